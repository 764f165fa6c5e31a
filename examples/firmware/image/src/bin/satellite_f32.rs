//! The satellite in single precision.
#![no_std]
#![no_main]

use models::Satellite;

#[image::entry]
fn main() -> ! {
    image::run::<Satellite<f32>>()
}
