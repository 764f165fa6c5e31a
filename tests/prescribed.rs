//! Prescribed motions: a motor with the reported effort of the drive moves the hinge as prescribed, for every
//! kind of hinge. Moving ends are equivalent to bodies with prescribed motions, and accelerating frames to
//! gravity.

mod support;

use mstmm::prelude::*;
use mstmm::{FloatingState, HingeMotion};
use mstmm_reference::{HingeMotion as Motion, Random};
use nalgebra::{UnitQuaternion, Vector3};
use support::mechanism::random_quaternion;
use support::motion::{
    ball, cylindrical, elastic, floating, gimbal, part, pin, planar, plane_elastic, screw, slider,
    universal,
};
use support::{ComparedPoint, difference, worst};

const STATES: u64 = 30;

/// The chains have two or three bodies, with condition numbers of some hundreds; a few hundred
/// roundings on the way leave 10² · 10² · 10⁻¹⁶ relative to the largest term.
const TOLERANCE: f64 = 1e-12;

/// A random motion of a hinge with a number of single coordinates and possibly a quaternion after them.
fn random_motion(random: &mut Random, singles: usize, quaternion: bool) -> Motion {
    let mut q: Vec<f64> = (0..singles).map(|_| random.between(-0.8, 0.8)).collect();
    if quaternion {
        q.extend(random_quaternion(random));
    }
    let rates = singles + 3 * usize::from(quaternion);
    let v = (0..rates).map(|_| random.between(-2.0, 2.0)).collect();
    let a = (0..rates).map(|_| random.between(-5.0, 5.0)).collect();
    Motion { q, v, a }
}

/// Sets a state from the motions of its hinges, in order.
fn set(state: &mut impl ChainState<Scalar = f64>, hinges: &[&Motion]) {
    let q: Vec<f64> = hinges.iter().flat_map(|motion| motion.q.clone()).collect();
    let v: Vec<f64> = hinges.iter().flat_map(|motion| motion.v.clone()).collect();
    state.coordinates_mut().copy_from_slice(&q);
    state.rates_mut().copy_from_slice(&v);
}

/// The largest difference of motions, and of loads, at the same points of two chains.
fn apart<P: ComparedPoint>(a: &[P], b: &[P]) -> f64 {
    let quantities = |points: &[P]| -> [Vec<f64>; 2] {
        let motion = points.iter().flat_map(|point| point.motion().concat());
        [motion.collect(), points.iter().flat_map(|point| point.load().concat()).collect()]
    };
    let (a, b) = (quantities(a), quantities(b));
    [0, 1].into_iter().map(|k| difference(&a[k], &b[k])).fold(0.0, worst)
}

/// A hinge with a prescribed motion, and the same hinge with a motor, between two others; both have springs,
/// dampers, friction and rotors.
macro_rules! twins {
    ($(
        $test:ident, $told:ident $driven:ident, $dimension:ident
        [$($hinge:tt)*] { $($passive:tt)* } motors { $($motor:tt)* }
        $motion:ident($singles:literal, $quaternion:literal);
    )*) => { $(
        twins! { @chain $dimension $told [$($hinge)*] { $($passive)* motion = input; } }
        twins! { @chain $dimension $driven [$($hinge)*] { $($passive)* $($motor)* } }

        #[test]
        fn $test() {
            let (told, driven) = ($told::<f64>::new(), $driven::<f64>::new());
            let mut largest = 0.0;
            for seed in 0..STATES {
                let mut random = Random::new(seed);
                let near = random_motion(&mut random, 1, false);
                let joint = random_motion(&mut random, $singles, $quaternion);
                let far = random_motion(&mut random, 1, false);
                let (mut alone, mut whole) = (told.initial_state(), driven.initial_state());
                set(&mut alone, &[&near, &far]);
                set(&mut whole, &[&near, &joint, &far]);

                let mut inputs = told.no_inputs();
                inputs.joint = $motion(&joint);
                let mut expected = told.workspace();
                told.solve_into(&alone, &inputs, &mut expected).expect("a regular chain");
                let mut motors = driven.no_inputs();
                motors.joint = expected.joint().effort();
                let mut found = driven.workspace();
                driven.solve_into(&whole, &motors, &mut found).expect("a regular chain");
                let fast = driven.accelerations(&whole, &motors).expect("a regular chain");

                let [first, last] = [0, 1].map(|k| expected.accelerations()[k]);
                let accelerations = [&[first], &joint.a[..], &[last]].concat();
                let energies = [
                    [expected.kinetic_energy(), expected.potential_energy()],
                    [found.kinetic_energy(), found.potential_energy()],
                ];
                let alone = told.energy_with(&alone, &inputs);
                let off = [
                    difference(found.accelerations().as_slice(), &accelerations),
                    difference(fast.as_slice(), &accelerations),
                    apart(&found.points(), &expected.points()),
                    difference(&energies[0], &energies[1]),
                    difference(&[alone.kinetic, alone.potential], &energies[1]),
                ];
                let off = off.into_iter().fold(0.0, worst);
                assert!(off < TOLERANCE, "seed {seed}: {off:e}");
                largest = worst(largest, off);
            }
            println!("{}: off by {largest:.1e}", stringify!($told));
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
            hinge joint { $($fields)* }
        } }
    };
    (@chain line $name:ident [$($hinge:tt)*] { $($fields:tt)* }) => {
        mstmm_chain! { line chain $name {
            gravity = 3 m/s^2;
            body Link { mass = 1.5 kg; output = 0.5 m; }
            ground -> slider near -> Link first -> $($hinge)* joint -> Link second -> slider far
                -> Link third;
            hinge joint { $($fields)* }
        } }
    };
}

