//! Dual numbers: values that carry exact derivatives.

mod algebra;

use core::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use crate::{Mask, Scalar};

/// A dual number: a value and its derivatives with respect to `K` variables, which every operation computes exactly.
///
/// A chain of dual numbers computes all its results together with their derivatives with respect to anything that it
/// is given: coordinates, rates, inputs, parameters, the time. There is no step to choose and no truncation error:
/// derivatives are as accurate as values. The values have the bits that the chain computes in `T`, except for
/// [`Scalar::sum`] of lanes. `K` directions in one pass cost less than `K` passes, because the values are shared.
///
/// `T` is `f64`, `f32`, lanes, or a dual number: `Dual<Dual<f64>>` has second derivatives.
///
/// Vectors, rotations and matrices of dual numbers have the sums and products of `nalgebra`. Operators also take a number
/// `T` on the right, and `f64` or `f32` on the left. Functions that `nalgebra` has for real fields only, such as norms, are not
/// there: the norm is `v.dot(&v).sqrt()`. Compare values: `x.value > 0.0`.
///
/// # Example
///
/// The gradient of a product by both factors, and the derivative of a square root:
///
/// ```
/// use mstmm_runtime::{Dual, Scalar};
///
/// let [width, height] = Dual::variables([3.0, 4.0]);
/// let area = width * height;
/// assert_eq!((area.value, area.derivatives), (12.0, [4.0, 3.0]));
///
/// let x = Dual::variable(9.0);
/// assert_eq!((x.sqrt().value, x.sqrt().derivative()), (3.0, 1.0 / 6.0));
/// ```
///
/// The derivative of a trajectory: a pendulum of unit length whose gravity g is unknown. The derivative of its angle
/// after a step of an integrator with respect to g is that of the numerical result, not of the exact motion.
///
/// ```
/// use mstmm_runtime::{Chain, ChainState, Dual, Error, Rk4, Scalar};
///
/// /// `mstmm_chain!` generates such types: they are generic over the scalar.
/// struct Pendulum<T> { gravity: T }
///
/// #[derive(Clone, Default)]
/// struct Swing<T> { q: [T; 1], v: [T; 1], t: T }
///
/// impl<T: Scalar> ChainState for Swing<T> {
///     type Scalar = T;
///     fn coordinates(&self) -> &[T] { &self.q }
///     fn coordinates_mut(&mut self) -> &mut [T] { &mut self.q }
///     fn rates(&self) -> &[T] { &self.v }
///     fn rates_mut(&mut self) -> &mut [T] { &mut self.v }
///     fn time(&self) -> T { self.t }
///     fn set_time(&mut self, time: T) { self.t = time }
/// }
///
/// impl<T: Scalar> Chain for Pendulum<T> {
///     type Scalar = T;
///     type State = Swing<T>;
///     type Inputs = ();
///
///     fn derivative_into(&self, state: &Swing<T>, _: &(), rate: &mut Swing<T>) -> Result<(), Error> {
///         let ([sine], _) = Scalar::sin_cos(state.q);
///         (rate.q, rate.v) = (state.v, [-(self.gravity * sine)]);
///         Ok(())
///     }
///
///     fn configuration_rate_into(&self, state: &Swing<T>, rate: &mut Swing<T>) {
///         rate.q = state.v;
///     }
///
///     fn normalize(&self, _: &mut Swing<T>) {}
/// }
///
/// fn angle<T: Scalar>(gravity: T) -> Result<T, Error> {
///     let mut state = Swing { q: [T::constant(1.0)], ..Swing::default() };
///     Rk4::new(T::constant(0.01)).step(&Pendulum { gravity }, &mut state, |_, _| ())?;
///     Ok(state.q[0])
/// }
///
/// let derivative = angle(Dual::variable(9.8))?.derivative();
/// let difference = (angle(9.8 + 1e-4)? - angle(9.8 - 1e-4)?) / 2e-4;
/// assert!((derivative - difference).abs() < 1e-11);
/// // The angle falls by g sin(1) t²/2.
/// assert!((derivative + 1f64.sin() * 0.01 * 0.01 / 2.0).abs() < 1e-8);
/// # Ok::<(), Error>(())
/// ```
///
/// # Kinks and singular points
///
/// [`copysign`](Scalar::copysign) and [`abs`](Scalar::abs) have the derivative of the side that the sign bit chooses,
/// also at zero: `abs` has the slope 1 at `+0` and −1 at `−0`. Comparisons and [`select`](Scalar::select) look at
/// values only, so a result has the derivative of the branch that computes its value. Friction and limits in
/// hinges are functions of this kind. The derivative of an angle at the origin and of a reciprocal at zero is not
/// finite.
///
/// The derivative of a square root at zero is zero if the derivative of its argument is zero, otherwise it is not finite.
/// The root of a constant zero is thus a constant. A length √(x² + y²) has a kink at zero, where its derivatives are
/// zero; its second derivatives are not finite there.
///
/// The force of a spring whose ends coincide jumps if its free length is not zero. Its derivatives there are finite, but
/// are those of a length that is smoothed over 1e-15 m: stiffness times free length over 1e-15 m.
///
/// A dual number is finite if its value and all its derivatives are. A chain returns
/// [`Error::NotFinite`](crate::Error::NotFinite) where a result has no derivative.
///
/// # Decisions
///
/// The step size of [`Dopri5`](crate::Dopri5) and the rank of redundant loop constraints follow from the values.
/// Their derivatives are those of the numerical method at this choice.
/// [`assemble`](crate::GeneratedChain::assemble) corrects derivatives once more when the values are closed, so that the
/// derivatives satisfy the loop constraints too.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias("autodiff", "AutoDiffXd", "automatic differentiation", "dual number", "dual numbers"))]
#[doc(alias("forward mode", "gradient", "Jet", "ForwardDiff", "num_dual"))]
pub struct Dual<T, const K: usize = 1> {
    /// The value.
    pub value: T,
    /// The derivatives of the value with respect to the variables.
    pub derivatives: [T; K],
}

