//! Momentum of chains and trees.

use mstmm::nalgebra::Vector3;
use mstmm::{Chain, Dual, Error, SliderState, mstmm_chain};

mstmm_chain! {
    /// A floating tree with a repeated part.
    chain Kite {
        answers = [momentum, kinematics];
        gravity = [0.5, -9.8, 1] m/s^2;
        body Trunk {
            mass = 3 kg; com = [0.1, 0.2, -0.1] m; output = [0.4, 0, 0.1] m;
            point side = [0, 0.3, 0] m;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
        }
        body Rod {
            mass = 1.3 kg; com = [0.3, 0.1, 0] m; output = [0.6, 0, 0.2] m turned rpy(20, -30, 50) deg;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
        }
        Trunk trunk -> repeat 3 { pin c -> Rod d -> slider(y) e -> Rod f };
        trunk.side -> ball g -> Rod h;
        hinge c { torque = input; stiffness = 3; damping = 0.1; }
    }

    /// A plane chain on the ground.
    plane chain Plane {
        answers = momentum;
        body Link { mass = 2 kg; com = [0.5, 0.1] m; output = [1, 0] m; inertia = 0.1 kg*m^2 about com; }
        ground -> pin a -> Link b -> slider(x) c -> Link d;
    }

    /// A robot whose base is welded to the ground, and a branch of welds only.
    chain Fixed {
        answers = [momentum, kinematics];
        body Base {
            mass = 5 kg; com = [0.1, 0.2, 0.3] m; output = [0, 0, 0.5] m turned rpy(90, 0, 30) deg;
            inertia = diag(0.1, 0.2, 0.15) kg*m^2 about com;
            point side = [0.4, 0, 0] m turned rpy(0, 40, 0) deg;
        }
        body Arm { mass = 2 kg; com = [0.3, 0, 0.1] m; inertia = diag(0.02, 0.1, 0.1) kg*m^2 about com; }
        ground at [1, 2, 3] m turned rpy(10, 20, 30) deg -> weld foot -> Base base -> pin(y) joint -> Arm arm;
        base.side -> weld hook -> Arm crate_box;
    }

    /// Nothing moves.
    plane chain Wall {
        answers = momentum;
        body Brick { mass = 3 kg; com = [0.5, 0.1] m; output = [1, 0] m; inertia = 0.1 kg*m^2 about com; }
        ground at [1, 0] m -> weld a -> Brick b -> weld c -> Brick d;
    }

    /// Two carts whose first is moved.
    line chain Carts {
        answers = momentum;
        body Cart { mass = 2 kg; com = 0.1 m; output = 0.5 m; }
        ground -> slider a -> Cart b -> slider c -> Cart d;
        hinge a { motion = input; }
    }
}

/// Returns a general state of the kite.
fn general(kite: &Kite<f64>) -> KiteState<f64> {
    let mut state = kite.initial_state();
    for (k, q) in state.q.iter_mut().enumerate() {
        *q += 0.07 * ((k * k) % 7) as f64 - 0.1;
    }
    for (k, v) in state.v.iter_mut().enumerate() {
        *v = 0.4 - 0.11 * k as f64;
    }
    kite.normalize(&mut state);
    state
}

/// Only gravity acts on a floating tree from outside, whatever its motors and springs do: dp/dt is the weight, and the
/// angular momentum about the centre of mass is constant.
#[test]
fn only_the_weight_changes_the_momentum_of_a_floating_tree() -> Result<(), Error> {
    let kite = Kite::<f64>::new();
    let mut inputs = kite.no_inputs();
    inputs.c = [3.0, -2.0, 1.0];
    let state = general(&kite);
    let accelerations = kite.accelerations(&state, &inputs)?;
    let mut rate = kite.initial_state();
    kite.configuration_rate_into(&state, &mut rate);
    let dual = Kite::<Dual<f64>>::new();
    let mut moving = dual.initial_state();
    let pair = |value: f64, derivative: f64| Dual::new(value, [derivative]);
    moving
        .q
        .iter_mut()
        .zip(state.q.iter().zip(&rate.q))
        .for_each(|(to, (&q, &d))| *to = pair(q, d));
    moving
        .v
        .iter_mut()
        .zip(state.v.iter().zip(&accelerations))
        .for_each(|(to, (&v, &d))| *to = pair(v, d));
    let momentum = dual.momentum(&moving, &dual.no_inputs())?;
    let change = |vector: Vector3<Dual<f64>>| vector.map(|entry| entry.derivatives[0]);
    let weight = Vector3::new(0.5, -9.8, 1.0) * momentum.mass.value;
    // Forces up to 100 N on seven bodies, and condition numbers of the mass matrix below 1000.
    let rounding = 100.0 * 7.0 * 1000.0 * f64::EPSILON;
    assert!((change(momentum.linear) - weight).norm() < rounding);
    assert!(change(momentum.angular).norm() < rounding);
    let mass = momentum.mass.value;
    assert!(
        (change(momentum.center_of_mass) * mass - momentum.linear.map(|x| x.value)).norm() < 1e-12
    );
    Ok(())
}

