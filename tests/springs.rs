//! Springs, limits and rotors of every kind of hinge conserve energy; dampers and friction dissipate the
//! power given by their rates. Exact, by dual numbers.

mod support;

use mstmm::prelude::*;
use mstmm_reference::Random;
use support::dual::{Dual, energy_rate};
use support::mechanism::random_quaternion;
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
            let (kept, same) = ($elastic::<f64>::new(), $elastic::<Dual>::new());
            let (lost, alike) = ($lossy::<f64>::new(), $lossy::<Dual>::new());
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
