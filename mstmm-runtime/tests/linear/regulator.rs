//! Regulators against the Riccati equation, closed forms, and the recursion over many steps.

use super::{Random, converted};
use mstmm_runtime::Error;
use mstmm_runtime::description::Origin;
use mstmm_runtime::linear::{Lqr, lqr};
use mstmm_runtime::nalgebra::{DMatrix, Matrix1, Matrix2, SMatrix, Vector2};

/// A system and its weights.
struct Problem<const X: usize, const U: usize> {
    a: SMatrix<f64, X, X>,
    b: SMatrix<f64, X, U>,
    q: SMatrix<f64, X, X>,
    r: SMatrix<f64, U, U>,
}

impl<const X: usize, const U: usize> Problem<X, U> {
    /// Motions grow by up to `growth` in a step.
    fn random(seed: u64, growth: f64) -> Self {
        let mut random = Random::new(seed);
        let a = random.matrix::<X, X>();
        let size = a.abs().max() * (X as f64).sqrt();
        let (q, r) = (random.matrix::<X, X>(), random.matrix::<U, U>());
        Self {
            a: a * (growth / size),
            b: random.matrix(),
            q: q * q.transpose(),
            r: r * r.transpose() + SMatrix::identity() * 0.01,
        }
    }

    fn lqr(&self) -> Result<Lqr<f64, X, U>, Error> {
        lqr(&self.a, &self.b, &self.q, &self.r)
    }

    /// The right side of the Riccati equation, by nalgebra's inverse.
    fn right_side(&self, p: &SMatrix<f64, X, X>) -> SMatrix<f64, X, X> {
        let Self { a, b, q, r } = self;
        let inner = to_dynamic(&(r + b.transpose() * p * b));
        let coupling = b.transpose() * p * a;
        let gain = inner.try_inverse().expect("positive definite") * to_dynamic(&coupling);
        let lowered = to_dynamic(&coupling.transpose()) * gain;
        a.transpose() * p * a + q - SMatrix::from_fn(|row, column| lowered[(row, column)])
    }

    /// The largest eigenvalue of the closed loop, as a magnitude.
    fn radius(&self, regulator: &Lqr<f64, X, U>) -> f64 {
        let eigenvalues = to_dynamic(&(self.a - self.b * regulator.gain)).complex_eigenvalues();
        eigenvalues.iter().map(|value| value.norm()).fold(0.0, f64::max)
    }
}

fn to_dynamic<const R: usize, const C: usize>(m: &SMatrix<f64, R, C>) -> DMatrix<f64> {
    DMatrix::from_column_slice(R, C, m.as_slice())
}

fn check<const X: usize, const U: usize>() {
    let (mut largest, mut unstable) = (0.0f64, 0);
    for seed in 0..40 {
        let problem = Problem::<X, U>::random(seed, 3.0 * (seed % 4) as f64 / 3.0);
        let regulator = problem.lqr().expect("stabilizable");
        let p = regulator.cost;
        // A rounding error E of P changes the residual by Cᵀ E C − E, with the closed loop C.
        let closed = (problem.a - problem.b * regulator.gain).norm();
        let off = (problem.right_side(&p) - p).abs().max() / p.abs().max();
        let tolerance = 1e-14 * (2.0 + closed * closed);
        assert!(off < tolerance, "seed {seed}: residual {off:e} of {tolerance:e}");
        assert_eq!(p, p.transpose());
        let radius = problem.radius(&regulator);
        assert!(radius < 1.0, "seed {seed}: {radius}");
        let open = to_dynamic(&problem.a).complex_eigenvalues();
        unstable += usize::from(open.iter().any(|value| value.norm() > 1.0));
        largest = largest.max(off / tolerance * 1e-14);
    }
    assert!(unstable >= 5, "only {unstable} systems are unstable");
    println!(
        "{X} states, {U} inputs: residual {largest:.1e} (1 + C²), {unstable} of 40 are unstable"
    );
}

#[test]
fn the_riccati_equation_holds_and_the_closed_loop_is_stable() {
    check::<1, 1>();
    check::<2, 1>();
    check::<4, 2>();
    check::<6, 2>();
    check::<8, 3>();
}

