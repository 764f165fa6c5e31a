//! `answers = [kinematics, jacobian]`: generated types against the workspace, in both precisions and in lanes.

use mstmm::description::Origin;
use mstmm::nalgebra::{Rotation3, SMatrix, SVector, Vector2, Vector3};
use mstmm::prelude::*;
use mstmm::{Error, HingeMotion, PinState, Scalar, SliderState, mstmm_chain};
use mstmm_reference::Random;

mstmm_chain! {
    /// A repeated part with a branch, a channel from the previous repetition, and branches behind the last one.
    chain Ladder {
        gravity = [1, -9.8, 2] m/s^2;
        answers = [jacobian, mass_matrix];
        param reach = 0.6 m;
        param lift = 0.3;
        body Link {
            mass = 1 kg;
            com = [0.5 * reach, 0.1 m, 0 m];
            output = [reach, 0 m, 0.2 m] turned rpy(20, -30, 50) deg;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
            point side = [0.2, 0.5, -0.1] m turned rpy(0, lift, 0.1);
            point tip = [0.1, 0.3, 0.2] m turned rpy(30, 0, 10) deg;
        }
        ground at [0, 1, 0] m -> universal base -> Link beam -> repeat 3 from right.side = beam.side {
            pin(x) a -> Link left;
            last.right.side -> ball b -> Link right;
            left.side -> pin(y) c -> Link rung;
        } -> pin d -> Link weight;
        rung.side -> slider(x) e -> Link bead;
        left.output -> cylindrical f -> Link beside;
    }
    /// Held at its end, with a prescribed hinge and a moving start.
    chain Hung {
        gravity = [0, -9.8, 0] m/s^2;
        answers = [kinematics, jacobian];
        body Rod {
            mass = 1 kg;
            com = [0.3, 0.1, 0] m;
            output = [0.6, 0, 0.2] m turned rpy(20, -30, 50) deg;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
        }
        Rod first -> pin a -> Rod second -> universal(x, z) b -> Rod third -> ball c -> ground at [1, 2, 3] m;
        hinge a { motion = input; }
    }
    plane chain Crane {
        gravity = [0, -9.8] m/s^2;
        answers = basic;
        param reach = 0.5 m;
        body Arm {
            mass = 1 kg; com = [0.3, 0.1] m; inertia = 0.1 kg*m^2 about com;
            output = [0.6, 0.2] m turned 0.3 rad;
            point hook = [reach, 0.1 m] turned 0.2 rad;
        }
        ground -> slider(x) track -> Arm trolley -> repeat 3 { pin joint -> Arm boom };
        trolley.hook -> pin side -> Arm other;
    }
    line chain Train {
        answers = [kinematics, jacobian, mass_matrix];
        body Wagon { mass = 2 kg; output = 1.5 m; point door = 0.5 m; }
        moving front -> slider a -> Wagon one -> repeat 2 { slider b -> Wagon more };
        hinge a { motion = input; }
    }
    chain Arm {
        gravity = [0, 0, -9.8] m/s^2;
        answers = [mass_matrix, jacobian];
        body Link {
            mass = 1 kg; com = [0, 0, 0.2] m; output = [0, 0, 0.4] m;
            inertia = diag(0.02, 0.02, 0.01) kg*m^2 about com;
        }
        ground -> pin(z) a -> Link l1 -> pin(y) b -> Link l2 -> pin(z) c -> Link l3 -> pin(y) d -> Link l4
            -> pin(z) e -> Link l5 -> pin(y) f -> Link l6 -> pin(z) g -> Link l7;
    }
}

/// Poses, velocities and accelerations are sums over at most a dozen hinges, of lengths of about a metre.
const ROUNDINGS: f64 = 500.0;

/// Returns random numbers between −1 and 1 that both precisions have.
fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut random = Random::new(seed);
    move || f64::from(random.between(-1.0, 1.0) as f32)
}

fn stack(a: Vector3<f64>, b: Vector3<f64>) -> SVector<f64, 6> {
    SVector::from([a.x, a.y, a.z, b.x, b.y, b.z])
}

/// Checks that a number is small.
fn near(what: &str, name: &str, off: f64) {
    let limit = ROUNDINGS * f64::EPSILON;
    assert!(off < limit, "{what}: {name} differ by {off:e}");
}

