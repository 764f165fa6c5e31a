//! The base parameters: the dynamic parameters that motions can identify.
//!
//! Some columns of the regressor are linear combinations of others in every state. Parameters of a set of
//! independent columns, each with its share of the dependent ones added, are the base parameters (W. Khalil,
//! E. Dombre, Modeling, Identification and Control of Robots, chapter 9).
//!
//! Changes of parameters that change no effort are sums of changes that involve one link, or a link and its parent: what the
//! motion of a hinge cannot distinguish moves from one of its links to the other (P. M. Wensing, G. Niemeyer, J.-J. E.
//! Slotine, A geometric characterization of observability in inertial parameter identification, Int. J. Robot. Res., 2024).
//! Therefore a column is compared only with the columns of its own link and of the parent.

use super::dry_run::{DryRun, Number, near_zero};
use crate::equations::{Axes, Trace, regressor};
use crate::ids::IdVec;
use crate::model::{DynamicParameter, InertialParameter, LinkId, MovesWith};

/// A column depends on earlier ones if the rest is smaller than this, relative to the column. The columns of states that
/// differ by half a radian have condition numbers below a million for the robots tested.
const DEPENDENT: f64 = 1e-8;
/// The column of an inertial parameter is zero, up to rounding, if it is smaller than this, relative to the largest one, in
/// units of the size of the chain.
const ZERO: f64 = 1e-12;
/// The number of equations for each parameter.
const EQUATIONS: usize = 2;
/// The number of inertial parameters of a rigid body in space.
const INERTIAL: usize = 10;

impl DryRun {
    /// Returns the indices of the base parameters: from the ground outward, those whose columns are independent of the
    /// columns before them.
    pub(super) fn base_parameters(&self) -> Vec<usize> {
        let columns = self.stacked();
        let parameters = self.chain.dynamic_parameters();
        let relative = |k: usize| match parameters[k] {
            DynamicParameter::Inertial(_, parameter) => norm(&columns[k]) / self.unit_of(parameter),
            DynamicParameter::Passive(..) => 0.0,
        };
        let zero = ZERO * (0..columns.len()).map(relative).fold(0.0, f64::max);
        let is_present = |k: usize| match parameters[k] {
            DynamicParameter::Inertial(..) => relative(k) > zero,
            DynamicParameter::Passive(..) => norm(&columns[k]) > 0.0,
        };
        let independent = |span: &mut Span, of_link: &[usize]| {
            let present = of_link.iter().filter(|&&k| is_present(k));
            present.copied().filter(|&k| span.add(&columns[k])).collect::<Vec<_>>()
        };
        let (of_links, apart) = self.parameters_by_links();
        let mut base = independent(&mut Span::default(), &apart);
        for (link, own) in of_links.enumerate() {
            let mut span = Span::default();
            if let Some(parent) = self.merged.links[link].parent {
                independent(&mut span, &of_links[parent]);
            }
            base.extend(independent(&mut span, own));
        }
        base.sort_unstable();
        base
    }

    /// Returns the moment of an inertial parameter at unit angular acceleration, with arms of the size of the chain.
    fn unit_of(&self, parameter: InertialParameter) -> f64 {
        match parameter {
            InertialParameter::Mass => self.size * self.size,
            InertialParameter::FirstMoment(_) => self.size,
            InertialParameter::Inertia(..) => 1.0,
        }
    }

    /// Returns the unit of rates in rad/s. At this rate, centrifugal accelerations at the size of the chain are as large as
    /// the gravity, which would otherwise hide them in small chains.
    fn frequency(&self) -> f64 {
        let (v, pose) = (self.at_rest(), self.pose(&self.values, 0));
        let context = self.context(&self.merged, &self.values, (&pose.q, &v, &pose.inputs));
        let gravity = context.base_acceleration().linear;
        (gravity.dot(gravity).value().sqrt() / self.size).max(1.0).sqrt()
    }

    /// Returns the units of all rates.
    fn rate_units(&self) -> Vec<f64> {
        let free = self.chain.hinges.iter().filter(|hinge| !hinge.is_prescribed());
        free.flat_map(|hinge| self.units(&hinge.kind, |group| group.rates.clone())).collect()
    }

