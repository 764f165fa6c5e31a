//! The linear-quadratic regulator in discrete time.
//!
//! # Method
//!
//! The discrete algebraic Riccati equation P = Aᵀ P A − Aᵀ P B (R + Bᵀ P B)⁻¹ Bᵀ P A + Q is solved by the
//! structure-preserving doubling algorithm (Chu, Fan, Lin and Wang, *Structure-preserving algorithms for periodic
//! discrete-time algebraic Riccati equations*, Int. J. Control 77, 2004). Its k-th iterate is the cost over 2ᵏ steps.
//! Newton's method (Hewer 1971) follows: the cost of the gain found is summed over all time, by doubling too, and the best
//! gain with this cost from the next step on replaces the gain. It removes the rounding errors of the first part. The sum
//! converges only if the closed loop is stable. The closed loops of all gains that follow are stable too.
//!
//! If R is much smaller than Bᵀ P B, or if motions grow many times in a step, the doubling loses digits, and may find no gain.
//! Every gain with a stable closed loop can be the start of Newton's method, so that of a limited number of steps is taken, by
//! the Riccati recursion P ← Cᵀ P C + Q + Kᵀ R K. All of its terms are positive.
//!
//! Q and R are divided by a common power of two first, which the gain does not depend on, so that the largest entry is near
//! one; the cost is multiplied by it at the end. Both are exact.

use super::product::{add_product, product, transposed};
use super::solve::solve_both;
use super::{Columns, largest, solve_positive_definite};
use crate::origin::{self, Origin};
use crate::{Error, Mask, Scalar};
use nalgebra::SMatrix;

/// The largest number of doublings: 2⁵⁰ steps. A closed loop whose motions decay more slowly counts as not stable.
const DOUBLINGS: usize = 50;

/// The numbers of steps after which the recursion is asked for a gain with a stable closed loop, if the doubling finds none.
const HORIZONS: [usize; 3] = [16, 64, 256];

/// The largest number of steps of Newton's method. From a gain that is far from the best one the cost first falls to a
/// quarter in each step.
const NEWTON_STEPS: usize = 40;

/// The relative change of a gain from which on it may be far from the best one.
const FAR: f64 = 1e-3;

/// The result of [`lqr`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lqr<T, const X: usize, const U: usize> {
    /// The gain K of the inputs u = −K x.
    pub gain: SMatrix<T, U, X>,
    /// The matrix P of the cost xᵀ P x that remains from a state x on.
    #[doc(alias("cost-to-go", "Riccati", "value function"))]
    pub cost: SMatrix<T, X, X>,
}

/// Computes the linear-quadratic regulator of x⁺ = A x + B u: the gain K of u = −K x with the least sum of
/// xᵀ Q x + uᵀ R u over all steps.
///
/// Q and R are symmetric; only their symmetric parts count. Q has no negative eigenvalue, R is positive definite. Costs
/// of a step are weights in continuous time multiplied by the step. A and B are those of
/// [`discretize`](super::discretize), for example. Each lane has its own regulator.
///
/// The number of operations is bounded: at most a sum of 50 doublings with 9 X³ multiplications, 336 steps of a recursion
/// with 2 X³ + 4 X² U + 3 X U² + U³, and 44 sums of 50 doublings with 3 X³. Usually there are one sum, no recursion and three
/// sums. About twenty doublings are needed for each sum if the slowest motion of the closed loop decays in 10⁵ steps.
///
/// # Errors
/// [`Error::InvalidParameter`] for `r` if R is not positive definite, [`Error::NotFinite`] if a matrix is not finite or
/// the cost or B R⁻¹ Bᵀ Q overflows, and [`Error::NotStabilizable`] if no gain was found that makes A − B K stable, in
/// any lane. The gain is not found if a motion that does not decay without control is not changed by the inputs, or has no
/// weight in Q.
#[doc(alias("dlqr", "DARE", "LinearQuadraticRegulator", "optimal control", "solve_discrete_are"))]
#[doc(alias("discrete Riccati equation"))]
#[doc(alias("DiscreteTimeLinearQuadraticRegulator", "DiscreteAlgebraicRiccatiEquation"))]
pub fn lqr<T: Scalar, const X: usize, const U: usize>(
    a: &SMatrix<T, X, X>,
    b: &SMatrix<T, X, U>,
    q: &SMatrix<T, X, X>,
    r: &SMatrix<T, U, U>,
) -> Result<Lqr<T, X, U>, Error> {
    check_finite("a", a)?;
    check_finite("b", b)?;
    check_finite("q", q)?;
    check_finite("r", r)?;
    let (a, b) = (&a.data.0, &b.data.0);
    let (mut q, given_r) = (q.data.0, r);
    let mut r = r.data.0;
    let largest = largest(q.as_flattened().iter().chain(r.as_flattened()));
    let [inverse, scale] = power_of_two(largest);
    scale_by(&mut q, inverse);
    scale_by(&mut r, inverse);
    make_symmetric(&mut q);
    make_symmetric(&mut r);
    let problem = Problem { a, b, q, r, given_r };
    let start = problem.stabilizing()?;
    let (gain, mut cost) = problem.best_from(start)?;
    scale_by(&mut cost, scale);
    if !are_finite(&cost) {
        return Err(Error::NotFinite(Origin::Result));
    }
    Ok(Lqr { gain: gain.into(), cost: cost.into() })
}