twins! {
    a_pin, PinTold PinDriven, space [pin([1, 2, -1])] {
        rest = 20 deg; stiffness = 30; damping = 2; armature = 0.3; friction = 1;
        friction_speed = 0.1; limits = [-0.2, 0.3]; limit_stiffness = 100; limit_damping = 3;
    } motors { torque = input; } pin(1, false);
    a_slider, SliderTold SliderDriven, space [slider(y)] {
        rest = 0.1; stiffness = 30; damping = 2; armature = 0.3; friction = 1;
        friction_speed = 0.1; limits = [-0.2, 0.3]; limit_stiffness = 100; limit_damping = 3;
    } motors { force = input; } slider(1, false);
    a_screw, ScrewTold ScrewDriven, space [screw([1, 1, 0], 0.2 m/rad)] {
        stiffness = 30; damping = 2; armature = 0.3; friction = 1; friction_speed = 0.1;
    } motors { torque = input; } screw(1, false);
    a_cylindrical_hinge, CylindricalTold CylindricalDriven, space [cylindrical([0, 1, -2])] {
        stiffness = 30; turning_damping = 2; turning_armature = 0.3; friction = 1;
        friction_speed = 0.1; rest = 0.1 m turned 30 deg; turning_stiffness = 4;
    } motors { force = input; torque = input; } cylindrical(2, false);
    a_universal_hinge, UniversalTold UniversalDriven, space [universal(x, [1, 2, 0])] {
        stiffness = [30, 20]; damping = 2; armature = [0.3, 0.1]; rest = [0.1, 0.2];
        friction = [1, 2]; friction_speed = 0.1;
    } motors { torque = input; } universal(2, false);
    a_gimbal, GimbalTold GimbalDriven, space [gimbal(x, [1, 2, 0], [0, 1, 1])] {
        stiffness = [30, 20, 10]; damping = 2; armature = [0.3, 0.1, 0.2]; rest = [0.1, 0.2, 0.3];
        friction = [1, 2, 3]; friction_speed = 0.1;
    } motors { torque = input; } gimbal(3, false);
    a_ball, BallTold BallDriven, space [ball] {
        rest = rpy(10, 20, 30) deg; stiffness = 30; damping = 2; armature = 0.3; friction = 1;
        friction_speed = 0.1; limits = 40 deg; limit_stiffness = 50; limit_damping = 2;
    } motors { torque = input; } ball(0, true);
    a_planar_hinge, PlanarTold PlanarDriven, space [planar(y)] {
        stiffness = [30, 20]; turning_stiffness = 5; damping = 2; armature = [0.3, 0.1];
        turning_friction = 2; turning_friction_speed = 0.1; turning_armature = 0.2;
    } motors { force = input; torque = input; } planar(3, false);
    a_floating_hinge, FloatingTold FloatingDriven, space [floating] {
        stiffness = [30, 20, 10]; turning_stiffness = 5; damping = 2; armature = [0.3, 0.1, 0.2];
        turning_friction = 2; turning_friction_speed = 0.1; turning_armature = 0.2;
        rest = [0.1, 0.2, 0.3] m turned rpy(10, 20, 30) deg;
    } motors { force = input; torque = input; } floating(3, true);
    an_elastic_hinge, ElasticTold ElasticDriven, space [elastic] {
        stiffness = [30, 20, 10]; turning_stiffness = [5, 4, 3]; damping = [1, 2, 3];
        turning_damping = 0.1; armature = [0.3, 0.1, 0.2]; turning_armature = [0.2, 0.3, 0.1];
        rest = [0.1, 0.2, 0.3] m turned rpy(10, 20, 30) deg;
    } motors { force = input; torque = input; } elastic(6, false);
    a_planar_hinge_in_the_plane, PlaneTold PlaneDriven, plane [planar] {
        stiffness = [30, 20]; turning_stiffness = 5; damping = 2; armature = [0.3, 0.1];
    } motors { force = input; torque = input; } planar(3, false);
    an_elastic_hinge_in_the_plane, PlaneElasticTold PlaneElasticDriven, plane [elastic] {
        stiffness = [30, 20]; turning_stiffness = 5; damping = [1, 2]; armature = [0.3, 0.1];
        turning_armature = 0.2; rest = [0.1, 0.2] m turned 30 deg;
    } motors { force = input; torque = input; } plane_elastic(3, false);
    a_slider_on_a_line, LineTold LineDriven, line [slider] {
        stiffness = 30; damping = 5; armature = 0.3; rest = 0.1 m;
    } motors { force = input; } slider(1, false);
}

