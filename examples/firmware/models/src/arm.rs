//! A real arm under a controller.

use mstmm::{Error, Rk4, mstmm_chain};

use crate::{Model, Number, integrator, simulate};

include!("../../../panda.rs");

panda! {
    /// The Franka Emika Panda without its hand, from its URDF.
    pub chain Arm {
        hinges {
            hinge j2 { start = -45 deg; }
            hinge j4 { start = -135 deg; }
            hinge j6 { start = 90 deg; }
            hinge j7 { start = 45 deg; }
        }
    }
}

/// Stiffness and damping of the controller, in N m/rad and N m s/rad.
const STIFFNESS: [f64; 7] = [60.0, 60.0, 60.0, 60.0, 25.0, 15.0, 5.0];
const DAMPING: [f64; 7] = [5.0, 5.0, 5.0, 5.0, 1.0, 0.5, 0.1];

/// The target of the controller in rad.
const TARGET: [f64; 7] = [0.5, 0.3, -0.4, -1.5, 0.2, 1.8, 0.6];

impl<T: Number> Model for Arm<T> {
    type Work = Rk4<Self>;

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

    fn work() -> Rk4<Self> {
        integrator()
    }

    fn step(&self, rk4: &mut Rk4<Self>, state: &mut Self::State) -> Result<(), Error> {
        simulate(self, rk4, state)
    }
}
