//! Comparing what generated code computes with what the independent solver says.
#![allow(dead_code)]

pub mod matter;
pub mod mechanism;
pub mod motion;
pub mod moving;
pub mod printed;
pub mod states;

use mstmm::{LinePoint, PlanePoint, Point};
use mstmm_reference::Solution;

/// The largest difference of two lists, relative to the largest entry of the second (at least 1).
pub fn difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let scale = b.iter().fold(1.0_f64, |largest, x| largest.max(x.abs()));
    a.iter().zip(b).map(|(x, y)| (x - y).abs() / scale).fold(0.0, worst)
}

/// The larger number; a NaN wins.
pub fn worst(a: f64, b: f64) -> f64 {
    if b.is_nan() || b > a { b } else { a }
}

/// A connection point of any dimension, entry by entry beside one of the reference.
pub trait ComparedPoint {
    /// Position, orientation, velocity, angular velocity, acceleration, angular acceleration.
    fn motion(&self) -> [Vec<f64>; 6];
    /// Moment and force.
    fn load(&self) -> [Vec<f64>; 2];
    fn motion_of(reference: &mstmm_reference::Point) -> [Vec<f64>; 6];
    fn load_of(reference: &mstmm_reference::Point) -> [Vec<f64>; 2];
}

impl ComparedPoint for Point<f64> {
    fn motion(&self) -> [Vec<f64>; 6] {
        [
            self.position().as_slice().into(),
            // nalgebra keeps columns, the reference rows.
            self.orientation().matrix().transpose().as_slice().into(),
            self.velocity().as_slice().into(),
            self.angular_velocity().as_slice().into(),
            self.acceleration().as_slice().into(),
            self.angular_acceleration().as_slice().into(),
        ]
    }

    fn load(&self) -> [Vec<f64>; 2] {
        [self.moment().as_slice().into(), self.force().as_slice().into()]
    }

    fn motion_of(p: &mstmm_reference::Point) -> [Vec<f64>; 6] {
        [
            p.position.into(),
            p.rotation.concat(),
            p.velocity.into(),
            p.angular_velocity.into(),
            p.acceleration.into(),
            p.angular_acceleration.into(),
        ]
    }

    fn load_of(p: &mstmm_reference::Point) -> [Vec<f64>; 2] {
        [p.moment.into(), p.force.into()]
    }
}

impl ComparedPoint for PlanePoint<f64> {
    fn motion(&self) -> [Vec<f64>; 6] {
        let (cosine, sine) = self.cos_sin();
        [
            self.position().as_slice().into(),
            vec![cosine, sine],
            self.velocity().as_slice().into(),
            vec![self.angular_velocity()],
            self.acceleration().as_slice().into(),
            vec![self.angular_acceleration()],
        ]
    }

    fn load(&self) -> [Vec<f64>; 2] {
        [vec![self.moment()], self.force().as_slice().into()]
    }

    fn motion_of(p: &mstmm_reference::Point) -> [Vec<f64>; 6] {
        [
            p.position[..2].into(),
            vec![p.rotation[0][0], p.rotation[1][0]],
            p.velocity[..2].into(),
            vec![p.angular_velocity[2]],
            p.acceleration[..2].into(),
            vec![p.angular_acceleration[2]],
        ]
    }

    fn load_of(p: &mstmm_reference::Point) -> [Vec<f64>; 2] {
        [vec![p.moment[2]], p.force[..2].into()]
    }
}

impl ComparedPoint for LinePoint<f64> {
    fn motion(&self) -> [Vec<f64>; 6] {
        let nothing = Vec::new;
        let [position, velocity] = [vec![self.position()], vec![self.velocity()]];
        [position, nothing(), velocity, nothing(), vec![self.acceleration()], nothing()]
    }

    fn load(&self) -> [Vec<f64>; 2] {
        [Vec::new(), vec![self.force()]]
    }

    fn motion_of(p: &mstmm_reference::Point) -> [Vec<f64>; 6] {
        let nothing = Vec::new;
        let [position, velocity] = [vec![p.position[0]], vec![p.velocity[0]]];
        [position, nothing(), velocity, nothing(), vec![p.acceleration[0]], nothing()]
    }

    fn load_of(p: &mstmm_reference::Point) -> [Vec<f64>; 2] {
        [Vec::new(), vec![p.force[0]]]
    }
}

/// The largest difference of any quantity of the points' motion, each relative to its largest value
/// along the chain.
pub fn motions_match<P: ComparedPoint>(computed: &[P], expected: &Solution) -> f64 {
    quantities_match(computed.iter().map(P::motion), expected.points.iter().map(P::motion_of))
}

/// The same for forces and moments.
pub fn loads_match<P: ComparedPoint>(computed: &[P], expected: &Solution) -> f64 {
    quantities_match(computed.iter().map(P::load), expected.points.iter().map(P::load_of))
}

fn quantities_match<const N: usize>(
    computed: impl Iterator<Item = [Vec<f64>; N]>,
    expected: impl Iterator<Item = [Vec<f64>; N]>,
) -> f64 {
    let (computed, expected): (Vec<_>, Vec<_>) = (computed.collect(), expected.collect());
    let along = |points: &[[Vec<f64>; N]], k: usize| -> Vec<f64> {
        points.iter().flat_map(|point| point[k].clone()).collect()
    };
    (0..N).map(|k| difference(&along(&computed, k), &along(&expected, k))).fold(0.0, worst)
}
