//! Extreme mechanisms: numbers that the dynamics does not read, very different masses, bodies with
//! almost no inertia, parameters that make results infinite.

mod support;

use mstmm::description::Origin;
use mstmm::prelude::*;
use mstmm::{Error, GeneratedChain, Mask, Scalar};
use mstmm_reference::Random;

mstmm_chain! {
    /// A chain whose motion does not depend on its position and on the angle of its first pin.
    chain Drifter {
        body Hub { mass = 3 kg; com = [0.1, 0, 0] m; output = [1, 0, 0] m;
            inertia = diag(0.3, 0.4, 0.5) kg*m^2 about com; }
        body Boom { mass = 1 kg; com = [0.5, 0, 0] m;
            inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com; }
        Hub hub -> pin(y) hinge_line -> Boom boom;
    }

    /// A turntable: its pin is along gravity.
    chain Turntable {
        gravity = [0, 0, -9.8] m/s^2;
        body Plate { mass = 1 kg; com = [0, 0, 0] m;
            inertia = diag(0.1, 0.1, 0.2) kg*m^2 about com; }
        ground -> pin(z) axle -> Plate plate;
    }

    /// A gram of rod, which may be thin as a line, free to spin about its own axis, between the ground and a heavy body.
    chain Thread {
        gravity = [0, -9.8, 0] m/s^2;
        param thickness = 1e-6;
        body Rod { mass = 1 g; com = [0.5, 0, 0] m; output = [1, 0, 0] m;
            inertia = diag(thickness, 1/12000, 1/12000) kg*m^2 about com; }
        body Weight { mass = 100 kg; com = [0.2, -0.1, 0.3] m;
            inertia = diag(2, 3, 4) kg*m^2 about com; }
        ground turned rpy(10, 20, 30) deg -> ball loose -> Rod rod -> ball end -> Weight weight;
    }

    /// A crank that is driven, and a rod.
    chain Crank {
        answers = pull;
        body Arm { mass = 1 kg; com = [0.5, 0, 0] m; output = [1, 0, 0] m;
            inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com; }
        ground -> slider(z) lift -> Arm arm -> pin(z) drive -> Arm crank -> pin(z) joint -> Arm rod;
        hinge drive { motion = input; }
    }

    /// A body whose centre of mass lies far beyond its output, on the same axis.
    chain Overhang {
        gravity = [0, -9.8, 0] m/s^2;
        body Head { mass = 1 kg; com = [1, 0, 0] m; output = [1e-6, 0, 0] m;
            inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com; }
        ground -> ball neck -> Head head;
    }

    /// A wire that turns about its own axis: a tiny number, but an exact one.
    chain Wire {
        body Rod { mass = 1 kg; com = [0.5, 0, 0] m;
            inertia = diag(1e-9, 1/12, 1/12) kg*m^2 about com; }
        ground -> pin(x) spin -> Rod rod;
        hinge spin { torque = input; }
    }

    /// A chain with large matrices, whose entries are tested only if a coordinate, a rate or an acceleration is large.
    chain Snake {
        answers = [mass_matrix, jacobian, regressor, derivatives];
        param mass = 1;
        body Arm { mass = 1 kg; com = [0.5, 0.1, 0] m; output = [1, 0, 0] m;
            inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com; }
        body Tip { mass = mass * 1 kg; com = [0.5, 0.1, 0] m; inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com; }
        ground -> ball shoulder -> Arm upper -> slider(x) rail -> Arm middle -> ball elbow -> Arm lower -> slider(y) grip
            -> Arm finger -> ball knuckle -> Arm phalanx -> pin(z) tip -> Tip nail;
    }

    chain Lever {
        param length = 2;
        param slant = 1;
        body Arm { mass = 1 kg; com = [1 / length, 0, 0];
            inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com; }
        ground -> pin([0, 0, slant]) fulcrum -> Arm arm;
    }
}

/// Every number of a state must be finite, also those that nothing is computed from.
fn refuses_every_nan<C: GeneratedChain<Scalar = f64>>(chain: &C) {
    let state = chain.initial_state();
    let (q, v) = (state.coordinates().len(), state.rates().len());
    for place in 0..q + v {
        let mut broken = state.clone();
        let origin = match place.checked_sub(q) {
            None => {
                broken.coordinates_mut()[place] = f64::NAN;
                Origin::Coordinate(place)
            }
            Some(place) => {
                broken.rates_mut()[place] = f64::NAN;
                Origin::Rate(place)
            }
        };
        let found = chain.solve_into(&broken, &chain.no_inputs(), &mut chain.workspace());
        assert_eq!(found, Err(Error::NotFinite(origin)), "number {place}");
    }
}

