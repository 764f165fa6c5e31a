//! The reactions of a closing hinge: `G λ = b` with `G = J M⁻¹ Jᵀ`, which is positive except along the
//! directions that other directions of the hinge determine already, as all those out of the plane of
//! a planar loop and three of the five of Bennett's linkage.
//!
//! Row `i` of `J M^(-1/2)` has an entry `u_i / √d` for each degree of freedom that the Riccati transfer
//! eliminates. Gram and Schmidt's elimination of rows in the order of their norms reveals the rank: it
//! is Cholesky's factorisation of `G` with complete pivoting (Higham, *Accuracy and Stability of Numerical
//! Algorithms*, section 10.3) without the squares, whose rounding would hide small singular values.
//! Row `i` is measured by `s_i`, what its square would be if nothing in it cancelled. Step `k`:
//!
//! (1)  `i = argmax |J_i|² / s_i`, `r_k = J_i`, `d_k = |r_k|²`, `l_k = J r_k / d_k`, `J ← J − l_k r_kᵀ`
//! (2)  `G = L D Lᵀ`, `L = Q R` with the columns of `Q` across each other, `QᵀQ = S`
//! (3)  `λ = G⁺ b = Q S⁻¹ R⁻ᵀ D⁻¹ R⁻¹ S⁻¹ Qᵀ b`
//! (4)  `N = { x : Lᵀ x = 0 }`
//!
//! `λ` has the least norm, in N and N m, of all reactions that fit `b` best; those in `N` make no
//! difference to the motion. Repeated parts have too many degrees of freedom to keep: they add to a part
//! of `G` itself, and products of rows have that between them.
//!
//! A row is chosen by arithmetic, with weights that are one at the row and zero elsewhere, so that every
//! state takes the same steps. There are as many steps as the closure has rank anywhere, which is a
//! property of the linkage: off the closure by the error of an integrator's stage the rank is higher, and
//! a linkage that moves by its proportions only would be rigid. Near a bifurcation, as in the straight
//! pose of a parallelogram, a pivot vanishes; the direction then counts as undetermined.

use super::Trace;
use super::hinge::dot;
use crate::math::{NOISE, Scalar};

/// Reactions and what they do not determine.
#[derive(Clone, Debug)]
pub struct Closure<S> {
    /// `λ` of least norm.
    pub reactions: Vec<S>,
    /// Unit directions, one for each row, along which `λ` makes no difference; zeros where there is
    /// none.
    pub undetermined: Vec<Vec<S>>,
    /// `d_k / s_i` of each step, the largest first.
    pub pivots: Vec<S>,
    /// The largest `|J_i|² / s_i` that all steps have left: what one more step would have found.
    pub excess: S,
}

impl<S: Scalar> Closure<S> {
    /// Of a chain that is not closed.
    pub fn none() -> Self {
        let (reactions, undetermined, pivots) = (Vec::new(), Vec::new(), Vec::new());
        Closure { reactions, undetermined, pivots, excess: S::zero() }
    }
}

/// A linear system for the reactions of a closing hinge.
#[derive(Clone, Debug)]
pub struct Reactions<S> {
    /// What `G` is the sum of, outside of repeated parts.
    pub dofs: Vec<Dof<S>>,
    /// The part of `G` that repeated parts add, below its diagonal and on it, by rows.
    pub repeated: Vec<Vec<S>>,
    /// `s`
    pub sizes: Vec<S>,
    /// `b`
    pub right: Vec<S>,
    /// What there is to know of the linkage.
    pub linkage: Linkage<S>,
}

/// The part of `G` that a degree of freedom adds: `u uᵀ / d`.
#[derive(Clone, Debug)]
pub struct Dof<S> {
    /// `u`
    pub along: Vec<S>,
    /// `1 / d`
    pub inverse: S,
}

/// What the solution for the reactions has to know of a linkage.
#[derive(Clone, Debug)]
pub struct Linkage<S> {
    /// The rank of its closure.
    pub rank: Rank<S>,
    /// How many units in the last place of `s_i` rounding leaves of the square of a row to which repeated
    /// parts have added.
    pub noise: f64,
}

/// How many directions of a closing hinge are independent anywhere on the closure.
#[derive(Clone, Debug)]
pub enum Rank<S> {
    /// So many.
    Known(usize),
    /// As many as there are ones, before zeros.
    Given(Vec<S>),
}

