//! The answers of a chain. Each is one function of the generated code.

/// A function of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Answer {
    /// Accelerations of all hinges.
    Accelerations,
    /// Accelerations of a linearly implicit step.
    ImplicitAccelerations,
    /// Everything that `results` names.
    Solution,
    /// Kinetic and potential energy.
    Energy,
    /// Time derivatives of the coordinates.
    CoordinateRates,
    /// Coordinates with quaternions of unit length.
    Normalized,
    /// Projection of coordinates and rates onto the loop constraints.
    Correction,
    /// The pivots that determine the rank of the loop constraints.
    ClosurePivots,
    /// The state that a simulation starts from.
    Start,
    /// Inverse dynamics at zero accelerations: the efforts that keep all rates constant.
    BiasEfforts,
    /// Inverse dynamics: the efforts for given accelerations.
    InverseDynamics,
    /// The efforts that balance gravity at rest.
    GravityEfforts,
    /// The efforts of springs, dampers, friction and stops.
    PassiveEfforts,
    /// Everything that `results` names, for given accelerations.
    InverseSolution,
    /// The product of the mass matrix with a vector.
    MassMatrixTimes,
    /// The product of the inverse of the mass matrix with a vector.
    InverseMassMatrixTimes,
    /// The accelerations, and their derivative along a direction.
    Push,
    /// The change of inverse dynamics along a direction.
    EffortsChange,
    /// The accelerations, and the gradient of their sum with weights.
    Pull,
    /// The product of a closed chain's constraint Jacobian with a vector.
    ClosureJacobianTimes,
    /// The matrix that maps the dynamic parameters to efforts.
    Regressor,
    /// The product of the regressor with values of the dynamic parameters.
    RegressorTimes,
    /// The dynamic parameters.
    DynamicParameters,
    /// The mass matrix.
    MassMatrix,
    /// The inverse of the mass matrix.
    InverseMassMatrix,
    /// The derivatives of inverse dynamics.
    InverseDynamicsDerivatives,
    /// The accelerations with the inverse of the mass matrix, and derivatives of inverse dynamics.
    Linearization,
    /// Motions of all bodies and columns of all rates, without dynamics.
    Kinematics,
    /// Mass, centre of mass and momentum.
    Momentum,
    /// The matrix that maps rates to momentum.
    MomentumMatrix,
    /// The motions that the regressor is made of, with several rates at a time.
    RegressorMotions,
    /// The product of the Coriolis matrix with a vector.
    CoriolisMatrixTimes,
    /// The Coriolis matrix.
    CoriolisMatrix,
}

impl Answer {
    /// All answers, in the order in which they are computed. New ones go last, so that the text of
    /// the others does not change.
    pub const ALL: [Answer; 33] = [
        Answer::Accelerations,
        Answer::ImplicitAccelerations,
        Answer::Solution,
        Answer::Energy,
        Answer::CoordinateRates,
        Answer::Normalized,
        Answer::Correction,
        Answer::ClosurePivots,
        Answer::Start,
        Answer::BiasEfforts,
        Answer::InverseDynamics,
        Answer::GravityEfforts,
        Answer::PassiveEfforts,
        Answer::InverseSolution,
        Answer::MassMatrixTimes,
        Answer::InverseMassMatrixTimes,
        Answer::Push,
        Answer::EffortsChange,
        Answer::Pull,
        Answer::ClosureJacobianTimes,
        Answer::Regressor,
        Answer::RegressorTimes,
        Answer::DynamicParameters,
        Answer::MassMatrix,
        Answer::InverseMassMatrix,
        Answer::InverseDynamicsDerivatives,
        Answer::Linearization,
        Answer::Kinematics,
        Answer::Momentum,
        Answer::MomentumMatrix,
        Answer::RegressorMotions,
        Answer::CoriolisMatrixTimes,
        Answer::CoriolisMatrix,
    ];

    /// Returns whether chains have this function only if their description asks for it.
    pub fn is_requested(self) -> bool {
        self >= Answer::BiasEfforts
    }

    /// Returns its name in the text of a program.
    pub fn name(self) -> &'static str {
        match self {
            Answer::Accelerations => "accelerations",
            Answer::ImplicitAccelerations => "implicit_accelerations",
            Answer::Solution => "solution",
            Answer::Energy => "energy",
            Answer::CoordinateRates => "coordinate_rates",
            Answer::Normalized => "normalized",
            Answer::Correction => "correction",
            Answer::ClosurePivots => "closure_pivots",
            Answer::Start => "start",
            Answer::BiasEfforts => "bias_efforts",
            Answer::InverseDynamics => "inverse_dynamics",
            Answer::GravityEfforts => "gravity_efforts",
            Answer::PassiveEfforts => "passive_efforts",
            Answer::InverseSolution => "inverse_solution",
            Answer::MassMatrixTimes => "mass_matrix_times",
            Answer::InverseMassMatrixTimes => "inverse_mass_matrix_times",
            Answer::Push => "push",
            Answer::EffortsChange => "efforts_change",
            Answer::Pull => "pull",
            Answer::ClosureJacobianTimes => "closure_jacobian_times",
            Answer::Regressor => "regressor",
            Answer::RegressorTimes => "regressor_times",
            Answer::DynamicParameters => "dynamic_parameters",
            Answer::MassMatrix => "mass_matrix",
            Answer::InverseMassMatrix => "inverse_mass_matrix",
            Answer::InverseDynamicsDerivatives => "inverse_dynamics_derivatives",
            Answer::Linearization => "linearization",
            Answer::Kinematics => "kinematics",
            Answer::Momentum => "momentum",
            Answer::MomentumMatrix => "momentum_matrix",
            Answer::RegressorMotions => "regressor_motions",
            Answer::CoriolisMatrixTimes => "coriolis_matrix_times",
            Answer::CoriolisMatrix => "coriolis_matrix",
        }
    }
}
