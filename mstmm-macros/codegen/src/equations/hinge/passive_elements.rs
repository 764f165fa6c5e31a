//! What acts along the free directions of a hinge of itself: springs, dampers, friction, stops and
//! the inertia of rotors, each along one strain.

use super::ball;
use super::force_laws::{GroupState, LinearizedEffort, group_efforts};
use super::strain::{self, StrainMap};
use crate::equations::SymbolValues;
use crate::math::{Dual, Scalar};
use crate::model::{DofGroup, Hinge, HingeKind, Passive, Representation};

/// What acts along the free directions.
#[derive(Clone, Debug)]
pub struct PassiveElements<S> {
    /// How rates become strain rates.
    pub strains: StrainMap<S>,
    /// Strain rates.
    pub strain_rates: Vec<S>,
    /// Efforts, one for each of the hinge's rates; what the rates alone demand of rotors is taken
    /// off.
    pub efforts: Vec<S>,
    /// Inertia along each strain: of rotors and, in an implicit step, what the step adds.
    pub inertias: Vec<S>,
    /// Inertia of rotors along each strain.
    pub rotor_inertias: Vec<S>,
    /// Energy of springs and stops.
    pub energy: S,
}

/// What acts at coordinates `q` and rates `v`. In a linearly implicit Euler step of length `h` the
/// effort is the one that the change of strain over the step would make,
/// `σ(s + h ṡ⁺, ṡ⁺) ≈ σ − h k ṡ − (h c + h² k) s̈`: its last part counts as inertia.
pub fn passive_elements<S: Scalar>(
    hinge: &Hinge,
    numbers: &SymbolValues<S>,
    q: &[S],
    v: &[S],
    implicit: Option<S>,
) -> PassiveElements<S> {
    let strains = hinge.kind.law().strains(q);
    let rates = strain::times(&strains.jacobian, v);
    let rotor_inertias: Vec<S> =
        hinge.passive.iter().map(|p| numbers.scalar(&p.armature)).collect();
    let mut inertias = rotor_inertias.clone();
    let (mut efforts, energy) = linearized_efforts(hinge, numbers, q, &rates);
    if let Some(h) = implicit {
        for ((along, inertia), &rate) in efforts.iter_mut().zip(&mut inertias).zip(&rates) {
            let step = h * along.stiffness;
            along.effort = along.effort - step * rate;
            *inertia = *inertia + h * (along.damping + step);
        }
    }
    let biases = strain_bias(&hinge.kind, q, v, &rotor_inertias);
    let along = efforts.iter().zip(&rotor_inertias).zip(biases);
    let along: Vec<S> = along.map(|((along, &rotor), bias)| along.effort - rotor * bias).collect();
    let efforts = strain::transpose_times(&strains.jacobian, &along);
    PassiveElements { strains, strain_rates: rates, efforts, inertias, rotor_inertias, energy }
}

/// What acts along each strain, and the energy of it.
fn linearized_efforts<S: Scalar>(
    hinge: &Hinge,
    numbers: &SymbolValues<S>,
    q: &[S],
    rates: &[S],
) -> (Vec<LinearizedEffort<S>>, S) {
    if !hinge.passive.iter().any(Passive::has_effort) {
        return (rates.iter().map(|_| LinearizedEffort::zero()).collect(), S::zero());
    }
    let rest: Vec<S> = hinge.rest.iter().map(|value| numbers.scalar(value)).collect();
    let strains = strains_from_rest(&hinge.kind, &rest, q);
    let (mut efforts, mut energy) = (Vec::new(), S::zero());
    for group in hinge.kind.spec().groups {
        let (along, stored) = group_efforts(&GroupState {
            group,
            passive: &hinge.passive[group.rates.clone()],
            numbers,
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
    /// What accelerations of the rates take to move the rotors, along the rates.
    pub fn rotor_efforts(&self, accelerations: &[S]) -> Vec<S> {
        let along = strain::times(&self.strains.jacobian, accelerations);
        let taken: Vec<S> = along.iter().zip(&self.rotor_inertias).map(|(&a, &i)| a * i).collect();
        strain::transpose_times(&self.strains.jacobian, &taken)
    }
}

/// The strains `s`, one for each rate: coordinates less their rest values, rotation vectors from rest.
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

/// `J̇ v`, the strain accelerations that the rates alone make, where a rotor feels them.
fn strain_bias<S: Scalar>(kind: &HingeKind, q: &[S], v: &[S], rotor_inertias: &[S]) -> Vec<S> {
    let strains = kind.law().strains(q);
    if strains.is_constant || rotor_inertias.iter().all(|rotor| rotor.vanishes()) {
        return vec![S::zero(); v.len()];
    }
    let coordinate_rates = kind.law().coordinate_rates(q, v);
    let moving: Vec<Dual<S>> =
        q.iter().zip(coordinate_rates).map(|(&q, rate)| Dual::new(q, rate)).collect();
    let rates_held: Vec<Dual<S>> = v.iter().map(|&v| Dual::new(v, S::zero())).collect();
    let moving = kind.law().strains(&moving);
    strain::times(&moving.jacobian, &rates_held).iter().map(|sum| sum.derivative()).collect()
}
