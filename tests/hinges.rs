//! Hinges of all kinds compared with closed forms for one body: motions, springs, dampers, friction,
//! limits and rotors, and that nothing else changes the energy.

mod support;

use mstmm::prelude::*;
use mstmm_reference::Random;
use nalgebra::{Rotation3, Unit, UnitQuaternion, Vector2, Vector3};
use support::matter::Lump;
use support::mechanism::random_quaternion;
use support::{difference, worst};

const STATES: u64 = 50;

/// A closed form takes some ten operations on numbers of like size.
const TOLERANCE: f64 = 1e-14;

mstmm_chain! {
    /// A weight on a screw with a motor, on a shaft that leans: gravity has 3 m/s² along it.
    chain Screwed {
        gravity = [1, 2, -3] m/s^2;
        body Nut {
            mass = 2 kg; com = [0, 0, 0.3] m; inertia = diag(0.1, 0.1, 0.05) kg*m^2 about com;
        }
        ground -> screw(z, 50 mm/rad) joint -> Nut nut;
        hinge joint {
            stiffness = 4; rest = 30 deg; damping = 0.2; armature = 0.01; torque = input;
            friction = 0.3; friction_speed = 0.5; limits = [-1, 1]; limit_stiffness = 20;
            limit_damping = 0.7;
        }
    }
    /// The same weight on a slider.
    chain Slid {
        gravity = [1, 2, -3] m/s^2;
        body Nut {
            mass = 2 kg; com = [0, 0, 0.3] m; inertia = diag(0.1, 0.1, 0.05) kg*m^2 about com;
        }
        ground -> slider(z) joint -> Nut nut;
        hinge joint {
            stiffness = 4; rest = 0.2; damping = 0.2; armature = 0.01; force = input;
            friction = 0.3; friction_speed = 0.5; limits = [-1, 1]; limit_stiffness = 20;
            limit_damping = 0.7;
        }
    }
    /// On a pin it is held against gravity along the axis.
    chain Pinned {
        gravity = [1, 2, -3] m/s^2;
        body Nut {
            mass = 2 kg; com = [0, 0, 0.3] m; inertia = diag(0.1, 0.1, 0.05) kg*m^2 about com;
        }
        ground -> pin(z) joint -> Nut nut;
        hinge joint {
            stiffness = 4; rest = 30 deg; damping = 0.2; armature = 0.01; torque = input;
            friction = 0.3; friction_speed = 0.5; limits = [-1, 1]; limit_stiffness = 20;
            limit_damping = 0.7;
        }
    }
    /// Both at once, each with its own.
    chain Both {
        gravity = [1, 2, -3] m/s^2;
        body Nut {
            mass = 2 kg; com = [0, 0, 0.3] m; inertia = diag(0.1, 0.1, 0.05) kg*m^2 about com;
        }
        ground -> cylindrical(z) joint -> Nut nut;
        hinge joint {
            stiffness = 4; rest = 0.2 m turned 30 deg; damping = 0.2; armature = 0.01;
            force = input; friction = 0.3; friction_speed = 0.5; limits = [-1, 1];
            limit_stiffness = 20; limit_damping = 0.7;
            turning_stiffness = 4; turning_damping = 0.2; turning_armature = 0.01; torque = input;
            turning_friction = 0.3; turning_friction_speed = 0.5; turning_limits = [-1, 1];
            turning_limit_stiffness = 20; turning_limit_damping = 0.7;
        }
    }
}

/// The efforts along one coordinate in the hinges above, without motors.
fn passive(q: f64, v: f64, rest: f64) -> f64 {
    let beyond = if q > 1.0 {
        -20.0 * (q - 1.0) - 0.7 * v
    } else if q < -1.0 {
        -20.0 * (q + 1.0) - 0.7 * v
    } else {
        0.0
    };
    -4.0 * (q - rest) - 0.2 * v - 0.3 * v / (v * v + 0.5 * 0.5_f64).sqrt() + beyond
}

