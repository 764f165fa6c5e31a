//! The arm as a chain, and its controller.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use mstmm::{ChainState, Scalar, mstmm_chain};

include!("../panda.rs");

panda! {
    /// The Franka Emika Panda without its hand, from its URDF, with a payload on its flange.
    pub chain Panda {
        bodies {
            param payload = 1.5 kg;
            param x = 0 m;
            param y = 0 m;
            param z = 5 cm;
            param xx = 0.005 kg*m^2;
            param yy = 0.005 kg*m^2;
            param zz = 0.005 kg*m^2;

            body Payload {
                mass = payload;
                com = [x, y, z];
                inertia = diag(xx, yy, zz) about com;
            }
        }
        route { -> weld flange -> Payload load }
        hinges {
            hinge j1, j2, j3, j4, j5, j6, j7 {
                armature = 0.1 kg*m^2; // what the rotors are taken for in MuJoCo's model of the arm
            }
        }
    }
}

/// The target of the controller in rad: the start pose of Franka's examples.
pub const TARGET: [f64; 7] = [0.0, -FRAC_PI_4, 0.0, -3.0 * FRAC_PI_4, 0.0, FRAC_PI_2, FRAC_PI_4];

/// Stiffness and damping of the controller, in N m/rad and N m s/rad, from Franka's example of joint
/// impedance control.
const STIFFNESS: [f64; 7] = [600.0, 600.0, 600.0, 600.0, 250.0, 150.0, 50.0];
const DAMPING: [f64; 7] = [50.0, 50.0, 50.0, 50.0, 30.0, 25.0, 15.0];

/// A PD controller with the torques that hold the arm at the target with the nominal payload, the
/// payload of the description.
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
            let (angle, rate) = (state.coordinates()[joint], state.rates()[joint]);
            number(self.hold[joint]) + number(STIFFNESS[joint]) * (number(TARGET[joint]) - angle)
                - number(DAMPING[joint]) * rate
        };
        let [j1, j2, j3, j4, j5, j6, j7] = std::array::from_fn(torque);
        PandaInputs { j1, j2, j3, j4, j5, j6, j7 }
    }
}
