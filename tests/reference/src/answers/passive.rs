//! Springs, dampers, friction, limits and rotors of a hinge.

use super::hinge::{Motion, hamilton, strain_rates};
use super::space::{Vector, dot, norm, scaled};
use super::{Real, reals};
use crate::hinge::{Group, Hinge};

/// What acts along the rates of a hinge, apart from its motor.
pub(super) struct Passive {
    /// The efforts of springs, dampers, friction and limits.
    pub(super) efforts: Vec<Real>,
    /// The efforts that the rotors need.
    pub(super) rotors: Vec<Real>,
}

/// Returns what acts along the rates: the efforts and momenta of all strains, multiplied by the strain
/// rates at unit rates.
pub(super) fn passive(hinge: &Hinge, motion: &Motion) -> Passive {
    let count = motion.v.len();
    let [strain_rates_now, accelerations] = strain_rates(&hinge.kind, motion);
    let mut strain_efforts = reals(&vec![0.0; count]);
    for (number, (group, range)) in hinge.groups().into_iter().enumerate() {
        if number == 1 && hinge.kind.has_quaternion() {
            let rates = [0, 1, 2].map(|k| strain_rates_now[range.start + k]);
            let efforts = of_rotation(group, rotation_strain(hinge, &motion.q), rates);
            strain_efforts[range].copy_from_slice(&efforts);
        } else {
            for k in range.clone() {
                let rest = Real::new(hinge.rest_coordinates()[k]);
                let (member, q) = (k - range.start, motion.q[k]);
                strain_efforts[k] = of_strain(group, member, [q, q - rest, strain_rates_now[k]]);
            }
        }
    }
    let columns = strain_columns(hinge, motion);
    let along_rate = |values: &[Real]| -> Vec<Real> {
        let one = |column: &Vec<Real>| {
            column.iter().zip(values).fold(Real::new(0.0), |sum, (&a, &b)| sum + a * b)
        };
        columns.iter().map(one).collect()
    };
    let armature = armature(hinge);
    let momenta: Vec<Real> = armature.iter().zip(&accelerations).map(|(&a, &b)| a * b).collect();
    Passive { efforts: along_rate(&strain_efforts), rotors: along_rate(&momenta) }
}

/// Returns the strain rates at unit rates, by rates.
pub(super) fn strain_columns(hinge: &Hinge, motion: &Motion) -> Vec<Vec<Real>> {
    let count = motion.v.len();
    let still = Motion { a: reals(&vec![0.0; count]), ..motion.clone() };
    let one = |k: usize| {
        let mut v = still.a.clone();
        v[k] = Real::new(1.0);
        let [column, _] = strain_rates(&hinge.kind, &Motion { v, ..still.clone() });
        column
    };
    (0..count).map(one).collect()
}

/// Returns the inertias of the rotors, one for each strain.
pub(super) fn armature(hinge: &Hinge) -> Vec<Real> {
    let of_group = |(group, range): (&Group, std::ops::Range<usize>)| -> Vec<Real> {
        (0..range.len()).map(|member| Real::new(Group::entry(&group.armature, member))).collect()
    };
    hinge.groups().into_iter().flat_map(of_group).collect()
}

/// Returns the effort on a strain that is a single coordinate.
fn of_strain(group: &Group, member: usize, [q, strain, rate]: [Real; 3]) -> Real {
    let entry = |list: &[f64]| Real::new(Group::entry(list, member));
    let mut effort = -(entry(&group.stiffness) * strain) - entry(&group.damping) * rate;
    if !group.friction.is_empty() {
        effort -= entry(&group.friction) * rate * slip_speed(group, rate * rate).recip();
    }
    if let Some(limits) = &group.limits {
        let [low, high] = limits.range.map(Real::new);
        let beyond = if q > high {
            q - high
        } else if q < low {
            q - low
        } else {
            return effort;
        };
        effort -= Real::new(limits.stiffness) * beyond + Real::new(limits.damping) * rate;
    }
    effort
}

/// Returns the torque on three rotations whose coordinates are a quaternion.
fn of_rotation(group: &Group, strain: Vector, rate: Vector) -> Vector {
    let of = |strain_factor: Real, rate_factor: Real, torque: Vector| -> Vector {
        std::array::from_fn(|k| torque[k] - strain_factor * strain[k] - rate_factor * rate[k])
    };
    let entry = |list: &[f64]| Real::new(Group::entry(list, 0));
    let mut torque = of(entry(&group.stiffness), entry(&group.damping), [Real::new(0.0); 3]);
    if !group.friction.is_empty() {
        let factor = entry(&group.friction) * slip_speed(group, dot(rate, rate)).recip();
        torque = of(Real::new(0.0), factor, torque);
    }
    if let Some(limits) = &group.limits {
        let angle = norm(strain);
        let beyond = angle - Real::new(limits.range[1]);
        if beyond.high > 0.0 {
            let factor = Real::new(limits.stiffness) * beyond * angle.recip();
            torque = of(factor, Real::new(limits.damping), torque);
        }
    }
    torque
}

/// Returns the square root of the sum of the squares of a speed and of the friction speed.
fn slip_speed(group: &Group, square: Real) -> Real {
    let smallest = Real::new(group.friction_speed);
    (square + smallest * smallest).sqrt()
}

/// Returns the rotation vector, of length π at most, from rest to the orientation of a hinge.
fn rotation_strain(hinge: &Hinge, q: &[Real]) -> Vector {
    let first = hinge.kind.linear().end;
    let [w, x, y, z] = hinge.rest_coordinates()[first..]
        .try_into()
        .map(|rest: [f64; 4]| rest.map(Real::new))
        .expect("a quaternion");
    let [cosine, sines @ ..] = hamilton(&[w, -x, -y, -z], &q[first..]);
    let sign = Real::new(1.0).copysign(cosine);
    let sine = norm(sines);
    if sine.high == 0.0 {
        return sines;
    }
    let angle = Real::new(2.0) * sine.atan2(cosine * sign);
    scaled(sines, sign * angle * sine.recip())
}
