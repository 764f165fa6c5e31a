//! Riccati transfer: from the free end to the ground, the relation `F = A a + e` at every point.
//!
//! For every hinge, with `a = a' + S β` and the condition `Sᵀ F = τ`, one free direction `s` after
//! the other is eliminated:
//!
//! (1)  `y = A s`, `d = sᵀ y`, `z = y / d`, `w = τ − sᵀ e`
//! (2)  `A ← A − z yᵀ`, `e ← e + z w`
//! (3)  `β = w / d − zᵀ a'`, on the way back
//!
//! Chains in a plane have so little to compute for each body that they wait for `1 / d` most of the
//! time: there (2) is `A ← A − (y yᵀ) / d`, and in (3) `zᵀ a'` is taken apart into what hangs on the
//! parent and what does not.
//!
//! The last of several axes of a hinge need not wait for the one before. With what `A` was before that
//! one, `a` and `c` on its diagonal for the two and `b` beside it, `d = c − b² / a`:
//!
//! (6)  `1 / d = a / (a c − b²)`
//!
//! What is left has `A s = 0` and `sᵀ e = τ`. Where `s` is an axis both are set exactly, and `A`
//! keeps one of each pair of entries only: without that, chains of balls lose all digits.
//!
//! A closing hinge pulls at its link with unknown reactions, `F = A a + e + E λ`, and demands what
//! `a` of that link is to be along them. The same sweep carries both to the ground:
//!
//! (4)  `u = Eᵀ s`, `E ← E − z uᵀ`, `γ ← γ + u w / d`, `G ← G + u uᵀ / d`
//! (5)  `Tᵀ a = γ + Eᵀ a_ground − G λ`

mod direction;
mod recover;

use super::closure::{self, Closure, Dof, Reactions};
use super::motion::Drift;
use super::passage::Bundle;
use super::problem::{Movement, Problem, Relation};
use super::{Pivot, Trace};
use crate::math::{Motion, Scalar, SpatialInertia, Vec3, Wrench};
use direction::{Condition, Eliminated, eliminate};
use recover::recover;

/// What is carried inwards.
#[derive(Clone)]
struct Carried<S> {
    /// `A`
    inertia: SpatialInertia<S>,
    /// `e`
    load: Wrench<S>,
    /// `E`, by columns.
    pulls: Vec<Wrench<S>>,
    /// Squares of the arms that its moments come from.
    reach: S,
    /// What a pivot along a shift or a turn is the sum of: one that should vanish is what rounding
    /// leaves of it.
    scales: (S, S),
}

/// What has been summed up for a closing hinge.
#[derive(Clone)]
struct Sums<S> {
    /// `γ`
    gamma: Vec<S>,
    /// What `G` is the sum of, outside of repeated parts.
    dofs: Vec<Dof<S>>,
    /// The part of `G` that repeated parts add, below the diagonal and on it, by rows.
    repeated: Vec<Vec<S>>,
    /// What the diagonal of `G` would be if nothing in it cancelled.
    sizes: Vec<S>,
}

/// The movement, and the pivots `d`.
pub fn solve<S: Scalar>(
    problem: &Problem<S>,
    trace: &mut Trace<S>,
) -> (Movement<S>, Vec<Pivot<S>>) {
    let Reduced { mut eliminated, relations, sums, pivots } = reduce(problem, trace);
    let closure = close(problem, sums, trace);
    for step in eliminated.iter_mut().flatten() {
        let pulled = super::hinge::dot(&step.pulls, &closure.reactions);
        step.rest = step.rest - pulled;
    }
    let (amounts, points) = recover(problem, &eliminated, trace);
    (Movement { amounts, points, relations, closure }, pivots)
}

/// For methods that solve for the movement in another way: pivots, the reactions of a closing hinge, and
/// what hinges transmit.
pub fn reduced<S: Scalar>(
    problem: &Problem<S>,
    trace: &mut Trace<S>,
) -> (Vec<Pivot<S>>, Closure<S>, Vec<Relation<S>>) {
    let Reduced { pivots, sums, relations, .. } = reduce(problem, &mut Trace::new());
    trace.section(
        "pivots",
        "Inertia beyond the hinges, to be divided by",
        "the pivots of the Riccati transfer",
    );
    for pivot in &pivots {
        trace.number(format!("{}_d", problem.links[pivot.link].over.name), pivot.value);
    }
    let closure = close(problem, sums, trace);
    (pivots, closure, relations)
}

