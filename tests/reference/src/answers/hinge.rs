//! The pose of the outboard frame of a hinge, and the strains of its springs, dampers and rotors.

use super::jet::Jet;
use super::linear::solved;
use super::space::{
    Matrix, Number, Pose, Vector, about, constant, from_quaternion, moving, norm, product,
    rotating, scaled, times,
};
use super::{Real, reals};
use crate::hinge::{Axis, HingeKind};

/// The coordinates of a hinge, its rates and their derivatives.
#[derive(Clone, Debug)]
pub(super) struct Motion {
    pub(super) q: Vec<Real>,
    pub(super) v: Vec<Real>,
    pub(super) a: Vec<Real>,
}

fn unit(axis: &[f64; 3]) -> Vector<Jet> {
    let axis = axis.map(Real::new);
    constant(scaled(axis, norm(axis).recip()))
}

fn ith(k: usize) -> Vector<Jet> {
    std::array::from_fn(|row| <Jet as Number>::constant(f64::from(u8::from(row == k))))
}

fn turned(rotation: Matrix<Jet>) -> Pose {
    Pose { rotation, ..Pose::identity() }
}

/// Returns the pose of the outboard frame in the inboard frame.
pub(super) fn pose(kind: &HingeKind, motion: &Motion) -> Pose {
    let Motion { q, v, a } = motion;
    if has_rates_of_its_frame(kind) {
        let still = coordinate_pose(kind, &q.iter().map(|&q| Jet::constant(q)).collect::<Vec<_>>());
        return with_rates(kind, &still, v, a);
    }
    let jets: Vec<Jet> = (0..q.len()).map(|k| Jet::new(q[k], v[k], a[k])).collect();
    coordinate_pose(kind, &jets)
}

/// Whether the rates are not the derivatives of the coordinates.
fn has_rates_of_its_frame(kind: &HingeKind) -> bool {
    kind.has_quaternion() || matches!(kind, HingeKind::Elastic | HingeKind::PlaneElastic)
}

/// Gives a pose the derivative of its position and its angular velocity in outboard axes.
fn with_rates(kind: &HingeKind, still: &Pose, v: &[Real], a: &[Real]) -> Pose {
    let values = |rates: &[Real]| -> [Vector; 2] {
        let mut both = [[Real::new(0.0); 3]; 2];
        for (direction, &rate) in directions(kind).iter().zip(rates) {
            both[direction / 3][direction % 3] = rate;
        }
        both
    };
    let ([velocity, spin], [acceleration, change]) = (values(v), values(a));
    let rotation = still.rotation.map(|row| row.map(|entry| entry.value));
    Pose {
        position: moving(still.position.map(|entry| entry.value), velocity, acceleration),
        rotation: rotating(rotation, spin, change),
    }
}

/// Returns the directions of the rates of a frame: velocities first, then angular velocities.
fn directions(kind: &HingeKind) -> &'static [usize] {
    match kind {
        HingeKind::Ball => &[3, 4, 5],
        HingeKind::PlaneElastic => &[0, 1, 5],
        _ => &[0, 1, 2, 3, 4, 5],
    }
}

/// Returns the pose with given coordinates. Quaternions must be constant.
fn coordinate_pose(kind: &HingeKind, q: &[Jet]) -> Pose {
    let here = Pose::identity().position;
    let quaternion = |q: &[Jet]| {
        let values: Vec<Real> = q.iter().map(|entry| entry.value).collect();
        super::space::constant_matrix(from_quaternion(&values))
    };
    let zero = <Jet as Number>::constant(0.0);
    match kind {
        HingeKind::Weld => Pose::identity(),
        HingeKind::Pin { axis } => turned(about(unit(axis), q[0])),
        HingeKind::Slider { axis } => {
            Pose { position: scaled(unit(axis), q[0]), ..Pose::identity() }
        }
        HingeKind::Screw { axis, pitch } => {
            let way = q[0] * <Jet as Number>::constant(*pitch);
            Pose { position: scaled(unit(axis), way), rotation: about(unit(axis), q[0]) }
        }
        HingeKind::Cylindrical { axis } => {
            Pose { position: scaled(unit(axis), q[0]), rotation: about(unit(axis), q[1]) }
        }
        HingeKind::Universal { first, second } => {
            turned(product(about(unit(first), q[0]), about(unit(second), q[1])))
        }
        HingeKind::Gimbal { axes: [first, second, third] } => {
            let later = product(about(unit(second), q[1]), about(unit(third), q[2]));
            turned(product(about(unit(first), q[0]), later))
        }
        HingeKind::Ball => turned(quaternion(q)),
        HingeKind::Planar { normal } => planar(*normal, q),
        HingeKind::PlaneFloating => planar(Axis::Z, q),
        HingeKind::PlaneElastic => {
            let rotation = about(ith(2), q[2]);
            Pose { position: times(rotation, [q[0], q[1], zero]), rotation }
        }
        HingeKind::Floating => Pose { position: [q[0], q[1], q[2]], rotation: quaternion(&q[3..]) },
        HingeKind::Elastic => {
            let about_z = about(ith(2), q[5]);
            let small = product(about(ith(1), q[4]), about(ith(0), q[3]));
            let position = times(about_z, [q[0], q[1], q[2]]);
            Pose { position, rotation: product(about_z, small) }
        }
        HingeKind::LineFloating | HingeKind::LineElastic => {
            Pose { position: [q[0], here[1], here[2]], ..Pose::identity() }
        }
    }
}