/// Solves for the reactions.
pub fn solve<S: Scalar>(system: &Reactions<S>, trace: &mut Trace<S>) -> Closure<S> {
    let (pivots, left) = factorised(system);
    for (k, pivot) in pivots.iter().enumerate() {
        trace.number(format!("closure_d{k}"), pivot.value);
    }
    let is_regular = system.is_regular(&left);
    let excess = if pivots.len() < left.alive.len() { left.excess(system) } else { S::zero() };
    let undetermined = orthonormal(null_directions(&pivots, left));
    let reactions = if is_regular {
        let found = substituted(&pivots, system.right.clone());
        undetermined.iter().fold(found, |x, unit| without(x, unit))
    } else {
        least_norm(&pivots, &system.right)
    };
    for (k, &reaction) in reactions.iter().enumerate() {
        trace.number(format!("closure_reaction{k}"), reaction);
    }
    let pivots = pivots.iter().map(|pivot| pivot.measured).collect();
    Closure { reactions, undetermined, pivots, excess }
}

/// What a step found.
struct Pivot<S> {
    /// `e_i`
    choice: Vec<S>,
    /// `l_k`: one in the row of this step, zero in those of earlier steps, and zero where the pivot is
    /// rounding.
    column: Vec<S>,
    /// `d_k`
    value: S,
    /// `d_k / s_i`
    measured: S,
    /// `1 / d_k`, zero where the pivot is rounding.
    inverse: S,
}

/// A row of `J`, twice: the product of two rows is that of the left one's entries with the right one's.
#[derive(Clone)]
struct Row<S> {
    left: Vec<S>,
    /// The same, but for the part of `G` that is between them.
    right: Vec<S>,
}

impl<S: Scalar> Row<S> {
    fn product(&self, other: &Self) -> S {
        dot(&self.left, &other.right)
    }

    fn plus_scaled(self, other: &Self, factor: S) -> Self {
        let left = plus_scaled(self.left, &other.left, factor);
        Row { left, right: plus_scaled(self.right, &other.right, factor) }
    }

    fn vanishes(&self) -> bool {
        self.right.iter().all(|x| x.vanishes())
    }
}

/// What earlier steps have left.
struct Left<S> {
    rows: Vec<Row<S>>,
    /// One for each row that no step has chosen yet.
    open: Vec<S>,
    /// Those that do not vanish in every state; no step chooses another one.
    alive: Vec<usize>,
}

/// Equation (1), step by step.
fn factorised<S: Scalar>(system: &Reactions<S>) -> (Vec<Pivot<S>>, Left<S>) {
    let mut left = Left::of(system);
    let mut pivots = Vec::new();
    let is_regular = system.is_regular(&left);
    for allowed in system.steps(&left) {
        let is_last = pivots.len() + 1 == left.alive.len();
        let choice = match () {
            () if is_regular => left.next(pivots.len()),
            () if is_last => left.last(),
            () => left.largest(&system.sizes),
        };
        pivots.push(left.eliminate(choice, system, allowed));
    }
    (pivots, left)
}

impl<S: Scalar> Left<S> {
    fn of(system: &Reactions<S>) -> Self {
        let count = system.right.len();
        let repeated = |i: usize, j: usize| system.repeated[i.max(j)][i.min(j)];
        let shared: Vec<usize> = (0..count).filter(|&k| !repeated(k, k).vanishes()).collect();
        let roots: Vec<S> = system.dofs.iter().map(|dof| dof.inverse.sqrt()).collect();
        let row = |i: usize| {
            let dofs = system.dofs.iter().zip(&roots);
            let own: Vec<S> = dofs.map(|(dof, &root)| dof.along[i] * root).collect();
            let unit = shared.iter().map(|&k| if k == i { S::one() } else { S::zero() });
            let between = shared.iter().map(|&k| repeated(i, k));
            let left = own.iter().copied().chain(unit).collect();
            Row { left, right: own.iter().copied().chain(between).collect() }
        };
        let rows: Vec<Row<S>> = (0..count).map(row).collect();
        let alive = (0..count).filter(|&k| !rows[k].vanishes()).collect();
        Left { rows, open: vec![S::one(); count], alive }
    }

    /// The row of a step in the order of rows.
    fn next(&self, step: usize) -> Vec<S> {
        let weight = |k| if k == step { S::one() } else { S::zero() };
        self.spread((0..self.alive.len()).map(weight).collect())
    }