/// Checks that a point of the kinematics moves as a point of the workspace. The kinematics at rest belong to the same state
/// without rates.
macro_rules! agree {
    ($what:expr, [$kin:expr, $rest:expr, $point:expr], $v:expr, $accelerations:expr) => {{
        let (what, kin, rest, point) = (&$what, $kin, $rest, $point);
        near(what, "positions", (kin.position() - point.position()).amax());
        let turned = kin.orientation().matrix() - point.orientation().matrix();
        near(what, "orientations", turned.amax());
        near(what, "velocities", (kin.velocity() - point.velocity()).amax());
        near(what, "rates", (kin.angular_velocity() - point.angular_velocity()).amax());
        let scale = 1.0 + $accelerations.amax();
        let linear = kin.acceleration($accelerations) - point.acceleration();
        near(what, "accelerations", linear.amax() / scale);
        let angular = kin.angular_acceleration($accelerations) - point.angular_acceleration();
        near(what, "angular accelerations", angular.amax() / scale);
        let moved = stack(kin.velocity(), kin.angular_velocity())
            - stack(rest.velocity(), rest.angular_velocity());
        near(what, "J v", (kin.jacobian() * $v - moved).amax());
        near(what, "J x", (kin.jacobian_times(&$v) - moved).amax());
        let (force, moment) = (Vector3::new(1.0, -2.0, 0.5), Vector3::new(-0.3, 0.7, 1.1));
        let efforts = kin.jacobian_transpose_times(force, moment);
        near(what, "Jᵀ f", (kin.jacobian().transpose() * stack(force, moment) - efforts).amax());
    }};
}

/// All bodies of the ladder, by name and index, with all of their points.
#[test]
fn every_point_of_a_ladder_moves_as_in_the_workspace() {
    for seed in 0..20 {
        let mut number = numbers(seed);
        let mut ladder = Ladder::<f64>::new();
        ladder.set_reach(0.6 + 0.1 * number()).expect("a length");
        ladder.set_lift(number()).expect("an angle");
        let mut state = ladder.initial_state();
        state.coordinates_mut().iter_mut().for_each(|q| *q = number());
        state.rates_mut().iter_mut().for_each(|v| *v = number());
        ladder.normalize(&mut state);
        let inputs = ladder.no_inputs();
        let mut at = ladder.workspace();
        ladder.solve_into(&state, &inputs, &mut at).expect("a regular chain");
        let kin = ladder.kinematics(&state, &inputs).expect("finite numbers");
        let mut still = state.clone();
        still.rates_mut().fill(0.0);
        let rest = ladder.kinematics(&still, &inputs).expect("finite numbers");
        let (v, v_dot) = (state.v, at.accelerations());
        macro_rules! body {
            ($body:ident) => {
                body!($body, kin.$body(), rest.$body(), at.$body())
            };
            ($body:ident $index:expr) => {
                body!(
                    $body,
                    kin.$body($index).expect("a body"),
                    rest.$body($index).expect("a body"),
                    at.$body($index).expect("a body")
                )
            };
            ($body:ident, $kin:expr, $rest:expr, $at:expr) => {{
                let (kin, rest, at) = ($kin, $rest, $at);
                let what = format!("seed {seed}, {}", stringify!($body));
                agree!(what, [kin.input(), rest.input(), at.input()], v, v_dot);
                agree!(what, [kin.output(), rest.output(), at.output()], v, v_dot);
                agree!(what, [kin.com(), rest.com(), at.com()], v, v_dot);
                let place = [0.1, 0.3, 0.2];
                agree!(what, [kin.tip(), rest.tip(), at.tip()], v, v_dot);
                // Hinges leave this point of some bodies. Its frame depends on a parameter.
                agree!(what, [kin.side(), rest.side(), at.side()], v, v_dot);
                assert_eq!(kin.tip().position(), kin.at(place).position());
                assert_eq!(kin.tip().velocity(), kin.at(place).velocity());
                let tip =
                    Rotation3::from_euler_angles(30_f64.to_radians(), 0.0, 10_f64.to_radians());
                let turned = kin.input().orientation() * tip;
                near(&what, "frames", (turned.matrix() - kin.tip().orientation().matrix()).amax());
            }};
        }
        body!(beam);
        body!(weight);
        body!(bead);
        body!(beside);
        for index in 0..3 {
            body!(left index);
            body!(right index);
            body!(rung index);
        }
        assert!(kin.left(3).is_none() && kin.rung(usize::MAX).is_none());
    }
}

