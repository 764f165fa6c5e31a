use super::{ConstraintForces, ConstraintRank, ConstraintSystem, DelassusTerm, Rank, Trace, solve};

/// Three forms of the same system: separate terms only, terms of repeated parts only, and both.
const KEPT: [fn(usize) -> bool; 3] = [|_| true, |_| false, |number| number % 2 == 0];

/// Condition numbers are below 1e4 in these tests; a solution needs some hundred operations.
const TOLERANCE: f64 = 1e4 * 100.0 * f64::EPSILON;

fn product<const N: usize>(vectors: &[[f64; N]], x: &[f64]) -> Vec<f64> {
    let along = |v: &[f64; N]| v.iter().zip(x).map(|(v, x)| v * x).sum::<f64>();
    (0..N).map(|i| vectors.iter().map(|v| v[i] * along(v)).sum()).collect()
}

/// Solves `Σ v vᵀ λ = b`.
fn solved<const N: usize>(
    vectors: &[[f64; N]],
    keep: fn(usize) -> bool,
    right: Vec<f64>,
    rank: Rank<f64>,
) -> ConstraintForces<f64> {
    let of = |kept: bool| {
        let some = vectors.iter().enumerate().filter(move |(number, _)| keep(*number) == kept);
        some.map(|(_, v)| v)
    };
    // Different vectors with the same products.
    let dof = |v: &[f64; N]| DelassusTerm { t: v.iter().map(|x| x * 2.0).collect(), inverse: 0.25 };
    let entry = |i: usize, j: usize| of(false).map(|v| v[i] * v[j]).sum();
    let system = ConstraintSystem {
        terms: of(true).map(dof).collect(),
        repeated: (0..N).map(|i| (0..=i).map(|j| entry(i, j)).collect()).collect(),
        scales: (0..N).map(|i| vectors.iter().map(|v| v[i].abs().max(1.0)).sum()).collect(),
        rhs: right,
        rank: ConstraintRank { rank, rounding: 64.0 },
    };
    solve(&system, &mut Trace::new())
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn directions(closure: &ConstraintForces<f64>) -> Vec<&Vec<f64>> {
    closure.undetermined.iter().filter(|u| u.iter().any(|&x| x != 0.0)).collect()
}

#[test]
fn a_regular_system_has_no_undetermined_directions() {
    let vectors =
        [[1.0, 2.0, 0.0, -1.0], [0.0, 1.0, 3.0, 0.5], [2.0, 0.0, 1.0, 0.0], [0.0, 0.1, 0.2, 0.3]];
    let x = [0.3, -1.0, 2.0, 0.7];
    for keep in KEPT {
        let closure = solved(&vectors, keep, product(&vectors, &x), Rank::Known(4));
        let off = largest_difference(&closure.reactions, &x);
        assert!(off < TOLERANCE, "{off:e}");
        assert!(directions(&closure).is_empty());
    }
}

/// Rank two: the third and fourth rows are combinations of the first two.
const TWO: [[f64; 4]; 2] = [[1.0, 2.0, 3.0, -1.0], [0.0, 1.0, 1.0, 2.0]];

/// Returns a combination of the vectors, which has no component along the null directions.
fn combination(vectors: &[[f64; 4]; 2]) -> Vec<f64> {
    (0..4).map(|k| 0.7 * vectors[0][k] - 1.3 * vectors[1][k]).collect()
}

/// A row that depends on others in one pose only, such as the straight pose of a parallelogram.
#[test]
fn a_regular_system_may_be_singular() {
    let x = combination(&TWO);
    for keep in KEPT {
        let closure = solved(&TWO, keep, product(&TWO, &x), Rank::Known(4));
        let off = largest_difference(&closure.reactions, &x);
        assert!(off < TOLERANCE, "{off:e}");
        assert_eq!(directions(&closure).len(), 2);
    }
}

#[test]
fn the_least_norm_solution_is_found_with_and_without_a_given_rank() {
    let x = combination(&TWO);
    let ranks =
        [Rank::Known(2), Rank::AtRunTime(vec![1.0, 1.0, 0.0, 0.0]), Rank::AtRunTime(vec![1.0; 4])];
    for (keep, rank) in KEPT.into_iter().flat_map(|keep| ranks.clone().map(|rank| (keep, rank))) {
        let closure = solved(&TWO, keep, product(&TWO, &x), rank.clone());
        let off = largest_difference(&closure.reactions, &x);
        assert!(off < TOLERANCE, "{rank:?}: {off:e}");
        let found = directions(&closure);
        assert_eq!(found.len(), 2, "{rank:?}");
        for direction in found {
            let length: f64 = direction.iter().map(|x| x * x).sum();
            assert!((length - 1.0).abs() < 1e-14);
            assert!(product(&TWO, direction).iter().all(|x| x.abs() < 1e-13));
        }
    }
}

/// One row nearly vanishes, down to the rounding error and below. If it were selected first, the
/// rounding errors of the other rows would look larger than they are.
#[test]
fn a_row_that_nearly_vanishes_does_no_harm() {
    for (keep, exponent) in KEPT.into_iter().flat_map(|keep| (0..20).map(move |e| (keep, e))) {
        let size = 10.0_f64.powi(-exponent);
        let vectors = TWO.map(|v| [v[0] * size, v[1], v[2], v[3]]);
        let x = combination(&vectors);
        let closure = solved(&vectors, keep, product(&vectors, &x), Rank::Known(2));
        let off = largest_difference(&closure.reactions, &x);
        assert!(off < TOLERANCE, "{size:e}: {off:e}");
        assert_eq!(directions(&closure).len(), 2, "{size:e}");
    }
}

/// Two nearly dependent rows. Separate terms resolve singular values down to 1e-7 of the largest;
/// the squares of the rows would not.
#[test]
fn small_singular_values_are_resolved() {
    for exponent in 0..8 {
        let part = 10.0_f64.powi(-exponent);
        let vectors = [[1.0, 1.0, 0.5], [part, -part, 0.25 * part]];
        let x: Vec<f64> = (0..3).map(|k| vectors[0][k] - 1.5 * vectors[1][k] / part).collect();
        let closure = solved(&vectors, KEPT[0], product(&vectors, &x), Rank::Known(2));
        let off = largest_difference(&closure.reactions, &x);
        // The component of the right side along the second vector is smaller by the square of
        // `part`.
        assert!(off < 100.0 * f64::EPSILON / (part * part), "{part:e}: {off:e}");
        assert_eq!(directions(&closure).len(), 1, "{part:e}");
    }
}

/// A right side that no constraint forces fit. The best fit ignores the inconsistent component.
#[test]
fn the_inconsistent_part_of_the_right_side_has_no_effect() {
    let x = combination(&TWO);
    // Orthogonal to both vectors.
    let across = [-1.0, -1.0, 1.0, 0.0];
    assert!(product(&TWO, &across).iter().all(|&x| x == 0.0));
    for keep in KEPT {
        let right = product(&TWO, &x).iter().zip(across).map(|(b, n)| b + 0.25 * n).collect();
        let closure = solved(&TWO, keep, right, Rank::Known(2));
        let off = largest_difference(&closure.reactions, &x);
        assert!(off < TOLERANCE, "{off:e}");
    }
}
