//! Nothing is allocated, neither by generated code nor by the integrators.
//!
//! A counting allocator would need `unsafe`, which this workspace forbids. So the test uses two other
//! facts. This crate is `no_std` and does not use `alloc`, so generated code cannot allocate. No value of
//! the runtime needs to be dropped, so no value owns heap memory. Cargo reports that nalgebra is used
//! without `std` and `alloc`.
#![no_std]

extern crate std;

use core::mem::needs_drop;
use mstmm::prelude::*;
use mstmm::{Error, Point};
use std::process::Command;
use std::string::String;

mstmm_chain! {
    pub chain Arm {
        gravity = [0, -9.8, 0] m/s^2;
        param payload = 0.5 kg;
        body Link {
            mass = 1 kg + payload;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(1/6, 5/12, 5/12) kg*m^2 about com;
        }
        ground -> ball shoulder -> Link upper -> pin(z) elbow -> Link lower;
        hinge shoulder, elbow { torque = input; }
    }
}

const _: () = assert!(!needs_drop::<Arm<f64>>());
const _: () = assert!(!needs_drop::<ArmState<f64>>());
const _: () = assert!(!needs_drop::<ArmInputs<f64>>());
const _: () = assert!(!needs_drop::<ArmWorkspace<f64>>());
const _: () = assert!(!needs_drop::<ArmParameters<f64>>());
const _: () = assert!(!needs_drop::<Point<f64>>());
const _: () = assert!(!needs_drop::<Error>());
const _: () = assert!(!needs_drop::<Rk4<Arm<f64>>>());
const _: () = assert!(!needs_drop::<Dopri5<Arm<f64>>>());

#[test]
fn everything_runs_in_a_crate_without_alloc() -> Result<(), Error> {
    let mut chain = Arm::<f64>::new();
    chain.set_payload(0.7)?;
    let mut state = chain.initial_state();
    Rk4::new(1e-3).step(&chain, &mut state, |_, _| chain.no_inputs())?;
    Dopri5::new(1e-6, 1e-6).advance_to(&chain, &mut state, 0.1, |_, _| chain.no_inputs())?;
    let mut at = chain.workspace();
    chain.solve_into(&state, &chain.no_inputs(), &mut at)?;
    assert!(
        (chain.energy(&state).total() - (at.kinetic_energy() + at.potential_energy())).abs()
            < 1e-12
    );
    Ok(())
}

#[test]
fn dependencies_of_the_facade_have_no_alloc() {
    let tree = Command::new(env!("CARGO"))
        .args(["tree", "--offline", "--package", "mstmm", "--no-default-features"])
        .args(["--edges", "normal,features,no-proc-macro", "--prefix", "none"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("cargo runs");
    assert!(tree.status.success(), "{}", String::from_utf8_lossy(&tree.stderr));
    let tree = String::from_utf8_lossy(&tree.stdout).into_owned();
    assert!(tree.lines().any(|line| line.starts_with("nalgebra ")), "{tree}");
    for line in tree.lines() {
        let allocates = ["feature \"std\"", "feature \"alloc\""].iter().any(|f| line.contains(f));
        assert!(!allocates, "{line}\n{tree}");
    }
}
