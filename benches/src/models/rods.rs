//! A: unit rods on parallel pins, written as plane chains.

use super::{case, each_hinge, mstmm_chain};

mstmm_chain! {
    /// Three unit rods on pins.
    pub plane chain Rods3 {
        gravity = [0, -9.8] m/s^2;
        body Rod { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 1/12 kg*m^2 about com; }
        ground -> pin j1 -> Rod b1 -> pin j2 -> Rod b2 -> pin j3 -> Rod b3;
        hinge j1, j2, j3 { torque = input; }
    }

    /// Ten unit rods on pins.
    pub plane chain Rods10 {
        gravity = [0, -9.8] m/s^2;
        body Rod { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 1/12 kg*m^2 about com; }
        ground -> pin j1 -> Rod b1 -> pin j2 -> Rod b2 -> pin j3 -> Rod b3
               -> pin j4 -> Rod b4 -> pin j5 -> Rod b5 -> pin j6 -> Rod b6
               -> pin j7 -> Rod b7 -> pin j8 -> Rod b8 -> pin j9 -> Rod b9
               -> pin j10 -> Rod b10;
        hinge j1, j2, j3, j4, j5, j6, j7, j8, j9, j10 { torque = input; }
    }

    /// A hundred unit rods on pins.
    pub plane chain Rods100 {
        gravity = [0, -9.8] m/s^2;
        body Rod { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 1/12 kg*m^2 about com; }
        ground -> repeat 100 { pin joint -> Rod rod };
        hinge joint { torque = input; }
    }

    /// A thousand unit rods on pins.
    pub plane chain Rods1000 {
        gravity = [0, -9.8] m/s^2;
        body Rod { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 1/12 kg*m^2 about com; }
        ground -> repeat 1000 { pin joint -> Rod rod };
        hinge joint { torque = input; }
    }
}

case!(Rods3, "A3", |inputs, torques| each_hinge!(inputs, torques: j1 j2 j3));
case!(
    Rods10,
    "A10",
    |inputs, torques| each_hinge!(inputs, torques: j1 j2 j3 j4 j5 j6 j7 j8 j9 j10)
);
case!(Rods100, "A100", |inputs, torques| inputs.joint.copy_from_slice(torques));
case!(Rods1000, "A1000", |inputs, torques| inputs.joint.copy_from_slice(torques));
