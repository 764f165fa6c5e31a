//! Displacements between states, along the rates.
//!
//! Notation of a hinge: `p` position of the outboard origin along inboard axes, `R` rotation from outboard to inboard
//! components, `δ` displacement: that of `p`, then the rotation vector `ρ` of `R₀ᵀ R₁`, in outboard components. Other
//! translations and angles are their own displacements.

use super::hinge::{Dofs, Hinge};
use crate::Scalar;

/// Sets the displacement of a hinge from the coordinates `from` to the coordinates `to`.
pub(super) fn between<T: Scalar>(hinge: &Hinge, [from, to]: [&[T]; 2], displacement: &mut [T]) {
    let poses = [from, to].map(|q| Pose::of(hinge, q));
    if let [Some(from), Some(to)] = poses {
        copy(displacement, &from.displacement_to(&to));
        return;
    }
    let (mut from, mut to, mut displacement) = (from, to, displacement);
    for dofs in hinge.dofs() {
        let (a, b);
        (a, from) = split(from, dofs.coordinate_count());
        (b, to) = split(to, dofs.coordinate_count());
        let (out, rest) = displacement.split_at_mut(dofs.rate_count().min(displacement.len()));
        displacement = rest;
        match (quaternion(dofs, a), quaternion(dofs, b)) {
            (Some(a), Some(b)) => copy(out, &rotation_vector(product(conjugate(a), b))),
            _ => out.iter_mut().zip(a.iter().zip(b)).for_each(|(out, (&a, &b))| *out = b - a),
        }
    }
}

/// Displaces the coordinates of a hinge.
pub(super) fn displace<T: Scalar>(hinge: &Hinge, q: &mut [T], displacement: &[T]) {
    if let Some(pose) = Pose::of(hinge, q) {
        pose.displaced(displacement).store(q);
        return;
    }
    let (mut q, mut displacement) = (q, displacement);
    for dofs in hinge.dofs() {
        let (coordinates, rest) = q.split_at_mut(dofs.coordinate_count().min(q.len()));
        let change;
        q = rest;
        (change, displacement) = split(displacement, dofs.rate_count());
        match (quaternion(dofs, coordinates), change.first_chunk()) {
            (Some(before), Some(&vector)) => {
                copy(coordinates, &product(before, exponential(vector)));
            }
            _ => coordinates.iter_mut().zip(change).for_each(|(q, &change)| *q += change),
        }
    }
}

fn split<T>(values: &[T], count: usize) -> (&[T], &[T]) {
    values.split_at(count.min(values.len()))
}

fn copy<T: Scalar>(to: &mut [T], from: &[T]) {
    to.iter_mut().zip(from).for_each(|(to, &from)| *to = from);
}

fn quaternion<T: Scalar>(dofs: &Dofs, coordinates: &[T]) -> Option<[T; 4]> {
    coordinates.first_chunk().copied().filter(|_| dofs.has_quaternion())
}

/// Position and rotation of an elastic hinge, whose displacement is along axes that turn.
enum Pose<T> {
    /// In space: `p`, the quaternion of `R = A_z(θ₃) A_y(θ₂) A_x(θ₁)`, and the angles θ.
    Space([T; 3], [T; 4], [T; 3]),
    /// In a plane: `p` and θ.
    Plane([T; 2], T),
}

impl<T: Scalar> Pose<T> {
    /// Returns the pose at the coordinates Δ, θ of an elastic hinge: `p = A_z(θ₃) Δ`.
    fn of(hinge: &Hinge, q: &[T]) -> Option<Self> {
        if !hinge.is_elastic() {
            return None;
        }
        match *q {
            [x, y, z, roll, pitch, yaw] => {
                let [x, y] = turned([x, y], yaw);
                let angles = [roll, pitch, yaw];
                Some(Pose::Space([x, y, z], of_angles(angles), angles))
            }
            [x, y, angle] => Some(Pose::Plane(turned([x, y], angle), angle)),
            _ => None,
        }
    }

    fn displacement_to(&self, to: &Self) -> [T; 6] {
        let zero = T::default();
        match (self, to) {
            (Pose::Space(p, r, _), Pose::Space(to, to_r, _)) => {
                let [x, y, z] = rotation_vector(product(conjugate(*r), *to_r));
                [to[0] - p[0], to[1] - p[1], to[2] - p[2], x, y, z]
            }
            (Pose::Plane(p, angle), Pose::Plane(to, to_angle)) => {
                [to[0] - p[0], to[1] - p[1], *to_angle - *angle, zero, zero, zero]
            }
            _ => [zero; 6],
        }
    }

