"""Panda, UR5 and HyQ against Pinocchio, from the URDF files that the chains were imported from."""

import pathlib

import numpy as np
import pytest
from mstmm_robots import Hyq, Panda, Ur5

pinocchio = pytest.importorskip("pinocchio")
ROBOTS = pathlib.Path(pinocchio.__file__).parents[4] / "share/example-robot-data/robots"

CASES = {
    "panda": (Panda, "panda_description/urdf/panda.urdf", ["panda_finger_joint1", "panda_finger_joint2"], False),
    "ur5": (Ur5, "ur_description/urdf/ur5_robot.urdf", [], False),
    "hyq": (Hyq, "hyq_description/robots/hyq_no_sensors.urdf", [], True),
}
# The chains have the digits of the files, except tensors of merged links and angles within 1e-12 of whole degrees.
RELATIVE = 1e-9


@pytest.fixture(params=CASES)
def case(request):
    Model, file, locked, floating = CASES[request.param]
    root = [pinocchio.JointModelFreeFlyer()] if floating else []
    robot = pinocchio.buildModelFromUrdf(str(ROBOTS / file), *root)
    if locked:
        robot = pinocchio.buildReducedModel(robot, [robot.getJointId(name) for name in locked], pinocchio.neutral(robot))
    for armature in (robot.armature, robot.damping):
        armature[:] = 0
    model, rng, rows = Model(), np.random.default_rng(7), 9
    print("seed 7")
    # Names of Pinocchio have other signs between parts.
    plain = [name.replace(".", "").replace("_", "") for name in robot.names[1:]]
    ours = [hinge.replace(".", "").replace("_", "") for hinge, _, _ in model.hinges]
    order = [plain.index(name) for name in ours if name in plain]
    q, v = np.zeros((rows, robot.nq)), rng.normal(size=(rows, robot.nv))
    x = model.initial(rows)
    first = 7 if floating else 0
    joint = np.array(order) - (1 if floating else 0)
    if floating:
        q[:, :3] = x[:, :3] = rng.normal(size=(rows, 3))
        quaternion = rng.normal(size=(rows, 4))
        quaternion /= np.linalg.norm(quaternion, axis=1)[:, None]
        # The order of the library is w, x, y, z; that of Pinocchio x, y, z, w.
        x[:, 3:7], q[:, 3:7] = quaternion, quaternion[:, [1, 2, 3, 0]]
        joint = np.array([plain.index(name) - 1 for name in ours if name in plain and name != plain[0]])
    angles = rng.uniform(-1, 1, (rows, len(joint)))
    x[:, first : first + len(joint)] = angles
    q[:, first + joint] = angles
    nq = len(model.coordinates)
    if floating:
        # Rates of the base: here the velocity in inertial axes, in Pinocchio in the axes of the base.
        for row in range(rows):
            rotation = pinocchio.Quaternion(q[row, 3:7]).toRotationMatrix()
            x[row, nq : nq + 3] = rotation @ v[row, :3]
        x[:, nq + 3 : nq + 6] = v[:, 3:6]
        x[:, nq + 6 :] = v[:, 6 + joint]
    else:
        x[:, nq:] = v[:, joint]
    tau = rng.normal(size=(rows, len(joint)))
    full = np.zeros((rows, robot.nv))
    full[:, (6 if floating else 0) + joint] = tau
    return model, robot, robot.createData(), x, q, v, tau, full, joint, floating


def test_accelerations_are_those_of_aba(case):
    model, robot, data, x, q, v, tau, full, joint, floating = case
    ours = model.accelerations(x, tau)
    for row in range(len(x)):
        theirs = pinocchio.aba(robot, data, q[row], v[row], full[row])
        expected = theirs[(6 if floating else 0) + joint]
        got = ours[row, 6:] if floating else ours[row]
        np.testing.assert_allclose(got, expected, rtol=0, atol=RELATIVE * np.abs(theirs).max())
        if floating:
            rotation = pinocchio.Quaternion(q[row, 3:7]).toRotationMatrix()
            # The acceleration of the origin: that in body axes plus w x v.
            linear = rotation @ (theirs[:3] + np.cross(v[row, 3:6], v[row, :3]))
            np.testing.assert_allclose(ours[row, :3], linear, rtol=0, atol=RELATIVE * np.abs(theirs).max())
            np.testing.assert_allclose(ours[row, 3:6], theirs[3:6], rtol=0, atol=RELATIVE * np.abs(theirs).max())


