//! The coefficients of Dormand and Prince's method 5(4) (J. Comput. Appl. Math. 6, 1980), named as
//! in Hairer, Nørsett and Wanner, *Solving Ordinary Differential Equations I*, table II.5.2.

/// The times of stages 2 to 5, in steps; 6 and 7 are at the end.
pub(super) const ABSCISSAE: [f64; 4] = [1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0];

/// Stage 2 from rate 1.
pub(super) const A2: [f64; 1] = [1.0 / 5.0];

/// Stage 3 from rates 1 and 2.
pub(super) const A3: [f64; 2] = [3.0 / 40.0, 9.0 / 40.0];

/// Stage 4 from rates 1 to 3.
pub(super) const A4: [f64; 3] = [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0];

/// Stage 5 from rates 1 to 4.
pub(super) const A5: [f64; 4] =
    [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0];

/// Stage 6 from rates 1 to 5.
pub(super) const A6: [f64; 5] =
    [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0];

/// The result of order five, which is also stage 7, from rates 1 and 3 to 6.
pub(super) const B: [f64; 5] =
    [35.0 / 384.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0];

/// The difference of the results of order five and four, from rates 1 and 3 to 7.
pub(super) const E: [f64; 6] = [
    71.0 / 57600.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];

/// The quartic term of the interpolation of order four, from rates 1 and 3 to 7 (Shampine; Hairer's
/// `dopri5.f`).
pub(super) const D: [f64; 6] = [
    -12715105075.0 / 11282082432.0,
    87487479700.0 / 32700410799.0,
    -10690763975.0 / 1880347072.0,
    701980252875.0 / 199316789632.0,
    -1453857185.0 / 822651844.0,
    69997945.0 / 29380423.0,
];

#[cfg(test)]
mod tests {
    use super::*;

    /// Order conditions, which a wrong digit would violate: every row of A sums up to its abscissa, B
    /// integrates 1, c, c², c³, c⁴ exactly, and E and D leave a constant rate alone.
    #[test]
    fn rows_are_consistent() {
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-13, "{a} {b}");
        let rows: [&[f64]; 5] = [&A2, &A3, &A4, &A5, &A6];
        for (row, c) in rows.iter().zip(ABSCISSAE.into_iter().chain([1.0])) {
            near(row.iter().sum(), c);
        }
        let nodes = [0.0, ABSCISSAE[1], ABSCISSAE[2], ABSCISSAE[3], 1.0];
        for power in 0..5 {
            let integral: f64 =
                B.iter().zip(nodes).map(|(b, c): (&f64, f64)| b * c.powi(power)).sum();
            near(integral, 1.0 / f64::from(power + 1));
        }
        near(E.iter().sum(), 0.0);
        near(D.iter().sum(), 0.0);
    }
}
