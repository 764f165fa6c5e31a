//! Rust paths as numbers.

use mstmm::mstmm_chain;

/// Names that the generated code might take for its own.
const T: f64 = 2.0;
const Q: f64 = 0.25;

/// Neither may a function get in the way, nor a module.
#[allow(dead_code)]
mod shadows {
    pub fn c() {}
    pub fn state() {}
    pub fn t0() {}
    pub mod inputs {}
}
#[allow(unused_imports)]
use shadows::{c, inputs, state, t0};

mod catalogue {
    pub const DENSITY: f64 = 7850.0;
    pub mod rods {
        pub const LENGTH: f64 = 0.5;
    }
    pub struct Steel;
    impl Steel {
        pub const MASS: f64 = 3.0;
    }
}

/// Kinetic energy of the chain's only body at 2 m/s over two: its mass.
macro_rules! mass_of {
    ($Chain:ident) => {{
        let chain = $Chain::<f64>::new();
        let mut state = chain.initial_state();
        state.lump_mut().set_velocity([2.0, 0.0, 0.0].into());
        chain.energy(&state).kinetic / 2.0
    }};
}

mstmm_chain! {
    chain ByName {
        body Lump { mass = T; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; }
        Lump;
    }
    chain ByPath {
        body Lump {
            mass = catalogue::Steel::MASS;
            com = [0, 0, catalogue::rods::LENGTH];
            inertia = diag(1, 1, 1) about com;
        }
        Lump;
    }
    chain ByFormula {
        body Lump {
            mass = catalogue::DENSITY * (PI * Q^2 * catalogue::rods::LENGTH) / 2 + T g - Q kg;
            com = [0, 0, 0];
            inertia = diag(1, sqrt(T), cos(Q)) about com;
        }
        Lump;
    }
    chain ByAbsolutePath {
        body Lump {
            mass = ::core::f64::consts::E + crate::language::constants::Q * (1 kg);
            com = [0, 0, 0];
            inertia = diag(1, 1, 1) about com;
        }
        Lump;
    }
}

#[test]
fn constants_are_masses() {
    assert_eq!(mass_of!(ByName), 2.0);
    assert_eq!(mass_of!(ByPath), 3.0);
    let cylinder = 7850.0 * std::f64::consts::PI * 0.0625 * 0.5 / 2.0;
    crate::assert_close([mass_of!(ByFormula) / 100.0], [(cylinder + 0.002 - 0.25) / 100.0]);
    crate::assert_close([mass_of!(ByAbsolutePath)], [std::f64::consts::E + 0.25]);
}

#[test]
fn a_constant_is_as_good_as_its_number() {
    mstmm_chain! {
        chain ByConstants {
            gravity = [0, -T, 0] m/s^2;
            body Rod {
                mass = T;
                com = [Q, 0, 0];
                output = [Q, 0, 0] m turned rpy(0, 0, 0.25 * T);
                inertia = diag(0.1, T, T) kg*m^2 about com;
            }
            ground at [0, Q, 0] -> pin([Q, 0, T]) shoulder -> Rod -> ball wrist -> Rod tool;
            hinge shoulder { start = Q; start_rate = T; torque = Q; }
        }
        chain ByNumbers {
            gravity = [0, -2, 0] m/s^2;
            body Rod {
                mass = 2;
                com = [0.25, 0, 0];
                output = [0.25, 0, 0] m turned rpy(0, 0, 0.5);
                inertia = diag(0.1, 2, 2) kg*m^2 about com;
            }
            ground at [0, 0.25, 0] -> pin([0.25, 0, 2]) shoulder -> Rod -> ball wrist -> Rod tool;
            hinge shoulder { start = 0.25; start_rate = 2; torque = 0.25; }
        }
    }
    let (by_constants, by_numbers) = (ByConstants::<f64>::new(), ByNumbers::<f64>::new());
    let (q, v) = (by_constants.initial_state(), by_numbers.initial_state());
    assert_eq!((q.q, q.v), (v.q, v.v));
    let [by_constants, by_numbers] = [
        by_constants.accelerations(&q, &by_constants.no_inputs()).expect("a regular chain"),
        by_numbers.accelerations(&v, &by_numbers.no_inputs()).expect("a regular chain"),
    ];
    crate::assert_close(by_constants, by_numbers);
}

/// A chain in a function sees what is declared there.
#[test]
fn constants_of_a_function() {
    const LOAD: f64 = 1.5;
    mstmm_chain! {
        chain Local {
            body Lump { mass = LOAD + T kg; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; }
            Lump;
        }
    }
    assert_eq!(mass_of!(Local), 3.5);
}