def test_mass_matrix_is_that_of_crba(case):
    model, robot, data, x, q, v, tau, full, joint, floating = case
    ours = model.mass_matrix(x)
    for row in range(len(x)):
        theirs = pinocchio.crba(robot, data, q[row])
        theirs = np.triu(theirs) + np.triu(theirs, 1).T
        places = (6 if floating else 0) + joint
        expected = theirs[np.ix_(places, places)]
        got = ours[row, 6:, 6:] if floating else ours[row]
        np.testing.assert_allclose(got, expected, rtol=0, atol=RELATIVE * np.abs(expected).max())


def test_inverse_dynamics_is_that_of_rnea(case):
    """Efforts and accelerations of a base are a force in inertial axes and a torque in its own axes, and the derivatives of
    its rates; in Pinocchio all are in the axes of the base, whose velocity there changes by v' = R^T a - w x v."""
    model, robot, data, x, q, v, tau, full, joint, floating = case
    first = 6 if floating else 0
    ours_given = np.random.default_rng(8).normal(size=(len(x), first + len(joint)))
    ours = model.inverse_dynamics(x, ours_given)
    gravity = model.gravity_efforts(x)
    for row in range(len(x)):
        theirs_given = np.zeros(robot.nv)
        theirs_given[first + joint] = ours_given[row, first:]
        rotation = np.eye(3)
        if floating:
            rotation = pinocchio.Quaternion(q[row, 3:7]).toRotationMatrix()
            theirs_given[:3] = rotation.T @ ours_given[row, :3] - np.cross(v[row, 3:6], v[row, :3])
            theirs_given[3:6] = ours_given[row, 3:6]

        def in_our_axes(efforts):
            base = [rotation @ efforts[:3], efforts[3:6]] if floating else []
            return np.concatenate([*base, efforts[first + joint]])

        expected = in_our_axes(pinocchio.rnea(robot, data, q[row], v[row], theirs_given))
        np.testing.assert_allclose(ours[row], expected, rtol=0, atol=RELATIVE * np.abs(expected).max())
        expected = in_our_axes(pinocchio.computeGeneralizedGravity(robot, data, q[row]))
        np.testing.assert_allclose(gravity[row], expected, rtol=0, atol=RELATIVE * np.abs(expected).max())


FRAMES = {"Panda": ("panda_link7.panda_hand_tcp", "panda_hand_tcp"), "Ur5": ("wrist_3_link.ee_link", "ee_link")}


def test_jacobians_and_poses_are_those_of_pinocchio(case):
    model, robot, data, x, q, v, tau, full, joint, floating = case
    if floating:
        frame, name = "lf.lowerleg.foot", "lf_foot"
    else:
        frame, name = FRAMES[model.name]
    ours, motion = model.jacobian(frame, x), model.kinematics(frame, x)
    for row in range(len(x)):
        pinocchio.forwardKinematics(robot, data, q[row], v[row])
        pinocchio.updateFramePlacements(robot, data)
        index = robot.getFrameId(name)
        place = data.oMf[index]
        np.testing.assert_allclose(motion["position"][row], place.translation, atol=1e-9)
        np.testing.assert_allclose(motion["orientation"][row], place.rotation, atol=1e-9)
        theirs = pinocchio.computeFrameJacobian(robot, data, q[row], index, pinocchio.LOCAL_WORLD_ALIGNED)
        expected = theirs[:, (6 if floating else 0) + joint]
        got = ours[row][:, 6:] if floating else ours[row]
        np.testing.assert_allclose(got, expected, atol=1e-9)


def test_momentum_is_that_of_pinocchio(case):
    model, robot, data, x, q, v, tau, full, joint, floating = case
    momentum = model.momentum(x)
    for row in range(len(x)):
        theirs = pinocchio.computeCentroidalMomentum(robot, data, q[row], v[row])
        scale = np.abs(theirs.vector).max()
        np.testing.assert_allclose(momentum.linear[row], theirs.linear, atol=RELATIVE * scale)
        np.testing.assert_allclose(momentum.angular[row], theirs.angular, atol=RELATIVE * scale)
