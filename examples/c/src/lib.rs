//! An arm behind the C header `include/mstmm_arm.h`; the `README.md` says how it gets into
//! firmware.
#![no_std]

mod arm;
mod chain;
mod functions;
mod status;

pub use arm::{Arm, Inputs, Point, Results, State};
pub use chain::{Chain, ChainInputs, ChainState, ChainWorkspace};
pub use functions::*;
pub use status::Status;

/// The numbers that everything is computed in: `mstmm_real` of the header.
pub type Real = f32;

// On a computer `std` brings the panic handler that a static library must have.
#[cfg(not(target_os = "none"))]
extern crate std;

/// The one of firmware. Nothing here panics, so a linker leaves it out.
#[cfg(target_os = "none")]
#[panic_handler]
fn halt(_: &core::panic::PanicInfo) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
