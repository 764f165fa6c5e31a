//! The reactions of a closing hinge: `G λ = b` with a symmetric `G` that is positive but for
//! directions that are held already, as all those out of the plane of a planar loop are.
//!
//! `G = L D Lᵀ` row by row. What is left of a row that hangs on those before it is rounding: its
//! reaction is set to zero and its direction noted. A pivot is rounding if it is so beside the row's own
//! diagonal entry, or if its root is so beside the root of what that entry would be if nothing in it
//! cancelled: in a straight pose whole rows vanish but for the rounding of their lever arms. The solution is then freed of all that such directions can add: what is left is the
//! reaction of least norm, in N and N m.

use super::Trace;
use super::hinge::dot;
use crate::math::Scalar;

/// Reactions and what they do not determine.
#[derive(Clone, Debug)]
pub struct Closure<S> {
    /// `λ` of least norm.
    pub reactions: Vec<S>,
    /// Unit directions, one for each row, along which `λ` makes no difference; zeros where there is
    /// none.
    pub undetermined: Vec<Vec<S>>,
}

/// Solves `G λ = b`; of the symmetric `G` the lower rows are enough. `sizes` are what its diagonal
/// would be if nothing in it cancelled.
pub fn solve<S: Scalar>(
    matrix: &[Vec<S>],
    sizes: &[S],
    right: &[S],
    trace: &mut Trace<S>,
) -> Closure<S> {
    let count = right.len();
    let Factors { lower, inverses, pivots } = factorised(matrix, sizes);
    let forward = forward_substituted(&lower, right);
    let scaled: Vec<S> = forward.iter().zip(&inverses).map(|(&y, &d)| y * d).collect();
    let mut reactions = back_substituted(&lower, scaled);
    for (k, pivot) in pivots.iter().enumerate() {
        trace.number(format!("closure_d{k}"), *pivot);
    }
    let mut undetermined: Vec<Vec<S>> = Vec::new();
    for row in 0..count {
        let direction = free_direction(&lower, row, S::one() - pivots[row] * inverses[row]);
        let own = undetermined.iter().fold(direction, |x, unit| without(x, unit));
        let length = dot(&own, &own).recip_above(S::one()).sqrt();
        let unit: Vec<S> = own.iter().map(|&x| x * length).collect();
        reactions = without(reactions, &unit);
        undetermined.push(unit);
    }
    for (k, &reaction) in reactions.iter().enumerate() {
        trace.number(format!("closure_reaction{k}"), reaction);
    }
    Closure { reactions, undetermined }
}

struct Factors<S> {
    /// Below the diagonal, by rows; zero in the columns of rows that hang on others.
    lower: Vec<Vec<S>>,
    /// Reciprocal pivots; zero where the row hangs on others.
    inverses: Vec<S>,
    pivots: Vec<S>,
}

fn factorised<S: Scalar>(matrix: &[Vec<S>], sizes: &[S]) -> Factors<S> {
    let count = matrix.len();
    let mut rest: Vec<Vec<S>> = matrix
        .iter()
        .map(|row| (0..count).map(|k| row.get(k).copied().unwrap_or(S::zero())).collect())
        .collect();
    let mut lower = vec![vec![S::zero(); count]; count];
    let (mut inverses, mut pivots) = (Vec::new(), Vec::new());
    for k in 0..count {
        let pivot = rest[k][k];
        let inverse = guarded_reciprocal(pivot, matrix[k][k], sizes[k]);
        let column: Vec<S> = rest.iter().map(|row| row[k]).collect();
        for i in k + 1..count {
            lower[i][k] = column[i] * inverse;
            let pairs = rest[i].iter_mut().zip(&column).take(i + 1).skip(k + 1);
            for (entry, &other) in pairs {
                *entry = *entry - lower[i][k] * other;
            }
        }
        inverses.push(inverse);
        pivots.push(pivot);
    }
    Factors { lower, inverses, pivots }
}

/// The reciprocal of a pivot, or zero where that is rounding.
fn guarded_reciprocal<S: Scalar>(pivot: S, diagonal: S, size: S) -> S {
    let root = pivot.positive_part().sqrt();
    let counts = root * root.recip_above(size.sqrt());
    pivot.recip_above(diagonal) * counts
}

