//! Spatial algebra: motions, wrenches and inertias. `shifted_*` changes the point, `rotated*` the
//! axes.

use super::{AxisRotation, Mat3, PlaneFormula, Rotation, Scalar, Sym3, Vec3};
use std::ops::{Add, Sub};

/// A spatial motion: an acceleration `a = [r̈; Ω̇]`, or a velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<S> {
    /// Linear part, of the point.
    pub linear: Vec3<S>,
    /// Angular part, of the frame.
    pub angular: Vec3<S>,
}

/// A wrench `F = [q; n]`, dual to a motion. The internal moment of the paper is `m = −n`.
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

    /// The unit motion along axis `k` (0 to 2) or about axis `k − 3`.
    pub fn unit(k: usize) -> Self {
        Motion::from_fn(|i| if i == k { S::one() } else { S::zero() })
    }

    /// Returns entry `k` of the six: linear, then angular.
    pub fn at(&self, k: usize) -> S {
        if k < 3 { self.linear[k] } else { self.angular[k - 3] }
    }

    /// The motion with the entries `entry(k)`.
    pub fn from_fn(entry: impl Fn(usize) -> S) -> Self {
        Motion { linear: Vec3::from_fn(&entry), angular: Vec3::from_fn(|k| entry(k + 3)) }
    }

    /// Returns the motion of the point at `r` of the same rigid body, without terms of velocities.
    pub fn shifted_to(self, r: Vec3<S>) -> Self {
        Motion { linear: self.linear + self.angular.cross(r), angular: self.angular }
    }

    /// Returns the motion in the axes that `rotation` leads to.
    pub fn rotated(self, rotation: Mat3<S>) -> Self {
        Motion { linear: rotation * self.linear, angular: rotation * self.angular }
    }

    /// Returns the motion in the axes that `rotation` starts from.
    pub fn rotated_back(self, rotation: &Rotation<S>) -> Self {
        Motion {
            linear: rotation.rotate_back(self.linear),
            angular: rotation.rotate_back(self.angular),
        }
    }

    /// Returns the motion with another entry `k`.
    pub fn with_entry(&self, k: usize, value: S) -> Self {
        Motion::from_fn(|i| if i == k { value } else { self.at(i) })
    }

    /// Returns the power of a wrench on this motion.
    pub fn power(self, wrench: Wrench<S>) -> S {
        self.linear.dot(wrench.force) + self.angular.dot(wrench.moment)
    }

    /// Returns the motion times `factor`.
    pub fn scaled(self, factor: S) -> Self {
        Motion { linear: self.linear * factor, angular: self.angular * factor }
    }
}

impl<S: Scalar> Wrench<S> {
    /// No load.
    pub fn zero() -> Self {
        Wrench { force: Vec3::zero(), moment: Vec3::zero() }
    }

    /// The unit wrench along axis `k` (0 to 2) or about axis `k − 3`.
    pub fn unit(k: usize) -> Self {
        Wrench::from_fn(|i| if i == k { S::one() } else { S::zero() })
    }

    /// Returns entry `k` of the six: force, then moment.
    pub fn at(&self, k: usize) -> S {
        if k < 3 { self.force[k] } else { self.moment[k - 3] }
    }

    /// The wrench with the entries `entry(k)`.
    pub fn from_fn(entry: impl Fn(usize) -> S) -> Self {
        Wrench { force: Vec3::from_fn(&entry), moment: Vec3::from_fn(|k| entry(k + 3)) }
    }

    /// Returns the wrench about the origin, of a wrench about the point at `r`.
    pub fn shifted_from(self, r: Vec3<S>) -> Self {
        Wrench { force: self.force, moment: self.moment + r.cross(self.force) }
    }

    /// Returns the wrench in the axes that `rotation` leads to.
    pub fn rotated(self, rotation: &Rotation<S>) -> Self {
        Wrench { force: rotation.rotate(self.force), moment: rotation.rotate(self.moment) }
    }

    /// Returns the wrench in the axes that `rotation` starts from.
    pub fn rotated_back(self, rotation: &Rotation<S>) -> Self {
        Wrench {
            force: rotation.rotate_back(self.force),
            moment: rotation.rotate_back(self.moment),
        }
    }

    /// Returns the opposite wrench.
    pub fn reversed(self) -> Self {
        Wrench { force: -self.force, moment: -self.moment }
    }

    /// Returns the wrench times `factor`.
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

/// A spatial inertia: the symmetric 6×6 matrix `I` of `F = I a`, by blocks.
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
    /// Returns the inertia of a rigid body about a point, from mass, first moment `m r_C` and
    /// rotational inertia about that point.
    ///
    /// `I = [[m 1, −m r̃_C], [m r̃_C, J]]`: the acceleration columns of [P, Eqs. (18), (19)].
    pub fn rigid(mass: S, moment: Vec3<S>, inertia: Sym3<S>) -> Self {
        SpatialInertia {
            linear: Sym3::diagonal([mass; 3]),
            coupling: -moment.skew(),
            angular: inertia,
        }
    }

    /// Returns entry (i, j) of the 6×6 matrix.
    pub fn at(&self, i: usize, j: usize) -> S {
        match (i < 3, j < 3) {
            (true, true) => self.linear.at(i, j),
            (true, false) => self.coupling[i][j - 3],
            (false, true) => self.coupling[j][i - 3],
            (false, false) => self.angular.at(i - 3, j - 3),
        }
    }

    /// The inertia with `entry(i, j)`, which is called for the upper triangle of blocks.
    pub fn from_fn(entry: impl Fn(usize, usize) -> S) -> Self {
        SpatialInertia {
            linear: Sym3::from_fn(&entry),
            coupling: Mat3::from_fn(|i, j| entry(i, j + 3)),
            angular: Sym3::from_fn(|i, j| entry(i + 3, j + 3)),
        }
    }

    /// Returns `I a`.
    pub fn times(&self, motion: Motion<S>) -> Wrench<S> {
        Wrench {
            force: self.linear * motion.linear + self.coupling * motion.angular,
            moment: self.coupling.transposed() * motion.linear + self.angular * motion.angular,
        }
    }

    /// Returns the inertia in the axes that `rotation` leads to.
    pub fn rotated(&self, rotation: Mat3<S>) -> Self {
        SpatialInertia {
            linear: rotation.rotate_tensor(self.linear),
            coupling: rotation * self.coupling * rotation.transposed(),
            angular: rotation.rotate_tensor(self.angular),
        }
    }

    /// Returns `Xᵀ I X` with `X = [[1, −r̃], [0, 1]]`: the inertia about the origin, of an inertia
    /// about the point at `r`.
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
    /// Returns an inertia in the axes that the rotation leads to. `formula` is for the first of two
    /// steps.
    pub fn rotate_inertia(
        &self,
        inertia: &SpatialInertia<S>,
        formula: PlaneFormula,
    ) -> SpatialInertia<S> {
        match &self.steps {
            Some((step, mount)) => step.rotate_inertia(inertia, formula).rotated(*mount),
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
