//! C: the same cubes on pins; neighbouring pins are perpendicular.

use super::{case, each_hinge, mstmm_chain};

mstmm_chain! {
    /// Seven unit cubes on pins about z and y in turn.
    pub chain Pins7 {
        gravity = [0, -9.8, 0] m/s^2;
        body Cube {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
        }
        ground -> pin(z) j1 -> Cube b1 -> pin(y) j2 -> Cube b2 -> pin(z) j3 -> Cube b3
               -> pin(y) j4 -> Cube b4 -> pin(z) j5 -> Cube b5 -> pin(y) j6 -> Cube b6
               -> pin(z) j7 -> Cube b7;
        hinge j1, j2, j3, j4, j5, j6, j7 { torque = input; }
    }

    /// Thirty unit cubes on pins about z and y in turn.
    pub chain Pins30 {
        gravity = [0, -9.8, 0] m/s^2;
        body Cube {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
        }
        ground -> repeat 15 { pin(z) first -> Cube upper -> pin(y) second -> Cube lower };
        hinge first, second { torque = input; }
    }
}

case!(Pins7, "C7", |inputs, torques| each_hinge!(inputs, torques: j1 j2 j3 j4 j5 j6 j7));
case!(Pins30, "C30", |inputs, torques| {
    let (pairs, _) = torques.as_chunks::<2>();
    for (index, &[first, second]) in pairs.iter().enumerate() {
        (inputs.first[index], inputs.second[index]) = (first, second);
    }
});
