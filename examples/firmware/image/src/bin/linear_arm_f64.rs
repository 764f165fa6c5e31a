//! The linear model of the arm in double precision.
#![no_std]
#![no_main]

use models::LinearArm;

#[image::entry]
fn main() -> ! {
    image::run::<LinearArm<f64>>()
}
