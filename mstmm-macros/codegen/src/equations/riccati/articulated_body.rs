//! An articulated body: a link with everything outboard of it, as the inward sweep carries it.
//!
//! All quantities belong to the link's point, in the link's work axes.

use super::super::kinematics::BiasAcceleration;
use super::super::motion_problem::MotionProblem;
use super::super::strategy;
use super::super::sweep::Flatten;
use super::loop_sums::LoopSums;
use crate::ids::LinkId;
use crate::math::{Motion, Scalar, SpatialInertia, Vec3, Wrench};

/// A link with everything outboard of it.
#[derive(Clone)]
pub struct ArticulatedBody<S> {
    /// Articulated inertia `Iᴬ`.
    pub inertia: SpatialInertia<S>,
    /// Bias force `pᴬ`.
    pub bias_force: Wrench<S>,
    /// `Tᴬ` by columns, if a loop hinge is outboard of this link.
    pub constraint_wrenches: Vec<Wrench<S>>,
    /// Sum of the squared arms that the moments of `Tᴬ` come from.
    pub squared_arms: S,
    /// Size of the terms that a pivot along a translation, or about an axis, is the sum of. A pivot
    /// that should vanish is the rounding error of these terms.
    pub pivot_scales: (S, S),
    /// Sums of the loop constraints, if a loop hinge is outboard of this link.
    pub loop_sums: Option<LoopSums<S>>,
}

impl<S: Scalar> ArticulatedBody<S> {
    /// An articulated body with no loop hinge outboard of it.
    pub fn new(inertia: SpatialInertia<S>, bias_force: Wrench<S>) -> Self {
        ArticulatedBody {
            inertia,
            bias_force,
            constraint_wrenches: Vec::new(),
            squared_arms: S::zero(),
            pivot_scales: (S::zero(), S::zero()),
            loop_sums: None,
        }
    }

    /// Returns the loop sums at a root, with the acceleration `a` that the ground gives the root's
    /// point.
    pub fn loop_on_ground(self, a: Motion<S>) -> Option<LoopSums<S>> {
        self.loop_sums.map(|sums| sums.with_base_acceleration(a, &self.constraint_wrenches))
    }

    /// Adds this body to its parent, over the link's hinge and in the parent's work axes:
    /// `Iᴬ + Xᵀ Iᴬ X`, `pᴬ + Xᵀ (pᴬ + Iᴬ b)` with the bias acceleration `b` of the hinge,
    /// `Tᴬ + Xᵀ Tᴬ`.
    pub fn add_to_parent(self, problem: &MotionProblem<S>, link: LinkId, parent: &mut Self) {
        let hinge = &problem.links[link].hinge;
        let mass = self.inertia.linear.trace() + problem.transferred_mass(link) * S::number(3.0);
        parent.pivot_scales.0 = parent.pivot_scales.0 + mass;
        parent.pivot_scales.1 = parent.pivot_scales.1 + mass * hinge.arm.dot(hinge.arm);
        let BiasAcceleration { on_parent, in_hinge } = problem.bias_accelerations[link];
        let bias = (self.bias_force + self.inertia.times(in_hinge)).rotated(&hinge.to_parent);
        let inertia = hinge.to_parent.rotate_inertia(
            &self.inertia,
            strategy::plane_formula(&hinge.to_parent, &self.inertia),
        );
        let bias = bias + inertia.times(Motion { linear: on_parent, angular: Vec3::zero() });
        parent.inertia = parent.inertia + inertia.shifted_from(hinge.arm);
        parent.bias_force = parent.bias_force + bias.shifted_from(hinge.arm);
        parent.squared_arms = parent.squared_arms + self.squared_arms + hinge.arm.dot(hinge.arm);
        if self.loop_sums.is_some() {
            let wrenches = self.constraint_wrenches.iter();
            parent.constraint_wrenches =
                wrenches.map(|&wrench| hinge.wrench_to_parent(wrench)).collect();
        }
        parent.adopt_loop(self.loop_sums);
    }

    /// Takes over the loop sums of a branch, if the branch has any. The branch of a moving end has
    /// none.
    pub fn adopt_loop(&mut self, sums: Option<LoopSums<S>>) {
        if sums.is_some() && std::mem::replace(&mut self.loop_sums, sums).is_some() {
            bug!("two branches contain the same loop hinge")
        }
    }
}

impl<S: Scalar> Flatten<S> for ArticulatedBody<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let inertia = self.inertia.visit(replace);
        let bias_force = self.bias_force.visit(replace);
        let constraint_wrenches = self.constraint_wrenches.visit(replace);
        let squared_arms = replace(self.squared_arms);
        let pivot_scales = self.pivot_scales.visit(replace);
        let loop_sums = self.loop_sums.visit(replace);
        ArticulatedBody {
            inertia,
            bias_force,
            constraint_wrenches,
            squared_arms,
            pivot_scales,
            loop_sums,
        }
    }
}
