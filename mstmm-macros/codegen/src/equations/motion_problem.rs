//! The linear problem that both methods solve: the motion of the links under given forces, efforts
//! and bias accelerations, with or without loop constraints.
//!
//! `a` and `F` belong to the point of a link, in its work axes. `a` stands for accelerations, or
//! for changes of velocities. With the inertia `I` and the bias force `p` of a part:
//!
//! (1)  `a = X a_p + b + Σ s v̇`
//! (2)  `F = I a + p + Σ Xᵀ F_c`, `sᵀ F = τ`
//! (3)  `Tᵀ a = r` at the loop hinge

use super::base_parameters::OriginalInertia;
use super::constraint_forces::{ConstraintForces, ConstraintRank};
use super::kinematics::{BiasAcceleration, LinkKinematics};
use super::loop_hinge::LoopHinge;
use super::sweep::{LinkTree, PerLink};
use crate::ids::LinkId;
use crate::math::{Motion, Scalar, SpatialInertia, Wrench};
use crate::model::{Dimension, Layout};

/// A pivot of the Riccati transfer. It must be positive, or the accelerations are meaningless.
#[derive(Clone, Copy, Debug)]
pub struct HingePivot<S> {
    /// The link whose hinge has the degree of freedom.
    pub link: LinkId,
    /// The pivot `D`.
    pub value: S,
    /// The scale of the pivot: its rounding error is a few units in the last place of the scale.
    pub scale: S,
}

/// The data of the problem.
#[derive(Clone, Debug)]
pub struct MotionProblem<'a, S> {
    /// The kinematics of the links.
    pub links: &'a PerLink<LinkKinematics<S>>,
    /// The dimension, whose axes the problem is restricted to.
    pub dimension: Dimension,
    /// The tree of links that the sweeps run over.
    pub tree: LinkTree<'a, S>,
    /// The bias acceleration `b` of every hinge.
    pub bias_accelerations: PerLink<BiasAcceleration<S>>,
    /// The bias force `p` of every link's own part: the part of `F` that does not depend on `a`.
    pub bias_forces: PerLink<Wrench<S>>,
    /// The efforts `τ` along the basis vectors of every hinge.
    pub efforts: PerLink<Vec<S>>,
    /// The acceleration `a` of the ground.
    pub base_acceleration: Motion<S>,
    /// The loop constraints, if the chain is closed.
    pub loop_constraints: Option<LoopConstraints<'a, S>>,
    /// The inertias of the links before the change to base parameters, if it was made.
    pub original_inertias: Option<PerLink<OriginalInertia<S>>>,
    /// An inertia added to a link's own, if any.
    pub added_inertia: Option<(LinkId, SpatialInertia<S>)>,
}

/// The loop constraints: equation (3).
#[derive(Clone, Debug)]
pub struct LoopConstraints<'a, S> {
    /// The loop hinge.
    pub loop_hinge: &'a LoopHinge<S>,
    /// The targets `r`: one entry for each constraint.
    pub targets: Vec<S>,
    /// The wrench in the loop hinge that does not depend on the constraint forces.
    pub applied: Wrench<S>,
    /// The rank of the constraints.
    pub rank: ConstraintRank<S>,
}

/// A wrench as an affine function of the acceleration, `F = Iᴬ a' + pᴬ`, with `a'` the acceleration
/// from the parent.
#[derive(Clone, Copy, Debug)]
pub struct AffineWrench<S> {
    /// `Iᴬ`
    pub inertia: SpatialInertia<S>,
    /// `pᴬ`
    pub bias_force: Wrench<S>,
}

impl<S: Scalar> AffineWrench<S> {
    /// Returns `F` at this `a'`.
    pub fn at(&self, a: Motion<S>) -> Wrench<S> {
        self.inertia.times(a) + self.bias_force
    }
}

/// The solution of the problem.
#[derive(Clone, Debug)]
pub struct MotionSolution<S> {
    /// Accelerations `v̇` along the basis vectors of every hinge.
    pub basis_accelerations: PerLink<Vec<S>>,
    /// `a` of every link's point.
    pub link_accelerations: PerLink<Motion<S>>,
    /// The wrench in every hinge as a function of the acceleration from the parent. Empty for a
    /// closed chain, whose wrenches also depend on the constraint forces.
    pub affine_wrenches: PerLink<AffineWrench<S>>,
    /// The constraint forces, and their undetermined directions.
    pub constraint_forces: ConstraintForces<S>,
}

