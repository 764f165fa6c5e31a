//! Derivatives of integrations by the classical Runge-Kutta method, with inputs that are held over a step.
//!
//! Derivatives are along the rates: those of the computed steps and, for chains with quaternions, those of the linear
//! equation of small displacements, integrated by the same method. A quaternion q has three rates ω, in outboard axes: its
//! derivative is q (0, ω) / 2, and a displacement d of it changes by −ω × d due to its own rate.

use mstmm::description::{Answer, Answers, Description, QuantityKind};
use mstmm::{ChainState, Error, Rk4, Scalar};

use crate::blocks::Stop;

/// The shares of the stages in a step `x' = x + h (k1 + 2 k2 + 2 k3 + k4) / 6`.
const SHARES: [f64; 4] = [1.0 / 6.0, 2.0 / 6.0, 2.0 / 6.0, 1.0 / 6.0];
/// The factors of a stage's rate in the next one, in steps.
const FACTORS: [f64; 3] = [0.5, 0.5, 1.0];

/// The steps of an integration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steps {
    /// The step in s.
    pub step: f64,
    /// The number of steps.
    pub count: usize,
}

/// The states of a chain and their displacements: along the rates, then of the rates.
struct Space {
    coordinates: usize,
    rates: usize,
    /// The first entries of quaternions among the coordinates and among the rates.
    quaternions: Vec<[usize; 2]>,
    /// The entries of the other coordinates.
    plain: Vec<[usize; 2]>,
}

impl Space {
    fn of(of: &Description) -> Self {
        let (mut quaternions, mut plain) = (Vec::new(), Vec::new());
        let (mut coordinate, mut rate) = (0, 0);
        while let Some(quantity) = of.coordinates().get(coordinate) {
            if quantity.kind == QuantityKind::Quaternion {
                quaternions.push([coordinate, rate]);
                (coordinate, rate) = (coordinate + 4, rate + 3);
            } else {
                plain.push([coordinate, rate]);
                (coordinate, rate) = (coordinate + 1, rate + 1);
            }
        }
        Space { coordinates: of.coordinates().len(), rates: of.rates().len(), quaternions, plain }
    }

    /// Computes the changes of the coordinates, to first order, of displacements along the rates.
    fn along<T: Scalar>(&self, coordinates: &[T], displacement: &[T], change: &mut [T]) {
        for &[q, v] in &self.plain {
            change[q] = displacement[v];
        }
        for &[q, v] in &self.quaternions {
            for (row, to) in columns(&coordinates[q..q + 4]).iter().zip(&mut change[q..q + 4]) {
                *to = dot(row, &displacement[v..v + 3]);
            }
        }
    }

    /// Computes the products of weights of the coordinates with `along`: weights of displacements.
    fn against<T: Scalar>(&self, coordinates: &[T], weights: &[T], result: &mut [T]) {
        for &[q, v] in &self.plain {
            result[v] = weights[q];
        }
        for &[q, v] in &self.quaternions {
            let rows = columns(&coordinates[q..q + 4]);
            for (column, to) in result[v..v + 3].iter_mut().enumerate() {
                *to = dot(&rows.map(|row| row[column]), &weights[q..q + 4]);
            }
        }
    }

    /// Adds `sign` ω × d for each displacement d of a quaternion.
    fn turn<T: Scalar>(&self, rates: &[T], displacement: &[T], sign: f64, result: &mut [T]) {
        for &[_, v] in &self.quaternions {
            for k in 0..3 {
                let [a, b] = [v + (k + 1) % 3, v + (k + 2) % 3];
                let product = rates[a] * displacement[b] - rates[b] * displacement[a];
                result[v + k] += T::constant(sign) * product;
            }
        }
    }

    /// Sets quaternions to unit length.
    fn normalize<T: Scalar>(&self, coordinates: &mut [T]) {
        for &[q, _] in &self.quaternions {
            let quaternion = &mut coordinates[q..q + 4];
            let inverse = dot(quaternion, quaternion).sqrt().recip();
            quaternion.iter_mut().for_each(|entry| *entry *= inverse);
        }
    }
}

/// Returns the rows of the matrix N of the derivative N ω of a quaternion w, x, y, z.
fn columns<T: Scalar>(quaternion: &[T]) -> [[T; 3]; 4] {
    let half = T::constant(0.5);
    let [w, x, y, z] = [0, 1, 2, 3].map(|k| half * quaternion[k]);
    [[-x, -y, -z], [w, -z, y], [z, w, -x], [-y, x, w]]
}

fn dot<T: Scalar>(a: &[T], b: &[T]) -> T {
    a.iter().zip(b).fold(T::constant(0.0), |sum, (a, b)| sum + *a * *b)
}