/// What comes out of the way to the ground.
struct Reduced<S> {
    /// What each link has eliminated.
    eliminated: Vec<Vec<Eliminated<S>>>,
    /// What is left of `F = A a + e` then.
    relations: Vec<Relation<S>>,
    sums: Sums<S>,
    pivots: Vec<Pivot<S>>,
}

/// From the free end to the ground.
fn reduce<S: Scalar>(problem: &Problem<S>, trace: &mut Trace<S>) -> Reduced<S> {
    let links = problem.links;
    let mut eliminated: Vec<Vec<Eliminated<S>>> = links.iter().map(|_| Vec::new()).collect();
    let (mut pivots, mut relations) = (Vec::new(), Vec::new());
    let mut sums = Sums::of(problem.closing.as_ref().map_or(0, |it| it.closing.held.len()));
    let mut carried = own(problem);
    for index in (0..links.len()).rev() {
        (carried[index], sums) = problem.passage.inwards(index, (carried[index].clone(), sums));
        let over = &links[index].over;
        trace.section(
            format!("{}_riccati", over.name),
            format!("Riccati transfer over `{}`", over.name),
            "F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]",
        );
        let mut here = carried[index].clone();
        trace.inertia(&format!("{}_articulated", over.name), here.inertia);
        trace.wrench(&format!("{}_bias", over.name), here.load);
        let conditions = problem.efforts[index].iter().zip(&over.freedom.armature);
        let conditions: Vec<Condition<S>> = over
            .freedom
            .columns
            .iter()
            .zip(conditions)
            .map(|(&column, (&effort, &armature))| Condition { column, effort, armature })
            .collect();
        let steps = eliminate(&mut here, &conditions);
        for (_, step) in &steps {
            sums.add(step, problem.passage.is_repeated(index));
        }
        for (number, (condition, (pivot, step))) in conditions.iter().zip(steps).enumerate() {
            let scale = condition.column.scale(here.scales.0, here.scales.1) + condition.armature;
            let number = if conditions.len() > 1 { number.to_string() } else { String::new() };
            trace.number(format!("{}_d{number}", over.name), pivot);
            trace.number(format!("{}_d{number}_inverse", over.name), step.inverse);
            trace.number(format!("{}_d{number}_scale", over.name), scale);
            trace.wrench(&format!("{}_gain{number}", over.name), step.gain);
            trace.number(format!("{}_rest{number}", over.name), step.rest);
            eliminated[index].push(step);
            pivots.push(Pivot { link: index, value: pivot, scale });
        }
        for (gamma, pull) in sums.gamma.iter_mut().zip(&here.pulls) {
            *gamma = *gamma + problem.drift[index].power(&over.to_parent, *pull);
        }
        match links[index].parent {
            Some(parent) => hand_over(&here, problem, index, &mut carried[parent]),
            None => sums.arrive(&here, over.carried(problem.ground)),
        }
        relations.push(Relation { inertia: here.inertia, load: here.load });
    }
    relations.reverse();
    // Reactions would come on top, in as many products as a sum over all bodies takes.
    let relations = if problem.closing.is_none() { relations } else { Vec::new() };
    Reduced { eliminated, relations, sums, pivots }
}

/// What every link carries of its own part, and of the closing hinge.
fn own<S: Scalar>(problem: &Problem<S>) -> Vec<Carried<S>> {
    let none = problem.closing.as_ref().map_or(0, |it| it.closing.held.len());
    let carried = |(index, &load): (usize, &Wrench<S>)| {
        let inertia = problem.inertia(index);
        Carried {
            inertia,
            load,
            pulls: vec![Wrench::zero(); none],
            reach: S::zero(),
            scales: problem.scales(index),
        }
    };
    let mut all: Vec<Carried<S>> = problem.loads.iter().enumerate().map(carried).collect();
    if let (Some(demand), Some((link, pulls))) = (&problem.closing, problem.pulls()) {
        all[link].load = all[link].load + demand.closing.over.returned(demand.given);
        all[link].pulls = pulls;
        let arm = demand.closing.over.arm;
        all[link].reach = arm.dot(arm);
    }
    all
}