#[test]
fn the_matrix_maps_rates_to_momentum() -> Result<(), Error> {
    let kite = Kite::<f64>::new();
    let (state, inputs) = (general(&kite), kite.no_inputs());
    let momentum = kite.momentum(&state, &inputs)?;
    let product = kite.momentum_matrix(&state, &inputs)? * state.v;
    // Sums of some ten terms below 100.
    assert!((product.rows(0, 3) - momentum.linear).norm() < 1e-13);
    assert!((product.rows(3, 3) - momentum.angular).norm() < 1e-13);
    assert!(momentum.angular.norm() > 0.1 && momentum.linear.norm() > 0.1);

    let plane = Plane::<f64>::new();
    let mut state = plane.initial_state();
    (state.q[0], state.q[1], state.v[0], state.v[1]) = (0.7, 0.3, 1.1, -0.4);
    let momentum = plane.momentum(&state, &plane.no_inputs())?;
    let product = plane.momentum_matrix(&state, &plane.no_inputs())? * state.v;
    assert!((product[0] - momentum.linear.x).abs() < 1e-14);
    assert!((product[1] - momentum.linear.y).abs() < 1e-14);
    assert!((product[2] - momentum.angular).abs() < 1e-14);
    Ok(())
}

/// By definition, from the bodies' centres of mass.
#[test]
fn linear_momentum_is_the_sum_over_the_bodies() -> Result<(), Error> {
    let kite = Kite::<f64>::new();
    let (state, inputs) = (general(&kite), kite.no_inputs());
    let kinematics = kite.kinematics(&state, &inputs)?;
    let (mut first, mut linear) = (Vector3::zeros(), Vector3::zeros());
    let mut add = |mass: f64, position: Vector3<f64>, velocity: Vector3<f64>| {
        first += position * mass;
        linear += velocity * mass;
    };
    let trunk = kinematics.trunk().at([0.1, 0.2, -0.1]);
    add(3.0, trunk.position(), trunk.velocity());
    let rods = (0..3).flat_map(|k| {
        [
            kinematics.d(k).map(|it| it.at([0.3, 0.1, 0.0])),
            kinematics.f(k).map(|it| it.at([0.3, 0.1, 0.0])),
        ]
    });
    for rod in rods.flatten().chain([kinematics.h().at([0.3, 0.1, 0.0])]) {
        add(1.3, rod.position(), rod.velocity());
    }
    let momentum = kite.momentum(&state, &inputs)?;
    assert!((momentum.mass - (3.0 + 7.0 * 1.3)).abs() < 1e-14);
    assert!((momentum.center_of_mass * momentum.mass - first).norm() < 1e-12);
    assert!((momentum.linear - linear).norm() < 1e-12);
    Ok(())
}

/// A prescribed motion adds momentum that is not part of the matrix.
#[test]
fn prescribed_motions_have_momentum() -> Result<(), Error> {
    let carts = Carts::<f64>::new();
    let mut inputs = carts.no_inputs();
    inputs.a.state = SliderState::new(0.4, 0.5);
    let mut state = carts.initial_state();
    state.v[0] = 0.25;
    let momentum = carts.momentum(&state, &inputs)?;
    assert_eq!((momentum.mass, momentum.linear), (4.0, 2.0 * 0.5 + 2.0 * 0.75));
    assert_eq!(carts.momentum_matrix(&state, &inputs)?[0], 2.0);
    assert!((momentum.center_of_mass - (0.4 + 0.1 + 0.25)).abs() < 1e-15);
    Ok(())
}

/// Bodies that are fixed to the ground have no momentum, but count for the mass and its centre.
#[test]
fn bodies_on_the_ground_count() -> Result<(), Error> {
    let fixed = Fixed::<f64>::new();
    let mut state = fixed.initial_state();
    state.joint_mut().set_angle(0.4).set_rate(2.0);
    let inputs = fixed.no_inputs();
    let at = fixed.kinematics(&state, &inputs)?;
    let (base, arm, hook) = (at.base().com(), at.arm().com(), at.crate_box().com());
    let center = (base.position() * 5.0 + (arm.position() + hook.position()) * 2.0) / 9.0;
    let found = fixed.momentum(&state, &inputs)?;
    // A dozen roundings of numbers below ten.
    assert_eq!(found.mass, 9.0);
    assert!((found.center_of_mass - center).norm() < 1e-14);
    assert!((found.linear - arm.velocity() * 2.0).norm() < 1e-14);
    let (omega, velocity) = (arm.angular_velocity(), arm.velocity());
    let axes = arm.orientation();
    let spin = axes * Vector3::new(0.02, 0.1, 0.1).component_mul(&(axes.transpose() * omega));
    let angular = spin + (arm.position() - center).cross(&(velocity * 2.0));
    assert!((found.angular - angular).norm() < 1e-14);
    let column = fixed.momentum_matrix(&state, &inputs)? * state.v;
    assert!((column.fixed_rows::<3>(3) - angular).norm() < 1e-14);

    let wall = Wall::<f64>::new();
    let found = wall.momentum(&wall.initial_state(), &wall.no_inputs())?;
    assert_eq!((found.mass, found.center_of_mass.into()), (6.0, [2.0, 0.1]));
    Ok(())
}
