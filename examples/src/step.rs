//! Steps as a real-time loop would call them, compiled on their own so that their assembly can be
//! looked through: `.ci/run` sees to it that no way through them leads to a panic.

use mstmm::prelude::*;
use mstmm::{Dopri5, Error};

mstmm_chain! {
    /// Three unit cubes on ball-and-socket hinges (Rui et al. 2016, section 4.1).
    pub chain BallPendulum {
        gravity = [0, -9.8, 0] m/s^2;
        body Cube {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
        }
        ground -> ball shoulder -> Cube upper -> ball elbow -> Cube middle -> ball wrist -> Cube lower;
    }

    /// A driven arm on a floating hub, by the forward product.
    pub chain Satellite {
        method = transfer;
        param payload = 0.5 kg;
        body Hub {
            mass = 5 kg;
            com = [0, 0, 0.1] m;
            output = [0, 0, 0.4] m turned rpy(90, 0, 20) deg;
            inertia = diag(0.5, 0.5, 0.6) kg*m^2 about com;
        }
        body Boom {
            mass = 1 kg + payload;
            com = [0.5, 0, 0] m;
            inertia = diag(0.01, 0.1, 0.1) kg*m^2 about com;
        }
        Hub hub -> pin(z) joint -> Boom boom;
        hinge joint { torque = input; }
    }
}

/// One step of the pendulum in single precision.
#[inline(never)]
pub fn pendulum(
    chain: &BallPendulum<f32>,
    rk4: &mut Rk4<BallPendulum<f32>>,
    state: &mut BallPendulumState<f32>,
) -> Result<(), Error> {
    rk4.step(chain, state, |_, _| chain.no_inputs())
}

/// Everything at every connection point of the pendulum.
#[inline(never)]
pub fn pendulum_loads(
    chain: &BallPendulum<f64>,
    state: &BallPendulumState<f64>,
    at: &mut BallPendulumWorkspace<f64>,
) -> Result<(), Error> {
    chain.solve_into(state, &chain.no_inputs(), at)
}

/// One controlled step of the satellite.
#[inline(never)]
pub fn satellite(
    chain: &Satellite<f64>,
    dopri5: &mut Dopri5<Satellite<f64>>,
    state: &mut SatelliteState<f64>,
    torque: f64,
) -> Result<(), Error> {
    dopri5.step(chain, state, |_, _| SatelliteInputs { joint: torque }).map(|_| ())
}

/// A new payload.
#[inline(never)]
pub fn satellite_payload(chain: &mut Satellite<f64>, payload: f64) -> Result<(), Error> {
    chain.set_payload(payload)
}
