//! Passive elements of a hinge: springs, dampers, friction, stops and rotor inertias, each along
//! one strain.
//!
//! `s` are strains, `ṡ = J v` their rates and `σ` the efforts along them.

use super::ball;
use super::force_laws::{GroupState, LinearizedEffort, group_efforts};
use super::strain::{self, StrainMap};
use crate::equations::SymbolValues;
use crate::math::{Dual, Scalar};
use crate::model::{DofGroup, Hinge, HingeKind, Passive, Representation};

/// The passive elements of a hinge in a state.
#[derive(Clone, Debug)]
pub struct PassiveElements<S> {
    /// The map from rates to strain rates.
    pub strains: StrainMap<S>,
    /// Strain rates.
    pub strain_rates: Vec<S>,
    /// Efforts, one for each rate of the hinge, minus the rotor efforts that the rates alone
    /// require.
    pub efforts: Vec<S>,
    /// Efforts of springs, dampers, friction and stops, one for each rate of the hinge.
    pub element_efforts: Vec<S>,
    /// Inertia along each strain: rotor inertia plus, in an implicit step, the inertia that the
    /// step adds.
    pub inertias: Vec<S>,
    /// Rotor inertia along each strain.
    pub rotor_inertias: Vec<S>,
    /// Energy of springs and stops in J.
    pub energy: S,
}

/// Returns the passive elements at coordinates `q` and rates `v`. In a linearly implicit Euler step
/// of length `h`, the effort includes the change of strain over the step, `σ(s + h ṡ⁺, ṡ⁺) ≈ σ − h
/// k ṡ − (h c + h² k) s̈`. The last term is treated as an inertia.
pub fn passive_elements<S: Scalar>(
    hinge: &Hinge,
    values: &SymbolValues<S>,
    q: &[S],
    v: &[S],
    implicit: Option<S>,
) -> PassiveElements<S> {
    let strains = hinge.kind.law().strains(q);
    let rates = strain::times(&strains.jacobian, v);
    let rotor_inertias: Vec<S> = hinge.passive.iter().map(|p| values.scalar(&p.armature)).collect();
    let mut inertias = rotor_inertias.clone();
    let (mut efforts, energy) = linearized_efforts(hinge, values, q, &rates);
    if let Some(h) = implicit {
        for ((along, inertia), &rate) in efforts.iter_mut().zip(&mut inertias).zip(&rates) {
            let step = h * along.stiffness;
            along.effort = along.effort - step * rate;
            *inertia = *inertia + h * (along.damping + step);
        }
    }
    let of_elements: Vec<S> = efforts.iter().map(|along| along.effort).collect();
    let biases = strain_bias(&hinge.kind, (q, v), v, &rotor_inertias);
    let along = efforts.iter().zip(&rotor_inertias).zip(biases);
    let along: Vec<S> = along.map(|((along, &rotor), bias)| along.effort - rotor * bias).collect();
    let efforts = strain::transpose_times(&strains.jacobian, &along);
    let element_efforts = strain::transpose_times(&strains.jacobian, &of_elements);
    PassiveElements {
        strains,
        strain_rates: rates,
        efforts,
        element_efforts,
        inertias,
        rotor_inertias,
        energy,
    }
}

/// Returns the effort along each strain, and the energy.
fn linearized_efforts<S: Scalar>(
    hinge: &Hinge,
    values: &SymbolValues<S>,
    q: &[S],
    rates: &[S],
) -> (Vec<LinearizedEffort<S>>, S) {
    if !hinge.passive.iter().any(Passive::has_effort) {
        return (rates.iter().map(|_| LinearizedEffort::zero()).collect(), S::zero());
    }
    let rest: Vec<S> = hinge.rest.iter().map(|value| values.scalar(value)).collect();
    let strains = strains_from_rest(&hinge.kind, &rest, q);
    let (mut efforts, mut energy) = (Vec::new(), S::zero());
    for group in hinge.kind.spec().groups {
        let (along, stored) = group_efforts(&GroupState {
            group,
            passive: &hinge.passive[group.rates.clone()],
            values,
            strains: &strains[group.rates.clone()],
            rates: &rates[group.rates.clone()],
            coordinates: &q[group.coordinates.clone()],
        });
        efforts.extend(along);
        energy = energy + stored;
    }
    (efforts, energy)
}

impl<S: Scalar> PassiveElements<S> {
    /// Returns the efforts along the rates that accelerate the rotors.
    pub fn rotor_efforts(&self, accelerations: &[S]) -> Vec<S> {
        let strain_accelerations = strain::times(&self.strains.jacobian, accelerations);
        let efforts: Vec<S> =
            strain_accelerations.iter().zip(&self.rotor_inertias).map(|(&a, &i)| a * i).collect();
        strain::transpose_times(&self.strains.jacobian, &efforts)
    }
}

/// Returns the product of the rotors' Coriolis matrix `Jᵀ R J̇` with a vector, for rotor inertias `R`. It is
/// not zero if the strains depend on the coordinates in another way than linearly, as those of elastic hinges.
pub fn rotor_coriolis<S: Scalar>(
    kind: &HingeKind,
    elements: &PassiveElements<S>,
    state: (&[S], &[S]),
    x: &[S],
) -> Vec<S> {
    let rotors = &elements.rotor_inertias;
    let along = strain_bias(kind, state, x, rotors).into_iter().zip(rotors);
    let along: Vec<S> = along.map(|(bias, &rotor)| rotor * bias).collect();
    strain::transpose_times(&elements.strains.jacobian, &along)
}

/// Returns the strains `s`, one for each rate: coordinates minus their rest values, and rotation
/// vectors from rest.
fn strains_from_rest<S: Scalar>(kind: &HingeKind, rest: &[S], q: &[S]) -> Vec<S> {
    let group = |group: &DofGroup| {
        let (rest, q) = (&rest[group.coordinates.clone()], &q[group.coordinates.clone()]);
        match group.representation {
            Representation::Numbers | Representation::Angles => {
                q.iter().zip(rest).map(|(&q, &r)| q - r).collect()
            }
            Representation::Quaternion => ball::rotation_vector(rest, q).0.to_vec(),
        }
    };
    kind.spec().groups.iter().flat_map(group).collect::<Vec<S>>()
}

/// Returns `J̇ x` at rates `v`; zero without rotors. For `x = v` these are the strain accelerations at constant
/// rates.
fn strain_bias<S: Scalar>(
    kind: &HingeKind,
    (q, v): (&[S], &[S]),
    x: &[S],
    rotor_inertias: &[S],
) -> Vec<S> {
    let strains = kind.law().strains(q);
    if strains.is_constant || rotor_inertias.iter().all(|rotor| rotor.vanishes()) {
        return vec![S::zero(); v.len()];
    }
    let coordinate_rates = kind.law().coordinate_rates(q, v);
    let moving: Vec<Dual<S>> =
        q.iter().zip(coordinate_rates).map(|(&q, rate)| Dual::new(q, rate)).collect();
    let held: Vec<Dual<S>> = x.iter().map(|&x| Dual::new(x, S::zero())).collect();
    let moving = kind.law().strains(&moving);
    strain::times(&moving.jacobian, &held).iter().map(|sum| sum.derivative()).collect()
}
