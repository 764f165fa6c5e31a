//! Single hinges and small mechanisms whose accelerations are known in closed form.

use crate::samples::{assert_close, cube, disc, hinge, pin_about_z};
use mstmm_reference::{
    About, Body, Chain, Dimension, Drives, Element, End, Frame, Hinge, HingeKind, Source, State,
};

/// A load on a vertical screw sinks and rotates: (J + m p²) θ'' = τ - m g p.
#[test]
fn screw_under_gravity() {
    let (pitch, inertia, mass, gravity) = (0.2, 0.3, 2.0, 9.8);
    let screw = hinge("j1", HingeKind::Screw { axis: [0.0, 0.0, 2.0], pitch });
    let chain = Chain::new("Screw", [0.0, 0.0, -gravity], vec![screw, disc("b1", mass, inertia)]);
    let (angle, rate, torque) = (1.1, -0.6, 0.7);
    let solution = chain.solve(&State { q: vec![angle], v: vec![rate] }, &[torque]);
    let reduced = inertia + mass * pitch * pitch;
    let expected = (torque - mass * gravity * pitch) / reduced;
    assert_close(solution.accelerations[0], expected, 1e-14, "acceleration");
    assert_close(solution.kinetic_energy, 0.5 * reduced * rate * rate, 1e-14, "kinetic");
    assert_close(solution.potential_energy, mass * gravity * pitch * angle, 1e-14, "potential");
    // The thread carries the weight minus the inertia force, and the moment that does not accelerate.
    let force = mass * (gravity + pitch * expected);
    assert_close(solution.points[1].force[2], force, 1e-13, "force");
    assert_close(solution.points[1].moment[2], -inertia * expected, 1e-13, "moment");
}

/// A slider accelerates by the component of gravity along its axis and the force of its motor.
#[test]
fn slider_on_a_slope() {
    let mass = 2.5;
    let slider = hinge("j1", HingeKind::Slider { axis: [3.0, 0.0, -4.0] });
    let chain = Chain::new("Slope", [0.0, 0.0, -9.8], vec![slider, disc("b1", mass, 0.1)]);
    let solution = chain.solve(&State { q: vec![0.5], v: vec![1.0] }, &[5.0]);
    assert_close(solution.accelerations[0], 9.8 * 0.8 + 5.0 / mass, 1e-14, "acceleration");
    assert_close(solution.points[2].position[0], 0.3, 1e-15, "position");
    assert_close(solution.potential_energy, -mass * 9.8 * 0.4, 1e-14, "potential");
    // The slope carries the rest of the weight, with a moment about the displaced origin.
    let across = mass * 9.8 * 0.6;
    let [at_ground, at_body] = [&solution.points[0], &solution.points[1]];
    let normal = [0.8, 0.0, 0.6];
    for k in 0..3 {
        let along = [3.0, 0.0, -4.0][k];
        assert_close(at_body.force[k], across * normal[k] + along, 1e-13, "force");
        assert_close(at_body.moment[k], 0.0, 1e-13, "moment at the body");
    }
    assert_close(at_ground.moment[1], across * 0.5, 1e-13, "moment at the ground");
}

/// A mass with a spring, a damper, friction and a limit: all forces at once.
#[test]
fn slider_with_everything_passive() {
    let mut slider = Hinge::new("j1", HingeKind::Slider { axis: [1.0, 0.0, 0.0] });
    slider.rest = vec![0.1];
    slider.linear.stiffness = vec![30.0];
    slider.linear.damping = vec![2.0];
    slider.linear.friction = vec![1.5];
    slider.linear.friction_speed = 0.4;
    slider.linear.armature = vec![0.25];
    slider.linear.limits =
        Some(mstmm_reference::Limits { range: [-0.2, 0.3], stiffness: 100.0, damping: 4.0 });
    slider.linear.motor = Source::Constant(vec![7.0]);
    let body = disc("b1", 2.0, 0.1);
    let chain = Chain::new("Passive", [0.0; 3], vec![Element::Hinge(slider), body]);
    for (x, beyond) in [(0.5, 0.2), (0.25, 0.0), (-0.6, -0.4)] {
        let v = 0.3;
        let solution = chain.solve(&State { q: vec![x], v: vec![v] }, &[99.0]);
        let stop = if beyond == 0.0 { 0.0 } else { -100.0 * beyond - 4.0 * v };
        let force = 7.0 - 30.0 * (x - 0.1) - 2.0 * v - 1.5 * v / 0.5 + stop;
        assert_close(solution.accelerations[0], force / 2.25, 1e-14, "acceleration");
        assert_close(solution.kinetic_energy, 0.5 * 2.25 * v * v, 1e-14, "kinetic");
        let stored = 15.0 * (x - 0.1) * (x - 0.1) + 50.0 * beyond * beyond;
        assert_close(solution.potential_energy, stored, 1e-14, "potential");
        assert_eq!(solution.efforts, [[7.0]]);
        assert_close(solution.points[1].force[0], 2.0 * force / 2.25, 1e-13, "passed on");
    }
}

