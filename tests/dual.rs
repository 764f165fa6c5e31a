//! Dual numbers as scalars: every operation, and generated chains, against differences in numbers of twice the precision,
//! closed forms and bits.

#[path = "support/double_double_scalar.rs"]
mod double_double;

mod dual {
    mod algebra;
    mod closed;
}

use double_double::DoubleDouble;
use mstmm::lanes::NativeF64;
use mstmm::wide::f64x4;
use mstmm::{Chain, ChainState, Dual, Error, Scalar, mstmm_chain};
use mstmm_reference::Random;

/// Every operation of the trait that depends on its arguments smoothly, away from its singular points.
struct Operations;

impl Operations {
    const COUNT: usize = 17;

    fn of<T: Scalar>([x, y, z]: [T; 3]) -> [T; Self::COUNT] {
        let ([sine, _], [_, cosine]) = T::sin_cos([x * y, z]);
        let mut added = x;
        added += y;
        added -= z * z;
        added *= x;
        [
            x + y,
            x - y,
            x * y,
            -x,
            x.negate() * y,
            added,
            x.mul_add(y, z),
            x.mul_sub(y, z),
            x.mul_neg_add(y, z),
            x.recip(),
            (x * x).sqrt() + (y * y + z * z).sqrt(),
            x.copysign(y),
            x.abs() * y.abs(),
            sine,
            cosine,
            y.atan2(x),
            T::select(x.simd_gt(y), x * z, y) + T::sum(&[&[x, y], &[z]]),
        ]
    }
}

/// The derivatives by each argument, by central differences with the step 1e-10: their truncation error is of the order
/// of 1e-20, and the rounding error of 1e-32 becomes one of 1e-22.
fn differences<const N: usize>(
    at: [f64; 3],
    function: impl Fn([DoubleDouble; 3]) -> [DoubleDouble; N],
) -> [[f64; 3]; N] {
    const STEP: f64 = 1e-10;
    let at = at.map(DoubleDouble::new);
    let slopes = [0, 1, 2].map(|k| {
        let moved = |step: f64| {
            let mut there = at;
            there[k] += DoubleDouble::new(step);
            function(there)
        };
        let (after, before) = (moved(STEP), moved(-STEP));
        let twice = DoubleDouble::new(2.0) * DoubleDouble::new(STEP);
        std::array::from_fn::<f64, N, _>(|n| ((after[n] - before[n]) * twice.recip()).high)
    });
    std::array::from_fn(|n| slopes.map(|slope| slope[n]))
}

/// The largest difference of two lists; a NaN is larger than any number.
fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let worst =
        |largest: f64, off: f64| if largest.is_nan() || off <= largest { largest } else { off };
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, worst)
}

#[test]
fn operations_have_exact_derivatives() {
    for seed in 0..200 {
        let mut random = Random::new(seed);
        let sign = |random: &mut Random| if random.chance(0.5) { 1.0 } else { -1.0 };
        // Away from kinks and from poles by more than the step.
        let at = [0; 3].map(|_| sign(&mut random) * random.between(0.2, 2.0));
        let duals = Operations::of(Dual::variables(at));
        let values = Operations::of(at);
        let expected = differences(at, Operations::of);
        for (n, dual) in duals.iter().enumerate() {
            assert_eq!(dual.value.to_bits(), values[n].to_bits(), "seed {seed}: {n}");
            // Derivatives are below 25 = 1/0.2², each of at most ten roundings.
            let off = distance(dual.derivatives, expected[n]);
            assert!(off < 25.0 * 10.0 * 1.2e-16, "seed {seed}: {n} off by {off:e}");
        }
        // In single precision, and lane by lane.
        let single = Operations::of(Dual::variables(at.map(|x| x as f32)));
        let lanes = Operations::of(Dual::variables(at.map(f64x4::splat)));
        for (n, (single, lanes)) in single.iter().zip(&lanes).enumerate() {
            let off = distance(single.derivatives.map(f64::from), expected[n]);
            assert!(off < 25.0 * 20.0 * 6e-8, "seed {seed}: {n} off by {off:e}");
            let lane = lanes.derivatives.map(|derivatives| derivatives.to_array()[3].to_bits());
            assert_eq!(lane, duals[n].derivatives.map(f64::to_bits), "seed {seed}: {n}");
        }
    }
}

/// The derivatives of x³ sin x, twice: dual numbers of dual numbers.
#[test]
fn second_derivatives_follow_from_nested_numbers() {
    for x in [-2.0, 0.3, 1.7] {
        let twice = Dual::variable(Dual::variable(x));
        let ([sine], _) = Scalar::sin_cos([twice]);
        let result = twice * twice * twice * sine;
        let (sine, cosine) = f64::sin_cos(x);
        let first = 3.0 * x * x * sine + x * x * x * cosine;
        let second = 6.0 * x * sine + 6.0 * x * x * cosine - x * x * x * sine;
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-14 * 50.0, "{a} {b}");
        near(result.value.derivative(), first);
        near(result.derivative().value, first);
        near(result.derivative().derivative(), second);
    }
}

