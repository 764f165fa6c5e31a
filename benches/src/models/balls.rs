//! B: the cubes of section 4.1 on ball-and-socket hinges.

use super::{case, each_vector, mstmm_chain};

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

    /// Ten unit cubes on ball-and-socket hinges.
    pub chain Balls10 {
        gravity = [0, -9.8, 0] m/s^2;
        body Cube {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
        }
        ground -> ball j1 -> Cube b1 -> ball j2 -> Cube b2 -> ball j3 -> Cube b3
               -> ball j4 -> Cube b4 -> ball j5 -> Cube b5 -> ball j6 -> Cube b6
               -> ball j7 -> Cube b7 -> ball j8 -> Cube b8 -> ball j9 -> Cube b9
               -> ball j10 -> Cube b10;
        hinge j1, j2, j3, j4, j5, j6, j7, j8, j9, j10 { torque = input; }
    }

    /// A hundred unit cubes on ball-and-socket hinges.
    pub chain Balls100 {
        gravity = [0, -9.8, 0] m/s^2;
        body Cube {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
        }
        ground -> repeat 100 { ball joint -> Cube cube };
        hinge joint { torque = input; }
    }
}

case!(Balls3, "B3", |inputs, torques| each_vector!(inputs, torques: j1 j2 j3));
case!(
    Balls10,
    "B10",
    |inputs, torques| each_vector!(inputs, torques: j1 j2 j3 j4 j5 j6 j7 j8 j9 j10)
);
case!(Balls100, "B100", |inputs, torques| {
    let (vectors, _) = torques.as_chunks::<3>();
    for (joint, vector) in inputs.joint.iter_mut().zip(vectors) {
        *joint = (*vector).into();
    }
});
