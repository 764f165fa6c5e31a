//! The inertia of bodies, with parameters as they are set.

use super::models::{Crawler, Kinds, MASS, Raft, Rope, Train};
use mstmm::Described;
use mstmm::description::BodyInertia;
use mstmm::nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};

fn of<C: Described<Scalar = f64>>(chain: &C, body: &str) -> BodyInertia<f64> {
    let index = C::DESCRIPTION.body(body).expect(body);
    chain.inertia(index).expect(body)
}

#[test]
fn inertia_is_what_was_written() {
    let chain = Kinds::<f64>::new();
    let block = of(&chain, "b3");
    let tensor = Matrix3::new(0.4, 0.01, 0.02, 0.01, 0.5, -0.03, 0.02, -0.03, 0.6);
    let expected = BodyInertia { mass: 1.5, com: Vector3::new(0.1, 0.1, 0.2), tensor };
    assert_eq!(block, expected);
    // A cube about the middle of a face, by Steiner's theorem: `I_C = I_I − m d²` for axes at a distance d.
    let cube = of(&chain, "tip");
    let moved = 5.0 / 16.0 - MASS * 0.25 * 0.25;
    assert_eq!((cube.mass, cube.com), (MASS, Vector3::new(0.25, 0.0, 0.0)));
    let expected = Matrix3::from_diagonal(&Vector3::new(0.125, moved, moved));
    assert!((cube.tensor - expected).norm() < 1e-15, "{}", cube.tensor);
    assert!(chain.inertia(Kinds::<f64>::DESCRIPTION.bodies().len()).is_none());
}

mstmm::mstmm_chain! {
    chain Skew {
        answers = linearize;
        param roll = 20 deg;
        body Wing {
            mass = 2 kg; com = [0.1, 0.2, 0.3] m; output = [1, 0, 0] m;
            inertia = tensor(0.4, 0.5, 0.6, 0.02, -0.01, 0.05) kg*m^2 about input turned rpy(roll, -70 deg, 130 deg);
        }
        body Fin {
            mass = 2 kg; com = [0, 0, 0] m;
            inertia = diag(0.3, 0.4, 0.5) kg*m^2 about com turned quaternion(0.5, -1, 0.25, 2);
        }
        ground -> ball root -> Wing wing -> pin([1, 2, 3]) flap -> Fin fin;
    }
}

/// `R I Rᵀ` with rotation matrices of another library.
#[test]
fn inertia_in_rotated_axes_is_that_of_the_body() -> Result<(), mstmm::Error> {
    let mut chain = Skew::<f64>::new();
    for roll in [20f64.to_radians(), -2.5] {
        chain.set_roll(roll)?;
        let angles = [roll, -70f64.to_radians(), 130f64.to_radians()];
        let rotation = Rotation3::from_euler_angles(angles[0], angles[1], angles[2]);
        let tensor = Matrix3::new(0.4, 0.02, -0.01, 0.02, 0.5, 0.05, -0.01, 0.05, 0.6);
        let about_input: Matrix3<f64> = rotation * tensor * rotation.inverse();
        let c = Vector3::new(0.1, 0.2, 0.3);
        let expected: Matrix3<f64> =
            about_input - 2.0 * (c.norm_squared() * Matrix3::identity() - c * c.transpose());
        let found = of(&chain, "wing").tensor;
        assert!((found - expected).norm() < 2e-15, "{found}{expected}");
    }
    let quaternion = UnitQuaternion::from_quaternion(Quaternion::new(0.5, -1.0, 0.25, 2.0));
    let rotation = quaternion.to_rotation_matrix();
    let expected: Matrix3<f64> =
        rotation * Matrix3::from_diagonal(&Vector3::new(0.3, 0.4, 0.5)) * rotation.inverse();
    let found = of(&chain, "fin").tensor;
    assert!((found - expected).norm() < 1e-15, "{found}{expected}");
    Ok(())
}

/// The derivative with respect to the angle is that of central differences.
#[test]
fn accelerations_have_derivatives_by_the_angle_of_an_inertia() -> Result<(), mstmm::Error> {
    let mut chain = Skew::<f64>::new();
    let mut state = chain.initial_state();
    state.v.copy_from_slice(&[1.0, -2.0, 0.5, 3.0]);
    let exact = chain.linearize(&state, &chain.no_inputs())?.by_parameters;
    let (h, roll) = (1e-5, 20f64.to_radians());
    let mut at = |roll: f64| {
        chain.set_roll(roll)?;
        chain.accelerations(&state, &chain.no_inputs())
    };
    let difference = (at(roll + h)? - at(roll - h)?) / (2.0 * h);
    // Accelerations of about 10: rounding of 1e-15 / h, and h² times third derivatives.
    assert!((exact.column(0) - difference).norm() < 1e-8, "{exact}{difference}");
    assert!(exact.norm() > 0.1);
    Ok(())
}

#[test]
fn parameters_change_inertia() -> Result<(), mstmm::Error> {
    let mut chain = Kinds::<f64>::new();
    chain.set_payload(2.5)?;
    chain.set_slope(-0.3)?;
    let block = of(&chain, "b9");
    assert_eq!((block.mass, block.com), (3.5, Vector3::new(0.1, -0.3, 0.2)));
    let mut chain = Crawler::<f64>::new();
    chain.set_knot(|index| 0.5 * index as f64)?;
    chain.set_bend(|index| 10.0 * index as f64)?;
    for index in 0..3 {
        let link = of(&chain, &format!("link[{index}]"));
        assert_eq!(link.mass, 1.0 + 0.5 * index as f64);
        assert!((link.com.y - index as f64).abs() < 1e-15);
    }
    assert_eq!(of(&chain, "left.thigh").com.y, 0.02);
    assert_eq!(of(&chain, "right.thigh").com.y, -0.02);
    Ok(())
}

/// Total mass and centre of mass by `momentum`, which computes them by the equations of the chain.
#[test]
fn masses_add_up_to_those_of_momentum() -> Result<(), mstmm::Error> {
    let mut crawler = Crawler::<f64>::new();
    crawler.set_knot(|index| 0.25 * index as f64)?;
    crawler.set_hull(7.0)?;
    let total = total(&crawler);
    let expected = crawler.momentum(&crawler.initial_state(), &crawler.no_inputs())?.mass;
    assert!((total - expected).abs() < 1e-13 * expected, "{total} is not {expected}");
    let mut raft = Raft::<f64>::new();
    raft.set_load(0.125)?;
    let expected = raft.momentum(&raft.initial_state(), &raft.no_inputs())?.mass;
    assert!((self::total(&raft) - expected).abs() < 1e-13 * expected);
    Ok(())
}

fn total<C: Described<Scalar = f64>>(chain: &C) -> f64 {
    let bodies = 0..C::DESCRIPTION.bodies().len();
    bodies.map(|body| chain.inertia(body).expect("a body").mass).sum()
}

#[test]
fn planes_and_lines_have_what_they_know() {
    let raft = of(&Raft::<f64>::new(), "third");
    let moment = 0.9 - 2.5 * (0.5 * 0.5 + 0.1 * 0.1);
    let mut expected = Matrix3::zeros();
    expected[(2, 2)] = moment;
    assert_eq!(raft.com, Vector3::new(0.5, 0.1, 0.0));
    assert!((raft.tensor - expected).norm() < 1e-15, "{}", raft.tensor);
    let car = of(&Train::<f64>::new(), "second");
    assert_eq!((car.mass, car.tensor), (20.0, Matrix3::zeros()));
    assert_eq!(of(&Rope::<f64>::new(), "rod[77]").mass, 1.0);
}