/// Returns 2⁻ᵏ and 2ᵏ with `value` · 2⁻ᵏ between 1/16 and 16, in each lane, if the scalar has both powers; 1 and 1 for
/// zero.
fn power_of_two<T: Scalar>(value: T) -> [T; 2] {
    let one = T::constant(1.0);
    let (mut rest, mut inverse, mut power) = (value, one, one);
    let is_zero = !value.simd_gt(T::constant(0.0));
    // 2⁴, 2⁸, …, 2⁵¹² by squaring: a loop over constants would convert them from `f64` in each step.
    let mut next = T::constant(16.0);
    let powers = [(); 8].map(|()| {
        let power = next;
        next = power * power;
        power
    });
    for large in powers.into_iter().rev() {
        let small = large.recip();
        // In `f32` the larger powers are infinite.
        let exists = large.is_finite();
        for (applies, down, up) in [
            (exists & !large.simd_gt(rest), small, large),
            (exists & !is_zero & small.simd_gt(rest), large, small),
        ] {
            rest = T::select(applies, rest * down, rest);
            inverse = T::select(applies, inverse * down, inverse);
            power = T::select(applies, power * up, power);
        }
    }
    [inverse, power]
}

fn scale_by<T: Scalar, const R: usize, const C: usize>(matrix: &mut Columns<T, R, C>, factor: T) {
    matrix.as_flattened_mut().iter_mut().for_each(|entry| *entry *= factor);
}

/// Returns whether all entries are finite, in all lanes.
fn are_finite<T: Scalar, const R: usize, const C: usize>(matrix: &Columns<T, R, C>) -> bool {
    let entries = matrix.as_flattened().iter();
    entries.fold(<T::Mask as Mask>::splat(true), |all, x| all & x.is_finite()).all()
}

/// The matrices of a regulator, with Q and R divided by a common factor.
struct Problem<'a, T, const X: usize, const U: usize> {
    a: &'a Columns<T, X, X>,
    b: &'a Columns<T, X, U>,
    q: Columns<T, X, X>,
    r: Columns<T, U, U>,
    /// R before it is scaled.
    given_r: &'a SMatrix<T, U, U>,
}

