//! What generated code calls besides the public items: the parts of it that are the same for every chain.
//!
//! Not for use by hand; it may change with every version.

mod linkage;

/// What a loop leaves for later ones, time by time: room that nothing fills before it does.
pub use arrayvec::ArrayVec as Stored;

pub use crate::point::{Places, entries};
pub use crate::quaternion::{QuaternionsOf, check_quaternion, check_quaternions};
pub use linkage::{assemble, check_closure, closure, closure_steps};

use core::convert::identity;

use crate::{Error, Mask, Scalar};

/// The parameters of a chain and the values derived from them; read only.
///
/// All code in the module of the macro call can write the fields of generated types. It cannot write these.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sealed<P, D = ()> {
    parameters: P,
    derived: D,
}

impl<P> Sealed<P> {
    /// Parameters from which nothing has been derived yet.
    #[inline(always)]
    pub fn new(parameters: P) -> Self {
        Self { parameters, derived: () }
    }

    /// The same parameters with what is derived from them.
    #[inline(always)]
    pub fn with<D>(self, derived: D) -> Sealed<P, D> {
        Sealed { parameters: self.parameters, derived }
    }
}

impl<P, D> Sealed<P, D> {
    /// The parameters.
    #[inline(always)]
    pub fn parameters(&self) -> &P {
        &self.parameters
    }

    /// What is derived from them.
    #[inline(always)]
    pub fn derived(&self) -> &D {
        &self.derived
    }
}

/// How many units in the last place of its scale a pivot must exceed to count as positive: a pivot that should vanish is
/// the difference of a few rounded products of that size.
pub const NOISE: f64 = 8.0;

/// Whether all pivots are positive beyond rounding, and numbers finite: so is then their sum, and if it overflows
/// they mean nothing either. What is known last comes last.
#[inline(always)]
pub fn regular<T: Scalar, const P: usize, const N: usize>(
    pivots: [T; P],
    scales: [T; P],
    numbers: [T; N],
) -> bool {
    let noise = T::epsilon() * T::constant(NOISE);
    // The last two apart, which are known at about the same time: nothing else is left to do meanwhile.
    let (first, last) = numbers.split_at(N.saturating_sub(2));
    let sum = |numbers: &[T]| numbers.iter().copied().reduce(|sum, number| sum + number);
    let sum = match (sum(first), sum(last)) {
        (Some(first), Some(last)) => first + last,
        (first, last) => first.or(last).unwrap_or(T::constant(0.0)),
    };
    let mut regular = sum.is_finite();
    for (pivot, scale) in pivots.into_iter().zip(scales) {
        regular = regular & pivot.simd_gt(noise * scale);
    }
    regular.all()
}

