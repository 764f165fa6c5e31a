//! Passive efforts of a hinge: springs, dampers, friction, limits and the inertia of rotors.

use crate::hinge::{Group, Hinge};
use crate::strain::Strains;
use nalgebra::{DMatrix, DVector};

/// The passive efforts and inertias along the rates of a hinge at one instant.
pub(crate) struct Passive {
    /// The efforts of springs, dampers, friction and limits, conjugate to the hinge's rates.
    pub(crate) efforts: DVector<f64>,
    /// The rotors' inertia for the derivatives of the hinge's rates.
    pub(crate) inertia: DMatrix<f64>,
    /// The efforts that the rotors need at constant rates.
    pub(crate) inertia_bias: DVector<f64>,
    /// The energy of springs and limits in J.
    pub(crate) potential_energy: f64,
    /// The energy of the rotors in J.
    pub(crate) kinetic_energy: f64,
}

/// The efforts conjugate to strain rates, and the energy of the springs.
struct StrainEfforts {
    efforts: DVector<f64>,
    energy: f64,
}

impl Passive {
    /// Returns the passive efforts of a hinge with the given coordinates and rates.
    pub(crate) fn new(hinge: &Hinge, q: &[f64], v: &[f64]) -> Passive {
        let strains = Strains::new(hinge, q, v);
        let mut acting = StrainEfforts { efforts: DVector::zeros(v.len()), energy: 0.0 };
        let mut armature = DVector::zeros(v.len());
        for ((group, strained), turning) in hinge.groups().into_iter().zip([false, true]) {
            for k in strained.clone() {
                armature[k] = Group::entry(&group.armature, k - strained.start);
            }
            if turning && hinge.kind.has_quaternion() {
                acting.on_turn(group, strained.start, &strains);
            } else {
                for k in strained.clone() {
                    acting.on_coordinate(group, k, k - strained.start, &strains);
                }
            }
        }
        let to_rates = strains.jacobian.transpose();
        let rotors = DMatrix::from_diagonal(&armature);
        Passive {
            efforts: &to_rates * acting.efforts,
            inertia: &to_rates * &rotors * &strains.jacobian,
            inertia_bias: &to_rates * &rotors * &strains.bias,
            potential_energy: acting.energy,
            kinetic_energy: 0.5 * strains.rates.dot(&(&rotors * &strains.rates)),
        }
    }
}

impl StrainEfforts {
    /// Adds the efforts on a strain that is a single coordinate; `member` is its index in the group.
    fn on_coordinate(&mut self, group: &Group, k: usize, member: usize, strains: &Strains) {
        let (strain, rate) = (strains.relative[k], strains.rates[k]);
        let entry = |list: &[f64]| Group::entry(list, member);
        let mut effort = -entry(&group.stiffness) * strain - entry(&group.damping) * rate;
        self.energy += 0.5 * entry(&group.stiffness) * strain * strain;
        if !group.friction.is_empty() {
            effort -= entry(&group.friction) * rate / rate.hypot(group.friction_speed);
        }
        if let Some(limits) = &group.limits {
            let coordinate = strains.coordinates[k];
            let above = (coordinate - limits.range[1]).max(0.0);
            let below = (limits.range[0] - coordinate).max(0.0);
            effort += limits.stiffness * (below - above);
            if above > 0.0 || below > 0.0 {
                effort -= limits.damping * rate;
            }
            self.energy += 0.5 * limits.stiffness * (above * above + below * below);
        }
        self.efforts[k] += effort;
    }

    /// Adds the efforts on three rotations whose coordinates are a quaternion.
    fn on_turn(&mut self, group: &Group, first: usize, strains: &Strains) {
        let strain = DVector::from_column_slice(&strains.relative[first..first + 3]);
        let rate = strains.rates.rows(first, 3).into_owned();
        let (angle, speed) = (strain.norm(), rate.norm());
        let stiffness = Group::entry(&group.stiffness, 0);
        let mut effort = -stiffness * &strain - Group::entry(&group.damping, 0) * &rate;
        self.energy += 0.5 * stiffness * angle * angle;
        if !group.friction.is_empty() {
            effort -=
                &rate * (Group::entry(&group.friction, 0) / speed.hypot(group.friction_speed));
        }
        if let Some(limits) = &group.limits {
            let beyond = angle - limits.range[1];
            if beyond > 0.0 {
                effort -= &strain * (limits.stiffness * beyond / angle) + limits.damping * &rate;
                self.energy += 0.5 * limits.stiffness * beyond * beyond;
            }
        }
        let mut own = self.efforts.rows_mut(first, 3);
        own += effort;
    }
}