impl<T: Scalar, const X: usize, const U: usize> Problem<'_, T, X, U> {
    /// Returns a gain with a stable closed loop, and its cost. It is the best gain but for rounding errors, unless the doubling
    /// fails.
    fn stabilizing(&self) -> Result<(Columns<T, U, X>, Columns<T, X, X>), Error> {
        let doubled = self.cost_by_doubling().and_then(|cost| self.with_cost(self.gain(&cost)?));
        if !matches!(doubled, Err(Error::NotStabilizable)) {
            return doubled;
        }
        let mut cost = self.q;
        for steps in HORIZONS {
            for _ in 0..steps {
                cost = self.cost_of_step(&self.gain(&cost)?, &cost);
            }
            let found = self.with_cost(self.gain(&cost)?);
            if !matches!(found, Err(Error::NotStabilizable)) {
                return found;
            }
        }
        doubled
    }

    /// Returns a gain with its cost.
    fn with_cost(
        &self,
        gain: Columns<T, U, X>,
    ) -> Result<(Columns<T, U, X>, Columns<T, X, X>), Error> {
        Ok((gain, self.cost_of(&gain)?))
    }

    /// Returns the cost Cᵀ P C + Q + Kᵀ R K of a step with the gain K and the closed loop C, and the cost P from then on.
    fn cost_of_step(&self, gain: &Columns<T, U, X>, cost: &Columns<T, X, X>) -> Columns<T, X, X> {
        let closed = self.closed_loop(gain);
        let mut sum = self.weights(gain);
        add_product(&mut sum, &transposed(&closed), &product(cost, &closed));
        make_symmetric(&mut sum);
        sum
    }

    /// Returns A − B K.
    fn closed_loop(&self, gain: &Columns<T, U, X>) -> Columns<T, X, X> {
        let mut closed = product(self.b, gain);
        let both = closed.as_flattened_mut().iter_mut().zip(self.a.as_flattened());
        both.for_each(|(entry, &a)| *entry = a - *entry);
        closed
    }

    /// Returns Q + Kᵀ R K.
    fn weights(&self, gain: &Columns<T, U, X>) -> Columns<T, X, X> {
        let mut weights = self.q;
        add_product(&mut weights, &transposed(gain), &product(&self.r, gain));
        weights
    }

    /// Returns the best gain, and its cost, by Newton's method from a gain with a stable closed loop. Near the best gain
    /// changes are squared by each step, so one that is no less than half of the change before is a rounding error.
    fn best_from(
        &self,
        (mut gain, mut cost): (Columns<T, U, X>, Columns<T, X, X>),
    ) -> Result<(Columns<T, U, X>, Columns<T, X, X>), Error> {
        let mut change = T::constant(f64::INFINITY);
        for _ in 0..NEWTON_STEPS {
            let next = self.gain(&cost)?;
            let mut difference = next;
            let entries = difference.as_flattened_mut().iter_mut();
            entries.zip(gain.as_flattened()).for_each(|(entry, &gain)| *entry -= gain);
            let size = largest(next.as_flattened());
            let now = largest(difference.as_flattened()) * size.recip();
            gain = next;
            let improves = now.simd_gt(T::constant(FAR)) | change.simd_gt(now + now);
            if (!improves).all() {
                break;
            }
            change = now;
            cost = self.cost_of(&gain)?;
        }
        Ok((gain, cost))
    }

    /// Returns the least cost, by doubling: A ← A W A, G ← G + A W G Aᵀ, H ← H + Aᵀ H W A, with W = (1 + G H)⁻¹, from
    /// G = B R⁻¹ Bᵀ and H = Q.
    fn cost_by_doubling(&self) -> Result<Columns<T, X, X>, Error> {
        let scaled = solve_positive_definite(&self.r.into(), &transposed(self.b).into());
        let mut g = product(self.b, &scaled.map_err(|_| self.r_is_refused())?.data.0);
        make_symmetric(&mut g);
        let (mut a, mut h) = (*self.a, self.q);
        for doubling in 0..DOUBLINGS {
            let mut w = unit();
            add_product(&mut w, &g, &h);
            if doubling == 0 && !are_finite(&w) {
                return Err(Error::NotFinite(Origin::Result));
            }
            let (wa, wg) = solve_both(&w, &a, &g).map_err(|_| Error::NotStabilizable)?;
            let left = transposed(&a);
            let change = product(&left, &product(&h, &wa));
            add_product(&mut g, &a, &product(&wg, &left));
            a = product(&a, &wa);
            add(&mut h, &change);
            make_symmetric(&mut g);
            make_symmetric(&mut h);
            if has_decayed(&a)? {
                return Ok(h);
            }
        }
        Err(Error::NotStabilizable)
    }

    /// Returns the error for an R of which elimination fails: it is not positive definite, or so much smaller than Q
    /// that it is lost.
    fn r_is_refused(&self) -> Error {
        let mut r = self.given_r.data.0;
        let [inverse, _] = power_of_two(largest(r.as_flattened()));
        scale_by(&mut r, inverse);
        make_symmetric(&mut r);
        match solve_positive_definite(&r.into(), &transposed(self.b).into()) {
            Err(Error::SingularMatrix) => {
                Error::InvalidParameter { name: "r", reason: "must be positive definite" }
            }
            _ => Error::NotFinite(Origin::Result),
        }
    }

    /// Returns (R + Bᵀ P B)⁻¹ Bᵀ P A, the gain that is the best with the cost P from the next step on.
    fn gain(&self, cost: &Columns<T, X, X>) -> Result<Columns<T, U, X>, Error> {
        let weighted = product(&transposed(self.b), cost);
        let mut left = self.r;
        add_product(&mut left, &weighted, self.b);
        make_symmetric(&mut left);
        let gain = solve_positive_definite(&left.into(), &product(&weighted, self.a).into());
        Ok(gain.map_err(|_| Error::NotStabilizable)?.data.0)
    }

    /// Returns the cost Σ (Cᵀ)ⁿ (Q + Kᵀ R K) Cⁿ of a gain K with the closed loop C = A − B K: P ← P + Cᵀ P C, C ← C².
    fn cost_of(&self, gain: &Columns<T, U, X>) -> Result<Columns<T, X, X>, Error> {
        let (mut closed, mut cost) = (self.closed_loop(gain), self.weights(gain));
        for _ in 0..DOUBLINGS {
            let change = product(&transposed(&closed), &product(&cost, &closed));
            add(&mut cost, &change);
            make_symmetric(&mut cost);
            if has_decayed(&closed)? {
                return Ok(cost);
            }
            closed = product(&closed, &closed);
        }
        Err(Error::NotStabilizable)
    }
}

