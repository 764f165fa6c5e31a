//! Repeated parts in chains that are held at both ends, brought there by assembly.

use super::motions::floating;
use super::twins::twins;

twins! {
    [space
        gravity = [1, -9.8, 2] m/s^2;
        body Bar {
            mass = 1 kg;
            com = [0.3, 0.1, 0] m;
            output = [0.6, 0, 0] m;
            inertia = diag(0.03, 0.12, 0.14) kg*m^2 about com;
        }
    ]

    rope: Rope {
        ground -> repeat 3 { ball a -> Bar b } -> ball last -> ground at [1.2, 0.5, 0.2] m;
    } = RopeOut {
        ground -> ball a1 -> Bar b1 -> ball a2 -> Bar b2 -> ball a3 -> Bar b3
            -> ball last -> ground at [1.2, 0.5, 0.2] m;
    };

    // Three directions of its closure follow from the others.
    flat_loop: Loop LoopByTransfer {
        ground -> repeat 2 { pin a -> Bar b } -> pin middle -> Bar bar -> pin last
            -> ground at [1, 0.2, 0] m;
    } = LoopOut {
        ground -> pin a1 -> Bar b1 -> pin a2 -> Bar b2 -> pin middle -> Bar bar -> pin last
            -> ground at [1, 0.2, 0] m;
    };

    driven: Driven {
        moving deck -> ball first -> Bar bar -> repeat 2 { ball a -> Bar b -> weld c -> Bar d }
            -> elastic last -> moving hook;
        hinge a { torque = input; damping = 0.3; }
        hinge last { stiffness = 100; turning_stiffness = [2, 3, 4]; }
    } = DrivenOut {
        moving deck -> ball first -> Bar bar -> ball a1 -> Bar b1 -> weld c1 -> Bar d1
            -> ball a2 -> Bar b2 -> weld c2 -> Bar d2 -> elastic last -> moving hook;
        hinge a1, a2 { torque = input; damping = 0.3; }
        hinge last { stiffness = 100; turning_stiffness = [2, 3, 4]; }
    } given |x| {
        deck = floating(x);
        hook = floating(&x[20..]);
        a = [[x[40], x[41], x[42]].into(), [x[43], x[44], x[45]].into()];
    } = {
        deck = floating(x);
        hook = floating(&x[20..]);
        a1 = [x[40], x[41], x[42]].into();
        a2 = [x[43], x[44], x[45]].into();
    };

    // Bodies outboard of the repeated part are attached to the moving end.
    welded_to_the_end: Welded WeldedByTransfer {
        ground -> repeat 2 { ball a -> Bar b } -> repeat 3 { pin c -> Bar d } -> ball e -> Bar f
            -> weld g -> Bar h -> weld i -> moving hook;
    } = WeldedOut {
        ground -> ball a1 -> Bar b1 -> ball a2 -> Bar b2 -> pin c1 -> Bar d1 -> pin c2 -> Bar d2
            -> pin c3 -> Bar d3 -> ball e -> Bar f -> weld g -> Bar h -> weld i -> moving hook;
    } given |x| { hook = floating(x); } = { hook = floating(x); };
}
