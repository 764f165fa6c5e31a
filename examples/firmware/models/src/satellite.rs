//! A tree: a satellite with two wings and a reaction wheel.

use crate::{Model, Number, integrator, simulate};
use mstmm::{Error, Rk4, mstmm_chain};

include!("../../../../tests/trees/models/satellite.chain");

/// The torque on the wheel for a rate of the hub, in N m s/rad.
const DAMPING: f64 = 5.0;

impl<T: Number> Model for Satellite<T> {
    type Work = Rk4<Self>;

    fn new() -> Self {
        Satellite::new()
    }

    fn start(&self) -> Self::State {
        self.initial_state()
    }

    fn inputs(&self, state: &Self::State) -> Self::Inputs {
        SatelliteInputs { axle: T::constant(DAMPING) * state.hub().rate().z }
    }

    fn work() -> Rk4<Self> {
        integrator()
    }

    fn step(&self, rk4: &mut Rk4<Self>, state: &mut Self::State) -> Result<(), Error> {
        simulate(self, rk4, state)
    }
}