/// Returns a state from coordinates and rates, one after the other.
fn state_of<S: ChainState>(values: &[S::Scalar]) -> S {
    let mut state = S::zero_position();
    let count = state.coordinates().len();
    state.coordinates_mut().copy_from_slice(&values[..count]);
    state.rates_mut().copy_from_slice(&values[count..]);
    state
}

/// Returns the states of the four stages of a step.
fn stages<C: Answers>(
    chain: &C,
    space: &Space,
    start: C::State,
    inputs: &C::Inputs,
    step: f64,
) -> Result<[C::State; 4], Error>
where
    C::State: Clone,
{
    let mut all = [start.clone(), start.clone(), start.clone(), start];
    let mut rate = C::State::zero_position();
    for (stage, factor) in FACTORS.into_iter().enumerate() {
        chain.derivative_into(&all[stage], inputs, &mut rate)?;
        let factor = C::Scalar::constant(step * factor);
        let next = &mut all[stage + 1];
        for (to, change) in next.coordinates_mut().iter_mut().zip(rate.coordinates()) {
            *to += factor * *change;
        }
        for (to, change) in next.rates_mut().iter_mut().zip(rate.rates()) {
            *to += factor * *change;
        }
        space.normalize(next.coordinates_mut());
    }
    Ok(all)
}

/// The gradients of a step, with the memory for one call of `pull`.
struct Reverse<'a, C: Answers> {
    chain: &'a C,
    space: Space,
    step: f64,
    pulled: Vec<C::Scalar>,
}

impl<C: Answers> Reverse<'_, C>
where
    C::State: Clone,
{
    /// Returns the gradient by the start of a step from that by its end. The gradients by inputs and parameters are added to
    /// `sums`.
    fn step(
        &mut self,
        start: &[C::Scalar],
        inputs: &C::Inputs,
        gradient: &[C::Scalar],
        [by_inputs, by_parameters]: [&mut [C::Scalar]; 2],
    ) -> Result<Vec<C::Scalar>, Error> {
        let start: C::State = state_of(start);
        self.chain.check_state(&start)?;
        self.chain.check_inputs(inputs)?;
        let stages = stages(self.chain, &self.space, start, inputs, self.step)?;
        let mut total = gradient.to_vec();
        let mut later: Option<Vec<C::Scalar>> = None;
        for stage in (0..4).rev() {
            let share = C::Scalar::constant(self.step * SHARES[stage]);
            let mut weights: Vec<_> = gradient.iter().map(|entry| share * *entry).collect();
            if let Some(later) = later {
                let factor = C::Scalar::constant(self.step * FACTORS[stage]);
                let pairs = weights.iter_mut().zip(later);
                pairs.for_each(|(to, value)| *to += factor * value);
            }
            let sums = [&mut *by_inputs, &mut *by_parameters];
            let by_state = self.pull((&stages[stage], inputs), &weights, sums)?;
            total.iter_mut().zip(&by_state).for_each(|(to, value)| *to += *value);
            later = Some(by_state);
        }
        Ok(total)
    }

    /// Returns the product of weights with the derivatives of the rates of displacements by displacements. Those by inputs
    /// and parameters are added to `inputs` and `parameters`.
    fn pull(
        &mut self,
        (state, at): (&C::State, &C::Inputs),
        weights: &[C::Scalar],
        [inputs, parameters]: [&mut [C::Scalar]; 2],
    ) -> Result<Vec<C::Scalar>, Error> {
        let rates = self.space.rates;
        let (of_coordinates, of_rates) = weights.split_at(rates);
        // The lengths are those of the description.
        let answer = self.chain.answer(Answer::Pull, state, at, of_rates, &mut self.pulled);
        answer.unwrap_or(Ok(()))?;
        let mut parts = self.pulled[rates..].split_at(2 * rates);
        let mut result = parts.0.to_vec();
        self.space.turn(state.rates(), of_coordinates, 1.0, &mut result[..rates]);
        for (to, weight) in result[rates..].iter_mut().zip(of_coordinates) {
            *to += *weight;
        }
        for sums in [inputs, parameters] {
            let (own, rest) = parts.1.split_at(sums.len());
            sums.iter_mut().zip(own).for_each(|(to, value)| *to += *value);
            parts.1 = rest;
        }
        Ok(result)
    }
}

