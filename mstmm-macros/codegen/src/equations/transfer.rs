//! The transfer matrix method: the forward product from the ground's end, `z_{1,I}` of
//! [P, Eqs. (9), (10)], for general chains.
//!
//! `a` and `F` at a connection point are a known part plus one column for each of six unknowns: the
//! columns of `U_j … U_1` that the boundary leaves open. The paper's hinges look ahead to the next
//! hinge ([P, Eqs. (25), (38)]), which loses accuracy with the length of the chain. Here each hinge
//! uses its own conditions `Sᵀ F = τ` at once, and eliminates as many unknowns as its accelerations
//! `β` add. The condition `F = 0` at the free end is the boundary solve [P, Eq. (11)]. Back substitution through the
//! eliminations gives all `β`.
//!
//! A loop hinge adds its constraint forces to the wrench at the far end. These are the constraint
//! forces of the Riccati transfer, whose equations for them are symmetric and reveal redundant
//! constraints. With known constraint forces, the boundary solve is that of a loaded free end.
//!
//! # Notation
//!
//! All quantities belong to the point of a link, in its work axes. `F` is the wrench on the inboard
//! side of the link's part, or on the outboard side if a function says so.
//!
//! | symbol | in code | meaning |
//! |---|---|---|
//! | `a`, `F` | [`StateColumn`] | a column of the product |
//! | `x` | `unknowns` | the unknowns that the columns belong to: at the start the six entries of `F` |
//! | `s`, `τ` | [`BasisVector`], `efforts` | a degree of freedom of the link's hinge, `sᵀ F + H β = τ` with the rotor inertia `H` |
//! | `β` | `betas` | the acceleration along `s`, the added unknown |
//! | `v`, `γ`, `w` | [`Reflection`] | the elimination of an unknown by a condition |

use super::Trace;
use super::constraint_forces::ConstraintForces;
use super::hinge::BasisVector;
use super::motion_problem::{MotionProblem, MotionSolution, basis_motion};
use super::reflection::{Reflection, VectorSpace};
use super::sweep::{Flatten, PerLink};
use crate::ids::LinkId;
use crate::math::{Motion, Scalar, Wrench};

/// A column of the product, which belongs to one unknown; or the known part.
#[derive(Clone, Copy, Debug)]
struct StateColumn<S> {
    a: Motion<S>,
    f: Wrench<S>,
}

impl<S: Scalar> VectorSpace<S> for StateColumn<S> {
    fn plus_scaled(self, other: Self, factor: S) -> Self {
        StateColumn { a: self.a + other.a.scaled(factor), f: self.f + other.f.scaled(factor) }
    }
    fn scaled(self, factor: S) -> Self {
        StateColumn { a: self.a.scaled(factor), f: self.f.scaled(factor) }
    }
}

/// The state vector at a connection point as a function of the unknowns.
#[derive(Clone)]
struct TransferProduct<S> {
    known: StateColumn<S>,
    columns: Vec<StateColumn<S>>,
}

/// A condition that was used, and the unknown that it determines.
struct UsedCondition<S> {
    reflection: Reflection<S>,
    determined: S,
}

/// Solves the problem, with the constraint forces that the Riccati transfer has found.
///
/// If nothing outboard of a hinge has inertia, the boundary solve is singular, but rounding errors
/// hide this. The caller must check the pivots of the Riccati transfer.
pub fn solve<S: Scalar>(
    problem: &MotionProblem<S>,
    constraint_forces: ConstraintForces<S>,
    trace: &mut Trace<S>,
) -> MotionSolution<S> {
    let path = path(problem);
    let (product, used) =
        problem.tree.along(&path, None, |link, before: Option<TransferProduct<S>>| {
            let hinge = &problem.links[link].hinge;
            trace.section(
                format!("{}_transfer", hinge.name),
                format!("Transfer to `{}`", hinge.name),
                "[P, Eqs. (8), (21), (25), (35)]",
            );
            let mut current = match (before, problem.links[link].parent) {
                (Some(before), Some(parent)) => before.across(problem, parent, link),
                _ => TransferProduct::at_ground(problem, link),
            };
            let used = current.cross_hinge(problem, link, trace);
            current.record(&hinge.name, trace);
            (Some(current), used)
        });
    let unknowns = match (&product, path.last()) {
        (Some(product), Some(&last)) => {
            far_end(problem, (product, last), &constraint_forces.reactions, trace)
        }
        _ => Vec::new(),
    };
    let mut basis_accelerations = PerLink::filled(Vec::new(), problem.links.len());
    for (link, betas) in recover(unknowns, &used, trace, problem) {
        basis_accelerations[link] = betas;
    }
    let link_accelerations = link_accelerations(problem, &basis_accelerations);
    MotionSolution {
        basis_accelerations,
        link_accelerations,
        affine_wrenches: PerLink::new(),
        constraint_forces,
    }
}