/// From a link's point, behind its hinge, to its parent's.
fn hand_over<S: Scalar>(
    here: &Carried<S>,
    problem: &Problem<S>,
    index: usize,
    parent: &mut Carried<S>,
) {
    let over = &problem.links[index].over;
    let mass = here.inertia.linear.trace() + problem.given_mass(index) * S::number(3.0);
    parent.scales.0 = parent.scales.0 + mass;
    parent.scales.1 = parent.scales.1 + mass * over.arm.dot(over.arm);
    let Drift { on_parent, in_hinge } = problem.drift[index];
    let load = (here.load + here.inertia.times(in_hinge)).turned(&over.to_parent);
    let inertia = over.to_parent.of_inertia(&here.inertia);
    let load = load + inertia.times(Motion { linear: on_parent, angular: Vec3::zero() });
    parent.inertia = parent.inertia + inertia.moved_from(over.arm);
    parent.load = parent.load + load.moved_from(over.arm);
    parent.reach = parent.reach + here.reach + over.arm.dot(over.arm);
    for (pull, &more) in parent.pulls.iter_mut().zip(&here.pulls) {
        *pull = *pull + over.returned(more);
    }
}

impl<S: Scalar> Bundle<S> for Carried<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let inertia = self.inertia.visit(replace);
        let load = self.load.visit(replace);
        let pulls = self.pulls.visit(replace);
        let reach = replace(self.reach);
        Carried { inertia, load, pulls, reach, scales: self.scales.visit(replace) }
    }
}

impl<S: Scalar> Bundle<S> for Sums<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let gamma = self.gamma.visit(replace);
        let repeated = self.repeated.visit(replace);
        Sums { gamma, repeated, sizes: self.sizes.visit(replace), dofs: self.dofs }
    }
}

impl<S: Scalar> Sums<S> {
    fn of(count: usize) -> Self {
        let zero = || vec![S::zero(); count];
        let row = |row: usize| vec![S::zero(); row + 1];
        let repeated = (0..count).map(row).collect();
        Sums { gamma: zero(), dofs: Vec::new(), repeated, sizes: zero() }
    }

    /// Equation (4), except for `E`.
    fn add(&mut self, step: &Eliminated<S>, is_repeated: bool) {
        let Eliminated { along, inverse, rest, pulls, sizes, .. } = step;
        for (i, &u) in along.iter().enumerate() {
            self.gamma[i] = self.gamma[i] + u * *rest;
            self.sizes[i] = self.sizes[i] + sizes[i] * *inverse;
        }
        if !is_repeated {
            return self.dofs.push(Dof { along: along.clone(), inverse: *inverse });
        }
        for (row, &u) in self.repeated.iter_mut().zip(along) {
            for (sum, &pull) in row.iter_mut().zip(pulls) {
                *sum = *sum + u * pull;
            }
        }
    }

    /// The part of equation (5) that the ground makes, from its `a` at the first link's point.
    fn arrive(&mut self, here: &Carried<S>, ground: Motion<S>) {
        for (gamma, pull) in self.gamma.iter_mut().zip(&here.pulls) {
            *gamma = *gamma + ground.power(*pull);
        }
    }
}

/// Equation (5) solved for the reactions.
fn close<S: Scalar>(problem: &Problem<S>, sums: Sums<S>, trace: &mut Trace<S>) -> Closure<S> {
    let Some(demand) = &problem.closing else { return Closure::none() };
    trace.section("closure", "Closure", "[P, Eqs. (9) to (11)] at the held end");
    let Sums { gamma, mut dofs, repeated, mut sizes } = sums;
    // Where the closing hinge hangs on the ground, nothing it does moves anything.
    let gamma = if demand.closing.parent.is_some() { gamma } else { problem.at_rest() };
    let with_rotors = demand.closing.held.iter().enumerate();
    for (k, held) in with_rotors.filter(|(_, held)| !held.inertia.vanishes()) {
        let along = (0..sizes.len()).map(|i| if i == k { S::one() } else { S::zero() }).collect();
        dofs.push(Dof { along, inverse: held.inertia });
        sizes[k] = sizes[k] + held.inertia;
    }
    let right = gamma.iter().zip(&demand.reached).map(|(&g, &r)| g - r).collect();
    let linkage = demand.linkage.clone();
    closure::solve(&Reactions { dofs, repeated, sizes, right, linkage }, trace)
}