fn unit<T: Scalar, const N: usize>() -> Columns<T, N, N> {
    core::array::from_fn(|column| {
        core::array::from_fn(|row| T::constant(if row == column { 1.0 } else { 0.0 }))
    })
}

/// Adds `other` to `sum`.
fn add<T: Scalar, const R: usize, const C: usize>(
    sum: &mut Columns<T, R, C>,
    other: &Columns<T, R, C>,
) {
    let both = sum.as_flattened_mut().iter_mut().zip(other.as_flattened());
    both.for_each(|(sum, &other)| *sum += other);
}

/// Replaces a matrix by its symmetric part.
fn make_symmetric<T: Scalar, const N: usize>(matrix: &mut Columns<T, N, N>) {
    let other = transposed(matrix);
    add(matrix, &other);
    matrix.as_flattened_mut().iter_mut().for_each(|entry| *entry *= T::constant(0.5));
}

/// Returns whether Mᵀ Y M is below the rounding errors of Y for all Y of equal scales, in all lanes.
///
/// # Errors
/// [`Error::NotStabilizable`] if an entry is not finite.
fn has_decayed<T: Scalar, const N: usize>(matrix: &Columns<T, N, N>) -> Result<bool, Error> {
    if !are_finite(matrix) {
        return Err(Error::NotStabilizable);
    }
    // An upper bound of the largest singular value.
    let norm = T::constant(N as f64) * largest(matrix.as_flattened());
    Ok(T::epsilon().simd_gt(norm * norm).all())
}

/// Fails if an entry of an argument is not finite.
fn check_finite<T: Scalar, const R: usize, const C: usize>(
    name: &'static str,
    matrix: &SMatrix<T, R, C>,
) -> Result<(), Error> {
    if matrix.iter().all(|entry| entry.is_finite().all()) {
        return Ok(());
    }
    Err(Error::NotFinite(origin::of_argument(name, matrix.as_slice())))
}
