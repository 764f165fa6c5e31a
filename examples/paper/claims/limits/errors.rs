//! The accelerations of chains of cubes by generated code, relative errors, and their bound.

use mstmm::{ChainState, Error, GeneratedChain, Scalar};
use nalgebra::Vector3;

use super::DIGITS;
use super::pose::{Pose, Real, exact};

/// A generated chain of cubes.
pub trait Cubes: GeneratedChain {
    /// r̈ and Ω̇ at the inputs of all bodies, inertial frame.
    fn at_inputs(at: &Self::Workspace) -> Vec<[Vector3<Self::Scalar>; 2]>;
}

/// r̈ and Ω̇ of the inputs of all bodies, from coordinates rounded to the chain's own precision.
pub fn accelerations<C>(chain: &C, pose: &Pose) -> Result<Vec<f64>, Error>
where
    C: Cubes<Scalar: Into<f64>>,
{
    let mut state = chain.initial_state();
    let (q, v) = pose.coordinates();
    let set = |(to, from): (&mut C::Scalar, &f64)| *to = C::Scalar::constant(*from);
    state.coordinates_mut().iter_mut().zip(&q).for_each(set);
    state.rates_mut().iter_mut().zip(&v).for_each(set);
    let mut at = Box::new(chain.workspace());
    chain.solve_into(&state, &chain.no_inputs(), &mut at)?;
    let all = C::at_inputs(&at).into_iter().flatten();
    Ok(all.flat_map(<[C::Scalar; 3]>::from).map(Into::into).collect())
}

/// The largest error relative to the largest acceleration; NaN if a value is not finite.
pub fn error(found: &[f64], truth: &[Real]) -> f64 {
    if found.len() != truth.len() || found.iter().any(|x| !x.is_finite()) {
        return f64::NAN;
    }
    let found: Vec<Real> = found.iter().map(|&x| exact(x, DIGITS)).collect();
    apart(&found, truth)
}

/// The largest difference between two lists of equal length, relative to the largest value of the second.
pub fn apart(one: &[Real], other: &[Real]) -> f64 {
    let size = |x: Real| x.to_f64().value().abs();
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
    largest(&mut one.iter().zip(other).map(|(a, b)| size(a - b)))
        / largest(&mut other.iter().map(|x| size(x.clone())))
}

/// The operations of an evaluation per body by `transfer`, which needs more than `riccati`.
const OPERATIONS: f64 = 1240.0;

/// The bound for the relative error of generated code: half a unit in the last place for each operation, as
/// if each rounding error were one of the largest acceleration.
pub fn bound(bodies: usize, unit: f64) -> f64 {
    0.5 * unit * OPERATIONS * bodies as f64
}