    fn displaced(self, displacement: &[T]) -> Self {
        match (self, displacement) {
            (Pose::Space([x, y, z], r, angles), &[dx, dy, dz, a, b, c]) => {
                let r = product(r, exponential([a, b, c]));
                Pose::Space([x + dx, y + dy, z + dz], r, angles_near(r, angles))
            }
            (Pose::Plane([x, y], angle), &[dx, dy, turn]) => {
                Pose::Plane([x + dx, y + dy], angle + turn)
            }
            (pose, _) => pose,
        }
    }

    fn store(&self, q: &mut [T]) {
        match *self {
            Pose::Space([x, y, z], _, [roll, pitch, yaw]) => {
                let [x, y] = turned([x, y], -yaw);
                copy(q, &[x, y, z, roll, pitch, yaw]);
            }
            Pose::Plane(position, angle) => {
                let [x, y] = turned(position, -angle);
                copy(q, &[x, y, angle]);
            }
        }
    }
}

/// Returns a vector in a plane, rotated by an angle.
fn turned<T: Scalar>([x, y]: [T; 2], angle: T) -> [T; 2] {
    let ([sin], [cos]) = T::sin_cos([angle]);
    [cos * x - sin * y, sin * x + cos * y]
}

/// Returns the quaternion of `A_z(θ₃) A_y(θ₂) A_x(θ₁)`.
fn of_angles<T: Scalar>(angles: [T; 3]) -> [T; 4] {
    let zero = T::default();
    let ([x, y, z], [cx, cy, cz]) = T::sin_cos(angles.map(|angle| angle * T::constant(0.5)));
    product([cz, zero, zero, z], product([cy, zero, y, zero], [cx, x, zero, zero]))
}

/// Returns the angles θ of `A_z(θ₃) A_y(θ₂) A_x(θ₁)`, with θ₁ and θ₃ within half a turn of those of `near`.
fn angles_near<T: Scalar>([w, x, y, z]: [T; 4], [roll, _, yaw]: [T; 3]) -> [T; 3] {
    let (one, two) = (T::constant(1.0), T::constant(2.0));
    let sine = two * (w * y - z * x);
    let square = one - sine * sine;
    let cosine = T::select(square.simd_gt(T::default()), square, T::default()).sqrt();
    let near = |sine: T, cosine: T, angle: T| {
        let ([s], [c]) = T::sin_cos([angle]);
        angle + (sine * c - cosine * s).atan2(cosine * c + sine * s)
    };
    [
        near(two * (w * x + y * z), one - two * (x * x + y * y), roll),
        sine.atan2(cosine),
        near(two * (w * z + x * y), one - two * (y * y + z * z), yaw),
    ]
}

fn conjugate<T: Scalar>([w, x, y, z]: [T; 4]) -> [T; 4] {
    [w, -x, -y, -z]
}

fn product<T: Scalar>([w, x, y, z]: [T; 4], [a, b, c, d]: [T; 4]) -> [T; 4] {
    [
        w * a - x * b - y * c - z * d,
        w * b + x * a + y * d - z * c,
        w * c - x * d + y * a + z * b,
        w * d + x * c - y * b + z * a,
    ]
}

/// Returns the rotation vector of a quaternion, of at most half a turn.
fn rotation_vector<T: Scalar>([w, x, y, z]: [T; 4]) -> [T; 3] {
    let zero = T::default();
    let sine = (x * x + y * y + z * z).sqrt();
    let angle = T::constant(2.0) * sine.atan2(w.abs());
    // 2 / w at rest, where the vector is zero. A quaternion and its opposite are one rotation.
    let factor = T::select(sine.simd_gt(zero), angle * sine.recip(), T::constant(2.0));
    let factor = factor.copysign(w);
    [x * factor, y * factor, z * factor]
}

/// Returns the quaternion of a rotation vector.
fn exponential<T: Scalar>([x, y, z]: [T; 3]) -> [T; 4] {
    let zero = T::default();
    let half = (x * x + y * y + z * z).sqrt() * T::constant(0.5);
    let ([sin], [cos]) = T::sin_cos([half]);
    let factor = T::select(half.simd_gt(zero), sin * half.recip(), T::constant(1.0));
    let factor = factor * T::constant(0.5);
    [cos, x * factor, y * factor, z * factor]
}
