//! The linearised accelerations of a chain, and the discrete model of a step with held inputs.
//!
//! # Notation
//!
//! δ is a small motion of the coordinates *along the rates*: dq = N(q) δ, where q̇ = N(q) v. So δ has as many entries as
//! the rates v, also where an orientation is a quaternion: for a ball δ is a small rotation in outboard axes. x = (δ, dv)
//! is a deviation of the state, u a deviation of the inputs.

use super::Columns;
use super::product::add_product;
use crate::integrate::combine::sum_scaled;
use crate::origin::Origin;
use crate::{Chain, ChainState, Error, Mask, Scalar};
use nalgebra::{SMatrix, SVector};

/// A chain with `N` rates and `U` inputs whose accelerations have derivatives.
///
/// A generated chain implements it if its description has `answers = linearize;`. Closed chains do not: their rates are
/// not independent.
#[diagnostic::on_unimplemented(
    message = "the chain `{Self}` has no linearisation",
    label = "needs `answers = linearize;` and an open chain",
    note = "add `answers = linearize;` to the chain, or the word to its list: `answers = […, linearize];`",
    note = "closed chains do not have it, since their rates are not independent"
)]
pub trait Linearize<const N: usize, const U: usize>: Chain {
    /// Computes accelerations and their derivatives at a state.
    ///
    /// As for [`Chain::derivative_into`], quaternions of any length near one are used unchanged.
    ///
    /// # Errors
    /// Those of [`Chain::derivative_into`]. `at` is unspecified after an error.
    fn linearize_into(
        &self,
        state: &Self::State,
        inputs: &Self::Inputs,
        at: &mut ContinuousModel<Self::Scalar, N, U>,
    ) -> Result<(), Error>;
}

/// The linear model in continuous time of a chain with `N` rates and `U` inputs, from which [`discretize`] makes a
/// [`DiscreteModel`].
///
/// It has what [`Linearization`](crate::Linearization) has, without M⁻¹ and the derivatives with respect to parameters.
///
/// The model is δ̇ = `tangent_rate` δ + dv, dv̇ = `by_coordinates` δ + `by_rates` dv +
/// `by_inputs` u. δ is a small motion of the coordinates along the rates, dq = N(q) δ with the N(q) of q̇ = N(q) v. For a
/// pin it is a small angle, for a ball a small rotation in outboard axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContinuousModel<T, const N: usize, const U: usize> {
    /// v̇.
    pub accelerations: SVector<T, N>,
    /// ∂v̇/∂q along the rates, in rad/s² or m/s² per rad or m.
    #[doc(alias("stiffness", "ddq_dq"))]
    pub by_coordinates: SMatrix<T, N, N>,
    /// ∂v̇/∂v.
    #[doc(alias("ddq_dv"))]
    pub by_rates: SMatrix<T, N, N>,
    /// ∂v̇/∂u; for efforts these are columns of the inverse mass matrix.
    #[doc(alias("ddq_dtau"))]
    pub by_inputs: SMatrix<T, N, U>,
    /// ∂δ̇/∂δ: −\[ω\]× for each quaternion, whose axes rotate with ω, and zero for all coordinates with q̇ = v.
    pub tangent_rate: SMatrix<T, N, N>,
}

impl<T: Scalar, const N: usize, const U: usize> ContinuousModel<T, N, U> {
    /// Returns A of ẋ = A x + B u with x = (δ, dv). `X` is 2 N; otherwise the program does not compile.
    #[doc(alias("state matrix", "system matrix"))]
    pub fn a<const X: usize>(&self) -> SMatrix<T, X, X> {
        let mut unit = zeros();
        set_unit(&mut unit);
        stacked(
            [&self.tangent_rate.data.0, &unit],
            [&self.by_coordinates.data.0, &self.by_rates.data.0],
        )
    }

    /// Returns B of ẋ = A x + B u with x = (δ, dv). `X` is 2 N; otherwise the program does not compile.
    #[doc(alias("input matrix"))]
    pub fn b<const X: usize>(&self) -> SMatrix<T, X, U> {
        stacked_inputs(&zeros(), &self.by_inputs.data.0)
    }
}

impl<T: Scalar, const N: usize, const U: usize> Default for ContinuousModel<T, N, U> {
    fn default() -> Self {
        Self {
            accelerations: [[T::constant(0.0); N]].into(),
            by_coordinates: zeros().into(),
            by_rates: zeros().into(),
            by_inputs: zeros().into(),
            tangent_rate: zeros().into(),
        }
    }
}

/// The derivatives of a vector at the end of a step by coordinates (along the rates) and rates at its start, and by the
/// held inputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivity<T, const N: usize, const U: usize> {
    /// By the coordinates at the start, along the rates there.
    pub by_coordinates: SMatrix<T, N, N>,
    /// By the rates at the start.
    pub by_rates: SMatrix<T, N, N>,
    /// By the inputs.
    pub by_inputs: SMatrix<T, N, U>,
}

