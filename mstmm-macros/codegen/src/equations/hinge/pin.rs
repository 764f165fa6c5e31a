//! Pin: turns about an axis `ζ` fixed on both sides [P, Sect. 3.3].
//!
//! Coordinate: the angle `Θ` in rad by which the outboard frame is turned against the inboard one,
//! right-handed about `ζ`. Aligned axes have one coordinate axis along `ζ`: the moment along it is
//! then a single number, `H_2 Aᵀ m = 0` of [P, Eq. (35)].

use super::{Column, Crossing, Freedom, WorkAxes};
use crate::equations::Numbers;
use crate::math::{Mat3, Motion, Scalar, Turn, Vec3};
use crate::model::Value;

/// Axes one of which is the pin's.
pub struct Alignment<S> {
    /// Which of the aligned axes lies along the pin's.
    pub axis: usize,
    /// Whether it points the opposite way.
    pub opposite: bool,
    /// Aligned axes to those of the hinge's frames.
    pub rotation: Mat3<S>,
}

/// Axes aligned with a pin; the frame's own where its axis is one of them.
pub fn alignment<S: Scalar>(axis: &[Value; 3], numbers: &Numbers<S>) -> Alignment<S> {
    let zero = [0, 1, 2].map(|k| axis[k].is_zero());
    if let Some(k) = (0..3).find(|&k| zero[(k + 1) % 3] && zero[(k + 2) % 3])
        && let Some(length) = axis[k].known()
    {
        return Alignment { axis: k, opposite: length < 0.0, rotation: Mat3::identity() };
    }
    // An axis in a coordinate plane: turning the plane leaves most of the matrix zero.
    let k = (0..3).find(|&k| !zero[k] && zero[(k + 2) % 3]).unwrap_or(2);
    let axis = numbers.vector(axis);
    let unit = axis * axis.dot(axis).sqrt().recip();
    Alignment { axis: k, opposite: false, rotation: frame_along(k, unit) }
}

/// A rotation whose column `k` is `unit`, by a formula without a branch or a singular place:
/// T. Duff et al., Building an orthonormal basis, revisited, J. Computer Graphics Techniques 2017.
fn frame_along<S: Scalar>(k: usize, unit: Vec3<S>) -> Mat3<S> {
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

/// A turn about the axis.
pub fn crossing<S: Scalar>(axis: &[Value; 3], numbers: &Numbers<S>, q: &[S]) -> Crossing<S> {
    let Alignment { axis, opposite, .. } = alignment(axis, numbers);
    let (sin, cos) = q[0].sin_cos();
    let turn = Turn { axis, sin: if opposite { -sin } else { sin }, cos };
    Crossing { rotation: turn.matrix(), turn: Some(turn), offset: Vec3::zero() }
}

/// Turns about the axis are free: `Ω_O = Ω_I + A_O ω_r` [P, Eq. (36)].
pub fn freedom<S: Scalar>(
    axis: &[Value; 3],
    numbers: &Numbers<S>,
    axes: WorkAxes<S>,
    reversed: bool,
) -> Freedom<S> {
    let Alignment { axis, opposite, .. } = alignment(axis, numbers);
    let column = if axes.aligned {
        Column::Axis(3 + axis)
    } else {
        let angular = axes.from_child.column(axis);
        Column::General(Motion { linear: Vec3::zero(), angular })
    };
    let sign = if opposite == reversed { S::one() } else { -S::one() };
    Freedom { columns: vec![column], basis: vec![vec![sign]] }
}

/// The rate of the angle.
pub fn coordinate_rates<S: Scalar>(v: &[S]) -> Vec<S> {
    v.to_vec()
}
