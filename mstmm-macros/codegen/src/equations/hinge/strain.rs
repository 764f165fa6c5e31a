//! Strains: how far a hinge is from rest, in the measures that its springs act on.

use super::ball;
use super::freedom::{dot, identity};
use crate::math::{Dual, Scalar};
use crate::model::{Form, Freedoms, HingeKind};

/// How rates become strain rates.
#[derive(Clone, Debug)]
pub struct Strains<S> {
    /// `J` of `ṡ = J v`, by rows.
    pub rows: Vec<Vec<S>>,
    /// `J⁻¹`, by rows.
    pub inverse: Vec<Vec<S>>,
    /// Whether `J` is the same at all coordinates.
    is_constant: bool,
}

impl<S: Scalar> Strains<S> {
    /// Strains that change by so many rates, `J = 1`.
    pub fn change_by_rates(count: usize) -> Self {
        let (rows, inverse) = identity(count);
        Strains { rows, inverse, is_constant: true }
    }

    /// By `J` and `J⁻¹`, which depend on the coordinates.
    pub fn of(rows: Vec<Vec<S>>, inverse: Vec<Vec<S>>) -> Self {
        Strains { rows, inverse, is_constant: false }
    }
}

/// `s`, one for each rate: coordinates less their rest values, rotation vectors from rest.
pub fn values<S: Scalar>(kind: &HingeKind, rest: &[S], q: &[S]) -> Vec<S> {
    let group = |group: &Freedoms| {
        let (rest, q) = (&rest[group.coordinates.clone()], &q[group.coordinates.clone()]);
        match group.form {
            Form::Numbers | Form::Angles => q.iter().zip(rest).map(|(&q, &r)| q - r).collect(),
            Form::Quaternion => ball::rotation_vector(rest, q).0.to_vec(),
        }
    };
    kind.shape().groups.iter().flat_map(group).collect::<Vec<S>>()
}

/// `ṡ = J v`
pub fn rates<S: Scalar>(rows: &[Vec<S>], v: &[S]) -> Vec<S> {
    rows.iter().map(|row| dot(row, v)).collect()
}

/// `Jᵀ σ`: efforts along the rates from those along the strains.
pub fn returned<S: Scalar>(rows: &[Vec<S>], along: &[S]) -> Vec<S> {
    let column = |j: usize| rows.iter().map(|row| row[j]).collect::<Vec<S>>();
    (0..rows.len()).map(|j| dot(&column(j), along)).collect()
}

/// `J̇ v`, the strain accelerations that the rates alone make, where a rotor feels them.
pub fn drift<S: Scalar>(kind: &HingeKind, q: &[S], v: &[S], rotors: &[S]) -> Vec<S> {
    let strains = kind.law().strains(q);
    if strains.is_constant || rotors.iter().all(|rotor| rotor.vanishes()) {
        return vec![S::zero(); v.len()];
    }
    let coordinate_rates = kind.law().coordinate_rates(q, v);
    let moving: Vec<Dual<S>> =
        q.iter().zip(coordinate_rates).map(|(&q, rate)| Dual::new(q, rate)).collect();
    let rates_held: Vec<Dual<S>> = v.iter().map(|&v| Dual::new(v, S::zero())).collect();
    let moving = kind.law().strains(&moving);
    rates(&moving.rows, &rates_held).iter().map(|sum| sum.derivative()).collect()
}
