//! The pose and the motion of the outboard frame of a hinge relative to the inboard frame.

use crate::chain::Dimension;
use crate::hinge::{Axis, HingeKind};
use crate::rotation::{self, Mat3, Vec3};
use nalgebra::{DVector, Matrix6, Matrix6xX, Vector6};
use std::f64::consts::TAU;

/// The velocity of the outboard origin, then the angular velocity of the outboard frame.
pub(crate) type Twist = Vector6<f64>;

/// The outboard frame of a hinge seen from the inboard frame, in inboard axes.
pub(crate) struct Relative {
    /// The rotation matrix from outboard to inboard components.
    pub(crate) rotation: Mat3,
    /// The outboard origin.
    pub(crate) offset: Vec3,
    /// One column for every rate: the twist if that rate is 1 and all others are 0.
    pub(crate) directions: Matrix6xX<f64>,
    /// The derivative of the twist at constant rates.
    pub(crate) bias: Twist,
}

impl HingeKind {
    /// Returns the floating base as a hinge from the inertial frame to the first body.
    pub(crate) fn of_base(dimension: Dimension) -> HingeKind {
        match dimension {
            Dimension::Space => HingeKind::Floating,
            Dimension::Plane => HingeKind::PlaneFloating,
            Dimension::Line => HingeKind::LineFloating,
        }
    }

    /// Returns the pose of the outboard frame for the given coordinates, and its motion subspace.
    pub(crate) fn relative(&self, q: &[f64], v: &[f64]) -> Relative {
        let (rotation, offset) = self.pose(q);
        let none = Vec3::zeros();
        let shift = |direction: Vec3| twist(direction, none);
        let turn = |direction: Vec3| twist(none, direction);
        let any = || [Vec3::x(), Vec3::y(), Vec3::z()];
        let in_outboard_axes = || any().map(|axis| turn(rotation * axis)).to_vec();
        let mut bias = Twist::zeros();
        let directions: Vec<Twist> = match self {
            HingeKind::Weld => Vec::new(),
            HingeKind::Pin { axis } => vec![turn(unit(axis))],
            HingeKind::Slider { axis } => vec![shift(unit(axis))],
            HingeKind::Screw { axis, pitch } => vec![twist(unit(axis) * *pitch, unit(axis))],
            HingeKind::Cylindrical { axis } => vec![shift(unit(axis)), turn(unit(axis))],
            HingeKind::Universal { first, second } => {
                let (first, second) = (unit(first), unit(second));
                let carried = rotation::about_axis(&first, q[0]) * second;
                // The second axis rotates with the first angle.
                bias = turn(first.cross(&carried) * (v[0] * v[1]));
                vec![turn(first), turn(carried)]
            }
            HingeKind::Gimbal { axes } => {
                let [first, second, third] = gimbal_axes(axes, q);
                let at = |i: usize, j: usize| v[i] * v[j];
                // Each axis rotates with the angles before it.
                bias = turn(
                    first.cross(&second) * at(0, 1)
                        + first.cross(&third) * at(0, 2)
                        + second.cross(&third) * at(1, 2),
                );
                vec![turn(first), turn(second), turn(third)]
            }
            HingeKind::Ball => in_outboard_axes(),
            HingeKind::Planar { normal } => planar_directions(*normal),
            HingeKind::PlaneFloating | HingeKind::PlaneElastic => planar_directions(Axis::Z),
            HingeKind::Floating | HingeKind::Elastic => {
                let shifts = any().map(shift);
                shifts.into_iter().chain(in_outboard_axes()).collect()
            }
            HingeKind::LineFloating | HingeKind::LineElastic => vec![shift(Vec3::x())],
        };
        let directions = Matrix6xX::from_fn(directions.len(), |row, k| directions[k][row]);
        Relative { rotation, offset, directions, bias }
    }

