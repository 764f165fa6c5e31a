//! Derivatives along changes of states and inputs.

use super::differences::derivative;
use super::hinge::coordinate_rates;
use super::space::{Vector, plus, scaled};
use super::{Answers, Now, Real, floats};
use crate::chain::Gravity;
use crate::drives::LoadInput;
use crate::hinge::{HingeKind, Source};

/// A direction in which the state and the inputs of a chain change.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// The change of the coordinates, as rates: one number for every rate.
    pub coordinates: Vec<f64>,
    /// The change of the rates.
    pub rates: Vec<f64>,
    /// The change of the accelerations that inverse dynamics are given.
    pub accelerations: Vec<f64>,
    /// The change of the efforts of motors with inputs; other entries are ignored.
    pub efforts: Vec<f64>,
    /// The change of the inputs of loads; values that are not inputs are ignored.
    pub loads: Vec<LoadInput>,
    /// The change of the forces of actuators of springs; values that are not inputs are ignored.
    pub actuators: Vec<f64>,
    /// The change of gravity, if gravity is an input.
    pub gravity: [f64; 3],
}

impl Answers<'_> {
    /// Returns a change of nothing.
    pub fn no_change(&self) -> Change {
        let none = vec![0.0; self.now.v.len()];
        Change {
            coordinates: none.clone(),
            rates: none.clone(),
            accelerations: none.clone(),
            efforts: none,
            loads: vec![LoadInput::default(); self.now.loads.len()],
            actuators: vec![0.0; self.now.actuators.len()],
            gravity: [0.0; 3],
        }
    }

    /// Returns the derivative of the efforts of inverse dynamics along a change.
    pub fn inverse_dynamics_along(&self, accelerations: &[f64], change: &Change) -> Vec<f64> {
        let now = Now { a: super::reals(accelerations), ..self.now.clone() };
        floats(&derivative(|step| self.efforts(&self.changed(&now, change, step))))
    }

    /// Returns the derivative of the accelerations along a change.
    pub fn accelerations_along(&self, change: &Change) -> Vec<f64> {
        let now = &self.now;
        floats(&derivative(|step| self.solved_accelerations(&self.changed(now, change, step))))
    }

    fn changed(&self, now: &Now, change: &Change, step: Real) -> Now {
        let mut changed = now.clone();
        let moved = |from: &[Real], by: &[f64]| -> Vec<Real> {
            from.iter().zip(by).map(|(&from, &by)| from + step * Real::new(by)).collect()
        };
        changed.q = self.moved(now, &change.coordinates, step);
        changed.v = moved(&now.v, &change.rates);
        changed.a = moved(&now.a, &change.accelerations);
        changed.efforts = moved(&now.efforts, &self.driven(&change.efforts));
        let add = |to: &mut Vector, by: [f64; 3], is_input: bool| {
            if is_input {
                *to = plus(*to, scaled(by.map(Real::new), step));
            }
        };
        let loads = self.mechanism.chain.loads.iter().zip(&change.loads);
        for ((load, by), [force, torque]) in loads.zip(&mut changed.loads) {
            add(force, by.force, load.force == Source::Input);
            add(torque, by.torque, load.torque == Source::Input);
        }
        let springs = self.mechanism.chain.springs.iter().zip(&change.actuators);
        for ((spring, &by), force) in springs.zip(&mut changed.actuators) {
            if spring.force == Source::Input {
                *force += step * Real::new(by);
            }
        }
        add(&mut changed.gravity, change.gravity, self.mechanism.chain.gravity == Gravity::Input);
        changed
    }

    /// Returns the efforts of motors with inputs, and zero for the others.
    fn driven(&self, efforts: &[f64]) -> Vec<f64> {
        let mut driven = vec![0.0; efforts.len()];
        for joint in self.mechanism.joints.iter().filter(|joint| joint.prescribed.is_none()) {
            for (group, range) in joint.hinge.groups() {
                if group.motor == Source::Input {
                    for k in range {
                        driven[joint.first_rate + k] = efforts[joint.first_rate + k];
                    }
                }
            }
        }
        driven
    }

    /// Returns the coordinates after a step along rates, to first order.
    pub(super) fn moved(&self, now: &Now, rates: &[f64], step: Real) -> Vec<Real> {
        let mut q = now.q.clone();
        let mut add = |kind: &HingeKind, coordinate: usize, rate: usize| {
            let own = &mut q[coordinate..][..kind.coordinates()];
            let along = super::reals(&rates[rate..][..kind.dof_count()]);
            let change = coordinate_rates(kind, own, &along);
            own.iter_mut().zip(change).for_each(|(q, change)| *q += step * change);
        };
        if self.mechanism.chain.floats() {
            add(&HingeKind::of_base(self.mechanism.chain.dimension), 0, 0);
        }
        for joint in self.mechanism.joints.iter().filter(|joint| joint.prescribed.is_none()) {
            add(joint.kind(), joint.first_coordinate, joint.first_rate);
        }
        q
    }
}