    /// The only row that is open.
    fn last(&self) -> Vec<S> {
        self.spread(self.alive.iter().map(|&row| self.open[row]).collect())
    }

    /// The open row of which most is left.
    fn largest(&self, sizes: &[S]) -> Vec<S> {
        self.spread(largest(&self.scores(sizes)).0)
    }

    /// How much is left of that row.
    fn excess(&self, system: &Reactions<S>) -> S {
        largest(&self.scores(&system.sizes)).1
    }

    /// How much is left of each row that may be chosen.
    fn scores(&self, sizes: &[S]) -> Vec<S> {
        let score = |&k: &usize| {
            let (row, open) = (&self.rows[k], self.open[k]);
            // Rows that are not open come behind all others.
            let closed = S::one() - open;
            row.product(row) * sizes[k].recip_above(S::zero()) * open - closed
        };
        self.alive.iter().map(score).collect()
    }

    /// Weights of the rows that may be chosen, as those of all rows.
    fn spread(&self, weights: Vec<S>) -> Vec<S> {
        let mut all = vec![S::zero(); self.open.len()];
        for (&row, weight) in self.alive.iter().zip(weights) {
            all[row] = weight;
        }
        all
    }

    fn eliminate(&mut self, choice: Vec<S>, system: &Reactions<S>, allowed: S) -> Pivot<S> {
        let zero = vec![S::zero(); self.rows[0].left.len()];
        let none = Row { left: zero.clone(), right: zero };
        let weighted = self.rows.iter().zip(&choice);
        let chosen = weighted.fold(none, |sum, (row, &weight)| sum.plus_scaled(row, weight));
        let (value, size) = (chosen.product(&chosen), dot(&choice, &system.sizes));
        let inverse = system.guarded_reciprocal(value, size) * allowed;
        let along = |(row, &open): (&Row<S>, &S)| row.product(&chosen) * inverse * open;
        let column: Vec<S> = self.rows.iter().zip(&self.open).map(along).collect();
        for (row, &amount) in self.rows.iter_mut().zip(&column) {
            *row = row.clone().plus_scaled(&chosen, -amount);
        }
        self.open = plus_scaled(self.open.clone(), &choice, -S::one());
        let measured = value * size.recip_above(S::zero());
        Pivot { choice, column, value, measured, inverse }
    }
}

impl<S: Scalar> Reactions<S> {
    /// Whether no row depends on others but in singular poses: then any order of rows will do.
    fn is_regular(&self, left: &Left<S>) -> bool {
        matches!(self.linkage.rank, Rank::Known(rank) if rank >= left.alive.len())
    }

    /// A weight for each step that may be taken: one, or zero beyond the rank.
    fn steps(&self, left: &Left<S>) -> Vec<S> {
        let most = left.alive.len();
        match &self.linkage.rank {
            Rank::Known(rank) => vec![S::one(); most.min(*rank)],
            Rank::Given(steps) => steps.iter().copied().take(most).collect(),
        }
    }

    /// `1 / d` of a square, or zero where a direction is not determined: by a pivot of less than a unit in
    /// the last place of `s_i`, rounding of `b` would make larger reactions than the loads do.
    fn guarded_reciprocal(&self, square: S, size: S) -> S {
        let is_kept = self.repeated.iter().flatten().all(|x| x.vanishes());
        let units = if is_kept { 1.0 } else { self.linkage.noise };
        square.recip_above(size * S::number(units / NOISE))
    }
}

/// `L⁻ᵀ D⁻¹ L⁻¹ b`, where `L` is square but for the rows of pivots that are rounding.
fn substituted<S: Scalar>(pivots: &[Pivot<S>], mut right: Vec<S>) -> Vec<S> {
    let mut amounts = Vec::new();
    for Pivot { choice, column, inverse, .. } in pivots {
        let amount = dot(choice, &right);
        right = plus_scaled(right, column, -amount);
        amounts.push(amount * *inverse);
    }
    let zero = vec![S::zero(); right.len()];
    pivots.iter().zip(amounts).rev().fold(zero, |x, (pivot, amount)| {
        let step = amount - dot(&pivot.column, &x);
        plus_scaled(x, &pivot.choice, step)
    })
}

