//! Inertia tensors.

use crate::diag::Diagnostics;
use crate::model::lower::{BodyType, Draft};
use crate::model::{About, Dimension, Inertia, Value};

/// How far below zero a second moment may be against the trace of the tensor. Thin rods and flat
/// plates have second moments of zero, and tensors are often written with two decimals only: this
/// is what rounding `0.703…` to `0.70` amounts to.
const TOLERANCE: f64 = 5e-3;

/// Symmetric: xx, yy, zz, xy, xz, yz.
type Tensor = [f64; 6];

/// No moment of inertia is negative; parameters count with their defaults.
pub(super) fn moments_are_not_negative(draft: &Draft, diagnostics: &mut Diagnostics) {
    let defaults = draft.defaults();
    for body in &draft.types {
        let Some(inertia) = &body.inertia else { continue };
        for (index, moment) in inertia.value.tensor[..3].iter().enumerate() {
            if is_negative(moment, &defaults) {
                let at = body.inertia_entry(index).unwrap_or(inertia.at);
                diagnostics.error_over(at, "a moment of inertia cannot be negative");
            }
        }
    }
}

fn is_negative(value: &Value, defaults: &[Option<f64>]) -> bool {
    value.at(defaults).is_some_and(|value| value < 0.0)
}

/// A real body has mass nowhere less than zero, so its second moments `∫ x xᵀ dm = ½ tr(J) 1 − J`
/// are positive or zero in all directions. That is the triangle inequality of its principal
/// moments. It holds about any point, and about the centre of mass it is the sharpest.
pub(super) fn inertias_are_those_of_real_bodies(draft: &Draft, diagnostics: &mut Diagnostics) {
    let defaults = draft.defaults();
    for body in &draft.types {
        let Some(inertia) = &body.inertia else { continue };
        let Some(tensor) = known(&inertia.value.tensor, &defaults) else { continue };
        if inertia.value.tensor[..3].iter().any(|moment| is_negative(moment, &defaults)) {
            continue;
        }
        let slack = TOLERANCE * trace(&tensor);
        if !is_real(draft.space, &tensor, slack) {
            let message = "no body has this inertia: \
                           a principal moment is more than the sum of the other two";
            diagnostics.error_over(inertia.at, message);
        } else if let Some(central) = about_com(body, &inertia.value, tensor, &defaults)
            && !is_real(draft.space, &central, central_slack(&central, &tensor))
        {
            let message = "no body with this mass and centre of mass has so little inertia \
                           about its input; is it `about com`?";
            diagnostics.error_over(inertia.at, message);
        }
    }
}

fn known<const N: usize>(values: &[Value; N], defaults: &[Option<f64>]) -> Option<[f64; N]> {
    let numbers: Option<Vec<f64>> = values.iter().map(|value| value.at(defaults)).collect();
    numbers?.try_into().ok()
}

/// A tensor about a far input is mostly that of its mass in a point, and only what is left of it
/// has the digits written; the difference itself is exact but for rounding.
fn central_slack(central: &Tensor, about_input: &Tensor) -> f64 {
    TOLERANCE * trace(central).max(0.0) + 1e-9 * trace(about_input)
}

fn trace(tensor: &Tensor) -> f64 {
    tensor[0] + tensor[1] + tensor[2]
}

/// The tensor of the input shifted to the centre of mass, `J_C = J_I − m (cᵀc 1 − c cᵀ)`, if the
/// mass is known and where it is.
fn about_com(
    body: &BodyType,
    inertia: &Inertia,
    tensor: Tensor,
    defaults: &[Option<f64>],
) -> Option<Tensor> {
    if inertia.about == About::Com {
        return None;
    }
    let mass = body.mass.as_ref()?.value.at(defaults).filter(|mass| *mass > 0.0)?;
    let [x, y, z] = known(&body.com.as_ref()?.value, defaults)?;
    let steiner = [y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z];
    let mut central = tensor;
    for (entry, steiner) in central.iter_mut().zip(steiner) {
        *entry -= mass * steiner;
    }
    Some(central)
}

/// Whether a body can have this tensor. In a plane nothing is known but its entry about z.
fn is_real(space: Dimension, tensor: &Tensor, slack: f64) -> bool {
    match space {
        Dimension::Space => has_second_moments(tensor, slack),
        Dimension::Plane | Dimension::Line => tensor[2] + slack >= 0.0,
    }
}

/// Whether `½ tr(J) 1 − J + slack 1` is positive definite: whether its pivots are positive. The
/// slack keeps them away from zero where the second moments themselves are not.
fn has_second_moments(tensor: &Tensor, slack: f64) -> bool {
    if tensor.iter().all(|&entry| entry == 0.0) {
        // A mass in a point.
        return true;
    }
    let [xx, yy, zz, xy, xz, yz] = *tensor;
    let half = trace(tensor) / 2.0 + slack;
    let first = half - xx;
    let second = half - yy - xy * xy / first;
    let across = -yz - xy * xz / first;
    let third = half - zz - xz * xz / first - across * across / second;
    first > 0.0 && second > 0.0 && third > 0.0
}

#[cfg(test)]
mod tests {
    use super::{TOLERANCE, has_second_moments, trace};

    fn is_real(tensor: [f64; 6]) -> bool {
        has_second_moments(&tensor, TOLERANCE * trace(&tensor))
    }

    #[test]
    fn the_triangle_inequality_holds_in_any_axes() {
        assert!(is_real([1.0, 1.0, 0.0, 0.0, 0.0, 0.0]), "a thin rod");
        assert!(is_real([0.1, 0.2, 0.1 + 0.2, 0.0, 0.0, 0.0]), "a plate");
        assert!(!is_real([1.0, 1.0, 2.1, 0.0, 0.0, 0.0]));
        // The plate (1, 2, 3) turned by 45° about z, then one that is a little too flat.
        assert!(is_real([1.5, 1.5, 3.0, 0.5, 0.0, 0.0]));
        assert!(!is_real([1.5, 1.5, 3.2, 0.5, 0.0, 0.0]));
        // A rod along (1, 1, 1): trace 2, the tensor is 1 − n nᵀ.
        let (on, off) = (2.0 / 3.0, -1.0 / 3.0);
        assert!(is_real([on, on, on, off, off, off]));
        assert!(!is_real([on, on, on, -off, off, off]));
    }
}
