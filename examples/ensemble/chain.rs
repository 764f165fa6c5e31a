//! The arm as a chain, and its controller.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use mstmm::{ChainState, Scalar, mstmm_chain};

mstmm_chain! {
    /// The Franka Emika Panda without its hand, from its URDF, with a payload on its flange.
    pub chain Panda {
        gravity = [0, 0, -9.81] m/s^2;
        param payload = 1.5 kg;
        param x = 0 m;
        param y = 0 m;
        param z = 5 cm;
        param xx = 0.005 kg*m^2;
        param yy = 0.005 kg*m^2;
        param zz = 0.005 kg*m^2;

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
        body Payload {
            mass = payload;
            com = [x, y, z];
            inertia = diag(xx, yy, zz) about com;
        }
        ground at [0, 0, 0.333]
            -> pin(z) j1 -> L1
            -> pin(z) j2 -> L2
            -> pin(z) j3 -> L3
            -> pin(z) j4 -> L4
            -> pin(z) j5 -> L5
            -> pin(z) j6 -> L6
            -> pin(z) j7 -> L7
            -> weld flange -> Payload load;

        hinge j1, j2, j3, j4, j5, j6, j7 {
            torque = input;
            armature = 0.1 kg*m^2; // what the rotors are taken for in MuJoCo's model of the arm
        }
    }
}

/// The pose that the controller brings the arm to, in rad: the one Franka's own examples start from.
pub const TARGET: [f64; 7] = [0.0, -FRAC_PI_4, 0.0, -3.0 * FRAC_PI_4, 0.0, FRAC_PI_2, FRAC_PI_4];

/// What stiffness and damping the controller gives the joints, in N m/rad and N m s/rad: that of
/// Franka's example of joint impedance.
const STIFFNESS: [f64; 7] = [600.0, 600.0, 600.0, 600.0, 250.0, 150.0, 50.0];
const DAMPING: [f64; 7] = [50.0, 50.0, 50.0, 50.0, 30.0, 25.0, 15.0];

/// Springs and dampers to the target, and what holds the arm there with the payload that the
/// controller believes in: the one of the description.
pub struct Controller {
    hold: [f64; 7],
}

impl Controller {
    pub fn new() -> Self {
        let believed = Panda::<f64>::new();
        let potential = |joint: usize, turn: f64| {
            let mut state = PandaState { q: TARGET.into(), ..PandaState::default() };
            state.q[joint] += turn;
            believed.energy(&state).potential
        };
        let slope = |joint| (potential(joint, 1e-4) - potential(joint, -1e-4)) / 2e-4;
        Self { hold: std::array::from_fn(slope) }
    }

    pub fn torques<T: Scalar>(&self, state: &PandaState<T>) -> PandaInputs<T> {
        let number = T::constant;
        let torque = |joint: usize| {
            let (angle, rate) = (state.q()[joint], state.v()[joint]);
            number(self.hold[joint]) + number(STIFFNESS[joint]) * (number(TARGET[joint]) - angle)
                - number(DAMPING[joint]) * rate
        };
        let [j1, j2, j3, j4, j5, j6, j7] = std::array::from_fn(torque);
        PandaInputs { j1, j2, j3, j4, j5, j6, j7 }
    }
}
