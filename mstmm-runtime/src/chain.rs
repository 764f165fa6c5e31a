//! The traits of chains and their states: what integrators and generic code use.

use crate::{Energy, Error, Scalar};

/// The state of a simulation: coordinates, rates and time.
///
/// The coordinates of all hinges are in one slice, their rates in another, hinge by hinge in the same order; the
/// order of generated chains is documented at [`GeneratedChain`]. There are fewer rates than coordinates if an
/// orientation is a quaternion. All states of one chain have slices of the same lengths.
///
/// The state of a generated chain has the same values in its public fields `q`, `v` and `t`, as vectors of a fixed
/// length. The methods of this trait are for code that is generic over the chain.
///
/// [`Default`] of a generated state is the start of the description, with default parameters.
pub trait ChainState: Clone + Default {
    /// The scalar type of the state.
    type Scalar: Scalar;

    /// Returns the state in which every hinge is at rest in its zero position, at time zero.
    ///
    /// Integrators allocate their buffers with it. The default implementation is [`Default::default`], for states
    /// whose default is that state.
    #[doc(alias("neutral", "mj_resetData"))]
    #[must_use]
    fn zero_position() -> Self {
        Self::default()
    }

    /// Returns the coordinates: rad, m, and the components w, x, y, z of unit quaternions.
    #[doc(alias("q", "qpos", "configuration", "positions", "generalized coordinates", "nq"))]
    #[doc(alias("GetPositions", "num_positions", "mj_getState"))]
    fn coordinates(&self) -> &[Self::Scalar];

    /// Returns the coordinates, to be changed.
    #[doc(alias("SetPositions", "mj_setState"))]
    fn coordinates_mut(&mut self) -> &mut [Self::Scalar];

    /// Returns the rates: rad/s and m/s.
    #[doc(alias("v", "qvel", "generalized velocities", "nv", "degrees of freedom"))]
    #[doc(alias("GetVelocities", "num_velocities", "mj_getState"))]
    fn rates(&self) -> &[Self::Scalar];

    /// Returns the rates, to be changed.
    #[doc(alias("SetVelocities", "mj_setState"))]
    fn rates_mut(&mut self) -> &mut [Self::Scalar];

    /// Returns the time in s.
    fn time(&self) -> Self::Scalar;

    /// Sets the time in s.
    fn set_time(&mut self, time: Self::Scalar);
}

/// A mechanical system that can be integrated in time.
///
/// `mstmm_chain!` implements it for the chains it generates.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a chain: the chain comes first, then the state",
    label = "expected a chain",
    note = "write `rk4.advance_to(&chain, &mut state, …)`, and other functions of a chain and a state in this order"
)]
pub trait Chain {
    /// The scalar type of the chain.
    type Scalar: Scalar;

    /// The state of the chain.
    type State: ChainState<Scalar = Self::Scalar>;

    /// The inputs of the chain: efforts of motors, external forces and torques, prescribed motions.
    type Inputs;

    /// Computes the time derivative of `state`: q̇ into `rate.coordinates()`, v̇ into `rate.rates()`.
    ///
    /// The time of `rate` is unspecified.
    ///
    /// Quaternions of `state` may have any length near one, as in the stages of an integrator. They are used
    /// unchanged and without checks. For a quaternion of length n with the rotation matrix R, the matrix
    /// (1 − n²) 1 + n² R is used, which is R up to terms of the order of n² − 1, and q̇ is n times that of the unit
    /// quaternion. [`check_state`](Chain::check_state) and [`check_inputs`](Chain::check_inputs) check states and
    /// inputs that come from outside.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if the state or the inputs are not finite. [`Error::Singular`] if the bodies outboard of
    /// a hinge have no inertia along one of its axes. `rate` is unspecified after an error.
    #[doc(alias("EvalTimeDerivatives", "CalcTimeDerivatives", "forward dynamics"))]
    fn derivative_into(
        &self,
        state: &Self::State,
        inputs: &Self::Inputs,
        rate: &mut Self::State,
    ) -> Result<(), Error>;

