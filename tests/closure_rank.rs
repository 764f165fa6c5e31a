//! The rank of a loop constraint is a property of the linkage. It is found also if parameters or Rust constants
//! define the geometry and if motions are prescribed; an error names the closing hinge if the rank changes.

use mstmm::prelude::*;
use mstmm::{ChainState, GeneratedChain, HingeMotion, PinState, Scalar};

/// Bennett's linkage, whose bars are as long as the sines of their twists. The three texts differ in where
/// the lengths come from.
macro_rules! bennett {
    ($name:ident, $method:ident, [$($parameter:tt)*], $short:expr, $long:expr) => {
        mstmm_chain! {
            pub chain $name {
                method = $method;
                $($parameter)*
                body Short {
                    mass = 1 kg; com = [0.5, 0.1, 0.05] m; inertia = diag(0.05, 0.1, 0.12) kg*m^2 about com;
                    output = [$short, 0, 0] turned rpy(30, 0, 0) deg;
                }
                body Long {
                    mass = 1.5 kg; com = [0.7, 0, 0.1] m; inertia = diag(0.06, 0.2, 0.22) kg*m^2 about com;
                    output = [$long, 0, 0] turned rpy(45, 0, 0) deg;
                }
                ground -> pin a -> Short first -> pin b -> Long second -> pin c -> Short third
                    -> pin d -> ground at [-$long, 0, 0] turned rpy(-45, 0, 0) deg;
                hinge a { start = 80 deg; start_rate = 2 rad/s; }
                hinge b { start = 155 deg; }
                hinge c { start = -80 deg; }
                hinge d { start = -155 deg; }
            }
        }
    };
}

mod unrolled {
    use super::*;
    bennett!(Bennett, riccati, [], (1), (sqrt(2)));
    bennett!(Twice, riccati, [], (2), (2 * sqrt(2)));
}

mod parametric {
    use super::*;
    bennett!(Bennett, riccati, [param size = 1; param _load = 1 kg;], (size), (size * sqrt(2)));
    bennett!(ByTransfer, transfer, [param size = 1; param _load = 1 kg;], (size), (size * sqrt(2)));
}

mod constant {
    use super::*;

    const LONG: f64 = std::f64::consts::SQRT_2;

    bennett!(Bennett, riccati, [], (1), (LONG));
    bennett!(ByTransfer, transfer, [], (1), (LONG));
}

/// An assembled state after some motion.
fn moved<C: GeneratedChain>(chain: &C, steps: usize) -> C::State {
    let mut state = chain.initial_state();
    chain.assemble(&mut state, &chain.no_inputs()).expect("bars that fit");
    let mut rk4 = Rk4::new(C::Scalar::constant(0.01));
    for _ in 0..steps {
        rk4.step(chain, &mut state, |_, _| chain.no_inputs()).expect("a step");
    }
    state
}

