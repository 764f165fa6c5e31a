"""Steps per second of Panda, UR5 and HyQ: this wheel, MuJoCo's rollout, Pinocchio and CasADi, in one run.

    python measure.py NAME_OF_THE_WHEEL [SECONDS_FOR_EACH]

All integrate the same mechanism, without contact, limits and damping, by RK4 with the same step, on all cores if the
tool can. Their states after 100 steps are compared first.
"""

import os
import pathlib
import platform
import sys
import time
import xml.etree.ElementTree as ElementTree

import casadi
import mujoco
import mujoco.rollout
import numpy as np
import pinocchio
from mstmm_robots import Hyq, Panda, Ur5


ROBOTS = pathlib.Path(pinocchio.__file__).parents[4] / "share/example-robot-data/robots"
FILES = {
    Panda: ("panda_description/urdf/panda.urdf", False),
    Ur5: ("ur_description/urdf/ur5_robot.urdf", False),
    Hyq: ("hyq_description/robots/hyq_no_sensors.urdf", True),
}
STEP, CORES = 1e-3, len(os.sched_getaffinity(0))
SECONDS = float(sys.argv[2]) if len(sys.argv) > 2 else 5.0


def urdf_text(file, floating):
    """Returns a file without shapes, with fixed fingers and, if it floats, a free joint at its root."""
    root = ElementTree.parse(ROBOTS / file).getroot()
    for link in root.iter("link"):
        for shape in link.findall("visual") + link.findall("collision"):
            link.remove(shape)
    for joint in root.iter("joint"):
        if "finger_joint" in joint.get("name", ""):
            joint.set("type", "fixed")
            for mimic in joint.findall("mimic"):
                joint.remove(mimic)
    for inertia in root.iter("inertia"):
        if inertia.get("ixx") == inertia.get("ixy"):
            # MuJoCo refuses this tensor of 1e-6 kg m^2, which no body can have.
            inertia.set("ixy", "0"), inertia.set("ixz", "0"), inertia.set("iyz", "0")
    for other in root.findall("transmission") + root.findall("gazebo"):
        root.remove(other)
    if floating:
        children = {joint.find("child").get("link") for joint in root.findall("joint")}
        base = next(link.get("name") for link in root.findall("link") if link.get("name") not in children)
        ElementTree.SubElement(root, "link", name="the_world")
        joint = ElementTree.SubElement(root, "joint", name="free", type="floating")
        ElementTree.SubElement(joint, "parent", link="the_world")
        ElementTree.SubElement(joint, "child", link=base)
    return ElementTree.tostring(root, encoding="unicode")


def plain(name):
    return name.replace(".", "").replace("_", "")


def best(function):
    """Returns the shortest time of a call, of as many as fit the seconds, two at least."""
    times, start = [], time.perf_counter()
    while len(times) < 2 or time.perf_counter() - start < SECONDS:
        before = time.perf_counter()
        function()
        times.append(time.perf_counter() - before)
    return min(times)


def start(model, rows):
    x = model.initial(rows)
    nq, first = len(model.coordinates), 7 if "Quaternion" in model.coordinates.kinds else 0
    rng = np.random.default_rng(5)
    x[:, first:nq] += rng.uniform(-0.5, 0.5, (rows, nq - first))
    x[:, nq:] += rng.uniform(-0.5, 0.5, (rows, x.shape[1] - nq))
    return x


def by_mujoco(model, text):
    mj = mujoco.MjModel.from_xml_string(text)
    mj.opt.timestep, mj.opt.integrator = STEP, mujoco.mjtIntegrator.mjINT_RK4
    mj.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT) | int(mujoco.mjtDisableBit.mjDSBL_LIMIT)
    mj.dof_damping[:], mj.dof_armature[:], mj.dof_frictionloss[:] = 0, 0, 0
    mj.opt.gravity[:] = [0, 0, -9.81]
    names = [plain(mj.joint(index).name) for index in range(mj.njnt)]
    ours = [plain(name) for name, _, _ in model.hinges]
    first = 7 if names[0] == "free" else 0
    order = [ours.index(name) - (1 if first else 0) for name in names if name != "free"]
    nq = len(model.coordinates)
    columns = [*range(first), *(first + np.array(order))]
    columns += [nq + column for column in [*range(6 if first else 0), *((6 if first else 0) + np.array(order))]]
    return mj, np.array(columns)


