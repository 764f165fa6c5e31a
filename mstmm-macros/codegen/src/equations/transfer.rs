//! The forward product from the ground's end, `z_{1,I}` of [P, Eqs. (9), (10)], made general.
//!
//! Every connection point's `a` and `F` are carried as a known part and one column for each of six
//! unknowns, the columns of `U_j … U_1` that the boundary leaves open. Where the paper's hinges
//! look ahead to the next hinge ([P, Eqs. (25), (38)], which loses accuracy with the length of the
//! chain), each hinge here uses its own condition `Sᵀ F = τ` at once to take out as many unknowns
//! as its `β` bring in. The free end's `F = 0` is the boundary solve [P, Eq. (11)]; going back
//! through the eliminations gives every `β`.

use super::elimination::{Mixed, Reflection};
use super::hinge::Column;
use super::{LinkMotion, Trace};
use crate::math::{Motion, Scalar, Wrench};

/// A column of the product: what belongs to one unknown, or the known part.
#[derive(Clone, Copy, Debug)]
struct Part<S> {
    a: Motion<S>,
    f: Wrench<S>,
}

impl<S: Scalar> Mixed<S> for Part<S> {
    fn plus_scaled(self, other: Self, factor: S) -> Self {
        Part { a: self.a + other.a.scaled(factor), f: self.f + other.f.scaled(factor) }
    }
    fn scaled(self, factor: S) -> Self {
        Part { a: self.a.scaled(factor), f: self.f.scaled(factor) }
    }
}

/// The state vector at a connection point as a function of the unknowns.
struct Product<S> {
    known: Part<S>,
    columns: Vec<Part<S>>,
}

/// Amounts of every link's free columns.
///
/// Where nothing with inertia lies beyond a hinge the boundary solve has no answer, but rounding
/// hides it: whoever calls has to look at the pivots of the Riccati transfer.
pub fn solve<S: Scalar>(
    links: &[LinkMotion<S>],
    efforts: &[Vec<S>],
    ground: Motion<S>,
    trace: &mut Trace<S>,
) -> Vec<Vec<S>> {
    let Some(first) = links.first() else { return Vec::new() };
    let mut product = Product::at_ground(first, ground);
    let mut used: Vec<Vec<Reflection<S>>> = Vec::new();
    for (index, link) in links.iter().enumerate() {
        trace.section(
            format!("Transfer to `{}`", link.name),
            "[P, Eqs. (8), (21)] with the conditions [P, Eqs. (25), (35)] of this hinge",
        );
        if index > 0 {
            product.cross(&links[index - 1], link);
        }
        let conditions = link.freedom.columns.iter().zip(&efforts[index]);
        used.push(conditions.map(|(&s, &tau)| product.free(s, tau, link, trace)).collect());
        product.record(link, trace);
    }
    trace.section("Boundary solve at the free end", "[P, Eq. (11)]");
    let unknowns = boundary(product.beyond(&links[links.len() - 1]), trace);
    recover(unknowns, &used, trace, links)
}

impl<S: Scalar> Product<S> {
    /// The start of the chain: its acceleration is known, its wrench is the unknown.
    fn at_ground(first: &LinkMotion<S>, ground: Motion<S>) -> Self {
        let unit = |k| Wrench::from_fn(|i| if i == k { S::one() } else { S::zero() });
        Product {
            known: Part { a: first.carried(ground), f: Wrench::zero() },
            columns: (0..6).map(|k| Part { a: Motion::zero(), f: unit(k) }).collect(),
        }
    }

    /// Over the body at `from` [P, Eqs. (17) to (19)] and into the axes of `to`.
    fn cross(&mut self, from: &LinkMotion<S>, to: &LinkMotion<S>) {
        let inertia = from.rigid();
        let over = |f: Wrench<S>| f.moved_from(-to.arm).turned_back(&to.to_parent);
        for part in &mut self.columns {
            let f = over(part.f - inertia.times(part.a));
            *part = Part { a: part.a.carried_to(to.arm).turned_back(&to.to_parent), f };
        }
        let Part { a, f } = self.known;
        let f = over(f - inertia.times(a) - from.velocity_load());
        self.known = Part { a: to.carried(a), f };
    }