    /// Returns the indices of the dynamic parameters of each link and its hinge, and of those of hinges that close loops.
    fn parameters_by_links(&self) -> (IdVec<LinkId, Vec<usize>>, Vec<usize>) {
        let mut of_links = IdVec::filled(Vec::new(), self.merged.links.len());
        let mut apart = Vec::new();
        for (k, parameter) in self.chain.dynamic_parameters().into_iter().enumerate() {
            match parameter {
                DynamicParameter::Inertial(body, _) => match self.merged.parts[body] {
                    MovesWith::Link(link) => of_links[link].push(k),
                    MovesWith::Ground => {}
                },
                DynamicParameter::Passive(hinge, ..) => {
                    match self.merged.links.position(|link| link.hinge == hinge) {
                        Some(link) => of_links[link].push(k),
                        None => apart.push(k),
                    }
                }
            }
        }
        (of_links, apart)
    }

    /// Returns the columns of the regressor, stacked over states near the start, with all inputs in motion. Forces are
    /// moments at an arm of the size of the chain.
    fn stacked(&self) -> Vec<Vec<f64>> {
        let count = self.chain.dynamic_parameters().len();
        let mut columns = vec![Vec::new(); count];
        let (frequency, units) = (self.frequency(), self.rate_units());
        for seed in 1..=self.states(count) {
            let pose = self.pose_in_motion(frequency, seed);
            let in_units = |first: usize, factor: f64| {
                let numbers = units.iter().enumerate().map(|(k, unit)| {
                    Number::variable(unit * factor * near_zero(first + k, seed).value())
                });
                numbers.collect::<Vec<_>>()
            };
            let v = in_units(100, frequency);
            let accelerations = in_units(1000, frequency * frequency);
            let state = (&pose.q[..], &v[..], &pose.inputs[..]);
            let context = self.context(&self.merged, &self.values, state);
            let context = context.with_accelerations(&accelerations);
            let of_state = regressor(&context, Axes::Body, &mut Trace::silent());
            for (column, entries) in columns.iter_mut().zip(of_state) {
                column.extend(entries.iter().zip(&units).map(|(entry, unit)| entry.value() * unit));
            }
        }
        columns
    }

    /// Returns the number of states, so that there are [`EQUATIONS`] for each parameter.
    ///
    /// Links that move relative to each other by prescribed motions only are a group. The parameters of all its links are
    /// independent, but only the rates of the hinge of its first link, and those inboard of it, have equations with
    /// them.
    fn states(&self, count: usize) -> usize {
        let rates = self.merged.dof_count().max(1);
        let mut first: IdVec<LinkId, Option<LinkId>> = IdVec::default();
        let mut sizes: Vec<(LinkId, usize)> = Vec::new();
        for (id, link) in self.merged.links.enumerate() {
            let is_driven = self.merged.v[link.hinge].is_empty();
            let of_group =
                if is_driven { link.parent.and_then(|parent| first[parent]) } else { Some(id) };
            first.push(of_group);
            match sizes.iter_mut().find(|(group, _)| Some(*group) == of_group) {
                Some((_, size)) => *size += 1,
                None => sizes.extend(of_group.map(|group| (group, 1))),
            }
        }
        let of_group = |&(group, size): &(LinkId, usize)| {
            let own = self.merged.v[self.merged.links[group].hinge].len();
            (EQUATIONS * INERTIAL * size).div_ceil(own)
        };
        let average = (EQUATIONS * count).div_ceil(rates);
        sizes.iter().map(of_group).fold(average, usize::max) + 1
    }
}

/// The space that columns span, by orthonormal vectors.
#[derive(Default)]
struct Span(Vec<Vec<f64>>);

impl Span {
    /// Adds a column; returns whether it is independent of the others.
    fn add(&mut self, column: &[f64]) -> bool {
        let mut rest = column.to_vec();
        // Twice is enough (W. Kahan), since rounding errors of the first pass are removed by the second.
        for direction in self.0.iter().chain(&self.0) {
            let along: f64 = direction.iter().zip(&rest).map(|(a, b)| a * b).sum();
            rest.iter_mut().zip(direction).for_each(|(rest, a)| *rest -= along * a);
        }
        let left = norm(&rest);
        let is_independent = left > DEPENDENT * norm(column);
        if is_independent {
            self.0.push(rest.into_iter().map(|entry| entry / left).collect());
        }
        is_independent
    }
}

fn norm(column: &[f64]) -> f64 {
    column.iter().map(|entry| entry * entry).sum::<f64>().sqrt()
}