#[test]
fn kinks_have_the_derivative_of_the_side_of_the_sign() {
    let slope = |x: f64| Dual::variable(x).abs().derivative();
    assert_eq!([2.0, 0.0, -0.0, -2.0].map(slope), [1.0, 1.0, -1.0, -1.0]);
    for (x, sign) in [(2.0f64, 1.0f64), (2.0, -0.0), (-2.0, 0.0), (-0.0, -1.0), (0.0, -3.0)] {
        let result = Dual::variable(x).copysign(Dual::from(sign));
        let same = x.is_sign_negative() == sign.is_sign_negative();
        assert_eq!(result.value.to_bits(), x.copysign(sign).to_bits());
        assert_eq!(result.derivative(), if same { 1.0 } else { -1.0 });
        // The magnitude does not depend on the sign.
        assert_eq!(Dual::from(x).copysign(Dual::variable(sign)).derivative(), 0.0);
    }
    // Each lane has its side, and its branch.
    let lanes = Dual::variable(f64x4::new([3.0, -3.0, 0.0, -0.0]));
    assert_eq!(lanes.abs().derivative().to_array(), [1.0, -1.0, 1.0, -1.0]);
    let two = Dual::from(f64x4::splat(2.0));
    let chosen = Dual::select(lanes.simd_gt(two), lanes * lanes, two * lanes);
    assert_eq!(chosen.derivative().to_array(), [6.0, 2.0, 2.0, 2.0]);
}

/// The slope of a square root at zero is infinite, but a zero that does not change has a root that does not change.
#[test]
fn the_root_of_zero_has_the_derivative_of_what_does_not_change() {
    let [x, y] = Dual::variables([0.0f64, 3.0]);
    assert_eq!(Dual::<f64, 2>::default().sqrt(), Dual::default());
    assert!(!x.sqrt().is_finite());
    // The length of a vector of zero has a kink.
    assert_eq!((x * x).sqrt(), Dual::default());
    // Each derivative separately.
    assert_eq!((x * y).sqrt().derivatives.map(f64::is_finite), [false, true]);
    assert_eq!((x * y).sqrt().derivatives[1], 0.0);
    assert!((-y).sqrt().value.is_nan());
    assert!((-y).sqrt().derivatives[1].is_nan());
    assert!(Dual::new(0.0, [f64::NAN]).sqrt().derivative().is_nan());

    // Each lane separately, with the bits of numbers.
    let (values, slopes) = ([4.0, 0.0, 0.0, -0.0], [1.0, 0.0, 2.0, -0.0]);
    let lanes = Dual::new(f64x4::new(values), [f64x4::new(slopes)]).sqrt();
    for lane in 0..4 {
        let number = Dual::new(values[lane], [slopes[lane]]).sqrt();
        assert_eq!(lanes.value.to_array()[lane].to_bits(), number.value.to_bits());
        let derivative = lanes.derivative().to_array()[lane];
        assert_eq!(derivative.to_bits(), number.derivative().to_bits());
    }
    assert_eq!(lanes.derivative().to_array(), [0.25, 0.0, f64::INFINITY, 0.0]);

    // Second derivatives: of a constant, and of a length with a kink, whose slope jumps.
    let second = Dual::variable(Dual::variable(0.0f64));
    assert_eq!((second - second).sqrt(), Dual::default());
    let length = (second * second).sqrt();
    assert_eq!((length.value.value, length.derivative().value), (0.0, 0.0));
    assert!(!length.derivative().derivative().is_finite());
}

/// The angle depends on the direction only: scaling by powers of two scales its derivative by their inverse.
#[test]
fn the_derivative_of_an_angle_neither_overflows_nor_vanishes() {
    let gradient = |y: f64, x: f64| {
        let [y, x] = Dual::variables([y, x]);
        y.atan2(x).derivatives
    };
    for (y, x) in [(0.3, 0.7), (-2.0, 0.1), (1.0, -3.0), (0.0, -1.0)] {
        let near = gradient(y, x);
        assert!((near[0] - x / (x * x + y * y)).abs() < 1e-15 * 50.0);
        for scale in [2f64.powi(900), 2f64.powi(-900)] {
            assert_eq!(gradient(y * scale, x * scale).map(|slope| slope * scale), near);
        }
    }
    assert!(!Dual::<f64>::variable(0.0).atan2(Dual::from(0.0)).is_finite());
}

#[test]
fn a_number_is_finite_if_its_derivatives_are() {
    assert!(Dual::new(1.0f64, [2.0, 3.0]).is_finite());
    assert!(!Dual::new(1.0f64, [2.0, f64::NAN]).is_finite());
    assert!(!Dual::new(f64::INFINITY, [2.0, 3.0]).is_finite());
    let lanes = Dual::new(f64x4::splat(1.0), [f64x4::new([0.0, f64::NAN, 1.0, f64::INFINITY])]);
    let kept = f64x4::select(lanes.is_finite(), f64x4::splat(1.0), f64x4::splat(0.0));
    assert_eq!(kept.to_array(), [1.0, 0.0, 1.0, 0.0]);
}

