//! Hinges in a row, without a body between them.

use crate::math::Vec3;
use crate::model::lower::{RouteItem, Spanned};
use crate::model::{HingeKind, Value};

/// Directions whose sine, or cosine, is less than this are parallel, or at a right angle.
const ALIKE: f64 = 1e-6;

type Vector = Vec3<f64>;

/// What to write in place of hinges in a row, as the end of a message.
pub(super) fn advice(hinges: &[RouteItem], defaults: &[Option<f64>]) -> String {
    match compound(hinges, defaults) {
        Some(kind) => format!("; write one hinge `{kind}` instead"),
        None => "; add a body there, with a small mass".into(),
    }
}

/// The kind that does what all of these do, if there is one.
fn compound(hinges: &[RouteItem], defaults: &[Option<f64>]) -> Option<&'static str> {
    let kinds: Option<Vec<&HingeKind>> = hinges
        .iter()
        .map(|item| match item {
            RouteItem::Hinge { hinge_kind: Some(Spanned { value, .. }), .. } => Some(value),
            _ => None,
        })
        .collect();
    let along = |axis| direction(axis, defaults);
    use HingeKind::{Pin, Slider};
    match kinds?[..] {
        [Pin { axis: a }, Pin { axis: b }] => {
            (along(a)?.dot(along(b)?).abs() < ALIKE).then_some("universal")
        }
        [Pin { axis: a }, Slider { axis: b }] | [Slider { axis: a }, Pin { axis: b }] => {
            (sine(along(a)?, along(b)?) < ALIKE).then_some("cylindrical")
        }
        [Pin { axis: a }, Pin { axis: b }, Pin { axis: c }] => {
            let (a, b, c) = (along(a)?, along(b)?, along(c)?);
            (a.dot(b.cross(c)).abs() > ALIKE).then_some("ball")
        }
        _ => None,
    }
}

/// An axis with its largest component 1, if it is known and has a direction; parameters count with
/// their defaults.
fn direction(axis: &[Value; 3], defaults: &[Option<f64>]) -> Option<Vector> {
    let [x, y, z] = axis.each_ref().map(|component| component.at(defaults));
    let axis = [x?, y?, z?];
    let largest = axis.iter().fold(0.0_f64, |largest, component| largest.max(component.abs()));
    (largest > 0.0 && largest.is_finite()).then(|| Vec3(axis.map(|component| component / largest)))
}

/// The sine of the angle between two directions.
fn sine(a: Vector, b: Vector) -> f64 {
    let length = |a: Vector| a.dot(a).sqrt();
    length(a.cross(b)) / (length(a) * length(b))
}