/// The scalar equation p = a² p r / (r + p) + q with b = 1 is quadratic.
#[test]
fn a_scalar_system_has_its_closed_form() -> Result<(), Error> {
    for (a, q, r) in [(1.1f64, 1.0, 1.0), (0.5, 2.0, 0.1), (1.0, 1e-8, 1.0), (30.0, 1.0, 100.0)] {
        let half: f64 = 0.5 * (q + (a * a - 1.0) * r);
        let p = half + (half * half + q * r).sqrt();
        let found = lqr(&Matrix1::new(a), &Matrix1::new(1.0), &Matrix1::new(q), &Matrix1::new(r))?;
        let gain = a * p / (r + p);
        // For a = 1 the cost is the small difference of the equation's terms: half the digits of q / p are lost.
        assert!((found.cost.x / p - 1.0).abs() < 1e-11, "{} {p}", found.cost.x);
        assert!((found.gain.x / gain - 1.0).abs() < 1e-11, "{} {gain}", found.gain.x);
    }
    Ok(())
}

/// A mass that a force moves, sampled ever faster: the gain tends to that of continuous time, which is
/// √(q/r) and √(2 √(q/r)) for a weight q of the position (Bryson and Ho, *Applied Optimal Control*, chapter 5).
#[test]
fn fast_sampling_has_the_gain_of_continuous_time() -> Result<(), Error> {
    let expected = [2.0f64, 2.0];
    for h in [1e-2, 1e-3, 1e-4, 1e-5] {
        let a = Matrix2::new(1.0, h, 0.0, 1.0);
        let b = Vector2::new(0.5 * h * h, h);
        let q = Matrix2::new(4.0 * h, 0.0, 0.0, 0.0);
        let gain = lqr(&a, &b, &q, &Matrix1::new(h))?.gain;
        for (found, expected) in gain.iter().zip(expected) {
            let off = (found - expected).abs();
            assert!(off < 2.5 * h && (h < 1e-4 || off > 0.5 * h), "{h}: {found} is off by {off:e}");
        }
    }
    Ok(())
}

/// The best gain for one input, by the Riccati recursion in the form Cᵀ P C + Kᵀ R K + Q with the closed loop C, of which all
/// terms are positive.
fn by_recursion<const X: usize>(problem: &Problem<X, 1>) -> SMatrix<f64, 1, X> {
    let Problem { a, b, q, r } = problem;
    let mut p = *q;
    for _ in 0..20_000 {
        let gain = b.transpose() * p * a / (r + b.transpose() * p * b).x;
        let closed = a - b * gain;
        let next = closed.transpose() * p * closed + gain.transpose() * r * gain + q;
        let change = (next - p).abs().max();
        p = next;
        if change < 1e-16 * p.abs().max() {
            break;
        }
    }
    b.transpose() * p * a / (r + b.transpose() * p * b).x
}

/// Weights R that are much smaller than Bᵀ P B: the doubling loses digits, and finds no gain in the end. The gain of these
/// systems changes by up to some thousand times the rounding errors of the products in its equation.
#[test]
fn cheap_inputs_have_their_gain() -> Result<(), Error> {
    fn check<const X: usize>(seed: u64, largest: &mut [f64; 2]) -> Result<(), Error> {
        let mut problem = Problem::<X, 1>::random(seed, 1.5);
        // The numbers of the single precision, so that both have the same system.
        let rounded = |number: f64| f64::from(number as f32);
        (problem.a, problem.b) = (problem.a.map(rounded), problem.b.map(rounded));
        problem.q = problem.q.map(rounded);
        for exponent in (0..16).step_by(3) {
            problem.r = Matrix1::new(f64::from(10.0_f32.powi(-exponent)));
            let expected = by_recursion(&problem);
            let of =
                |gain: SMatrix<f64, 1, X>| (gain - expected).abs().max() / expected.abs().max();
            let double = of(problem.lqr()?.gain);
            assert!(double < 2e4 * f64::EPSILON, "seed {seed}, R = 1e-{exponent}: {double:e}");
            let Problem { a, b, q, r } = &problem;
            let single =
                lqr::<f32, X, 1>(&converted(a), &converted(b), &converted(q), &converted(r))?;
            let single = of(single.gain.map(f64::from));
            assert!(
                single < 2e4 * f64::from(f32::EPSILON),
                "seed {seed}, R = 1e-{exponent}, single precision: {single:e}"
            );
            *largest = [largest[0].max(double), largest[1].max(single)];
        }
        Ok(())
    }
    let mut largest = [0.0; 2];
    for seed in 0..6 {
        check::<2>(seed, &mut largest)?;
        check::<4>(seed, &mut largest)?;
    }
    println!("largest relative errors: {:.1e}, in single precision {:.1e}", largest[0], largest[1]);
    Ok(())
}