/// A chain on a moving end, and the same chain on a body whose hinge has a prescribed motion.
macro_rules! carried {
    ($(
        $test:ident, $on_end:ident $on_body:ident, $dimension:ident [$carrier:ident]
        $motion:ident($singles:literal, $quaternion:literal)
        { $($body:tt)* } { $($massive:tt)* } [$($hinge:tt)*] ($own:literal, $turns:literal);
    )*) => { $(
        mstmm_chain! { $dimension chain $on_end {
            $($body)*
            moving deck -> $($hinge)* joint -> Link first -> $($hinge)* next -> Link second;
        } }
        mstmm_chain! { $dimension chain $on_body {
            $($massive)*
            $($body)*
            ground -> $carrier deck -> Carrier carrier
                -> $($hinge)* joint -> Link first -> $($hinge)* next -> Link second;
            hinge deck { motion = input; }
        } }

        #[test]
        fn $test() {
            let (on_end, on_body) = ($on_end::<f64>::new(), $on_body::<f64>::new());
            let mut largest = 0.0;
            for seed in 0..STATES {
                let mut random = Random::new(seed);
                let deck = random_motion(&mut random, $singles, $quaternion);
                let hinges = [(); 2].map(|()| random_motion(&mut random, $own, $turns));
                let (mut state, mut same) = (on_end.initial_state(), on_body.initial_state());
                set(&mut state, &[&hinges[0], &hinges[1]]);
                set(&mut same, &[&hinges[0], &hinges[1]]);
                let (mut inputs, mut told) = (on_end.no_inputs(), on_body.no_inputs());
                inputs.deck = $motion(&deck);
                told.deck = $motion(&deck);
                let (mut found, mut expected) = (on_end.workspace(), on_body.workspace());
                on_end.solve_into(&state, &inputs, &mut found).expect("a regular chain");
                on_body.solve_into(&same, &told, &mut expected).expect("a regular chain");
                let off = [
                    difference(
                        found.accelerations().as_slice(),
                        expected.accelerations().as_slice(),
                    ),
                    apart(&found.points(), &expected.points()[2..]),
                ];
                let off = off.into_iter().fold(0.0, worst);
                assert!(off < TOLERANCE, "seed {seed}: {off:e}");
                largest = worst(largest, off);
            }
            println!("{}: off by {largest:.1e}", stringify!($on_end));
        }
    )* };
}

carried! {
    a_moving_end_in_space, OnDeck OnCarrier, space [floating] floating(3, true)
    {
        gravity = [1, -9.8, 2] m/s^2;
        body Link {
            mass = 1.5 kg; com = [0.2, -0.1, 0.1] m; output = [0.5, 0.1, -0.2] m;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
        }
    }
    { body Carrier {
        mass = 3 kg; com = [1, 1, 1] m; output = [0, 0, 0] m;
        inertia = diag(1, 1, 1) kg*m^2 about com;
    } }
    [ball] (0, true);
    a_moving_end_in_the_plane, OnPlaneDeck OnPlaneCarrier, plane [planar] planar(3, false)
    {
        gravity = [1, -9.8] m/s^2;
        body Link {
            mass = 1.5 kg; com = [0.2, -0.1] m; output = [0.5, 0.1] m;
            inertia = 0.1 kg*m^2 about com;
        }
    }
    { body Carrier {
        mass = 3 kg; com = [1, 1] m; output = [0, 0] m; inertia = 1 kg*m^2 about com;
    } }
    [pin] (1, false);
    a_moving_end_on_a_line, OnLineDeck OnLineCarrier, line [slider] slider(1, false)
    { gravity = 2 m/s^2; body Link { mass = 1.5 kg; output = 0.3 m; } }
    { body Carrier { mass = 3 kg; output = 0 m; } }
    [slider] (1, false);
}

