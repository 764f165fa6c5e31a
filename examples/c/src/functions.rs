//! The functions of the header, which documents them.
//!
//! A pointer that may be null is an `Option` of a reference, so no function needs unsafe code. The
//! caller must pass pointers to the right structs.
#![expect(unsafe_code, reason = "names that a linker sees")]

use core::ffi::c_char;
use core::mem::MaybeUninit;

use crate::arm::{Arm, Inputs, Results, State};
use crate::{Real, Status, status};

/// Makes an arm.
// SAFETY: nothing else has this name.
#[unsafe(no_mangle)]
pub extern "C" fn mstmm_arm_init(arm: Option<&mut MaybeUninit<Arm>>, step: Real) -> Status {
    let Some(arm) = arm else { return Status::NULL_POINTER };
    if !step.is_finite() {
        return Status::NOT_FINITE;
    }
    arm.write(Arm::new(step));
    Status::OK
}

/// Writes the start of the arm.
// SAFETY: nothing else has this name.
#[unsafe(no_mangle)]
pub extern "C" fn mstmm_arm_initial_state(
    arm: Option<&Arm>,
    state: Option<&mut MaybeUninit<State>>,
) -> Status {
    let (Some(arm), Some(state)) = (arm, state) else { return Status::NULL_POINTER };
    state.write(arm.initial_state());
    Status::OK
}

/// Sets the payload's mass in kg.
// SAFETY: nothing else has this name.
#[unsafe(no_mangle)]
pub extern "C" fn mstmm_arm_set_payload_mass(arm: Option<&mut Arm>, mass: Real) -> Status {
    let Some(arm) = arm else { return Status::NULL_POINTER };
    arm.set_payload_mass(mass).into()
}

/// Sets the payload's moment of inertia about its own z in kg m².
// SAFETY: nothing else has this name.
#[unsafe(no_mangle)]
pub extern "C" fn mstmm_arm_set_payload_spin(arm: Option<&mut Arm>, moment: Real) -> Status {
    let Some(arm) = arm else { return Status::NULL_POINTER };
    arm.set_payload_spin(moment).into()
}

/// Takes one step.
// SAFETY: nothing else has this name.
#[unsafe(no_mangle)]
pub extern "C" fn mstmm_arm_step(
    arm: Option<&mut Arm>,
    state: Option<&mut State>,
    inputs: Option<&Inputs>,
) -> Status {
    let (Some(arm), Some(state), Some(inputs)) = (arm, state, inputs) else {
        return Status::NULL_POINTER;
    };
    arm.step(state, *inputs).into()
}

/// Computes all results.
// SAFETY: nothing else has this name.
#[unsafe(no_mangle)]
pub extern "C" fn mstmm_arm_solve(
    arm: Option<&Arm>,
    state: Option<&State>,
    inputs: Option<&Inputs>,
    results: Option<&mut MaybeUninit<Results>>,
) -> Status {
    let (Some(arm), Some(state), Some(inputs), Some(results)) = (arm, state, inputs, results)
    else {
        return Status::NULL_POINTER;
    };
    arm.solve(*state, *inputs).map(|solved| _ = results.write(solved)).into()
}

/// Returns the size of an arm in bytes.
// SAFETY: nothing else has this name.
#[unsafe(no_mangle)]
pub extern "C" fn mstmm_arm_size() -> u32 {
    size_of::<Arm>() as u32
}

/// Returns the name of a code.
// SAFETY: nothing else has this name.
#[unsafe(no_mangle)]
pub extern "C" fn mstmm_code_name(code: i32) -> *const c_char {
    status::code_name(code).as_ptr()
}

/// Returns the name of a hinge.
// SAFETY: nothing else has this name.
#[unsafe(no_mangle)]
pub extern "C" fn mstmm_arm_hinge_name(hinge: i32) -> *const c_char {
    status::hinge_name(hinge).as_ptr()
}
