//! The arm in double precision.
#![no_std]
#![no_main]

use models::Arm;

#[image::entry]
fn main() -> ! {
    image::run::<Arm<f64>>()
}
