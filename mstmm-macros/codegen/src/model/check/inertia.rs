//! Inertia tensors.

use crate::model::condition::{Condition, Must, Requirement};
use crate::model::lower::{BodyType, Draft, Given};
use crate::model::{About, Dimension, Inertia, Value};

/// How far below zero a second moment may be against the trace of the tensor. Thin rods and flat
/// plates have second moments of zero, and tensors are often written with two decimals only: this
/// is what rounding `0.703…` to `0.70` amounts to.
const TOLERANCE: f64 = 5e-3;

/// The same about the centre of mass, against the trace of a tensor that is written about the input:
/// three digits of it.
const TOLERANCE_ABOUT_INPUT: f64 = 5e-4;

/// Symmetric: xx, yy, zz, xy, xz, yz.
type Tensor = [Value; 6];

/// No moment of inertia is negative.
pub(super) fn moments_are_not_negative(draft: &Draft) -> Vec<Requirement> {
    let moments = draft.types.iter().filter_map(|body| {
        let inertia = body.inertia.as_ref()?;
        let moments = inertia.value.tensor[..3].iter().enumerate();
        Some(moments.map(move |(index, moment)| {
            let at = body.inertia_entry(index).unwrap_or(inertia.at);
            let message = "a moment of inertia cannot be negative";
            vec![Condition::new(moment.clone(), Must::NotBeNegative, at, message).shown("kg*m^2")]
        }))
    });
    moments.flatten().collect()
}

/// A real body has mass nowhere less than zero, so its second moments `∫ x xᵀ dm = ½ tr(J) 1 − J`
/// are positive or zero in all directions. That is the triangle inequality of its principal
/// moments. It holds about any point, and about the centre of mass it is the sharpest.
pub(super) fn inertias_are_those_of_real_bodies(draft: &Draft) -> Vec<Requirement> {
    let bodies = draft.types.iter();
    bodies.filter_map(|body| Some(real(draft.space, body, body.inertia.as_ref()?))).collect()
}

fn real(space: Dimension, body: &BodyType, inertia: &Given<Inertia>) -> Requirement {
    let tensor = &inertia.value.tensor;
    let silent = |value: &Value, must: Must| Condition::silent(value.clone(), must, inertia.at);
    let mut conditions: Requirement =
        tensor[..3].iter().map(|moment| silent(moment, Must::NotBeNegative)).collect();
    let mut require = |tensor: &Tensor, slack: Value, message: &str| {
        let condition = |value| Condition::new(value, Must::NotBeNegative, inertia.at, message);
        conditions.extend(minors(space, tensor, slack).into_iter().map(condition));
    };
    let slack = Value::number(TOLERANCE).times(trace(space, tensor));
    let message = "no body has this inertia: \
                   a principal moment is more than the sum of the other two";
    require(tensor, slack, message);
    if let (About::Input, Some(mass), Some(com)) = (inertia.value.about, &body.mass, &body.com) {
        let central = about_com(tensor, &mass.value, &com.value);
        let slack = Value::number(TOLERANCE).times(trace(space, &central));
        let slack = slack.plus(Value::number(TOLERANCE_ABOUT_INPUT).times(trace(space, tensor)));
        let message = "no body with this mass and centre of mass has so little inertia \
                       about its input; is it `about com`?";
        require(&central, slack, message);
    }
    conditions
}

/// The sum of all moments. In a plane nothing is known but that about z.
fn trace(space: Dimension, [xx, yy, zz, ..]: &Tensor) -> Value {
    match space {
        Dimension::Space => xx.clone().plus(yy.clone()).plus(zz.clone()),
        Dimension::Plane | Dimension::Line => zz.clone(),
    }
}

/// The tensor of the input shifted to the centre of mass, `J_C = J_I − m (cᵀc 1 − c cᵀ)`.
fn about_com(tensor: &Tensor, mass: &Value, com: &[Value; 3]) -> Tensor {
    let product = |a: usize, b: usize| com[a].clone().times(com[b].clone());
    let steiner = [
        product(1, 1).plus(product(2, 2)),
        product(0, 0).plus(product(2, 2)),
        product(0, 0).plus(product(1, 1)),
        product(0, 1).negated(),
        product(0, 2).negated(),
        product(1, 2).negated(),
    ];
    let mut entries = steiner.into_iter().zip(tensor);
    [(); 6].map(|()| {
        let (steiner, entry) = entries.next().expect("six entries of both");
        entry.clone().minus(mass.clone().times(steiner))
    })
}

/// What must not be negative for a body to have this tensor: all principal minors of its second
/// moments `½ tr(J) 1 − J + slack 1`. In a plane the moment itself.
fn minors(space: Dimension, tensor: &Tensor, slack: Value) -> Vec<Value> {
    let [xx, yy, zz, xy, xz, yz] = tensor.clone();
    if space != Dimension::Space {
        return vec![zz.plus(slack)];
    }
    let half = trace(space, tensor).times(Value::number(0.5)).plus(slack);
    let [a, b, c] = [xx, yy, zz].map(|moment| half.clone().minus(moment));
    let times = |a: &Value, b: &Value| a.clone().times(b.clone());
    let minor = |a: &Value, b: &Value, off: &Value| times(a, b).minus(times(off, off));
    // With the off-diagonal entries −xy, −xz and −yz.
    let product = times(&xy, &xz).times(yz.clone());
    let determinant = times(&a, &b)
        .times(c.clone())
        .minus(product.clone().plus(product))
        .minus(times(&a, &times(&yz, &yz)))
        .minus(times(&b, &times(&xz, &xz)))
        .minus(times(&c, &times(&xy, &xy)));
    let pairs = [minor(&a, &b, &xy), minor(&a, &c, &xz), minor(&b, &c, &yz)];
    [a, b, c].into_iter().chain(pairs).chain([determinant]).collect()
}

#[cfg(test)]
mod tests {
    use super::{Dimension, TOLERANCE, Value, minors, trace};

    fn is_real(tensor: [f64; 6]) -> bool {
        let tensor = tensor.map(Value::number);
        let slack = Value::number(TOLERANCE).times(trace(Dimension::Space, &tensor));
        let minors = minors(Dimension::Space, &tensor, slack);
        minors.iter().all(|minor| minor.known().is_some_and(|minor| minor >= 0.0))
    }

    #[test]
    fn the_triangle_inequality_holds_in_any_axes() {
        assert!(is_real([0.0; 6]), "a mass in a point");
        assert!(is_real([1.0, 1.0, 0.0, 0.0, 0.0, 0.0]), "a thin rod");
        assert!(is_real([0.1, 0.2, 0.1 + 0.2, 0.0, 0.0, 0.0]), "a plate");
        assert!(!is_real([1.0, 1.0, 2.1, 0.0, 0.0, 0.0]));
        assert!(!is_real([0.0, 0.0, 0.0, 1.0, 0.0, 0.0]));
        // The plate (1, 2, 3) turned by 45° about z, then one that is a little too flat.
        assert!(is_real([1.5, 1.5, 3.0, 0.5, 0.0, 0.0]));
        assert!(!is_real([1.5, 1.5, 3.2, 0.5, 0.0, 0.0]));
        // A rod along (1, 1, 1): trace 2, the tensor is 1 − n nᵀ.
        let (on, off) = (2.0 / 3.0, -1.0 / 3.0);
        assert!(is_real([on, on, on, off, off, off]));
        assert!(!is_real([on, on, on, -off, off, off]));
    }
}