/// Returns the links from the ground to the far end, without the link of a moving end there.
fn path<S: Scalar>(problem: &MotionProblem<S>) -> Vec<LinkId> {
    let last = match &problem.loop_constraints {
        Some(constraints) => constraints.loop_hinge.parent,
        None => problem.links.ids().into_iter().next_back(),
    };
    last.map_or(Vec::new(), |last| problem.tree.path_to(last))
}

/// Returns `a` of all points, from the accelerations of all hinges.
fn link_accelerations<S: Scalar>(
    problem: &MotionProblem<S>,
    basis_accelerations: &PerLink<Vec<S>>,
) -> PerLink<Motion<S>> {
    let (accelerations, _) = problem.tree.outward(problem.base_acceleration, |link, &parent| {
        let carried = problem.acceleration_from_parent(link, parent);
        (carried + basis_motion(&problem.links[link], &basis_accelerations[link]), ())
    });
    accelerations
}

impl<S: Scalar> Flatten<S> for StateColumn<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let a = self.a.visit(replace);
        StateColumn { a, f: self.f.visit(replace) }
    }
}

impl<S: Scalar> Flatten<S> for TransferProduct<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let known = self.known.visit(replace);
        TransferProduct { known, columns: self.columns.visit(replace) }
    }
}

impl<S: Scalar> TransferProduct<S> {
    /// Returns the product at the start of the chain, where the acceleration is known and the
    /// wrench is unknown.
    fn at_ground(problem: &MotionProblem<S>, first: LinkId) -> Self {
        let unknown = |&k: &usize| StateColumn { a: Motion::zero(), f: Wrench::unit(k) };
        TransferProduct {
            known: StateColumn {
                a: problem.acceleration_from_parent(first, problem.base_acceleration),
                f: Wrench::zero(),
            },
            columns: problem.dimension.axes().iter().map(unknown).collect(),
        }
    }

    /// Propagates the product over the part of `from` [P, Eqs. (17) to (19)] and into the axes of
    /// `to`.
    fn across(self, problem: &MotionProblem<S>, from: LinkId, to: LinkId) -> Self {
        let hinge = &problem.links[to].hinge;
        let beyond = |f: Wrench<S>| f.shifted_from(-hinge.arm).rotated_back(&hinge.to_parent);
        let TransferProduct { known, columns } = self.outboard_of_body(problem, from);
        let cross = |part: StateColumn<S>| StateColumn {
            a: hinge.motion_from_parent(part.a),
            f: beyond(part.f),
        };
        let a = hinge.acceleration_from_parent(known.a, problem.bias_accelerations[to]);
        TransferProduct {
            known: StateColumn { a, f: beyond(known.f) },
            columns: columns.into_iter().map(cross).collect(),
        }
    }

    /// Returns the product with the wrench on the outboard side of a link's part, about the link's
    /// point: a column of `U_j z` [P, Eqs. (18), (19), (21)] for each column `z`.
    fn outboard_of_body(&self, problem: &MotionProblem<S>, link: LinkId) -> Self {
        let inertia = problem.inertia(link);
        let outboard =
            |part: &StateColumn<S>| StateColumn { a: part.a, f: part.f - inertia.times(part.a) };
        let known = outboard(&self.known);
        TransferProduct {
            known: StateColumn { a: known.a, f: known.f - problem.bias_forces[link] },
            columns: self.columns.iter().map(outboard).collect(),
        }
    }

    /// Eliminates the degrees of freedom of a hinge; each condition determines one unknown.
    fn cross_hinge(
        &mut self,
        problem: &MotionProblem<S>,
        index: LinkId,
        trace: &mut Trace<S>,
    ) -> Vec<UsedCondition<S>> {
        let hinge = &problem.links[index].hinge;
        let conditions = problem.efforts[index].iter().zip(&hinge.basis.armature);
        let mut used = Vec::new();
        for (&column, (&effort, &armature)) in hinge.basis.columns.iter().zip(conditions) {
            let step = self.eliminate(column, effort, armature);
            for (number, &v) in step.reflection.vector().iter().enumerate() {
                trace.number(format!("{}_v{number}", hinge.name), v);
            }
            used.push(step);
        }
        used
    }

