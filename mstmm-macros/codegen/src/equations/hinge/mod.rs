//! Hinges (joints): how each kind rotates and translates its outboard frame relative to its inboard
//! frame, and its motion subspace. There is one file for each kind.
//!
//! Each kind is one [`HingeLaw`]; `CONTRIBUTING.md` lists what else a new kind needs. Everything
//! that follows from the law, passive elements and the closing of loops are the same for all kinds.
//!
//! Frames: a hinge leads from its *parent* side to its *child* side. The parent is on the inboard
//! side, unless the chain is held at its end only: then the hinge is *reversed*. Each kind may
//! choose *aligned* axes, fixed in both of its frames, in which its motion subspace has the most
//! zeros.

mod axis;
mod ball;
mod cylindrical;
mod displacement;
mod elastic;
mod floating;
mod force_laws;
mod gimbal;
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

pub use displacement::displaced;
pub use law::HingeLaw;
pub use passive_elements::{PassiveElements, passive_elements, rotor_coriolis};
pub use rows::{dot, identity};
pub use strain::StrainMap;
pub use subspace_basis::{BasisVector, SubspaceBasis, empty_basis, subspace_basis};
pub use transform::{HingeTransform, ToWorkAxes, combine, hinge_transform};

use crate::math::{AxisRotation, FrameOrientation, Motion, Scalar, Vec3};
use crate::model::HingeKind;

/// The geometry of a hinge at given coordinates, in aligned axes.
#[derive(Clone, Debug)]
pub struct HingeGeometry<S> {
    /// Rotation from outboard axes to inboard axes.
    pub rotation: FrameOrientation<S>,
    /// The same rotation, if it is about one of the axes.
    pub axis_rotation: Option<AxisRotation<S>>,
    /// From the inboard origin to the outboard origin in m, inboard axes.
    pub offset: Vec3<S>,
    /// The motion subspace `S`, one column for each rate.
    pub columns: Vec<SubspaceColumn<S>>,
}

/// A column of the motion subspace, constant in one frame of the hinge: the motion of the outboard
/// origin and frame relative to the inboard frame.
#[derive(Clone, Copy, Debug)]
pub struct SubspaceColumn<S> {
    /// The frame in which the column is constant.
    pub frame: ColumnFrame,
    /// The six entries: in aligned axes of the outboard side if the column is constant there, in
    /// those of the inboard side otherwise.
    pub motion: Motion<S>,
}

/// The frame in which a column of the motion subspace is constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnFrame {
    /// The inboard frame.
    Inboard,
    /// A frame between both sides. The inboard columns move it relative to the inboard frame, and the
    /// outboard frame moves relative to it by the middle columns, then by the outboard columns. A kind
    /// of hinge with such a column has rotations only.
    Middle,
    /// The outboard frame.
    Outboard,
}

impl<S: Scalar> HingeGeometry<S> {
    /// Both frames coincide; no degree of freedom.
    fn fixed() -> Self {
        HingeGeometry {
            rotation: FrameOrientation::identity(),
            axis_rotation: None,
            offset: Vec3::zero(),
            columns: Vec::new(),
        }
    }

    /// The outboard frame is rotated about one axis.
    fn rotated(rotation: AxisRotation<S>) -> Self {
        HingeGeometry {
            rotation: FrameOrientation::from_matrix(rotation.matrix()),
            axis_rotation: Some(rotation),
            ..HingeGeometry::fixed()
        }
    }
}

impl<S: Scalar> SubspaceColumn<S> {
    /// A column fixed on the inboard side.
    fn inboard(motion: Motion<S>) -> Self {
        SubspaceColumn { frame: ColumnFrame::Inboard, motion }
    }

    /// A translation along a vector fixed on the inboard side.
    fn translation(linear: Vec3<S>) -> Self {
        SubspaceColumn::inboard(Motion { linear, angular: Vec3::zero() })
    }

    /// A rotation about a vector fixed on the inboard side.
    fn rotation(angular: Vec3<S>) -> Self {
        SubspaceColumn::inboard(Motion { linear: Vec3::zero(), angular })
    }

    /// Returns the same entries fixed on the outboard side.
    fn outboard(self) -> Self {
        SubspaceColumn { frame: ColumnFrame::Outboard, ..self }
    }

    /// Returns the same entries fixed in the middle frame.
    fn middle(self) -> Self {
        SubspaceColumn { frame: ColumnFrame::Middle, ..self }
    }
}

/// Returns the time derivative of the coordinates of a hinge.
pub fn coordinate_rates<S: Scalar>(kind: &HingeKind, q: &[S], v: &[S]) -> Vec<S> {
    kind.law().coordinate_rates(q, v)
}

/// Returns the coordinates of a hinge with quaternions normalised to unit norm.
pub fn normalized<S: Scalar>(kind: &HingeKind, q: &[S]) -> Vec<S> {
    kind.law().normalized(q)
}