/// `L⁻¹ x`
fn forward_substituted<S: Scalar>(lower: &[Vec<S>], x: &[S]) -> Vec<S> {
    let mut y: Vec<S> = Vec::new();
    for (row, &x) in lower.iter().zip(x) {
        y.push(x - dot(row, &y));
    }
    y
}

/// `L⁻ᵀ x`
fn back_substituted<S: Scalar>(lower: &[Vec<S>], mut x: Vec<S>) -> Vec<S> {
    for k in (0..x.len()).rev() {
        for i in k + 1..x.len() {
            x[k] = x[k] - lower[i][k] * x[i];
        }
    }
    x
}

/// `G`'s null direction that belongs to a row, times `amount`.
fn free_direction<S: Scalar>(lower: &[Vec<S>], row: usize, amount: S) -> Vec<S> {
    let unit = (0..lower.len()).map(|k| if k == row { amount } else { S::zero() }).collect();
    back_substituted(lower, unit)
}

/// `x` without its part along a unit vector, or along nothing.
fn without<S: Scalar>(x: Vec<S>, unit: &[S]) -> Vec<S> {
    let along = dot(&x, unit);
    x.iter().zip(unit).map(|(&x, &u)| x - u * along).collect()
}

#[cfg(test)]
mod tests {
    use super::{Trace, solve};

    fn product(matrix: &[Vec<f64>], x: &[f64]) -> Vec<f64> {
        matrix.iter().map(|row| row.iter().zip(x).map(|(a, b)| a * b).sum()).collect()
    }

    fn diagonal(matrix: &[Vec<f64>]) -> Vec<f64> {
        (0..4).map(|k| matrix[k][k]).collect()
    }

    /// `Σ v vᵀ`
    fn gram(vectors: &[[f64; 4]]) -> Vec<Vec<f64>> {
        let entry = |i: usize, j: usize| vectors.iter().map(|v| v[i] * v[j]).sum();
        (0..4).map(|i| (0..4).map(|j| entry(i, j)).collect()).collect()
    }

    #[test]
    fn a_regular_system_is_solved_and_nothing_is_undetermined() {
        let matrix = gram(&[
            [1.0, 2.0, 0.0, -1.0],
            [0.0, 1.0, 3.0, 0.5],
            [2.0, 0.0, 1.0, 0.0],
            [0.0, 0.1, 0.2, 0.3],
        ]);
        let x = [0.3, -1.0, 2.0, 0.7];
        let closure = solve(&matrix, &diagonal(&matrix), &product(&matrix, &x), &mut Trace::new());
        for (found, expected) in closure.reactions.iter().zip(x) {
            // The condition number of the matrix is below 1e4.
            assert!((found - expected).abs() < 1e4 * 16.0 * f64::EPSILON, "{found} {expected}");
        }
        assert!(closure.undetermined.iter().flatten().all(|&x| x == 0.0));
    }

    #[test]
    fn of_all_solutions_the_shortest_is_found() {
        // Rank two: the third and fourth rows hang on the first two.
        let vectors = [[1.0, 2.0, 3.0, -1.0], [0.0, 1.0, 1.0, 2.0]];
        let matrix = gram(&vectors);
        // A combination of the vectors has no part along the null directions.
        let x: Vec<f64> = (0..4).map(|k| 0.7 * vectors[0][k] - 1.3 * vectors[1][k]).collect();
        let closure = solve(&matrix, &diagonal(&matrix), &product(&matrix, &x), &mut Trace::new());
        for (found, expected) in closure.reactions.iter().zip(&x) {
            assert!((found - expected).abs() < 1e3 * 16.0 * f64::EPSILON, "{found} {expected}");
        }
        let directions: Vec<_> =
            closure.undetermined.iter().filter(|u| u.iter().any(|&x| x != 0.0)).collect();
        assert_eq!(directions.len(), 2);
        for direction in directions {
            let length: f64 = direction.iter().map(|x| x * x).sum();
            assert!((length - 1.0).abs() < 1e-14);
            assert!(product(&matrix, direction).iter().all(|x| x.abs() < 1e-13));
        }
    }
}
