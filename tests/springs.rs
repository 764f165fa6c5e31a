//! Springs, limits and rotors of every kind of hinge conserve energy; dampers and friction dissipate the
//! power given by their rates. Exact, by dual numbers.

mod springs {
    mod actuators;
}
mod support;

use mstmm::nalgebra::{Vector2, Vector3};
use mstmm::prelude::*;
use mstmm::{Dual, Scalar, SpringResult};
use mstmm_reference::Random;
use support::mechanism::random_quaternion;
use support::moving::energy_rate;
use support::worst;

/// dE/dt is a difference of terms of up to some thousand W, each of a hundred roundings.
const TOLERANCE: f64 = 1e-13;
const LARGEST_POWER: f64 = 1e3;

/// A chain with the hinge between two pins, with everything that keeps energy, and the same with
/// all that takes some; what that is, `power` says from q̇ and v of the hinge.
macro_rules! springs {
    ($(
        $test:ident, $elastic:ident $lossy:ident, $dimension:ident [$($hinge:tt)*]
        { $($kept:tt)* } { $($lost:tt)* }
        $coordinates:literal, quaternion $quaternion:tt;
        power($q_rate:ident, $v:ident) $power:expr;
    )*) => { $(
        springs! { @chain $dimension $elastic [$($hinge)*] { $($kept)* } }
        springs! { @chain $dimension $lossy [$($hinge)*] { $($kept)* $($lost)* } }

        #[test]
        fn $test() {
            let (kept, same) = ($elastic::<f64>::new(), $elastic::<Dual<f64>>::new());
            let (lost, alike) = ($lossy::<f64>::new(), $lossy::<Dual<f64>>::new());
            let mut largest = 0.0;
            for seed in 0..50 {
                let mut random = Random::new(seed);
                let mut q: Vec<f64> =
                    (0..1 + $coordinates).map(|_| random.between(-0.8, 0.8)).collect();
                if $quaternion {
                    q.extend(random_quaternion(&mut random));
                }
                q.push(random.between(-3.0, 3.0));
                let mut state = kept.initial_state();
                state.coordinates_mut().copy_from_slice(&q);
                state.rates_mut().iter_mut().for_each(|rate| *rate = random.between(-2.0, 2.0));
                let rate = energy_rate(&kept, &same, &state, &kept.no_inputs());

                let mut damped = lost.initial_state();
                damped.coordinates_mut().copy_from_slice(state.coordinates());
                damped.rates_mut().copy_from_slice(state.rates());
                let mut moving = lost.initial_state();
                lost.configuration_rate_into(&damped, &mut moving);
                let ($q_rate, $v) = (&moving.coordinates()[1..], &damped.rates()[1..]);
                let taken: f64 = $power;
                let loss = energy_rate(&lost, &alike, &damped, &lost.no_inputs());
                let off = worst(rate.abs(), (loss + taken).abs()) / LARGEST_POWER;
                assert!(off < TOLERANCE, "seed {seed}: {rate:e}, {loss} of {taken}");
                largest = worst(largest, off);
            }
            println!("{}: off by {largest:.1e}", stringify!($elastic));
        }
    )* };
    (@chain space $name:ident [$($hinge:tt)*] { $($fields:tt)* }) => {
        mstmm_chain! { chain $name {
            gravity = [1, -9.8, 2] m/s^2;
            body Link {
                mass = 1.5 kg;
                com = [0.2, -0.1, 0.1] m;
                output = [0.5, 0.1, -0.2] m turned rpy(20, -30, 50) deg;
                inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
            }
            ground -> pin(x) near -> Link first -> $($hinge)* joint -> Link second
                -> pin([1, 2, 3]) far -> Link third;
            spring rope { on = third; at = output; to = [1, 1, 1] m; stiffness = 20; length = 0.3; }
            hinge joint { $($fields)* }
        } }
    };
    (@chain plane $name:ident [$($hinge:tt)*] { $($fields:tt)* }) => {
        mstmm_chain! { plane chain $name {
            gravity = [1, -9.8] m/s^2;
            body Link {
                mass = 1.5 kg;
                com = [0.2, -0.1] m;
                output = [0.5, 0.1] m turned 20 deg;
                inertia = 0.09 kg*m^2 about com;
            }
            ground -> pin near -> Link first -> $($hinge)* joint -> Link second -> pin far
                -> Link third;
            spring rope { on = third; at = output; to = [1, 1] m; stiffness = 20; length = 0.3; }
            hinge joint { $($fields)* }
        } }
    };
}

