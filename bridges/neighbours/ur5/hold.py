"""Holds the UR5 against gravity in simulation and shows the forces in its joints. Needs the wheel of `ur5.chain`."""

import argparse
import pathlib
import xml.etree.ElementTree

import numpy as np
from ur5 import Ur5

STEP, STEPS = 1e-3, 2000
GRAVITY = 9.81
URDF = "ur_description/urdf/ur5_robot.urdf"
POSE = np.array([0.3, -1.1, 1.4, -0.6, 0.8, 0.2])


def hold(model, x, steps):
    """Returns the states of `steps` milliseconds with gravity compensation, which is computed anew in each of them."""
    states = [x.copy()]
    for _ in range(steps):
        torques = model.gravity_efforts(x)
        model.step(x, torques, STEP, 1)
        states.append(x.copy())
    return np.array(states)


def weights_outboard(urdf):
    """Returns by links the weight in N of the link and of all outboard of it, from the masses in the URDF file."""
    root = xml.etree.ElementTree.parse(urdf).getroot()
    masses = {link.get("name"): float(mass.get("value")) for link in root.iter("link") for mass in link.iter("mass")}
    children = {}
    for joint in root.iter("joint"):
        if joint.find("parent") is not None:
            children.setdefault(joint.find("parent").get("link"), []).append(joint.find("child").get("link"))

    def mass(link):
        return masses.get(link, 0.0) + sum(mass(child) for child in children.get(link, []))

    return {link: GRAVITY * mass(link) for link in masses}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("robots", type=pathlib.Path, help="the folder `robots` of example-robot-data")
    parser.add_argument("-o", "--output", default=".", help="the folder for the page and the picture")
    given = parser.parse_args()
    folder, model = pathlib.Path(given.output), Ur5()

    # At rest the arm stays where it is, up to rounding.
    x = np.concatenate([POSE, np.zeros(6)])
    states = hold(model, x.copy(), STEPS)
    falling = model.rollout(x, None, STEP, 200)
    print(f"at rest: the joints move by {np.abs(states[:, :6] - POSE).max():.1e} rad in {STEPS * STEP:g} s, "
          f"without compensation by {np.abs(falling[-1, :6] - POSE).max():.2f} rad in 0.2 s")

    # The force in each joint is the weight of all that it carries.
    torques = model.gravity_efforts(x)
    points = model.solve(x, torques)["points"]
    weights = weights_outboard(given.robots / URDF)
    for link, weight in weights.items():
        if f"{link}.input" in points:
            force = np.linalg.norm(points[f"{link}.input"]["force"])
            print(f"{link:16} force {force:10.5f} N   weight outboard {weight:10.5f} N")

    # Without gravity nothing but the motion is left: pushed once, the arm keeps its kinetic energy.
    x[6:] = [0.3, -0.2, 0.4, 0.5, -0.6, 0.7]
    moving = hold(model, x.copy(), STEPS)
    kinetic, _ = model.energy(moving)
    print(f"pushed: kinetic energy {kinetic[0]:.4f} J, which changes by {np.ptp(kinetic):.1e} J")

    shown = moving[::10].copy()
    recording = model.record(shown, model.gravity_efforts(shown), 10 * STEP)
    recording.write_html(folder / "ur5.html", title="UR5 with gravity compensation", meshes=given.robots)
    model.record(states[:1], torques).write_svg(folder / "ur5.svg", meshes=given.robots)
    print(f"{folder / 'ur5.html'} shows the motion and the forces in the joints, {folder / 'ur5.svg'} the arm at rest")


if __name__ == "__main__":
    main()
