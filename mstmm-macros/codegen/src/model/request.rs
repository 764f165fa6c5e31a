//! The requests of a description: the words of `answers = […];`, each for one or more functions.

use Request::{
    BiasEfforts, CoriolisMatrix, Derivatives, InverseDynamics, Jacobian, Kinematics, Linearize,
    MassMatrix, Momentum, Pull, Push, Regressor,
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
    /// The Coriolis matrix, and its product with a vector.
    CoriolisMatrix,
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
    ("coriolis_matrix", &[CoriolisMatrix]),
    ("basic", &[InverseDynamics, MassMatrix, Jacobian]),
];

/// What a word of another program stands for.
#[derive(Clone, Copy, Debug)]
pub enum Foreign {
    /// A word of `answers`.
    Keyword(&'static str),
    /// A method that every chain has.
    OfAll(&'static str),
}

/// Functions of other programs, and of chains, that are no words of `answers`.
pub const OTHER_ANSWERS: &[(&str, Foreign)] = &[
    ("rnea", Foreign::Keyword("inverse_dynamics")),
    ("mj_inverse", Foreign::Keyword("inverse_dynamics")),
    ("CalcInverseDynamics", Foreign::Keyword("inverse_dynamics")),
    ("computeGeneralizedGravity", Foreign::Keyword("inverse_dynamics")),
    ("gravity", Foreign::Keyword("inverse_dynamics")),
    ("gravity_efforts", Foreign::Keyword("inverse_dynamics")),
    ("passive_efforts", Foreign::Keyword("inverse_dynamics")),
    ("inverse_solve_into", Foreign::Keyword("inverse_dynamics")),
    ("nonLinearEffects", Foreign::Keyword("bias_efforts")),
    ("nle", Foreign::Keyword("bias_efforts")),
    ("qfrc_bias", Foreign::Keyword("bias_efforts")),
    ("coriolis", Foreign::Keyword("bias_efforts")),
    ("computeCoriolisMatrix", Foreign::Keyword("coriolis_matrix")),
    ("coriolis_matrix_times", Foreign::Keyword("coriolis_matrix")),
    ("bias", Foreign::Keyword("bias_efforts")),
    ("crba", Foreign::Keyword("mass_matrix")),
    ("mass", Foreign::Keyword("mass_matrix")),
    ("mj_fullM", Foreign::Keyword("mass_matrix")),
    ("CalcMassMatrix", Foreign::Keyword("mass_matrix")),
    ("computeMinverse", Foreign::Keyword("mass_matrix")),
    ("inverse_mass_matrix", Foreign::Keyword("mass_matrix")),
    ("mass_matrix_times", Foreign::Keyword("mass_matrix")),
    ("inverse_mass_matrix_times", Foreign::Keyword("mass_matrix")),
    ("fk", Foreign::Keyword("kinematics")),
    ("forward_kinematics", Foreign::Keyword("kinematics")),
    ("forwardKinematics", Foreign::Keyword("kinematics")),
    ("mj_kinematics", Foreign::Keyword("kinematics")),
    ("mj_jac", Foreign::Keyword("jacobian")),
    ("getFrameJacobian", Foreign::Keyword("jacobian")),
    ("closure_jacobian", Foreign::Keyword("jacobian")),
    ("operational_space_inertia", Foreign::Keyword("jacobian")),
    ("ccrba", Foreign::Keyword("momentum")),
    ("centroidal_momentum", Foreign::Keyword("momentum")),
    ("momentum_matrix", Foreign::Keyword("momentum")),
    ("center_of_mass", Foreign::Keyword("momentum")),
    ("computeJointTorqueRegressor", Foreign::Keyword("regressor")),
    ("dynamic_parameters", Foreign::Keyword("regressor")),
    ("base_parameters", Foreign::Keyword("regressor")),
    ("computeRNEADerivatives", Foreign::Keyword("derivatives")),
    ("inverse_dynamics_derivatives", Foreign::Keyword("derivatives")),
    ("computeABADerivatives", Foreign::Keyword("linearize")),
    ("linearization", Foreign::Keyword("linearize")),
    ("discretize", Foreign::Keyword("linearize")),
    ("lqr", Foreign::Keyword("linearize")),
    ("jvp", Foreign::Keyword("push")),
    ("push_into", Foreign::Keyword("push")),
    ("vjp", Foreign::Keyword("pull")),
    ("gradient", Foreign::Keyword("pull")),
    ("pull_into", Foreign::Keyword("pull")),
    ("aba", Foreign::OfAll("accelerations")),
    ("forward_dynamics", Foreign::OfAll("accelerations")),
    ("accelerations", Foreign::OfAll("accelerations")),
    ("energy", Foreign::OfAll("energy")),
    ("solve_into", Foreign::OfAll("solve_into")),
];