/// Power that friction takes at a speed.
fn rubbed(friction: f64, speed: f64, smooth: f64) -> f64 {
    friction * speed * speed / speed.hypot(smooth)
}

/// Σ c ṡ²
fn damped<const N: usize>(damping: [f64; N], rates: &[f64]) -> f64 {
    damping.iter().zip(rates).map(|(c, rate)| c * rate * rate).sum()
}

springs! {
    a_pin, Pin PinLossy, space [pin([1, 2, -1])]
    { rest = 20 deg; stiffness = 30; armature = 0.3; limits = [-0.2, 0.3]; limit_stiffness = 90; }
    { damping = 2; friction = 1; friction_speed = 0.1; }
    1, quaternion false;
    power(q, _v) damped([2.0], q) + rubbed(1.0, q[0], 0.1);

    a_slider, Slider SliderLossy, space [slider([0, 1, 1])]
    { rest = 0.2; stiffness = 30; armature = 0.3; limits = [-0.2, 0.3]; limit_stiffness = 90; }
    { damping = 2; friction = 1; friction_speed = 0.1; }
    1, quaternion false;
    power(q, _v) damped([2.0], q) + rubbed(1.0, q[0], 0.1);

    a_screw, Screw ScrewLossy, space [screw(y, 0.3 m/rad)]
    { rest = 0.2; stiffness = 30; armature = 0.3; limits = [-0.2, 0.3]; limit_stiffness = 90; }
    { damping = 2; friction = 1; friction_speed = 0.1; }
    1, quaternion false;
    power(q, _v) damped([2.0], q) + rubbed(1.0, q[0], 0.1);

    a_cylindrical_hinge, Cylindrical CylindricalLossy, space [cylindrical(x)]
    {
        rest = 0.2 m turned 20 deg; stiffness = 30; armature = 0.3; turning_stiffness = 5;
        turning_armature = 0.1; turning_limits = [-0.2, 0.3]; turning_limit_stiffness = 90;
    }
    { damping = 2; turning_damping = 0.3; turning_friction = 1; turning_friction_speed = 0.1; }
    2, quaternion false;
    power(q, _v) damped([2.0, 0.3], q) + rubbed(1.0, q[1], 0.1);

    a_universal_hinge, Universal UniversalLossy, space [universal(x, [1, 2, 0])]
    {
        rest = [0.2, 0.1]; stiffness = [30, 20]; armature = [0.3, 0.1]; limits = [-0.2, 0.3];
        limit_stiffness = 90;
    }
    { damping = [2, 1]; friction = [1, 0.5]; friction_speed = 0.1; }
    2, quaternion false;
    power(q, _v) damped([2.0, 1.0], q) + rubbed(1.0, q[0], 0.1) + rubbed(0.5, q[1], 0.1);

    a_gimbal, Gimbal GimbalLossy, space [gimbal(x, [1, 2, 0], z)]
    {
        rest = [0.2, 0.1, 0.3]; stiffness = [30, 20, 10]; armature = [0.3, 0.1, 0.2];
        limits = [-0.2, 0.3]; limit_stiffness = 90;
    }
    { damping = [2, 1, 3]; friction = [1, 0.5, 2]; friction_speed = 0.1; }
    3, quaternion false;
    power(q, _v) {
        let rubbed = rubbed(1.0, q[0], 0.1) + rubbed(0.5, q[1], 0.1) + rubbed(2.0, q[2], 0.1);
        damped([2.0, 1.0, 3.0], q) + rubbed
    };

    a_ball, Ball BallLossy, space [ball]
    {
        rest = rpy(10, 20, 30) deg; stiffness = 30; armature = 0.3; limits = 40 deg;
        limit_stiffness = 90;
    }
    { damping = 2; friction = 1; friction_speed = 0.1; }
    0, quaternion true;
    power(_q, v) {
        let speed = v[0].hypot(v[1]).hypot(v[2]);
        damped([2.0; 3], &v[..3]) + rubbed(1.0, speed, 0.1)
    };

    a_planar_hinge, Planar PlanarLossy, space [planar(x)]
    {
        rest = [0.2, 0.1] m turned 10 deg; stiffness = [30, 20]; turning_stiffness = 5;
        armature = [0.3, 0.1]; turning_armature = 0.2; limits = [-0.2, 0.3]; limit_stiffness = 90;
    }
    { damping = [2, 1]; turning_damping = 0.5; turning_friction = 1; turning_friction_speed = 0.1; }
    3, quaternion false;
    power(q, _v) damped([2.0, 1.0, 0.5], q) + rubbed(1.0, q[2], 0.1);

    a_floating_hinge, Floating FloatingLossy, space [floating]
    {
        rest = [0.2, 0.1, 0] m turned rpy(10, 20, 30) deg; stiffness = [30, 20, 10];
        turning_stiffness = 5; armature = 0.3; turning_armature = 0.2; limits = [-0.2, 0.3];
        limit_stiffness = 90; turning_limits = 40 deg; turning_limit_stiffness = 30;
    }
    { damping = [2, 1, 3]; turning_damping = 0.5; friction = 1; friction_speed = 0.2; }
    3, quaternion true;
    power(_q, v) damped([2.0, 1.0, 3.0, 0.5, 0.5, 0.5], &v[..6])
        + v[..3].iter().map(|&speed| rubbed(1.0, speed, 0.2)).sum::<f64>();

    an_elastic_hinge, Elastic ElasticLossy, space [elastic]
    {
        rest = [0.2, 0.1, 0] m turned rpy(10, 20, 30) deg; stiffness = [30, 20, 10];
        turning_stiffness = [5, 6, 7]; armature = [0.3, 0.2, 0.1];
        turning_armature = [0.2, 0.3, 0.1]; limits = [-0.2, 0.3]; limit_stiffness = 90;
        turning_limits = [-0.4, 0.4]; turning_limit_stiffness = 30;
    }
    {
        damping = [2, 1, 3]; turning_damping = [0.5, 0.6, 0.7]; friction = 1; friction_speed = 0.2;
        turning_friction = [0.1, 0.2, 0.3]; turning_friction_speed = 0.2;
    }
    6, quaternion false;
    power(q, _v) damped([2.0, 1.0, 3.0, 0.5, 0.6, 0.7], q)
        + (0..6).map(|k| rubbed([1.0, 1.0, 1.0, 0.1, 0.2, 0.3][k], q[k], 0.2)).sum::<f64>();

    a_planar_hinge_in_the_plane, Flat FlatLossy, plane [planar]
    {
        rest = [0.2, 0.1] m turned 10 deg; stiffness = [30, 20]; turning_stiffness = 5;
        armature = [0.3, 0.1]; turning_armature = 0.2; turning_limits = [-0.2, 0.3];
        turning_limit_stiffness = 90;
    }
    { damping = [2, 1]; turning_damping = 0.5; friction = 1; friction_speed = 0.1; }
    3, quaternion false;
    power(q, _v) damped([2.0, 1.0, 0.5], q) + rubbed(1.0, q[0], 0.1) + rubbed(1.0, q[1], 0.1);

    an_elastic_hinge_in_the_plane, FlatElastic FlatElasticLossy, plane [elastic]
    {
        rest = [0.2, 0.1] m turned 10 deg; stiffness = [30, 20]; turning_stiffness = 5;
        armature = [0.3, 0.1]; turning_armature = 0.2; limits = [-0.2, 0.3]; limit_stiffness = 90;
    }
    { damping = [2, 1]; turning_damping = 0.5; turning_friction = 1; turning_friction_speed = 0.1; }
    3, quaternion false;
    power(q, _v) damped([2.0, 1.0, 0.5], q) + rubbed(1.0, q[2], 0.1);
}