/// Why what should be [`regular`] is not: the first hinge whose pivot vanishes, or something is not finite.
///
/// It is apart from the question, so that the compiler sees that nothing but an error follows from it.
#[inline(always)]
pub fn irregular<T: Scalar, const P: usize>(
    hinges: &[&'static str; P],
    pivots: [T; P],
    scales: [T; P],
) -> Error {
    // Copies, without which the arrays would be in memory also where nothing is wrong.
    diagnosis(hinges, &pivots.map(identity), &scales.map(identity))
}

/// Fails if any of the numbers is NaN or infinite, or their sum. What a chain computes need not depend on all of them.
///
/// # Errors
/// [`Error::NotFinite`].
#[inline]
pub fn finite<T: Scalar>(numbers: &[&[T]]) -> Result<(), Error> {
    if T::sum(numbers).is_finite().all() { Ok(()) } else { Err(Error::NotFinite) }
}

/// Fails if any of the numbers is NaN or infinite, of which there may be many: they are added up
/// side by side, for a sum of all of them would take as long as a chain does.
///
/// # Errors
/// [`Error::NotFinite`].
#[inline]
pub fn all_finite<T: Scalar>(numbers: &[T]) -> Result<(), Error> {
    let (chunks, rest) = numbers.as_chunks::<16>();
    let mut sums = [T::constant(0.0); 16];
    for chunk in chunks {
        for (sum, &number) in sums.iter_mut().zip(chunk) {
            *sum += number;
        }
    }
    finite(&[&sums, rest])
}

/// Why a chain has no accelerations.
#[cold]
#[inline(never)]
fn diagnosis<T: Scalar>(hinges: &[&'static str], pivots: &[T], scales: &[T]) -> Error {
    let noise = T::epsilon() * T::constant(NOISE);
    for ((&hinge, &pivot), &scale) in hinges.iter().zip(pivots).zip(scales) {
        // Too large a state is no fault of the hinge.
        if (pivot.is_finite() & scale.is_finite()).all() && !pivot.simd_gt(noise * scale).all() {
            return Error::Singular { hinge };
        }
    }
    Error::NotFinite
}

/// What has been written is written: the compiler may not put it off any longer, and keep results in registers that
/// are wanted. No instruction, and nothing but speed hangs on it.
#[inline(always)]
pub fn written() {
    core::sync::atomic::compiler_fence(core::sync::atomic::Ordering::SeqCst);
}

/// Makes results anew where there turn out to be none: nothing of what has been written stays.
#[cold]
#[inline(never)]
pub fn take_back<W>(results: &mut W, new: impl FnOnce() -> W) {
    *results = new();
}

/// Whether a parameter may be set: to a finite number that leaves everything derived from it finite.
///
/// # Errors
/// [`Error::InvalidParameter`] with the reason.
#[cold]
pub fn check_parameter<T: Scalar>(
    name: &'static str,
    values: &[T],
    derived: &[&[T]],
) -> Result<(), Error> {
    let finite = |numbers: &[T]| numbers.iter().all(|number| number.is_finite().all());
    if !finite(values) {
        return Err(Error::InvalidParameter { name, reason: "must be a finite number" });
    }
    if !derived.iter().all(|numbers| finite(numbers)) {
        return Err(Error::InvalidParameter {
            name,
            reason: "must leave all quantities derived from it finite",
        });
    }
    Ok(())
}

/// Whether numbers that hang on a parameter are what they must be: positive where the first part of a rule says so,
/// not negative elsewhere.
///
/// # Errors
/// [`Error::InvalidParameter`] with the reason of the first rule that is broken.
#[cold]
pub fn check_numbers<T: Scalar, const N: usize>(
    name: &'static str,
    numbers: &[T; N],
    rules: &[(bool, &'static str); N],
) -> Result<(), Error> {
    let zero = T::constant(0.0);
    for (number, &(positive, reason)) in numbers.iter().zip(rules) {
        let holds = if positive { number.simd_gt(zero) } else { !zero.simd_gt(*number) };
        if !(holds & number.is_finite()).all() {
            return Err(Error::InvalidParameter { name, reason });
        }
    }
    Ok(())
}

/// How many units in the last place of its scale a number must exceed to count as not zero, where equations have to
/// ask: rows of a closure that hang on others leave the rounding of many operations.
pub const REDUNDANT: f64 = 1024.0;

/// `1 / value` where it exceeds what rounding can leave of `scale`, zero elsewhere.
#[inline]
pub fn recip_above<T: Scalar>(value: T, scale: T) -> T {
    let above = value.simd_gt(T::epsilon() * T::constant(REDUNDANT) * scale);
    T::select(above, value.recip(), T::constant(0.0))
}

/// More than nothing, and less than any inertia: so a pivot of zero vanishes beside a scale of zero.
const TINY: f64 = 1e-30;

/// Whether a pivot is a number that is not positive beyond rounding.
#[inline]
pub fn vanishes<T: Scalar>(pivot: T, scale: T) -> T::Mask {
    // One comparison, for there may be thousands of them; with NaN it says no.
    scale.mul_add(T::epsilon() * T::constant(NOISE), T::constant(TINY)).simd_gt(pivot)
}

/// Fails with the name of a repeated hinge if a pivot of it is not positive.
///
/// # Errors
/// [`Error::Singular`].
#[inline]
pub fn require<M: Mask>(regular: M, hinge: &'static str) -> Result<(), Error> {
    if regular.all() { Ok(()) } else { Err(Error::Singular { hinge }) }
}

/// Numbers in a row, of which the compiler knows how many they are.
pub trait Row {
    /// What they are.
    type Number;
    /// How many they are.
    const LEN: usize;
    /// All of them.
    fn row(&self) -> &[Self::Number];
    /// All of them, to be written.
    fn row_mut(&mut self) -> &mut [Self::Number];
}

impl<T, const LEN: usize> Row for [T; LEN] {
    type Number = T;
    const LEN: usize = LEN;
    #[inline(always)]
    fn row(&self) -> &[T] {
        self
    }
    #[inline(always)]
    fn row_mut(&mut self) -> &mut [T] {
        self
    }
}

impl<T: Scalar, const LEN: usize> Row for nalgebra::SVector<T, LEN> {
    type Number = T;
    const LEN: usize = LEN;
    #[inline(always)]
    fn row(&self) -> &[T] {
        self.as_slice()
    }
    #[inline(always)]
    fn row_mut(&mut self) -> &mut [T] {
        self.as_mut_slice()
    }
}

/// `N` numbers of a row from a place on.
#[inline(always)]
pub fn piece<R: Row<Number: Copy>, const N: usize, const PLACE: usize>(row: &R) -> [R::Number; N] {
    times::<R, N, PLACE, 1>(row)[0]
}

/// The numbers of a repeated part in a row, from a place on, `N` every time.
///
/// ```
/// mstmm_runtime::generated::times::<_, 2, 0, 2>(&[0.0; 4]);
/// ```
/// ```compile_fail
/// mstmm_runtime::generated::times::<_, 2, 1, 2>(&[0.0; 4]);
/// ```
#[inline(always)]
pub fn times<R: Row, const N: usize, const PLACE: usize, const TIMES: usize>(
    row: &R,
) -> &[[R::Number; N]] {
    const { assert!(PLACE + N * TIMES <= R::LEN, "mstmm bug: numbers beyond the end of their row") };
    row.row()[PLACE..PLACE + N * TIMES].as_chunks().0
}

/// As [`times`], to be written.
#[inline(always)]
pub fn times_mut<R: Row, const N: usize, const PLACE: usize, const TIMES: usize>(
    row: &mut R,
) -> &mut [[R::Number; N]] {
    const { assert!(PLACE + N * TIMES <= R::LEN, "mstmm bug: numbers beyond the end of their row") };
    row.row_mut()[PLACE..PLACE + N * TIMES].as_chunks_mut().0
}

/// Numbers with some that are known, each by its place.
#[must_use]
pub fn with_known<T: Scalar, const N: usize>(mut numbers: [T; N], known: &[(usize, T)]) -> [T; N] {
    for &(place, value) in known {
        if let Some(number) = numbers.get_mut(place) {
            *number = value;
        }
    }
    numbers
}

/// The number of a connection point in the model, and the numbers that it is read off: those of its piece, at its time.
///
/// Pieces are told by six numbers: the first point in the model, how many points of it, the first of all points, how
/// many of all, the first number, and how many numbers every time has.
#[inline]
pub fn place_of<'a, T>(numbers: &'a [T], pieces: &[[usize; 6]], index: usize) -> (usize, &'a [T]) {
    for &[model, each, first, all, place, count] in pieces {
        if (first..first + all).contains(&index) {
            let (time, point) = ((index - first) / each, (index - first) % each);
            let rest = numbers.get(place + time * count..).unwrap_or_default();
            return (model + point, rest);
        }
    }
    (usize::MAX, &[])
}

/// Square root of a number in a chain's description.
pub fn sqrt(value: f64) -> f64 {
    Scalar::sqrt(value)
}

/// Sine of an angle in rad in a chain's description.
pub fn sin(value: f64) -> f64 {
    let ([sine], _) = <f64 as Scalar>::sin_cos([value]);
    sine
}

/// Cosine of an angle in rad in a chain's description.
pub fn cos(value: f64) -> f64 {
    let (_, [cosine]) = <f64 as Scalar>::sin_cos([value]);
    cosine
}

/// A vector of nalgebra's from its entries.
#[inline]
pub fn vector<T: Scalar, const N: usize>(entries: [T; N]) -> nalgebra::SVector<T, N> {
    nalgebra::SVector::from(entries)
}
