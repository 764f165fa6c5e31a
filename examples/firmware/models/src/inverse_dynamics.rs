//! A controller of the arm by inverse dynamics.

use mstmm::nalgebra::SVector;
use mstmm::{Error, mstmm_chain};

use crate::{Hash, Model, Number, STEP};

include!("../../../panda.rs");

panda! {
    /// The Franka Emika Panda without its hand, from its URDF, with inverse dynamics.
    pub chain InverseDynamics {
        bodies { answers = inverse_dynamics; }
        hinges {
            hinge j2 { start = -45 deg; }
            hinge j4 { start = -135 deg; }
            hinge j6 { start = 90 deg; }
        }
    }
}

/// The target of the controller in rad.
const TARGET: [f64; 7] = [0.5, 0.3, -0.4, -1.5, 0.2, 1.8, 0.6];
/// The frequency in rad/s with which the arm approaches the target, without overshoot.
const FREQUENCY: f64 = 2.0;

impl<T: Number> Model for InverseDynamics<T> {
    /// The torques.
    type Work = SVector<T, 7>;

    fn new() -> Self {
        InverseDynamics::new()
    }

    fn start(&self) -> Self::State {
        self.initial_state()
    }

    fn inputs(&self, _: &Self::State) -> Self::Inputs {
        self.no_inputs()
    }

    fn work() -> Self::Work {
        SVector::from([[T::constant(0.0); 7]])
    }

    /// Computes the torques for accelerations towards the target. The arm gets these accelerations: its state changes by
    /// a step of the semi-implicit Euler method.
    fn step(&self, torques: &mut Self::Work, state: &mut Self::State) -> Result<(), Error> {
        let [stiffness, damping, step] =
            [FREQUENCY * FREQUENCY, 2.0 * FREQUENCY, STEP].map(T::constant);
        let mut accelerations = Self::work();
        let entries = accelerations.iter_mut().zip(state.q.iter().zip(&state.v)).zip(TARGET);
        entries.for_each(|((acceleration, (&q, &v)), target)| {
            *acceleration = stiffness * (T::constant(target) - q) - damping * v;
        });
        self.inverse_dynamics_into(state, &accelerations, &self.no_inputs(), torques)?;
        state.v.iter_mut().zip(&accelerations).for_each(|(v, &a)| *v += step * a);
        state.q.iter_mut().zip(&state.v).for_each(|(q, &v)| *q += step * v);
        Ok(())
    }

    fn add_results(torques: &Self::Work, hash: &mut Hash) {
        hash.add(torques.iter().copied());
    }
}
