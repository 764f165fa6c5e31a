//! What an integrator needs to know of a chain.

use crate::{Energy, Error, Scalar};

/// The state of a simulation: coordinates, rates and time.
///
/// The coordinates of all hinges are in one slice, their rates in another, hinge by hinge in the same order; the
/// order of generated chains is documented at [`GeneratedChain`]. There are fewer rates than coordinates if an
/// orientation is a quaternion. All states of one chain have slices of the same lengths.
///
/// The state of a generated chain has the same values in its public fields `q`, `v` and `t`, as vectors of a fixed
/// length. The methods of this trait are for code that is generic over the chain.
pub trait ChainState: Clone {
    /// The scalar type of the state.
    type Scalar: Scalar;

    /// Returns the coordinates: rad, m, and the components w, x, y, z of unit quaternions.
    #[doc(alias("q", "qpos", "configuration", "positions", "generalized coordinates", "nq"))]
    fn coordinates(&self) -> &[Self::Scalar];

    /// Returns the coordinates, to be changed.
    fn coordinates_mut(&mut self) -> &mut [Self::Scalar];

    /// Returns the rates: rad/s and m/s.
    #[doc(alias("v", "qvel", "generalized velocities", "nv", "degrees of freedom"))]
    fn rates(&self) -> &[Self::Scalar];

    /// Returns the rates, to be changed.
    fn rates_mut(&mut self) -> &mut [Self::Scalar];

    /// Returns the time in s.
    fn time(&self) -> Self::Scalar;

    /// Sets the time in s.
    fn set_time(&mut self, time: Self::Scalar);
}

/// A mechanical system that can be integrated in time.
///
/// `mstmm_chain!` implements it for the chains it generates.
pub trait Chain {
    /// The numbers the chain is computed with.
    type Scalar: Scalar;

    /// The state of the chain. Integrators fill their buffers with default states, whose values do
    /// not matter.
    type State: ChainState<Scalar = Self::Scalar> + Default;

    /// What acts on the chain from outside during a step: torques, forces, prescribed motions.
    type Inputs;

    /// The time derivative of `state`: afterwards `rate.coordinates()` is q̇ and `rate.rates()` is v̇. The time
    /// of `rate` means nothing.
    ///
    /// The quaternions of `state` may have any length near one, as those of an integrator's stages
    /// have. They are used unchanged and are not checked: for a quaternion of length n whose
    /// rotation matrix is R, the matrix (1 − n²) 1 + n² R is used instead of R, which is R up to
    /// terms of the order of n² − 1, and q̇ is n times that of the unit quaternion. A state or
    /// inputs that come from outside are checked by [`check_state`](Chain::check_state) and
    /// [`check_inputs`](Chain::check_inputs).
    ///
    /// # Errors
    /// [`Error::NotFinite`] if the state or the inputs are not finite, [`Error::Singular`] if no
    /// inertia is left beyond a hinge. `rate` means nothing then.
    fn derivative_into(
        &self,
        state: &Self::State,
        inputs: &Self::Inputs,
        rate: &mut Self::State,
    ) -> Result<(), Error>;

    /// The rate of a linearly implicit step of Euler's method of `step` seconds: afterwards
    /// `rate.rates()` is the v̇ of (M + h C + h² K) v̇ = τ − h K v, where M v̇ = τ are the equations of
    /// motion, h is the step, and K and C are stiffness and damping of the springs, dampers,
    /// friction and limits in hinges: −∂τ/∂q ∂q̇/∂v and −∂τ/∂v of those alone, where strains are
    /// coordinates. Of the strains s of elastic hinges, and of the turns of balls and floating hinges,
    /// K is Jᵀ k J and C is Jᵀ c J with ṡ = J v: what is left out vanishes at rest. `rate.coordinates()` is q̇
    /// of `state`.
    ///
    /// With K and C zero it is [`derivative_into`](Chain::derivative_into), which is the default.
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

    /// The rates of the coordinates alone, which follow from coordinates and rates without any
    /// dynamics: afterwards `rate.coordinates()` is q̇, and all else in `rate` is as it was.
    ///
    /// It is linear in the rates. What is not finite gives what is not finite.
    fn configuration_rate_into(&self, state: &Self::State, rate: &mut Self::State);

    /// Checks what a state that comes from outside must fulfil beyond finite numbers: the length of
    /// each quaternion is between 0.9 and 1.1. A quaternion that is not finite passes; it gives
    /// [`Error::NotFinite`] where it is used. Of lanes all must pass.
    ///
    /// Accelerations are those of the rotation up to terms of the order of n² − 1 for a length n, see
    /// [`derivative_into`](Chain::derivative_into). For a state whose quaternions are further from
    /// unit length than rounding, call [`normalize`](Chain::normalize) first.
    ///
    /// Integrators check the state that they are given once in a call of `step` or `advance_to`. The
    /// default checks nothing.
    ///
    /// # Errors
    /// [`Error::InvalidQuaternion`].
    fn check_state(&self, state: &Self::State) -> Result<(), Error> {
        let _ = state;
        Ok(())
    }

