//! Repeated parts at the start, in the middle, at the end and behind each other, in chains that are
//! held, move or float.

use super::motions::floating;
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

    one_after_the_other: Rows RowsByTransfer {
        ground -> repeat 2 { pin a -> Rod b } -> repeat 2 { pin(x) c -> Cube d };
    } = RowsOut {
        ground -> pin a1 -> Rod b1 -> pin a2 -> Rod b2 -> pin(x) c1 -> Cube d1
            -> pin(x) c2 -> Cube d2;
    };

    mixed: Mixed {
        ground -> ball first -> Rod base -> repeat 2 { pin a -> Rod b } -> pin(y) middle -> Cube hub
            -> weld w -> Rod arm -> repeat 2 { slider c -> Cube d } -> universal last -> Rod tip;
        hinge last { start = [0.1, 0.2]; }
        hinge first { start_rate = [1, 2, 3]; }
    } = MixedOut {
        ground -> ball first -> Rod base -> pin a1 -> Rod b1 -> pin a2 -> Rod b2
            -> pin(y) middle -> Cube hub -> weld w -> Rod arm -> slider c1 -> Cube d1
            -> slider c2 -> Cube d2 -> universal last -> Rod tip;
        hinge last { start = [0.1, 0.2]; }
        hinge first { start_rate = [1, 2, 3]; }
    };

    floats: Adrift AdriftByTransfer {
        Cube hub -> repeat 2 { pin a -> Rod b } -> ball last -> Cube tip;
        body hub { start = [1, 2, 3] m turned rpy(10, 20, 30) deg; start_velocity = [1, 2, 3]; }
    } = AdriftOut {
        Cube hub -> pin a1 -> Rod b1 -> pin a2 -> Rod b2 -> ball last -> Cube tip;
        body hub { start = [1, 2, 3] m turned rpy(10, 20, 30) deg; start_velocity = [1, 2, 3]; }
    };

    floats_and_ends_repeated: Loose {
        Cube hub -> repeat 2 { ball a -> Rod b } -> repeat 2 { pin c -> Rod d };
        body hub { start_rate = [1, 2, 3]; }
    } = LooseOut {
        Cube hub -> ball a1 -> Rod b1 -> ball a2 -> Rod b2 -> pin c1 -> Rod d1 -> pin c2 -> Rod d2;
        body hub { start_rate = [1, 2, 3]; }
    };

    moves_at_the_start: Crane {
        moving deck -> repeat 2 { universal a -> Rod b } -> pin last -> Cube tip;
    } = CraneOut {
        moving deck -> universal a1 -> Rod b1 -> universal a2 -> Rod b2 -> pin last -> Cube tip;
    } given |x| { deck = floating(x); } = { deck = floating(x); };
}