impl<T: Scalar, const N: usize, const U: usize> Sensitivity<T, N, U> {
    fn zero() -> Self {
        Self { by_coordinates: zeros().into(), by_rates: zeros().into(), by_inputs: zeros().into() }
    }

    /// Adds left · right.
    fn add_product(&mut self, left: &Columns<T, N, N>, right: &Self) {
        add_product(&mut self.by_coordinates.data.0, left, &right.by_coordinates.data.0);
        add_product(&mut self.by_rates.data.0, left, &right.by_rates.data.0);
        add_product(&mut self.by_inputs.data.0, left, &right.by_inputs.data.0);
    }

    /// Adds factor · right.
    fn add_scaled(&mut self, factor: T, right: &Self) {
        fn add<T: Scalar, const N: usize, const M: usize>(
            to: &mut SMatrix<T, N, M>,
            factor: T,
            from: &SMatrix<T, N, M>,
        ) {
            let both = to.data.0.as_flattened_mut().iter_mut().zip(from.data.0.as_flattened());
            both.for_each(|(to, &from)| *to = factor.mul_add(from, *to));
        }
        add(&mut self.by_coordinates, factor, &right.by_coordinates);
        add(&mut self.by_rates, factor, &right.by_rates);
        add(&mut self.by_inputs, factor, &right.by_inputs);
    }
}

/// The discrete model of a step with held inputs: x⁺ = A x + B u for deviations x = (δ, dv) of the state.
///
/// δ at the start is a small motion along the rates of the state at the start, δ at the end one along the rates of the
/// state at the end of the step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias(
    "discrete-time model",
    "c2d",
    "EKF",
    "extended Kalman filter",
    "MPC",
    "iLQR",
    "DDP",
    "transition matrix",
    "zero-order hold",
    "mjd_transitionFD"
))]
pub struct DiscreteModel<T, const N: usize, const U: usize> {
    /// The derivatives of the coordinates at the end, along the rates there: the upper N rows of A and B.
    pub coordinates: Sensitivity<T, N, U>,
    /// The derivatives of the rates at the end: the lower N rows of A and B.
    pub rates: Sensitivity<T, N, U>,
}

impl<T: Scalar, const N: usize, const U: usize> DiscreteModel<T, N, U> {
    /// Returns A of x⁺ = A x + B u. `X` is 2 N; otherwise the program does not compile.
    ///
    /// The type of the result gives `X`, as in `let a: SMatrix<f64, 4, 4> = model.a();` for a chain with two rates, and so
    /// does an argument of [`lqr`](super::lqr).
    #[doc(alias("Ad", "state transition matrix"))]
    pub fn a<const X: usize>(&self) -> SMatrix<T, X, X> {
        let Self { coordinates, rates } = self;
        stacked(
            [&coordinates.by_coordinates.data.0, &coordinates.by_rates.data.0],
            [&rates.by_coordinates.data.0, &rates.by_rates.data.0],
        )
    }

    /// Returns B of x⁺ = A x + B u. `X` is 2 N; otherwise the program does not compile. See [`a`](Self::a).
    #[doc(alias("Bd"))]
    pub fn b<const X: usize>(&self) -> SMatrix<T, X, U> {
        stacked_inputs(&self.coordinates.by_inputs.data.0, &self.rates.by_inputs.data.0)
    }

    fn zero() -> Self {
        Self { coordinates: Sensitivity::zero(), rates: Sensitivity::zero() }
    }

    /// The deviations at the start of a step.
    fn unit() -> Self {
        let mut model = Self::zero();
        set_unit(&mut model.coordinates.by_coordinates.data.0);
        set_unit(&mut model.rates.by_rates.data.0);
        model
    }

    /// Adds factor · other.
    fn add_scaled(&mut self, factor: T, other: &Self) {
        self.coordinates.add_scaled(factor, &other.coordinates);
        self.rates.add_scaled(factor, &other.rates);
    }

    fn is_finite(&self) -> bool {
        let Self { coordinates, rates } = self;
        let finite = |part: &Sensitivity<T, N, U>| {
            let all = part.by_coordinates.iter().chain(&part.by_rates).chain(&part.by_inputs);
            all.fold(Mask::splat(true), |all: T::Mask, entry| all & entry.is_finite()).all()
        };
        finite(coordinates) && finite(rates)
    }

    /// Returns the time derivative of the deviations of this model: δ̇ and dv̇ at a stage.
    fn rate(&self, at: &ContinuousModel<T, N, U>) -> Self {
        let mut rate = Self { coordinates: self.rates, rates: Sensitivity::zero() };
        // Without quaternions and elastic hinges this is zero.
        let zero = T::constant(0.0);
        if at.tangent_rate.data.0.as_flattened().iter().any(|&entry| entry != zero) {
            rate.coordinates.add_product(&at.tangent_rate.data.0, &self.coordinates);
        }
        rate.rates.by_inputs = at.by_inputs;
        rate.rates.add_product(&at.by_coordinates.data.0, &self.coordinates);
        rate.rates.add_product(&at.by_rates.data.0, &self.rates);
        rate
    }
}