/// Motions that grow six times in a step: the doubling finds no gain for some of these systems in single precision.
#[test]
fn closed_loops_of_fast_growing_motions_are_stable() {
    fn check<const X: usize, const U: usize>() {
        for seed in 0..60 {
            let mut problem = Problem::<X, U>::random(seed, 6.0);
            // The numbers of the single precision, so that both have the same system.
            let rounded = |number: f64| f64::from(number as f32);
            (problem.a, problem.b) = (problem.a.map(rounded), problem.b.map(rounded));
            let regulator = problem.lqr().expect("stabilizable");
            let radius = problem.radius(&regulator);
            assert!(radius < 1.0, "seed {seed}: {radius}");
            let Problem { a, b, q, r } = &problem;
            let single =
                lqr::<f32, X, U>(&converted(a), &converted(b), &converted(q), &converted(r));
            let gain = single.expect("stabilizable").gain.map(f64::from);
            let radius = problem.radius(&Lqr { gain, ..regulator });
            assert!(radius < 1.0, "seed {seed}, single precision: {radius}");
        }
    }
    check::<2, 1>();
    check::<4, 2>();
    check::<8, 2>();
}

/// A cart with a pole upright, over wide ranges of steps and weights, and in single precision, where A differs from the
/// unit matrix by the last digits only.
#[test]
fn residuals_are_small_for_all_steps_and_weights() -> Result<(), Error> {
    let mut rates = SMatrix::<f64, 4, 4>::zeros();
    (rates[(0, 2)], rates[(1, 3)]) = (1.0, 1.0);
    (rates[(2, 1)], rates[(3, 1)]) = (-0.981, 21.582);
    let identity = SMatrix::identity();
    for h in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5] {
        let step = rates * h;
        let integral = (2..=4).rev().fold(identity, |sum, k| identity + step * sum / f64::from(k));
        for weight in [1e-6, 1e-3, 1.0, 1e3] {
            let problem = Problem {
                a: identity + step * integral,
                b: integral * SMatrix::<f64, 4, 1>::new(0.0, 0.0, 1.0, -2.0) * h,
                q: SMatrix::from_diagonal(&SMatrix::<f64, 4, 1>::new(10.0, 10.0, 1.0, 1.0)) * h,
                r: Matrix1::new(weight * h),
            };
            let Lqr { gain, cost } = problem.lqr()?;
            let off = (problem.right_side(&cost) - cost).abs().max() / cost.abs().max();
            assert!(off < 1e-13, "{h} {weight}: residual {off:e}");
            assert!(problem.radius(&Lqr { gain, cost }) < 1.0);
            let Problem { a, b, q, r } = &problem;
            let single =
                lqr::<f32, 4, 1>(&converted(a), &converted(b), &converted(q), &converted(r))?;
            let off = (single.gain.map(f64::from) - gain).abs().max() / gain.abs().max();
            // Rounding A changes its rates by 6e-8 / h, and 1e3 is the gain from a weight of 1e-6.
            assert!(off < 1e-3 + 1e-6 / h, "{h} {weight}: single precision is off by {off:e}");
        }
    }
    Ok(())
}

/// The cost over n steps, by the recursion from the end, tends to the cost of all steps.
#[test]
fn the_recursion_over_many_steps_tends_to_the_cost() {
    for seed in 0..20 {
        let problem = Problem::<4, 1>::random(seed, 2.0);
        let cost = problem.lqr().expect("stabilizable").cost;
        // The recursion does not keep the symmetry by itself.
        let recursion = (0..2000).fold(problem.q, |p, _| {
            let next = problem.right_side(&p);
            (next + next.transpose()) * 0.5
        });
        let off = (recursion - cost).abs().max() / cost.abs().max();
        assert!(off < 1e-10, "seed {seed}: {off:e}");
    }
}