impl<S: Scalar> MotionProblem<'_, S> {
    /// Returns the problem with inertia added along the constraints. The added term `μ p (pᵀ a −
    /// r)` vanishes, since `pᵀ a = r`, but without it a body without inertia along `p` would have a
    /// zero pivot before the constraints apply.
    pub fn with_added_inertia(mut self) -> Self {
        let (Some(constraints), Some((link, wrenches))) =
            (&self.loop_constraints, self.constraint_wrenches())
        else {
            return self;
        };
        let mass = self.links.iter().fold(S::zero(), |sum, link| sum + link.mass);
        let inertia = self.links.iter().fold(S::zero(), |sum, link| {
            sum + link.inertia.trace() + link.mass * link.hinge.arm.dot(link.hinge.arm)
        });
        let mut added = SpatialInertia::from_fn(|_, _| S::zero());
        let mut load = self.bias_forces[link];
        for ((constraint, wrench), &target) in
            constraints.loop_hinge.constraints.iter().zip(&wrenches).zip(&constraints.targets)
        {
            if !constraint.inertia.vanishes() {
                continue;
            }
            let is_angular = constraint.wrench.force.0.iter().all(|part| part.vanishes());
            let scaled = wrench.scaled(if is_angular { inertia } else { mass });
            added = added + SpatialInertia::from_fn(|i, j| scaled.at(i) * wrench.at(j));
            load = load - scaled.scaled(target);
        }
        self.bias_forces[link] = load;
        self.added_inertia = Some((link, added));
        self
    }

    /// Returns the spatial inertia of a link's own part, with the added inertia.
    pub fn inertia(&self, link: LinkId) -> SpatialInertia<S> {
        let inertia = self.links[link].spatial_inertia();
        match self.added_inertia {
            Some((to, added)) if to == link => inertia + added,
            _ => inertia,
        }
    }

    /// Returns the scales of the pivots along translations and about axes, of a link's own part.
    pub fn pivot_scales(&self, link: LinkId) -> (S, S) {
        let inertia = self.inertia(link);
        let scales = (inertia.linear.at(0, 0), inertia.angular.trace());
        self.original_inertias.as_ref().map_or(scales, |originals| originals[link].scales)
    }

    /// Returns the mass that a link has transferred to its parent.
    pub fn transferred_mass(&self, link: LinkId) -> S {
        self.original_inertias
            .as_ref()
            .map_or(S::zero(), |originals| originals[link].transferred_mass)
    }

    /// Returns `a' = X a_p + b` of a link's point, from `a` of its parent's point.
    pub fn acceleration_from_parent(&self, link: LinkId, parent: Motion<S>) -> Motion<S> {
        self.links[link].hinge.acceleration_from_parent(parent, self.bias_accelerations[link])
    }

    /// Returns `a` of the point of a link's parent, from `a` of all links.
    pub fn parent_acceleration(
        &self,
        link: LinkId,
        accelerations: &PerLink<Motion<S>>,
    ) -> Motion<S> {
        self.links[link].parent.map_or(self.base_acceleration, |parent| accelerations[parent])
    }

    /// Returns the link inboard of the loop hinge, and the wrenches of unit constraint forces on
    /// that link about its point.
    pub fn constraint_wrenches(&self) -> Option<(LinkId, Vec<Wrench<S>>)> {
        let loop_hinge = self.loop_constraints.as_ref()?.loop_hinge;
        let parent = loop_hinge.parent?;
        let wrenches = loop_hinge
            .constraints
            .iter()
            .map(|constraint| loop_hinge.hinge.wrench_to_parent(constraint.wrench))
            .collect();
        Some((parent, wrenches))
    }

    /// Returns `Tᵀ X a` at the loop hinge, if its inboard side is the ground.
    pub fn gamma_on_ground(&self) -> Vec<S> {
        let Some(LoopConstraints { loop_hinge, .. }) = &self.loop_constraints else {
            return Vec::new();
        };
        let a = loop_hinge.hinge.motion_from_parent(self.base_acceleration);
        loop_hinge.constraints.iter().map(|constraint| a.power(constraint.wrench)).collect()
    }
}

impl<S: Scalar> MotionSolution<S> {
    /// Returns the accelerations of the rates of all links' hinges, in the layout's order; zero for
    /// a hinge that has no link.
    pub fn rates(&self, links: &PerLink<LinkKinematics<S>>, layout: &Layout) -> Vec<S> {
        let mut rates = vec![S::zero(); layout.dof_count()];
        links.iter().zip(&self.basis_accelerations).for_each(
            |(LinkKinematics { hinge, .. }, accelerations)| {
                rates[layout.v[hinge.id].clone()]
                    .copy_from_slice(&hinge.basis.to_rates(accelerations));
            },
        );
        rates
    }
}

/// Returns `Σ s x` over the basis vectors of a link's hinge.
pub fn basis_motion<S: Scalar>(link: &LinkKinematics<S>, amounts: &[S]) -> Motion<S> {
    let columns = link.hinge.basis.columns.iter().map(|column| column.motion());
    columns.zip(amounts).fold(Motion::zero(), |sum, (motion, &x)| sum + motion.scaled(x))
}
