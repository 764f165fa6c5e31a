//! Single bodies whose accelerations and motions are known in closed form.

use crate::samples::{assert_close, central_inertia, cube, hinge};
use mstmm_reference::{
    About, Body, Chain, Element, End, Frame, HingeKind, Random, State, random_state, simulate,
};
use nalgebra::Vector3;

/// A cube on a pin about z, at an angle from the x axis, has the angular acceleration
/// m g l cos(angle) / I; its hinge carries the centripetal force and the rest of the weight.
#[test]
fn pin_pendulum() {
    let pin = hinge("j1", HingeKind::Pin { axis: [0.0, 0.0, 3.0] });
    let chain = Chain::new("Pendulum", [0.0, -9.8, 0.0], vec![pin, cube("b1")]);
    let (angle, rate, torque) = (0.7_f64, 1.3, 2.0);
    let solution = chain.solve(&State { q: vec![angle], v: vec![rate] }, &[torque]);
    let falling = (torque - 9.8 * 0.5 * angle.cos()) / (5.0 / 12.0);
    assert_close(solution.accelerations[0], falling, 1e-14, "acceleration");

    let (along, across) = (-0.5 * rate * rate, 0.5 * falling);
    let force_x = along * angle.cos() - across * angle.sin();
    let force_y = along * angle.sin() + across * angle.cos() + 9.8;
    assert_eq!(solution.points.len(), 3);
    for point in &solution.points[..2] {
        assert_close(point.force[0], force_x, 1e-14, "force along x");
        assert_close(point.force[1], force_y, 1e-14, "force along y");
        assert_close(point.moment[2], -torque, 1e-14, "moment");
    }
    assert_close(solution.kinetic_energy, 0.5 * 5.0 / 12.0 * rate * rate, 1e-14, "kinetic");
    assert_close(solution.potential_energy, 9.8 * 0.5 * angle.sin(), 1e-14, "potential");
}

/// A floating body follows Euler's equations about its centre of mass, which falls freely.
#[test]
fn tumbling_body() {
    let body = Body {
        name: "b1".to_owned(),
        mass: 2.0,
        com: [0.3, -0.2, 0.4],
        output: Frame::at([0.5, 0.5, 0.0]),
        inertia: [1.3, 1.1, 1.7, 0.1, -0.2, 0.05],
        about: About::Input,
        points: Vec::new(),
    };
    let inertia = central_inertia(&body);
    let com = Vector3::from(body.com);
    let gravity = [1.0, 2.0, -9.0];
    let chain = floating(gravity, body);
    let state = random_state(&mut Random::new(1), &chain);
    let solution = chain.solve(&state, &[0.0; 6]);

    let spin = Vector3::from_column_slice(&state.v[3..6]);
    let euler = inertia.try_inverse().unwrap() * -spin.cross(&(inertia * spin));
    let rotation = crate::samples::matrix(&solution.points[0].rotation);
    let of_input =
        Vector3::from(gravity) - rotation * (euler.cross(&com) + spin.cross(&spin.cross(&com)));
    for k in 0..3 {
        assert_close(solution.accelerations[k], of_input[k], 1e-13, "input point");
        assert_close(solution.accelerations[3 + k], euler[k], 1e-13, "angular");
    }
    let loads = solution.points.iter().flat_map(|point| [point.force, point.moment]);
    assert!(loads.flatten().all(|load| load == 0.0), "free ends carry nothing");
}

/// The axis of a free symmetric top moves on a cone with a known period.
#[test]
fn symmetric_top() {
    let (across, along) = (0.5, 0.8);
    let body = Body {
        name: "b1".to_owned(),
        mass: 2.0,
        com: [0.0; 3],
        output: Frame::IDENTITY,
        inertia: [across, across, along, 0.0, 0.0, 0.0],
        about: About::Com,
        points: Vec::new(),
    };
    let chain = floating([0.0; 3], body);
    let (spin, wobble) = (3.0, 0.7);
    let start = State {
        q: vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
        v: vec![0.0, 0.0, 0.0, wobble, 0.0, spin],
    };
    simulate(&chain, &start, &[0.0; 6], &[1.0, 4.0, 10.0], |sample| {
        // In the body frame, the angular velocity rotates at (along - across) / across * spin.
        let phase = (along - across) / across * spin * sample.time;
        let expected = [wobble * phase.cos(), wobble * phase.sin(), spin];
        for (found, expected) in sample.state.v[3..].iter().zip(expected) {
            assert_close(*found, expected, 1e-11, "angular velocity");
        }
    });
}

fn floating(gravity: [f64; 3], body: Body) -> Chain {
    let elements = vec![Element::Body(body)];
    Chain { start: End::Free, ..Chain::new("Body", gravity, elements) }
}