    /// Returns the rotation and the offset of the outboard frame.
    fn pose(&self, q: &[f64]) -> (Mat3, Vec3) {
        let still = Mat3::identity();
        let nowhere = Vec3::zeros();
        let about_z = |angle: f64| rotation::about_axis(&Vec3::z(), angle);
        match self {
            HingeKind::Weld => (still, nowhere),
            HingeKind::Pin { axis } => (rotation::about_axis(&unit(axis), q[0]), nowhere),
            HingeKind::Slider { axis } => (still, unit(axis) * q[0]),
            HingeKind::Screw { axis, pitch } => {
                (rotation::about_axis(&unit(axis), q[0]), unit(axis) * (pitch * q[0]))
            }
            HingeKind::Cylindrical { axis } => {
                (rotation::about_axis(&unit(axis), q[1]), unit(axis) * q[0])
            }
            HingeKind::Universal { first, second } => {
                let [first, second] = [(first, q[0]), (second, q[1])]
                    .map(|(axis, angle)| rotation::about_axis(&unit(axis), angle));
                (first * second, nowhere)
            }
            HingeKind::Gimbal { axes } => {
                let about = |k: usize| rotation::about_axis(&unit(&axes[k]), q[k]);
                (about(0) * about(1) * about(2), nowhere)
            }
            HingeKind::Ball => (rotation::from_quaternion(&q[..4]), nowhere),
            HingeKind::Planar { normal } => planar_pose(*normal, q),
            HingeKind::PlaneFloating => planar_pose(Axis::Z, q),
            HingeKind::PlaneElastic => (about_z(q[2]), about_z(q[2]) * Vec3::new(q[0], q[1], 0.0)),
            HingeKind::Floating => {
                (rotation::from_quaternion(&q[3..7]), Vec3::from_column_slice(&q[..3]))
            }
            HingeKind::Elastic => {
                let small =
                    rotation::about_axis(&Vec3::y(), q[4]) * rotation::about_axis(&Vec3::x(), q[3]);
                (about_z(q[5]) * small, about_z(q[5]) * Vec3::from_column_slice(&q[..3]))
            }
            HingeKind::LineFloating | HingeKind::LineElastic => (still, Vec3::x() * q[0]),
        }
    }

    /// Returns the coordinates for a pose of the outboard frame, which the hinge must allow up to a
    /// small error. Of all equivalent coordinates, those nearest to `near` are returned, so angles
    /// do not jump and quaternions do not change their sign.
    pub(crate) fn measure(&self, rotation: &Mat3, offset: &Vec3, near: &[f64]) -> Vec<f64> {
        let about = |axis: &Vec3, near: f64| {
            let angle = rotation::angle_about(axis, rotation);
            angle + TAU * ((near - angle) / TAU).round()
        };
        let quaternion = |near: &[f64]| rotation::to_quaternion(rotation, near);
        match self {
            HingeKind::Weld => Vec::new(),
            HingeKind::Pin { axis } | HingeKind::Screw { axis, .. } => {
                vec![about(&unit(axis), near[0])]
            }
            HingeKind::Slider { axis } => vec![unit(axis).dot(offset)],
            HingeKind::Cylindrical { axis } => {
                vec![unit(axis).dot(offset), about(&unit(axis), near[1])]
            }
            HingeKind::Universal { first, second } => {
                universal_angles(&unit(first), &unit(second), rotation, near)
            }
            HingeKind::Gimbal { axes } => gimbal_angles(axes, rotation, near),
            HingeKind::Ball => quaternion(near).to_vec(),
            HingeKind::Planar { normal } => {
                let [first, second] = planar_axes(*normal);
                let turned = about(&Vec3::ith(normal.index(), 1.0), near[2]);
                vec![first.dot(offset), second.dot(offset), turned]
            }
            HingeKind::PlaneFloating => vec![offset.x, offset.y, about(&Vec3::z(), near[2])],
            HingeKind::PlaneElastic => {
                let angle = about(&Vec3::z(), near[2]);
                let carried = rotation::about_axis(&Vec3::z(), -angle) * offset;
                vec![carried.x, carried.y, angle]
            }
            HingeKind::Floating => offset.iter().copied().chain(quaternion(&near[3..7])).collect(),
            HingeKind::Elastic => elastic_coordinates(rotation, offset, near[5]),
            HingeKind::LineFloating | HingeKind::LineElastic => vec![offset.x],
        }
    }
}

impl Relative {
    /// Returns the twist of the outboard frame for the given rates.
    pub(crate) fn twist(&self, v: &[f64]) -> Twist {
        &self.directions * DVector::from_column_slice(v)
    }

    /// Returns the rates with the twist closest to the given one (least squares).
    pub(crate) fn rates(&self, twist: &Twist) -> Vec<f64> {
        if self.directions.ncols() == 0 {
            return Vec::new();
        }
        let along = self.directions.transpose() * twist;
        let squares = self.directions.transpose() * &self.directions;
        let rates = squares.lu().solve(&along);
        rates.expect("the rates of a hinge are independent").as_slice().to_vec()
    }
}

/// Returns the unit vector along an axis.
pub(crate) fn unit(axis: &[f64; 3]) -> Vec3 {
    Vec3::from(*axis).normalize()
}

/// Puts together a twist.
pub(crate) fn twist(velocity: Vec3, spin: Vec3) -> Twist {
    Twist::new(velocity.x, velocity.y, velocity.z, spin.x, spin.y, spin.z)
}

/// Returns the matrix that transforms both parts of a twist from a frame's axes to inertial axes.
pub(crate) fn to_inertial(rotation: &Mat3) -> Matrix6<f64> {
    let mut both = Matrix6::zeros();
    both.fixed_view_mut::<3, 3>(0, 0).copy_from(rotation);
    both.fixed_view_mut::<3, 3>(3, 3).copy_from(rotation);
    both
}

