//! Factorisation of the constraint rows in the order of their remaining norms: equation (1) of
//! [`super`].

use super::super::hinge::dot;
use super::{ConstraintSystem, Rank, plus_scaled};
use crate::math::{RANK_ULPS, Scalar};

/// One step of the factorisation.
pub(super) struct FactorStep<S> {
    /// The unit vector `e_i` of the selected row.
    pub(super) selector: Vec<S>,
    /// `l_k`: one in the selected row, zero in the rows of earlier steps, and zero if the pivot is
    /// a rounding error.
    pub(super) column: Vec<S>,
    /// The pivot `d_k`.
    pub(super) pivot: S,
    /// `d_k / s_i`
    pub(super) relative_pivot: S,
    /// `1 / d_k`, zero if the pivot is a rounding error.
    pub(super) inverse: S,
}

/// A row of `J` in two forms. The product of two rows multiplies the left form of one with the
/// right form of the other.
#[derive(Clone)]
struct JacobianRow<S> {
    left: Vec<S>,
    /// The left form, multiplied by the part of `Λ` between the rows.
    right: Vec<S>,
}

impl<S: Scalar> JacobianRow<S> {
    fn product(&self, other: &Self) -> S {
        dot(&self.left, &other.right)
    }

    fn plus_scaled(self, other: &Self, factor: S) -> Self {
        let left = plus_scaled(self.left, &other.left, factor);
        JacobianRow { left, right: plus_scaled(self.right, &other.right, factor) }
    }

    fn vanishes(&self) -> bool {
        self.right.iter().all(|x| x.vanishes())
    }
}

/// The rows that remain after the steps so far.
pub(super) struct RemainingRows<S> {
    rows: Vec<JacobianRow<S>>,
    /// One for each row that no step has selected; zero for the others.
    pub(super) unused: Vec<S>,
    /// The rows that do not vanish in every state. Only these rows are selected.
    pub(super) candidates: Vec<usize>,
}

/// Returns the steps of equation (1), and the rows that remain.
pub(super) fn factorize<S: Scalar>(
    system: &ConstraintSystem<S>,
) -> (Vec<FactorStep<S>>, RemainingRows<S>) {
    let mut left = RemainingRows::of(system);
    let mut pivots = Vec::new();
    let is_regular = system.is_regular(&left);
    for allowed in system.steps(&left) {
        let is_last = pivots.len() + 1 == left.candidates.len();
        let selector = if is_regular {
            left.in_order(pivots.len())
        } else if is_last {
            left.only_unused()
        } else {
            left.largest(&system.scales)
        };
        pivots.push(left.eliminate(selector, system, allowed));
    }
    (pivots, left)
}

impl<S: Scalar> RemainingRows<S> {
    fn of(system: &ConstraintSystem<S>) -> Self {
        let count = system.rhs.len();
        let repeated = |i: usize, j: usize| system.repeated[i.max(j)][i.min(j)];
        let shared: Vec<usize> = (0..count).filter(|&k| !repeated(k, k).vanishes()).collect();
        let roots: Vec<S> = system.terms.iter().map(|term| term.inverse.sqrt()).collect();
        let row = |i: usize| {
            let terms = system.terms.iter().zip(&roots);
            let entries: Vec<S> = terms.map(|(term, &root)| term.t[i] * root).collect();
            let unit = shared.iter().map(|&k| if k == i { S::one() } else { S::zero() });
            let between = shared.iter().map(|&k| repeated(i, k));
            let left = entries.iter().copied().chain(unit).collect();
            JacobianRow { left, right: entries.iter().copied().chain(between).collect() }
        };
        let rows: Vec<JacobianRow<S>> = (0..count).map(row).collect();
        let candidates = (0..count).filter(|&k| !rows[k].vanishes()).collect();
        RemainingRows { rows, unused: vec![S::one(); count], candidates }
    }

    /// Returns the selector of a row by the number of its step.
    fn in_order(&self, step: usize) -> Vec<S> {
        let weight = |k| if k == step { S::one() } else { S::zero() };
        self.scatter((0..self.candidates.len()).map(weight).collect())
    }

    /// Returns the selector of the only unused row.
    fn only_unused(&self) -> Vec<S> {
        self.scatter(self.candidates.iter().map(|&row| self.unused[row]).collect())
    }

