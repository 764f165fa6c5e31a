//! What every hinge transmits, once it is known how the links move [P, Eqs. (18), (19)].

use super::Trace;
use super::problem::{Movement, Problem, Relation};
use crate::math::{Scalar, Wrench};

/// Over so many bodies at most a wrench is a sum where it need not be one: rounding grows with the square
/// of their number.
const MOST_BODIES: usize = 8;

/// On the child's side of every link's hinge, about the link's point, in its work axes; where the hinge
/// frees whole axes that is its effort and nothing else [P, Eqs. (25), (57), (58)].
pub fn transmitted<S: Scalar>(
    problem: &Problem<S>,
    movement: &Movement<S>,
    trace: &mut Trace<S>,
) -> Vec<Wrench<S>> {
    let mut wrenches = from_the_free_end(problem, movement);
    if let Some(demand) = &problem.closing {
        let reaction = demand.closing.wrench(demand.given, &movement.closure.reactions);
        if let Some((child, on_child)) = demand.closing.on_child(reaction) {
            wrenches[child] = wrenches[child] - on_child;
        }
    }
    let released = |(index, wrench): (usize, Wrench<S>)| {
        let over = &problem.links[index].over;
        let wrench = over.freedom.released(wrench, &over.efforts);
        trace.section(
            format!("{}_wrench", over.name),
            format!("Load on `{}`", over.name),
            "[P, Eqs. (18), (19)]",
        );
        trace.wrench(&format!("{}_load", over.name), wrench);
        wrench
    };
    wrenches.into_iter().enumerate().map(released).collect()
}

/// From what every body's own motion takes and its children pass on; where that would be a long sum, or
/// one over the times of a repeated part, from what comes over from the parent, with the relation of
/// the way to the ground. Relations take about as many operations, but their numbers have to be kept
/// until it is known how the links move.
fn from_the_free_end<S: Scalar>(problem: &Problem<S>, movement: &Movement<S>) -> Vec<Wrench<S>> {
    let relations = relations(problem, movement);
    let of = |(index, &load): (usize, &Wrench<S>)| {
        problem.inertia(index).times(movement.points[index]) + load
    };
    let mut wrenches: Vec<Wrench<S>> = problem.loads.iter().enumerate().map(of).collect();
    if let (Some(demand), Some((link, pulls))) = (&problem.closing, problem.pulls()) {
        let given = wrenches[link] + demand.closing.over.returned(demand.given);
        wrenches[link] = pulled(given, &pulls, &movement.closure.reactions);
    }
    for index in (0..wrenches.len()).rev() {
        wrenches[index] = match relations[index] {
            Some(relation) => relation.at(problem.carried(index, &movement.points)),
            None => problem.passage.inwards(index, wrenches[index]),
        };
        let link = &problem.links[index];
        let wrench = link.over.freedom.released(wrenches[index], &link.over.efforts);
        if let Some(parent) = link.parent.filter(|&parent| relations[parent].is_none()) {
            wrenches[parent] = wrenches[parent] + link.over.returned(wrench);
        }
    }
    wrenches
}

/// The relations of hinges that are not to be summed up for, if there are any.
fn relations<'a, S: Scalar>(
    problem: &Problem<S>,
    movement: &'a Movement<S>,
) -> Vec<Option<&'a Relation<S>>> {
    let mut bodies = vec![1; problem.links.len()];
    let mut chosen = vec![None; problem.links.len()];
    for (index, relation) in movement.relations.iter().enumerate().rev() {
        let at_seam = problem.passage.is_seam(index);
        if at_seam || bodies[index] > MOST_BODIES {
            (chosen[index], bodies[index]) = (Some(relation), 0);
        }
        if let Some(parent) = problem.links[index].parent {
            // What is beyond a seam is another time's, and cannot be added up at all.
            let beyond = if at_seam { MOST_BODIES } else { bodies[index] };
            bodies[parent] = bodies[parent].max(beyond + 1);
        }
    }
    chosen
}

/// With the reactions of a closing hinge.
fn pulled<S: Scalar>(wrench: Wrench<S>, pulls: &[Wrench<S>], reactions: &[S]) -> Wrench<S> {
    pulls.iter().zip(reactions).fold(wrench, |sum, (&pull, &amount)| sum + pull.scaled(amount))
}
