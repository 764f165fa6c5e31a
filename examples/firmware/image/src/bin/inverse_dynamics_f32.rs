//! The inverse dynamics of the arm in single precision.
#![no_std]
#![no_main]

use models::InverseDynamics;

#[image::entry]
fn main() -> ! {
    image::run::<InverseDynamics<f32>>()
}