/// Computes the discrete model of one step of [`Rk4`](crate::Rk4) of `step` seconds from `state`, with held inputs.
///
/// The step is that of [`Rk4::step_held`](crate::Rk4::step_held), and the model is computed by the chain rule through
/// its four stages: the same method integrates δ̇ and dv̇ of all deviations along with the state. There are four calls
/// of [`Linearize::linearize_into`].
///
/// If q̇ = v for all coordinates, A and B are the derivatives of the result of the step, exact up to rounding. For
/// quaternions and elastic hinges they are those of the motion up to h⁵, the error of the step itself; the derivatives
/// of the numerical result follow from a chain of [dual numbers](crate::Dual).
///
/// At an equilibrium x is the deviation from it. Along a trajectory x is the deviation from the trajectory at each step.
///
/// # Errors
/// Those of [`Chain::check_state`], [`Chain::check_inputs`] and [`Linearize::linearize_into`], and
/// [`Error::NotFinite`] if an entry of the model is not finite.
#[doc(alias("mjd_transitionFD", "DiscreteTimeApproximation", "c2d", "discretisation"))]
pub fn discretize<C: Linearize<N, U>, const N: usize, const U: usize>(
    chain: &C,
    state: &C::State,
    inputs: &C::Inputs,
    step: C::Scalar,
) -> Result<DiscreteModel<C::Scalar, N, U>, Error> {
    chain.check_state(state)?;
    chain.check_inputs(inputs)?;
    let half = step * C::Scalar::constant(0.5);
    let (one, two) = (C::Scalar::constant(1.0), C::Scalar::constant(2.0));
    let start = state.time();

    let unit = DiscreteModel::unit();
    let (mut model, mut sum) = (unit, DiscreteModel::zero());
    let (mut stage, mut rate) = (state.clone(), C::State::zero_position());
    let mut at = ContinuousModel::default();
    // As in `Rk4`: for each stage its time, its weight in the mean of the rates in sixths, and the factor of its rate in
    // the next stage.
    for (time, weight, onward) in [
        (start, one, Some(half)),
        (start + half, two, Some(half)),
        (start + half, two, Some(step)),
        (start + step, one, None),
    ] {
        stage.set_time(time);
        chain.linearize_into(&stage, inputs, &mut at)?;
        let change = model.rate(&at);
        sum.add_scaled(weight, &change);
        if let Some(onward) = onward {
            model = unit;
            model.add_scaled(onward, &change);
            chain.configuration_rate_into(&stage, &mut rate);
            let accelerations = at.accelerations.data.0.as_flattened();
            rate.rates_mut().iter_mut().zip(accelerations).for_each(|(to, &from)| *to = from);
            sum_scaled(&mut stage, state, onward, &rate);
        }
    }
    model = unit;
    model.add_scaled(step * C::Scalar::constant(1.0 / 6.0), &sum);
    if model.is_finite() { Ok(model) } else { Err(Error::NotFinite(Origin::Result)) }
}

fn zeros<T: Scalar, const R: usize, const C: usize>() -> Columns<T, R, C> {
    [[T::constant(0.0); R]; C]
}

/// Makes the diagonal of a matrix of zeros one.
fn set_unit<T: Scalar, const N: usize>(matrix: &mut Columns<T, N, N>) {
    for (index, column) in matrix.iter_mut().enumerate() {
        column.iter_mut().skip(index).take(1).for_each(|entry| *entry = T::constant(1.0));
    }
}

/// Returns the matrix of four blocks, each row from left to right.
fn stacked<T: Scalar, const N: usize, const X: usize>(
    upper: [&Columns<T, N, N>; 2],
    lower: [&Columns<T, N, N>; 2],
) -> SMatrix<T, X, X> {
    const { assert!(X == 2 * N, "the number of states is twice the number of rates") };
    let mut matrix = zeros();
    let upper = upper.into_iter().flatten();
    let lower = lower.into_iter().flatten();
    for (column, (upper, lower)) in matrix.iter_mut().zip(upper.zip(lower)) {
        fill(column, upper, lower);
    }
    matrix.into()
}

/// Returns the matrix of two blocks, one below the other.
fn stacked_inputs<T: Scalar, const N: usize, const U: usize, const X: usize>(
    upper: &Columns<T, N, U>,
    lower: &Columns<T, N, U>,
) -> SMatrix<T, X, U> {
    const { assert!(X == 2 * N, "the number of states is twice the number of rates") };
    let mut matrix = zeros();
    for (column, (upper, lower)) in matrix.iter_mut().zip(upper.iter().zip(lower)) {
        fill(column, upper, lower);
    }
    matrix.into()
}

fn fill<T: Scalar>(column: &mut [T], upper: &[T], lower: &[T]) {
    column.iter_mut().zip(upper.iter().chain(lower)).for_each(|(to, &from)| *to = from);
}
