//! The inertia of bodies, with parameters as they are set.

use super::models::{Crawler, Kinds, MASS, Raft, Rope, Train};
use mstmm::Described;
use mstmm::description::BodyInertia;
use mstmm::nalgebra::{Matrix3, Vector3};

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
