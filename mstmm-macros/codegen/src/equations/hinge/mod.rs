//! Hinges: how each turns and shifts its outboard frame against its inboard one, and which
//! directions it leaves free. One file a kind.
//!
//! Each kind is one [`HingeLaw`]; `CONTRIBUTING.md` lists what else a new kind needs. What follows
//! from the law, what acts along the free directions and how hinges close a loop is the same for
//! all.
//!
//! A hinge is crossed from the side that motion comes from (the *parent*) to the other (the
//! *child*). The parent is the inboard side, unless the chain is held at its end only: then the
//! crossing is *reversed*. Each kind may choose axes that suit it, *aligned* with its free
//! directions and fixed in both of its frames.

mod axis;
mod ball;
mod cylindrical;
mod elastic;
mod floating;
mod force_laws;
mod kinds;
mod law;
mod passive_elements;
mod pin;
mod planar;
mod plane_elastic;
mod rows;
mod screw;
mod slider;
mod strain;
mod subspace_basis;
mod transform;
mod universal;
mod weld;

pub use law::HingeLaw;
pub use passive_elements::{PassiveElements, passive_elements};
pub use rows::{dot, identity};
pub use strain::StrainMap;
pub use subspace_basis::{BasisVector, SubspaceBasis, empty_basis, subspace_basis};
pub use transform::{HingeTransform, ToWorkAxes, combine, hinge_transform};

use crate::math::{AxisRotation, Mat3, Motion, Scalar, Vec3};
use crate::model::HingeKind;

/// A hinge at given coordinates, in aligned axes.
#[derive(Clone, Debug)]
pub struct HingeGeometry<S> {
    /// Outboard axes to inboard ones.
    pub rotation: Mat3<S>,
    /// The same, if it is a turn about one of the axes.
    pub axis_rotation: Option<AxisRotation<S>>,
    /// From the inboard origin to the outboard one, inboard axes.
    pub offset: Vec3<S>,
    /// What each rate does: `S`, column by column.
    pub columns: Vec<SubspaceColumn<S>>,
}

/// A free direction, constant in the axes of one side: the motion of the outboard origin and frame
/// against the inboard frame.
#[derive(Clone, Copy, Debug)]
pub struct SubspaceColumn<S> {
    /// Whether it is fixed on the outboard side.
    pub on_outboard: bool,
    /// Its six entries, in aligned axes of that side.
    pub motion: Motion<S>,
}

impl<S: Scalar> HingeGeometry<S> {
    /// Both frames coincide, and nothing is free.
    fn fixed() -> Self {
        HingeGeometry {
            rotation: Mat3::identity(),
            axis_rotation: None,
            offset: Vec3::zero(),
            columns: Vec::new(),
        }
    }

    /// The outboard frame is turned about an axis.
    fn rotated(rotation: AxisRotation<S>) -> Self {
        HingeGeometry {
            rotation: rotation.matrix(),
            axis_rotation: Some(rotation),
            ..HingeGeometry::fixed()
        }
    }
}

impl<S: Scalar> SubspaceColumn<S> {
    /// Fixed on the inboard side.
    fn inboard(motion: Motion<S>) -> Self {
        SubspaceColumn { on_outboard: false, motion }
    }

    /// A shift along a vector fixed on the inboard side.
    fn translation(linear: Vec3<S>) -> Self {
        SubspaceColumn::inboard(Motion { linear, angular: Vec3::zero() })
    }

    /// A turn about a vector fixed on the inboard side.
    fn rotation(angular: Vec3<S>) -> Self {
        SubspaceColumn::inboard(Motion { linear: Vec3::zero(), angular })
    }

    /// The same entries, but fixed on the outboard side.
    fn outboard(self) -> Self {
        SubspaceColumn { on_outboard: true, ..self }
    }
}

/// The time derivative of the coordinates of a hinge.
pub fn coordinate_rates<S: Scalar>(kind: &HingeKind, q: &[S], v: &[S]) -> Vec<S> {
    kind.law().coordinate_rates(q, v)
}

/// The coordinates of a hinge with quaternions put back to unit length.
pub fn normalized<S: Scalar>(kind: &HingeKind, q: &[S]) -> Vec<S> {
    kind.law().normalized(q)
}
