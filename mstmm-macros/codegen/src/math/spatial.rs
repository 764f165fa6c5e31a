//! Spatial quantities: what a connection point does, what is transmitted there, and the inertia
//! that links both.

use super::{AxisRotation, Mat3, PlaneFormula, Rotation, Scalar, Sym3, Vec3};
use std::ops::{Add, Sub};

/// `a = [r̈; Ω̇]`, or a rate of the same shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<S> {
    /// Of the point.
    pub linear: Vec3<S>,
    /// Of the frame.
    pub angular: Vec3<S>,
}

/// `F = [q; n]`, power-conjugate to a motion; the method's internal moment is `m = −n`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wrench<S> {
    /// Force.
    pub force: Vec3<S>,
    /// Moment about the point.
    pub moment: Vec3<S>,
}

impl<S: Scalar> Motion<S> {
    /// No motion.
    pub fn zero() -> Self {
        Motion { linear: Vec3::zero(), angular: Vec3::zero() }
    }

    /// Along or about axis `k` of the six.
    pub fn unit(k: usize) -> Self {
        Motion::from_fn(|i| if i == k { S::one() } else { S::zero() })
    }

    /// Entry `k` of the six: linear, then angular.
    pub fn at(&self, k: usize) -> S {
        if k < 3 { self.linear[k] } else { self.angular[k - 3] }
    }

    /// From its six entries.
    pub fn from_fn(entry: impl Fn(usize) -> S) -> Self {
        Motion { linear: Vec3::from_fn(&entry), angular: Vec3::from_fn(|k| entry(k + 3)) }
    }

    /// The part linear in the motion of the law of rigid bodies: the motion of the point at `r`.
    pub fn shifted_to(self, r: Vec3<S>) -> Self {
        Motion { linear: self.linear + self.angular.cross(r), angular: self.angular }
    }

    /// In the axes that `rotation` leads to.
    pub fn rotated(self, rotation: Mat3<S>) -> Self {
        Motion { linear: rotation * self.linear, angular: rotation * self.angular }
    }

    /// In the axes from which `rotation` leads here.
    pub fn rotated_back(self, rotation: &Rotation<S>) -> Self {
        Motion {
            linear: rotation.rotate_back(self.linear),
            angular: rotation.rotate_back(self.angular),
        }
    }

    /// With another number at a place.
    pub fn with_entry(&self, k: usize, value: S) -> Self {
        Motion::from_fn(|i| if i == k { value } else { self.at(i) })
    }

    /// Power of a wrench on this motion.
    pub fn power(self, wrench: Wrench<S>) -> S {
        self.linear.dot(wrench.force) + self.angular.dot(wrench.moment)
    }

    /// Times a number.
    pub fn scaled(self, factor: S) -> Self {
        Motion { linear: self.linear * factor, angular: self.angular * factor }
    }
}

impl<S: Scalar> Wrench<S> {
    /// No load.
    pub fn zero() -> Self {
        Wrench { force: Vec3::zero(), moment: Vec3::zero() }
    }

    /// Along or about axis `k` of the six.
    pub fn unit(k: usize) -> Self {
        Wrench::from_fn(|i| if i == k { S::one() } else { S::zero() })
    }

    /// Entry `k` of the six: force, then moment.
    pub fn at(&self, k: usize) -> S {
        if k < 3 { self.force[k] } else { self.moment[k - 3] }
    }

    /// From its six entries.
    pub fn from_fn(entry: impl Fn(usize) -> S) -> Self {
        Wrench { force: Vec3::from_fn(&entry), moment: Vec3::from_fn(|k| entry(k + 3)) }
    }

    /// The same load that acts at `r`, taken about the origin.
    pub fn shifted_from(self, r: Vec3<S>) -> Self {
        Wrench { force: self.force, moment: self.moment + r.cross(self.force) }
    }

    /// In the axes that `rotation` leads to.
    pub fn rotated(self, rotation: &Rotation<S>) -> Self {
        Wrench { force: rotation.rotate(self.force), moment: rotation.rotate(self.moment) }
    }

    /// In the axes from which `rotation` leads here.
    pub fn rotated_back(self, rotation: &Rotation<S>) -> Self {
        Wrench {
            force: rotation.rotate_back(self.force),
            moment: rotation.rotate_back(self.moment),
        }
    }

    /// The opposite load.
    pub fn reversed(self) -> Self {
        Wrench { force: -self.force, moment: -self.moment }
    }

    /// Times a number.
    pub fn scaled(self, factor: S) -> Self {
        Wrench { force: self.force * factor, moment: self.moment * factor }
    }
}

impl<S: Scalar> Add for Motion<S> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Motion { linear: self.linear + other.linear, angular: self.angular + other.angular }
    }
}

