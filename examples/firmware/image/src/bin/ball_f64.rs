//! Three cubes on balls in double precision.
#![no_std]
#![no_main]

use models::BallPendulum;

#[image::entry]
fn main() -> ! {
    image::run::<BallPendulum<f64>>()
}