/// Screw: (J + m p² + I) θ̈ = τ − p m g; slider: (m + I) ẍ = f − m g; pin: (J + I) θ̈ = τ. The
/// torque that the hinge transmits is τ − I θ̈, since the rest accelerates the rotor.
#[test]
fn along_and_about_one_axis() {
    let (screwed, slid) = (Screwed::<f64>::new(), Slid::<f64>::new());
    let (pinned, both) = (Pinned::<f64>::new(), Both::<f64>::new());
    let (mut at, mut on_pin) = (screwed.workspace(), pinned.workspace());
    let (turned, shifted) = (30_f64.to_radians(), 0.2);
    let mut largest = 0.0;
    for seed in 0..STATES {
        let mut random = Random::new(seed);
        let [q, v, motor] = [2.0, 3.0, 5.0].map(|size| random.between(-size, size));
        let (torque, force) = (motor + passive(q, v, turned), motor + passive(q, v, shifted));

        let inputs = ScrewedInputs { joint: motor };
        let mut state = screwed.initial_state();
        state.joint_mut().set_angle(q).set_rate(v);
        let pitch = 0.05;
        let screw = (torque - pitch * 2.0 * 3.0) / (0.05 + 2.0 * pitch * pitch + 0.01);
        screwed.solve_into(&state, &inputs, &mut at).expect("a regular chain");
        let place = at.nut().input();
        let mut off = [
            difference(&[at.joint().acceleration()], &[screw]),
            difference(&[place.position().z, place.velocity().z], &[pitch * q, pitch * v]),
            difference(&[place.acceleration().z], &[pitch * screw]),
            // The nut's balance along and about the axis.
            difference(&[at.joint().output().force().z], &[2.0 * (pitch * screw + 3.0)]),
            difference(&[-at.joint().output().moment().z], &[0.05 * screw]),
            difference(&[at.joint().effort()], &[motor]),
        ]
        .into_iter()
        .fold(0.0, worst);

        let mut state = slid.initial_state();
        state.joint_mut().set_position(q).set_velocity(v);
        let slide = (force - 2.0 * 3.0) / (2.0 + 0.01);
        let found = slid.accelerations(&state, &SlidInputs { joint: motor }).expect("regular")[0];
        off = worst(off, difference(&[found], &[slide]));

        let mut state = pinned.initial_state();
        state.joint_mut().set_angle(q).set_rate(v);
        let turn = torque / (0.05 + 0.01);
        pinned
            .solve_into(&state, &PinnedInputs { joint: motor }, &mut on_pin)
            .expect("a regular chain");
        off = worst(off, difference(&[on_pin.joint().acceleration()], &[turn]));
        let passed_on = -on_pin.joint().output().moment().z;
        off = worst(off, difference(&[passed_on], &[torque - 0.01 * turn]));

        let mut state = both.initial_state();
        state.joint_mut().set_position(q).set_angle(q).set_velocity(v).set_rate(v);
        let inputs = BothInputs { joint: Vector2::new(motor, motor) };
        let found = both.accelerations(&state, &inputs).expect("a regular chain");
        off = worst(off, difference(found.as_slice(), &[slide, turn]));
        assert!(off < TOLERANCE, "seed {seed}: {off:e}");
        largest = worst(largest, off);
    }
    println!("off by {largest:.1e}");
}

mstmm_chain! {
    /// Axes that are neither perpendicular nor along a frame's.
    chain Cross {
        gravity = [1, -9.8, 2] m/s^2;
        body Arm {
            mass = 1.5 kg;
            com = [0.2, -0.1, 0.3] m;
            output = [0.4, 0, 0] m;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
        }
        ground -> universal([1, 2, 0], [1, 1, 1]) joint -> Arm arm;
        hinge joint { torque = input; armature = [0.2, 0.3] kg*m^2; }
    }
}

