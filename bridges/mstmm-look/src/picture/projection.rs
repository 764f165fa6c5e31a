//! The projection of still pictures.

use crate::Mechanism;
use crate::rotation::{Vector, norm};
use mstmm_runtime::description::Dimension;

/// A parallel projection: the axes to the right, up and towards the viewer.
#[derive(Clone, Copy, Debug)]
pub struct Projection {
    right: Vector,
    above: Vector,
    back: Vector,
}

impl Projection {
    /// Returns the view of a mechanism: along −z in a plane or on a line, otherwise from the side and above, with
    /// gravity downwards.
    pub fn of(mechanism: &Mechanism) -> Self {
        if mechanism.dimension != Dimension::Space {
            let [right, above, back] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            return Projection { right, above, back };
        }
        let length = norm(mechanism.gravity);
        let up = match length > 0.0 {
            true => mechanism.gravity.map(|entry| -entry / length),
            false => [0.0, 0.0, 1.0],
        };
        let start = if up[0].abs() > 0.9 { [0.0, 0.0, 1.0] } else { [1.0, 0.0, 0.0] };
        let along = dot(start, up);
        let front = unit([0, 1, 2].map(|k| start[k] - along * up[k]));
        let side = cross(up, front);
        let ((sy, cy), (sp, cp)) = (0.75_f64.sin_cos(), 0.35_f64.sin_cos());
        let level = [0, 1, 2].map(|k| cy * front[k] + sy * side[k]);
        let back = [0, 1, 2].map(|k| cp * level[k] + sp * up[k]);
        let right = [0, 1, 2].map(|k| cy * side[k] - sy * front[k]);
        Projection { right, above: cross(back, right), back }
    }

    /// Returns a vector in the picture, whose second component points downwards.
    pub fn pixel(&self, vector: Vector) -> [f64; 2] {
        [dot(vector, self.right), -dot(vector, self.above)]
    }

    /// Returns the distance of a place towards the viewer.
    pub fn depth(&self, place: Vector) -> f64 {
        dot(place, self.back)
    }
}

fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(vector: Vector) -> Vector {
    let length = norm(vector);
    vector.map(|entry| entry / length)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The axes are a right-handed orthonormal frame, and what is above is drawn above.
    #[test]
    fn axes_are_orthonormal() {
        for gravity in [[0.0, 0.0, -9.81], [0.0, -9.8, 0.0], [-1.0, 0.0, 0.0], [1.0, -2.0, 3.0]] {
            let (dimension, name, docs) = (Dimension::Space, String::new(), String::new());
            let (bodies, points) = (Vec::new(), Vec::new());
            let (springs, axes) = (Vec::new(), Vec::new());
            let mechanism =
                Mechanism { name, docs, dimension, gravity, bodies, points, springs, axes };
            let Projection { right, above, back } = Projection::of(&mechanism);
            for (a, b, expected) in
                [(right, above, 0.0), (above, back, 0.0), (back, right, 0.0), (right, right, 1.0)]
            {
                assert!((dot(a, b) - expected).abs() < 1e-15 * 8.0);
            }
            assert!(norm([0, 1, 2].map(|k| cross(right, above)[k] - back[k])) < 1e-15 * 8.0);
            assert!(dot(above, gravity) < 0.0 && dot(right, gravity).abs() < 1e-14);
        }
    }
}