/// A chain that is held at its end, with a prescribed hinge: the bodies inboard of a hinge move with its rates.
#[test]
fn a_chain_held_at_its_end_moves_as_in_the_workspace() {
    for seed in 0..20 {
        let mut number = numbers(seed);
        let hung = Hung::<f64>::new();
        let mut state = hung.initial_state();
        state.coordinates_mut().iter_mut().for_each(|q| *q = number());
        state.rates_mut().iter_mut().for_each(|v| *v = number());
        hung.normalize(&mut state);
        let mut inputs = hung.no_inputs();
        let pin = PinState::new(number(), number());
        inputs.a = HingeMotion { state: pin, acceleration: number() };
        let mut at = hung.workspace();
        hung.solve_into(&state, &inputs, &mut at).expect("a regular chain");
        let kin = hung.kinematics(&state, &inputs).expect("finite numbers");
        let mut still = state.clone();
        still.rates_mut().fill(0.0);
        let rest = hung.kinematics(&still, &inputs).expect("finite numbers");
        let (v, v_dot) = (state.v, at.accelerations());
        macro_rules! body {
            ($body:ident) => {
                let what = format!("seed {seed}, {}", stringify!($body));
                let points = [kin.$body().input(), kin.$body().output(), kin.$body().com()];
                agree!(what, [points[0], rest.$body().input(), at.$body().input()], v, v_dot);
                agree!(what, [points[1], rest.$body().output(), at.$body().output()], v, v_dot);
                agree!(what, [points[2], rest.$body().com(), at.$body().com()], v, v_dot);
            };
        }
        body!(first);
        body!(second);
        body!(third);
        // The ball is between the ground and all bodies, the universal only inboard of it; its rates come first.
        let moved =
            |jacobian: SMatrix<f64, 6, 5>| [0, 1, 2, 3, 4].map(|j| jacobian.column(j).amax() > 0.0);
        assert_eq!(moved(kin.third().com().jacobian()), [false, false, true, true, true]);
        assert_eq!(moved(kin.first().com().jacobian()), [true; 5]);
        let moving = stack(rest.first().com().velocity(), rest.first().com().angular_velocity());
        assert!(moving.amax() > 0.0, "the prescribed hinge moves the first body");
    }
}

/// The plane and the line, in lanes: every lane has the bits of a single state.
#[test]
fn points_of_a_crane_move_as_in_the_workspace() {
    for seed in 0..20 {
        let mut number = numbers(seed);
        let mut crane = Crane::<f64>::new();
        crane.set_reach(0.5 + 0.1 * number()).expect("a length");
        let mut state = crane.initial_state();
        state.coordinates_mut().iter_mut().for_each(|q| *q = number());
        state.rates_mut().iter_mut().for_each(|v| *v = number());
        let inputs = crane.no_inputs();
        let mut at = crane.workspace();
        crane.solve_into(&state, &inputs, &mut at).expect("a regular chain");
        let kin = crane.kinematics(&state, &inputs).expect("finite numbers");
        let v_dot = at.accelerations();
        let check = |what: &str, kin: PlaneKin, point: mstmm::PlanePoint<f64>| {
            let what = format!("seed {seed}, {what}");
            near(&what, "positions", (kin.position() - point.position()).amax());
            let turned = kin.orientation().matrix() - point.orientation().matrix();
            near(&what, "orientations", turned.amax());
            near(&what, "velocities", (kin.velocity() - point.velocity()).amax());
            near(&what, "rates", (kin.angular_velocity() - point.angular_velocity()).abs());
            let moved: Vector3<f64> = kin.jacobian() * state.v;
            let velocity = kin.velocity();
            let expected = Vector3::new(velocity.x, velocity.y, kin.angular_velocity());
            near(&what, "J v", (moved - expected).amax());
            near(&what, "J x", (kin.jacobian_times(&state.v) - expected).amax());
            let scale = 1.0 + v_dot.amax();
            near(
                &what,
                "accelerations",
                (kin.acceleration(v_dot) - point.acceleration()).amax() / scale,
            );
            let angular = kin.angular_acceleration(v_dot) - point.angular_acceleration();
            near(&what, "angular accelerations", angular.abs() / scale);
            let efforts = kin.jacobian_transpose_times(Vector2::new(2.0, -1.0), 0.5);
            let expected = kin.jacobian().transpose() * Vector3::new(2.0, -1.0, 0.5);
            near(&what, "Jᵀ f", (efforts - expected).amax());
        };
        check("trolley", kin.trolley().input(), at.trolley().input());
        check("trolley", kin.trolley().output(), at.trolley().output());
        check("trolley", kin.trolley().hook(), at.trolley().hook());
        check("other", kin.other().output(), at.other().output());
        // No hinge leaves this hook.
        let (hook, point) = (kin.other().hook(), at.other().hook());
        near(
            "hook",
            "orientations",
            (hook.orientation().matrix() - point.orientation().matrix()).amax(),
        );
        near("hook", "positions", (hook.position() - point.position()).amax());
        for index in 0..3 {
            let (Some(kin), Some(at)) = (kin.boom(index), at.boom(index)) else { panic!() };
            check("boom", kin.input(), at.input());
            check("boom", kin.output(), at.output());
        }
    }
}

