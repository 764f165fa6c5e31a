//! A real arm under a controller.

use mstmm::mstmm_chain;

use crate::{Model, Number};

mstmm_chain! {
    /// The Franka Emika Panda without its hand, from its URDF.
    pub chain Arm {
        gravity = [0, 0, -9.81] m/s^2;

        body L1 {
            mass = 4.970684; com = [0.003875, 0.002081, -0.04762];
            output = [0.0, 0.0, 0.0] turned rpy(-90, 0, 0) deg;
            inertia = tensor(0.70337, 0.70661, 0.009117, -0.000139, 0.006772, 0.019169) about com;
        }
        body L2 {
            mass = 0.646926; com = [-0.003141, -0.02872, 0.003495];
            output = [0.0, -0.316, 0.0] turned rpy(90, 0, 0) deg;
            inertia = tensor(0.007962, 0.02811, 0.025995, -0.003925, 0.010254, 0.000704) about com;
        }
        body L3 {
            mass = 3.228604; com = [0.027518, 0.039252, -0.066502];
            output = [0.0825, 0.0, 0.0] turned rpy(90, 0, 0) deg;
            inertia = tensor(0.037242, 0.036155, 0.01083, -0.004761, -0.011396, -0.012805) about com;
        }
        body L4 {
            mass = 3.587895; com = [-0.05317, 0.104419, 0.027454];
            output = [-0.0825, 0.384, 0.0] turned rpy(-90, 0, 0) deg;
            inertia = tensor(0.025853, 0.019552, 0.028323, 0.007796, -0.001332, 0.008641) about com;
        }
        body L5 {
            mass = 1.225946; com = [-0.011953, 0.041065, -0.038437];
            output = [0.0, 0.0, 0.0] turned rpy(90, 0, 0) deg;
            inertia = tensor(0.035549, 0.029474, 0.008627, -0.002117, -0.004037, 0.000229) about com;
        }
        body L6 {
            mass = 1.666555; com = [0.060149, -0.014117, -0.010517];
            output = [0.088, 0.0, 0.0] turned rpy(90, 0, 0) deg;
            inertia = tensor(0.001964, 0.004354, 0.005433, 0.000109, -0.001158, 0.000341) about com;
        }
        body L7 {
            mass = 0.735522; com = [0.010517, -0.004252, 0.061597];
            output = [0.0, 0.0, 0.107];
            inertia = tensor(0.012516, 0.010027, 0.004815, -0.000428, -0.001196, -0.000741) about com;
        }

        ground at [0, 0, 0.333]
            -> pin(z) j1 -> L1
            -> pin(z) j2 -> L2
            -> pin(z) j3 -> L3
            -> pin(z) j4 -> L4
            -> pin(z) j5 -> L5
            -> pin(z) j6 -> L6
            -> pin(z) j7 -> L7;

        hinge j1, j2, j3, j4, j5, j6, j7 { torque = input; }
        hinge j2 { start = -45 deg; }
        hinge j4 { start = -135 deg; }
        hinge j6 { start = 90 deg; }
        hinge j7 { start = 45 deg; }
    }
}

/// Of springs and dampers that the controller puts in the joints, in N m/rad and N m s/rad.
const STIFFNESS: [f64; 7] = [60.0, 60.0, 60.0, 60.0, 25.0, 15.0, 5.0];
const DAMPING: [f64; 7] = [5.0, 5.0, 5.0, 5.0, 1.0, 0.5, 0.1];

/// The pose that they pull to, in rad.
const TARGET: [f64; 7] = [0.5, 0.3, -0.4, -1.5, 0.2, 1.8, 0.6];

impl<T: Number> Model for Arm<T> {
    const STEP: f64 = 1e-3;

    fn new() -> Self {
        Arm::new()
    }

    fn start(&self) -> Self::State {
        self.initial_state()
    }

    fn inputs(&self, state: &Self::State) -> Self::Inputs {
        let torque = |joint: usize| {
            let [stiffness, damping, target] =
                [STIFFNESS[joint], DAMPING[joint], TARGET[joint]].map(T::constant);
            stiffness * (target - state.q[joint]) - damping * state.v[joint]
        };
        let [j1, j2, j3, j4, j5, j6, j7] = core::array::from_fn(torque);
        ArmInputs { j1, j2, j3, j4, j5, j6, j7 }
    }
}
