//! Lengths of axes and quaternions, which are divided by the root of their squared lengths.

use super::Value;
use super::condition::{Bound, Condition, Requirement};
use crate::diag::SpanRange;

/// The largest squared length, and the inverse of the smallest. Between them no square, no inverse and no root overflows
/// or vanishes in `f32`.
const LARGEST_SQUARE: f64 = 1e30;
/// The bounds on the length, for messages.
pub(super) const BOUNDS: &str = "between 1e-15 and 1e15";

/// Axes are parallel if the sine of the angle between them is less than this.
const PARALLEL: f64 = 1e-6;

/// Returns the squared length.
pub(super) fn squared(components: &[Value]) -> Value {
    components
        .iter()
        .fold(Value::number(0.0), |sum, entry| sum.plus(entry.clone().times(entry.clone())))
}

/// Returns a value that is positive if the squared length is within the bounds, and negative or not finite if it is not.
pub(super) fn margin(square: Value) -> Value {
    let inverse = Value::number(1.0).over(square.clone());
    Value::number(LARGEST_SQUARE).minus(square).minus(inverse)
}

/// Returns a value that is positive unless the two axes are parallel.
pub(super) fn sine_margin([a, b]: [&[Value; 3]; 2]) -> Value {
    let products = a.iter().zip(b).map(|(a, b)| a.clone().times(b.clone()));
    let product = products.reduce(Value::plus).unwrap_or_else(|| Value::number(0.0));
    // The part of b perpendicular to a; its length is |b| times the sine of the angle between them.
    let along = product.over(squared(a));
    let [x, y, z] = [0, 1, 2].map(|index| {
        let along_a = a[index].clone().times(along.clone());
        b[index].clone().minus(along_a)
    });
    squared(&[x, y, z]).over(squared(b)).minus(Value::number(PARALLEL * PARALLEL))
}

/// Returns the requirement that the length is within the bounds. `of` is a name such as `an axis`.
pub(super) fn requirement(
    components: &[Value],
    at: SpanRange,
    of: &str,
    zero: &str,
) -> Requirement {
    let square = squared(components);
    let margin = margin(square.clone());
    let message = format!("the length of {of} must be {BOUNDS}");
    // Components that are not finite are reported as numbers.
    let finite = |component: &Value| Condition::silent(component.clone(), Bound::BeFinite, at);
    let mut conditions: Vec<Condition> = components.iter().map(finite).collect();
    conditions.extend([
        Condition::new(square, Bound::BePositive, at, zero),
        Condition::new(margin.clone(), Bound::BeFinite, at, message.clone()),
        Condition::new(margin, Bound::BePositive, at, message),
    ]);
    conditions
}

/// Scales known components to a largest one of ±1.
pub(super) fn scaled<const N: usize>(components: &[Value; N]) -> [Value; N] {
    let sizes = components.iter().map(|component| component.known().map(f64::abs));
    match sizes.reduce(|a, b| Some(a?.max(b?))).flatten() {
        Some(largest) if largest > 0.0 => {
            components.clone().map(|component| component.over(Value::number(largest)))
        }
        _ => components.clone(),
    }
}

/// Scales known components whose squared length is out of the bounds, so that all written lengths but zero are accepted.
pub(super) fn within_bounds<const N: usize>(components: [Value; N]) -> [Value; N] {
    match margin(squared(&components)).known() {
        Some(margin) if margin.is_finite() && margin > 0.0 => components,
        _ => scaled(&components),
    }
}
