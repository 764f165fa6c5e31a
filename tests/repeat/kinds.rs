//! All kinds of hinges in repeated parts, several in each.

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

    pin_slider_screw: Straight {
        ground -> repeat 2 { pin([1, 2, 3]) a -> Rod b -> slider(y) c -> Cube d
            -> screw(x, 5 cm/rev) e -> Rod f };
        hinge a { start = 1; start_rate = -2; }
        hinge c { start = 0.5 m; start_velocity = 1 m/s; }
        hinge e { start = -0.4; start_rate = 4; }
    } = StraightOut {
        ground -> pin([1, 2, 3]) a1 -> Rod b1 -> slider(y) c1 -> Cube d1
            -> screw(x, 5 cm/rev) e1 -> Rod f1
            -> pin([1, 2, 3]) a2 -> Rod b2 -> slider(y) c2 -> Cube d2
            -> screw(x, 5 cm/rev) e2 -> Rod f2;
        hinge a1, a2 { start = 1; start_rate = -2; }
        hinge c1, c2 { start = 0.5 m; start_velocity = 1 m/s; }
        hinge e1, e2 { start = -0.4; start_rate = 4; }
    };

    cylindrical_weld_universal: Twofold TwofoldByTransfer {
        ground -> repeat 2 { cylindrical(y) a -> Rod b -> weld c -> Cube d
            -> universal(x, [1, 0, 2]) e -> Rod f };
        hinge a { start = 0.2 m turned 30 deg; start_velocity = -1; start_rate = 2; }
        hinge e { start = [10, 20] deg; start_rate = [1, 2]; }
    } = TwofoldOut {
        ground -> cylindrical(y) a1 -> Rod b1 -> weld c1 -> Cube d1
            -> universal(x, [1, 0, 2]) e1 -> Rod f1
            -> cylindrical(y) a2 -> Rod b2 -> weld c2 -> Cube d2
            -> universal(x, [1, 0, 2]) e2 -> Rod f2;
        hinge a1, a2 { start = 0.2 m turned 30 deg; start_velocity = -1; start_rate = 2; }
        hinge e1, e2 { start = [10, 20] deg; start_rate = [1, 2]; }
    };

    gimbal: Ringed RingedByTransfer {
        ground -> repeat 2 { gimbal(x, [1, 0, 2], y) a -> Rod b -> pin(z) c -> Cube d };
        hinge a { start = [10, 20, -30] deg; start_rate = [1, 2, -1]; }
    } = RingedOut {
        ground -> gimbal(x, [1, 0, 2], y) a1 -> Rod b1 -> pin(z) c1 -> Cube d1
            -> gimbal(x, [1, 0, 2], y) a2 -> Rod b2 -> pin(z) c2 -> Cube d2;
        hinge a1, a2 { start = [10, 20, -30] deg; start_rate = [1, 2, -1]; }
    };

    ball_planar: Threefold {
        ground -> repeat 2 { ball a -> Rod b -> planar(x) c -> Cube d };
        hinge a { start = rpy(10, -20, 30) deg; start_rate = [1, 2, 3]; }
        hinge c { start = [0.1, 0.2] m turned -1; start_velocity = [1, 2]; start_rate = 3; }
    } = ThreefoldOut {
        ground -> ball a1 -> Rod b1 -> planar(x) c1 -> Cube d1
            -> ball a2 -> Rod b2 -> planar(x) c2 -> Cube d2;
        hinge a1, a2 { start = rpy(10, -20, 30) deg; start_rate = [1, 2, 3]; }
        hinge c1, c2 { start = [0.1, 0.2] m turned -1; start_velocity = [1, 2]; start_rate = 3; }
    };

    floating_elastic: Sixfold {
        ground -> repeat 2 { floating a -> Rod b -> elastic c -> Cube d };
        hinge a {
            start = [0.1, 0.2, 0.3] m turned quaternion(4, 1, 2, 3);
            start_velocity = [1, 2, 3];
            start_rate = [3, 2, 1];
        }
        hinge c { start = [0.3, 0.1, 0.2] m turned rpy(0.1, 0.2, 8) rad; start_rate = [1, 2, 1]; }
    } = SixfoldOut {
        ground -> floating a1 -> Rod b1 -> elastic c1 -> Cube d1
            -> floating a2 -> Rod b2 -> elastic c2 -> Cube d2;
        hinge a1, a2 {
            start = [0.1, 0.2, 0.3] m turned quaternion(4, 1, 2, 3);
            start_velocity = [1, 2, 3];
            start_rate = [3, 2, 1];
        }
        hinge c1, c2 { start = [0.3, 0.1, 0.2] m turned rpy(0.1, 0.2, 8) rad; start_rate = [1, 2, 1]; }
    };

    welds: Welded {
        ground -> repeat 2 { weld a -> Rod b } -> pin j -> Cube base
            -> repeat 2 { weld c -> Rod d -> ball e -> Cube f } -> repeat 3 { weld g -> Rod h };
        spring s { on = b; to = [1, 2, 3] m; stiffness = 5; }
        spring r { on = d; at = tip; to = [1, 2, 3] m; stiffness = 5; length = 1; }
        load p { on = h; at = tip; force = [1, 2, 3] N; }
    } = WeldedOut {
        ground -> weld a1 -> Rod b1 -> weld a2 -> Rod b2 -> pin j -> Cube base
            -> weld c1 -> Rod d1 -> ball e1 -> Cube f1 -> weld c2 -> Rod d2 -> ball e2 -> Cube f2
            -> weld g1 -> Rod h1 -> weld g2 -> Rod h2 -> weld g3 -> Rod h3;
        spring s1 { on = b1; to = [1, 2, 3] m; stiffness = 5; }
        spring s2 { on = b2; to = [1, 2, 3] m; stiffness = 5; }
        spring r1 { on = d1; at = tip; to = [1, 2, 3] m; stiffness = 5; length = 1; }
        spring r2 { on = d2; at = tip; to = [1, 2, 3] m; stiffness = 5; length = 1; }
        load p1 { on = h1; at = tip; force = [1, 2, 3] N; }
        load p2 { on = h2; at = tip; force = [1, 2, 3] N; }
        load p3 { on = h3; at = tip; force = [1, 2, 3] N; }
    };
}

#[test]
fn in_single_precision() {
    twins!(@compare f32 [Sixfold] SixfoldOut);
}
