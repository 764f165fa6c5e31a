//! Linear systems.

use super::{Random, converted};
use mstmm_runtime::Error;
use mstmm_runtime::description::Origin;
use mstmm_runtime::linear::{solve, solve_positive_definite};
use mstmm_runtime::nalgebra::{Matrix2, Matrix3, SMatrix, Vector2};

/// The largest residual of A X = B relative to N · |A| |X|, the sum of its terms, in units of ε.
fn residual<const N: usize, const M: usize>(
    a: &SMatrix<f64, N, N>,
    x: &SMatrix<f64, N, M>,
    b: &SMatrix<f64, N, M>,
) -> f64 {
    let terms = a.abs() * x.abs() * (N as f64 * f64::EPSILON);
    (a * x - b).abs().zip_map(&terms, |off, size| off / size).max()
}

fn check<const N: usize>() {
    for seed in 0..50 {
        let mut random = Random::new(seed);
        let (a, b) = (random.matrix::<N, N>(), random.matrix::<N, 3>());
        // Rows of very different sizes, in any order.
        let mut scaled = (a, b);
        for row in 0..N {
            let size = 10f64.powi((40.0 * random.next()) as i32);
            scaled.0.row_mut(row).scale_mut(size);
            scaled.1.row_mut(row).scale_mut(size);
        }
        for (a, b) in [(a, b), scaled] {
            let x = solve(&a, &b).expect("a regular matrix");
            // Growth of the pivots costs a few digits at most.
            let off = residual(&a, &x, &b);
            assert!(off < 20.0, "seed {seed}, {N}: {off}");
        }
        let definite = a * a.transpose() + SMatrix::identity() * 0.01;
        let x = solve_positive_definite(&definite, &b).expect("positive definite");
        let off = residual(&definite, &x, &b);
        assert!(off < 20.0, "seed {seed}, {N}: {off}");
    }
}

#[test]
fn solutions_have_residuals_of_rounding() {
    check::<1>();
    check::<2>();
    check::<3>();
    check::<6>();
    check::<14>();
}

#[test]
fn zero_pivots_are_exchanged() -> Result<(), Error> {
    // Each column has one entry, not on the diagonal.
    let a = Matrix3::new(0.0, 0.0, 2.0, 4.0, 0.0, 0.0, 0.0, 8.0, 0.0);
    let inverse = Matrix3::new(0.0, 0.25, 0.0, 0.0, 0.0, 0.125, 0.5, 0.0, 0.0);
    assert_eq!(solve(&a, &Matrix3::identity())?, inverse);
    Ok(())
}

#[test]
fn singular_matrices_are_refused() {
    let singular = Err(Error::SingularMatrix);
    let rank_two = Matrix3::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0);
    assert_eq!(solve(&rank_two, &Matrix3::identity()), singular);
    assert_eq!(solve(&Matrix3::<f64>::zeros(), &Matrix3::identity()), singular);
    assert_eq!(solve(&Matrix3::repeat(f64::NAN), &Matrix3::identity()), singular);
    assert_eq!(solve(&Matrix3::repeat(f64::INFINITY), &Matrix3::identity()), singular);
    let singular = Err(Error::SingularMatrix);
    for indefinite in [
        Matrix2::new(1.0, 2.0, 2.0, 1.0),
        Matrix2::new(-1.0, 0.0, 0.0, -1.0),
        Matrix2::new(0.0, 1.0, 1.0, 0.0),
        Matrix2::new(1.0, 1.0, 1.0, 1.0),
        Matrix2::repeat(f64::NAN),
    ] {
        assert_eq!(solve_positive_definite(&indefinite, &Matrix2::identity()), singular);
    }
    // Regular, but its small entries are all its digits in single precision.
    let near = Matrix2::new(1.0, 1.0, 1.0, 1.0 + 1e-9);
    assert!(solve(&near, &Matrix2::identity()).is_ok());
    assert_eq!(
        solve::<f32, 2, 2>(&converted(&near), &Matrix2::identity()),
        Err(Error::SingularMatrix)
    );
}

/// Lanes exchange different rows; each has the bits that it has alone.
#[cfg(feature = "wide")]
#[test]
fn lanes_have_their_own_pivots() -> Result<(), Error> {
    use mstmm_runtime::wide::f64x4;
    for seed in 0..20 {
        let mut random = Random::new(seed);
        let [a, b] = [(); 2].map(|()| [(); 4].map(|()| random.matrix::<5, 5>()));
        let lanes = |of: [SMatrix<f64, 5, 5>; 4]| {
            SMatrix::<f64x4, 5, 5>::from_fn(|row, column| f64x4::new(of.map(|m| m[(row, column)])))
        };
        let x = solve(&lanes(a), &lanes(b))?;
        for lane in 0..4 {
            assert_eq!(x.map(|x| x.to_array()[lane]), solve(&a[lane], &b[lane])?, "seed {seed}");
        }
        // One singular lane makes all fail.
        let mut singular = a;
        singular[2].set_column(1, &a[2].column(3));
        assert_eq!(solve(&lanes(singular), &lanes(b)), Err(Error::SingularMatrix));
    }
    Ok(())
}

#[test]
fn results_that_are_not_finite_are_errors() {
    let (a, b) = (Matrix2::new(2.0, 0.0, 0.0, 3.0), Vector2::new(1.0, 1.0));
    let both = |a: Matrix2<f64>, b: Vector2<f64>| [solve(&a, &b), solve_positive_definite(&a, &b)];
    for bad in [f64::NAN, f64::INFINITY] {
        let argument = Error::NotFinite(Origin::Argument { name: "b", index: 1 });
        assert_eq!(both(a, Vector2::new(1.0, bad)), [Err(argument); 2]);
    }
    let of_a = Matrix2::new(2.0, f64::NAN, f64::NAN, 3.0);
    assert!(both(of_a, b).iter().all(Result::is_err));
    let overflows = Error::NotFinite(Origin::Result);
    assert_eq!(both(a * 1e-10, b * 1e308), [Err(overflows); 2]);
}
