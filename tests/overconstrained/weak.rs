//! A linkage that comes near a singular position, where its closure has one direction less.
//!
//! The weakest of the singular values that count falls with the square of the first angle. Down to
//! 1e-3 of the greatest they must be told from those that do not count.

use super::algebra::Real;
use super::face::Closed;
use super::goldberg::{Six, SixByTransfer, SixTilted, SixTiltedByTransfer, six, six_tilted};
use super::linkage::Linkage;
use super::states::compare;

/// From 2 rad to 0.07 rad in a geometric sequence, each configuration found from the previous one.
fn approached<C: Closed<Scalar = f64>>(chain: &C, mut linkage: Linkage) {
    let mut crank = 2.0;
    while crank > 0.07 {
        compare(chain, &linkage, &[crank]);
        linkage.start = linkage.angles(crank.exact()).iter().map(|x| x.high).collect();
        crank *= 0.85;
    }
}

#[test]
fn riccati() {
    approached(&Six::<f64>::new(), six());
}

#[test]
fn transfer() {
    approached(&SixByTransfer::<f64>::new(), six());
}

#[test]
fn tilted_by_riccati() {
    approached(&SixTilted::<f64>::new(), six_tilted());
}

#[test]
fn tilted_by_transfer() {
    approached(&SixTiltedByTransfer::<f64>::new(), six_tilted());
}
