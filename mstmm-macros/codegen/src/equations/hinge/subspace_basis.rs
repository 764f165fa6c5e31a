//! The basis of a hinge's motion subspace in which the sweeps eliminate degrees of freedom.

use super::rows::{dot, identity};
use super::strain::StrainMap;
use super::transform::combine;
use crate::math::{Motion, Scalar, Wrench};

/// A basis of the motion subspace, in the work axes of the child.
///
/// The child moves relative to the parent by `Σ columns[i] w[i]`, and `v = inverse · w`. The
/// equation of the hinge is `columnsᵀ F = inverseᵀ τ − armature ẇ`.
#[derive(Clone, Debug)]
pub struct SubspaceBasis<S> {
    /// The basis vectors; none if the motion is prescribed.
    pub columns: Vec<BasisVector<S>>,
    /// Rotor inertia along each basis vector.
    pub armature: Vec<S>,
    inverse: Vec<Vec<S>>,
}

/// A basis vector of the motion subspace.
#[derive(Clone, Copy, Debug)]
pub enum BasisVector<S> {
    /// Along (0 to 2) or about (3 to 5) a work axis. The entries along it become exactly zero in
    /// the elimination.
    Axis(usize),
    /// Any other motion.
    General(Motion<S>),
}

impl<S: Scalar> BasisVector<S> {
    /// Returns `motion` as a basis vector.
    fn of(motion: Motion<S>) -> Self {
        let present: Vec<usize> = (0..6).filter(|&k| !motion.at(k).vanishes()).collect();
        match present[..] {
            [k] if (motion.at(k) - S::one()).vanishes() => BasisVector::Axis(k),
            _ => BasisVector::General(motion),
        }
    }

    /// Returns the six entries of the basis vector.
    pub fn motion(&self) -> Motion<S> {
        match self {
            BasisVector::Axis(axis) => Motion::unit(*axis),
            BasisVector::General(motion) => *motion,
        }
    }

    /// Returns the scale of a pivot along the basis vector, from a mass and a moment of inertia.
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

/// Returns a basis of `subspace`, in work axes. `strains` maps rates to strain rates, and
/// `armature` are the rotor inertias along the strains. Three rotations that are not orthogonal to
/// each other stay the basis: whole axes would be divided by what vanishes where the three are in one
/// plane, and the elimination tests its pivots.
pub fn subspace_basis<S: Scalar>(
    (subspace, has_orthogonal_rotations): (&[Motion<S>], bool),
    strains: &StrainMap<S>,
    armature: &[S],
) -> SubspaceBasis<S> {
    if armature.iter().all(|inertia| inertia.vanishes()) {
        let axes = axes_of(subspace).filter(|_| has_orthogonal_rotations);
        let on_axes = axes.and_then(|axes| on_axes(subspace, axes, armature));
        return on_axes
            .unwrap_or_else(|| along(subspace.to_vec(), identity(subspace.len()).1, armature));
    }
    // Along the strains, each rotor has its own inertia.
    let column = |k: usize| {
        let amounts: Vec<S> = strains.inverse.iter().map(|row| row[k]).collect();
        combine(subspace.iter(), &amounts)
    };
    let columns = (0..subspace.len()).map(column).collect();
    along(columns, strains.inverse.clone(), armature)
}

/// Returns the basis of a hinge whose motion is prescribed, which is empty.
pub fn empty_basis<S>() -> SubspaceBasis<S> {
    SubspaceBasis { columns: Vec::new(), armature: Vec::new(), inverse: Vec::new() }
}

/// Returns the axes along which the motions have entries, if there are as many axes as motions.
fn axes_of<S: Scalar>(subspace: &[Motion<S>]) -> Option<Vec<usize>> {
    let present = |&k: &usize| subspace.iter().any(|motion| !motion.at(k).vanishes());
    let axes: Vec<usize> = (0..6).filter(present).collect();
    (axes.len() == subspace.len()).then_some(axes)
}

/// Returns a basis of whole axes. The inverse follows from the blocks: translations are orthogonal
/// to each other, and rotations are orthogonal to each other.
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
    let translations = axes.iter().filter(|&&axis| axis < 3).count();
    let basis: Vec<Vec<S>> =
        axes.iter().map(|&axis| subspace.iter().map(|motion| motion.at(axis)).collect()).collect();
    // Translations come first among the rates of every kind, and have no angular part.
    let block = |i: usize, j: usize| i >= translations && j < translations;
    let pure = (0..count).all(|i| (0..count).all(|j| !block(i, j) || basis[i][j].vanishes()));
    if !pure {
        return None;
    }
    let mut inverse = vec![vec![S::zero(); count]; count];
    for i in 0..count {
        for j in 0..count {
            inverse[i][j] = if (i < translations) == (j < translations) {
                basis[j][i]
            } else if i < translations {
                let over = |k: usize| {
                    let turned = (translations..count)
                        .fold(S::zero(), |sum, l| sum + basis[k][l] * basis[j][l]);
                    basis[k][i] * turned
                };
                -(0..translations).fold(S::zero(), |sum, k| sum + over(k))
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
    /// Returns efforts along the basis vectors, from efforts along the rates.
    pub fn to_basis(&self, efforts: &[S]) -> Vec<S> {
        (0..self.columns.len())
            .map(|j| {
                self.inverse.iter().zip(efforts).fold(S::zero(), |sum, (row, &x)| sum + row[j] * x)
            })
            .collect()
    }

    /// Returns rates, or accelerations, from `amounts` along the basis vectors.
    pub fn to_rates(&self, amounts: &[S]) -> Vec<S> {
        self.inverse.iter().map(|row| dot(row, amounts)).collect()
    }

    /// Returns the wrench in the hinge with exact entries along the free axes, where the wrench
    /// equals the effort.
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
