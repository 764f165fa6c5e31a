//! The sums of the loop constraints, from the link of the loop hinge to the ground: equations (4)
//! and (5).

use super::super::Trace;
use super::super::constraint_forces::{self, ConstraintForces, ConstraintSystem, DelassusTerm};
use super::super::kinematics::{BiasAcceleration, HingeKinematics};
use super::super::motion_problem::MotionProblem;
use super::super::sweep::Flatten;
use super::eliminated_dof::EliminatedDof;
use crate::math::{Motion, Scalar, Wrench};

/// The sums of equation (4), for a loop hinge outboard of a link.
#[derive(Clone)]
pub struct LoopSums<S> {
    /// `γ`
    gamma: Vec<S>,
    /// The terms of `Λ` outside of repeated parts.
    terms: Vec<DelassusTerm<S>>,
    /// The part of `Λ` from repeated parts: its lower triangle with the diagonal, by rows.
    repeated: Vec<Vec<S>>,
    /// The diagonal of `Λ` if nothing cancelled in it.
    scales: Vec<S>,
}

impl<S: Scalar> LoopSums<S> {
    /// Returns the sums at the link inboard of the loop hinge.
    pub fn new(count: usize) -> Self {
        let row = |row: usize| vec![S::zero(); row + 1];
        LoopSums {
            gamma: vec![S::zero(); count],
            terms: Vec::new(),
            repeated: (0..count).map(row).collect(),
            scales: vec![S::zero(); count],
        }
    }

    /// Adds the eliminated degrees of freedom of a hinge by equation (4), which also changes `Tᴬ`
    /// elsewhere.
    pub fn add_dofs(&mut self, steps: &[EliminatedDof<S>], is_repeated: bool) {
        steps.iter().for_each(|step| self.add_dof(step, is_repeated));
    }

    fn add_dof(&mut self, step: &EliminatedDof<S>, is_repeated: bool) {
        let EliminatedDof { t, inverse, u_over_d, t_over_d, t_scales, .. } = step;
        for (i, &t) in t.iter().enumerate() {
            self.gamma[i] = self.gamma[i] + t * *u_over_d;
            self.scales[i] = self.scales[i] + t_scales[i] * *inverse;
        }
        if !is_repeated {
            return self.terms.push(DelassusTerm { t: t.clone(), inverse: *inverse });
        }
        for (row, &t) in self.repeated.iter_mut().zip(t) {
            for (sum, &other) in row.iter_mut().zip(t_over_d) {
                *sum = *sum + t * other;
            }
        }
    }

    /// Adds the bias acceleration of a hinge to `γ`.
    pub fn add_bias_acceleration(
        &mut self,
        bias: BiasAcceleration<S>,
        hinge: &HingeKinematics<S>,
        wrenches: &[Wrench<S>],
    ) {
        for (gamma, wrench) in self.gamma.iter_mut().zip(wrenches) {
            *gamma = *gamma + bias.power(&hinge.to_parent, *wrench);
        }
    }

    /// Adds the acceleration that the ground gives to the point of a root, to `γ`: part
    /// of equation (5).
    pub fn with_base_acceleration(mut self, a: Motion<S>, wrenches: &[Wrench<S>]) -> Self {
        for (gamma, wrench) in self.gamma.iter_mut().zip(wrenches) {
            *gamma = *gamma + a.power(*wrench);
        }
        self
    }
}

impl<S: Scalar> Flatten<S> for LoopSums<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let gamma = self.gamma.visit(replace);
        let repeated = self.repeated.visit(replace);
        let scales = self.scales.visit(replace);
        LoopSums { gamma, terms: self.terms, repeated, scales }
    }
}

/// Solves equation (5) for the constraint forces, from the sums at the ground.
pub fn solve_constraints<S: Scalar>(
    problem: &MotionProblem<S>,
    sums: Option<LoopSums<S>>,
    trace: &mut Trace<S>,
) -> ConstraintForces<S> {
    let Some(constraints) = &problem.loop_constraints else { return ConstraintForces::none() };
    trace.section("closure", "Loop constraints", "[P, Eqs. (9) to (11)] at the loop hinge");
    let rows = &constraints.loop_hinge.constraints;
    // If the inboard side of the loop hinge is the ground, the constraint forces move nothing.
    let sums = sums.unwrap_or_else(|| LoopSums {
        gamma: problem.gamma_on_ground(),
        ..LoopSums::new(rows.len())
    });
    let LoopSums { gamma, mut terms, repeated, mut scales } = sums;
    for (k, row) in rows.iter().enumerate().filter(|(_, row)| !row.inertia.vanishes()) {
        let t = (0..scales.len()).map(|i| if i == k { S::one() } else { S::zero() }).collect();
        terms.push(DelassusTerm { t, inverse: row.inertia });
        scales[k] = scales[k] + row.inertia;
    }
    let rhs: Vec<S> = gamma.iter().zip(&constraints.targets).map(|(&g, &r)| g - r).collect();
    for (k, (&scale, &rhs)) in scales.iter().zip(&rhs).enumerate() {
        trace.number(format!("closure_scale{k}"), scale);
        trace.number(format!("closure_rhs{k}"), rhs);
    }
    let rank = constraints.rank.clone();
    constraint_forces::solve(&ConstraintSystem { terms, repeated, scales, rhs, rank }, trace)
}