type PlaneKin<'a> =
    mstmm::PointKinematics<mstmm::PlaneMotion<'a, f64>, 5, mstmm::RateColumns<'a, f64>>;

#[test]
fn wagons_move_as_in_the_workspace() {
    let train = Train::<f64>::new();
    let mut state = train.initial_state();
    state.coordinates_mut().copy_from_slice(&[0.3, -0.2]);
    state.rates_mut().copy_from_slice(&[1.5, -0.7]);
    let mut inputs = train.no_inputs();
    inputs.a = HingeMotion { state: SliderState::new(0.1, 2.0), acceleration: 3.0 };
    inputs.front = HingeMotion { state: SliderState::new(4.0, -0.5), acceleration: 0.25 };
    let mut at = train.workspace();
    train.solve_into(&state, &inputs, &mut at).expect("a regular chain");
    let kin = train.kinematics(&state, &inputs).expect("finite numbers");
    let v_dot = at.accelerations();
    let (kin, last) = (kin.more(1).expect("a wagon"), at.more(1).expect("a wagon"));
    assert_eq!(kin.output().position(), last.output().position());
    assert_eq!(kin.door().position(), last.door().position());
    assert_eq!(kin.input().velocity(), last.input().velocity());
    assert_eq!(kin.input().velocity(), 2.0 - 0.5 + 1.5 - 0.7);
    assert_eq!(kin.input().bias_acceleration(), 3.25);
    assert!((kin.input().acceleration(v_dot) - last.input().acceleration()).abs() < 1e-14);
    assert_eq!(kin.input().jacobian(), SMatrix::<f64, 1, 2>::new(1.0, 1.0));
    assert_eq!(kin.input().jacobian_transpose_times(3.0), SVector::from([3.0, 3.0]));
    let inertia = train.operational_space_inertia(&state, &inputs, &kin.input());
    // The force moves only the last wagon: the one before it is held by the prescribed hinge.
    assert!((inertia.expect("a regular point")[(0, 0)] - 2.0).abs() < 1e-14);
}

/// Returns the arm in a bent pose.
fn bent<T: Scalar>(seed: u64) -> (Arm<T>, ArmState<T>) {
    let mut number = numbers(seed);
    let arm = Arm::<T>::new();
    let mut state = arm.initial_state();
    let mut draw = || T::constant(number());
    state.coordinates_mut().iter_mut().for_each(|q| *q = draw());
    state.rates_mut().iter_mut().for_each(|v| *v = draw());
    (arm, state)
}