mstmm_chain! {
    chain Hung {
        gravity = [0, 0, -9.8] m/s^2;
        body Link {
            mass = 1 kg;
            com = [0, 0, -0.1] m;
            output = [0, 0, -0.2] m;
            inertia = diag(0.01, 0.01, 0.01) kg*m^2 about com;
        }
        ground -> ball a -> Link first -> repeat 2 { ball b -> Link each } -> weld c -> Link last;
        spring stay { on = last; at = output; to = [3, 4, -0.8] m; stiffness = 10; damping = 3; length = 4; }
        spring guy { on = each; at = output; to = [0, 1, -0.4] m; stiffness = 5; }
    }
}

mstmm_chain! {
    plane chain FlatStay {
        body Rod { mass = 1 kg; com = [0.3, 0] m; inertia = 0.1 kg*m^2 about com; output = [0.6, 0] m; }
        ground -> pin a -> Rod rod;
        spring stay { on = rod; at = output; to = [0.6, 1] m; stiffness = 10; damping = 3; length = 0.4; }
    }
}

mstmm_chain! {
    line chain LineStay {
        body Cart { mass = 1 kg; }
        ground -> slider a -> Cart cart;
        spring stay { on = cart; to = 2 m; stiffness = 10; damping = 3; length = 0.4; }
    }
}

