//! The crate `mstmm` is called `dynamics` here, and many things have the names of what generated code
//! is made of.

#![deny(warnings, missing_docs, clippy::all)]
#![cfg_attr(not(test), no_std)]

pub mod crowded;

use dynamics::mstmm_chain;

mstmm_chain! {
    /// An oscillator, for all.
    pub line chain Oscillator {
        body Car { mass = 2 kg; }
        ground -> slider spring -> Car car;
        hinge spring { stiffness = 50 N/m; force = input; }
    }
}

/// Its acceleration at 1 m, from a chain of the module and from another one of the same name.
#[must_use]
pub fn accelerations() -> [f64; 2] {
    // Seen in this function alone.
    const MASS: f64 = 4.0;
    mstmm_chain! {
        line chain Inside {
            body Car { mass = MASS; }
            ground -> slider spring -> Car car;
            hinge spring { stiffness = 50 N/m; }
        }
    }
    let (module, inside) = (Oscillator::<f64>::new(), Inside::<f64>::new());
    let (mut a, mut b) = (module.initial_state(), inside.initial_state());
    a.spring_mut().set_position(1.0);
    b.spring_mut().set_position(1.0);
    [
        module.accelerations(&a, &module.no_inputs()).map_or(f64::NAN, |v| v[0]),
        inside.accelerations(&b, &inside.no_inputs()).map_or(f64::NAN, |v| v[0]),
    ]
}

#[cfg(test)]
mod tests {
    use super::accelerations;
    use super::crowded;

    #[test]
    fn chains_of_modules_and_functions() {
        assert_eq!(accelerations(), [-25.0, -12.5]);
    }

    #[test]
    fn names_in_the_crate_do_not_affect_a_chain() {
        assert_eq!(crowded::acceleration(), -25.0);
    }
}
