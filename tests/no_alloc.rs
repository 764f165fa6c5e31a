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

    /// A tree with a part, and a repeated part with a branch.
    pub chain Walker {
        gravity = [0, 0, -9.8] m/s^2;
        param load[2] = 0.1 kg;
        body Trunk {
            mass = 5 kg;
            com = [0, 0, 0.1] m;
            output = [0.5, 0, 0] m;
            inertia = diag(0.2, 0.3, 0.4) kg*m^2 about com;
            point left = [0, 0.2, 0] m;
            point right = [0, -0.2, 0] m;
        }
        body Link {
            mass = 1 kg;
            com = [0.2, 0, 0] m;
            output = [0.4, 0, 0] m;
            inertia = diag(0.01, 0.02, 0.02) kg*m^2 about com;
        }
        body Weight {
            mass = 1 kg + load;
            com = [0.1, 0, 0] m;
            inertia = diag(0.01, 0.01, 0.01) kg*m^2 about com;
        }
        part Leg(side) {
            universal(x, y) hip -> Link thigh -> pin([0, side, 0]) knee -> Link shank;
            hinge hip, knee { torque = input; }
        }
        Trunk trunk -> repeat 2 { ball joint -> Link link; link.output -> pin(z) side -> Weight weight; };
        trunk.left -> Leg(1) left;
        trunk.right -> Leg(-1) right;
        spring cord { on = left.shank.output; to = right.shank.output; stiffness = 50; length = 0.4 m; }
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
const _: () = assert!(!needs_drop::<Walker<f64>>());
const _: () = assert!(!needs_drop::<WalkerState<f64>>());
const _: () = assert!(!needs_drop::<WalkerInputs<f64>>());
const _: () = assert!(!needs_drop::<WalkerWorkspace<f64>>());
const _: () = assert!(!needs_drop::<WalkerParameters<f64>>());
const _: () = assert!(!needs_drop::<Dopri5<Walker<f64>>>());

/// Calls the integrators and all functions of a chain.
macro_rules! run {
    ($chain:expr) => {{
        let chain = &$chain;
        let mut state = chain.initial_state();
        Rk4::new(1e-3).step(chain, &mut state, |_, _| chain.no_inputs())?;
        Newmark::new(1e-3).step(chain, &mut state, |_, _| chain.no_inputs())?;
        LinearlyImplicitEuler::new(1e-3).step(chain, &mut state, |_, _| chain.no_inputs())?;
        Dopri5::new(1e-6, 1e-6).advance_to(chain, &mut state, 0.1, |_, _| chain.no_inputs())?;
        let mut at = chain.workspace();
        chain.solve_into(&state, &chain.no_inputs(), &mut at)?;
        let energy = at.kinetic_energy() + at.potential_energy();
        // Ten roundings of some ten J.
        assert!((chain.energy(&state).total() - energy).abs() < 1e-12);
        Ok(())
    }};
}

#[test]
fn everything_runs_in_a_crate_without_alloc() -> Result<(), Error> {
    let mut arm = Arm::<f64>::new();
    arm.set_payload(0.7)?;
    run!(arm)
}

#[test]
fn a_tree_runs_in_a_crate_without_alloc() -> Result<(), Error> {
    let mut walker = Walker::<f64>::new();
    walker.set_load(|index| index as f64)?;
    run!(walker)
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
