//! The computation for each state.

use mstmm::description::{Answer, BodyFrame};

use crate::gradients::Steps;

/// The method of integration, with a fixed step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The classical Runge–Kutta method of order four.
    Rk4,
    /// The semi-implicit Euler method.
    SemiImplicitEuler,
    /// The linearly implicit Euler method, for stiff springs and dampers in hinges.
    LinearlyImplicitEuler,
}

impl Method {
    /// All methods with their names.
    pub const ALL: [(&'static str, Method); 3] = [
        ("rk4", Method::Rk4),
        ("semi_implicit_euler", Method::SemiImplicitEuler),
        ("linearly_implicit_euler", Method::LinearlyImplicitEuler),
    ];
}

/// The number of results at a connection point: position, rows of the orientation, velocity, angular velocity,
/// acceleration, angular acceleration, moment, force.
pub const POINT_VALUES: usize = 30;

/// The computation for each state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Work {
    /// The state after `steps` steps of `step` seconds; the result is all states if `every` is not zero: the first one,
    /// and one after every so many steps.
    Steps {
        /// The method of integration.
        method: Method,
        /// The step in s.
        step: f64,
        /// The number of steps.
        steps: usize,
        /// The number of steps between two results, zero for the last state only.
        every: usize,
    },
    /// The accelerations of all rates.
    Accelerations,
    /// Kinetic and potential energy.
    Energies,
    /// Accelerations, efforts, kinetic and potential energy, then the results at all connection points.
    Solution,
    /// An answer.
    Answer(Answer),
    /// The motion of a frame, 24 values as in `FrameMotion`, then the Jacobian, column by column, if the length of the
    /// result has room for it.
    Motion(BodyFrame),
    /// The gradients of weights times the states of a trajectory of RK4 steps, by start, inputs of each step and
    /// parameters. The given values are the trajectory, then as many weights.
    Pullback(Steps),
    /// The changes of the states of a trajectory of RK4 steps, the first of which is the state. The given values are the
    /// displacement of the start, along and of the rates, then the change of the parameters.
    Pushforward(Steps),
    /// The state that satisfies the loop constraints next to the given one.
    Assembly,
}
