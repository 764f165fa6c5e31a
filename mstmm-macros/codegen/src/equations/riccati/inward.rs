//! From the free ends to the ground: equations (1), (2) and (4).

use super::super::kinematics::HingeKinematics;
use super::super::motion_problem::{AffineWrench, MotionProblem};
use super::super::sweep::PerLink;
use super::super::{HingePivot, Trace, strategy};
use super::articulated_body::ArticulatedBody;
use super::eliminate::{HingeDof, eliminate};
use super::eliminated_dof::EliminatedDof;
use super::loop_sums::LoopSums;
use crate::ids::LinkId;
use crate::math::{Scalar, SpatialInertia, Wrench};

/// What comes out of the way to the ground.
pub struct InwardSweep<S> {
    /// What each link has eliminated.
    pub eliminated: PerLink<Vec<EliminatedDof<S>>>,
    /// What is left of `F = Iᴬ a + pᴬ` then.
    pub relations: PerLink<AffineWrench<S>>,
    /// The open loop as it arrives at the ground.
    pub open: Option<LoopSums<S>>,
    /// `D` of all directions, the last link first.
    pub pivots: Vec<HingePivot<S>>,
}

/// From the free ends to the ground.
pub fn reduce<S: Scalar>(problem: &MotionProblem<S>, trace: &mut Trace<S>) -> InwardSweep<S> {
    let step = |link: LinkId, mut here: ArticulatedBody<S>, parent: &mut ArticulatedBody<S>| {
        let hinge = &problem.links[link].hinge;
        trace.section(
            format!("{}_riccati", hinge.name),
            format!("Riccati transfer over `{}`", hinge.name),
            "F = I a + p, [P, Eqs. (18), (19), (25), (35)]",
        );
        trace.inertia(&format!("{}_articulated", hinge.name), here.inertia);
        trace.wrench(&format!("{}_bias", hinge.name), here.bias);
        for (number, &column) in here.columns.iter().enumerate() {
            trace.wrench(&format!("{}_column{number}", hinge.name), column);
        }
        let conditions = conditions(hinge, &problem.efforts[link]);
        let steps = eliminate(&mut here, &conditions);
        if let Some(open) = &mut here.open {
            open.add_directions(&steps, problem.tree.is_repeated(link));
            open.add_drift(problem.drift[link], hinge, &here.columns);
        }
        let pivots = pivots(link, &here, &conditions, &steps);
        record(trace, &hinge.name, &steps, &pivots);
        let relation = AffineWrench { inertia: here.inertia, bias: here.bias };
        match problem.links[link].parent {
            Some(_) => here.add_to_parent(problem, link, parent),
            None => parent.hold(here.on_ground(hinge.motion_from_parent(problem.ground))),
        }
        (steps, pivots, relation)
    };
    let nothing = SpatialInertia::from_fn(|_, _| S::zero());
    let ground = ArticulatedBody::with(nothing, Wrench::zero());
    let (records, ground) = problem.tree.inward(own(problem), ground, step);
    let pivots = records.iter().rev().flat_map(|(_, pivots, _)| pivots.iter().copied()).collect();
    let relations = if strategy::keeps_relations(problem.closing.is_some()) {
        records.iter().map(|&(.., relation)| relation).collect()
    } else {
        PerLink::new()
    };
    let eliminated = records.into_iter().map(|(steps, ..)| steps).collect();
    InwardSweep { eliminated, relations, open: ground.open, pivots }
}

/// What every link has of itself, the closing hinge where it hangs on the link.
fn own<S: Scalar>(problem: &MotionProblem<S>) -> PerLink<ArticulatedBody<S>> {
    let of = |(link, &bias): (LinkId, &Wrench<S>)| {
        let inertia = problem.inertia(link);
        ArticulatedBody { scales: problem.scales(link), ..ArticulatedBody::with(inertia, bias) }
    };
    let mut all: PerLink<ArticulatedBody<S>> = problem.loads.enumerate().map(of).collect();
    if let (Some(demand), Some((link, columns))) = (&problem.closing, problem.pulls()) {
        let hinge = &demand.closing.hinge;
        all[link].bias = all[link].bias + hinge.wrench_to_parent(demand.given);
        all[link].open = Some(LoopSums::new(columns.len()));
        all[link].columns = columns;
        all[link].reach = hinge.arm.dot(hinge.arm);
    }
    all
}

/// The free directions of a hinge with their efforts.
fn conditions<S: Scalar>(hinge: &HingeKinematics<S>, efforts: &[S]) -> Vec<HingeDof<S>> {
    let given = efforts.iter().zip(&hinge.basis.armature);
    let columns = hinge.basis.columns.iter().zip(given);
    columns.map(|(&column, (&effort, &armature))| HingeDof { column, effort, armature }).collect()
}

/// What a link divides by.
fn pivots<S: Scalar>(
    link: LinkId,
    here: &ArticulatedBody<S>,
    conditions: &[HingeDof<S>],
    steps: &[EliminatedDof<S>],
) -> Vec<HingePivot<S>> {
    let (mass, moment) = here.scales;
    let of = |(condition, step): (&HingeDof<S>, &EliminatedDof<S>)| {
        let scale = condition.column.pivot_scale(mass, moment) + condition.armature;
        HingePivot { link, value: step.pivot, scale }
    };
    conditions.iter().zip(steps).map(of).collect()
}

fn record<S: Scalar>(
    trace: &mut Trace<S>,
    name: &str,
    steps: &[EliminatedDof<S>],
    pivots: &[HingePivot<S>],
) {
    for (number, (step, pivot)) in steps.iter().zip(pivots).enumerate() {
        let number = if steps.len() > 1 { number.to_string() } else { String::new() };
        trace.number(format!("{name}_d{number}"), pivot.value);
        trace.number(format!("{name}_d{number}_inverse"), step.inverse);
        trace.number(format!("{name}_d{number}_scale"), pivot.scale);
        trace.wrench(&format!("{name}_gain{number}"), step.gain);
        trace.number(format!("{name}_rest{number}"), step.rest);
        for (column, &along) in step.along.iter().enumerate() {
            trace.number(format!("{name}_column{column}_along{number}"), along);
        }
    }
}
