//! Comparing what generated code computes with what the independent solver says.
#![allow(dead_code)]

pub mod dual;
pub mod matter;
pub mod mechanism;

use mstmm::Point;
use mstmm_reference::Solution;

/// What generated code computes, from any chain's workspace.
pub struct Entries<'a> {
    pub accelerations: &'a [f64],
    pub points: &'a [Point<f64>],
    pub energies: [f64; 2],
}

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

/// The largest difference of any quantity, each relative to its largest value along the chain.
pub fn matches(computed: &Entries, expected: &Solution) -> f64 {
    type Ours = fn(&Point<f64>) -> Vec<f64>;
    type Theirs = fn(&mstmm_reference::Point) -> Vec<f64>;
    let quantities: [(Ours, Theirs); 8] = [
        (|p| p.position().as_slice().into(), |p| p.position.into()),
        // nalgebra keeps columns, the reference rows.
        (|p| p.orientation().matrix().transpose().as_slice().into(), |p| p.rotation.concat()),
        (|p| p.velocity().as_slice().into(), |p| p.velocity.into()),
        (|p| p.angular_velocity().as_slice().into(), |p| p.angular_velocity.into()),
        (|p| p.acceleration().as_slice().into(), |p| p.acceleration.into()),
        (|p| p.angular_acceleration().as_slice().into(), |p| p.angular_acceleration.into()),
        (|p| p.moment().as_slice().into(), |p| p.moment.into()),
        (|p| p.force().as_slice().into(), |p| p.force.into()),
    ];
    let at_points = quantities.iter().map(|(ours, theirs)| {
        let ours: Vec<f64> = computed.points.iter().flat_map(ours).collect();
        let theirs: Vec<f64> = expected.points.iter().flat_map(theirs).collect();
        difference(&ours, &theirs)
    });
    at_points
        .chain([
            difference(computed.accelerations, &expected.accelerations),
            difference(&computed.energies, &[expected.kinetic_energy, expected.potential_energy]),
        ])
        .fold(0.0, worst)
}
