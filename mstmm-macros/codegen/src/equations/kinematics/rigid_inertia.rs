//! Mass, first moment and inertia of a rigid part.

use crate::math::{Scalar, Sym3, Vec3};

/// The inertia of a rigid part about a point; the owner names point and axes.
#[derive(Clone, Copy, Debug)]
pub struct RigidInertia<S> {
    /// Mass `m`.
    pub mass: S,
    /// First moment `m r_C`.
    pub first_moment: Vec3<S>,
    /// Rotational inertia `J`.
    pub inertia: Sym3<S>,
}

impl<S: Scalar> RigidInertia<S> {
    /// No inertia.
    pub fn zero() -> Self {
        let (first_moment, inertia) = (Vec3::zero(), Sym3([S::zero(); 6]));
        RigidInertia { mass: S::zero(), first_moment, inertia }
    }
}
