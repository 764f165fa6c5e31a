//! The strains of the springs, dampers and rotors of a hinge, and their rates.

use crate::hinge::{Hinge, HingeKind};
use crate::rotation::{self, Mat3, Vec3};
use nalgebra::{DMatrix, DVector};

/// The strains of a hinge, one per rate.
pub(crate) struct Strains {
    /// The strains relative to rest; a rotation vector for rotations with a quaternion.
    pub(crate) relative: Vec<f64>,
    /// The coordinates, which are compared with limits.
    pub(crate) coordinates: Vec<f64>,
    /// The strain rates.
    pub(crate) rates: DVector<f64>,
    /// The derivative of the strain rates by the rates of the hinge, one column per rate.
    pub(crate) jacobian: DMatrix<f64>,
    /// The derivatives of the strain rates at constant rates of the hinge.
    pub(crate) bias: DVector<f64>,
}

impl Strains {
    /// Returns the strains of a hinge with the given coordinates and rates.
    pub(crate) fn new(hinge: &Hinge, q: &[f64], v: &[f64]) -> Strains {
        let rest = hinge.rest_coordinates();
        let (coordinates, relative) = if hinge.kind.has_quaternion() {
            let first = hinge.kind.linear().end;
            let turn = rotation::vector_between(&rest[first..first + 4], &q[first..first + 4]);
            let shifts = q[..first].iter().zip(&rest).map(|(a, b)| a - b);
            let shifted: Vec<f64> = q[..first].to_vec();
            let with_turn = |shifts: Vec<f64>| [shifts, turn.as_slice().to_vec()].concat();
            (with_turn(shifted), with_turn(shifts.collect()))
        } else {
            (q.to_vec(), q.iter().zip(&rest).map(|(a, b)| a - b).collect())
        };
        let (jacobian, bias) = match hinge.kind {
            HingeKind::Elastic => elastic(q, v),
            HingeKind::PlaneElastic => plane_elastic(q, v),
            _ => (DMatrix::identity(v.len(), v.len()), DVector::zeros(v.len())),
        };
        let rates = &jacobian * DVector::from_column_slice(v);
        Strains { relative, coordinates, rates, jacobian, bias }
    }
}

/// Returns the Jacobian and the bias of the strain rates of an elastic hinge.
///
/// The rates of the hinge follow from the strain rates by `v = K(q) q̇`. So `q̇ = K⁻¹ v`, and
/// `q̈ = K⁻¹ (v̇ - K̇ q̇)`.
fn elastic(q: &[f64], v: &[f64]) -> (DMatrix<f64>, DVector<f64>) {
    let (x, y, z) = (Vec3::x(), Vec3::y(), Vec3::z());
    let carried = Vec3::from_column_slice(&q[..3]);
    let about_z = rotation::about_axis(&z, q[5]);
    // Components of the frames after the rotations about z and y, in the outboard frame.
    let back_x = rotation::about_axis(&x, -q[3]);
    let back_y = rotation::about_axis(&y, -q[4]);
    let (y_out, z_out) = (back_x * y, back_x * (back_y * z));
    let spins = Mat3::from_columns(&[x, y_out, z_out]);

    let mut k = DMatrix::zeros(6, 6);
    k.fixed_view_mut::<3, 3>(0, 0).copy_from(&about_z);
    k.fixed_view_mut::<3, 1>(0, 5).copy_from(&z.cross(&(about_z * carried)));
    k.fixed_view_mut::<3, 3>(3, 3).copy_from(&spins);
    let jacobian = k.try_inverse().expect("the second angle is less than a right one");

    let rates = &jacobian * DVector::from_column_slice(v);
    let carried_rate = Vec3::new(rates[0], rates[1], rates[2]);
    let (rate_1, rate_2, rate_3) = (rates[3], rates[4], rates[5]);
    let of_offset = z.cross(&(about_z * carried_rate)) * (2.0 * rate_3)
        + z.cross(&z.cross(&(about_z * carried))) * (rate_3 * rate_3);
    let y_out_rate = -x.cross(&y_out) * rate_1;
    let z_out_rate = -x.cross(&z_out) * rate_1 - back_x * y.cross(&(back_y * z)) * rate_2;
    let of_spin = y_out_rate * rate_2 + z_out_rate * rate_3;
    let changes = DVector::from_iterator(6, of_offset.iter().chain(of_spin.iter()).copied());
    let bias = -(&jacobian * changes);
    (jacobian, bias)
}

/// Returns the Jacobian and the bias of an elastic hinge in a plane chain: an elastic hinge in space
/// that stays in the plane.
fn plane_elastic(q: &[f64], v: &[f64]) -> (DMatrix<f64>, DVector<f64>) {
    let in_space = |all: &[f64]| [all[0], all[1], 0.0, 0.0, 0.0, all[2]];
    let (jacobian, bias) = elastic(&in_space(q), &in_space(v));
    let kept = [0, 1, 5];
    (jacobian.select_rows(&kept).select_columns(&kept), bias.select_rows(&kept))
}
