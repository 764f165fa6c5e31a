//! Advice for hinges without a body between them.

use crate::math::Vec3;
use crate::model::lower::{RouteItem, Spanned};
use crate::model::{HingeKind, Value};

/// Directions are parallel if the sine of their angle is less than this, and perpendicular if its
/// cosine is.
const ALIKE: f64 = 1e-6;

type Vector = Vec3<f64>;

/// Returns the end of a message: what to write instead of hinges in a row.
pub(super) fn advice(hinges: &[&RouteItem], defaults: &[Option<f64>]) -> String {
    let is_weld = |item: &&&RouteItem| match item {
        RouteItem::Hinge { hinge_kind: Some(kind), .. } => kind.value == HingeKind::Weld,
        _ => false,
    };
    if let Some(weld) = hinges.iter().find(is_weld).and_then(|weld| weld.name()) {
        return format!("; remove weld `{weld}`: it has no effect next to a hinge");
    }
    match compound(hinges, defaults) {
        Some(kind) => format!("; write one hinge `{kind}` instead"),
        None => "; add a body there, with a small mass".into(),
    }
}

/// Returns the kind of hinge that is equivalent to all of these, if there is one.
fn compound(hinges: &[&RouteItem], defaults: &[Option<f64>]) -> Option<&'static str> {
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
            let at_right_angles = a.dot(b).abs() < ALIKE && b.dot(c).abs() < ALIKE;
            let kind = if at_right_angles { "gimbal" } else { "ball" };
            (a.dot(b.cross(c)).abs() > ALIKE).then_some(kind)
        }
        _ => None,
    }
}

/// Scales an axis to a largest component of 1; `None` if it is unknown or zero. Parameters have
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