impl<S: Scalar> Add for Wrench<S> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Wrench { force: self.force + other.force, moment: self.moment + other.moment }
    }
}

impl<S: Scalar> Sub for Motion<S> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Motion { linear: self.linear - other.linear, angular: self.angular - other.angular }
    }
}

impl<S: Scalar> Sub for Wrench<S> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Wrench { force: self.force - other.force, moment: self.moment - other.moment }
    }
}

/// A symmetric 6×6 matrix `A` of `F = A a`, by blocks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialInertia<S> {
    /// Force per linear acceleration.
    pub linear: Sym3<S>,
    /// Force per angular acceleration; transposed, moment per linear acceleration.
    pub coupling: Mat3<S>,
    /// Moment per angular acceleration.
    pub angular: Sym3<S>,
}

impl<S: Scalar> SpatialInertia<S> {
    /// Of a rigid body about a point: mass, first moment `m r_C` and inertia about there.
    ///
    /// `M = [[m 1, −m r̃_C], [m r̃_C, J]]`, the acceleration columns of [P, Eqs. (18), (19)].
    pub fn rigid(mass: S, moment: Vec3<S>, inertia: Sym3<S>) -> Self {
        SpatialInertia {
            linear: Sym3::diagonal([mass; 3]),
            coupling: -moment.skew(),
            angular: inertia,
        }
    }

    /// Entry (i, j) of the six by six.
    pub fn at(&self, i: usize, j: usize) -> S {
        match (i < 3, j < 3) {
            (true, true) => self.linear.at(i, j),
            (true, false) => self.coupling[i][j - 3],
            (false, true) => self.coupling[j][i - 3],
            (false, false) => self.angular.at(i - 3, j - 3),
        }
    }

    /// From its entries, asked for in the blocks' order (row ≤ column).
    pub fn from_fn(entry: impl Fn(usize, usize) -> S) -> Self {
        SpatialInertia {
            linear: Sym3::from_fn(&entry),
            coupling: Mat3::from_fn(|i, j| entry(i, j + 3)),
            angular: Sym3::from_fn(|i, j| entry(i + 3, j + 3)),
        }
    }

    /// `A a`
    pub fn times(&self, motion: Motion<S>) -> Wrench<S> {
        Wrench {
            force: self.linear * motion.linear + self.coupling * motion.angular,
            moment: self.coupling.transposed() * motion.linear + self.angular * motion.angular,
        }
    }

    /// In the axes that `rotation` leads to.
    pub fn rotated(&self, rotation: Mat3<S>) -> Self {
        SpatialInertia {
            linear: rotation.rotate_tensor(self.linear),
            coupling: rotation * self.coupling * rotation.transposed(),
            angular: rotation.rotate_tensor(self.angular),
        }
    }

    /// `Xᵀ A X` with `X = [[1, −r̃], [0, 1]]`: an inertia at `r`, seen from the origin.
    pub fn shifted_from(&self, r: Vec3<S>) -> Self {
        let skew = r.skew();
        let coupling = self.coupling - self.linear.full() * skew;
        let (moved, old) = (skew * coupling, skew * self.coupling);
        SpatialInertia {
            linear: self.linear,
            coupling,
            angular: self.angular + Sym3::from_fn(|i, j| moved[i][j] + old[j][i]),
        }
    }
}

impl<S: Scalar> Rotation<S> {
    /// An inertia in the axes that the rotation leads to; the formula is that of the first of two
    /// steps.
    pub fn rotate_inertia(
        &self,
        inertia: &SpatialInertia<S>,
        formula: PlaneFormula,
    ) -> SpatialInertia<S> {
        match &self.steps {
            Some((turn, mount)) => turn.rotate_inertia(inertia, formula).rotated(*mount),
            None => inertia.rotated(self.matrix()),
        }
    }
}

impl<S: Scalar> AxisRotation<S> {
    fn rotate_inertia(
        &self,
        inertia: &SpatialInertia<S>,
        formula: PlaneFormula,
    ) -> SpatialInertia<S> {
        SpatialInertia {
            linear: match formula {
                PlaneFormula::FewestOperations => self.rotate_symmetric(inertia.linear),
                PlaneFormula::ShortestPath => self.rotate_in_plane(inertia.linear),
            },
            coupling: self.rotate_tensor(inertia.coupling),
            angular: self.rotate_symmetric(inertia.angular),
        }
    }
}

impl<S: Scalar> Add for SpatialInertia<S> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        SpatialInertia {
            linear: self.linear + other.linear,
            coupling: self.coupling + other.coupling,
            angular: self.angular + other.angular,
        }
    }
}
