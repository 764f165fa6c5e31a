//! The loop that a closing hinge closes, from its link to the ground: equations (4) and (5).

use super::super::Trace;
use super::super::closure::{self, Closure, Dof, Reactions};
use super::super::kinematics::{Crossed, Drift};
use super::super::problem::Problem;
use super::super::sweep::Flatten;
use super::eliminated::Eliminated;
use crate::math::{Motion, Scalar, Wrench};

/// The constraints of a closing hinge that is farther out.
#[derive(Clone)]
pub struct OpenLoop<S> {
    /// `γ`
    gamma: Vec<S>,
    /// What `Λ` is the sum of, outside of repeated parts.
    dofs: Vec<Dof<S>>,
    /// The part of `Λ` that repeated parts add, below the diagonal and on it, by rows.
    repeated: Vec<Vec<S>>,
    /// What the diagonal of `Λ` would be if nothing in it cancelled.
    sizes: Vec<S>,
}

impl<S: Scalar> OpenLoop<S> {
    /// At the link that the closing hinge hangs on.
    pub fn new(count: usize) -> Self {
        let row = |row: usize| vec![S::zero(); row + 1];
        OpenLoop {
            gamma: vec![S::zero(); count],
            dofs: Vec::new(),
            repeated: (0..count).map(row).collect(),
            sizes: vec![S::zero(); count],
        }
    }

    /// Equation (4) for the directions of a hinge, except for `Tᴬ`.
    pub fn add_directions(&mut self, steps: &[Eliminated<S>], is_repeated: bool) {
        steps.iter().for_each(|step| self.add_direction(step, is_repeated));
    }

    fn add_direction(&mut self, step: &Eliminated<S>, is_repeated: bool) {
        let Eliminated { along, inverse, rest, by_pivot, sizes, .. } = step;
        for (i, &t) in along.iter().enumerate() {
            self.gamma[i] = self.gamma[i] + t * *rest;
            self.sizes[i] = self.sizes[i] + sizes[i] * *inverse;
        }
        if !is_repeated {
            return self.dofs.push(Dof { along: along.clone(), inverse: *inverse });
        }
        for (row, &t) in self.repeated.iter_mut().zip(along) {
            for (sum, &other) in row.iter_mut().zip(by_pivot) {
                *sum = *sum + t * other;
            }
        }
    }

    /// What joins `a` on the way over a hinge.
    pub fn add_drift(&mut self, drift: Drift<S>, over: &Crossed<S>, columns: &[Wrench<S>]) {
        for (gamma, column) in self.gamma.iter_mut().zip(columns) {
            *gamma = *gamma + drift.power(&over.to_parent, *column);
        }
    }

    /// The part of equation (5) that the ground makes, from its `a` at a root's point.
    pub fn on_ground(mut self, ground: Motion<S>, columns: &[Wrench<S>]) -> Self {
        for (gamma, column) in self.gamma.iter_mut().zip(columns) {
            *gamma = *gamma + ground.power(*column);
        }
        self
    }
}

impl<S: Scalar> Flatten<S> for OpenLoop<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let gamma = self.gamma.visit(replace);
        let repeated = self.repeated.visit(replace);
        let sizes = self.sizes.visit(replace);
        OpenLoop { gamma, dofs: self.dofs, repeated, sizes }
    }
}

/// Equation (5) solved for the reactions, from the loop as it has arrived at the ground.
pub fn close<S: Scalar>(
    problem: &Problem<S>,
    open: Option<OpenLoop<S>>,
    trace: &mut Trace<S>,
) -> Closure<S> {
    let Some(demand) = &problem.closing else { return Closure::none() };
    trace.section("closure", "Closure", "[P, Eqs. (9) to (11)] at the held end");
    let held = &demand.closing.held;
    // Where the closing hinge hangs on the ground, nothing it does moves anything.
    let open =
        open.unwrap_or_else(|| OpenLoop { gamma: problem.at_rest(), ..OpenLoop::new(held.len()) });
    let OpenLoop { gamma, mut dofs, repeated, mut sizes, .. } = open;
    for (k, held) in held.iter().enumerate().filter(|(_, held)| !held.inertia.vanishes()) {
        let along = (0..sizes.len()).map(|i| if i == k { S::one() } else { S::zero() }).collect();
        dofs.push(Dof { along, inverse: held.inertia });
        sizes[k] = sizes[k] + held.inertia;
    }
    let right: Vec<S> = gamma.iter().zip(&demand.reached).map(|(&g, &r)| g - r).collect();
    for (k, (&size, &right)) in sizes.iter().zip(&right).enumerate() {
        trace.number(format!("closure_size{k}"), size);
        trace.number(format!("closure_right{k}"), right);
    }
    let linkage = demand.linkage.clone();
    closure::solve(&Reactions { dofs, repeated, sizes, right, linkage }, trace)
}
