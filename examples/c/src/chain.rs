//! The chain; for another chain change this file and the numbers in the header.

use mstmm::mstmm_chain;

mstmm_chain! {
    /// An arm with three motors, a payload that swings on a ball below its end, and a camera on a
    /// spring beside its column.
    pub chain Chain {
        gravity = [0, 0, -9.81] m/s^2;
        param payload_mass = 2 kg;
        param payload_spin = 0.01 kg*m^2;

        body Column {
            mass = 20 kg;
            com = [0, 0, 0.3] m;
            output = [0, 0, 0.6] m;
            inertia = diag(0.8, 0.8, 0.3) kg*m^2 about com;
            point mast = [0, 0.2, 0.6] m;
        }
        body Link {
            mass = 4 kg;
            com = [0.25, 0, 0] m;
            output = [0.5, 0, 0] m;
            inertia = diag(0.01, 0.09, 0.09) kg*m^2 about com;
        }
        body Camera {
            mass = 0.5 kg;
            com = [0, 0, 0.1] m;
            output = [0, 0, 0.2] m;
            inertia = diag(0.001, 0.001, 0.001) kg*m^2 about com;
        }
        body Payload {
            mass = payload_mass;
            com = [0, 0, -0.2] m;
            output = [0, 0, -0.4] m;
            inertia = diag(0.02 kg*m^2, 0.02 kg*m^2, payload_spin) about com;
        }

        ground -> pin(z) waist    -> Column column
               -> pin(y) shoulder -> Link upper_arm
               -> pin(y) elbow    -> Link forearm
               -> ball hook       -> Payload payload;
        column.mast -> pin(x) mount -> Camera camera;

        hinge waist, shoulder, elbow { torque = input; damping = 0.5 N*m*s/rad; }
        hinge mount { stiffness = 20 N*m/rad; damping = 0.1 N*m*s/rad; }
        hinge shoulder { start = -45 deg; }
        hinge elbow { start = 90 deg; }
        hinge hook { start = rpy(0, -45, 0) deg; }
    }
}
