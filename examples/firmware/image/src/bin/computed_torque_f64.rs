//! Computed torque of the arm with an estimate of its payload in double precision.
#![no_std]
#![no_main]

use models::ComputedTorque;

#[image::entry]
fn main() -> ! {
    image::run::<ComputedTorque<f64>>()
}