const ARM: Lump =
    Lump { mass: 1.5, com: [0.2, -0.1, 0.3], inertia: [0.1, 0.12, 0.09, 0.01, 0.02, -0.01] };

/// Ω = a α̇ + b' β̇ with b' = Rot(a, α) b, so Ω̇ = a α̈ + b' β̈ + (a × b') α̇ β̇. The arm is in
/// balance, and its moments about both axes are the motor torques minus those of the rotors.
#[test]
fn a_universal_hinge_rotates_about_both_axes() {
    let chain = Cross::<f64>::new();
    let mut at = chain.workspace();
    let [a, b] =
        [Vector3::new(1.0, 2.0, 0.0), Vector3::new(1.0, 1.0, 1.0)].map(Unit::new_normalize);
    let mut largest = 0.0;
    for seed in 0..STATES {
        let mut random = Random::new(seed);
        let [angles, rates, torques] =
            [3.0, 2.0, 5.0].map(|size| Vector2::from_fn(|_, _| random.between(-size, size)));
        let mut state = chain.initial_state();
        state.joint_mut().set_angles(angles).set_rates(rates);
        chain.solve_into(&state, &CrossInputs { joint: torques }, &mut at).expect("regular");
        let turn = Rotation3::from_axis_angle(&a, angles.x);
        let carried = turn * b;
        let accelerations = at.joint().acceleration();
        let spin = *a * rates.x + *carried * rates.y;
        let spin_rate = *a * accelerations.x
            + *carried * accelerations.y
            + a.cross(&carried) * rates.x * rates.y;
        let output = at.joint().output();
        let orientation = turn * Rotation3::from_axis_angle(&b, angles.y);
        let passed_on = [a, carried].map(|axis| -output.moment().dot(&axis));
        let expected = [torques.x - 0.2 * accelerations.x, torques.y - 0.3 * accelerations.y];
        let off = [
            difference(output.orientation().matrix().as_slice(), orientation.matrix().as_slice()),
            difference(output.angular_velocity().as_slice(), spin.as_slice()),
            difference(output.angular_acceleration().as_slice(), spin_rate.as_slice()),
            difference(&passed_on, &expected),
            ARM.imbalance([&output, &at.arm().output()], [1.0, -9.8, 2.0]),
        ]
        .into_iter()
        .fold(0.0, worst);
        // The arm's mass matrix has a condition of some ten.
        assert!(off < 10.0 * TOLERANCE, "seed {seed}: {off:e}");
        largest = worst(largest, off);
    }
    println!("off by {largest:.1e}");
}

mstmm_chain! {
    /// A ball with everything, on a body as round as a ball.
    chain Round {
        body Globe {
            mass = 2 kg; com = [0, 0, 0] m; inertia = diag(0.4, 0.4, 0.4) kg*m^2 about com;
        }
        ground -> ball joint -> Globe globe;
        hinge joint {
            rest = rpy(20, -30, 50) deg; stiffness = 7; damping = 0.6; friction = 0.5;
            friction_speed = 0.2; limits = 100 deg; limit_stiffness = 40; limit_damping = 0.9;
            armature = 0.1;
        }
    }
    /// The same turns of a floating hinge, and its shifts.
    chain Adrift {
        body Globe {
            mass = 2 kg; com = [0, 0, 0] m; inertia = diag(0.4, 0.4, 0.4) kg*m^2 about com;
        }
        ground -> floating joint -> Globe globe;
        hinge joint {
            rest = [0.1, 0.2, 0.3] m turned rpy(20, -30, 50) deg;
            stiffness = [3, 4, 5]; damping = 0.4; armature = [0.1, 0.2, 0.3];
            turning_stiffness = 7; turning_damping = 0.6; turning_friction = 0.5;
            turning_friction_speed = 0.2; turning_limits = 100 deg; turning_limit_stiffness = 40;
            turning_limit_damping = 0.9; turning_armature = 0.1;
        }
    }
}