impl<T, const K: usize> Dual<T, K> {
    /// Makes a dual number of a value and its derivatives.
    #[inline]
    pub fn new(value: T, derivatives: [T; K]) -> Self {
        Self { value, derivatives }
    }
}

impl<T: Scalar, const K: usize> Dual<T, K> {
    /// Returns `K` variables with these values: the derivative of each variable with respect to itself is one.
    #[inline]
    pub fn variables(values: [T; K]) -> [Self; K] {
        let mut variables = values.map(Self::from);
        for (index, variable) in variables.iter_mut().enumerate() {
            let itself = variable.derivatives.iter_mut().skip(index).take(1);
            itself.for_each(|derivative| *derivative = T::constant(1.0));
        }
        variables
    }

    /// Returns the number with this value and the derivatives `combine(a, b)` of the derivatives a, b of two numbers.
    #[inline]
    fn joined(value: T, a: Self, b: Self, combine: impl Fn(T, T) -> T) -> Self {
        let mut derivatives = a.derivatives;
        let both = derivatives.iter_mut().zip(b.derivatives);
        both.for_each(|(a, b)| *a = combine(*a, b));
        Self { value, derivatives }
    }

    /// Returns f(self) of a function with this value and this slope at `self`.
    #[inline]
    fn chained(self, value: T, slope: T) -> Self {
        Self { value, derivatives: self.derivatives.map(|derivative| slope * derivative) }
    }

    /// Returns the square root `root`, with a derivative of zero where the value and this derivative of `self` are zero.
    ///
    /// The slope is infinite there, and its product with zero is NaN.
    #[cold]
    fn root_of_zero(self, root: Self) -> Self {
        let is_zero = |number: T| !number.abs().simd_gt(T::constant(0.0));
        let at_zero = is_zero(self.value);
        // The root of a nested derivative is zero too, and is not finite unless its own derivatives are zero.
        let root_of = |a: T, slope: T| T::select(at_zero & is_zero(a), a.sqrt(), slope);
        Self::joined(root.value, self, root, root_of)
    }
}

impl<T: Scalar> Dual<T> {
    /// Returns the one variable, with this value: its derivative with respect to itself is one.
    #[inline]
    pub fn variable(value: T) -> Self {
        Self { value, derivatives: [T::constant(1.0)] }
    }

    /// Returns the derivative with respect to the one variable.
    #[inline]
    pub fn derivative(self) -> T {
        let [derivative] = self.derivatives;
        derivative
    }
}

/// A constant: its derivatives are zero.
impl<T: Scalar, const K: usize> From<T> for Dual<T, K> {
    #[inline]
    fn from(value: T) -> Self {
        Self { value, derivatives: [T::constant(0.0); K] }
    }
}

/// Zero, a constant.
impl<T: Scalar, const K: usize> Default for Dual<T, K> {
    #[inline]
    fn default() -> Self {
        Self::from(T::default())
    }
}

// Not `inline(always)`: unoptimised code of a chain would need some hundred bytes of stack for each operation.
impl<T: Scalar, const K: usize> Add for Dual<T, K> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self::joined(self.value + other.value, self, other, |a, b| a + b)
    }
}

impl<T: Scalar, const K: usize> Sub for Dual<T, K> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::joined(self.value - other.value, self, other, |a, b| a - b)
    }
}

/// (a b)' = a' b + a b'.
impl<T: Scalar, const K: usize> Mul for Dual<T, K> {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let (x, y) = (self.value, other.value);
        Self::joined(x * y, self, other, |a, b| a.mul_add(y, x * b))
    }
}

