//! Repeated parts in the plane and on a line.

mod plane {
    use crate::repeat::motions::{planar, vector};
    use crate::repeat::twins::twins;

    twins! {
        [plane
            gravity = [1, -9.8] m/s^2;
            body Rod {
                mass = 1 kg;
                com = [0.3, 0.1] m;
                output = [0.6, 0] m turned 30 deg;
                inertia = 0.1 kg*m^2 about com;
                point tip = [0.2, 0.5] m;
            }
        ]

        kinds: Kinds KindsByTransfer {
            ground at [1, 2] m turned 40 deg
                -> repeat 2 { pin a -> Rod b -> slider([1, 2]) c -> Rod d -> planar e -> Rod f
                    -> elastic g -> Rod h -> weld i -> Rod j };
            hinge a { start = 20 deg; torque = input; }
            hinge c { stiffness = 30; damping = 2; }
            hinge g { stiffness = 30; turning_stiffness = 4; start = [0.1, 0.2] turned 3; }
        } = KindsOut {
            ground at [1, 2] m turned 40 deg
                -> pin a1 -> Rod b1 -> slider([1, 2]) c1 -> Rod d1 -> planar e1 -> Rod f1
                -> elastic g1 -> Rod h1 -> weld i1 -> Rod j1
                -> pin a2 -> Rod b2 -> slider([1, 2]) c2 -> Rod d2 -> planar e2 -> Rod f2
                -> elastic g2 -> Rod h2 -> weld i2 -> Rod j2;
            hinge a1, a2 { start = 20 deg; torque = input; }
            hinge c1, c2 { stiffness = 30; damping = 2; }
            hinge g1, g2 { stiffness = 30; turning_stiffness = 4; start = [0.1, 0.2] turned 3; }
        } given |x| { a = [x[0], x[1]]; } = { a1 = x[0]; a2 = x[1]; };

        floats: Adrift AdriftByTransfer {
            Rod hub -> repeat 3 { pin a -> Rod b } -> slider k -> Rod last;
            load p { on = b; at = tip; force = input; torque = input; }
            spring s { on = b; at = tip; to = [0, 3] m; stiffness = 50; length = 1 m; damping = 2; }
        } = AdriftOut {
            Rod hub -> pin a1 -> Rod b1 -> pin a2 -> Rod b2 -> pin a3 -> Rod b3
                -> slider k -> Rod last;
            load p1 { on = b1; at = tip; force = input; torque = input; }
            load p2 { on = b2; at = tip; force = input; torque = input; }
            load p3 { on = b3; at = tip; force = input; torque = input; }
            spring s1 { on = b1; at = tip; to = [0, 3]; stiffness = 50; length = 1; damping = 2; }
            spring s2 { on = b2; at = tip; to = [0, 3]; stiffness = 50; length = 1; damping = 2; }
            spring s3 { on = b3; at = tip; to = [0, 3]; stiffness = 50; length = 1; damping = 2; }
        } given |x| {
            p_force = [vector(x), vector(&x[2..]), vector(&x[4..])];
            p_torque = [x[6], x[7], x[8]];
        } = {
            p1_force = vector(x);
            p2_force = vector(&x[2..]);
            p3_force = vector(&x[4..]);
            p1_torque = x[6];
            p2_torque = x[7];
            p3_torque = x[8];
        };

        closes: Loop LoopByTransfer {
            ground -> repeat 3 { pin a -> Rod b } -> pin last -> ground at [0.5, 0.6] m;
        } = LoopOut {
            ground -> pin a1 -> Rod b1 -> pin a2 -> Rod b2 -> pin a3 -> Rod b3
                -> pin last -> ground at [0.5, 0.6] m;
        };

        moves: Crane {
            moving deck -> repeat 2 { pin a -> Rod b };
        } = CraneOut {
            moving deck -> pin a1 -> Rod b1 -> pin a2 -> Rod b2;
        } given |x| { deck = planar(x); } = { deck = planar(x); };
    }
}

mod line {
    use crate::repeat::twins::twins;

    twins! {
        [line gravity = -9.8 m/s^2; body Car { mass = 3 kg; com = 0.4 m; output = 1 m; }]

        floats: Train TrainByTransfer {
            Car first -> repeat 3 { elastic a -> Car b } -> slider c -> Car last;
            hinge a { stiffness = 100 N/m; damping = 3; force = input; start = 0.2 m; }
            load drag { on = b; force = input; }
        } = TrainOut {
            Car first -> elastic a1 -> Car b1 -> elastic a2 -> Car b2 -> elastic a3 -> Car b3
                -> slider c -> Car last;
            hinge a1, a2, a3 { stiffness = 100 N/m; damping = 3; force = input; start = 0.2 m; }
            load drag1 { on = b1; force = input; }
            load drag2 { on = b2; force = input; }
            load drag3 { on = b3; force = input; }
        } given |x| { a = [x[0], x[1], x[2]]; drag_force = [x[3], x[4], x[5]]; } = {
            a1 = x[0];
            a2 = x[1];
            a3 = x[2];
            drag1_force = x[3];
            drag2_force = x[4];
            drag3_force = x[5];
        };

        closes: Row {
            ground -> repeat 2 { slider a -> Car b -> weld c -> Car d } -> slider e -> ground at 9 m;
            hinge a { stiffness = 50; limits = [0, 1]; limit_stiffness = 200; }
            hinge e { stiffness = 20; }
        } = RowOut {
            ground -> slider a1 -> Car b1 -> weld c1 -> Car d1 -> slider a2 -> Car b2
                -> weld c2 -> Car d2 -> slider e -> ground at 9 m;
            hinge a1, a2 { stiffness = 50; limits = [0, 1]; limit_stiffness = 200; }
            hinge e { stiffness = 20; }
        };
    }
}
