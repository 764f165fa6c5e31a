//! The directions that a hinge leaves free, as the sweeps use them.

use super::rows::{dot, identity};
use super::strain::StrainMap;
use super::transform::combine;
use crate::math::{Motion, Scalar, Wrench};

/// The directions that a hinge leaves free, in the work axes of the child.
///
/// The child moves against the parent by `Σ columns[i] w[i]`, and `v = inverse · w`. The hinge's
/// condition is `columnsᵀ F = inverseᵀ τ − armature ẇ`.
#[derive(Clone, Debug)]
pub struct SubspaceBasis<S> {
    /// The free directions; none where the motion is prescribed.
    pub columns: Vec<BasisVector<S>>,
    /// Inertia of rotors along each column.
    pub armature: Vec<S>,
    inverse: Vec<Vec<S>>,
}

/// A free direction.
#[derive(Clone, Copy, Debug)]
pub enum BasisVector<S> {
    /// Along (0 to 2) or about (3 to 5) one of the work axes: what is eliminated along it can be
    /// set to exactly zero.
    Axis(usize),
    /// Any other.
    General(Motion<S>),
}

impl<S: Scalar> BasisVector<S> {
    /// `motion` as a column: an axis where it is one.
    fn of(motion: Motion<S>) -> Self {
        let present: Vec<usize> = (0..6).filter(|&k| !motion.at(k).vanishes()).collect();
        match present[..] {
            [k] if (motion.at(k) - S::one()).vanishes() => BasisVector::Axis(k),
            _ => BasisVector::General(motion),
        }
    }

    /// The direction's six entries.
    pub fn motion(&self) -> Motion<S> {
        match self {
            BasisVector::Axis(axis) => Motion::unit(*axis),
            BasisVector::General(motion) => *motion,
        }
    }

    /// What a pivot along it is measured by, from a mass and a moment of inertia.
    pub fn pivot_scale(&self, mass: S, moment: S) -> S {
        match self {
            BasisVector::Axis(axis) if *axis < 3 => mass,
            BasisVector::Axis(_) => moment,
            BasisVector::General(Motion { linear, angular }) => {
                mass * linear.dot(*linear) + moment * angular.dot(*angular)
            }
        }
    }
}

/// The free directions of a hinge that moves by `subspace`, in work axes; `strains` are those that
/// its passive elements act on and `armature` the inertias of rotors along them.
pub fn subspace_basis<S: Scalar>(
    subspace: &[Motion<S>],
    strains: &StrainMap<S>,
    armature: &[S],
) -> SubspaceBasis<S> {
    if armature.iter().all(|inertia| inertia.vanishes()) {
        let on_axes = axes_of(subspace).and_then(|axes| on_axes(subspace, axes, armature));
        return on_axes
            .unwrap_or_else(|| along(subspace.to_vec(), identity(subspace.len()).1, armature));
    }
    // Along the strains rotors have one inertia each.
    let column = |k: usize| {
        let amounts: Vec<S> = strains.inverse.iter().map(|row| row[k]).collect();
        combine(subspace.iter(), &amounts)
    };
    let columns = (0..subspace.len()).map(column).collect();
    along(columns, strains.inverse.clone(), armature)
}

/// Nothing is free.
pub fn empty_basis<S>() -> SubspaceBasis<S> {
    SubspaceBasis { columns: Vec::new(), armature: Vec::new(), inverse: Vec::new() }
}

/// The axes that motions have entries along, if there are as many as motions.
fn axes_of<S: Scalar>(subspace: &[Motion<S>]) -> Option<Vec<usize>> {
    let present = |&k: &usize| subspace.iter().any(|motion| !motion.at(k).vanishes());
    let axes: Vec<usize> = (0..6).filter(present).collect();
    (axes.len() == subspace.len()).then_some(axes)
}

/// Whole axes as free directions. The inverse of the basis follows from its blocks: shifts among
/// themselves, and turns among themselves, are orthogonal.
///
/// ```text
/// basis = [L N]   inverse = [Lᵀ −Lᵀ N Tᵀ]
///         [0 T]             [0        Tᵀ]
/// ```
fn on_axes<S: Scalar>(
    subspace: &[Motion<S>],
    axes: Vec<usize>,
    armature: &[S],
) -> Option<SubspaceBasis<S>> {
    let count = axes.len();
    let shifts = axes.iter().filter(|&&axis| axis < 3).count();
    let basis: Vec<Vec<S>> =
        axes.iter().map(|&axis| subspace.iter().map(|motion| motion.at(axis)).collect()).collect();
    // Shifts come first among the rates of every kind, and only turns can turn.
    let block = |i: usize, j: usize| i >= shifts && j < shifts;
    let pure = (0..count).all(|i| (0..count).all(|j| !block(i, j) || basis[i][j].vanishes()));
    if !pure {
        return None;
    }
    let mut inverse = vec![vec![S::zero(); count]; count];
    for i in 0..count {
        for j in 0..count {
            inverse[i][j] = if (i < shifts) == (j < shifts) {
                basis[j][i]
            } else if i < shifts {
                let over = |k: usize| {
                    let turned =
                        (shifts..count).fold(S::zero(), |sum, l| sum + basis[k][l] * basis[j][l]);
                    basis[k][i] * turned
                };
                -(0..shifts).fold(S::zero(), |sum, k| sum + over(k))
            } else {
                S::zero()
            };
        }
    }
    let columns = axes.into_iter().map(BasisVector::Axis).collect();
    Some(SubspaceBasis { columns, armature: armature.to_vec(), inverse })
}

fn along<S: Scalar>(
    motions: Vec<Motion<S>>,
    inverse: Vec<Vec<S>>,
    armature: &[S],
) -> SubspaceBasis<S> {
    let columns = motions.into_iter().map(BasisVector::of).collect();
    SubspaceBasis { columns, armature: armature.to_vec(), inverse }
}

impl<S: Scalar> SubspaceBasis<S> {
    /// Efforts along the columns, from those that belong to the rates.
    pub fn to_basis(&self, efforts: &[S]) -> Vec<S> {
        (0..self.columns.len())
            .map(|j| {
                self.inverse.iter().zip(efforts).fold(S::zero(), |sum, (row, &x)| sum + row[j] * x)
            })
            .collect()
    }

    /// The rates, or accelerations, that belong to `amounts` of the columns.
    pub fn to_rates(&self, amounts: &[S]) -> Vec<S> {
        self.inverse.iter().map(|row| dot(row, amounts)).collect()
    }

    /// A wrench over the hinge, with the efforts put where the free axes leave nothing else.
    pub fn with_applied_efforts(&self, wrench: Wrench<S>, efforts: &[S]) -> Wrench<S> {
        let basis_efforts = self.to_basis(efforts);
        let along = |k: usize| {
            let is_axis =
                |column: &BasisVector<S>| matches!(column, BasisVector::Axis(axis) if *axis == k);
            self.columns.iter().position(is_axis).filter(|&i| self.armature[i].vanishes())
        };
        Wrench::from_fn(|k| along(k).map_or(wrench.at(k), |column| basis_efforts[column]))
    }
}
