//! The computed torques of the arm in double precision.
#![no_std]
#![no_main]

use models::ComputedTorque;

#[image::entry]
fn main() -> ! {
    image::run::<ComputedTorque<f64>>()
}
