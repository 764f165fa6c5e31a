"""Imported MuJoCo models compared with MuJoCo: `bridges/check-import --mjcf`.

Accelerations and the mass matrix in random states, with dampers, rotors and the efforts of all joints. Friction is smooth in
a chain and a constraint in MuJoCo, so it is computed here; limits, contacts and equations are off.
"""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
from pathlib import Path

import mujoco
import numpy as np
from harness.trees import imported as names

from . import program

SEED = 27
STATES = 10
LARGEST = 1e-9
SMOOTHING = {mujoco.mjtJoint.mjJNT_HINGE: 0.1, mujoco.mjtJoint.mjJNT_SLIDE: 0.01}
"""The `friction_speed` of written texts."""

PACKAGES = Path(mujoco.__file__).parents[1]
MODELS = {
    "openarm": Path(sys.prefix) / "share/openarm_mujoco/v2/openarm_bimanual.xml",
    "offsets": Path(__file__).with_name("offsets.xml"),
    "jaco": PACKAGES / "dm_control/mujoco/testing/assets/arm.xml",
}


class Peer:
    """A model of MuJoCo, with the joints of a chain in the order of their names there."""

    def __init__(self, path: Path, found: names.Names):
        self.model = mujoco.MjModel.from_xml_path(str(path))
        off = mujoco.mjtDisableBit
        self.model.opt.disableflags |= off.mjDSBL_CONSTRAINT | off.mjDSBL_ACTUATION
        self.data = mujoco.MjData(self.model)
        by_name = {self.model.joint(index).name: index for index in range(self.model.njnt)}
        self.joints = [by_name[hinge.joint] for hinge in found.hinges]
        if sorted(self.joints) != list(range(self.model.njnt)):
            raise ValueError(f"{path}: the text has {len(self.joints)} of {self.model.njnt} joints")

    def states(self, random: np.random.Generator) -> np.ndarray:
        """Returns coordinates within the limits, rates and efforts."""
        count = len(self.joints)
        low, high = np.full(count, -1.0), np.full(count, 1.0)
        for place, joint in enumerate(self.joints):
            if self.model.jnt_limited[joint]:
                low[place], high[place] = self.model.jnt_range[joint]
        coordinates = random.uniform(low, high, (STATES, count))
        return np.hstack([coordinates, random.uniform(-2, 2, (STATES, count)), random.uniform(-5, 5, (STATES, count))])

    def solve(self, state: np.ndarray) -> dict[str, np.ndarray]:
        model, data = self.model, self.data
        q, v, efforts = np.split(state, 3)
        at = model.jnt_dofadr[self.joints]
        data.qpos[model.jnt_qposadr[self.joints]] = q
        data.qvel[at] = v
        speeds = np.array([SMOOTHING[mujoco.mjtJoint(model.jnt_type[joint])] for joint in self.joints])
        data.qfrc_applied[at] = efforts - model.dof_frictionloss[at] * v / np.hypot(v, speeds)
        mujoco.mj_forward(model, data)
        matrix = np.zeros((model.nv, model.nv))
        # By its inverse, whose interface is the same in all versions.
        mujoco.mj_solveM(model, data, matrix, np.eye(model.nv))
        matrix = np.linalg.inv(matrix)
        return {"accelerations": data.qacc[at].copy(), "mass matrix": matrix[np.ix_(at, at)]}


ORIENTATIONS = {
    "quat": 4,
    "axisangle": 4,
    "euler": 3,
    "xyaxes": 6,
    "zaxis": 3,
}
"""The forms of an orientation and their numbers."""


def orientations(command: str, work: Path) -> float:
    """Returns the largest difference of rotation matrices of sites with random orientations in all forms."""
    random = np.random.default_rng(SEED)
    worst = 0.0
    for sequence in ("xyz", "XYZ", "zyx", "yXz", "ZxZ"):
        for angle in ("radian", "degree"):
            forms = [form for form in ORIENTATIONS for _ in range(4)]
            values = [random.uniform(-2, 2, ORIENTATIONS[form]) for form in forms]
            sites = "".join(
                f'<site name="s{index}" {form}="{" ".join(map(repr, map(float, value)))}"/>'
                for index, (form, value) in enumerate(zip(forms, values, strict=True))
            )
            file = work / "orientations.xml"
            file.write_text(
                f'<mujoco><compiler angle="{angle}" eulerseq="{sequence}"/><worldbody><body><joint/>'
                f'<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>{sites}</body></worldbody></mujoco>'
            )
            model = mujoco.MjModel.from_xml_path(str(file))
            run = [command, "mstmm", "import", str(file)]
            text = subprocess.run(run, check=True, capture_output=True, text=True).stdout
            pattern = r"point s(\d+) = \[[^]]*\] m(?:\s+turned rpy\(([^)]*)\) (\w+))?;"
            found = re.findall(pattern, text)
            if len(found) != len(forms):
                raise ValueError(f"{len(found)} of {len(forms)} sites are in the text:\n{text}")
            for number, angles, unit in found:
                roll, pitch, yaw = (float(part) for part in (angles or "0, 0, 0").split(","))
                if unit == "deg":
                    roll, pitch, yaw = np.deg2rad([roll, pitch, yaw])
                exact = np.zeros(9)
                mujoco.mju_quat2Mat(exact, model.site_quat[model.site(f"s{number}").id])
                own = about(2, yaw) @ about(1, pitch) @ about(0, roll)
                worst = max(worst, float(np.abs(own - exact.reshape(3, 3)).max()))
    return worst


def about(axis: int, angle: float) -> np.ndarray:
    """Returns the rotation about an axis."""
    matrix = np.eye(3)
    first, second = (axis + 1) % 3, (axis + 2) % 3
    matrix[[first, second], [first, second]] = np.cos(angle)
    matrix[first, second], matrix[second, first] = -np.sin(angle), np.sin(angle)
    return matrix


def main() -> None:
    parser = argparse.ArgumentParser(prog="bridges/check-import --mjcf", description=__doc__)
    parser.add_argument("--work", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--command", required=True, help=argparse.SUPPRESS)
    options = parser.parse_args()
    texts = {}
    for module, path in MODELS.items():
        run = [options.command, "mstmm", "import", str(path)]
        text = subprocess.run(run, check=True, capture_output=True, text=True).stdout
        (options.work / f"{module}.chain").write_text(text)
        texts[module] = (text, names.read(text))
    program.write(options.work, texts)
    program.build(options.work)
    difference = orientations(options.command, options.work)
    print(f"orientations: {difference:.0e}")
    wrong = [] if difference < 1e-12 else ["orientations"]
    for module, (_, found) in texts.items():
        peer = Peer(MODELS[module], found)
        states = peer.states(np.random.default_rng(SEED))
        count = len(peer.joints)
        worst = dict.fromkeys(("accelerations", "mass matrix"), 0.0)
        for state, row in zip(states, program.run(options.work, module, states), strict=True):
            other = peer.solve(state)
            own = {"accelerations": row[:count], "mass matrix": row[count : count + count * count].reshape(count, -1)}
            for quantity, value in own.items():
                difference = np.abs(value - other[quantity]).max() / np.abs(other[quantity]).max()
                worst[quantity] = max(worst[quantity], float(difference))
        print(f"{module}: {count} joints, " + ", ".join(f"{name} {value:.0e}" for name, value in worst.items()))
        if not all(value < LARGEST for value in worst.values()):
            wrong.append(module)
    if wrong:
        sys.exit(f"wrong: {', '.join(wrong)}")


if __name__ == "__main__":
    main()
