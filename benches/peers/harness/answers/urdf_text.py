"""An arm as a URDF file, for tools that read nothing else."""

import math

from ..cases import DOWN, ONE, UP, Case, Matrix, Vector

ANGLES: dict[Matrix, Vector] = {
    ONE: (0.0, 0.0, 0.0),
    UP: (math.pi / 2, 0.0, 0.0),
    DOWN: (-math.pi / 2, 0.0, 0.0),
}
"""Roll, pitch and yaw of the rotations of an arm."""


def of(case: Case, tip: Vector) -> str:
    """Returns the text; a fixed joint holds a link `tip` without mass at a point of the last body."""
    lines = [f'<robot name="{case.name}">', '<link name="link0"/>']
    for index, body in enumerate(case.bodies, 1):
        (xx, xy, xz), (_, yy, yz), (_, _, zz) = body.inertia
        lines += [
            f'<link name="link{index}"><inertial><origin xyz="{joined(body.com)}" rpy="0 0 0"/>',
            f'<mass value="{body.mass!r}"/>',
            f'<inertia ixx="{xx!r}" ixy="{xy!r}" ixz="{xz!r}" iyy="{yy!r}" iyz="{yz!r}" izz="{zz!r}"/>',
            "</inertial></link>",
            f'<joint name="joint{index}" type="continuous">',
            f'<origin xyz="{joined(body.position)}" rpy="{joined(ANGLES[body.rotation])}"/>',
            f'<parent link="link{index - 1}"/><child link="link{index}"/>',
            f'<axis xyz="{joined([float(name == body.hinge) for name in "xyz"])}"/>',
            "</joint>",
        ]
    last = len(case.bodies)
    lines += [
        '<link name="tip"/>',
        f'<joint name="tip_joint" type="fixed"><origin xyz="{joined(tip)}" rpy="0 0 0"/>',
        f'<parent link="link{last}"/><child link="tip"/></joint>',
        "</robot>",
    ]
    return "\n".join(lines) + "\n"


def joined(numbers: Vector | list[float]) -> str:
    return " ".join(map(repr, numbers))