    /// Returns the selector of the unused row with the largest remaining norm.
    fn largest(&self, scales: &[S]) -> Vec<S> {
        self.scatter(largest(&self.scores(scales)).0)
    }

    /// Returns the largest remaining relative norm.
    pub(super) fn excess(&self, system: &ConstraintSystem<S>) -> S {
        largest(&self.scores(&system.scales)).1
    }

    /// Returns the remaining relative norm of each candidate.
    fn scores(&self, scales: &[S]) -> Vec<S> {
        let score = |&k: &usize| {
            let (row, open) = (&self.rows[k], self.unused[k]);
            // Used rows have the lowest scores.
            let closed = S::one() - open;
            row.product(row) * scales[k].recip_above(S::zero()) * open - closed
        };
        self.candidates.iter().map(score).collect()
    }

    /// Returns weights of the candidates as weights of all rows.
    pub(super) fn scatter(&self, weights: Vec<S>) -> Vec<S> {
        let mut weights_of_rows = vec![S::zero(); self.unused.len()];
        for (&row, weight) in self.candidates.iter().zip(weights) {
            weights_of_rows[row] = weight;
        }
        weights_of_rows
    }

    fn eliminate(
        &mut self,
        selector: Vec<S>,
        system: &ConstraintSystem<S>,
        allowed: S,
    ) -> FactorStep<S> {
        let zero = vec![S::zero(); self.rows[0].left.len()];
        let none = JacobianRow { left: zero.clone(), right: zero };
        let weighted = self.rows.iter().zip(&selector);
        let chosen = weighted.fold(none, |sum, (row, &weight)| sum.plus_scaled(row, weight));
        let (pivot, scale) = (chosen.product(&chosen), dot(&selector, &system.scales));
        let inverse = system.guarded_reciprocal(pivot, scale) * allowed;
        let along = |(row, &open): (&JacobianRow<S>, &S)| row.product(&chosen) * inverse * open;
        let column: Vec<S> = self.rows.iter().zip(&self.unused).map(along).collect();
        for (row, &amount) in self.rows.iter_mut().zip(&column) {
            *row = row.clone().plus_scaled(&chosen, -amount);
        }
        self.unused = plus_scaled(self.unused.clone(), &selector, -S::one());
        let relative_pivot = pivot * scale.recip_above(S::zero());
        FactorStep { selector, column, pivot, relative_pivot, inverse }
    }
}

impl<S: Scalar> ConstraintSystem<S> {
    /// Whether rows depend on others in singular poses only. Then any order of the rows is
    /// possible.
    pub(super) fn is_regular(&self, left: &RemainingRows<S>) -> bool {
        matches!(self.rank.rank, Rank::Known(rank) if rank >= left.candidates.len())
    }

    /// Returns a weight for each possible step: one, or zero beyond the rank.
    pub(super) fn steps(&self, left: &RemainingRows<S>) -> Vec<S> {
        let most = left.candidates.len();
        match &self.rank.rank {
            Rank::Known(rank) => vec![S::one(); most.min(*rank)],
            Rank::AtRunTime(steps) => steps.iter().copied().take(most).collect(),
        }
    }

    /// Returns `1 / d` of a square, or zero if the direction is undetermined. With a pivot of less
    /// than a unit in the last place of `s_i`, the rounding error of `b` would cause larger
    /// constraint forces than the loads do.
    fn guarded_reciprocal(&self, square: S, scale: S) -> S {
        let is_kept = self.repeated.iter().flatten().all(|x| x.vanishes());
        let units = if is_kept { 1.0 } else { self.rank.rounding };
        square.recip_above(scale * S::number(units / RANK_ULPS))
    }
}

/// Returns weights that are one at the largest value and zero elsewhere, and that value.
fn largest<S: Scalar>(values: &[S]) -> (Vec<S>, S) {
    let mut weights = vec![S::one()];
    let mut best = values[0];
    for &number in &values[1..] {
        let (is_less, is_more) = (number - best).sides();
        for weight in &mut weights {
            *weight = *weight * is_less;
        }
        weights.push(is_more);
        best = best * is_less + number * is_more;
    }
    (weights, best)
}