def mujoco_runner(mj, columns, x, steps):
    state = np.concatenate([np.zeros((len(x), 1)), x[:, columns]], axis=1)
    data = [mujoco.MjData(mj) for _ in range(CORES)]
    with_pool = mujoco.rollout.Rollout(nthread=CORES)
    out = np.empty((len(x), steps, state.shape[1]))

    def run():
        with_pool.rollout(mj, data, state, nstep=steps, state=out, skip_checks=False)
        return out[:, -1, 1:]

    return run


def pinocchio_runner(robot, x, steps):
    """Returns a loop over the first states, with `aba` called from Python; for fixed bases."""
    data, n = robot.createData(), robot.nv

    def run():
        for row in x:
            q, v = row[:n].copy(), row[n:].copy()
            zero = np.zeros(n)
            for _ in range(steps):
                a1 = pinocchio.aba(robot, data, q, v, zero).copy()
                v2 = v + STEP / 2 * a1
                a2 = pinocchio.aba(robot, data, q + STEP / 2 * v, v2, zero).copy()
                v3 = v + STEP / 2 * a2
                a3 = pinocchio.aba(robot, data, q + STEP / 2 * v2, v3, zero).copy()
                v4 = v + STEP * a3
                a4 = pinocchio.aba(robot, data, q + STEP * v3, v4, zero)
                q = q + STEP / 6 * (v + 2 * v2 + 2 * v3 + v4)
                v = v + STEP / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
        return np.concatenate([q, v])

    return run


def cross(v):
    """Returns the matrix of the motion cross product of a spatial velocity, linear part first."""
    return casadi.blockcat([[casadi.skew(v[3:]), casadi.skew(v[:3])], [casadi.SX(3, 3), casadi.skew(v[3:])]])


def articulated_body(robot):
    """Returns forward dynamics by the articulated-body algorithm, in symbols, from the numbers of Pinocchio's model."""
    n = robot.nv
    q, v = casadi.SX.sym("q", n), casadi.SX.sym("v", n)
    axis, move, velocity, bias, inertia, force = {}, {}, {0: casadi.SX(6, 1)}, {}, {}, {}
    for i in range(1, robot.njoints):
        joint = robot.joints[i].createData()
        robot.joints[i].calc(joint, np.zeros(1))
        axis[i] = np.asarray(joint.S).ravel()
        k, place = casadi.skew(axis[i][3:]), robot.jointPlacements[i]
        turn = casadi.SX.eye(3) + casadi.sin(q[i - 1]) * k + (1 - casadi.cos(q[i - 1])) * k @ k
        to_child = (place.rotation @ turn).T
        move[i] = casadi.blockcat([[to_child, -to_child @ casadi.skew(place.translation)], [casadi.SX(3, 3), to_child]])
        rate = casadi.SX(axis[i]) * v[i - 1]
        velocity[i] = move[i] @ velocity[robot.parents[i]] + rate
        bias[i] = cross(velocity[i]) @ rate
        inertia[i] = casadi.SX(robot.inertias[i].matrix())
        force[i] = -cross(velocity[i]).T @ inertia[i] @ velocity[i]
    gain, pivot, effort = {}, {}, {}
    for i in reversed(range(1, robot.njoints)):
        gain[i] = inertia[i] @ axis[i]
        pivot[i], effort[i] = casadi.dot(axis[i], gain[i]), -casadi.dot(axis[i], force[i])
        if robot.parents[i] > 0:
            rest = inertia[i] - gain[i] @ gain[i].T / pivot[i]
            load = force[i] + rest @ bias[i] + gain[i] * effort[i] / pivot[i]
            inertia[robot.parents[i]] += move[i].T @ rest @ move[i]
            force[robot.parents[i]] += move[i].T @ load
    acceleration, result = {0: casadi.SX([0, 0, 9.81, 0, 0, 0])}, []
    for i in range(1, robot.njoints):
        before = move[i] @ acceleration[robot.parents[i]] + bias[i]
        result.append((effort[i] - casadi.dot(gain[i], before)) / pivot[i])
        acceleration[i] = before + axis[i] * result[-1]
    return casadi.Function("f", [q, v], [casadi.vertcat(*result)])