fn planar(normal: Axis, q: &[Jet]) -> Pose {
    let n = normal.index();
    let mut position = Pose::identity().position;
    position[(n + 1) % 3] = q[0];
    position[(n + 2) % 3] = q[1];
    Pose { position, rotation: about(ith(n), q[2]) }
}

/// Returns the first two derivatives of the coordinates of an elastic hinge, or of the strains of
/// another hinge, for given rates and derivatives of rates.
///
/// An elastic hinge has `v = K(q) q̇`: the columns of `K` are the rates of the poses whose coordinates
/// move one at a time, and the derivative of `v` at `q̈ = 0` is that of the pose with these `q̇`.
pub(super) fn strain_rates(kind: &HingeKind, motion: &Motion) -> [Vec<Real>; 2] {
    let Motion { q, v, a } = motion;
    if !matches!(kind, HingeKind::Elastic | HingeKind::PlaneElastic) {
        return [v.clone(), a.clone()];
    }
    let rates = |rates: &[Real]| {
        let jets = q.iter().zip(rates).map(|(&q, &rate)| Jet::new(q, rate, Real::new(0.0)));
        let pose = coordinate_pose(kind, &jets.collect::<Vec<_>>());
        let [spin, change] = pose.own_spin();
        let first = [pose.velocity(), spin].concat();
        let second = [pose.acceleration(), change].concat();
        let kept = |all: Vec<Real>| directions(kind).iter().map(|&k| all[k]).collect::<Vec<_>>();
        [kept(first), kept(second)]
    };
    let columns: Vec<Vec<Real>> = (0..q.len())
        .map(|k| {
            let mut one = reals(&vec![0.0; q.len()]);
            one[k] = Real::new(1.0);
            let [column, _] = rates(&one);
            column
        })
        .collect();
    let matrix = |row: usize| columns.iter().map(|column| column[row]).collect::<Vec<_>>();
    let matrix: Vec<Vec<Real>> = (0..q.len()).map(matrix).collect();
    let first = solved(&matrix, v);
    let [_, bias] = rates(&first);
    let rest: Vec<Real> = a.iter().zip(&bias).map(|(&a, &bias)| a - bias).collect();
    [first, solved(&matrix, &rest)]
}

/// Returns the derivatives of the coordinates with given rates.
pub(super) fn coordinate_rates(kind: &HingeKind, q: &[Real], v: &[Real]) -> Vec<Real> {
    let none = reals(&vec![0.0; v.len()]);
    if !kind.has_quaternion() {
        let motion = Motion { q: q.to_vec(), v: v.to_vec(), a: none };
        let [rates, _] = strain_rates(kind, &motion);
        return rates;
    }
    let linear = kind.linear().end;
    let mut rates = v[..linear].to_vec();
    let spin = [v[linear], v[linear + 1], v[linear + 2]];
    let by_spin = hamilton(&q[linear..], &[Real::new(0.0), spin[0], spin[1], spin[2]]);
    rates.extend(by_spin.map(|entry| entry * Real::new(0.5)));
    rates
}

/// Returns the product of two quaternions (w, x, y, z).
pub(super) fn hamilton(a: &[Real], b: &[Real]) -> [Real; 4] {
    [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    ]
}
