//! Hinges: how each turns and shifts its outboard frame against its inboard one, and which
//! directions it leaves free. One file a kind, the same functions in the same order.
//!
//! A new kind is a variant of [`HingeKind`] and four files, each with its line in the list beside
//! it: its words in `model/lower/hinge`, its numbers in `model/hinge`, its equations here, and the
//! view of its coordinates in the runtime's `hinge`.
//!
//! A hinge is crossed from the side that motion comes from (the *parent*) to the other (the
//! *child*). The parent is the inboard side, unless the chain is held at its end only: then the
//! crossing is *reversed*. Each kind may choose axes that suit it, *aligned* with its free
//! directions and fixed in both of its frames.

mod ball;
mod floating;
mod pin;
mod weld;

use super::Numbers;
use crate::math::{Mat3, Motion, Rotation, Scalar, Turn, Vec3, Wrench};
use crate::model::HingeKind;

/// The geometry of a hinge at given coordinates.
#[derive(Clone, Debug)]
pub struct Crossing<S> {
    /// Aligned child axes to aligned parent axes.
    pub rotation: Mat3<S>,
    /// The same, if it is a turn about one of the aligned axes.
    pub turn: Option<Turn<S>>,
    /// From the parent's point to the child's, aligned parent axes.
    pub offset: Vec3<S>,
}

/// Aligned axes of a hinge's two sides, to the axes that the child's equations are written in.
#[derive(Clone, Copy, Debug)]
pub struct WorkAxes<S> {
    /// Whether the work axes are the aligned child axes.
    pub aligned: bool,
    /// From aligned parent axes.
    pub from_parent: Mat3<S>,
    /// From aligned child axes.
    pub from_child: Mat3<S>,
}

/// The directions that a hinge leaves free, in the work axes of the child.
///
/// The child moves against the parent by `Σ columns[i] · basis[i][j] · v[j]`. The basis is
/// orthogonal, so that `columnsᵀ F = basis · τ` and `v̇ = basisᵀ β` for `a = … + Σ columns[i] β[i]`.
#[derive(Clone, Debug)]
pub struct Freedom<S> {
    /// The free directions.
    pub columns: Vec<Column<S>>,
    /// From rates to the amounts of the columns.
    pub basis: Vec<Vec<S>>,
}

/// A free direction.
#[derive(Clone, Copy, Debug)]
pub enum Column<S> {
    /// Along (0 to 2) or about (3 to 5) one of the work axes: what is eliminated along it can be
    /// set to exactly zero.
    Axis(usize),
    /// Any other.
    General(Motion<S>),
}

impl<S: Scalar> Column<S> {
    /// Whether it is a shift along an axis; anything else is measured by moments of inertia.
    pub fn is_linear(&self) -> bool {
        matches!(self, Column::Axis(axis) if *axis < 3)
    }

    /// The direction's six entries.
    pub fn motion(&self) -> Motion<S> {
        match self {
            Column::Axis(axis) => {
                Motion::from_fn(|k| if k == *axis { S::one() } else { S::zero() })
            }
            Column::General(motion) => *motion,
        }
    }
}

impl<S: Scalar> Freedom<S> {
    /// The amounts of the columns that belong to `rates`, or to efforts.
    pub fn amounts(&self, rates: &[S]) -> Vec<S> {
        self.basis
            .iter()
            .map(|row| row.iter().zip(rates).fold(S::zero(), |sum, (&b, &v)| sum + b * v))
            .collect()
    }

    /// The rates, or accelerations, that belong to `amounts` of the columns.
    pub fn rates(&self, amounts: &[S]) -> Vec<S> {
        (0..amounts.len())
            .map(|j| {
                self.basis.iter().zip(amounts).fold(S::zero(), |sum, (row, &x)| sum + row[j] * x)
            })
            .collect()
    }

    /// A wrench over the hinge, with the efforts put where the free axes leave nothing else.
    pub fn released(&self, wrench: Wrench<S>, efforts: &[S]) -> Wrench<S> {
        let amounts = self.amounts(efforts);
        let along = |k: usize| {
            let is_axis = |column: &Column<S>| matches!(column, Column::Axis(axis) if *axis == k);
            self.columns.iter().position(is_axis)
        };
        Wrench::from_fn(|k| along(k).map_or(wrench.at(k), |column| amounts[column]))
    }

    /// The motion of the child against the parent at `rates`.
    pub fn motion(&self, rates: &[S]) -> Motion<S> {
        let amounts = self.amounts(rates);
        self.columns
            .iter()
            .zip(amounts)
            .fold(Motion::zero(), |sum, (column, x)| sum + column.motion().scaled(x))
    }
}

/// The rotation from aligned axes to those of the hinge's frames.
pub fn alignment<S: Scalar>(kind: &HingeKind, numbers: &Numbers<S>) -> Mat3<S> {
    match kind {
        HingeKind::Pin { axis } => pin::alignment(axis, numbers).rotation,
        HingeKind::Weld | HingeKind::Ball | HingeKind::Floating => Mat3::identity(),
    }
}

/// The crossing of a hinge from inboard to outboard.
pub fn crossing<S: Scalar>(kind: &HingeKind, numbers: &Numbers<S>, q: &[S]) -> Crossing<S> {
    match kind {
        HingeKind::Weld => weld::crossing(),
        HingeKind::Pin { axis } => pin::crossing(axis, numbers, q),
        HingeKind::Ball => ball::crossing(q),
        HingeKind::Floating => floating::crossing(q),
    }
}

/// What a hinge leaves free.
pub fn freedom<S: Scalar>(
    kind: &HingeKind,
    numbers: &Numbers<S>,
    axes: WorkAxes<S>,
    reversed: bool,
) -> Freedom<S> {
    match kind {
        HingeKind::Weld => weld::freedom(),
        HingeKind::Pin { axis } => pin::freedom(axis, numbers, axes, reversed),
        HingeKind::Ball => ball::freedom(axes, reversed),
        HingeKind::Floating => floating::freedom(axes, reversed),
    }
}

/// The time derivative of the coordinates.
pub fn coordinate_rates<S: Scalar>(kind: &HingeKind, q: &[S], v: &[S]) -> Vec<S> {
    match kind {
        HingeKind::Weld => Vec::new(),
        HingeKind::Pin { .. } => pin::coordinate_rates(v),
        HingeKind::Ball => ball::coordinate_rates(q, v),
        HingeKind::Floating => floating::coordinate_rates(q, v),
    }
}

/// The coordinates with quaternions put back to unit length.
pub fn normalized<S: Scalar>(kind: &HingeKind, q: &[S]) -> Vec<S> {
    match kind {
        HingeKind::Weld | HingeKind::Pin { .. } => q.to_vec(),
        HingeKind::Ball => ball::normalized(q),
        HingeKind::Floating => floating::normalized(q),
    }
}

impl<S: Scalar> Crossing<S> {
    /// The crossing in the other direction.
    pub fn reversed(self) -> Self {
        let rotation = self.rotation.transposed();
        let turn = self.turn.map(Turn::reversed);
        Crossing { rotation, turn, offset: -(rotation * self.offset) }
    }

    /// Its rotation followed by the fixed one of the parent's side.
    pub fn mounted_on(&self, side: Mat3<S>) -> Rotation<S> {
        match self.turn {
            Some(turn) => Rotation::mounted(side, turn),
            None => Rotation::general(side * self.rotation),
        }
    }
}

/// A square block of a basis.
fn rows<S: Scalar>(matrix: Mat3<S>) -> Vec<Vec<S>> {
    matrix.0.iter().map(|row| row.to_vec()).collect()
}