/// Two discs on one axis, and a rotor between them that rotates with the second hinge.
#[test]
fn rotor_between_discs() {
    let (first, second, rotor) = (0.6, 0.2, 0.35);
    let mut driven = Hinge::new("j2", HingeKind::Pin { axis: [0.0, 0.0, 1.0] });
    driven.turning.armature = vec![rotor];
    let elements = vec![
        pin_about_z("j1"),
        disc("b1", 1.0, first),
        Element::Hinge(driven),
        disc("b2", 1.0, second),
    ];
    let chain = Chain::new("Discs", [0.0, -9.8, 0.0], elements);
    let (rates, torques) = ([0.5, -2.0], [0.4, -0.9]);
    let solution = chain.solve(&State { q: vec![0.3, 0.4], v: rates.to_vec() }, &torques);
    // (J1 + J2) θ1'' + J2 θ2'' = τ1 and J2 θ1'' + (J2 + R) θ2'' = τ2.
    let determinant = (first + second) * (second + rotor) - second * second;
    let expected = [
        ((second + rotor) * torques[0] - second * torques[1]) / determinant,
        ((first + second) * torques[1] - second * torques[0]) / determinant,
    ];
    for (found, expected) in solution.accelerations.iter().zip(expected) {
        assert_close(*found, expected, 1e-14, "acceleration");
    }
    let turning = 0.5 * (first * 0.25 + second * 2.25 + rotor * 4.0);
    assert_close(solution.kinetic_energy, turning, 1e-14, "kinetic");
}

/// A pendulum on a frame that rotates at a constant rate, so that its pivot accelerates.
#[test]
fn pendulum_on_a_moving_frame() {
    let chain = Chain {
        start: End::Moving { name: "cart".to_owned() },
        ..Chain::new("Cart", [0.0, -9.8, 0.0], vec![pin_about_z("j1"), cube("b1")])
    };
    let mut drives = Drives::none(&chain);
    drives.start.position = [0.3, 1.0, 0.0];
    drives.start.velocity = [2.0, 0.0, 0.0];
    drives.start.acceleration = [1.5, 0.5, 0.0];
    drives.start.rate_derivative = [0.0, 0.0, 0.7];
    let angle = 0.4_f64;
    let solution = chain.solve_driven(&State { q: vec![angle], v: vec![1.3] }, &drives);
    let lever = 0.5 / (5.0 / 12.0);
    let absolute = -lever * ((9.8 + 0.5) * angle.cos() - 1.5 * angle.sin());
    assert_close(solution.accelerations[0], absolute - 0.7, 1e-14, "acceleration");
    assert_eq!(solution.points[0].velocity, [2.0, 0.0, 0.0]);
    assert_eq!(solution.points[0].angular_acceleration, [0.0, 0.0, 0.7]);
}

/// The drive of a pendulum with a prescribed motion balances gravity and accelerates the rotor.
#[test]
fn prescribed_pendulum() {
    let mut pin = Hinge::new("j1", HingeKind::Pin { axis: [0.0, 0.0, 1.0] });
    pin.prescribed = true;
    pin.turning.stiffness = vec![3.0];
    pin.turning.damping = vec![0.5];
    pin.turning.armature = vec![0.2];
    let elements = vec![Element::Hinge(pin), cube("b1")];
    let chain = Chain::new("Driven", [0.0, -9.8, 0.0], elements);
    let mut drives = Drives::none(&chain);
    let (angle, rate, acceleration) = (0.6_f64, 1.2, -0.4);
    drives.motions[0].q = vec![angle];
    drives.motions[0].v = vec![rate];
    drives.motions[0].a = vec![acceleration];
    let solution = chain.solve_driven(&State { q: vec![], v: vec![] }, &drives);
    let torque =
        (5.0 / 12.0 + 0.2) * acceleration + 9.8 * 0.5 * angle.cos() + 3.0 * angle + 0.5 * rate;
    assert_close(solution.efforts[0][0], torque, 1e-14, "torque");
    assert!(solution.accelerations.is_empty());
    assert_close(solution.points[1].angular_acceleration[2], acceleration, 1e-15, "carried out");
}