/// The accelerations in a state of one chain by another one of the same linkage; redundant directions.
macro_rules! accelerations_as {
    ($scalar:ty, $chain:expr, $workspace:ty, $state:expr) => {{
        let (chain, from) = ($chain, $state);
        let mut state = chain.initial_state();
        state.coordinates_mut().copy_from_slice(from.coordinates());
        state.rates_mut().copy_from_slice(from.rates());
        let mut at: $workspace = chain.workspace();
        chain.solve_into(&state, &chain.no_inputs(), &mut at).expect("a regular state");
        let accelerations: Vec<f64> =
            at.accelerations().iter().map(|&x: &$scalar| f64::from(x)).collect();
        (accelerations, at.closure().redundant())
    }};
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Accelerations are some ten rad/s²; a state takes about a thousand operations, and the closure's singular
/// values are within a tenth of each other.
const TOLERANCE: f64 = 10.0 * 1000.0;

macro_rules! same_as_written {
    ($scalar:ty) => {
        let tolerance = TOLERANCE * f64::from(<$scalar>::EPSILON);
        let check = |label: &str, (expected, _): (Vec<f64>, usize), found: (Vec<f64>, usize)| {
            let off = largest_difference(&expected, &found.0);
            assert!(off < tolerance, "{label}: {off:e}");
            assert_eq!(found.1, 3, "{label}");
        };
        for steps in [0, 60, 200] {
            let state = moved(&unrolled::Bennett::<$scalar>::new(), steps);
            let truth = || {
                accelerations_as!(
                    $scalar,
                    unrolled::Bennett::new(),
                    unrolled::BennettWorkspace<_>,
                    &state
                )
            };
            let mut resized = parametric::Bennett::new();
            resized.set_size(2.0).expect("a size");
            resized.set_size(1.0).expect("a size");
            resized.set__load(5.0).expect("a mass");
            check(
                "parameter",
                truth(),
                accelerations_as!(
                    $scalar,
                    parametric::Bennett::new(),
                    parametric::BennettWorkspace<_>,
                    &state
                ),
            );
            check(
                "set twice",
                truth(),
                accelerations_as!($scalar, resized, parametric::BennettWorkspace<_>, &state),
            );
            check(
                "parameter, transfer",
                truth(),
                accelerations_as!(
                    $scalar,
                    parametric::ByTransfer::new(),
                    parametric::ByTransferWorkspace<_>,
                    &state
                ),
            );
            check(
                "constant",
                truth(),
                accelerations_as!(
                    $scalar,
                    constant::Bennett::new(),
                    constant::BennettWorkspace<_>,
                    &state
                ),
            );
            check(
                "constant, transfer",
                truth(),
                accelerations_as!(
                    $scalar,
                    constant::ByTransfer::new(),
                    constant::ByTransferWorkspace<_>,
                    &state
                ),
            );
            let state = moved(&unrolled::Twice::<$scalar>::new(), steps);
            let mut twice = parametric::Bennett::new();
            twice.set_size(2.0).expect("a size");
            let truth = accelerations_as!(
                $scalar,
                unrolled::Twice::new(),
                unrolled::TwiceWorkspace<_>,
                &state
            );
            check(
                "set to two",
                truth,
                accelerations_as!($scalar, twice, parametric::BennettWorkspace<_>, &state),
            );
        }
    };
}

#[test]
fn parameters_and_constants_equal_literals() {
    same_as_written!(f64);
}

#[test]
fn parameters_and_constants_equal_literals_in_single_precision() {
    same_as_written!(f32);
}

/// A motion through flat poses and back, with stages that violate the constraint by a thousandth: a linkage
/// that became rigid there would lose its energy at once.
#[test]
fn a_linkage_with_parameters_keeps_its_energy() {
    let mut chain = parametric::Bennett::<f64>::new();
    chain.set_size(1.5).expect("a size");
    let mut state = chain.initial_state();
    chain.assemble(&mut state, &chain.no_inputs()).expect("bars that fit");
    assert!(state.a().rate() > 1.0, "{}", state.a().rate());
    let energy = |state: &parametric::BennettState<f64>| chain.energy(state).kinetic;
    let start = energy(&state);
    let (mut dopri5, mut worst, mut flat) = (Dopri5::new(1e-10, 1e-10), 0.0_f64, 0);
    while state.time() < 10.0 {
        let before = state.a().angle();
        dopri5.step(&chain, &mut state, |_, _| chain.no_inputs()).expect("a step");
        worst = worst.max((energy(&state) - start).abs() / start);
        flat += usize::from(before.sin().signum() != state.a().angle().sin().signum());
    }
    println!("energy off by {worst:.1e}, {flat} flat positions");
    assert!(worst < 1e-8 && flat >= 3);
}

mstmm_chain! {
    /// Four pins in a plane. A parameter tilts the second out of the plane: then the linkage is rigid. At first
    /// crank and coupler are in line.
    chain Tilted {
        param tilt = 0;
        body Crank {
            mass = 1 kg; com = [0.2, 0, 0] m; inertia = diag(0.01, 0.02, 0.02) kg*m^2 about com;
            output = [1, 0, 0] m;
        }
        body Coupler {
            mass = 2 kg; com = [0.5, 0.1, 0] m; inertia = diag(0.05, 0.2, 0.2) kg*m^2 about com;
            output = [2, 0, 0] m;
        }
        body Rocker {
            mass = 1.5 kg; com = [0.3, 0, 0] m; inertia = diag(0.05, 0.1, 0.1) kg*m^2 about com;
            output = [2.5, 0, 0] m;
        }
        ground -> pin a -> Crank crank -> pin([tilt, 0, 1]) b -> Coupler coupler -> pin c
            -> Rocker rocker -> pin d -> ground at [2, 0, 0] m;
        hinge a { start = 55.8 deg; torque = input; }
        hinge c { start = 138.6 deg; }
    }
}

#[test]
fn a_parameter_may_change_the_rank() {
    let mut chain = Tilted::<f64>::new();
    let inputs = TiltedInputs { a: 1.0 };
    let solve = |chain: &Tilted<f64>| {
        let mut state = chain.initial_state();
        chain.assemble(&mut state, &inputs).expect("a triangle");
        let mut at = chain.workspace();
        chain.solve_into(&state, &inputs, &mut at).expect("a state");
        (at.accelerations()[0], at.closure().redundant())
    };
    let (free, redundant) = solve(&chain);
    assert!(free.abs() > 0.01, "{free:e}");
    assert_eq!(redundant, 3);
    chain.set_tilt(0.3).expect("a direction");
    let (stuck, redundant) = solve(&chain);
    // A torque of one N m on some kg m², to rounding and to what assembling leaves.
    assert!(stuck.abs() < 1e-9, "{stuck:e}");
    assert_eq!(redundant, 2);
    chain.set_tilt(0.0).expect("a direction");
    assert_eq!(solve(&chain), (free, 3));
}

/// An arm that rotates about two axes, translates along its own axis and is held at the point of its base.
/// Without a length it rotates freely, with two independent constraints of three; extended, it cannot rotate.
macro_rules! polar {
    ($name:ident, $method:ident, [$($parameter:tt)*], $rest:expr) => {
        mstmm_chain! {
            pub chain $name {
                method = $method;
                $($parameter)*
                body Cart {
                    mass = 1 kg; com = [0.1, 0.2, 0] m; inertia = diag(0.1, 0.12, 0.13) kg*m^2 about com;
                    output = [$rest, 0, 0] m;
                }
                body Arm {
                    mass = 2 kg; com = [0.3, 0.1, 0.1] m; inertia = diag(0.1, 0.15, 0.18) kg*m^2 about com;
                    output = [0, 0, 0] m;
                }
                ground -> slider(x) shift -> Cart cart -> universal(z, y) turn -> Arm arm
                    -> slider(x) length -> Cart head -> ball hold -> ground at [2 * $rest, 0, 0] m;
                hinge turn { start = [50, -40] deg; }
            }
        }
    };
}

polar!(Polar, riccati, [], 0);
polar!(PolarByTransfer, transfer, [], 0);
polar!(PolarOf, riccati, [param rest = 0;], (rest));

macro_rules! another_rank_is_an_error {
    ($chain:ty) => {
        let chain = <$chain>::new();
        let (mut at, inputs) = (chain.workspace(), chain.no_inputs());
        let mut state = chain.initial_state();
        chain.assemble(&mut state, &inputs).expect("an arm without a length");
        chain.solve_into(&state, &inputs, &mut at).expect("a state");
        assert_eq!(at.closure().redundant(), 1);
        let stretched = || {
            let mut state = chain.initial_state();
            state.coordinates_mut()[..4].copy_from_slice(&[-0.7, 0.0, 0.0, 0.7]);
            state
        };
        let mut state = stretched();
        let error = Err(mstmm::Error::ClosureRank { hinge: "hold" });
        assert_eq!(chain.assemble(&mut state, &inputs), error);
        assert_eq!(state, stretched());
        let stepped = Rk4::new(1e-3).step(&chain, &mut state, |_, _| chain.no_inputs());
        assert_eq!((stepped, state), (error, stretched()));
    };
}

#[test]
fn another_rank_than_around_the_start_is_an_error() {
    another_rank_is_an_error!(Polar<f64>);
    another_rank_is_an_error!(PolarByTransfer<f64>);
    another_rank_is_an_error!(PolarOf<f64>);
}

mstmm_chain! {
    /// Bars that are parallel in pairs; where the prescribed angle of the crank is zero all of them lie in line.
    plane chain Parallelogram {
        body Crank {
            mass = 1 kg; com = [0.2, 0] m; inertia = 0.02 kg*m^2 about com; output = [1, 0] m;
        }
        body Coupler {
            mass = 2 kg; com = [0.5, 0.1] m; inertia = 0.2 kg*m^2 about com; output = [2, 0] m;
        }
        ground -> pin a -> Crank crank -> pin b -> Coupler coupler -> pin c -> Crank rocker
            -> pin d -> ground at [2, 0] m;
        hinge a { motion = input; }
        hinge c { start = 180 deg; }
    }
}

/// The coupler keeps its direction, so that the angles of its hinges change as the crank's does.
#[test]
fn a_prescribed_crank_may_rest_in_a_special_position() {
    let chain = Parallelogram::<f64>::new();
    let mut at = chain.workspace();
    for step in 1..60 {
        let (angle, rate, acceleration) = (0.1 * f64::from(step), 0.7, -1.3);
        if angle.sin().abs() < 0.05 {
            continue;
        }
        let motion = HingeMotion { state: PinState::new(angle, rate), acceleration };
        let inputs = ParallelogramInputs { a: motion };
        let mut state = chain.initial_state();
        for (q, value) in
            state.coordinates_mut().iter_mut().zip([-angle, angle + std::f64::consts::PI, -angle])
        {
            *q = value;
        }
        for (v, value) in state.rates_mut().iter_mut().zip([-rate, rate, -rate]) {
            *v = value;
        }
        chain.solve_into(&state, &inputs, &mut at).expect("a regular state");
        let expected = [-acceleration, acceleration, -acceleration];
        let off = largest_difference(at.accelerations().as_slice(), &expected);
        // Singular values down to the sine of the angle.
        assert!(off < 1e-11, "{angle}: {off:e}");
        assert_eq!(at.closure().redundant(), 0, "{angle}");
    }
}
