//! The reactions of a closing hinge: `Λ λ = b` with `Λ = J M⁻¹ Jᵀ`, which is positive except along
//! the directions that other directions of the hinge determine already, as all those out of the
//! plane of a planar loop and three of the five of Bennett's linkage.
//!
//! Row `i` of `J M^(-1/2)` has an entry `t_i / √D` for each degree of freedom that the Riccati
//! transfer eliminates. Gram and Schmidt's elimination of rows in the order of their norms reveals
//! the rank: it is Cholesky's factorisation of `Λ` with complete pivoting (Higham, *Accuracy and
//! Stability of Numerical Algorithms*, section 10.3) without the squares, whose rounding would hide
//! small singular values. Row `i` is measured by `s_i`, what its square would be if nothing in it
//! cancelled. Step `k`:
//!
//! (1)  `i = argmax |J_i|² / s_i`, `r_k = J_i`, `d_k = |r_k|²`, `l_k = J r_k / d_k`, `J ← J − l_k r_kᵀ`
//! (2)  `Λ = L D Lᵀ`, `L = Q R` with the columns of `Q` across each other, `QᵀQ = Σ`
//! (3)  `λ = Λ⁺ b = Q Σ⁻¹ R⁻ᵀ D⁻¹ R⁻¹ Σ⁻¹ Qᵀ b`
//! (4)  `N = { x : Lᵀ x = 0 }`
//!
//! `λ` has the least norm, in N and N m, of all reactions that fit `b` best; those in `N` make no
//! difference to the motion. Repeated parts have too many degrees of freedom to keep: they add to a
//! part of `Λ` itself, and products of rows have that between them.
//!
//! A row is chosen by arithmetic, with weights that are one at the row and zero elsewhere, so that
//! every state takes the same steps. There are as many steps as the closure has rank anywhere,
//! which is a property of the linkage: off the closure by the error of an integrator's stage the
//! rank is higher, and a linkage that moves by its proportions only would be rigid. Near a
//! bifurcation, as in the straight pose of a parallelogram, a pivot vanishes; the direction then
//! counts as undetermined.

mod factorization;
mod null_space;
#[cfg(test)]
mod tests;

use super::Trace;
use super::hinge::dot;
use crate::math::Scalar;
use factorization::{FactorStep, RemainingRows, factorize};
use null_space::{null_directions, orthonormal};

/// Reactions and what they do not determine.
#[derive(Clone, Debug)]
pub struct ConstraintForces<S> {
    /// `λ` of least norm.
    pub reactions: Vec<S>,
    /// Unit directions, one for each row, along which `λ` makes no difference; zeros where there is
    /// none.
    pub undetermined: Vec<Vec<S>>,
    /// `d_k / s_i` of each step, the largest first.
    pub pivots: Vec<S>,
    /// The largest `|J_i|² / s_i` that the steps which the rank allows have left.
    pub excess: S,
}

impl<S: Scalar> ConstraintForces<S> {
    /// Of a chain that is not closed.
    pub fn none() -> Self {
        let (reactions, undetermined, pivots) = (Vec::new(), Vec::new(), Vec::new());
        ConstraintForces { reactions, undetermined, pivots, excess: S::zero() }
    }
}

/// A linear system for the reactions of a closing hinge.
#[derive(Clone, Debug)]
pub struct ConstraintSystem<S> {
    /// What `Λ` is the sum of, outside of repeated parts.
    pub terms: Vec<DelassusTerm<S>>,
    /// The part of `Λ` that repeated parts add, below its diagonal and on it, by rows.
    pub repeated: Vec<Vec<S>>,
    /// `s`
    pub scales: Vec<S>,
    /// `b`
    pub rhs: Vec<S>,
    /// Rank and rounding of the linkage.
    pub rank: ConstraintRank<S>,
}