    /// Uses the hinge's condition `sᵀ F = τ` and lets its direction `s` go.
    fn free(
        &mut self,
        s: Column<S>,
        tau: S,
        link: &LinkMotion<S>,
        trace: &mut Trace<S>,
    ) -> Reflection<S> {
        let direction = s.motion();
        let coefficients: Vec<S> =
            self.columns.iter().map(|part| direction.power(part.f)).collect();
        let reflection = Reflection::of(&coefficients, tau - direction.power(self.known.f));
        for (number, &v) in reflection.vector().iter().enumerate() {
            trace.number(format!("{}_v{number}", link.name), v);
        }
        let settled = reflection.apply(&mut self.columns);
        self.known = self.known.plus_scaled(settled, S::one());
        if let Column::Axis(axis) = s {
            // What the reflection has made zero but for rounding is zero.
            let set =
                |f: Wrench<S>, value| Wrench::from_fn(|k| if k == axis { value } else { f.at(k) });
            self.known.f = set(self.known.f, tau);
            for part in &mut self.columns {
                part.f = set(part.f, S::zero());
            }
        }
        self.columns.push(Part { a: direction, f: Wrench::zero() });
        reflection
    }

    /// The wrench beyond the body at `link`, about its point, by rows of unknowns and known part.
    fn beyond(&self, link: &LinkMotion<S>) -> Vec<(Vec<S>, S)> {
        let inertia = link.rigid();
        let known = self.known.f - inertia.times(self.known.a) - link.velocity_load();
        let columns: Vec<Wrench<S>> =
            self.columns.iter().map(|part| part.f - inertia.times(part.a)).collect();
        (0..6).map(|k| (columns.iter().map(|f| f.at(k)).collect(), known.at(k))).collect()
    }

    fn record(&self, link: &LinkMotion<S>, trace: &mut Trace<S>) {
        for (number, part) in self.columns.iter().enumerate() {
            trace.motion(&format!("{}_a{number}", link.name), part.a);
            trace.wrench(&format!("{}_f{number}", link.name), part.f);
        }
        trace.motion(&format!("{}_a", link.name), self.known.a);
        trace.wrench(&format!("{}_f", link.name), self.known.f);
    }
}

/// Solves six conditions `row · x + known = 0`, one after the other.
fn boundary<S: Scalar>(mut rows: Vec<(Vec<S>, S)>, trace: &mut Trace<S>) -> Vec<S> {
    let mut reflections = Vec::new();
    for number in 0..rows.len() {
        let (row, known) = rows[number].clone();
        let reflection = Reflection::of(&row, -known);
        for (row, known) in rows.iter_mut().skip(number + 1) {
            *known = *known + reflection.apply(row);
        }
        reflections.push(reflection);
    }
    let unknowns = reflections.iter().rev().fold(Vec::new(), |y, reflection| reflection.expand(y));
    for (number, &unknown) in unknowns.iter().enumerate() {
        trace.number(format!("end_x{number}"), unknown);
    }
    unknowns
}

/// Back through the hinges: each gives up its `β` and gets its eliminated unknown.
fn recover<S: Scalar>(
    mut unknowns: Vec<S>,
    used: &[Vec<Reflection<S>>],
    trace: &mut Trace<S>,
    links: &[LinkMotion<S>],
) -> Vec<Vec<S>> {
    let mut amounts: Vec<Vec<S>> = Vec::new();
    for (link, reflections) in links.iter().zip(used).rev() {
        trace.section(format!("Back to `{}`", link.name), "[P, Eqs. (8), (11)]");
        let mut betas = Vec::new();
        for reflection in reflections.iter().rev() {
            betas.extend(unknowns.pop());
            unknowns = reflection.expand(unknowns);
        }
        betas.reverse();
        for (number, &beta) in betas.iter().enumerate() {
            trace.number(format!("{}_beta{number}", link.name), beta);
        }
        amounts.push(betas);
    }
    amounts.reverse();
    amounts
}