/// Along ψ, the rotation vector from rest: −k ψ, and beyond the limit a second spring; along ω:
/// dampers, and friction in proportion to neither. nalgebra finds the rotation vector by itself.
#[test]
fn a_ball_springs_back_along_the_rotation_vector() {
    let (ball, floating) = (Round::<f64>::new(), Adrift::<f64>::new());
    let rest = UnitQuaternion::from_euler_angles(
        20_f64.to_radians(),
        -30_f64.to_radians(),
        50_f64.to_radians(),
    );
    let limit = 100_f64.to_radians();
    let (mut largest, mut beyond) = (0.0, 0);
    for seed in 0..STATES {
        let mut random = Random::new(seed);
        let [w, x, y, z] = random_quaternion(&mut random);
        let turn = UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(w, x, y, z));
        let spin = Vector3::from_fn(|_, _| random.between(-2.0, 2.0));
        let psi = (rest.inverse() * turn).scaled_axis();
        let over = (psi.norm() - limit).max(0.0);
        let mut torque = -psi * 7.0 - spin * 0.6 - spin * 0.5 / spin.norm().hypot(0.2);
        if over > 0.0 {
            torque -= psi.normalize() * (40.0 * over) + spin * 0.9;
            beyond += 1;
        }
        let turning = torque / (0.4 + 0.1);

        let mut state = ball.initial_state();
        state.joint_mut().set_orientation(turn).set_rate(spin);
        let found = ball.accelerations(&state, &ball.no_inputs()).expect("a regular chain");
        let mut off = difference(found.as_slice(), turning.as_slice());
        let stored = 3.5 * psi.norm_squared() + 20.0 * over * over;
        off = worst(off, difference(&[ball.energy(&state).potential], &[stored]));

        let [place, velocity] =
            [1.0, 2.0].map(|size| Vector3::from_fn(|_, _| random.between(-size, size)));
        let shift = place - Vector3::new(0.1, 0.2, 0.3);
        let pull = -shift.component_mul(&Vector3::new(3.0, 4.0, 5.0)) - velocity * 0.4;
        let linear = pull.component_div(&Vector3::new(2.1, 2.2, 2.3));
        let mut state = floating.initial_state();
        let mut joint = state.joint_mut();
        joint.set_position(place).set_velocity(velocity).set_orientation(turn).set_rate(spin);
        let found = floating.accelerations(&state, &floating.no_inputs()).expect("regular");
        let expected = [linear.as_slice(), turning.as_slice()].concat();
        off = worst(off, difference(found.as_slice(), &expected));
        // Near half a turn nalgebra's angle is worse determined than ours.
        assert!(off < 10.0 * TOLERANCE, "seed {seed}: {off:e}");
        largest = worst(largest, off);
    }
    println!("off by {largest:.1e}, {beyond} of {STATES} beyond the limit");
    assert!(beyond > 5 && beyond < STATES - 5);
}

/// At rest a ball's spring has a direction of no length: nothing acts, and nothing is NaN.
#[test]
fn a_ball_at_rest_rests() {
    let chain = Round::<f64>::new();
    let state = chain.initial_state();
    let mut at_rest = state.clone();
    let angles = [20_f64, -30.0, 50.0].map(f64::to_radians);
    at_rest.joint_mut().set_bryan_angles(angles);
    let found = chain.accelerations(&at_rest, &chain.no_inputs()).expect("a regular chain");
    assert!(found.norm() < 1e-14, "{found}");
    assert!(chain.energy(&at_rest).total().abs() < 1e-14);
    // The opposite quaternion is the same orientation.
    let mut opposite = at_rest.clone();
    opposite.coordinates_mut().iter_mut().for_each(|x| *x = -*x);
    let found = chain.accelerations(&opposite, &chain.no_inputs()).expect("a regular chain");
    assert!(found.norm() < 1e-14, "{found}");
}
