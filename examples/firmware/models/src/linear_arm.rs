//! The linear model of the arm, as a controller with a model of its future needs it in every step.

use mstmm::nalgebra::SMatrix;
use mstmm::{Error, mstmm_chain};

use crate::{Hash, Model, Number, STEP};

include!("../../../panda.rs");

panda! {
    /// The Franka Emika Panda without its hand, from its URDF, with its linear model.
    pub chain LinearArm {
        bodies { answers = linearize; }
        hinges {
            hinge j2 { start = -45 deg; }
            hinge j4 { start = -135 deg; }
            hinge j6 { start = 90 deg; }
        }
    }
}

/// The damping of all joints in N m s/rad.
const DAMPING: f64 = 0.5;

/// The derivatives of the accelerations, and A and B of the linear model ẋ = A x + B u.
pub struct LinearModel<T: Number> {
    derivatives: LinearArmLinearization<T>,
    a: SMatrix<T, 14, 14>,
    b: SMatrix<T, 14, 7>,
}

impl<T: Number> Model for LinearArm<T> {
    type Work = LinearModel<T>;

    fn new() -> Self {
        LinearArm::new()
    }

    fn start(&self) -> Self::State {
        self.initial_state()
    }

    fn inputs(&self, state: &Self::State) -> Self::Inputs {
        let torque = |joint: usize| T::constant(-DAMPING) * state.v[joint];
        let [j1, j2, j3, j4, j5, j6, j7] = core::array::from_fn(torque);
        LinearArmInputs { j1, j2, j3, j4, j5, j6, j7 }
    }

    fn work() -> Self::Work {
        let zero = T::constant(0.0);
        LinearModel {
            derivatives: LinearArmLinearization::default(),
            a: SMatrix::from([[zero; 14]; 14]),
            b: SMatrix::from([[zero; 14]; 7]),
        }
    }

    /// Computes the linear model, and takes a step of the semi-implicit Euler method with its accelerations.
    fn step(&self, model: &mut Self::Work, state: &mut Self::State) -> Result<(), Error> {
        self.linearize_into(state, &self.inputs(state), &mut model.derivatives)?;
        (model.a, model.b) = (model.derivatives.a(), model.derivatives.b());
        let step = T::constant(STEP);
        let accelerations = &model.derivatives.accelerations;
        state.v.iter_mut().zip(accelerations).for_each(|(v, &a)| *v += step * a);
        state.q.iter_mut().zip(&state.v).for_each(|(q, &v)| *q += step * v);
        Ok(())
    }

    fn add_results(model: &Self::Work, hash: &mut Hash) {
        hash.add(model.a.iter().chain(&model.b).copied());
    }
}
