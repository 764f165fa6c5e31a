//! Generated chains compared with the paper's printed matrices: sections 4.1 and 4.2 in motion, at every
//! connection point.

use mstmm::BodyResult;
use mstmm::nalgebra::{Matrix3, SVector, Vector3};
use mstmm::paper::body::{Body, Load, Motion};
use mstmm::paper::chain::{self, InputEnd, OutputEnd};
use mstmm::paper::pin::Pin;
use mstmm::paper::{TransferMatrix, ball};
use mstmm::prelude::*;

/// The product costs three bodies about three digits.
const TOLERANCE: f64 = 1e-11;

mstmm_chain! {
    chain BallPendulum {
        gravity = [0, -9.8, 0] m/s^2;
        body Cube {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
        }
        ground -> ball shoulder -> Cube upper -> ball elbow -> Cube middle -> ball wrist -> Cube lower;
        hinge wrist { start_rate = [0, 0.1, 0] rad/s; }
    }
    chain Arm {
        gravity = [0, -9.8, 0] m/s^2;
        body Cube {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
        }
        ground
            -> pin(z) first -> Cube upper -> pin(z) second -> Cube middle -> pin(z) third -> Cube lower;
        hinge second { start_rate = 1 rad/s; }
    }
}

/// The cube of both chains in motion, [P, Eq. (21)].
fn cube(result: &BodyResult<f64>) -> TransferMatrix<f64> {
    let body = Body {
        mass: 1.0,
        com: Vector3::new(0.5, 0.0, 0.0),
        output: Vector3::new(1.0, 0.0, 0.0),
        inertia: Matrix3::from_diagonal(&Vector3::new(1.0 / 6.0, 5.0 / 12.0, 5.0 / 12.0)),
    };
    let motion = Motion {
        orientation: result.input().orientation().into_inner(),
        angular_velocity: result.input().angular_velocity(),
    };
    let weight = Load { force: Vector3::new(0.0, -9.8, 0.0), moment: Vector3::zeros() };
    body.blocks(&motion, &weight).transfer_matrix()
}

/// Compares all outputs, of hinge, body, hinge, …, with the ends of the three bodies.
fn compare(found: &[SVector<f64, 13>; 6], bodies: &[BodyResult<f64>; 3]) {
    let ends = bodies.iter().flat_map(|body| [*body.input().z(), *body.output().z()]);
    for (found, generated) in found.iter().zip(ends) {
        let expected = generated.to_vector();
        let apart = (found - expected).amax() / expected.amax();
        assert!(apart < TOLERANCE, "{apart:e}\n{found}{expected}");
    }
}

#[test]
fn the_ball_pendulum() -> Result<(), mstmm::Error> {
    let chain = BallPendulum::<f64>::new();
    let (mut state, mut rk4, mut at) = (chain.initial_state(), Rk4::new(1e-2), chain.workspace());
    for _ in 0..20 {
        for _ in 0..10 {
            rk4.step(&chain, &mut state, |_, _| chain.no_inputs())?;
        }
        chain.solve_into(&state, &chain.no_inputs(), &mut at)?;
        let bodies = [at.upper(), at.middle(), at.lower()];
        let [a, b, c] = bodies.each_ref().map(cube);
        let elements = [
            ball::transfer_matrix(&a),
            a,
            ball::transfer_matrix(&b),
            b,
            ball::transfer_matrix(&c),
            c,
        ];
        let states = chain::solve(&elements, &InputEnd::ball(), &OutputEnd::free());
        compare(&states.outputs, &bodies);
    }
    Ok(())
}

#[test]
fn the_arm() -> Result<(), mstmm::Error> {
    let chain = Arm::<f64>::new();
    let (mut state, mut rk4, mut at) = (chain.initial_state(), Rk4::new(1e-2), chain.workspace());
    for _ in 0..20 {
        for _ in 0..10 {
            rk4.step(&chain, &mut state, |_, _| chain.no_inputs())?;
        }
        chain.solve_into(&state, &chain.no_inputs(), &mut at)?;
        let bodies = [at.upper(), at.middle(), at.lower()];
        let rates = [state.first().rate(), state.second().rate(), state.third().rate()];
        let hinge = |k: usize, body: &TransferMatrix<f64>| {
            let point = bodies[k].input();
            let orientation = point.orientation().into_inner();
            let pin =
                Pin { orientation, angular_velocity: point.angular_velocity(), rate: rates[k] };
            pin.blocks(body, &orientation).transfer_matrix()
        };
        let [a, b, c] = bodies.each_ref().map(cube);
        let elements = [hinge(0, &a), a, hinge(1, &b), b, hinge(2, &c), c];
        let ground = InputEnd::pin(&Matrix3::identity());
        let states = chain::solve(&elements, &ground, &OutputEnd::free());
        compare(&states.outputs, &bodies);
    }
    Ok(())
}