def casadi_runner(robot, x, steps):
    """Returns a rollout of all states by a function of CasADi, mapped over all cores."""
    f, n = articulated_body(robot), robot.nv
    for row in x[:3]:
        theirs = pinocchio.aba(robot, robot.createData(), row[:n].copy(), row[n:].copy(), np.zeros(n))
        assert np.abs(np.asarray(f(row[:n], row[n:])).ravel() - theirs).max() < 1e-9 * np.abs(theirs).max()
    s = casadi.MX.sym("s", 2 * n)

    def rate(s):
        return casadi.vertcat(s[n:], f(s[:n], s[n:]))

    k1 = rate(s)
    k2 = rate(s + STEP / 2 * k1)
    k3 = rate(s + STEP / 2 * k2)
    k4 = rate(s + STEP * k3)
    step = casadi.Function("step", [s], [s + STEP / 6 * (k1 + 2 * k2 + 2 * k3 + k4)])
    mapped = step.mapaccum(steps).map(len(x), "thread", CORES)
    states = casadi.DM(x.T)
    return lambda: mapped(states)


def measure(Model, name):
    model, (file, floating) = Model(), FILES[Model]
    text = urdf_text(file, floating)
    mj, columns = by_mujoco(model, text)
    # The same states after 100 steps: rounding, amplified by the motion.
    x = start(model, 8)
    ours = x.copy()
    model.step(ours, None, STEP, 100)
    theirs = mujoco_runner(mj, columns, x, 100)()
    difference = np.abs(ours[:, columns] - theirs).max()
    assert difference < 1e-5, difference
    rows, steps = 4096, 50
    x = start(model, rows)

    def run():
        y = x.copy()
        model.step(y, None, STEP, steps)

    results = {f"mstmm, {name}": rows * steps / best(run)}
    few = 1024
    results["MuJoCo rollout"] = few * steps / best(mujoco_runner(mj, columns, x[:few], steps))
    if not floating:
        robot = pinocchio.buildModelFromXML(text)
        plain_names = [plain(joint) for joint in robot.names[1:]]
        ours_names = [plain(hinge) for hinge, _, _ in model.hinges]
        order = np.array([ours_names.index(joint) for joint in plain_names])
        permuted = np.concatenate([order, len(order) + order])
        results["Pinocchio aba from Python"] = 4 * steps / best(pinocchio_runner(robot, x[:4][:, permuted], steps))
        results["CasADi map"] = 64 * steps / best(casadi_runner(robot, x[:64][:, permuted], steps))
    return difference, results


def main():
    name = sys.argv[1] if len(sys.argv) > 1 else "this wheel"
    versions = f"numpy {np.__version__}, MuJoCo {mujoco.__version__}, Pinocchio {pinocchio.__version__}"
    print(f"{CORES} cores, {platform.machine()}, Python {platform.python_version()}, {versions}, {Panda.lanes} lanes")
    print("| model | tool | RK4 steps/s | mstmm is faster by |\n|---|---|---|---|")
    for Model in FILES:
        difference, results = measure(Model, name)
        own = next(iter(results.values()))
        for tool, rate in results.items():
            print(f"| {Model.name} | {tool} | {rate:.3g} | {own / rate:.1f} |")
        print(f"| | largest difference from MuJoCo after 100 steps | {difference:.1e} | |", flush=True)


if __name__ == "__main__":
    main()
