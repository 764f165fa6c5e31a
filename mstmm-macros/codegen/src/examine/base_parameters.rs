//! The base parameters: the dynamic parameters that motions can identify.
//!
//! Some columns of the regressor are linear combinations of others in every state. Parameters of a set of
//! independent columns, each with its share of the dependent ones added, are the base parameters (W. Khalil,
//! E. Dombre, Modeling, Identification and Control of Robots, chapter 9).

use super::dry_run::{DryRun, Number, near_zero};
use crate::equations::{Axes, Trace, regressor};
use crate::ids::IdVec;
use crate::model::LinkId;

/// A column depends on earlier ones if the rest is smaller than this, relative to the column. The columns of states that
/// differ by half a radian have condition numbers below a million for the robots tested.
const DEPENDENT: f64 = 1e-8;
/// A column is zero, up to rounding, if it is smaller than this, relative to the largest column. Mass columns of arms of
/// a millimetre are 10⁶ times smaller than those of inertias.
const ZERO: f64 = 1e-12;
/// The number of equations for each parameter.
const EQUATIONS: usize = 2;
/// The number of inertial parameters of a rigid body in space.
const INERTIAL: usize = 10;

impl DryRun {
    /// Returns the indices of the first dynamic parameters whose columns are independent.
    pub(super) fn base_parameters(&self) -> Vec<usize> {
        let mut independent: Vec<Vec<f64>> = Vec::new();
        let columns = self.stacked();
        let largest = columns.iter().map(|column| norm(column)).fold(0.0, f64::max);
        let mut is_new = |column: &Vec<f64>| {
            let length = norm(column);
            let mut rest = column.clone();
            // Twice is enough (W. Kahan), since rounding errors of the first pass are removed by the second.
            for _ in 0..2 {
                for direction in &independent {
                    let along: f64 = direction.iter().zip(&rest).map(|(a, b)| a * b).sum();
                    rest.iter_mut().zip(direction).for_each(|(rest, a)| *rest -= along * a);
                }
            }
            let left = norm(&rest);
            let is_independent = length > ZERO * largest && left > DEPENDENT * length;
            if is_independent {
                independent.push(rest.into_iter().map(|entry| entry / left).collect());
            }
            is_independent
        };
        (0..columns.len()).filter(|&k| is_new(&columns[k])).collect()
    }

    /// Returns the columns of the regressor, stacked over states near the start, with all inputs in motion.
    fn stacked(&self) -> Vec<Vec<f64>> {
        let count = self.chain.dynamic_parameters().len();
        let rates = self.merged.dof_count().max(1);
        let mut columns = vec![Vec::new(); count];
        for seed in 1..=self.states(count) {
            let pose = self.pose_in_motion(seed);
            let v: Vec<Number> = (0..rates).map(|k| near_zero(100 + k, seed)).collect();
            let accelerations: Vec<Number> =
                (0..rates).map(|k| near_zero(1000 + k, seed)).collect();
            let state = (&pose.q[..], &v[..], &pose.inputs[..]);
            let context = self.context(&self.merged, &self.values, state);
            let context = context.with_accelerations(&accelerations);
            let of_state = regressor(&context, Axes::Body, &mut Trace::silent());
            for (column, entries) in columns.iter_mut().zip(of_state) {
                column.extend(entries.into_iter().map(|entry| entry.value()));
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
        // A group of one link has fewer independent parameters.
        let groups = sizes.iter().filter(|(_, size)| *size > 1);
        let average = (EQUATIONS * count).div_ceil(rates);
        groups.map(of_group).fold(average, usize::max) + 1
    }
}

fn norm(column: &[f64]) -> f64 {
    column.iter().map(|entry| entry * entry).sum::<f64>().sqrt()
}
