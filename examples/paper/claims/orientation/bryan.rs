//! The cube on a ball with the paper's coordinates: the state is the Bryan angles θ and their rates, and
//! θ̈ = H⁻¹ Aᵀ Ω̇ − H⁻¹ Ḣ θ̇ [P, Section 2.1].
//!
//! Ω̇ is that of generated code, and the integrator is the same, so that only the coordinates differ.

use mstmm::paper::rotation;
use mstmm::{Chain, ChainState, Error};
use nalgebra::Vector3;

use super::{Top, TopInputs, TopState};

/// The cube in Bryan angles.
pub struct ByAngles<'a>(pub &'a Top<f64>);

/// Angles in rad, their rates in rad/s, and the time in s.
#[derive(Clone, Default)]
pub struct Angles {
    q: [f64; 3],
    v: [f64; 3],
    time: f64,
}

impl Angles {
    /// The state at zero angles, where the rates of the angles are Ω.
    pub fn level(angular_velocity: Vector3<f64>) -> Self {
        Angles { v: angular_velocity.into(), ..Angles::default() }
    }

    /// The same state for generated code.
    pub fn as_top(&self) -> TopState<f64> {
        let rate = rotation::rate_matrix(&self.q.into()) * Vector3::from(self.v);
        let mut state = TopState::default();
        state.joint_mut().set_bryan_angles(self.q).set_rate(rate);
        state
    }
}

impl ChainState for Angles {
    type Scalar = f64;

    fn coordinates(&self) -> &[f64] {
        &self.q
    }

    fn coordinates_mut(&mut self) -> &mut [f64] {
        &mut self.q
    }

    fn rates(&self) -> &[f64] {
        &self.v
    }

    fn rates_mut(&mut self) -> &mut [f64] {
        &mut self.v
    }

    fn time(&self) -> f64 {
        self.time
    }

    fn set_time(&mut self, time: f64) {
        self.time = time;
    }
}

impl Chain for ByAngles<'_> {
    type Scalar = f64;
    type State = Angles;
    type Inputs = TopInputs<f64>;

    fn derivative_into(
        &self,
        state: &Angles,
        inputs: &TopInputs<f64>,
        rate: &mut Angles,
    ) -> Result<(), Error> {
        let angular_acceleration = self.0.accelerations(&state.as_top(), inputs)?;
        let (angles, rates) = (state.q.into(), state.v.into());
        let turning = rotation::rotation_matrix(&angles) * angular_acceleration;
        rate.q = state.v;
        rate.v = rotation::angle_accelerations(&angles, &rates, &turning).into();
        Ok(())
    }

    fn configuration_rate_into(&self, state: &Angles, rate: &mut Angles) {
        rate.q = state.v;
    }

    /// Does nothing: there is no quaternion.
    fn normalize(&self, _state: &mut Angles) {}
}
