//! Momentum of a chain.

use nalgebra::{Vector2, Vector3};

/// The momentum of a chain in space, inertial axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Momentum<T> {
    /// The mass of all bodies in kg, also of those that are fixed to the ground.
    #[doc(alias("total mass", "CalcTotalMass", "computeTotalMass", "mj_getTotalmass"))]
    pub mass: T,
    /// The centre of mass in m.
    #[doc(alias("centre of mass", "CoM", "centerOfMass", "CalcCenterOfMassPositionInWorld"))]
    #[doc(alias("mj_comPos", "subtree_com", "subtreecom"))]
    pub center_of_mass: Vector3<T>,
    /// Linear momentum in kg m/s.
    #[doc(alias("mj_subtreeVel", "subtree_linvel", "subtreelinvel"))]
    #[doc(alias("CalcCenterOfMassTranslationalVelocityInWorld"))]
    pub linear: Vector3<T>,
    /// Angular momentum about the centre of mass in kg m²/s.
    #[doc(alias("centroidal momentum", "computeCentroidalMomentum", "subtree_angmom"))]
    #[doc(alias("subtreeangmom", "CalcSpatialMomentumInWorldAboutPoint"))]
    pub angular: Vector3<T>,
}

/// The momentum of a chain in a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneMomentum<T> {
    /// The mass of all bodies in kg.
    pub mass: T,
    /// The centre of mass in m.
    pub center_of_mass: Vector2<T>,
    /// Linear momentum in kg m/s.
    pub linear: Vector2<T>,
    /// Angular momentum about the centre of mass in kg m²/s.
    pub angular: T,
}

/// The momentum of a chain on a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineMomentum<T> {
    /// The mass of all bodies in kg.
    pub mass: T,
    /// The centre of mass in m.
    pub center_of_mass: T,
    /// Momentum in kg m/s.
    pub linear: T,
}

impl<T> Momentum<T> {
    #[doc(hidden)]
    pub fn of([mass, x, y, z, px, py, pz, lx, ly, lz]: [T; 10]) -> Self {
        Momentum {
            mass,
            center_of_mass: Vector3::new(x, y, z),
            linear: Vector3::new(px, py, pz),
            angular: Vector3::new(lx, ly, lz),
        }
    }
}

impl<T> PlaneMomentum<T> {
    #[doc(hidden)]
    pub fn of([mass, x, y, px, py, angular]: [T; 6]) -> Self {
        let (center_of_mass, linear) = (Vector2::new(x, y), Vector2::new(px, py));
        PlaneMomentum { mass, center_of_mass, linear, angular }
    }
}

impl<T> LineMomentum<T> {
    #[doc(hidden)]
    pub fn of([mass, center_of_mass, linear]: [T; 3]) -> Self {
        LineMomentum { mass, center_of_mass, linear }
    }
}