impl<T: Scalar, const K: usize> Neg for Dual<T, K> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self { value: -self.value, derivatives: self.derivatives.map(|derivative| -derivative) }
    }
}

impl<T: Scalar, const K: usize> AddAssign for Dual<T, K> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<T: Scalar, const K: usize> SubAssign for Dual<T, K> {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<T: Scalar, const K: usize> MulAssign for Dual<T, K> {
    #[inline]
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl<T: Scalar, const K: usize> Scalar for Dual<T, K> {
    type Mask = T::Mask;
    type Real = T::Real;
    type Columns = Self;
    type Pack = Self;

    const LANES: usize = T::LANES;
    const DERIVATIVE_ORDER: usize = T::DERIVATIVE_ORDER + 1;

    #[inline]
    fn constant(value: f64) -> Self {
        Self::from(T::constant(value))
    }

    #[inline]
    fn epsilon() -> Self {
        Self::from(T::epsilon())
    }

    #[inline]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        let product = self * factor;
        let value = self.value.mul_add(factor.value, addend.value);
        Self::joined(value, product, addend, |a, b| a + b)
    }

    #[inline]
    fn mul_sub(self, factor: Self, subtrahend: Self) -> Self {
        let product = self * factor;
        let value = self.value.mul_sub(factor.value, subtrahend.value);
        Self::joined(value, product, subtrahend, |a, b| a - b)
    }

    #[inline]
    fn mul_neg_add(self, factor: Self, addend: Self) -> Self {
        let product = self * factor;
        let value = self.value.mul_neg_add(factor.value, addend.value);
        Self::joined(value, product, addend, |a, b| b - a)
    }

    #[inline]
    fn negate(self) -> Self {
        Self { value: self.value.negate(), derivatives: self.derivatives.map(T::negate) }
    }

    /// (1/a)' = −a'/a².
    #[inline]
    fn recip(self) -> Self {
        let value = self.value.recip();
        self.chained(value, (value * value).negate())
    }

    /// (√a)' = a'/(2√a), and zero if a and a' are zero.
    #[inline]
    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        let root = self.chained(value, (value + value).recip());
        if self.value.simd_gt(T::constant(0.0)).all() { root } else { self.root_of_zero(root) }
    }

    #[inline]
    fn copysign(self, sign: Self) -> Self {
        let one = T::constant(1.0);
        // One where both signs are the same, else minus one.
        let slope = one.copysign(self.value) * one.copysign(sign.value);
        self.chained(self.value.copysign(sign.value), slope)
    }

    #[inline]
    fn abs(self) -> Self {
        self.chained(self.value.abs(), T::constant(1.0).copysign(self.value))
    }

    /// (sin a)' = cos a a', (cos a)' = −sin a a'.
    #[inline]
    fn sin_cos<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let (sine_values, cosine_values) = T::sin_cos(angles.map(|angle| angle.value));
        let (mut sines, mut cosines) = (angles, angles);
        let values = sine_values.into_iter().zip(cosine_values);
        for ((sine, cosine), (s, c)) in sines.iter_mut().zip(&mut cosines).zip(values) {
            *sine = sine.chained(s, c);
            *cosine = cosine.chained(c, s.negate());
        }
        (sines, cosines)
    }

    /// atan2(y, x)' = (x y' − y x') / (x² + y²), with x and y scaled by the larger so that no square overflows.
    #[inline]
    fn atan2(self, x: Self) -> Self {
        let (size, width) = (self.value.abs(), x.value.abs());
        let scale = T::select(size.simd_gt(width), size, width).recip();
        let (sine, cosine) = (self.value * scale, x.value * scale);
        let over_square = sine.mul_add(sine, cosine * cosine).recip() * scale;
        let (along, across) = (cosine * over_square, sine * over_square);
        let value = self.value.atan2(x.value);
        Self::joined(value, self, x, |y, x| along.mul_sub(y, across * x))
    }

    #[inline]
    fn simd_gt(self, other: Self) -> T::Mask {
        self.value.simd_gt(other.value)
    }

    #[inline]
    fn is_finite(self) -> T::Mask {
        let finite = |all, derivative: T| all & derivative.is_finite();
        self.derivatives.into_iter().fold(self.value.is_finite(), finite)
    }

    #[inline]
    fn select(mask: T::Mask, if_true: Self, if_false: Self) -> Self {
        let value = T::select(mask, if_true.value, if_false.value);
        Self::joined(value, if_true, if_false, |a, b| T::select(mask, a, b))
    }

    #[inline]
    fn with_derivatives_of(self, other: Self) -> Self {
        let value = self.value.with_derivatives_of(other.value);
        Self { value, derivatives: other.derivatives }
    }

    #[inline]
    fn max_lane(self) -> T::Real {
        self.value.max_lane()
    }

    #[inline]
    fn splat(value: T::Real) -> Self {
        Self::from(T::splat(value))
    }
}
