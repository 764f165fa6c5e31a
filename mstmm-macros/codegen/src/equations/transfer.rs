//! The forward product from the ground's end, `z_{1,I}` of [P, Eqs. (9), (10)], made general.
//!
//! Every connection point's `a` and `F` are carried as a known part and one column for each of six
//! unknowns, the columns of `U_j … U_1` that the boundary leaves open. Where the paper's hinges
//! look ahead to the next hinge ([P, Eqs. (25), (38)], which loses accuracy with the length of the
//! chain), each hinge here uses its own condition `Sᵀ F = τ` at once to take out as many unknowns
//! as its `β` bring in. The free end's `F = 0` is the boundary solve [P, Eq. (11)]; going back
//! through the eliminations gives every `β`.
//!
//! A closing hinge adds its reactions to the wrench at the far end. They are those of the Riccati
//! transfer, whose equations for them are symmetric and show which are redundant; with them the
//! boundary solve is that of a loaded end.
//!
//! # Notation
//!
//! All quantities belong to the point of a link, in its work axes. `F` is the wrench on the inboard
//! side of the link's body, or behind it where a function says so.
//!
//! | symbol | in code | meaning |
//! |---|---|---|
//! | `a`, `F` | [`StateColumn`] | a column of the product |
//! | `x` | `unknowns` | what the columns belong to: at the start the six entries of `F` |
//! | `s`, `τ` | [`BasisVector`], `efforts` | a free direction of the link's hinge, `sᵀ F + I β = τ` |
//! | `β` | `betas` | the acceleration along `s`, the unknown that joins |
//! | `v`, `γ`, `w` | [`Reflection`] | how a condition takes an unknown out |

use super::Trace;
use super::constraint_forces::ConstraintForces;
use super::hinge::BasisVector;
use super::motion_problem::{MotionProblem, MotionSolution, basis_motion};
use super::reflection::{Reflection, VectorSpace};
use super::sweep::{Flatten, PerLink};
use crate::ids::LinkId;
use crate::math::{Motion, Scalar, Wrench};

/// A column of the product: what belongs to one unknown, or the known part.
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

/// A condition that was used, and what it settled.
struct UsedCondition<S> {
    reflection: Reflection<S>,
    determined: S,
}

/// The movement, with the reactions of a closing hinge that the Riccati transfer has found.
///
/// Where nothing with inertia lies beyond a hinge the boundary solve has no answer, but rounding
/// hides it: whoever calls has to look at the pivots of the Riccati transfer.
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
            let mut here = match (before, problem.links[link].parent) {
                (Some(before), Some(parent)) => before.across(problem, parent, link),
                _ => TransferProduct::at_ground(problem, link),
            };
            let used = here.cross_hinge(problem, link, trace);
            here.record(&hinge.name, trace);
            (Some(here), used)
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

/// The links from the ground to the far end; a moving end at the far side is not among them.
fn path<S: Scalar>(problem: &MotionProblem<S>) -> Vec<LinkId> {
    let last = match &problem.loop_constraints {
        Some(constraints) => constraints.loop_hinge.parent,
        None => problem.links.ids().into_iter().next_back(),
    };
    last.map_or(Vec::new(), |last| problem.tree.path_to(last))
}

/// `a` of all points, from the amounts of all columns.
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
    /// The start of the chain: its acceleration is known, its wrench is the unknown.
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

    /// Over the body at `from` [P, Eqs. (17) to (19)] and into the axes of `to`.
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

    /// The wrench behind the body at a link, about its point, in place of the one in front of it.
    fn outboard_of_body(&self, problem: &MotionProblem<S>, link: LinkId) -> Self {
        let inertia = problem.inertia(link);
        let taken =
            |part: &StateColumn<S>| StateColumn { a: part.a, f: part.f - inertia.times(part.a) };
        let known = taken(&self.known);
        TransferProduct {
            known: StateColumn { a: known.a, f: known.f - problem.bias_forces[link] },
            columns: self.columns.iter().map(taken).collect(),
        }
    }

    /// Uses all conditions of a hinge.
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

    /// Uses the condition `sᵀ F + I β = τ` and lets the direction `s` go, `β` being a new unknown.
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
            // What the reflection has made zero but for rounding is zero.
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
            trace.motion(&format!("{name}_a{number}"), part.a);
            trace.wrench(&format!("{name}_f{number}"), part.f);
        }
        trace.motion(&format!("{name}_a"), self.known.a);
        trace.wrench(&format!("{name}_f"), self.known.f);
    }
}

/// The boundary conditions outboard of the last body, [P, Eq. (11)].
fn far_end<S: Scalar>(
    problem: &MotionProblem<S>,
    (product, last): (&TransferProduct<S>, LinkId),
    reactions: &[S],
    trace: &mut Trace<S>,
) -> Vec<S> {
    trace.section("end", "Boundary solve at the far end", "[P, Eqs. (9) to (11)]");
    let end = product.outboard_of_body(problem, last);
    let given = problem.loop_constraints.as_ref().map_or(Wrench::zero(), |constraints| {
        constraints
            .loop_hinge
            .hinge
            .wrench_to_parent(constraints.loop_hinge.wrench(constraints.applied, reactions))
    });
    let rows = problem.dimension.axes().iter().map(|&k| BoundaryRow {
        coefficients: end.columns.iter().map(|part| part.f.at(k)).collect(),
        value: given.at(k) - end.known.f.at(k),
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

/// Back through the hinges: each gives up its `β` and gets its eliminated unknown.
fn recover<S: Scalar>(
    unknowns: Vec<S>,
    used: &[(LinkId, Vec<UsedCondition<S>>)],
    trace: &mut Trace<S>,
    problem: &MotionProblem<S>,
) -> Vec<(LinkId, Vec<S>)> {
    let (_, amounts) = problem.tree.back_along(used, unknowns, |link, steps, mut unknowns| {
        let name = &problem.links[link].hinge.name;
        trace.section(format!("{name}_back"), format!("Back to `{name}`"), "[P, Eqs. (8), (11)]");
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