#[test]
fn numbers_that_the_motion_does_not_depend_on_must_be_finite_too() {
    refuses_every_nan(&Drifter::<f64>::new());
    refuses_every_nan(&Turntable::<f64>::new());
}

/// The rounding error of a hundred kilograms must not count as the inertia of a gram.
#[test]
fn a_loose_thread_under_a_heavy_weight_has_no_answer() {
    let mut chain = Thread::<f64>::new();
    // Less than what rounding leaves of the hundred kilograms.
    chain.set_thickness(1e-22).expect("a thin rod");
    for seed in 0..200 {
        let mut random = Random::new(seed);
        let mut state = chain.initial_state();
        state.q.iter_mut().for_each(|q| *q = random.between(-1.0, 1.0));
        state.v.iter_mut().for_each(|v| *v = random.between(-1.0, 1.0));
        mstmm::Chain::normalize(&chain, &mut state);
        let found = chain.accelerations(&state, &chain.no_inputs());
        assert_eq!(found.err(), Some(Error::Singular { hinge: "loose" }), "seed {seed}");
    }
}

#[test]
fn a_tiny_inertia_that_is_exact_has_an_answer_in_single_precision() {
    let chain = Wire::<f32>::new();
    let inputs = WireInputs { spin: 2e-9 };
    let found = chain.accelerations(&chain.initial_state(), &inputs).expect("an answer");
    // One quotient of two rounded numbers.
    assert!((found[0] - 2.0).abs() < 4.0 * f32::EPSILON, "{found}");
}

#[test]
fn a_parameter_with_results_that_are_not_finite_is_refused() {
    let mut chain = Lever::<f64>::new();
    let before = chain.clone();
    for refused in [chain.set_length(0.0), chain.set_slant(0.0), chain.set_length(f64::INFINITY)] {
        assert!(matches!(refused, Err(Error::InvalidParameter { .. })), "{refused:?}");
    }
    assert_eq!(chain, before);
    chain.set_slant(-3.0).expect("the axis the other way round");
}

/// The centre of mass of a body must not be computed from a point close to its input, which would lose
/// six digits here.
#[test]
fn a_force_is_right_to_rounding_wherever_the_output_lies() {
    let chain = Overhang::<f64>::new();
    let mut at = chain.workspace();
    for seed in 0..20 {
        let mut random = Random::new(seed);
        let mut state = chain.initial_state();
        state.coordinates_mut().iter_mut().for_each(|q| *q = random.between(-1.0, 1.0));
        state.rates_mut().iter_mut().for_each(|v| *v = random.between(-2.0, 2.0));
        chain.normalize(&mut state);
        chain.solve_into(&state, &chain.no_inputs(), &mut at).expect("a regular chain");
        let head = at.head();
        let (input, omega) = (head.input(), head.input().angular_velocity());
        let arm = input.orientation() * nalgebra::Vector3::x();
        let centre = input.angular_acceleration().cross(&arm) + omega.cross(&omega.cross(&arm));
        let felt = centre + nalgebra::Vector3::y() * 9.8;
        let off = (input.force() - felt).norm() / felt.norm();
        // A few dozen roundings, each of half a unit.
        assert!(off < 32.0 * f64::EPSILON, "seed {seed}: {off:e}");
    }
}

/// The gradient at a weight of the slider does not depend on the rates of pins, but the accelerations do.
#[test]
fn a_gradient_with_accelerations_that_overflow_is_an_error() {
    let chain = Crank::<f64>::new();
    let (state, mut inputs) = (chain.initial_state(), chain.no_inputs());
    inputs.drive.state = mstmm::PinState::new(0.0, 1e160);
    let overflow = Err(Error::NotFinite(Origin::Result));
    assert_eq!(chain.accelerations(&state, &inputs).map(|_| ()), overflow);
    let weights = nalgebra::Vector2::new(1.0, 0.0);
    let (mut accelerations, mut gradient) = (weights, CrankVariation::default());
    let found = chain.pull_into(&state, &inputs, &weights, &mut accelerations, &mut gradient);
    assert_eq!(found, overflow);
}

