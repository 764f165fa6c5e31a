//! The requests of a description: the words of `answers = […];`, each for one or more functions.

use Request::{
    BiasEfforts, Derivatives, InverseDynamics, Jacobian, Kinematics, Linearize, MassMatrix,
    Momentum, Pull, Push, Regressor,
};

/// A request for functions that are not generated unless the description asks for them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Request {
    /// Efforts for given accelerations, their parts, and all wrenches.
    InverseDynamics,
    /// Inverse dynamics at zero accelerations.
    BiasEfforts,
    /// The mass matrix, its inverse, and products of both with a vector.
    MassMatrix,
    /// Poses, velocities and bias accelerations of points, without dynamics.
    Kinematics,
    /// Jacobians of points.
    Jacobian,
    /// Momentum, and the matrix that maps rates to it.
    Momentum,
    /// The matrix that maps inertial parameters to efforts.
    Regressor,
    /// Derivatives of inverse dynamics.
    Derivatives,
    /// Derivatives of the accelerations.
    Linearize,
    /// The product of the derivatives of the accelerations with a vector.
    Push,
    /// The product of a vector with the derivatives of the accelerations.
    Pull,
}

/// The words of `answers = […];` with the requests that each stands for.
pub const ANSWER_WORDS: &[(&str, &[Request])] = &[
    ("inverse_dynamics", &[InverseDynamics]),
    ("bias_efforts", &[BiasEfforts]),
    ("mass_matrix", &[MassMatrix]),
    ("kinematics", &[Kinematics]),
    ("jacobian", &[Jacobian]),
    ("momentum", &[Momentum]),
    ("regressor", &[Regressor]),
    ("derivatives", &[Derivatives]),
    ("linearize", &[Linearize]),
    ("push", &[Push]),
    ("pull", &[Pull]),
    ("basic", &[InverseDynamics, MassMatrix, Jacobian]),
];