/// A force and a moment at the tip accelerate it as the inverse inertia says, and the inertia gives them back.
#[test]
fn the_inertia_at_a_point_is_that_which_a_wrench_feels() {
    for seed in 0..20 {
        let (arm, state) = bent::<f64>(seed);
        let inputs = arm.no_inputs();
        let kin = arm.kinematics(&state, &inputs).expect("finite numbers");
        let tip = kin.l7().output();
        let inverse = arm.inverse_operational_space_inertia(&state, &inputs, &tip);
        let inverse = inverse.expect("a regular chain");
        let wrench = SVector::from([1.0, -2.0, 0.5, 0.1, 0.2, -0.3]);
        let (force, moment) = (Vector3::new(1.0, -2.0, 0.5), Vector3::new(0.1, 0.2, -0.3));
        let efforts = tip.jacobian_transpose_times(force, moment);
        let rates = arm.inverse_mass_matrix_times(&state, &inputs, &efforts).expect("regular");
        let moved = tip.jacobian_times(&rates);
        let scale = moved.amax();
        assert!((inverse * wrench - moved).amax() < 1e-12 * scale, "seed {seed}");
        let inertia = arm.operational_space_inertia(&state, &inputs, &tip).expect("a regular pose");
        let lost = inertia.amax() * inverse.amax() * f64::EPSILON;
        assert!((inertia * moved - wrench).amax() < 100.0 * lost, "seed {seed}");
        assert_eq!(inertia, inertia.transpose());
    }
}

#[test]
fn a_point_that_cannot_move_in_every_direction_has_no_inertia() {
    let (arm, mut state) = bent::<f64>(1);
    let inputs = arm.no_inputs();
    let singular = Err(Error::SingularMatrix);
    let kin = arm.kinematics(&state, &inputs).expect("finite numbers");
    // Five hinges are too few.
    let inertia = arm.operational_space_inertia(&state, &inputs, &kin.l5().output());
    assert_eq!(inertia, singular);
    // All axes of a straight arm are in one plane.
    state.coordinates_mut().fill(0.0);
    let kin = arm.kinematics(&state, &inputs).expect("finite numbers");
    let inertia = arm.operational_space_inertia(&state, &inputs, &kin.l7().output());
    assert_eq!(inertia, singular);
}

#[test]
fn values_that_are_not_finite_leave_the_kinematics_empty() {
    let (arm, state) = bent::<f64>(1);
    let inputs = arm.no_inputs();
    for number in [f64::NAN, f64::INFINITY] {
        for entry in 0..7 {
            let mut kin = arm.kinematics(&state, &inputs).expect("finite numbers");
            let mut wrong = state.clone();
            wrong.rates_mut()[entry] = number;
            assert_eq!(
                arm.kinematics_into(&wrong, &inputs, &mut kin),
                Err(Error::NotFinite(Origin::Rate(entry)))
            );
            assert_eq!(kin, ArmKinematics::default());
            let mut wrong = state.clone();
            wrong.coordinates_mut()[entry] = number;
            assert_eq!(
                arm.kinematics(&wrong, &inputs).err(),
                Some(Error::NotFinite(Origin::Coordinate(entry)))
            );
        }
    }
}

/// Single precision, and each lane, see the same point.
#[test]
fn lanes_and_single_precision_agree_with_double_precision() {
    use mstmm::wide::f64x4;
    let (arm, state) = bent::<f64>(3);
    let tip = arm.kinematics(&state, &arm.no_inputs()).expect("finite numbers");
    let tip = tip.l7().output();
    let (small, small_state) = bent::<f32>(3);
    let kin = small.kinematics(&small_state, &small.no_inputs()).expect("finite numbers");
    let jacobian = kin.l7().output().jacobian().map(f64::from);
    assert!((jacobian - tip.jacobian()).amax() < ROUNDINGS * f64::from(f32::EPSILON));
    let (wide, wide_state) = bent::<f64x4>(3);
    let kin = wide.kinematics(&wide_state, &wide.no_inputs()).expect("finite numbers");
    let point = kin.l7().output();
    for lane in 0..4 {
        assert_eq!(point.jacobian().map(|x| x.to_array()[lane]), tip.jacobian());
        assert_eq!(point.position().map(|x| x.to_array()[lane]), tip.position());
        let bias = point.bias_acceleration().map(|x| x.to_array()[lane]);
        assert_eq!(bias, tip.bias_acceleration());
    }
    let inertia = wide.operational_space_inertia(&wide_state, &wide.no_inputs(), &point);
    let expected = arm.operational_space_inertia(&state, &arm.no_inputs(), &tip);
    let inertia = inertia.expect("a regular pose").map(|x| x.to_array()[0]);
    assert_eq!(inertia, expected.expect("a regular pose"));
}
