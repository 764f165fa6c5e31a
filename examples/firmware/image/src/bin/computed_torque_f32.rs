//! The computed torques of the arm in single precision.
#![no_std]
#![no_main]

use models::ComputedTorque;

#[image::entry]
fn main() -> ! {
    image::run::<ComputedTorque<f32>>()
}
