//! The scalars for the interpreter of procedures.

use super::double_double::DoubleDouble;
use super::interpreter::Judge;
use mstmm_codegen::math::{Dual, PIVOT_ULPS};

impl Judge for f64 {
    fn exceeds(self, scale: Self) -> bool {
        self > PIVOT_ULPS * f64::EPSILON * scale
    }
    fn is_finite(self) -> bool {
        f64::is_finite(self)
    }
    fn product_sum(a: Self, b: Self, c: Self, fused: bool) -> Self {
        if fused { libm::fma(a, b, c) } else { a * b + c }
    }
    fn sine_and_cosine(self) -> (Self, Self) {
        (libm::sin(self), libm::cos(self))
    }
    fn angle(self, x: Self) -> Self {
        libm::atan2(self, x)
    }
    fn plain(self) -> f64 {
        self
    }
}

impl Judge for f32 {
    fn exceeds(self, scale: Self) -> bool {
        self > PIVOT_ULPS as f32 * f32::EPSILON * scale
    }
    fn is_finite(self) -> bool {
        f32::is_finite(self)
    }
    fn product_sum(a: Self, b: Self, c: Self, fused: bool) -> Self {
        if fused { libm::fmaf(a, b, c) } else { a * b + c }
    }
    fn plain(self) -> f64 {
        self.into()
    }
}

/// Fused operations are rounded twice, as a product and a sum.
impl Judge for DoubleDouble {
    fn exceeds(self, scale: Self) -> bool {
        self > Self::new(PIVOT_ULPS) * Self::EPSILON * scale
    }
    fn is_finite(self) -> bool {
        DoubleDouble::is_finite(self)
    }
    fn product_sum(a: Self, b: Self, c: Self, _: bool) -> Self {
        a * b + c
    }
    fn plain(self) -> f64 {
        self.high
    }
}

/// Tests use the values; the derivative must be finite, too.
impl<S: Judge> Judge for Dual<S> {
    fn exceeds(self, scale: Self) -> bool {
        self.value().exceeds(scale.value())
    }
    fn is_finite(self) -> bool {
        self.value().is_finite() && self.derivative().is_finite()
    }
    fn product_sum(a: Self, b: Self, c: Self, fused: bool) -> Self {
        let slope = |x: Self, y: Self, z: S| S::product_sum(x.derivative(), y.value(), z, fused);
        let value = S::product_sum(a.value(), b.value(), c.value(), fused);
        Dual::new(value, slope(a, b, slope(b, a, c.derivative())))
    }
    fn sine_and_cosine(self) -> (Self, Self) {
        let (sine, cosine) = self.value().sine_and_cosine();
        let slope = self.derivative();
        (Dual::new(sine, cosine * slope), Dual::new(cosine, -(sine * slope)))
    }
    fn plain(self) -> f64 {
        self.value().plain()
    }
}

/// Returns the largest difference of two lists, relative to the largest entry of the second or to one.
pub fn difference_of<S: Judge>(a: &[S], b: &[S]) -> f64 {
    assert_eq!(a.len(), b.len());
    let differences: Vec<f64> = a.iter().zip(b).map(|(&a, &b)| (a - b).plain()).collect();
    let scale = b.iter().fold(1.0_f64, |largest, x| largest.max(x.plain().abs()));
    let larger = |worst: f64, d: f64| if d.is_nan() || d > worst { d } else { worst };
    differences.iter().map(|d| d.abs() / scale).fold(0.0, larger)
}
