//! What the way to the ground carries: a link with all that hangs on it.

use super::super::kinematics::BiasAcceleration;
use super::super::motion_problem::MotionProblem;
use super::super::strategy;
use super::super::sweep::Flatten;
use super::loop_sums::LoopSums;
use crate::ids::LinkId;
use crate::math::{Motion, Scalar, SpatialInertia, Vec3, Wrench};

/// A link with all that hangs on it.
#[derive(Clone)]
pub struct ArticulatedBody<S> {
    /// `Iᴬ`
    pub inertia: SpatialInertia<S>,
    /// `pᴬ`
    pub bias: Wrench<S>,
    /// `Tᴬ` by columns, if a loop is open here.
    pub columns: Vec<Wrench<S>>,
    /// Squares of the arms that the moments of `Tᴬ` come from.
    pub reach: S,
    /// What a pivot along a shift or a turn is the sum of: one that should vanish is what rounding
    /// leaves of it.
    pub scales: (S, S),
    /// The loop that is open here, its closing hinge being farther out.
    pub open: Option<LoopSums<S>>,
}

impl<S: Scalar> ArticulatedBody<S> {
    /// On no loop.
    pub fn with(inertia: SpatialInertia<S>, bias: Wrench<S>) -> Self {
        let (reach, scales) = (S::zero(), (S::zero(), S::zero()));
        ArticulatedBody { inertia, bias, columns: Vec::new(), reach, scales, open: None }
    }

    /// The open loop at a root, with the acceleration `a` that the root's point has from the
    /// ground.
    pub fn on_ground(self, a: Motion<S>) -> Option<LoopSums<S>> {
        self.open.map(|open| open.on_ground(a, &self.columns))
    }

    /// Over the link's hinge to the point of the parent, in its work axes: `Iᴬ + Xᵀ Iᴬ X`,
    /// `pᴬ + Xᵀ (pᴬ + Iᴬ b)` with the bias acceleration `b` of the hinge, `Tᴬ + Xᵀ Tᴬ`.
    pub fn add_to_parent(self, problem: &MotionProblem<S>, link: LinkId, parent: &mut Self) {
        let hinge = &problem.links[link].hinge;
        let mass = self.inertia.linear.trace() + problem.given_mass(link) * S::number(3.0);
        parent.scales.0 = parent.scales.0 + mass;
        parent.scales.1 = parent.scales.1 + mass * hinge.arm.dot(hinge.arm);
        let BiasAcceleration { on_parent, in_hinge } = problem.drift[link];
        let bias = (self.bias + self.inertia.times(in_hinge)).rotated(&hinge.to_parent);
        let inertia = hinge.to_parent.rotate_inertia(
            &self.inertia,
            strategy::plane_formula(&hinge.to_parent, &self.inertia),
        );
        let bias = bias + inertia.times(Motion { linear: on_parent, angular: Vec3::zero() });
        parent.inertia = parent.inertia + inertia.shifted_from(hinge.arm);
        parent.bias = parent.bias + bias.shifted_from(hinge.arm);
        parent.reach = parent.reach + self.reach + hinge.arm.dot(hinge.arm);
        if self.open.is_some() {
            parent.columns =
                self.columns.iter().map(|&column| hinge.wrench_to_parent(column)).collect();
        }
        parent.hold(self.open);
    }

    /// Takes over the open loop of a branch, if it has one: a moving end is a branch without.
    pub fn hold(&mut self, open: Option<LoopSums<S>>) {
        if open.is_some() && std::mem::replace(&mut self.open, open).is_some() {
            bug!("two branches hold the same loop open")
        }
    }
}

impl<S: Scalar> Flatten<S> for ArticulatedBody<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let inertia = self.inertia.visit(replace);
        let bias = self.bias.visit(replace);
        let columns = self.columns.visit(replace);
        let reach = replace(self.reach);
        let scales = self.scales.visit(replace);
        ArticulatedBody { inertia, bias, columns, reach, scales, open: self.open.visit(replace) }
    }
}