type InSpace<T> = SpringResult<T, Vector3<T>>;

/// Returns length, rate, tension and force of the stays, with the first link turned about z.
fn hung<T: Scalar>() -> (InSpace<T>, [InSpace<T>; 2]) {
    let chain = Hung::<T>::new();
    let mut state = chain.initial_state();
    state.a_mut().set_rate([0.0, 2.0, 0.0].map(T::constant).into());
    let mut at = chain.workspace();
    chain.solve_into(&state, &chain.no_inputs(), &mut at).expect("a regular chain");
    assert!(at.guy(2).is_none());
    (at.stay(), [0, 1].map(|index| at.guy(index).expect("two repetitions")))
}

#[test]
fn springs_report_length_tension_and_force() {
    let (stay, guys) = hung::<f64>();
    // The end moves at 2 rad/s about y, 0.8 m below the ground: with −1.6 m/s along x.
    let tension = 10.0 + 3.0 * 0.96;
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-13, "{a} {b}");
    near(stay.length(), 5.0);
    near(stay.length_rate(), 0.96);
    near(stay.tension(), tension);
    near((stay.force() - Vector3::new(0.6, 0.8, 0.0) * tension).norm(), 0.0);
    near(guys[0].length(), 1.0);
    near((guys[0].force() - Vector3::new(0.0, 5.0, 0.0)).norm(), 0.0);
    near(guys[1].length(), 1.04_f64.sqrt());
    near(guys[1].tension(), 5.0 * 1.04_f64.sqrt());
    let (small, _) = hung::<f32>();
    near(f64::from(small.length()), 5.0);
    assert!((f64::from(small.tension()) - tension).abs() < 1e-5);

    let flat = FlatStay::<f64>::new();
    let (mut state, mut at) = (flat.initial_state(), flat.workspace());
    state.a_mut().set_rate(2.0);
    flat.solve_into(&state, &flat.no_inputs(), &mut at).expect("a regular chain");
    // The end moves up with 1.2 m/s.
    near(at.stay().length_rate(), -1.2);
    near(at.stay().tension(), 6.0 - 3.6);
    near((at.stay().force() - Vector2::new(0.0, 2.4)).norm(), 0.0);

    let line = LineStay::<f64>::new();
    let (mut state, mut at) = (line.initial_state(), line.workspace());
    state.a_mut().set_velocity(2.0);
    line.solve_into(&state, &line.no_inputs(), &mut at).expect("a regular chain");
    let result: SpringResult<f64, f64> = at.stay();
    assert_eq!((result.length(), result.length_rate()), (2.0, -2.0));
    assert_eq!((result.tension(), result.force()), (10.0, 10.0));
}

