//! Mass, first moment and inertia of a rigid part.

use crate::math::{Motion, Scalar, SpatialInertia, Sym3, Vec3, Wrench};

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

    /// Returns the spatial inertia.
    pub fn spatial(&self) -> SpatialInertia<S> {
        SpatialInertia::rigid(self.mass, self.first_moment, self.inertia)
    }

    /// Returns the wrench that the velocities require, `[m Ω̃Ω̃ r_C; Ω × J Ω]`: `−E_5` of
    /// [P, Eq. (20)] and, about the point, the gyroscopic part of `E_9`.
    pub fn velocity_wrench(&self, omega: Vec3<S>) -> Wrench<S> {
        let moment = self.inertia.gyroscopic(omega);
        Wrench { force: self.first_moment.centripetal_by_products(omega), moment }
    }

    /// Returns `∫ [w × ṙ; r × (w × ṙ)] dm` with `ṙ = Ω × r`: the wrench that a part with the angular velocity
    /// `omega` requires if a field adds `w × ṙ` to the acceleration of each mass. For `w = Ω` it is the
    /// velocity wrench. The moment is `−Ω × (∫ r rᵀ dm w)`.
    pub fn coriolis_wrench(&self, omega: Vec3<S>, w: Vec3<S>) -> Wrench<S> {
        let half = self.inertia.trace() * S::number(0.5);
        let reduced = self.inertia + Sym3::diagonal([-half; 3]);
        let force = w.cross(omega.cross(self.first_moment));
        Wrench { force, moment: omega.cross(reduced * w) }
    }

    /// Returns the wrench about the point that a motion of the part requires, `I a + p`.
    pub fn needed_wrench(&self, acceleration: Motion<S>, omega: Vec3<S>) -> Wrench<S> {
        self.spatial().times(acceleration) + self.velocity_wrench(omega)
    }
}
