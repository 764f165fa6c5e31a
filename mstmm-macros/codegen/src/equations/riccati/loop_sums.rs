//! The loop that a closing hinge closes, from its link to the ground: equations (4) and (5).

use super::super::Trace;
use super::super::constraint_forces::{self, ConstraintForces, ConstraintSystem, DelassusTerm};
use super::super::kinematics::{BiasAcceleration, HingeKinematics};
use super::super::motion_problem::MotionProblem;
use super::super::sweep::Flatten;
use super::eliminated_dof::EliminatedDof;
use crate::math::{Motion, Scalar, Wrench};

/// The constraints of a closing hinge that is farther out.
#[derive(Clone)]
pub struct LoopSums<S> {
    /// `γ`
    gamma: Vec<S>,
    /// What `Λ` is the sum of, outside of repeated parts.
    dofs: Vec<DelassusTerm<S>>,
    /// The part of `Λ` that repeated parts add, below the diagonal and on it, by rows.
    repeated: Vec<Vec<S>>,
    /// What the diagonal of `Λ` would be if nothing in it cancelled.
    sizes: Vec<S>,
}

impl<S: Scalar> LoopSums<S> {
    /// At the link that the closing hinge hangs on.
    pub fn new(count: usize) -> Self {
        let row = |row: usize| vec![S::zero(); row + 1];
        LoopSums {
            gamma: vec![S::zero(); count],
            dofs: Vec::new(),
            repeated: (0..count).map(row).collect(),
            sizes: vec![S::zero(); count],
        }
    }

    /// Equation (4) for the directions of a hinge, except for `Tᴬ`.
    pub fn add_directions(&mut self, steps: &[EliminatedDof<S>], is_repeated: bool) {
        steps.iter().for_each(|step| self.add_direction(step, is_repeated));
    }

    fn add_direction(&mut self, step: &EliminatedDof<S>, is_repeated: bool) {
        let EliminatedDof { along, inverse, rest, by_pivot, sizes, .. } = step;
        for (i, &t) in along.iter().enumerate() {
            self.gamma[i] = self.gamma[i] + t * *rest;
            self.sizes[i] = self.sizes[i] + sizes[i] * *inverse;
        }
        if !is_repeated {
            return self.dofs.push(DelassusTerm { along: along.clone(), inverse: *inverse });
        }
        for (row, &t) in self.repeated.iter_mut().zip(along) {
            for (sum, &other) in row.iter_mut().zip(by_pivot) {
                *sum = *sum + t * other;
            }
        }
    }

    /// What joins `a` on the way over a hinge.
    pub fn add_drift(
        &mut self,
        drift: BiasAcceleration<S>,
        hinge: &HingeKinematics<S>,
        columns: &[Wrench<S>],
    ) {
        for (gamma, column) in self.gamma.iter_mut().zip(columns) {
            *gamma = *gamma + drift.power(&hinge.to_parent, *column);
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

impl<S: Scalar> Flatten<S> for LoopSums<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let gamma = self.gamma.visit(replace);
        let repeated = self.repeated.visit(replace);
        let sizes = self.sizes.visit(replace);
        LoopSums { gamma, dofs: self.dofs, repeated, sizes }
    }
}

/// Equation (5) solved for the reactions, from the loop as it has arrived at the ground.
pub fn close<S: Scalar>(
    problem: &MotionProblem<S>,
    open: Option<LoopSums<S>>,
    trace: &mut Trace<S>,
) -> ConstraintForces<S> {
    let Some(demand) = &problem.closing else { return ConstraintForces::none() };
    trace.section("closure", "Closure", "[P, Eqs. (9) to (11)] at the held end");
    let held = &demand.closing.held;
    // Where the closing hinge hangs on the ground, nothing it does moves anything.
    let open =
        open.unwrap_or_else(|| LoopSums { gamma: problem.at_rest(), ..LoopSums::new(held.len()) });
    let LoopSums { gamma, mut dofs, repeated, mut sizes, .. } = open;
    for (k, held) in held.iter().enumerate().filter(|(_, held)| !held.inertia.vanishes()) {
        let along = (0..sizes.len()).map(|i| if i == k { S::one() } else { S::zero() }).collect();
        dofs.push(DelassusTerm { along, inverse: held.inertia });
        sizes[k] = sizes[k] + held.inertia;
    }
    let right: Vec<S> = gamma.iter().zip(&demand.reached).map(|(&g, &r)| g - r).collect();
    for (k, (&size, &right)) in sizes.iter().zip(&right).enumerate() {
        trace.number(format!("closure_size{k}"), size);
        trace.number(format!("closure_right{k}"), right);
    }
    let linkage = demand.linkage.clone();
    constraint_forces::solve(&ConstraintSystem { dofs, repeated, sizes, right, linkage }, trace)
}