/// Returns the two axes of a plane that follow its normal.
fn planar_axes(normal: Axis) -> [Vec3; 2] {
    [1, 2].map(|further| Vec3::ith((normal.index() + further) % 3, 1.0))
}

fn planar_directions(normal: Axis) -> Vec<Twist> {
    let [first, second] = planar_axes(normal);
    let none = Vec3::zeros();
    let turn = twist(none, Vec3::ith(normal.index(), 1.0));
    vec![twist(first, none), twist(second, none), turn]
}

fn planar_pose(normal: Axis, q: &[f64]) -> (Mat3, Vec3) {
    let [first, second] = planar_axes(normal);
    let rotation = rotation::about_axis(&Vec3::ith(normal.index(), 1.0), q[2]);
    (rotation, first * q[0] + second * q[1])
}

/// Returns the two angles of a universal hinge.
fn universal_angles(first: &Vec3, second: &Vec3, rotation: &Mat3, near: &[f64]) -> Vec<f64> {
    let on = |angle: f64, near: f64| angle + TAU * ((near - angle) / TAU).round();
    // The second axis depends only on the first angle.
    let carried = rotation * second;
    let across = second - first * first.dot(second);
    let first_angle = first.cross(&across).dot(&carried).atan2(across.dot(&carried));
    let rest = rotation::about_axis(first, -first_angle) * rotation;
    vec![on(first_angle, near[0]), on(rotation::angle_about(second, &rest), near[1])]
}

/// Returns the axes of a gimbal in a position, in inboard components.
fn gimbal_axes(axes: &[[f64; 3]; 3], q: &[f64]) -> [Vec3; 3] {
    let [first, second, third] = axes.map(|axis| unit(&axis));
    let outer = rotation::about_axis(&first, q[0]);
    let inner = outer * rotation::about_axis(&second, q[1]);
    [first, outer * second, inner * third]
}

/// Returns how far the axes of a gimbal are from one plane: the volume between them relative to the
/// largest one at other angles, from zero to one.
pub(crate) fn gimbal_regularity(axes: &[[f64; 3]; 3], q: &[f64]) -> f64 {
    let [first, second, third] = gimbal_axes(axes, q);
    let largest = first.cross(&second).norm() * second.cross(&third).norm();
    first.dot(&second.cross(&third)).abs() / largest
}

/// Returns the three angles of a gimbal.
///
/// The angle between the first and the third axis depends only on the second angle, and has each of its
/// values at two of them.
fn gimbal_angles(axes: &[[f64; 3]; 3], rotation: &Mat3, near: &[f64]) -> Vec<f64> {
    let on = |angle: f64, near: f64| angle + TAU * ((near - angle) / TAU).round();
    let [first, second, third] = axes.map(|axis| unit(&axis));
    let carried = rotation * third;
    // first · third = along + across cos(angle) + beyond sin(angle)
    let along = first.dot(&second) * second.dot(&third);
    let (across, beyond) = (first.dot(&third) - along, first.dot(&second.cross(&third)));
    let middle = beyond.atan2(across);
    let cosine = (first.dot(&carried) - along) / across.hypot(beyond);
    let half = cosine.clamp(-1.0, 1.0).acos();
    let angles = |second_angle: f64| {
        let inner = rotation::about_axis(&second, second_angle);
        let start = inner * third;
        let [from, to] = [start, carried].map(|axis| axis - first * first.dot(&axis));
        let first_angle = first.dot(&from.cross(&to)).atan2(from.dot(&to));
        let outer = rotation::about_axis(&first, first_angle);
        let rest = (outer * inner).transpose() * rotation;
        let third_angle = rotation::angle_about(&third, &rest);
        [first_angle, second_angle, third_angle]
    };
    let both = [middle - half, middle + half].map(|second_angle| {
        let angles = angles(second_angle);
        let nearest: Vec<f64> = angles.iter().zip(near).map(|(&a, &near)| on(a, near)).collect();
        let distance: f64 = nearest.iter().zip(near).map(|(a, b)| (a - b).powi(2)).sum();
        (nearest, distance)
    });
    let [(one, to_one), (other, to_other)] = both;
    if to_one < to_other { one } else { other }
}

/// Returns Δ and the angles of an elastic hinge.
fn elastic_coordinates(rotation: &Mat3, offset: &Vec3, near: f64) -> Vec<f64> {
    let about_x = rotation[(2, 1)].atan2(rotation[(2, 2)]);
    let about_y = (-rotation[(2, 0)]).atan2(rotation[(2, 1)].hypot(rotation[(2, 2)]));
    let about_z = rotation[(1, 0)].atan2(rotation[(0, 0)]);
    let about_z = about_z + TAU * ((near - about_z) / TAU).round();
    let carried = rotation::about_axis(&Vec3::z(), -about_z) * offset;
    vec![carried.x, carried.y, carried.z, about_x, about_y, about_z]
}
