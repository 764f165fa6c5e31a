//! What acts in repeated hinges and on repeated bodies.

use super::motions::{ball, pin, planar, vector};
use super::twins::twins;

twins! {
    [space
        gravity = [1, -9.8, 2] m/s^2;
        body Rod {
            mass = 1 kg;
            com = [0.3, 0.1, 0] m;
            output = [0.6, 0, 0.2] m turned rpy(20, -30, 50) deg;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
            point tip = [0.2, 0.5, -0.1] m;
        }
        body Cube {
            mass = 2 kg;
            com = [0.1, -0.1, 0.2] m;
            output = [0, 0.4, 0] m;
            inertia = diag(0.3, 0.4, 0.5) kg*m^2 about input;
        }
    ]

    motors: Driven DrivenByTransfer {
        ground -> repeat 2 { ball a -> Rod b -> cylindrical(x) c -> Cube d };
        hinge a { torque = input; }
        hinge c { force = input; torque = 2 N*m; }
    } = DrivenOut {
        ground -> ball a1 -> Rod b1 -> cylindrical(x) c1 -> Cube d1
            -> ball a2 -> Rod b2 -> cylindrical(x) c2 -> Cube d2;
        hinge a1, a2 { torque = input; }
        hinge c1, c2 { force = input; torque = 2 N*m; }
    } given |x| {
        a = [vector(x), vector(&x[3..])];
        c = [x[6], x[7]];
    } = {
        a1 = vector(x);
        a2 = vector(&x[3..]);
        c1 = x[6];
        c2 = x[7];
    };

    springs_and_the_like: Sprung SprungByTransfer {
        ground -> repeat 2 { pin a -> Rod b -> ball c -> Cube d };
        hinge a {
            rest = 0.2;
            stiffness = 30;
            damping = 0.5;
            armature = 0.2 kg*m^2;
            friction = 0.4 N*m;
            friction_speed = 0.1 rad/s;
            limits = [-0.5, 0.4] rad;
            limit_stiffness = 200;
            limit_damping = 2;
            torque = -3 N*m;
        }
        hinge c {
            start = rpy(10, 20, 30) deg;
            rest = rpy(10, 20, 30) deg;
            stiffness = 20;
            damping = 0.3;
            armature = 0.1 kg*m^2;
            friction = 0.4 N*m;
            friction_speed = 0.1 rad/s;
            limits = 0.3 rad;
            limit_stiffness = 50;
        }
    } = SprungOut {
        ground -> pin a1 -> Rod b1 -> ball c1 -> Cube d1 -> pin a2 -> Rod b2 -> ball c2 -> Cube d2;
        hinge a1, a2 {
            rest = 0.2;
            stiffness = 30;
            damping = 0.5;
            armature = 0.2 kg*m^2;
            friction = 0.4 N*m;
            friction_speed = 0.1 rad/s;
            limits = [-0.5, 0.4] rad;
            limit_stiffness = 200;
            limit_damping = 2;
            torque = -3 N*m;
        }
        hinge c1, c2 {
            start = rpy(10, 20, 30) deg;
            rest = rpy(10, 20, 30) deg;
            stiffness = 20;
            damping = 0.3;
            armature = 0.1 kg*m^2;
            friction = 0.4 N*m;
            friction_speed = 0.1 rad/s;
            limits = 0.3 rad;
            limit_stiffness = 50;
        }
    };

    elastic_springs: Bending {
        ground -> repeat 2 { elastic a -> Rod b } -> pin k -> Cube tip;
        hinge a {
            rest = [0.1, 0.2, 0.3] m turned rpy(0.1, 0.2, 0.3);
            stiffness = [100, 200, 300];
            turning_stiffness = 20;
            damping = 2;
            turning_damping = [0.1, 0.2, 0.3];
            armature = 0.3 kg;
        }
    } = BendingOut {
        ground -> elastic a1 -> Rod b1 -> elastic a2 -> Rod b2 -> pin k -> Cube tip;
        hinge a1, a2 {
            rest = [0.1, 0.2, 0.3] m turned rpy(0.1, 0.2, 0.3);
            stiffness = [100, 200, 300];
            turning_stiffness = 20;
            damping = 2;
            turning_damping = [0.1, 0.2, 0.3];
            armature = 0.3 kg;
        }
    };

    prescribed: Told {
        ground -> repeat 2 { pin a -> Rod b -> ball c -> Cube d } -> repeat 2 { planar e -> Rod f };
        hinge a { motion = input; }
        hinge e { motion = input; stiffness = 3; turning_stiffness = 4; }
    } = ToldOut {
        ground -> pin a1 -> Rod b1 -> ball c1 -> Cube d1 -> pin a2 -> Rod b2 -> ball c2 -> Cube d2
            -> planar e1 -> Rod f1 -> planar e2 -> Rod f2;
        hinge a1, a2 { motion = input; }
        hinge e1, e2 { motion = input; stiffness = 3; turning_stiffness = 4; }
    } given |x| {
        a = [pin(x), pin(&x[3..])];
        e = [planar(&x[6..]), planar(&x[15..])];
    } = {
        a1 = pin(x);
        a2 = pin(&x[3..]);
        e1 = planar(&x[6..]);
        e2 = planar(&x[15..]);
    };

    prescribed_behind: ToldBehind {
        ground -> repeat 2 { pin a -> Rod b -> ball c -> Cube d };
        hinge c { motion = input; }
    } = ToldBehindOut {
        ground -> pin a1 -> Rod b1 -> ball c1 -> Cube d1 -> pin a2 -> Rod b2 -> ball c2 -> Cube d2;
        hinge c1, c2 { motion = input; }
    } given |x| { c = [ball(x), ball(&x[9..])]; } = { c1 = ball(x); c2 = ball(&x[9..]); };

    loads: Loaded LoadedByTransfer {
        ground -> repeat 2 { pin a -> Rod b -> ball c -> Cube d };
        load p { on = b; at = tip; force = [1, 2, 3] N; torque = [3, 2, 1] N*m; }
        load s { on = b; at = [1, 1, 1] m; force = [2, -2, 2] N; axes = body; }
        load r { on = d; at = output; force = input; axes = body; }
        load m { on = d; torque = input; }
    } = LoadedOut {
        ground -> pin a1 -> Rod b1 -> ball c1 -> Cube d1 -> pin a2 -> Rod b2 -> ball c2 -> Cube d2;
        load p1 { on = b1; at = tip; force = [1, 2, 3] N; torque = [3, 2, 1] N*m; }
        load p2 { on = b2; at = tip; force = [1, 2, 3] N; torque = [3, 2, 1] N*m; }
        load s1 { on = b1; at = [1, 1, 1] m; force = [2, -2, 2] N; axes = body; }
        load s2 { on = b2; at = [1, 1, 1] m; force = [2, -2, 2] N; axes = body; }
        load r1 { on = d1; at = output; force = input; axes = body; }
        load r2 { on = d2; at = output; force = input; axes = body; }
        load m1 { on = d1; torque = input; }
        load m2 { on = d2; torque = input; }
    } given |x| {
        r_force = [vector(x), vector(&x[3..])];
        m_torque = [vector(&x[6..]), vector(&x[9..])];
    } = {
        r1_force = vector(x);
        r2_force = vector(&x[3..]);
        m1_torque = vector(&x[6..]);
        m2_torque = vector(&x[9..]);
    };

    springs_to_the_ground: Tied {
        Cube hub -> repeat 2 { ball a -> Rod b } -> pin k -> Cube tip;
        spring s { on = b; at = tip; to = [0, 3, 0] m; stiffness = 50; length = 1 m; damping = 2; }
        spring r { on = b; to = [1, 0, 3] m; stiffness = 20; }
        spring u { on = tip; to = [1, 0, -3] m; stiffness = 20; }
    } = TiedOut {
        Cube hub -> ball a1 -> Rod b1 -> ball a2 -> Rod b2 -> pin k -> Cube tip;
        spring s1 { on = b1; at = tip; to = [0, 3, 0] m; stiffness = 50; length = 1 m; damping = 2; }
        spring s2 { on = b2; at = tip; to = [0, 3, 0] m; stiffness = 50; length = 1 m; damping = 2; }
        spring r1 { on = b1; to = [1, 0, 3] m; stiffness = 20; }
        spring r2 { on = b2; to = [1, 0, 3] m; stiffness = 20; }
        spring u { on = tip; to = [1, 0, -3] m; stiffness = 20; }
    };
}

mod gravity {
    use crate::repeat::motions::vector;
    use crate::repeat::twins::twins;

    twins! {
        [space
            gravity = input;
            body Rod {
                mass = 1 kg;
                com = [0.3, 0.1, 0] m;
                output = [0.6, 0, 0.2] m turned rpy(20, -30, 50) deg;
                inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
                point tip = [0.2, 0.5, -0.1] m;
            }
        ]

        as_an_input: Falling { Rod hub -> repeat 2 { pin a -> Rod b }; }
        = FallingOut { Rod hub -> pin a1 -> Rod b1 -> pin a2 -> Rod b2; }
        given |x| { gravity = vector(x); } = { gravity = vector(x); };
    }
}
