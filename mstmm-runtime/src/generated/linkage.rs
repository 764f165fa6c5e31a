//! How closed chains are assembled, and how the rank of their closure is found and watched.

use crate::{ChainState, Error, LoopClosure, Mask, Scalar};

/// The result of a closure from the wrenches that it leaves undetermined, which are zero where there is none.
#[inline]
pub fn closure<T: Scalar, const C: usize>(undetermined: [[T; 6]; C]) -> LoopClosure<T, C> {
    let square = |wrench: [T; 6]| wrench.into_iter().fold(T::default(), |sum, x| sum + x * x);
    LoopClosure::new(undetermined, undetermined.map(square))
}

/// Most corrections on the way to a closed chain.
const MOST_CORRECTIONS: u32 = 50;

/// Closes a chain by Newton's method. `correct` corrects coordinates and rates of the state once and returns how far it
/// is from closed, in m and rad: where lengths of the chain are near one metre, rounding leaves a few units in the last
/// place of one.
///
/// It is closed where that is at most 64 ε, or where it shrinks no longer and is at most ε^⅝, 1.6·10⁻¹⁰ in double and
/// 4.7·10⁻⁵ in single precision: long chains leave more rounding. Of several lanes the worst one decides.
///
/// # Errors
/// [`Error::NotAssembled`] if it is not closed after 50 corrections, or as soon as it is not finite, and
/// [`Error::ClosureRank`] as [`check_closure`] says; `state` is left as it was.
#[cold]
pub fn assemble<S: ChainState>(
    state: &mut S,
    hinge: &'static str,
    mut correct: impl FnMut(&mut S) -> [S::Scalar; 2],
) -> Result<(), Error> {
    type Real<S> = <<S as ChainState>::Scalar as Scalar>::Real;
    let epsilon = Real::<S>::epsilon();
    let closed = Real::<S>::constant(64.0) * epsilon;
    let near = independent::<Real<S>>();

    let start = state.clone();
    let mut before = Real::<S>::constant(f64::INFINITY);
    for correction in 0..MOST_CORRECTIONS {
        let residual = correct(state);
        let left = residual[0].max_lane();
        let is_closed = left <= closed || (left <= near && left >= before);
        let is_last = correction + 1 == MOST_CORRECTIONS && left <= near;
        let numbers = <S::Scalar as Scalar>::sum(&[state.coordinates(), state.rates()]);
        if (is_closed || is_last) && numbers.is_finite().all() {
            let checked = check_closure(residual, hinge);
            if checked.is_err() {
                *state = start;
            }
            return checked;
        }
        before = left;
        if !left.is_finite() {
            break;
        }
    }
    *state = start;
    Err(Error::NotAssembled)
}

/// Fails if directions of a closing hinge that count as redundant are independent. `residual` is how far the chain is
/// from closed, in m, rad, m/s and rad/s, and the largest relative pivot that is left, from 0 to 1.
///
/// Off its closure a redundant linkage leaves about the square of the first. The limit is 10⁶ times that, for lengths of
/// a millimetre, and rounding.
///
/// # Errors
/// [`Error::ClosureRank`].
#[inline]
pub fn check_closure<T: Scalar>(residual: [T; 2], hinge: &'static str) -> Result<(), Error> {
    let [gap, excess] = residual;
    let most = (gap * gap).mul_add(T::constant(1e6), independent::<T>());
    if (!excess.simd_gt(most)).all() { Ok(()) } else { Err(Error::ClosureRank { hinge }) }
}

/// Poses that the rank of a closure is looked for in: the start may be a special one.
const POSES: usize = 4;

/// Returns the steps of a closure: a one for each independent direction, then zeros. The rank is the largest one found
/// in the start and in poses assembled around it. If none can be assembled, all entries are one.
#[cold]
pub fn closure_steps<S: ChainState, const N: usize>(
    start: &S,
    normalize: impl Fn(&mut S),
    mut correct: impl FnMut(&mut S) -> [S::Scalar; 2],
    pivots: impl Fn(&S) -> [S::Scalar; N],
) -> [S::Scalar; N] {
    let constant = <S::Scalar as Scalar>::constant;
    let one = constant(1.0);
    let rounding = independent::<S::Scalar>();
    let mut steps = None;
    for pose in 0..POSES {
        let mut state = start.clone();
        state.rates_mut().fill(constant(0.0));
        if pose > 0 {
            for (number, q) in state.coordinates_mut().iter_mut().enumerate() {
                *q += constant(scattered(number + 1, pose) - 0.5);
            }
            normalize(&mut state);
        }
        // With all directions kept none counts as redundant, and no name is needed.
        if assemble(&mut state, "", &mut correct).is_err() {
            continue;
        }
        let found = steps.get_or_insert([constant(0.0); N]);
        for (step, pivot) in found.iter_mut().zip(pivots(&state)) {
            *step = S::Scalar::select(pivot.simd_gt(rounding), one, *step);
        }
    }
    steps.unwrap_or([one; N])
}

/// The smallest relative pivot that counts as independent: ε^⅝, which exceeds rounding and the square of the gap that
/// `assemble` leaves.
fn independent<T: Scalar>() -> T {
    let root = T::epsilon().sqrt();
    root * root.sqrt().sqrt()
}

/// Numbers from 0 to 1 as far from each other as they can be: multiples of the golden ratio.
fn scattered(number: usize, seed: usize) -> f64 {
    let multiple = number as f64 * seed as f64 * 0.618_033_988_749_895;
    multiple - multiple as u64 as f64
}
