//! The laws of all hinge kinds.

use super::{
    HingeLaw, ball::Ball, cylindrical::Cylindrical, elastic::Elastic, floating::Floating,
    gimbal::Gimbal, pin::Pin, planar::Planar, plane_elastic::PlaneElastic, screw::Screw,
    slider::Slider, universal::Universal, weld::Weld,
};
use crate::math::Scalar;
use crate::model::HingeKind;

impl HingeKind {
    /// Returns the law of this kind.
    pub fn law<S: Scalar>(&self) -> Box<dyn HingeLaw<S> + '_> {
        match self {
            HingeKind::Weld => Box::new(Weld),
            HingeKind::Pin { axis } => Box::new(Pin { axis }),
            HingeKind::Slider { axis } => Box::new(Slider { axis }),
            HingeKind::Screw { axis, pitch } => Box::new(Screw { axis, pitch }),
            HingeKind::Cylindrical { axis } => Box::new(Cylindrical { axis }),
            HingeKind::Universal { axes } => Box::new(Universal { axes }),
            HingeKind::Gimbal { axes } => Box::new(Gimbal { axes }),
            HingeKind::Ball => Box::new(Ball),
            HingeKind::Planar { normal } => Box::new(Planar { normal: *normal }),
            HingeKind::Floating => Box::new(Floating),
            HingeKind::Elastic => Box::new(Elastic),
            HingeKind::PlaneElastic => Box::new(PlaneElastic),
        }
    }
}
