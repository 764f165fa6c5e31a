//! Operators with numbers, quotients, and vectors and rotations of dual numbers.

use mstmm::nalgebra::{Matrix2, SMatrix, Vector2, Vector3};
use mstmm::{Dual, Error, mstmm_chain};
use mstmm_reference::Random;

/// Quotients and operations with numbers on both sides, against closed forms.
#[test]
fn operators_take_numbers_on_both_sides() {
    for seed in 0..100 {
        let mut random = Random::new(seed);
        let at = [0; 2].map(|_| random.between(0.5, 2.0));
        let [x, y] = Dual::variables(at);
        let found = (2.0 - x) / (x * x + 1.0) - 3.0 * y / x + (1.0 + y - 0.5) / y * 4.0 + 1.0 / y;
        let [x, y] = at;
        let square = x * x + 1.0;
        let value = (2.0 - x) / square - 3.0 * y / x + (1.0 + y - 0.5) / y * 4.0 + 1.0 / y;
        assert_eq!(found.value, value, "seed {seed}");
        let by_x = (-square - (2.0 - x) * 2.0 * x) / (square * square) + 3.0 * y / (x * x);
        let by_y = -3.0 / x - (0.5 * 4.0 + 1.0) / (y * y);
        for (found, expected) in found.derivatives.into_iter().zip([by_x, by_y]) {
            // Terms are below 24, with at most ten roundings.
            assert!((found - expected).abs() < 24.0 * 10.0 * 1.2e-16, "seed {seed}: {found}");
        }
        let mut halved = Dual::<f64, 2>::variables(at)[0];
        halved /= Dual::from(2.0);
        assert_eq!((halved.value, halved.derivatives), (at[0] / 2.0, [0.5, 0.0]));
        let [angle, _] = Dual::<f64, 2>::variables(at);
        let tangent = angle.sin() / angle.cos();
        let slope = 1.0 + at[0].tan().powi(2);
        // The tangent near a right angle is below 15, and the slope's error grows with its square.
        let off = (tangent.derivatives[0] / slope - 1.0).abs();
        assert!(off < 1e-13, "seed {seed}: {off:e}");
    }
}

/// Products of vectors and matrices have the entries of the sums written out.
#[test]
fn matrices_of_dual_numbers_are_multiplied() {
    let [a, b] = Dual::variables([0.3, -1.2]);
    let matrix = Matrix2::new(a, b, b * a, a + 1.0);
    let vector = Vector2::new(b, a);
    let product = matrix * vector;
    assert_eq!(
        (product[0].value, product[1].value),
        (0.3 * -1.2 * 2.0, (-1.2 * 0.3) * -1.2 + 1.3 * 0.3)
    );
    // a b + b a and a b² + (a + 1) a.
    assert_eq!(product[0].derivatives, [-2.4, 0.6]);
    let expected = [1.44_f64 + 1.6, 2.0 * 0.3 * -1.2];
    for (found, expected) in product[1].derivatives.into_iter().zip(expected) {
        assert!((found - expected).abs() < 1e-15, "{found} and {expected}");
    }
    assert_eq!(vector.dot(&vector), b * b + a * a);
    let identity: SMatrix<Dual<f64, 2>, 2, 2> = SMatrix::identity();
    assert_eq!(identity * matrix, matrix);
}

mstmm_chain! {
    chain Swing {
        gravity = [0, -9.81, 0] m/s^2;
        body Rod {
            mass = 2 kg; com = [0.4, 0, 0] m; inertia = diag(0.01, 0.1, 0.1) kg*m^2 about com;
            point imu = [0.7, 0, 0] m turned rpy(0, 0, 90) deg;
        }
        ground -> pin(z) joint -> Rod rod;
    }
}

/// The derivatives of what an accelerometer and a gyroscope measure, in the axes of their frame, by the angle and the rate.
#[test]
fn measurements_have_exact_derivatives() -> Result<(), Error> {
    let (chain, g, inertia) = (Swing::<Dual<f64, 2>>::new(), 9.81, 0.1 + 2.0 * 0.4 * 0.4);
    let mut at = chain.workspace();
    for (angle, rate) in [(0.3_f64, 1.0), (-2.0, -3.0), (1.2, 0.0)] {
        let [q, v] = Dual::variables([angle, rate]);
        let mut state = chain.initial_state();
        state.joint_mut().set_angle(q).set_rate(v);
        chain.solve_into(&state, &chain.no_inputs(), &mut at)?;
        let imu = at.rod().imu();
        let to_frame = imu.orientation().inverse();
        let gravity = Vector3::new(0.0, -g, 0.0).map(Dual::from);
        let force = to_frame * (imu.acceleration() - gravity);
        let turning = to_frame * imu.angular_velocity();
        let (sine, cosine) = angle.sin_cos();
        // Along the rod −ω² l + g sin θ, across it α l + g cos θ with α = −m g r cos θ / J. The frame is turned by 90°.
        let along = (-rate * rate * 0.7 + g * sine, [g * cosine, -2.0 * rate * 0.7]);
        let share = 1.0 - 2.0 * 0.4 * 0.7 / inertia;
        let across = (share * g * cosine, [-share * g * sine, 0.0]);
        let expected = [across, (-along.0, along.1.map(|x| -x)), (0.0, [0.0; 2])];
        for (found, (value, derivatives)) in force.iter().zip(expected) {
            // Numbers are below 20, with some dozen roundings.
            assert!((found.value - value).abs() < 1e-13, "{found:?}");
            let off = |k: usize| (found.derivatives[k] - derivatives[k]).abs();
            assert!(off(0) < 1e-13 && off(1) < 1e-13, "{found:?} and {derivatives:?}");
        }
        assert!(
            (turning.z - v).value.abs() < 1e-15 && (turning.z.derivatives[1] - 1.0).abs() < 1e-15
        );
    }
    Ok(())
}