    /// Uses the condition `sᵀ F + H β = τ` to eliminate one unknown, with `β` as a new unknown. For a
    /// ball, a pin and a floating hinge without drives it is [P, Eqs. (25), (35), (57), (58)].
    fn eliminate(&mut self, s: BasisVector<S>, tau: S, armature: S) -> UsedCondition<S> {
        let direction = s.motion();
        let mut coefficients: Vec<S> =
            self.columns.iter().map(|part| direction.power(part.f)).collect();
        coefficients.push(armature);
        self.columns.push(StateColumn { a: direction, f: Wrench::zero() });
        let reflection = Reflection::of(&coefficients);
        let determined = reflection.determine(tau - direction.power(self.known.f));
        let leaving = reflection.apply(&mut self.columns);
        self.known = self.known.plus_scaled(leaving, determined);
        if let (BasisVector::Axis(axis), true) = (s, armature.vanishes()) {
            // These entries are zero except for the rounding of the reflection; they are set to
            // zero exactly.
            let set =
                |f: Wrench<S>, value| Wrench::from_fn(|k| if k == axis { value } else { f.at(k) });
            self.known.f = set(self.known.f, tau);
            for part in &mut self.columns {
                part.f = set(part.f, S::zero());
            }
        }
        UsedCondition { reflection, determined }
    }

    fn record(&self, name: &str, trace: &mut Trace<S>) {
        for (number, part) in self.columns.iter().enumerate() {
            trace.motion(&format!("{name}_column{number}_acc"), part.a);
            trace.wrench(&format!("{name}_column{number}_wrench"), part.f);
        }
        trace.motion(&format!("{name}_known_acc"), self.known.a);
        trace.wrench(&format!("{name}_known_wrench"), self.known.f);
    }
}

/// Solves the boundary conditions outboard of the last body, [P, Eq. (11)].
fn far_end<S: Scalar>(
    problem: &MotionProblem<S>,
    (product, last): (&TransferProduct<S>, LinkId),
    reactions: &[S],
    trace: &mut Trace<S>,
) -> Vec<S> {
    trace.section("end", "Boundary solve at the far end", "[P, Eqs. (9) to (11)]");
    let end = product.outboard_of_body(problem, last);
    let applied = problem.loop_constraints.as_ref().map_or(Wrench::zero(), |constraints| {
        constraints
            .loop_hinge
            .hinge
            .wrench_to_parent(constraints.loop_hinge.wrench(constraints.applied, reactions))
    });
    let rows = problem.dimension.axes().iter().map(|&k| BoundaryRow {
        coefficients: end.columns.iter().map(|part| part.f.at(k)).collect(),
        value: applied.at(k) - end.known.f.at(k),
    });
    let unknowns = boundary(rows.collect());
    for (number, &unknown) in unknowns.iter().enumerate() {
        trace.number(format!("end_x{number}"), unknown);
    }
    unknowns
}

/// A condition on the unknowns.
struct BoundaryRow<S> {
    coefficients: Vec<S>,
    value: S,
}

/// Solves all conditions, one after the other.
fn boundary<S: Scalar>(mut rows: Vec<BoundaryRow<S>>) -> Vec<S> {
    let mut used: Vec<(Reflection<S>, S)> = Vec::new();
    for number in 0..rows.len() {
        let reflection = Reflection::of(&rows[number].coefficients);
        let determined = reflection.determine(rows[number].value);
        for row in rows.iter_mut().skip(number + 1) {
            let leaving = reflection.apply(&mut row.coefficients);
            row.value = row.value - leaving * determined;
        }
        used.push((reflection, determined));
    }
    let steps = used.iter().rev();
    steps.fold(Vec::new(), |y, (reflection, determined)| reflection.expand(y, *determined))
}

/// Substitutes back through the hinges: each gives its `β` and restores the unknown that it
/// eliminated.
fn recover<S: Scalar>(
    unknowns: Vec<S>,
    used: &[(LinkId, Vec<UsedCondition<S>>)],
    trace: &mut Trace<S>,
    problem: &MotionProblem<S>,
) -> Vec<(LinkId, Vec<S>)> {
    let (_, amounts) = problem.tree.back_along(used, unknowns, |link, steps, mut unknowns| {
        let name = &problem.links[link].hinge.name;
        trace.section(
            format!("{name}_back"),
            format!("Back substitution at `{name}`"),
            "[P, Eqs. (8), (11)]",
        );
        let mut betas = Vec::new();
        for step in steps.iter().rev() {
            unknowns = step.reflection.expand(unknowns, step.determined);
            betas.extend(unknowns.pop());
        }
        betas.reverse();
        for (number, &beta) in betas.iter().enumerate() {
            trace.number(format!("{name}_beta{number}"), beta);
        }
        (unknowns, betas)
    });
    amounts
}