/// Equations (2), by Gram and Schmidt, and (3).
fn least_norm<S: Scalar>(pivots: &[Pivot<S>], right: &[S]) -> Vec<S> {
    // Columns of Q, and of S⁻¹.
    let mut across: Vec<(Vec<S>, S)> = Vec::new();
    // Columns of R above its diagonal, which is one.
    let mut upper: Vec<Vec<S>> = Vec::new();
    for pivot in pivots {
        let (mut own, mut along) = (pivot.column.clone(), Vec::new());
        for (other, inverse) in &across {
            let amount = dot(&own, other) * *inverse;
            own = plus_scaled(own, other, -amount);
            along.push(amount);
        }
        let inverse = dot(&own, &own).recip_above(S::one());
        across.push((own, inverse));
        upper.push(along);
    }
    let mut x: Vec<S> = across.iter().map(|(q, inverse)| dot(q, right) * *inverse).collect();
    for k in (0..x.len()).rev() {
        for i in 0..k {
            x[i] = x[i] - upper[k][i] * x[k];
        }
    }
    for (x, pivot) in x.iter_mut().zip(pivots) {
        *x = *x * pivot.inverse;
    }
    for k in 0..x.len() {
        x[k] = x[k] - dot(&upper[k], &x[..k]);
    }
    across.iter().zip(x).fold(vec![S::zero(); right.len()], |sum, ((q, inverse), x)| {
        plus_scaled(sum, q, x * *inverse)
    })
}

/// Equation (4): a direction for each row, zero where the pivot of its step is none of rounding.
fn null_directions<S: Scalar>(pivots: &[Pivot<S>], left: Left<S>) -> Vec<Vec<S>> {
    let mut directions = Vec::new();
    for (k, pivot) in pivots.iter().enumerate() {
        let is_rounding = S::one() - pivot.value * pivot.inverse;
        let start = pivot.choice.iter().map(|&x| x * is_rounding).collect();
        directions.push(null_direction(&pivots[..k], start));
    }
    let mut open: Vec<S> = left.alive.iter().map(|&row| left.open[row]).collect();
    for _ in pivots.len()..open.len() {
        let first = first(&open);
        open = plus_scaled(open, &first, -S::one());
        directions.push(null_direction(pivots, left.spread(first)));
    }
    let count = left.open.len();
    for row in (0..count).filter(|row| !left.alive.contains(row)) {
        let entry = |k| if k == row { S::one() } else { S::zero() };
        directions.push((0..count).map(entry).collect());
    }
    directions
}

/// `start` and what it takes along the rows that steps have chosen for `l_kᵀ x = 0`.
fn null_direction<S: Scalar>(pivots: &[Pivot<S>], start: Vec<S>) -> Vec<S> {
    pivots.iter().rev().fold(start, |x, pivot| {
        let step = -dot(&pivot.column, &x);
        plus_scaled(x, &pivot.choice, step)
    })
}

/// Weights that are one at the largest of the numbers and zero elsewhere, and that number.
fn largest<S: Scalar>(numbers: &[S]) -> (Vec<S>, S) {
    let mut weights = vec![S::one()];
    let mut best = numbers[0];
    for &number in &numbers[1..] {
        let (is_less, is_more) = (number - best).sides();
        for weight in &mut weights {
            *weight = *weight * is_less;
        }
        weights.push(is_more);
        best = best * is_less + number * is_more;
    }
    (weights, best)
}

/// Of weights that are zero or one, the first that is one.
fn first<S: Scalar>(weights: &[S]) -> Vec<S> {
    let mut found = S::zero();
    let one = |&weight: &S| {
        let first = weight * (S::one() - found);
        found = found + first;
        first
    };
    weights.iter().map(one).collect()
}

/// The directions as unit vectors across each other; zero stays zero.
fn orthonormal<S: Scalar>(directions: Vec<Vec<S>>) -> Vec<Vec<S>> {
    let mut units: Vec<Vec<S>> = Vec::new();
    for direction in directions {
        let own = units.iter().fold(direction, |x, unit| without(x, unit));
        let length = dot(&own, &own).recip_above(S::one()).sqrt();
        units.push(own.iter().map(|&x| x * length).collect());
    }
    units
}

/// `x` without its part along a unit vector, or along nothing.
fn without<S: Scalar>(x: Vec<S>, unit: &[S]) -> Vec<S> {
    let along = dot(&x, unit);
    plus_scaled(x, unit, -along)
}

/// `x + y · factor`
fn plus_scaled<S: Scalar>(x: Vec<S>, y: &[S], factor: S) -> Vec<S> {
    x.iter().zip(y).map(|(&x, &y)| x + y * factor).collect()
}

#[cfg(test)]
mod tests;
