//! The constraint forces `λ` of a loop hinge: `Λ λ = b` with the Delassus matrix `Λ = J M⁻¹ Jᵀ`.
//! `Λ` is positive except along constraints that depend on others, such as all constraints out of
//! the plane of a planar loop, and three of the five of Bennett's linkage.
//!
//! Row `i` of `J M^(-1/2)` has an entry `t_i / √D` for each degree of freedom that the Riccati
//! transfer eliminates. Gram-Schmidt elimination of the rows in the order of their norms reveals
//! the rank. This is the Cholesky factorisation of `Λ` with complete pivoting (Higham, *Accuracy
//! and Stability of Numerical Algorithms*, section 10.3) without the squares, whose rounding would
//! hide small singular values. The scale `s_i` of row `i` is its square if nothing cancelled in it.
//! Step `k`:
//!
//! (1)  `i = argmax |J_i|² / s_i`, `r_k = J_i`, `d_k = |r_k|²`, `l_k = J r_k / d_k`, `J ← J − l_k r_kᵀ`
//! (2)  `Λ = L D Lᵀ`, `L = Q R` with orthogonal columns of `Q`, `QᵀQ = Σ`
//! (3)  `λ = Λ⁺ b = Q Σ⁻¹ R⁻ᵀ D⁻¹ R⁻¹ Σ⁻¹ Qᵀ b`
//! (4)  `N = { x : Lᵀ x = 0 }`
//!
//! `λ` has the least norm, in N and N m, of all constraint forces that fit `b` best; those in `N`
//! do not change the motion. Repeated parts have too many degrees of freedom to store. They are
//! summed into a part of `Λ`, which then appears in the products of rows.
//!
//! A row is selected by arithmetic, with weights that are one for the row and zero for the others,
//! so that every state takes the same steps. The number of steps is the largest rank on the closed
//! configurations, a property of the linkage. In the state of an integrator's stage, which violates
//! the constraints slightly, the rank is higher, and a linkage that moves only because of its
//! proportions would be rigid. Near a bifurcation, such as the straight pose of a parallelogram, a
//! pivot vanishes, and the direction is then undetermined.

mod factorization;
mod null_space;
#[cfg(test)]
mod tests;

use super::Trace;
use super::hinge::dot;
use crate::math::Scalar;
use factorization::{FactorStep, RemainingRows, factorize};
use null_space::{null_directions, orthonormal};

/// Constraint forces, and the directions in which they are undetermined.
#[derive(Clone, Debug)]
pub struct ConstraintForces<S> {
    /// `λ` of least norm, in N and N m.
    pub reactions: Vec<S>,
    /// Unit directions along which `λ` does not change the motion, one for each row; zero if the
    /// row determines its direction.
    pub undetermined: Vec<Vec<S>>,
    /// `d_k / s_i` of each step, the largest first.
    pub pivots: Vec<S>,
    /// The largest `|J_i|² / s_i` left after the steps that the rank allows.
    pub excess: S,
}

impl<S: Scalar> ConstraintForces<S> {
    /// No constraint forces, for a chain that is not closed.
    pub fn none() -> Self {
        let (reactions, undetermined, pivots) = (Vec::new(), Vec::new(), Vec::new());
        ConstraintForces { reactions, undetermined, pivots, excess: S::zero() }
    }
}

/// A linear system for the constraint forces of a loop hinge.
#[derive(Clone, Debug)]
pub struct ConstraintSystem<S> {
    /// The terms of `Λ` outside of repeated parts.
    pub terms: Vec<DelassusTerm<S>>,
    /// The part of `Λ` from repeated parts: its lower triangle with the diagonal, by rows.
    pub repeated: Vec<Vec<S>>,
    /// The scales `s`.
    pub scales: Vec<S>,
    /// The right-hand side `b`.
    pub rhs: Vec<S>,
    /// Rank and rounding of the rows.
    pub rank: ConstraintRank<S>,
}

/// The contribution `t tᵀ / D` of a degree of freedom to `Λ`.
#[derive(Clone, Debug)]
pub struct DelassusTerm<S> {
    /// `t`
    pub t: Vec<S>,
    /// `1 / D`
    pub inverse: S,
}

/// The rank of the constraints, and the rounding of their rows.
#[derive(Clone, Debug)]
pub struct ConstraintRank<S> {
    /// The number of independent constraints.
    pub rank: Rank<S>,
    /// The rounding error of the square of a row that repeated parts contribute to, in units in the
    /// last place of `s_i`.
    pub rounding: f64,
}

/// The largest number of independent constraints over all closed configurations.
#[derive(Clone, Debug)]
pub enum Rank<S> {
    /// Known while compiling.
    Known(usize),
    /// Given at run time: that many ones, then zeros.
    AtRunTime(Vec<S>),
}

/// Solves for the constraint forces.
pub fn solve<S: Scalar>(system: &ConstraintSystem<S>, trace: &mut Trace<S>) -> ConstraintForces<S> {
    let (pivots, left) = factorize(system);
    for (k, pivot) in pivots.iter().enumerate() {
        trace.number(format!("closure_d{k}"), pivot.pivot);
    }
    let is_regular = system.is_regular(&left);
    let excess = excess(system, &pivots, &left);
    let undetermined = orthonormal(null_directions(&pivots, left));
    // Without dependent constraints `L` is square, and substitution needs fewer operations.
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

/// Returns `L⁻ᵀ D⁻¹ L⁻¹ b`. `L` is square except for rows whose pivots are rounding errors.
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

/// Returns the solution of least norm: equations (2), by Gram-Schmidt, and (3).
fn least_norm<S: Scalar>(pivots: &[FactorStep<S>], right: &[S]) -> Vec<S> {
    // Columns of `Q`, with the entries of `Σ⁻¹`.
    let mut across: Vec<(Vec<S>, S)> = Vec::new();
    // Columns of `R` above its unit diagonal.
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

/// Returns the relative pivot of the first step beyond the rank.
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

/// Returns `x` without its component along a unit vector, or `x` itself if the vector is zero.
fn project_out<S: Scalar>(x: Vec<S>, unit: &[S]) -> Vec<S> {
    let along = dot(&x, unit);
    plus_scaled(x, unit, -along)
}

/// Returns `x + y · factor`.
fn plus_scaled<S: Scalar>(x: Vec<S>, y: &[S], factor: S) -> Vec<S> {
    x.iter().zip(y).map(|(&x, &y)| x + y * factor).collect()
}
