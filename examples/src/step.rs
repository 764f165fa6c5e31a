//! Steps as a real-time loop calls them, compiled separately: `.ci/run` searches their assembly for
//! panics and allocations.

use mstmm::linear::lqr;
use mstmm::nalgebra::SMatrix;
use mstmm::prelude::*;
use mstmm::{Dopri5, Dual, Error};

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

    /// A rope of fifty rods, each with its own knot, and a weight.
    pub plane chain Rope {
        gravity = [0, -9.8] m/s^2;
        param knot[50] = 0 kg;
        body Rod {
            mass = 20 g + knot;
            com = [1, 0] cm;
            output = [2, 0] cm;
            inertia = 1e-6 kg*m^2 about com;
        }
        body Weight { mass = 1 kg; com = [0, -5] cm; inertia = 1e-3 kg*m^2 about com; }
        ground -> repeat 50 { pin joint -> Rod rod } -> pin hook -> Weight weight;
        hinge joint { stiffness = 1 N*m/rad; damping = 1e-4 N*m*s/rad; }
    }

    /// A crank that drives a rocker.
    pub plane chain FourBar {
        gravity = [0, -9.8] m/s^2;
        body Crank { mass = 1 kg; com = [0.1, 0] m; output = [0.2, 0] m; inertia = 0.01 kg*m^2 about com; }
        body Bar { mass = 2 kg; com = [0.3, 0] m; output = [0.6, 0] m; inertia = 0.06 kg*m^2 about com; }
        ground -> pin drive -> Crank crank -> pin a -> Bar coupler -> pin b -> Bar rocker
               -> pin d -> ground at [0.8, 0] m;
        hinge drive { torque = input; start = 60 deg; }
        hinge a { start = -20 deg; }
        hinge b { start = -80 deg; }
    }

    /// A floating trunk with two legs, and a tail of three links with a spike each.
    pub chain Walker {
        gravity = [0, 0, -9.8] m/s^2;
        param load[3] = 0 kg;
        body Trunk {
            mass = 5 kg;
            com = [0, 0, 0.1] m;
            output = [-0.3, 0, 0] m;
            inertia = diag(0.2, 0.3, 0.4) kg*m^2 about com;
            point left = [0, 0.2, 0] m;
            point right = [0, -0.2, 0] m;
        }
        body Link {
            mass = 1 kg;
            com = [0, 0, -0.2] m;
            output = [0, 0, -0.4] m;
            inertia = diag(0.02, 0.02, 0.01) kg*m^2 about com;
        }
        body Spike {
            mass = 0.1 kg + load;
            com = [0.1, 0, 0] m;
            inertia = diag(1e-4, 1e-4, 1e-4) kg*m^2 about com;
        }
        part Leg(side) {
            universal(x, y) hip -> Link thigh -> pin([0, side, 0]) knee -> Link shank;
            hinge hip, knee { torque = input; }
        }
        Trunk trunk -> repeat 3 { ball joint -> Link link; link.output -> pin(y) root -> Spike spike; };
        trunk.left -> Leg(1) left;
        trunk.right -> Leg(-1) right;
        hinge joint { stiffness = 5 N*m/rad; damping = 0.1 N*m*s/rad; }
        spring cord {
            on = left.shank.output; to = right.shank.output; stiffness = 50 N/m; length = 0.4 m;
        }
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

/// All results at all connection points of the pendulum.
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

/// One step of the rope, whose springs are too stiff for an explicit method.
#[inline(never)]
pub fn rope(
    chain: &Rope<f64>,
    euler: &mut LinearlyImplicitEuler<Rope<f64>>,
    state: &mut RopeState<f64>,
) -> Result<(), Error> {
    euler.step(chain, state, |_, _| chain.no_inputs())
}

/// All results at all connection points of the rope.
#[inline(never)]
pub fn rope_loads(
    chain: &Rope<f64>,
    state: &RopeState<f64>,
    at: &mut RopeWorkspace<f64>,
) -> Result<(), Error> {
    chain.solve_into(state, &chain.no_inputs(), at)
}

/// Sets a knot in the rope.
#[inline(never)]
pub fn rope_knot(chain: &mut Rope<f64>, at: usize, mass: f64) -> Result<(), Error> {
    chain.set_knot(|index| if index == at { mass } else { 0.0 })
}

/// One step of the four-bar, with a projection onto its loop constraint.
#[inline(never)]
pub fn four_bar(
    chain: &FourBar<f32>,
    rk4: &mut Rk4<FourBar<f32>>,
    state: &mut FourBarState<f32>,
    torque: f32,
) -> Result<(), Error> {
    rk4.step(chain, state, |_, _| FourBarInputs { drive: torque })
}

/// Closes the four-bar from an approximate start.
#[inline(never)]
pub fn four_bar_closed(chain: &FourBar<f64>, state: &mut FourBarState<f64>) -> Result<(), Error> {
    chain.assemble(state, &chain.no_inputs())
}

/// Sets a new payload.
#[inline(never)]
pub fn satellite_payload(chain: &mut Satellite<f64>, payload: f64) -> Result<(), Error> {
    chain.set_payload(payload)
}

/// One step of the walker, which is a tree.
#[inline(never)]
pub fn walker(
    chain: &Walker<f32>,
    rk4: &mut Rk4<Walker<f32>>,
    state: &mut WalkerState<f32>,
    knees: [f32; 2],
) -> Result<(), Error> {
    let [left_knee, right_knee] = knees;
    rk4.step(chain, state, |_, _| WalkerInputs { left_knee, right_knee, ..chain.no_inputs() })
}

/// One step of the satellite with its derivatives by the held torque and the payload.
#[inline(never)]
pub fn satellite_dual(
    chain: &Satellite<Dual<f64, 2>>,
    rk4: &mut Rk4<Satellite<Dual<f64, 2>>>,
    state: &mut SatelliteState<Dual<f64, 2>>,
    torque: Dual<f64, 2>,
) -> Result<(), Error> {
    rk4.step_held(chain, state, &SatelliteInputs { joint: torque })
}

/// The gain of a regulator for two coordinates, their rates and an input.
#[inline(never)]
pub fn regulator(
    a: &SMatrix<f32, 4, 4>,
    b: &SMatrix<f32, 4, 1>,
    weights: &SMatrix<f32, 4, 4>,
) -> Result<SMatrix<f32, 1, 4>, Error> {
    Ok(lqr(a, b, weights, &SMatrix::repeat(1.0))?.gain)
}

/// All results at all connection points of the walker.
#[inline(never)]
pub fn walker_loads(
    chain: &Walker<f64>,
    state: &WalkerState<f64>,
    at: &mut WalkerWorkspace<f64>,
) -> Result<(), Error> {
    chain.solve_into(state, &chain.no_inputs(), at)
}
