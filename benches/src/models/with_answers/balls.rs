//! B: the cubes of section 4.1 on ball-and-socket hinges.

use super::mstmm_chain;

mstmm_chain! {
    /// Three unit cubes on ball-and-socket hinges.
    pub chain Balls3 {
        gravity = [0, -9.8, 0] m/s^2;
        body Cube {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
        }
        ground -> ball j1 -> Cube b1 -> ball j2 -> Cube b2 -> ball j3 -> Cube b3;
        hinge j1, j2, j3 { torque = input; }
    }

    /// Thirty unit cubes on ball-and-socket hinges.
    pub chain Balls30 {
        gravity = [0, -9.8, 0] m/s^2;
        body Cube {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
        }
        ground -> repeat 30 { ball joint -> Cube cube };
        hinge joint { torque = input; }
    }
}
