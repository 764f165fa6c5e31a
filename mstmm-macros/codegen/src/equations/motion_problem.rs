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
    pub drift: PerLink<BiasAcceleration<S>>,
    /// The part of the wrench at every link's point that does not hang on `a`, of its part alone.
    pub loads: PerLink<Wrench<S>>,
    /// Efforts along the columns of every link.
    pub efforts: PerLink<Vec<S>>,
    /// `a` of the ground.
    pub ground: Motion<S>,
    /// The hinge that closes the chain, with what it demands, if there is one.
    pub closing: Option<LoopConstraints<'a, S>>,
    /// What the links had before their inertias were redistributed, if they were.
    pub given: Option<PerLink<OriginalInertia<S>>>,
    /// Inertia that a link has besides its own, if any.
    pub added: Option<(LinkId, SpatialInertia<S>)>,
}

/// What a closing hinge demands.
#[derive(Clone, Debug)]
pub struct LoopConstraints<'a, S> {
    /// The hinge.
    pub closing: &'a LoopHinge<S>,
    /// What `a` of the point reached from the inboard side has to be along each of the closing's
    /// directions: `r_j` of `T_jᵀ a = r_j`.
    pub reached: Vec<S>,
    /// The wrench in the closing hinge that does not hang on its reactions.
    pub given: Wrench<S>,
    /// What there is to know of the linkage.
    pub linkage: ConstraintRank<S>,
}

/// `F = Iᴬ a' + pᴬ`: what a hinge transmits, with `a'` of the parent carried over.
#[derive(Clone, Copy, Debug)]
pub struct AffineWrench<S> {
    /// `Iᴬ`
    pub inertia: SpatialInertia<S>,
    /// `pᴬ`
    pub bias: Wrench<S>,
}

impl<S: Scalar> AffineWrench<S> {
    /// `F` with this `a'`.
    pub fn at(&self, a: Motion<S>) -> Wrench<S> {
        self.inertia.times(a) + self.bias
    }
}

/// How the links move.
#[derive(Clone, Debug)]
pub struct MotionSolution<S> {
    /// Amounts of every link's free columns.
    pub amounts: PerLink<Vec<S>>,
    /// `a` of every link's point.
    pub points: PerLink<Motion<S>>,
    /// What every link's hinge transmits, if that is known without what hangs on it: not where
    /// reactions of a closing hinge join.
    pub relations: PerLink<AffineWrench<S>>,
    /// Reactions along the closing's directions, and what they do not determine.
    pub closure: ConstraintForces<S>,
}

impl<S: Scalar> MotionProblem<'_, S> {
    /// The same with inertia along what the closing hinge holds: `μ p (pᵀ a − r)` of a direction
    /// with `pᵀ a = r` is nothing, but it keeps a body that has no inertia there from being loose
    /// before the chain is closed.
    pub fn with_added_inertia(mut self) -> Self {
        let (Some(demand), Some((link, pulls))) = (&self.closing, self.pulls()) else {
            return self;
        };
        let mass = self.links.iter().fold(S::zero(), |sum, link| sum + link.mass);
        let inertia = self.links.iter().fold(S::zero(), |sum, link| {
            sum + link.inertia.trace() + link.mass * link.hinge.arm.dot(link.hinge.arm)
        });
        let mut added = SpatialInertia::from_fn(|_, _| S::zero());
        let mut load = self.loads[link];
        for ((held, pull), &reached) in demand.closing.held.iter().zip(&pulls).zip(&demand.reached)
        {
            if !held.inertia.vanishes() {
                continue;
            }
            let turns = held.wrench.force.0.iter().all(|part| part.vanishes());
            let along = pull.scaled(if turns { inertia } else { mass });
            added = added + SpatialInertia::from_fn(|i, j| along.at(i) * pull.at(j));
            load = load - along.scaled(reached);
        }
        self.loads[link] = load;
        self.added = Some((link, added));
        self
    }

    /// The inertia that links `a` and `F` at a link's point.
    pub fn inertia(&self, link: LinkId) -> SpatialInertia<S> {
        let own = self.links[link].spatial_inertia();
        match self.added {
            Some((to, added)) if to == link => own + added,
            _ => own,
        }
    }

    /// What measures pivots along shifts and turns of a link's own part.
    pub fn scales(&self, link: LinkId) -> (S, S) {
        let inertia = self.inertia(link);
        let own = (inertia.linear.at(0, 0), inertia.angular.trace());
        self.given.as_ref().map_or(own, |given| given[link].scales)
    }

    /// The mass that a link has given to its parent.
    pub fn given_mass(&self, link: LinkId) -> S {
        self.given.as_ref().map_or(S::zero(), |given| given[link].mass)
    }

    /// `a` of a link's point but for the hinge's own columns, from `a` of its parent's point.
    pub fn motion_from_parent(&self, link: LinkId, parent: Motion<S>) -> Motion<S> {
        self.links[link].hinge.acceleration_from_parent(parent, self.drift[link])
    }

    /// `a` of the point of a link's parent, from those of all links.
    pub fn parent(&self, link: LinkId, points: &PerLink<Motion<S>>) -> Motion<S> {
        self.links[link].parent.map_or(self.ground, |parent| points[parent])
    }

    /// The wrenches with which the closing's reactions pull at the link that it hangs on, about its
    /// point, and that link.
    pub fn pulls(&self) -> Option<(LinkId, Vec<Wrench<S>>)> {
        let closing = self.closing.as_ref()?.closing;
        let parent = closing.parent?;
        let pulls =
            closing.held.iter().map(|held| closing.hinge.wrench_to_parent(held.wrench)).collect();
        Some((parent, pulls))
    }

    /// What the closing demands where it hangs on the ground, or on no link at all.
    pub fn at_rest(&self) -> Vec<S> {
        let Some(LoopConstraints { closing, .. }) = &self.closing else { return Vec::new() };
        let a = closing.hinge.motion_from_parent(self.ground);
        closing.held.iter().map(|held| a.power(held.wrench)).collect()
    }
}

impl<S: Scalar> MotionSolution<S> {
    /// Rates of all hinges on links, or their changes, in the layout's order; zero where no link
    /// is.
    pub fn rates(&self, links: &PerLink<LinkKinematics<S>>, layout: &Layout) -> Vec<S> {
        let mut rates = vec![S::zero(); layout.dof_count()];
        links.iter().zip(&self.amounts).for_each(|(LinkKinematics { hinge, .. }, amounts)| {
            rates[layout.v[hinge.id].clone()].copy_from_slice(&hinge.basis.to_rates(amounts));
        });
        rates
    }
}

/// `Σ motion · amount` of columns.
pub fn moved<S: Scalar>(link: &LinkKinematics<S>, amounts: &[S]) -> Motion<S> {
    let columns = link.hinge.basis.columns.iter().map(|column| column.motion());
    columns.zip(amounts).fold(Motion::zero(), |sum, (motion, &x)| sum + motion.scaled(x))
}