    /// Checks the quaternions of prescribed motions in the same way as
    /// [`check_state`](Chain::check_state).
    ///
    /// Integrators check all inputs that they ask for. The default checks nothing.
    ///
    /// # Errors
    /// [`Error::InvalidQuaternion`].
    fn check_inputs(&self, inputs: &Self::Inputs) -> Result<(), Error> {
        let _ = inputs;
        Ok(())
    }

    /// Brings quaternions back to unit length, from which a step moves them by no more than its
    /// error.
    fn normalize(&self, state: &mut Self::State);

    /// Brings a chain that is held at both ends back onto its closure, in positions and in
    /// velocities, by one correction: a step moves it off by no more than its error, of which about
    /// the square is left. Integrators ask for it after every step; `inputs` are asked at its end,
    /// by chains that need them. Other chains are closed always.
    ///
    /// # Errors
    /// That of `inputs`, unchanged; `state` is left as it was. [`Error::ClosureRank`] if directions that
    /// count as redundant are independent in this pose; `state` is then unspecified.
    fn project<E: From<Error>>(
        &self,
        state: &mut Self::State,
        inputs: impl FnOnce(&Self::State) -> Result<Self::Inputs, E>,
    ) -> Result<(), E> {
        let _ = (state, inputs);
        Ok(())
    }
}

/// A chain made by `mstmm_chain!`: what every one of them can do, for code that works with any.
///
/// The methods are those of the generated type itself, which documents them.
///
/// # Orders
///
/// Coordinates [`q`](ChainState::coordinates), rates [`v`](ChainState::rates) and accelerations lie hinge by hinge
/// in the order of the route. The body of a chain that floats comes first, and hinges whose motion is
/// prescribed have no place. A repeated part lies repetition by repetition: all its hinges in the order
/// of the route for the first repetition, then all of them for the second, and so on. So `repeat 2 { pin
/// a -> Rod b -> slider c -> Rod d }` has the rates a₀, c₀, a₁, c₁. The documentation of a state's type
/// has a table with the places of all its hinges.
///
/// The connection points that a workspace's `points()` returns are in the order of the route, too: the
/// input of the first element, then the output of every element, repetition by repetition where a part
/// is repeated. The input of an element is the output of the one before it.
pub trait GeneratedChain: Chain {
    /// Where results are written.
    type Workspace;

    /// The state that the description starts from, at time zero.
    fn initial_state(&self) -> Self::State;

    /// Inputs that are all zero.
    fn no_inputs(&self) -> Self::Inputs;

    /// Room for the results of [`solve_into`](Self::solve_into).
    fn workspace(&self) -> Self::Workspace;

    /// Accelerations, efforts and what the chain's setting `results` asks for, written into `at`: without the setting
    /// energies and, at every connection point, pose, velocity and the state vector `z`.
    ///
    /// # Errors
    /// As [`Chain::derivative_into`], and those of [`Chain::check_state`] and
    /// [`Chain::check_inputs`]; `at` is then as [`workspace`](Self::workspace) makes it: results of earlier calls
    /// are gone.
    fn solve_into(
        &self,
        state: &Self::State,
        inputs: &Self::Inputs,
        at: &mut Self::Workspace,
    ) -> Result<(), Error>;

    /// Closes a chain that is held at both ends: moves `state` to coordinates and rates nearby that
    /// fulfil the closure, with prescribed motions as `inputs` say. Other chains are closed always.
    ///
    /// Coordinates are found by Newton's method. Of all small motions that close the gap to first
    /// order, each correction is the one with the least kinetic energy, and so is each change of the
    /// rates among those that make both sides of the closing hinge move alike.
    ///
    /// # Errors
    /// [`Error::NotAssembled`] if the corrections do not converge, [`Error::ClosureRank`] if they lead to a
    /// pose in which the closure has a higher rank than was found, and those of
    /// [`Chain::check_state`] and [`Chain::check_inputs`]; `state` is left as it was.
    fn assemble(&self, state: &mut Self::State, inputs: &Self::Inputs) -> Result<(), Error> {
        self.check_state(state)?;
        self.check_inputs(inputs)
    }

    /// Kinetic and potential energy.
    fn energy(&self, state: &Self::State) -> Energy<Self::Scalar>;
}
