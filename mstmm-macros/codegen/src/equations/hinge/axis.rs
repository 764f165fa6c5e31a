//! Axes of hinges: aligned frames, and rotations about an axis.

use crate::equations::SymbolValues;
use crate::math::{AxisRotation, Mat3, Scalar, Vec3};
use crate::model::Value;

/// Axes of which one lies along the hinge's axis.
pub struct Alignment<S> {
    /// The index of that axis.
    pub axis: usize,
    /// Whether the hinge's axis points in the negative direction of that axis.
    pub is_reversed: bool,
    /// Rotation from aligned axes to the axes of the hinge's frames.
    pub rotation: Mat3<S>,
}

impl<S: Scalar> Alignment<S> {
    /// Returns axes aligned with `axis`: the frame's own axes if `axis` is one of them.
    pub fn with(axis: &[Value; 3], values: &SymbolValues<S>) -> Self {
        let zero = [0, 1, 2].map(|k| axis[k].is_zero());
        if let Some(k) = (0..3).find(|&k| zero[(k + 1) % 3] && zero[(k + 2) % 3])
            && let Some(length) = axis[k].known()
        {
            return Alignment { axis: k, is_reversed: length < 0.0, rotation: Mat3::identity() };
        }
        // For an axis in a coordinate plane, a rotation about the plane's normal keeps most of the
        // matrix zero.
        let k = (0..3).find(|&k| !zero[k] && zero[(k + 2) % 3]).unwrap_or(2);
        let unit = values.unit(axis);
        Alignment { axis: k, is_reversed: false, rotation: basis_along(k, unit) }
    }

    /// Returns the hinge's axis in aligned axes.
    pub fn direction(&self) -> Vec3<S> {
        let unit = Vec3::unit(self.axis);
        if self.is_reversed { -unit } else { unit }
    }

    /// Returns another axis of the hinge as a unit vector in aligned axes.
    pub fn to_aligned(&self, axis: &[Value; 3], values: &SymbolValues<S>) -> Vec3<S> {
        self.rotation.transposed() * values.unit(axis)
    }

    /// Returns a rotation about the hinge's axis.
    pub fn rotation_by(&self, angle: S) -> AxisRotation<S> {
        let (sin, cos) = angle.sin_cos();
        AxisRotation { axis: self.axis, sin: if self.is_reversed { -sin } else { sin }, cos }
    }
}

/// Returns a rotation whose column `k` is `unit`, by a formula without branches and singularities:
/// T. Duff et al., Building an orthonormal basis, revisited, J. Computer Graphics Techniques 2017.
fn basis_along<S: Scalar>(k: usize, unit: Vec3<S>) -> Mat3<S> {
    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
    let (x, y, z) = (unit[i], unit[j], unit[k]);
    let sign = S::one().copysign(z);
    let a = -(sign + z).recip();
    let b = x * y * a;
    let columns = [
        (i, [S::one() + sign * x * x * a, sign * b, -(sign * x)]),
        (j, [b, sign + y * y * a, -y]),
        (k, [x, y, z]),
    ];
    let mut rotation = Mat3::zero();
    for (column, entries) in columns {
        for (row, entry) in [i, j, k].into_iter().zip(entries) {
            rotation.0[row][column] = entry;
        }
    }
    rotation
}

/// Returns the rotation about a unit vector by an angle with the given sine and cosine.
pub fn rotation_about_unit<S: Scalar>(axis: Vec3<S>, angle: (S, S)) -> Mat3<S> {
    let others = |k: usize| axis[(k + 1) % 3].vanishes() && axis[(k + 2) % 3].vanishes();
    match (0..3).find(|&k| others(k)) {
        // A unit vector along a coordinate axis is plus or minus that axis.
        Some(k) => Mat3::axis_rotation(k, (angle.0 * axis[k], angle.1)),
        None => rotation_about(axis, angle),
    }
}

/// Returns the same for a vector along no coordinate axis: `cos 1 + sin ẽ + (1 − cos) e eᵀ`.
fn rotation_about<S: Scalar>(unit: Vec3<S>, (sin, cos): (S, S)) -> Mat3<S> {
    let scaled = unit * (S::one() - cos);
    let outer = Mat3::from_fn(|i, j| scaled[i] * unit[j]);
    Mat3::identity() * cos + unit.skew() * sin + outer
}