mstmm_chain! {
    chain Ladder {
        gravity = [0, 0, -9.81] m/s^2;
        param taut[3] = 500 N/m;
        body Beam {
            mass = 5 kg;
            com = [0, 0, 0] m;
            inertia = diag(0.1, 0.01, 0.1) kg*m^2 about com;
            output = [0, 0, 0] m;
            point side = [0, 0.2, 0] m;
        }
        body Link {
            mass = 0.5 kg;
            com = [0, 0, -0.15] m;
            inertia = diag(0.04, 0.04, 0.01) kg*m^2 about com;
            output = [0, 0, -0.3] m;
            point side = [0, 0.02, -0.3] m;
        }
        body Rung {
            mass = 0.3 kg;
            com = [0, 0.09, 0] m;
            inertia = diag(0.08, 0.03, 0.08) kg*m^2 about com;
            point end = [0, 0.18, 0] m;
        }
        ground at [0, 0, 8] m -> weld lashing -> Beam beam -> repeat 3 from rung.end = beam.side {
            ball knot -> Link link;
            link.side -> ball joint -> Rung rung;
        };
        spring cord { on = rung.end; to = last.rung.end; stiffness = taut; damping = 2 N*s/m; length = 0.3 m; }
        spring stay { on = link.output; to = beam.side; stiffness = 30 N/m; }
    }
}

#[test]
fn springs_between_repetitions_balance_a_ladder() {
    let mut ladder = Ladder::<f64>::new();
    let taut = [800.0, 700.0, 600.0];
    ladder.set_taut(|index| taut[index]).expect("positive stiffness");
    let mut same = Ladder::<Dual<f64>>::new();
    same.set_taut(|index| Dual::from(taut[index])).expect("positive stiffness");
    let mut state = ladder.initial_state();
    let mut at = ladder.workspace();
    let mut random = Random::new(1);
    for _ in 0..20 {
        state.rates_mut().iter_mut().for_each(|rate| *rate = random.between(-2.0, 2.0));
        ladder.solve_into(&state, &ladder.no_inputs(), &mut at).expect("a regular chain");
        let cords = [0, 1, 2].map(|index| at.cord(index).expect("three repetitions"));
        let lost: f64 = cords.iter().map(|cord| 2.0 * cord.length_rate().powi(2)).sum();
        let rate = energy_rate(&ladder, &same, &state, &ladder.no_inputs());
        assert!((rate + lost).abs() < 1e-10 * (1.0 + lost), "{rate} {lost}");
        for (cord, stiffness) in cords.iter().zip(taut) {
            let tension = stiffness * (cord.length() - 0.3) + 2.0 * cord.length_rate();
            assert!((cord.tension() - tension).abs() < 1e-12 * (1.0 + tension.abs()));
            assert!((cord.force().norm() - tension.abs()).abs() < 1e-10);
        }
        // The cord of the first repetition ends on the beam.
        let span = at.beam().side().position() - at.rung(0).expect("a rung").end().position();
        assert!((span.norm() - cords[0].length()).abs() < 1e-13);
        let stay = at.stay(2).expect("three repetitions");
        let span = at.beam().side().position() - at.link(2).expect("a link").output().position();
        assert!((stay.force() - span * 30.0).norm() < 1e-11);
        state.coordinates_mut().iter_mut().for_each(|q| *q += random.between(-0.2, 0.2));
        ladder.normalize(&mut state);
    }
    assert!(at.cord(3).is_none());
}
