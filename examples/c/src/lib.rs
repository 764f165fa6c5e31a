//! An arm with the C header `include/mstmm_arm.h`; see `README.md` for its use in firmware.
#![no_std]

mod arm;
mod chain;
mod functions;
mod status;

pub use arm::{Arm, Inputs, Point, Results, State};
pub use chain::{Chain, ChainInputs, ChainState, ChainWorkspace};
pub use functions::*;
pub use status::Status;

/// The scalar of all computations: `mstmm_real` of the header.
pub type Real = f32;

// On a computer `std` provides the panic handler that a static library must have.
#[cfg(not(target_os = "none"))]
extern crate std;

/// The panic handler of firmware. Nothing here panics, so the linker removes it.
#[cfg(target_os = "none")]
#[panic_handler]
fn halt(_: &core::panic::PanicInfo) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
