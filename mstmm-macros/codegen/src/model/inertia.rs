//! Inertia tensors that a real body can have.

use std::f64::consts::PI;

use super::{About, Dimension, Inertia, Value};

/// How far below zero a second moment may be, relative to the trace of the tensor. Thin rods and
/// flat plates have second moments of zero, and tensors are often written with two decimals: this
/// is the error of rounding `0.703…` to `0.70`.
const TOLERANCE: f64 = 5e-3;

/// The same about the centre of mass, relative to the trace of a tensor that is written about the
/// input with three digits.
const TOLERANCE_ABOUT_INPUT: f64 = 5e-4;

/// Symmetric: xx, yy, zz, xy, xz, yz.
type Tensor = [Value; 6];

impl Inertia {
    /// Returns the values that are not negative if a body can have this inertia. The mass density
    /// of a real body is nowhere negative, so its second moments `∫ x xᵀ dm = ½ tr(J) 1 − J` are
    /// not negative in any direction. This is the triangle inequality of its principal moments,
    /// about any point.
    pub fn signs(&self, space: Dimension) -> Vec<Value> {
        let slack = Value::number(TOLERANCE).times(trace(space, &self.tensor));
        minors(space, &self.tensor, slack)
    }

    /// Returns the same about the centre of mass, where it is the sharpest; nothing if the tensor
    /// is about that point already.
    pub fn central_signs(&self, space: Dimension, mass: &Value, com: &[Value; 3]) -> Vec<Value> {
        if self.about == About::Com {
            return Vec::new();
        }
        let central = about_com(&self.tensor, mass, com);
        let slack = Value::number(TOLERANCE).times(trace(space, &central));
        let slack_about_input =
            Value::number(TOLERANCE_ABOUT_INPUT).times(trace(space, &self.tensor));
        minors(space, &central, slack.plus(slack_about_input))
    }

    /// Returns the principal moments, beginning with the smallest; `None` if an entry is not known
    /// while compiling. The eigenvalues of a symmetric matrix by cosines: O. K. Smith, Communications
    /// of the ACM 4 (1961) 168.
    pub fn principal_moments(&self) -> Option<[f64; 3]> {
        let mut entries = [0.0; 6];
        for (entry, value) in entries.iter_mut().zip(&self.tensor) {
            *entry = value.known()?;
        }
        let [xx, yy, zz, xy, xz, yz] = entries;
        let mean = (xx + yy + zz) / 3.0;
        let [a, b, c] = [xx, yy, zz].map(|moment| moment - mean);
        let products = xy * xy + xz * xz + yz * yz;
        let radius = ((a * a + b * b + c * c + 2.0 * products) / 6.0).sqrt();
        if radius == 0.0 {
            return Some([mean; 3]);
        }
        let determinant = a * b * c + 2.0 * xy * xz * yz - a * yz * yz - b * xz * xz - c * xy * xy;
        let angle = (determinant / (2.0 * radius.powi(3))).clamp(-1.0, 1.0).acos() / 3.0;
        let largest = mean + 2.0 * radius * angle.cos();
        let smallest = mean + 2.0 * radius * (angle + 2.0 * PI / 3.0).cos();
        Some([smallest, 3.0 * mean - largest - smallest, largest])
    }
}

fn trace(space: Dimension, [xx, yy, zz, ..]: &Tensor) -> Value {
    match space {
        Dimension::Space => xx.clone().plus(yy.clone()).plus(zz.clone()),
        Dimension::Plane | Dimension::Line => zz.clone(),
    }
}

/// Shifts the tensor from the input to the centre of mass, `J_C = J_I − m (cᵀc 1 − c cᵀ)`.
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
    std::array::from_fn(|k| tensor[k].clone().minus(mass.clone().times(steiner[k].clone())))
}

/// Returns the principal minors of the second moments `½ tr(J) 1 − J + slack 1`, which are not
/// negative for a real body. In a plane chain it is the moment itself.
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
    use super::{About, Dimension, Inertia, TOLERANCE, Value, minors, trace};

    #[test]
    fn principal_moments_are_those_of_the_unrotated_body() {
        let moments = |tensor: [f64; 6]| {
            let inertia = Inertia { tensor: tensor.map(Value::number), about: About::Com };
            inertia.principal_moments().expect("known moments")
        };
        // (1, 2, 3) rotated by 45° about z; a rod along (1, 1, 1); a ball; a tensor of no body.
        let (on, off) = (2.0 / 3.0, -1.0 / 3.0);
        for (tensor, expected) in [
            ([1.5, 1.5, 3.0, 0.5, 0.0, 0.0], [1.0, 2.0, 3.0]),
            ([on, on, on, off, off, off], [0.0, 1.0, 1.0]),
            ([2.0, 2.0, 2.0, 0.0, 0.0, 0.0], [2.0; 3]),
            ([0.0, 0.0, 0.0, 1.0, 0.0, 0.0], [-1.0, 0.0, 1.0]),
        ] {
            for (found, expected) in moments(tensor).into_iter().zip(expected) {
                // The arc cosine of a double eigenvalue loses half the digits.
                assert!((found - expected).abs() < 1e-7, "{found} {expected}");
            }
        }
    }

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
        // The plate (1, 2, 3) rotated by 45° about z, then a plate that is slightly too flat.
        assert!(is_real([1.5, 1.5, 3.0, 0.5, 0.0, 0.0]));
        assert!(!is_real([1.5, 1.5, 3.2, 0.5, 0.0, 0.0]));
        // A rod along (1, 1, 1): trace 2, the tensor is 1 − n nᵀ.
        let (on, off) = (2.0 / 3.0, -1.0 / 3.0);
        assert!(is_real([on, on, on, off, off, off]));
        assert!(!is_real([on, on, on, -off, off, off]));
    }
}
