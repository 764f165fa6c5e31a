"""The mechanisms as files for tools that read a model."""

from pathlib import Path

import mujoco

from .cases import Body, Case, Vector


def for_pinocchio(case: Case) -> str:
    """Returns the input of `pinocchio.cpp`: gravity, then a line for each body."""

    def line(body: Body) -> str:
        entries = [*body.position, *(x for row in body.rotation for x in row), body.mass, *body.com]
        entries += [x for row in body.inertia for x in row]
        # Pinocchio's index of the ground is 0, that of the first body 1.
        parent = 0 if body.parent is None else body.parent + 1
        return " ".join([body.hinge, str(parent), *map(repr, entries)])

    first = " ".join(map(repr, [len(case.bodies), *case.gravity]))
    return "\n".join([first, *map(line, case.bodies)]) + "\n"


def for_mujoco(case: Case, path: Path, tip: tuple[int, Vector] | None = None) -> None:
    """Writes a compiled model, since MJCF cannot be nested a thousand levels deep.

    Optionally with a site at a point of a body.
    """
    spec = mujoco.MjSpec()
    spec.option.timestep = 1e-3
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_RK4
    spec.option.gravity = case.gravity
    # No contacts and no limits.
    flags = mujoco.mjtDisableBit
    spec.option.disableflags = flags.mjDSBL_CONSTRAINT | flags.mjDSBL_CONTACT
    bodies: list[mujoco.MjsBody] = []
    for body in case.bodies:
        inertia = body.inertia
        rotation = body.rotation
        before = spec.worldbody if body.parent is None else bodies[body.parent]
        own = before.add_body(
            pos=body.position,
            mass=body.mass,
            ipos=body.com,
            fullinertia=[inertia[i][j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))],
            explicitinertial=True,
        )
        own.alt.type = mujoco.mjtOrientation.mjORIENTATION_XYAXES
        own.alt.xyaxes = [rotation[i][column] for column in (0, 1) for i in range(3)]
        if body.hinge == "floating":
            own.add_joint(type=mujoco.mjtJoint.mjJNT_FREE)
        elif body.hinge == "ball":
            own.add_joint(type=mujoco.mjtJoint.mjJNT_BALL)
        else:
            axis = [float(name == body.hinge) for name in "xyz"]
            own.add_joint(type=mujoco.mjtJoint.mjJNT_HINGE, axis=axis)
        bodies.append(own)
    if tip:
        bodies[tip[0]].add_site(pos=tip[1])
    mujoco.mj_saveModel(spec.compile(), str(path))
