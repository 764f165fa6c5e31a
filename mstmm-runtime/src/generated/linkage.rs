//! Assembly of closed chains, and the rank of their loop constraints.

use super::checks::not_finite;
use crate::description::Described;
use crate::{ChainState, Error, LoopClosure, Mask, Scalar};

/// Returns the results of a loop closure from its undetermined wrenches, which are zero for independent directions.
#[inline]
pub fn loop_closure<T: Scalar, const C: usize>(undetermined: [[T; 6]; C]) -> LoopClosure<T, C> {
    let square = |wrench: [T; 6]| wrench.into_iter().fold(T::default(), |sum, x| sum + x * x);
    LoopClosure::new(undetermined, undetermined.map(square))
}

/// The largest number of corrections until a chain is closed.
pub const CORRECTIONS: u32 = 50;

/// How far a closed chain is from satisfying its loop constraints.
#[derive(Clone, Copy, Debug)]
pub struct Residual<T> {
    /// The norm of displacement, rotation and velocities across the closing hinge, in m, rad, m/s and rad/s.
    pub distance: T,
    /// The same norm without units: lengths relative to the chain's size, velocities also to those of its hinges.
    pub relative: T,
    /// The largest relative pivot among directions that count as redundant, from 0 to 1.
    pub excess: T,
}

impl<T> Residual<T> {
    /// Names the entries.
    #[inline]
    pub fn from_array([distance, relative, excess]: [T; 3]) -> Self {
        Residual { distance, relative, excess }
    }
}

/// Closes a chain by Newton's method.
///
/// `correct` corrects coordinates and rates of the state once, and returns how far it was from closed.
///
/// The chain is closed if its relative error is at most 64 ε. It is also closed if the error has stopped decreasing and
/// is at most ε^⅝, which is 1.6·10⁻¹⁰ in double and 4.7·10⁻⁵ in single precision, because long chains have more
/// rounding. The lane with the largest error decides. The derivatives of dual numbers converge after the values, and
/// are corrected further.
///
/// # Errors
/// [`Error::NotAssembled`] if the chain is not closed after 50 corrections, or if the error is not finite, and
/// the error of [`check_rank`]. `state` is then unchanged.
#[cold]
pub fn close<S: ChainState>(
    state: &mut S,
    hinge: &'static str,
    mut correct: impl FnMut(&mut S) -> Residual<S::Scalar>,
) -> Result<(), Error> {
    type Real<S> = <<S as ChainState>::Scalar as Scalar>::Real;
    let epsilon = Real::<S>::epsilon();
    let closed = Real::<S>::constant(64.0) * epsilon;
    let near = rank_tolerance::<Real<S>>();

    let start = state.clone();
    let mut before = Real::<S>::constant(f64::INFINITY);
    for correction in 0..CORRECTIONS {
        let residual = correct(state);
        let error = residual.relative.max_lane();
        let is_closed = error <= closed || (error <= near && error >= before);
        let is_last = correction + 1 == CORRECTIONS && error <= near;
        if (is_closed || is_last) && is_finite(state) {
            correct_derivatives(state, correct);
            let checked = if is_finite(state) {
                check_rank(residual, hinge)
            } else {
                Err(Error::NotAssembled)
            };
            if checked.is_err() {
                *state = start;
            }
            return checked;
        }
        before = error;
        if !error.is_finite() {
            break;
        }
    }
    *state = start;
    Err(Error::NotAssembled)
}

/// Assembles a chain as [`close`] does.
///
/// # Errors
/// Those of [`close`], and [`Error::NotFinite`] if a value of the state or of the inputs is not finite.
pub fn assemble<C: Described>(
    state: &mut C::State,
    inputs: &C::Inputs,
    hinge: &'static str,
    mut correct: impl FnMut(&mut C::State, &C::Inputs) -> Residual<C::Scalar>,
) -> Result<(), Error> {
    match close(state, hinge, |state| correct(state, inputs)) {
        Err(Error::NotAssembled) => match C::not_finite(state, inputs) {
            Some(origin) => Err(Error::NotFinite(origin)),
            None => Err(Error::NotAssembled),
        },
        other => other,
    }
}