/// Computes the gradients of the sum of weights times the states of a trajectory.
///
/// `given` has the trajectory, then as many weights. `result` becomes the gradients by the start, by the inputs of each
/// step and by the parameters.
pub fn pullback<C: Answers>(
    chain: &C,
    Steps { step, count }: Steps,
    mut inputs: impl FnMut(usize) -> C::Inputs,
    given: &[C::Scalar],
    result: &mut [C::Scalar],
) -> Result<(), Stop>
where
    C::State: Clone,
{
    let of = C::DESCRIPTION;
    let space = Space::of(of);
    let (nq, nv, columns) = (space.coordinates, space.rates, of.inputs().len());
    let (trajectory, weights) = given.split_at(given.len() / 2);
    // A chain without degrees of freedom has empty states.
    let len = (nq + nv).max(1);
    let [trajectory, weights] = [trajectory, weights].map(|all| all.chunks_exact(len));
    let zero = C::Scalar::constant(0.0);
    result.fill(zero);
    let (by_start, rest) = result.split_at_mut(nq + nv);
    let (by_inputs, by_parameters) = rest.split_at_mut(count * columns);
    let pulled = vec![zero; Answer::Pull.len(of, 0)];
    let mut reverse = Reverse { chain, space, step, pulled };
    let (mut gradient, mut along) = (vec![zero; 2 * nv], vec![zero; nv]);
    for (k, (x, own)) in trajectory.zip(weights).enumerate().rev() {
        if k < count {
            let by_inputs = &mut by_inputs[k * columns..(k + 1) * columns];
            gradient = reverse
                .step(x, &inputs(k), &gradient, [by_inputs, by_parameters])
                .map_err(|error| Stop { step: Some(k), error })?;
        }
        reverse.space.against(&x[..nq], &own[..nq], &mut along);
        let own = along.iter().chain(&own[nq..]);
        gradient.iter_mut().zip(own).for_each(|(to, value)| *to += *value);
    }
    // The gradient by states: that by a quaternion is orthogonal to it, and N has orthogonal columns of length 1/2.
    let space = &reverse.space;
    space.along(&given[..nq], &gradient[..nv], &mut by_start[..nq]);
    for &[q, _] in &space.quaternions {
        let four = C::Scalar::constant(4.0);
        by_start[q..q + 4].iter_mut().for_each(|entry| *entry *= four);
    }
    by_start[nq..].copy_from_slice(&gradient[nv..]);
    Ok(())
}

/// Computes the change of a trajectory along a displacement of its start and a change of the parameters.
///
/// `given` has the displacement along the rates, that of the rates, and the change of the parameters. `result` becomes the
/// change of each state.
pub fn pushforward<C: Answers>(
    chain: &C,
    Steps { step, count }: Steps,
    mut inputs: impl FnMut(usize) -> C::Inputs,
    mut state: C::State,
    (given, result): (&[C::Scalar], &mut [C::Scalar]),
) -> Result<(), Stop>
where
    C::State: Clone,
{
    let of = C::DESCRIPTION;
    let space = Space::of(of);
    let (nq, nv) = (space.coordinates, space.rates);
    let zero = C::Scalar::constant(0.0);
    let (start, parameters) = given.split_at(2 * nv);
    let mut displacement = start.to_vec();
    let mut pushed = vec![zero; Answer::Push.len(of, 0)];
    let mut rk4 = Rk4::new(C::Scalar::constant(step));
    for (k, change) in result.chunks_exact_mut((nq + nv).max(1)).enumerate() {
        space.along(state.coordinates(), &displacement[..nv], &mut change[..nq]);
        change[nq..].copy_from_slice(&displacement[nv..]);
        if k == count {
            break;
        }
        let stop = |error| Stop { step: Some(k), error };
        let at = inputs(k);
        chain.check_state(&state).map_err(stop)?;
        chain.check_inputs(&at).map_err(stop)?;
        let stages = stages(chain, &space, state.clone(), &at, step).map_err(stop)?;
        let (mut moved, mut total) = (displacement.clone(), displacement.clone());
        for (number, stage) in stages.iter().enumerate() {
            // The direction is along coordinates, rates, inputs and parameters.
            let mut direction = moved.clone();
            direction.resize(2 * nv + of.inputs().len(), zero);
            direction.extend_from_slice(parameters);
            let answer = chain.answer(Answer::Push, stage, &at, &direction, &mut pushed);
            answer.unwrap_or(Ok(())).map_err(stop)?;
            let mut rate = moved[nv..].to_vec();
            space.turn(stage.rates(), &moved[..nv], -1.0, &mut rate);
            rate.extend_from_slice(&pushed[nv..]);
            let share = C::Scalar::constant(step * SHARES[number]);
            total.iter_mut().zip(&rate).for_each(|(to, rate)| *to += share * *rate);
            if let Some(factor) = FACTORS.get(number) {
                let factor = C::Scalar::constant(step * factor);
                let pairs = displacement.iter().zip(&rate);
                moved = pairs.map(|(from, rate)| *from + factor * *rate).collect();
            }
        }
        displacement = total;
        rk4.step(chain, &mut state, |_, _| at.clone()).map_err(stop)?;
    }
    Ok(())
}
