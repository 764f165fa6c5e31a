//! Derivatives by central differences.

use super::Real;

/// The longer of the two steps; a power of two, so that it has no rounding error.
const STEP: f64 = 1.0 / (1 << 20) as f64;

/// Returns the derivative at zero of a smooth function: central differences with two steps, extrapolated
/// to a step of zero [Richardson].
///
/// The error is `h⁴/4` times a fifth derivative and the rounding error of the values over `h`: with
/// `h = 2⁻²⁰` and values with relative errors of 1e-31, about 1e-25 in functions whose
/// derivatives have the size of their values.
pub(super) fn derivative(function: impl Fn(Real) -> Vec<Real>) -> Vec<Real> {
    let difference = |step: f64| -> Vec<Real> {
        let (ahead, behind) = (function(Real::new(step)), function(Real::new(-step)));
        let scale = Real::new(0.5 / step);
        ahead.iter().zip(&behind).map(|(&a, &b)| (a - b) * scale).collect()
    };
    let (coarse, fine) = (difference(STEP), difference(0.5 * STEP));
    let third = Real::new(3.0).recip();
    fine.iter().zip(&coarse).map(|(&fine, &coarse)| fine + (fine - coarse) * third).collect()
}