/// Fails unless a matrix function has results exactly if all of its entries and their sum are finite, with one number of the
/// arguments multiplied by powers of ten.
#[track_caller]
fn is_right_at_any_scale<T: Scalar>(
    largest: i32,
    entries: impl Fn(&SnakeState<T>, &nalgebra::SVector<T, 12>, T) -> (Result<(), Error>, Vec<T>),
) {
    let mut random = Random::new(11);
    let mut number = || T::constant(random.between(-1.0, 1.0));
    let mut state = Snake::<T>::new().initial_state();
    state.rates_mut().iter_mut().for_each(|rate| *rate = number());
    let accelerations = nalgebra::SVector::from_fn(|_, _| number());
    let (q, v) = (state.coordinates().len(), state.rates().len());
    let mut found = [0; 2];
    for place in 0..q + 2 * v + 1 {
        for exponent in (-largest..=largest).step_by(3) {
            let scale = T::constant(10.0_f64.powi(exponent));
            let (mut state, mut accelerations) = (state.clone(), accelerations);
            let mut mass = T::constant(1.0);
            match place {
                place if place < q => state.coordinates_mut()[place] += scale,
                place if place < q + v => state.rates_mut()[place - q] *= scale,
                place if place < q + 2 * v => accelerations[place - q - v] *= scale,
                _ => mass = scale,
            }
            let (result, entries) = entries(&state, &accelerations, mass);
            let are_finite = entries.iter().all(|entry| entry.is_finite().all());
            // A sum of finite entries may overflow.
            let sum = entries.iter().fold(T::constant(0.0), |sum, entry| sum + entry.abs());
            let is_right = match result {
                Ok(()) => are_finite,
                Err(error) => !sum.is_finite().all() && error == Error::NotFinite(Origin::Result),
            };
            assert!(is_right, "number {place}, 1e{exponent}: {result:?}");
            found[usize::from(are_finite)] += 1;
        }
    }
    assert!(found[0] > 20 && found[1] > 200, "{found:?}");
}

/// Returns a chain with this mass, if the setter takes it.
fn snake<T: Scalar>(mass: T) -> Snake<T> {
    let mut chain = Snake::new();
    // A mass with which results of the setup overflow is refused.
    let _ = chain.set_mass(mass);
    chain
}

fn matrices_at_any_scale<T: Scalar>(largest: i32) {
    let none = |chain: &Snake<T>| chain.no_inputs();
    is_right_at_any_scale::<T>(largest, |state, _, mass| {
        let (chain, mut matrix) = (snake(mass), nalgebra::SMatrix::repeat(T::constant(0.0)));
        let result = chain.mass_matrix_into(state, &none(&chain), &mut matrix);
        (result, matrix.as_slice().to_vec())
    });
    is_right_at_any_scale::<T>(largest, |state, accelerations, mass| {
        let (chain, mut found) = (snake(mass), SnakeInverseDynamicsDerivatives::default());
        let inputs = none(&chain);
        let result =
            chain.inverse_dynamics_derivatives_into(state, accelerations, &inputs, &mut found);
        (result, found.by_coordinates.as_slice().to_vec())
    });
    is_right_at_any_scale::<T>(largest, |state, accelerations, mass| {
        let (chain, mut matrix) = (snake(mass), nalgebra::SMatrix::repeat(T::constant(0.0)));
        let inputs = none(&chain);
        let result = chain.regressor_into(state, accelerations, &inputs, &mut matrix);
        (result, matrix.as_slice().to_vec())
    });
}

#[test]
fn large_matrices_have_finite_entries_or_are_refused() {
    matrices_at_any_scale::<f64>(300);
    matrices_at_any_scale::<f32>(36);
    matrices_at_any_scale::<mstmm::wide::f64x4>(300);
}

/// Bounds of values say nothing about derivatives.
#[test]
fn derivatives_of_moderate_values_that_overflow_are_refused() {
    type Number = mstmm::Dual<f64>;
    let chain = Snake::<Number>::new();
    let mut state = chain.initial_state();
    let mut matrix = nalgebra::SMatrix::repeat(Number::constant(0.0));
    for (derivative, expected) in
        [(1e300, Ok(())), (f64::MAX, Err(Error::NotFinite(Origin::Result)))]
    {
        // The slider, behind the quaternion of the ball. Entries have some kilograms times its coordinate.
        state.coordinates_mut()[4].derivatives = [derivative];
        let found = chain.mass_matrix_into(&state, &chain.no_inputs(), &mut matrix);
        assert_eq!(found, expected, "{derivative:e}");
    }
}
