//! Chains as problems for the solvers of `diffsol`. The chapter `tutorial::diffsol` of `mstmm` shows this file.
use mstmm::description::{Answer, Answers};
use mstmm::{ChainState, Described, Dual, Scalar};
use std::cell::RefCell;

/// Returns the time derivative of y = [q, v] with parameters `p`, in the order of the description. Without parameters
/// they are those of the chain. All entries are NaN if the chain returns an error: the solver then tries a shorter step.
fn derivative<C: Described + Clone>(
    chain: &C,
    y: impl Iterator<Item = C::Scalar>,
    p: impl Iterator<Item = C::Scalar>,
    time: C::Scalar,
) -> C::State {
    let mut rate = C::State::default();
    let derivative = with_parameters(chain, p)
        .and_then(|chain| chain.derivative_into(&state(y, time), &chain.no_inputs(), &mut rate));
    if derivative.is_err() {
        let nan = C::Scalar::constant(f64::NAN);
        rate.coordinates_mut().fill(nan);
        rate.rates_mut().fill(nan);
    }
    rate
}

fn with_parameters<C: Described + Clone>(
    chain: &C,
    p: impl Iterator<Item = C::Scalar>,
) -> Result<C, mstmm::Error> {
    let mut chain = chain.clone();
    p.enumerate().try_for_each(|(index, value)| chain.set_parameter(index, value))?;
    Ok(chain)
}

/// Returns the state with the coordinates and rates y = [q, v].
pub fn state<S: ChainState>(mut y: impl Iterator<Item = S::Scalar>, time: S::Scalar) -> S {
    let mut state = S::zero_position();
    state.coordinates_mut().iter_mut().zip(&mut y).for_each(|(place, value)| *place = value);
    state.rates_mut().iter_mut().zip(&mut y).for_each(|(place, value)| *place = value);
    state.set_time(time);
    state
}

fn values<S: ChainState>(state: &S) -> impl Iterator<Item = S::Scalar> {
    state.coordinates().iter().chain(state.rates()).copied()
}

fn write<T>(from: impl Iterator<Item = T>, to: &mut [T]) {
    to.iter_mut().zip(from).for_each(|(place, value)| *place = value);
}

fn along(values: &[f64], direction: &[f64]) -> impl Iterator<Item = Dual<f64>> {
    values.iter().zip(direction).map(|(&value, &slope)| Dual::new(value, [slope]))
}

fn fixed(values: &[f64]) -> impl Iterator<Item = Dual<f64>> {
    values.iter().map(|&value| Dual::from(value))
}

/// Returns the number of entries of y.
pub fn dimension<C: Described>(_: &C) -> usize {
    C::DESCRIPTION.coordinates().len() + C::DESCRIPTION.rates().len()
}

/// Computes dy/dt.
pub fn rhs<C: Described<Scalar = f64> + Clone>(
    chain: &C,
    (y, p, t): (&[f64], &[f64], f64),
    dy: &mut [f64],
) {
    write(values(&derivative(chain, y.iter().copied(), p.iter().copied(), t)), dy);
}

/// Computes the product of the Jacobian ∂(dy/dt)/∂y with a direction, by the chain of dual numbers.
pub fn jacobian<D: Described<Scalar = Dual<f64>> + Clone>(
    dual: &D,
    (y, p, t): (&[f64], &[f64], f64),
    direction: &[f64],
    product: &mut [f64],
) {
    let rate = derivative(dual, along(y, direction), fixed(p), Dual::from(t));
    write(values(&rate).map(|dual| dual.derivative()), product);
}

/// Computes the product of ∂(dy/dt)/∂p with a direction.
pub fn by_parameters<D: Described<Scalar = Dual<f64>> + Clone>(
    dual: &D,
    (y, p, t): (&[f64], &[f64], f64),
    direction: &[f64],
    product: &mut [f64],
) {
    let rate = derivative(dual, fixed(y), along(p, direction), Dual::from(t));
    write(values(&rate).map(|dual| dual.derivative()), product);
}

/// Computes the start of the description with these parameters.
pub fn start<C: Described<Scalar = f64> + Clone>(chain: &C, p: &[f64], y: &mut [f64]) {
    match with_parameters(chain, p.iter().copied()) {
        Ok(chain) => write(values(&chain.initial_state()), y),
        Err(_) => y.fill(f64::NAN),
    }
}

/// Computes the product of the derivative of the start by the parameters with a direction.
pub fn start_by_parameters<D: Described<Scalar = Dual<f64>> + Clone>(
    dual: &D,
    p: &[f64],
    direction: &[f64],
    product: &mut [f64],
) {
    match with_parameters(dual, along(p, direction)) {
        Ok(dual) => write(values(&dual.initial_state()).map(|dual| dual.derivative()), product),
        Err(_) => product.fill(f64::NAN),
    }
}

/// The Jacobian by the answer `linearize` of the chain, for chains whose rates are the derivatives of the coordinates.
///
/// A solver asks for a matrix column by column, so the linearisation of the last state is kept.
pub struct Linearized<C> {
    chain: C,
    last: RefCell<(Vec<f64>, Vec<f64>)>,
}

impl<C: Answers<Scalar = f64> + Clone> Linearized<C> {
    /// Makes the Jacobian of a chain. `None` if the chain does not have the answer, or has quaternions.
    pub fn new(chain: C) -> Option<Self> {
        let of = C::DESCRIPTION;
        let fits = C::has(Answer::Linearize) && of.coordinates().len() == of.rates().len();
        fits.then(|| Self { chain, last: RefCell::default() })
    }

    /// Computes the product of the Jacobian with a direction, as [`jacobian`].
    pub fn jacobian(
        &self,
        (y, p, t): (&[f64], &[f64], f64),
        direction: &[f64],
        product: &mut [f64],
    ) {
        let here: Vec<f64> = [y, p, &[t]].concat();
        let (last, matrices) = &mut *self.last.borrow_mut();
        if *last != here {
            *matrices = self.linearize(y, p, t).unwrap_or_default();
            *last = here;
        }
        let n = C::DESCRIPTION.rates().len();
        let (dq, dv) = direction.split_at(n);
        let (upper, lower) = product.split_at_mut(n);
        upper.copy_from_slice(dv);
        lower.fill(if matrices.is_empty() { f64::NAN } else { 0.0 });
        for (column, factor) in matrices.chunks(n).zip(dq.iter().chain(dv)) {
            lower.iter_mut().zip(column).for_each(|(sum, entry)| *sum += entry * factor);
        }
    }

    /// Returns the columns of ∂v̇/∂q and ∂v̇/∂v.
    fn linearize(&self, y: &[f64], p: &[f64], t: f64) -> Option<Vec<f64>> {
        let (of, answer) = (C::DESCRIPTION, Answer::Linearize);
        let chain = with_parameters(&self.chain, p.iter().copied()).ok()?;
        let mut all = vec![0.0; answer.len(of, C::DYNAMIC_PARAMETER_COUNT)];
        let state = state(y.iter().copied(), t);
        chain.answer(answer, &state, &chain.no_inputs(), &[], &mut all)?.ok()?;
        // The parts follow each other: v̇, the inverse of the mass matrix, ∂v̇/∂q, ∂v̇/∂v and others.
        let n = of.rates().len();
        all.get(n + n * n..n + 3 * n * n).map(Vec::from)
    }
}
