"""The robots of the check, from the package `example-robot-data`."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from ..paths import PACKAGES, ROOT
from . import imported, urdf
from .imported import Text
from .urdf import Robot

FILES = PACKAGES / "cmeel.prefix/share/example-robot-data/robots"

MODELS = ROOT / "benches/src/models/trees"
"""Texts that were written by hand, with parts."""


@dataclass(frozen=True)
class Model:
    """A robot whose text is printed from its URDF file, or was written by hand."""

    name: str
    file: str
    """The URDF file, relative to the folder of all robots."""
    floating: bool
    by_hand: str = ""
    """The file of the text written by hand."""
    chain: str = ""
    """The name of the chain in this text."""
    joints: tuple[tuple[str, str], ...] = ()
    """The hinges of this text in the order of its coordinates, each with its joint."""
    undamped: tuple[str, ...] = ()
    """The parameters of this text that are dampers, which no other program has."""

    @property
    def path(self) -> Path:
        return FILES / self.file

    def robot(self, right_angles: bool = True) -> Robot:
        """Returns the robot with its bodies in the order of the text's coordinates."""
        robot = urdf.read(self.path, self.floating, right_angles)
        return robot.in_order([joint for _, joint in self.joints]) if self.by_hand else robot

    def printed(self) -> Model:
        """Returns the same robot with a text that is printed from the file."""
        return replace(self, by_hand="", chain="", joints=(), undamped=())

    def text(self) -> Text:
        if not self.by_hand:
            return imported.run(self.path, self.floating, str(urdf.RIGHT_ANGLE))
        text = (MODELS / self.by_hand).read_text()
        return Text(text, self.chain, [hinge for hinge, _ in self.joints])


def legs(names: list[str], joints: list[str]) -> list[tuple[str, str]]:
    return [(f"{leg}_{joint}", f"{leg}_{joint}_joint") for leg in names for joint in joints]


def limb(side: str, name: str, joints: list[str]) -> list[tuple[str, str]]:
    return [(f"{side}_{name}_{joint}", f"{side}_{joint}_joint") for joint in joints]


LEG = ["hip_pitch", "hip_roll", "hip_yaw", "knee", "ankle_pitch", "ankle_roll"]
ARM = ["shoulder_pitch", "shoulder_roll", "shoulder_yaw", "elbow", "wrist_roll", "wrist_pitch", "wrist_yaw"]
WAIST = ["waist_yaw", "waist_roll", "waist_pitch"]

MODELS_BY_NAME = {
    model.name: model
    for model in [
        Model(
            "HyQ",
            "hyq_description/robots/hyq_no_sensors.urdf",
            floating=True,
            by_hand="hyq.chain",
            chain="Hyq",
            joints=tuple(legs(["lf", "rf", "lh", "rh"], ["haa", "hfe", "kfe"])),
            undamped=("damping",),
        ),
        Model("ANYmal", "anymal_b_simple_description/robots/anymal.urdf", floating=True),
        Model("Solo12", "solo_description/robots/solo12.urdf", floating=True),
        Model(
            "G1",
            "g1_description/urdf/g1_29dof_rev_1_0.urdf",
            floating=True,
            by_hand="g1.chain",
            chain="G1",
            joints=(
                *((joint, f"{joint}_joint") for joint in WAIST),
                *(pair for side in ("left", "right") for pair in limb(side, "leg", LEG)),
                *(pair for side in ("left", "right") for pair in limb(side, "arm", ARM)),
            ),
        ),
        Model("Talos", "talos_data/robots/talos_reduced.urdf", floating=True),
        Model(
            "Panda",
            "panda_description/urdf/panda.urdf",
            floating=False,
            by_hand="panda_with_fingers.chain",
            chain="PandaWithFingers",
            joints=(
                *((f"j{index}", f"panda_joint{index}") for index in range(1, 8)),
                ("open_left", "panda_finger_joint1"),
                ("open_right", "panda_finger_joint2"),
            ),
            undamped=("damping", "finger_damping"),
        ),
        Model("Baxter", "baxter_description/urdf/baxter.urdf", floating=False),
    ]
}