/// A parallelogram of two cranks and a coupler, which does not rotate, moves like one pendulum.
#[test]
fn parallelogram() {
    let (crank, coupler, gravity) = (0.8, 1.5, 9.8);
    let bar = |name: &str, mass: f64, length: f64| {
        Element::Body(Body {
            name: name.to_owned(),
            mass,
            com: [0.5 * length, 0.0, 0.0],
            output: Frame::at([length, 0.0, 0.0]),
            inertia: [0.01, 0.1, 0.1, 0.0, 0.0, 0.0],
            about: About::Com,
            points: Vec::new(),
        })
    };
    let elements = vec![
        pin_about_z("j1"),
        bar("crank", 1.0, crank),
        pin_about_z("j2"),
        bar("coupler", 3.0, coupler),
        pin_about_z("j3"),
        bar("rocker", 2.0, crank),
        pin_about_z("j4"),
    ];
    let (angle, rate, torque) = (0.7_f64, 1.1, 4.0);
    let half_turn = std::f64::consts::PI;
    let state = State {
        q: vec![angle, -angle, angle + half_turn, -angle - half_turn],
        v: vec![rate, -rate, rate, -rate],
    };
    let inertia = 0.2 + (1.0 + 2.0) * 0.25 * crank * crank + 3.0 * crank * crank;
    let lever = (0.5 + 1.0 + 3.0) * crank;
    let expected = (torque - gravity * lever * angle.cos()) / inertia;
    for dimension in [Dimension::Plane, Dimension::Space] {
        let chain = Chain {
            dimension,
            finish: End::Held(Frame::at([coupler, 0.0, 0.0])),
            ..Chain::new("Parallelogram", [0.0, -gravity, 0.0], elements.clone())
        };
        let solution = chain.solve(&state, &[torque, 0.0, 0.0, 0.0]);
        assert_eq!(solution.reactions_unique, dimension == Dimension::Plane);
        for (k, sign) in [1.0, -1.0, 1.0, -1.0].into_iter().enumerate() {
            assert_close(solution.accelerations[k], sign * expected, 1e-13, "acceleration");
        }
        assert_close(solution.kinetic_energy, 0.5 * inertia * rate * rate, 1e-13, "kinetic");
    }
}

/// Two masses on a line with a spring between them oscillate about their common centre.
#[test]
fn two_masses_on_a_line() {
    let (first, second, stiffness) = (2.0, 3.0, 10.0);
    let mut elastic = Hinge::new("j1", HingeKind::LineElastic);
    elastic.linear.stiffness = vec![stiffness];
    elastic.rest = vec![0.5];
    let mass = |name: &str, mass: f64| {
        Element::Body(Body {
            name: name.to_owned(),
            mass,
            com: [0.0; 3],
            output: Frame::at([1.0, 0.0, 0.0]),
            inertia: [0.0; 6],
            about: About::Com,
            points: Vec::new(),
        })
    };
    let elements = vec![mass("b1", first), Element::Hinge(elastic), mass("b2", second)];
    let chain = Chain {
        dimension: Dimension::Line,
        start: End::Free,
        ..Chain::new("Line", [0.4, 0.0, 0.0], elements)
    };
    let solution = chain.solve(&State { q: vec![3.0, 0.8], v: vec![1.0, -2.0] }, &[0.0; 2]);
    let pull = stiffness * 0.3;
    assert_close(solution.accelerations[0], 0.4 + pull / first, 1e-14, "first mass");
    assert_close(solution.accelerations[1], -pull / second - pull / first, 1e-14, "hinge");
    assert_close(solution.points[1].force[0], -pull, 1e-14, "force");
    assert_eq!(solution.points[3].position, [5.8, 0.0, 0.0]);
}