    /// Computes the rate of one step of the linearly implicit Euler method, for a step of `step` seconds.
    ///
    /// `rate.rates()` is the v̇ of (M + h C + h² K) v̇ = τ − h K v. Here M v̇ = τ are the equations of motion and h is
    /// the step. K = −∂τ/∂q ∂q̇/∂v and C = −∂τ/∂v are stiffness and damping of the springs, dampers, friction and
    /// limits in hinges, if their strains are coordinates. For elastic hinges and for the rotations of ball and
    /// floating hinges, whose strains s have the rates ṡ = J v, K is Jᵀ k J and C is Jᵀ c J; the omitted terms are
    /// zero at rest. `rate.coordinates()` is q̇ of `state`.
    ///
    /// If K and C are zero, the result is that of [`derivative_into`](Chain::derivative_into), which is the default.
    ///
    /// # Errors
    /// As [`derivative_into`](Chain::derivative_into).
    fn implicit_derivative_into(
        &self,
        state: &Self::State,
        inputs: &Self::Inputs,
        step: Self::Scalar,
        rate: &mut Self::State,
    ) -> Result<(), Error> {
        let _ = step;
        self.derivative_into(state, inputs, rate)
    }

    /// Computes q̇ into `rate.coordinates()` and leaves the rest of `rate` unchanged.
    ///
    /// q̇ depends on coordinates and rates only, and is linear in the rates. Values that are not finite are passed on.
    #[doc(alias("MapVelocityToQDot", "qdot"))]
    fn configuration_rate_into(&self, state: &Self::State, rate: &mut Self::State);

    /// Checks that the length of each quaternion of a state is between 0.9 and 1.1, in all lanes.
    ///
    /// A quaternion that is not finite passes; its use gives [`Error::NotFinite`]. Accelerations are those of the
    /// rotation up to terms of the order of n² − 1 for a length n, see [`derivative_into`](Chain::derivative_into).
    /// If lengths differ from one by more than rounding, call [`normalize`](Chain::normalize) first.
    ///
    /// Integrators check the given state once in each call. The default checks nothing.
    ///
    /// # Errors
    /// [`Error::InvalidQuaternion`].
    fn check_state(&self, state: &Self::State) -> Result<(), Error> {
        let _ = state;
        Ok(())
    }

    /// Checks the quaternions of prescribed motions as [`check_state`](Chain::check_state) does.
    ///
    /// Integrators check all inputs that they evaluate. The default checks nothing.
    ///
    /// # Errors
    /// [`Error::InvalidQuaternion`].
    fn check_inputs(&self, inputs: &Self::Inputs) -> Result<(), Error> {
        let _ = inputs;
        Ok(())
    }

    /// Scales the quaternions of a state to unit length.
    ///
    /// A step changes their length by no more than the error of the step.
    #[doc(alias("mj_normalizeQuat", "unit quaternion"))]
    fn normalize(&self, state: &mut Self::State);

    /// Projects a state onto the loop constraints of a closed chain, in coordinates and rates.
    ///
    /// It takes one Newton correction. A step violates the constraints by no more than its error; about the square of
    /// that is left. Integrators call it after every step. `inputs` is evaluated once, only by chains that need
    /// inputs for the constraints. Open chains do nothing.
    ///
    /// # Errors
    /// The error of `inputs`, unchanged; `state` is then unchanged. [`Error::NotAssembled`] if a hinge other than a screw
    /// would rotate by more than half a rad, and [`Error::ClosureRank`] if directions that count as redundant are
    /// independent in this pose; `state` is then unspecified.
    #[doc(alias("close", "loop constraints", "constraint stabilization", "drift"))]
    fn project<E: From<Error>>(
        &self,
        state: &mut Self::State,
        inputs: impl FnOnce(&Self::State) -> Result<Self::Inputs, E>,
    ) -> Result<(), E> {
        let _ = (state, inputs);
        Ok(())
    }
}