mstmm_chain! {
    chain Lifted {
        body Link {
            mass = 1.5 kg;
            com = [0.2, -0.1, 0.1] m;
            output = [0.5, 0.1, -0.2] m turned rpy(20, -30, 50) deg;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
        }
        moving deck -> ball joint -> Link first -> pin(y) next -> Link second;
    }
    chain Heavy {
        gravity = input;
        body Link {
            mass = 1.5 kg;
            com = [0.2, -0.1, 0.1] m;
            output = [0.5, 0.1, -0.2] m turned rpy(20, -30, 50) deg;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
        }
        ground -> ball joint -> Link first -> pin(y) next -> Link second;
    }
}

/// A frame that accelerates without rotation and without gravity is equivalent to a frame at rest with
/// opposite gravity: the same relative motion and the same forces.
#[test]
fn accelerating_is_gravity() {
    let (lifted, heavy) = (Lifted::<f64>::new(), Heavy::<f64>::new());
    let mut largest = 0.0;
    for seed in 0..STATES {
        let mut random = Random::new(seed);
        let hinges = [random_motion(&mut random, 0, true), random_motion(&mut random, 1, false)];
        let (mut state, mut same) = (lifted.initial_state(), heavy.initial_state());
        set(&mut state, &[&hinges[0], &hinges[1]]);
        set(&mut same, &[&hinges[0], &hinges[1]]);
        let mut any = || [0.0; 3].map(|_: f64| random.between(-9.0, 9.0));
        let (position, velocity, acceleration) = (any(), any(), any());
        let deck = FloatingState::new(position, [1.0, 0.0, 0.0, 0.0], velocity, [0.0; 3]);
        let derivatives = part(&[&acceleration[..], &[0.0; 3]].concat(), 0);
        let inputs =
            LiftedInputs { deck: HingeMotion { state: deck, acceleration: derivatives.into() } };
        let gravity = HeavyInputs { gravity: acceleration.map(|x| -x).into() };
        let (mut found, mut expected) = (lifted.workspace(), heavy.workspace());
        lifted.solve_into(&state, &inputs, &mut found).expect("a regular chain");
        heavy.solve_into(&same, &gravity, &mut expected).expect("a regular chain");
        let mut off =
            difference(found.accelerations().as_slice(), expected.accelerations().as_slice());
        for (found, expected) in found.points().iter().zip(expected.points()) {
            let shifted = expected.acceleration() + Vector3::from(acceleration);
            off = [
                difference(found.load().concat().as_slice(), &expected.load().concat()),
                difference(found.acceleration().as_slice(), shifted.as_slice()),
            ]
            .into_iter()
            .fold(off, worst);
        }
        assert!(off < TOLERANCE, "seed {seed}: {off:e}");
        largest = worst(largest, off);
    }
    println!("off by {largest:.1e}");
}

mstmm_chain! {
    /// A pendulum on a deck that turns about the vertical.
    chain Governor {
        gravity = [0, -9.8, 0] m/s^2;
        body Rod {
            mass = 2 kg;
            com = [0, -0.5, 0] m;
            inertia = diag(0.2, 0.05, 0.22) kg*m^2 about com;
        }
        moving deck -> pin(z) joint -> Rod rod;
    }
}

/// (J_z + m l²) θ̈ = (m l² + J_x − J_y) Ω² sin θ cos θ − m g l sin θ; what the deck's turning
/// gains, Ω̇, acts on the pin's axis not at all.
#[test]
fn turning_lifts_a_governor() {
    let chain = Governor::<f64>::new();
    for seed in 0..STATES {
        let mut random = Random::new(seed);
        let mut any = || random.between(-3.0, 3.0);
        let (angle, rate, heading, spin, spin_up) = (any(), any(), any(), any(), any());
        let mut state = chain.initial_state();
        state.joint_mut().set_angle(angle).set_rate(rate);
        let turn = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), heading);
        let deck = FloatingState::new(
            [0.0; 3],
            [turn.w, turn.i, turn.j, turn.k],
            [0.0; 3],
            [0.0, spin, 0.0],
        );
        let acceleration = [0.0, 0.0, 0.0, 0.0, spin_up, 0.0].into();
        let inputs = GovernorInputs { deck: HingeMotion { state: deck, acceleration } };
        let found = chain.accelerations(&state, &inputs).expect("a regular chain")[0];
        let (sine, cosine) = angle.sin_cos();
        let (arm, drop) = (2.0 * 0.25, 2.0 * 9.8 * 0.5);
        let lift = (arm + 0.2 - 0.05) * spin * spin * sine * cosine;
        let expected = (lift - drop * sine) / (0.22 + arm);
        let off = difference(&[found], &[expected]);
        assert!(off < 1e-14, "seed {seed}: {off:e}");
    }
}
