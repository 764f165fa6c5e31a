//! The limits of the paper's printed equations, in numbers: the product of matrices loses accuracy with the length of the
//! chain, which the compiler's two methods do not; neighbouring pins at right angles are singular; and the overall equation
//! of the examples does not determine all unknowns.

mod common;

use common::Point;
use common::double_double::DoubleDouble;
use common::paper::{Case, Hinges, Moving, reported};
use mstmm_codegen::math::{Scalar, Structured};
use mstmm_codegen::model::SolutionMethod;
use mstmm_runtime::Scalar as Number;
use mstmm_runtime::nalgebra::{DMatrix, SMatrix, Vector3};
use mstmm_runtime::paper::chain::{self, InputEnd, OutputEnd};

const SEEDS: u64 = 3;

/// Returns r̈ and Ω̇ at all connection points.
fn accelerations<S: Scalar>(points: &[Point<Structured<S>>], number: fn(S) -> f64) -> Vec<f64> {
    let of = |point: &Point<Structured<S>>| {
        [point.acceleration.linear.0, point.acceleration.angular.0].concat()
    };
    points.iter().flat_map(of).map(|x| number(x.value())).collect()
}

/// Returns the error of a list, relative to its largest entry; infinite if an entry is not finite.
fn error(found: &[f64], truth: &[f64]) -> f64 {
    let error = common::difference(found, truth);
    if error.is_nan() { f64::INFINITY } else { error }
}

/// Returns the error of the compiler's equations in a precision.
fn compiled<S: Scalar>(
    case: &Case,
    (seed, method): (u64, SolutionMethod),
    truth: &[f64],
    number: fn(S) -> f64,
) -> f64 {
    let points = case.at_random::<S>(seed, method).computed.report.points;
    error(&accelerations(&points, number), truth)
}

/// Returns the error of the paper's product for N elements in a precision.
fn product<T: Number + Into<f64>, const N: usize, const K: usize>(
    case: &Case,
    moving: &Moving<f64>,
    input: &InputEnd<T, 13, K>,
    truth: &[f64],
) -> f64 {
    let elements: [_; N] = case.elements(moving).try_into().expect("N elements");
    let states = chain::solve(&elements, input, &OutputEnd::free());
    let all = [states.input].into_iter().chain(states.outputs);
    let found: Vec<f64> =
        all.flat_map(|z| <[T; 13]>::from(z).into_iter().take(6)).map(Into::into).collect();
    error(&found, truth)
}

/// The largest errors over some states of a chain.
#[derive(Clone, Copy, Debug, Default)]
struct Errors {
    /// The paper's product, `f64` and `f32`.
    product: [f64; 2],
    /// The larger error of `riccati` and `transfer`, `f64` and `f32`.
    compiled: [f64; 2],
}

fn larger(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].max(b[0]), a[1].max(b[1])]
}

fn errors<const N: usize>(hinges: impl Fn(usize) -> Hinges) -> Errors {
    let case = Case::of_cubes(hinges(N / 2), N / 2);
    let mut worst = Errors::default();
    for seed in 0..SEEDS {
        let truth = case.at_random::<DoubleDouble>(seed, SolutionMethod::Riccati);
        let truth = accelerations(&truth.computed.report.points, |x| x.high);
        let moving = case.at_random::<f64>(seed, SolutionMethod::Riccati);
        let of_product = if let Hinges::Pins(_) = case.hinges {
            let double = InputEnd::pin(&case.pin(0, &moving).orientation);
            let single = InputEnd::pin(&case.pin(0, &moving).orientation);
            [
                product::<f64, N, 5>(&case, &moving, &double, &truth),
                product::<f32, N, 5>(&case, &moving, &single, &truth),
            ]
        } else {
            [
                product::<f64, N, 3>(&case, &moving, &InputEnd::ball(), &truth),
                product::<f32, N, 3>(&case, &moving, &InputEnd::ball(), &truth),
            ]
        };
        worst.product = larger(worst.product, of_product);
        for method in [SolutionMethod::Riccati, SolutionMethod::Transfer] {
            let double = compiled::<f64>(&case, (seed, method), &truth, |x| x);
            let single = compiled::<f32>(&case, (seed, method), &truth, f64::from);
            worst.compiled = larger(worst.compiled, [double, single]);
        }
    }
    worst
}

/// Returns the errors for 1 to 60 bodies.
fn by_length(hinges: impl Fn(usize) -> Hinges + Copy) -> [(usize, Errors); 9] {
    [
        (1, errors::<2>(hinges)),
        (2, errors::<4>(hinges)),
        (3, errors::<6>(hinges)),
        (5, errors::<10>(hinges)),
        (10, errors::<20>(hinges)),
        (15, errors::<30>(hinges)),
        (20, errors::<40>(hinges)),
        (30, errors::<60>(hinges)),
        (60, errors::<120>(hinges)),
    ]
}

/// Checks that the product starts as accurate as the methods and ends without a correct digit; the methods do not change.
fn check_growth(name: &str, hinges: impl Fn(usize) -> Hinges + Copy) {
    let all = by_length(hinges);
    for (count, Errors { product, compiled }) in &all {
        println!(
            "{name} {count:>2}: product {:.1e} {:.1e}, compiled {:.1e} {:.1e}",
            product[0], product[1], compiled[0], compiled[1]
        );
    }
    for (count, Errors { product, compiled }) in all {
        assert!(compiled[0] < 1e-12 && compiled[1] < 1e-4, "{name} {count}: {compiled:?}");
        if count == 1 {
            assert!(product[0] < 1e-13 && product[1] < 1e-4, "{name}: {product:?}");
        }
        if count == 10 {
            assert!(product[0] > 1e2 * compiled[0], "{name}: {product:?}, {compiled:?}");
        }
        if count >= 30 {
            let worse = product.iter().zip(&compiled).all(|(product, own)| *product > 1e3 * own);
            assert!(worse, "{name} {count}: {product:?}");
        }
        if count == 60 {
            assert!(product[0] > 1e-2 && product[1] > 1e-2, "{name}: {product:?}");
        }
    }
}