/// Returns the distance from a closed chain.
///
/// # Errors
/// [`Error::NotFinite`] if it is not finite.
#[inline]
pub fn closure_error<C: Described>(
    state: &C::State,
    inputs: &C::Inputs,
    Residual { distance, .. }: Residual<C::Scalar>,
) -> Result<C::Scalar, Error> {
    match distance.is_finite().all() {
        true => Ok(distance),
        false => Err(not_finite::<C>(state, inputs)),
    }
}

/// Corrects the derivatives of a state whose values are closed, and leaves the values unchanged.
///
/// The last correction made the derivatives of the coordinates exact to first order. Those of the rates follow with the
/// next one, and each correction makes one more order exact.
fn correct_derivatives<S: ChainState>(
    state: &mut S,
    mut correct: impl FnMut(&mut S) -> Residual<S::Scalar>,
) {
    for _ in 0..S::Scalar::DERIVATIVE_ORDER {
        let mut next = state.clone();
        correct(&mut next);
        let join = |to: &mut [S::Scalar], from: &[S::Scalar]| {
            to.iter_mut().zip(from).for_each(|(to, &from)| *to = to.with_derivatives_of(from));
        };
        join(state.coordinates_mut(), next.coordinates());
        join(state.rates_mut(), next.rates());
    }
}

/// Returns whether all coordinates and rates are finite.
fn is_finite<S: ChainState>(state: &S) -> bool {
    <S::Scalar as Scalar>::sum(&[state.coordinates(), state.rates()]).is_finite().all()
}

/// Fails if directions of a closing hinge that count as redundant are independent.
///
/// If a redundant linkage is not exactly closed, the largest pivot that is left is about the square of the relative error.
/// The limit is 10⁶ times that square, which allows for arms of a thousandth of the size, plus rounding.
///
/// # Errors
/// [`Error::ClosureRank`].
#[inline]
pub fn check_rank<T: Scalar>(residual: Residual<T>, hinge: &'static str) -> Result<(), Error> {
    let Residual { relative, excess, .. } = residual;
    let limit = (relative * relative).mul_add(T::constant(1e6), rank_tolerance::<T>());
    if (!excess.simd_gt(limit)).all() { Ok(()) } else { Err(Error::ClosureRank { hinge }) }
}

/// The number of poses in which the rank is computed: the rank at the start may be smaller than elsewhere.
const POSES: usize = 4;

/// Returns the steps of the rank of a loop closure: a one for each independent direction, then zeros.
///
/// The rank is the largest one found at the start and in poses assembled around it. If none of these can be
/// assembled, all entries are one.
#[cold]
pub fn rank_steps<S: ChainState, const N: usize>(
    start: &S,
    normalize: impl Fn(&mut S),
    mut correct: impl FnMut(&mut S) -> Residual<S::Scalar>,
    pivots: impl Fn(&S) -> [S::Scalar; N],
) -> [S::Scalar; N] {
    let constant = <S::Scalar as Scalar>::constant;
    let one = constant(1.0);
    let rounding = rank_tolerance::<S::Scalar>();
    let mut steps = None;
    for pose in 0..POSES {
        let mut state = start.clone();
        state.rates_mut().fill(constant(0.0));
        if pose > 0 {
            for (index, q) in state.coordinates_mut().iter_mut().enumerate() {
                *q += constant(low_discrepancy(index + 1, pose) - 0.5);
            }
            normalize(&mut state);
        }
        // All directions are kept, so none counts as redundant and the error needs no name of a hinge.
        if close(&mut state, "", &mut correct).is_err() {
            continue;
        }
        let largest = steps.get_or_insert([constant(0.0); N]);
        for (step, pivot) in largest.iter_mut().zip(pivots(&state)) {
            *step = S::Scalar::select(pivot.simd_gt(rounding), one, *step);
        }
    }
    steps.unwrap_or([one; N])
}

/// Returns the smallest relative pivot of an independent direction: ε^⅝, which is larger than rounding and than the
/// square of the error that `close` leaves.
fn rank_tolerance<T: Scalar>() -> T {
    let root = T::epsilon().sqrt();
    root * root.sqrt().sqrt()
}

/// Returns an entry of a low-discrepancy sequence from 0 to 1: multiples of the golden ratio, modulo 1.
fn low_discrepancy(number: usize, seed: usize) -> f64 {
    let multiple = number as f64 * seed as f64 * 0.618_033_988_749_895;
    multiple - multiple as u64 as f64
}
