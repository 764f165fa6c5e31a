//! The cart and the pole, with the gain of a regulator that is computed on the board, in single precision.
#![no_std]
#![no_main]

use models::CartPole;

#[image::entry]
fn main() -> ! {
    image::run::<CartPole<f32>>()
}