/// No other gain has a smaller cost: the cost of a trajectory is xᵀ P x, and more with a gain that is changed.
#[test]
fn a_trajectory_has_the_cost_and_other_gains_have_more() -> Result<(), Error> {
    let mut random = Random::new(7);
    let problem = Problem::<4, 2>::random(3, 1.5);
    let regulator = problem.lqr()?;
    let start = random.matrix::<4, 1>();
    let cost = |gain: &SMatrix<f64, 2, 4>| {
        let (mut x, mut cost) = (start, 0.0);
        for _ in 0..2000 {
            let u = -(gain * x);
            cost += (x.transpose() * problem.q * x + u.transpose() * problem.r * u).x;
            x = problem.a * x + problem.b * u;
        }
        cost
    };
    let least = (start.transpose() * regulator.cost * start).x;
    assert!((cost(&regulator.gain) / least - 1.0).abs() < 1e-12);
    for _ in 0..20 {
        let other = regulator.gain + random.matrix::<2, 4>() * 1e-2;
        assert!(cost(&other) > least * (1.0 + 1e-9));
    }
    Ok(())
}

#[test]
fn what_cannot_be_stabilized_is_an_error() {
    let (q, r) = (Matrix2::identity(), Matrix1::new(1.0));
    let refused = |a: Matrix2<f64>, b: Vector2<f64>, q: Matrix2<f64>| lqr(&a, &b, &q, &r).err();
    let out_of_reach = Vector2::new(1.0, 0.0);
    for growth in [1.0, 1.01, 3.0, -1.0, -2.0] {
        let a = Matrix2::new(0.5, 0.0, 0.0, growth);
        assert_eq!(refused(a, out_of_reach, q), Some(Error::NotStabilizable), "{growth}");
        // Within reach, but without a weight.
        let weight = Matrix2::new(1.0, 0.0, 0.0, 0.0);
        assert_eq!(refused(a, Vector2::new(1.0, 1.0), weight), Some(Error::NotStabilizable));
        assert_eq!(refused(a, Vector2::new(1.0, 1.0), q), None);
    }
    // What decays by itself need not be within reach, nor have a weight.
    let decaying = Matrix2::new(0.5, 0.0, 0.0, 0.9);
    assert_eq!(refused(decaying, out_of_reach, q), None);
    assert_eq!(refused(decaying, Vector2::zeros(), Matrix2::zeros()), None);
}

/// The gain does not depend on the size of the weights, to the last bit where the size is a power of two.
#[test]
fn weights_may_have_any_size() -> Result<(), Error> {
    for seed in 0..20 {
        let problem = Problem::<4, 2>::random(seed, 1.5);
        let expected = problem.lqr()?;
        let sizes =
            [1e-200, 1e-150, 1e-9, 1e7, 1e150, 1e200, 1e300, 2f64.powi(-600), 2f64.powi(900)];
        for size in sizes {
            let Problem { a, b, q, r } = &problem;
            let found = lqr(a, b, &(q * size), &(r * size))?;
            // A rounding of each weight changes the gain by about a rounding; that of a power of two is exact.
            let tolerance = if size.log2().fract() == 0.0 { 0.0 } else { 1e-12 };
            let off = (found.gain - expected.gain).abs().max() / expected.gain.abs().max();
            assert!(off <= tolerance, "seed {seed}, {size:e}: {off:e}");
            let off = (found.cost / size - expected.cost).abs().max() / expected.cost.abs().max();
            assert!(off <= tolerance, "seed {seed}, {size:e}: {off:e}");
            // Up to 1e±30 in single precision.
            let size = size.powf(0.1);
            let single = lqr::<f32, 4, 2>(
                &converted(a),
                &converted(b),
                &converted(&(q * size)),
                &converted(&(r * size)),
            )?;
            let off = (single.gain.map(f64::from) - expected.gain).abs().max();
            assert!(off < 1e-4 * expected.gain.abs().max(), "seed {seed}, {size:e}: {off:e}");
        }
    }
    Ok(())
}