/// The part of `Λ` that a degree of freedom adds: `t tᵀ / D`.
#[derive(Clone, Debug)]
pub struct DelassusTerm<S> {
    /// `t`
    pub t: Vec<S>,
    /// `1 / D`
    pub inverse: S,
}

/// Properties of the linkage that the solution for the reactions needs.
#[derive(Clone, Debug)]
pub struct ConstraintRank<S> {
    /// The rank of its closure.
    pub rank: Rank<S>,
    /// How many units in the last place of `s_i` rounding leaves of the square of a row to which
    /// repeated parts have added.
    pub rounding: f64,
}

/// How many directions of a closing hinge are independent anywhere on the closure.
#[derive(Clone, Debug)]
pub enum Rank<S> {
    /// So many.
    Known(usize),
    /// As many as there are ones, before zeros.
    AtRunTime(Vec<S>),
}

/// Solves for the reactions.
pub fn solve<S: Scalar>(system: &ConstraintSystem<S>, trace: &mut Trace<S>) -> ConstraintForces<S> {
    let (pivots, left) = factorize(system);
    for (k, pivot) in pivots.iter().enumerate() {
        trace.number(format!("closure_d{k}"), pivot.pivot);
    }
    let is_regular = system.is_regular(&left);
    let excess = excess(system, &pivots, &left);
    let undetermined = orthonormal(null_directions(&pivots, left));
    // Without redundant directions L is square, and fewer operations do.
    let reactions = if is_regular {
        let found = substituted(&pivots, system.rhs.clone());
        undetermined.iter().fold(found, |x, unit| project_out(x, unit))
    } else {
        least_norm(&pivots, &system.rhs)
    };
    for (k, &reaction) in reactions.iter().enumerate() {
        trace.number(format!("closure_reaction{k}"), reaction);
    }
    let pivots = pivots.iter().map(|pivot| pivot.relative_pivot).collect();
    ConstraintForces { reactions, undetermined, pivots, excess }
}

/// `L⁻ᵀ D⁻¹ L⁻¹ b`, where `L` is square except for the rows of pivots that are rounding.
fn substituted<S: Scalar>(pivots: &[FactorStep<S>], mut right: Vec<S>) -> Vec<S> {
    let mut amounts = Vec::new();
    for FactorStep { selector, column, inverse, .. } in pivots {
        let amount = dot(selector, &right);
        right = plus_scaled(right, column, -amount);
        amounts.push(amount * *inverse);
    }
    let zero = vec![S::zero(); right.len()];
    pivots.iter().zip(amounts).rev().fold(zero, |x, (pivot, amount)| {
        let step = amount - dot(&pivot.column, &x);
        plus_scaled(x, &pivot.selector, step)
    })
}

/// Equations (2), by Gram and Schmidt, and (3).
fn least_norm<S: Scalar>(pivots: &[FactorStep<S>], right: &[S]) -> Vec<S> {
    // Columns of Q, and of Σ⁻¹.
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

/// What the first step beyond the rank finds or would find.
fn excess<S: Scalar>(
    system: &ConstraintSystem<S>,
    pivots: &[FactorStep<S>],
    left: &RemainingRows<S>,
) -> S {
    let steps = system.steps(left);
    let (mut before, mut excess) = (S::one(), S::zero());
    for (pivot, &allowed) in pivots.iter().zip(&steps) {
        excess = excess + pivot.relative_pivot * (before - allowed);
        before = allowed;
    }
    if pivots.len() < left.candidates.len() {
        excess + left.excess(system) * before
    } else {
        excess
    }
}

/// `x` without its part along a unit vector, or along nothing.
fn project_out<S: Scalar>(x: Vec<S>, unit: &[S]) -> Vec<S> {
    let along = dot(&x, unit);
    plus_scaled(x, unit, -along)
}

/// `x + y · factor`
fn plus_scaled<S: Scalar>(x: Vec<S>, y: &[S], factor: S) -> Vec<S> {
    x.iter().zip(y).map(|(&x, &y)| x + y * factor).collect()
}