#[test]
fn the_product_of_balls_loses_all_digits() {
    check_growth("balls", |_| Hinges::Balls);
}

#[test]
fn the_product_of_pins_in_a_plane_loses_all_digits() {
    check_growth("parallel pins", |count| Hinges::Pins(vec![Vector3::z(); count]));
}

#[test]
fn the_product_of_oblique_pins_loses_all_digits() {
    let axes = [[1.0, 2.0, 3.0], [1.0, 1.0, 2.0], [0.0, 1.0, 3.0]];
    check_growth("oblique pins", |count| {
        let axis = |k: usize| Vector3::from(axes[k % 3]).normalize();
        Hinges::Pins((0..count).map(axis).collect())
    });
}

/// Returns (41) for two cubes whose pins include a right angle minus the angle `missing`.
fn neighbours(missing: f64) -> (f64, f64) {
    let second = Vector3::new(0.0, missing.cos(), missing.sin());
    let case = Case::of_cubes(Hinges::Pins(vec![Vector3::z(), second]), 2);
    let moving = case.at::<f64>(SolutionMethod::Riccati, &[0.3, 0.4], &[1.0, -0.5]);
    let elements: [_; 4] = case.elements(&moving).try_into().expect("four elements");
    let determinant = case.pin_blocks(0, &moving, &elements[1]).determinant();
    let input = InputEnd::pin(&case.pin(0, &moving).orientation);
    let states = chain::solve(&elements, &input, &OutputEnd::free());
    let points: Vec<_> = moving.computed.report.points.iter().map(reported).collect();
    let truth: Vec<f64> = points.iter().flat_map(|z| z.as_slice().to_vec()).collect();
    let all = [states.input].into_iter().chain(states.outputs);
    let found: Vec<f64> = all.flat_map(|z| z.as_slice().to_vec()).collect();
    (determinant, error(&found, &truth))
}

/// det E₀ = −ζ₊ · u₃₂ ζ decreases with the angle that is missing to 90°, and so does the number of correct digits of all
/// results. At 90° it is a rounding error, while the compiled chain has no singularity (compared with the reference in its
/// tests).
#[test]
fn pins_at_right_angles_are_singular() {
    let mut last = 0.0;
    for missing in [1.0, 1e-2, 1e-4, 1e-6, 1e-8, 0.0] {
        let (determinant, error) = neighbours(missing);
        println!("{missing:e} rad short of 90°: det E0 {determinant:.1e}, error {error:.1e}");
        // u₃₂ = J_I + m r̃_IO r̃_IC has the diagonal 1/6, −1/12, −1/12 here.
        let expected = missing.sin() / 12.0;
        assert!((determinant - expected).abs() < 1e-15, "{determinant:e} {expected:e}");
        if missing > 0.0 {
            assert!(error < 1e-13 / missing && error > last / 10.0, "{missing:e}: {error:e}");
        } else {
            assert!(error > 1e-3, "{error:e}");
        }
        last = error;
    }
}

/// Returns the rank of the boundary equations, with all singular values.
fn rank<const M: usize, const K: usize>(matrix: &SMatrix<f64, M, K>) -> (usize, String) {
    let matrix = DMatrix::from_column_slice(M, K, matrix.as_slice());
    let mut values: Vec<f64> = matrix.singular_values().iter().copied().collect();
    values.sort_by(|a, b| b.total_cmp(a));
    // Ten decades lie between the singular values and the rounding errors.
    let rank = values.iter().filter(|&&value| value > 1e-10 * values[0]).count();
    let shown: Vec<String> = values.iter().map(|value| format!("{value:.1e}")).collect();
    (rank, shown.join(" "))
}

/// Returns the ranks of the boundary equations of three cubes: (45) as printed, and with the factor U₁.
fn ranks<const K: usize>(
    case: &Case,
    moving: &Moving<f64>,
    printed: &InputEnd<f64, 13, 6>,
    from_ground: &InputEnd<f64, 13, K>,
) -> (usize, usize) {
    let elements = case.elements::<f64>(moving);
    let of_printed = chain::boundary(&chain::overall(&elements[1..]), printed, &OutputEnd::free());
    let whole = chain::boundary(&chain::overall(&elements), from_ground, &OutputEnd::free());
    let (printed, values) = rank(&of_printed.0);
    let (whole, values_of_whole) = rank(&whole.0);
    println!("(45): rank {printed} of 6, {values}; from U1 on: {whole} of {K}, {values_of_whole}");
    (printed, whole)
}

#[test]
fn equation_45_is_rank_deficient() {
    let (balls, pins) =
        (Case::of_cubes(Hinges::Balls, 3), Case::of_cubes(Hinges::Pins(vec![Vector3::z(); 3]), 3));
    for seed in 0..SEEDS {
        let moving = balls.at_random(seed, SolutionMethod::Riccati);
        let found = ranks(&balls, &moving, &InputEnd::outboard_of_ball(), &InputEnd::ball());
        assert_eq!(found, (3, 3));

        let moving = pins.at_random(seed, SolutionMethod::Riccati);
        let ground = InputEnd::pin(&pins.pin(0, &moving).orientation);
        assert_eq!(ranks(&pins, &moving, &InputEnd::outboard_of_pin(), &ground), (5, 5));
    }
}