/// Weights at the ends of the range: what overflows is reported as such.
#[test]
fn weights_that_overflow_are_not_reported_as_not_stabilizable() -> Result<(), Error> {
    let (a, b) = (Matrix1::new(2.0), Matrix1::new(1.0));
    let of = |q: f64, r: f64| lqr(&a, &b, &Matrix1::new(q), &Matrix1::new(r));
    let gain = of(1.0, 1.0)?.gain;
    // Q + Qᵀ is not a number of `f64`.
    let decaying = Matrix1::new(0.5);
    let of_decaying = |size: f64| lqr(&decaying, &b, &Matrix1::new(size), &Matrix1::new(size));
    let (found, expected) = (of_decaying(2f64.powi(1023))?, of_decaying(1.0)?);
    assert_eq!((found.gain, found.cost), (expected.gain, expected.cost * 2f64.powi(1023)));
    // A small R hardly counts: the first step takes the state to zero.
    assert!((of(1e300, 1.0)?.gain.x - 2.0).abs() < 1e-15 && gain.x < 2.0);
    assert!((of(1.0, 1e-300)?.gain.x - 2.0).abs() < 1e-15);
    let overflows = Some(Error::NotFinite(Origin::Result));
    // The cost is 1.6e308 · 5.
    assert_eq!(of(1.6e308, 1.6e308).err(), overflows);
    // R is zero in comparison with Q, or B R⁻¹ Bᵀ Q is infinite.
    assert_eq!(of(1e300, 1e-300).err(), overflows);
    assert_eq!(of(1.0, 1e-310).err(), overflows);
    Ok(())
}

#[test]
fn weights_and_matrices_are_checked() {
    let (a, b, q) = (Matrix2::identity(), Vector2::new(1.0, 2.0), Matrix2::identity());
    let refused = Error::InvalidParameter { name: "r", reason: "must be positive definite" };
    for r in [0.0, -1.0] {
        assert_eq!(lqr(&a, &b, &q, &Matrix1::new(r)).err(), Some(refused));
    }
    for wrong in [f64::NAN, f64::INFINITY] {
        let one = Matrix1::new(1.0);
        let of = |name, index| Some(Error::NotFinite(Origin::Argument { name, index }));
        assert_eq!(lqr(&(a * wrong), &b, &q, &one).err(), of("a", 0));
        assert_eq!(lqr(&a, &(b * wrong), &q, &one).err(), of("b", 0));
        let mut last = q;
        last[(1, 1)] = wrong;
        assert_eq!(lqr(&a, &b, &last, &one).err(), of("q", 3));
        assert_eq!(lqr(&a, &b, &q, &(one * wrong)).err(), of("r", 0));
    }
}

#[test]
fn single_precision_has_its_own_accuracy() {
    for seed in 0..40 {
        let problem = Problem::<4, 2>::random(seed, 1.5);
        let expected = problem.lqr().expect("stabilizable");
        let Problem { a, b, q, r } = &problem;
        let found = lqr::<f32, 4, 2>(&converted(a), &converted(b), &converted(q), &converted(r));
        let gain = found.expect("stabilizable").gain.map(f64::from);
        let off = (gain - expected.gain).abs().max() / expected.gain.abs().max();
        assert!(off < 1e-4, "seed {seed}: off by {off:e}");
    }
}

#[cfg(feature = "wide")]
#[test]
fn lanes_have_their_own_regulators() -> Result<(), Error> {
    use mstmm_runtime::wide::f64x4;
    let problems = [1, 2, 3, 4].map(|seed| Problem::<4, 1>::random(seed, seed as f64 / 2.0));
    fn lanes<const R: usize, const C: usize>(
        of: impl Fn(usize) -> SMatrix<f64, R, C>,
    ) -> SMatrix<f64x4, R, C> {
        let of = [0, 1, 2, 3].map(of);
        SMatrix::from_fn(|row, column| f64x4::new(of.each_ref().map(|m| m[(row, column)])))
    }
    let found = lqr(
        &lanes(|lane| problems[lane].a),
        &lanes(|lane| problems[lane].b),
        &lanes(|lane| problems[lane].q),
        &lanes(|lane| problems[lane].r),
    )?;
    for (lane, problem) in problems.iter().enumerate() {
        let expected = problem.lqr()?;
        let gain = found.gain.map(|x| x.to_array()[lane]);
        // All lanes take as many doublings as the slowest.
        assert!((gain - expected.gain).abs().max() < 1e-12 * expected.gain.abs().max());
    }
    Ok(())
}
