//! Once, twice and seven times; both precisions.

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
    ]

    once: Once OnceByTransfer { ground -> repeat 1 { pin(y) a -> Rod b }; }
    = One { ground -> pin(y) a -> Rod b; };

    twice: Twice { ground -> repeat 2 { pin(y) a -> Rod b }; }
    = Two { ground -> pin(y) a1 -> Rod b1 -> pin(y) a2 -> Rod b2; };

    seven_times: SevenTimes SevenTimesByTransfer {
        ground at [0.1, 0.2, 0.3] m turned rpy(10, 20, 30) deg -> repeat 7 { pin(y) a -> Rod b };
        hinge a { start = 20 deg; start_rate = 3 rad/s; }
    } = Seven {
        ground at [0.1, 0.2, 0.3] m turned rpy(10, 20, 30) deg
            -> pin(y) a1 -> Rod b1 -> pin(y) a2 -> Rod b2 -> pin(y) a3 -> Rod b3
            -> pin(y) a4 -> Rod b4 -> pin(y) a5 -> Rod b5 -> pin(y) a6 -> Rod b6
            -> pin(y) a7 -> Rod b7;
        hinge a1, a2, a3, a4, a5, a6, a7 { start = 20 deg; start_rate = 3 rad/s; }
    };
}

#[test]
fn in_single_precision() {
    twins!(@compare f32 [Once] One);
    twins!(@compare f32 [Twice] Two);
    twins!(@compare f32 [SevenTimes] Seven);
}
