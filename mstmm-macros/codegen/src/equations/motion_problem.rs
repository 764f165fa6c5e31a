//! The linear problem that both methods solve: how the links move under given loads, efforts and
//! velocities, with or without a closing hinge.

use super::base_parameters::OriginalInertia;
use super::constraint_forces::{ConstraintForces, ConstraintRank};
use super::kinematics::{BiasAcceleration, LinkKinematics};
use super::loop_hinge::LoopHinge;
use super::sweep::{LinkTree, PerLink};
use crate::ids::LinkId;
use crate::math::{Motion, Scalar, SpatialInertia, Wrench};
use crate::model::{Dimension, Layout};

/// A number that must be positive if the accelerations are to mean anything.
#[derive(Clone, Copy, Debug)]
pub struct HingePivot<S> {
    /// Index of the link that it belongs to.
    pub link: LinkId,
    /// The number.
    pub value: S,
    /// What it is measured by: rounding leaves a few units in the last place of this number.
    pub scale: S,
}

/// What the links are to do. `a` may be accelerations, or changes of velocities.
#[derive(Clone, Debug)]
pub struct MotionProblem<'a, S> {
    /// The links.
    pub links: &'a PerLink<LinkKinematics<S>>,
    /// The directions that matter.
    pub dimension: Dimension,
    /// The links, for sweeps.
    pub tree: LinkTree<'a, S>,
    /// What joins `a` at every link on the way from its parent.
    pub bias_accelerations: PerLink<BiasAcceleration<S>>,
    /// The part of the wrench at every link's point that does not hang on `a`, of its part alone.
    pub bias_forces: PerLink<Wrench<S>>,
    /// Efforts along the columns of every link.
    pub efforts: PerLink<Vec<S>>,
    /// `a` of the ground.
    pub base_acceleration: Motion<S>,
    /// The hinge that closes the chain, with what it demands, if there is one.
    pub loop_constraints: Option<LoopConstraints<'a, S>>,
    /// What the links had before their inertias were redistributed, if they were.
    pub original_inertias: Option<PerLink<OriginalInertia<S>>>,
    /// Inertia that a link has besides its own, if any.
    pub added_inertia: Option<(LinkId, SpatialInertia<S>)>,
}

/// What a closing hinge demands.
#[derive(Clone, Debug)]
pub struct LoopConstraints<'a, S> {
    /// The hinge.
    pub loop_hinge: &'a LoopHinge<S>,
    /// What `a` of the point reached from the inboard side has to be along each of the closing's
    /// directions: `r_j` of `T_jᵀ a = r_j`.
    pub targets: Vec<S>,
    /// The wrench in the closing hinge that does not hang on its reactions.
    pub applied: Wrench<S>,
    /// What there is to know of the linkage.
    pub rank: ConstraintRank<S>,
}

/// `F = Iᴬ a' + pᴬ`: what a hinge transmits, with `a'` of the parent carried over.
#[derive(Clone, Copy, Debug)]
pub struct AffineWrench<S> {
    /// `Iᴬ`
    pub inertia: SpatialInertia<S>,
    /// `pᴬ`
    pub bias_force: Wrench<S>,
}

impl<S: Scalar> AffineWrench<S> {
    /// `F` with this `a'`.
    pub fn at(&self, a: Motion<S>) -> Wrench<S> {
        self.inertia.times(a) + self.bias_force
    }
}

/// How the links move.
#[derive(Clone, Debug)]
pub struct MotionSolution<S> {
    /// Amounts of every link's free columns.
    pub basis_accelerations: PerLink<Vec<S>>,
    /// `a` of every link's point.
    pub link_accelerations: PerLink<Motion<S>>,
    /// What every link's hinge transmits, if that is known without what hangs on it: not where
    /// reactions of a closing hinge join.
    pub affine_wrenches: PerLink<AffineWrench<S>>,
    /// Reactions along the closing's directions, and what they do not determine.
    pub constraint_forces: ConstraintForces<S>,
}

impl<S: Scalar> MotionProblem<'_, S> {
    /// The same with inertia along what the closing hinge holds: `μ p (pᵀ a − r)` of a direction
    /// with `pᵀ a = r` is nothing, but it keeps a body that has no inertia there from being loose
    /// before the chain is closed.
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
            let along = wrench.scaled(if is_angular { inertia } else { mass });
            added = added + SpatialInertia::from_fn(|i, j| along.at(i) * wrench.at(j));
            load = load - along.scaled(target);
        }
        self.bias_forces[link] = load;
        self.added_inertia = Some((link, added));
        self
    }

    /// The inertia that links `a` and `F` at a link's point.
    pub fn inertia(&self, link: LinkId) -> SpatialInertia<S> {
        let own = self.links[link].spatial_inertia();
        match self.added_inertia {
            Some((to, added)) if to == link => own + added,
            _ => own,
        }
    }

    /// What measures pivots along shifts and turns of a link's own part.
    pub fn pivot_scales(&self, link: LinkId) -> (S, S) {
        let inertia = self.inertia(link);
        let own = (inertia.linear.at(0, 0), inertia.angular.trace());
        self.original_inertias.as_ref().map_or(own, |originals| originals[link].scales)
    }

    /// The mass that a link has given to its parent.
    pub fn transferred_mass(&self, link: LinkId) -> S {
        self.original_inertias
            .as_ref()
            .map_or(S::zero(), |originals| originals[link].transferred_mass)
    }

    /// `a` of a link's point but for the hinge's own columns, from `a` of its parent's point.
    pub fn acceleration_from_parent(&self, link: LinkId, parent: Motion<S>) -> Motion<S> {
        self.links[link].hinge.acceleration_from_parent(parent, self.bias_accelerations[link])
    }

    /// `a` of the point of a link's parent, from those of all links.
    pub fn parent_acceleration(
        &self,
        link: LinkId,
        accelerations: &PerLink<Motion<S>>,
    ) -> Motion<S> {
        self.links[link].parent.map_or(self.base_acceleration, |parent| accelerations[parent])
    }

    /// The wrenches with which the closing's reactions pull at the link that it hangs on, about its
    /// point, and that link.
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

    /// What the closing demands where it hangs on the ground, or on no link at all.
    pub fn gamma_on_ground(&self) -> Vec<S> {
        let Some(LoopConstraints { loop_hinge, .. }) = &self.loop_constraints else {
            return Vec::new();
        };
        let a = loop_hinge.hinge.motion_from_parent(self.base_acceleration);
        loop_hinge.constraints.iter().map(|constraint| a.power(constraint.wrench)).collect()
    }
}

impl<S: Scalar> MotionSolution<S> {
    /// Rates of all hinges on links, or their changes, in the layout's order; zero where no link
    /// is.
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

/// `Σ motion · amount` of columns.
pub fn basis_motion<S: Scalar>(link: &LinkKinematics<S>, amounts: &[S]) -> Motion<S> {
    let columns = link.hinge.basis.columns.iter().map(|column| column.motion());
    columns.zip(amounts).fold(Motion::zero(), |sum, (motion, &x)| sum + motion.scaled(x))
}