/// The interface that all chains of `mstmm_chain!` share, for code that is generic over them.
///
/// Each generated type has methods of the same names, with their documentation.
///
/// # Orders
///
/// Coordinates [`q`](ChainState::coordinates), rates [`v`](ChainState::rates) and accelerations are in the order of the
/// routes, hinge by hinge. The floating base of a chain that is not held comes first. Hinges with a prescribed motion
/// have no entries. A repeated part is in the order of its repetitions: all hinges of the first repetition in the order
/// of its routes, then all hinges of the second one, and so on. So `repeat 2 { pin a -> Rod b -> slider c -> Rod d }` has
/// the rates a₀, c₀, a₁, c₁. The documentation of a state's type has a table of the indices of all hinges.
///
/// The connection points that `points()` of a workspace returns are in the order of the routes, too, repetition by
/// repetition in a repeated part. In a chain of one route they are the input of the first element, then the output of
/// every element, which is the input of the next one. In a tree each element adds its input, if no earlier element has
/// this point, and its output; the named points of a body that hinges leave follow its output. A hinge that leaves a
/// place together with other hinges, or the input of a body, has a separate input.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a chain of `mstmm_chain!`: the chain comes first, then the state",
    label = "expected a chain of `mstmm_chain!`"
)]
pub trait GeneratedChain: Chain {
    /// The results of [`solve_into`](Self::solve_into).
    type Workspace;

    /// Returns the state at the start that the description gives, at time zero.
    #[doc(alias("CreateDefaultContext", "mj_resetDataKeyframe", "keyframe"))]
    fn initial_state(&self) -> Self::State;

    /// Returns inputs that are all zero.
    fn no_inputs(&self) -> Self::Inputs;

    /// Returns an empty workspace for [`solve_into`](Self::solve_into).
    #[doc(alias("data", "mjData", "mj_makeData", "createData", "context"))]
    fn workspace(&self) -> Self::Workspace;

    /// Computes accelerations, efforts and the results that the chain's setting `results` lists, into `at`.
    ///
    /// Without the setting these are the energies and, at every connection point, pose, velocity and the state vector
    /// `z`.
    ///
    /// # Errors
    /// Those of [`Chain::derivative_into`], [`Chain::check_state`] and [`Chain::check_inputs`]. `at` is then an empty
    /// workspace, without the results of earlier calls. Energies, efforts, springs and values that are computed from
    /// results afterwards, such as the acceleration of a point, are not tested: they may overflow where a length or a rate
    /// exceeds 1e150, in `f32` 1e18.
    #[doc(alias("forward dynamics", "aba", "constraint forces", "mj_forward"))]
    #[doc(alias("constraintDynamics", "forwardDynamics", "mj_rnePostConstraint"))]
    fn solve_into(
        &self,
        state: &Self::State,
        inputs: &Self::Inputs,
        at: &mut Self::Workspace,
    ) -> Result<(), Error>;

    /// Assembles a closed chain: moves `state` to nearby coordinates and rates that satisfy the loop constraints.
    ///
    /// Prescribed motions are those of `inputs`. Open chains do nothing. Coordinates are found by Newton's method. Of
    /// all small motions that satisfy the linearised constraints, each correction is the one with the least kinetic
    /// energy. No hinge but a screw rotates by more than half a rad in one correction. Of all changes of the rates that
    /// satisfy the constraints of the velocities, the one with the least kinetic energy is taken.
    ///
    /// # Errors
    /// [`Error::NotAssembled`] if the corrections do not converge, [`Error::ClosureRank`] if the loop constraints have
    /// a higher rank at the result than around the start of the description, and those of [`Chain::check_state`] and
    /// [`Chain::check_inputs`]. `state` is then unchanged.
    #[doc(alias("inverse kinematics", "initial conditions"))]
    fn assemble(&self, state: &mut Self::State, inputs: &Self::Inputs) -> Result<(), Error> {
        self.check_state(state)?;
        self.check_inputs(inputs)
    }

    /// Returns kinetic and potential energy.
    #[doc(alias("mechanical energy"))]
    fn energy(&self, state: &Self::State) -> Energy<Self::Scalar>;
}
