//! The base parameters: the dynamic parameters that motions can identify.
//!
//! Some columns of the regressor are linear combinations of others in every state. Parameters of a set of
//! independent columns, each with its share of the dependent ones added, are the base parameters (W. Khalil,
//! E. Dombre, Modeling, Identification and Control of Robots, chapter 9).

use super::dry_run::{DryRun, Number, low_discrepancy};
use crate::equations::{Axes, Trace, regressor};

/// A column depends on earlier ones if the rest is smaller than this, relative to the column. The columns of states that
/// differ by half a radian have condition numbers below a million for the robots tested.
const DEPENDENT: f64 = 1e-8;
/// A column is zero, up to rounding, if it is smaller than this, relative to the largest column. Mass columns of arms of
/// a millimetre are 10⁶ times smaller than those of inertias.
const ZERO: f64 = 1e-12;
/// The number of equations for each parameter.
const EQUATIONS: usize = 2;

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

    /// Returns the columns of the regressor, stacked over states near the start.
    fn stacked(&self) -> Vec<Vec<f64>> {
        let count = self.chain.dynamic_parameters().len();
        let rates = self.merged.dof_count().max(1);
        let mut columns = vec![Vec::new(); count];
        for seed in 1..=(EQUATIONS * count).div_ceil(rates) + 1 {
            let any = |number: usize| Number::variable(4.0 * low_discrepancy(number, seed) - 2.0);
            let pose = self.pose(&self.values, seed);
            let v: Vec<Number> = (0..rates).map(|k| any(100 + k)).collect();
            let accelerations: Vec<Number> = (0..rates).map(|k| any(1000 + k)).collect();
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
}

fn norm(column: &[f64]) -> f64 {
    column.iter().map(|entry| entry * entry).sum::<f64>().sqrt()
}