mstmm_chain! {
    chain Passing {
        body Car { mass = 1 kg; com = [0, 0, 0] m; inertia = diag(1, 1, 1) kg*m^2 about com; }
        ground -> slider(x) track -> Car car;
        spring cord { on = car.com; to = [0, 0, 0] m; stiffness = 2 N/m; length = 0.5 m; }
    }
}

/// The ends of the spring coincide: no force, and the derivative of a length that is smoothed over 1e-15 m.
#[test]
fn a_spring_whose_ends_coincide_has_finite_derivatives() -> Result<(), Error> {
    let chain = Passing::<Dual<f64>>::new();
    let derivative = |place: Dual<f64>| {
        let (mut state, mut rate) = (chain.initial_state(), chain.initial_state());
        state.coordinates_mut().fill(place);
        chain.derivative_into(&state, &chain.no_inputs(), &mut rate)?;
        Ok(rate.rates()[0])
    };
    let still = derivative(Dual::from(0.0))?;
    assert_eq!((still.value, still.derivative()), (0.0, 0.0));
    let (jump, smooth) = (derivative(Dual::variable(0.0))?, derivative(Dual::variable(0.7))?);
    assert_eq!(jump.value, 0.0);
    assert!((jump.derivative() * 1e-15 - 2.0 * 0.5).abs() < 1e-12);
    // k (x − L) beyond the jump.
    assert!((smooth.value + 2.0 * 0.2).abs() < 1e-14 && (smooth.derivative() + 2.0).abs() < 1e-14);
    Ok(())
}

mstmm_chain! {
    chain Arm {
        gravity = [0.5, -0.3, -9.81] m/s^2;
        param load = 3 kg;

        body Link {
            mass = 2 kg;
            com = [0.2, 0.01, 0.02] m;
            inertia = diag(0.01, 0.05, 0.05) kg*m^2 about com;
            output = [0.5, 0, 0.1] m;
        }
        body Tip {
            mass = load;
            com = [0.3, 0.1, 0] m;
            inertia = diag(0.03, 0.02, 0.04) kg*m^2 about com;
        }

        ground -> universal(y, z) shoulder -> Link upper -> ball elbow -> Link lower
               -> pin(x) wrist -> Tip hand;

        hinge shoulder { torque = input; }
        hinge wrist { stiffness = 20 N*m/rad; damping = 0.3 N*m*s/rad; friction = 0.5 N*m; friction_speed = 0.1 rad/s; }
    }
}

/// The accelerations as functions of a displacement of all coordinates and rates, an input and a parameter.
fn accelerations<T: Scalar>(seed: u64, [along, torque, load]: [T; 3]) -> Result<[T; 6], Error> {
    let mut chain = Arm::<T>::new();
    chain.set_load(T::constant(3.0) + load)?;
    let mut random = Random::new(seed);
    let mut state = chain.initial_state();
    let mut random = |spread: f64| T::constant(random.between(-spread, spread));
    state.coordinates_mut().iter_mut().for_each(|q| *q += random(0.3));
    chain.normalize(&mut state);
    state.coordinates_mut().iter_mut().for_each(|q| *q += along * random(1.0));
    state.rates_mut().iter_mut().for_each(|v| *v = random(2.0) + along * random(1.0));
    let mut inputs = chain.no_inputs();
    inputs.shoulder = [torque, T::default()].into();
    let mut rate = chain.initial_state();
    chain.derivative_into(&state, &inputs, &mut rate)?;
    let mut found = [T::default(); 6];
    found.copy_from_slice(rate.rates());
    Ok(found)
}

/// Quaternions, setters of parameters, friction and all passes of the generator are in the code of the chain. The
/// quaternion leaves unit length by the displacement.
#[test]
fn accelerations_of_a_generated_chain_have_exact_derivatives() -> Result<(), Error> {
    let mut largest = 0.0f64;
    for seed in 0..20 {
        let duals = accelerations(seed, Dual::variables([0.0f64; 3]))?;
        let expected = differences([0.0; 3], |at| accelerations(seed, at).expect("regular"));
        let values = accelerations(seed, [0.0f64; 3])?;
        let lanes = accelerations(seed, Dual::variables([NativeF64::constant(0.0); 3]))?;
        let size = expected.as_flattened().iter().fold(1.0f64, |size, x| size.max(x.abs()));
        for n in 0..6 {
            assert_eq!(duals[n].value.to_bits(), values[n].to_bits(), "seed {seed}");
            // Some thousand operations.
            let off = distance(duals[n].derivatives, expected[n]) / size;
            assert!(off < 1e-13, "seed {seed}: {n} off by {off:e}");
            largest = largest.max(off);
            let lane = lanes[n].derivatives.map(|derivative| derivative.max_lane().to_bits());
            assert_eq!(lane, duals[n].derivatives.map(f64::to_bits), "seed {seed}: {n}");
        }
    }
    println!("off by {largest:.1e}");
    Ok(())
}
