//! Chains with quaternions in every position, and the states that each must reject.

use mstmm::prelude::*;
use mstmm::{Error, GeneratedChain, Scalar};
use std::fmt::Debug;

macro_rules! chains {
    ($method:ident: $unrolled:ident $repeated:ident $adrift:ident $loop:ident $moved:ident) => {
        mstmm_chain! {
            /// Balls, a pin between them, and a hinge that holds nothing.
            pub chain $unrolled {
                method = $method;
                gravity = [0, -9.8, 0] m/s^2;
                body Link {
                    mass = 1 kg; com = [0.5, 0.1, 0] m; output = [1, 0, 0] m;
                    inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
                }
                ground -> ball a -> Link la -> pin(z) b -> Link lb -> ball c -> Link lc
                    -> floating d -> Link ld;
            }
            /// The same kinds in repeated parts, among which lie others.
            pub chain $repeated {
                method = $method;
                gravity = [0, -9.8, 0] m/s^2;
                body Link {
                    mass = 1 kg; com = [0.5, 0.1, 0] m; output = [1, 0, 0] m;
                    inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
                }
                ground -> pin(y) first -> Link base
                    -> repeat 3 { pin(z) a -> Link la -> ball b -> Link lb }
                    -> ball c -> Link lc -> repeat 2 { floating d -> Link ld -> slider e -> Link le };
            }
            /// A chain that floats.
            pub chain $adrift {
                method = $method;
                body Link {
                    mass = 1 kg; com = [0.5, 0.1, 0] m; output = [1, 0, 0] m;
                    inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
                }
                Link hull -> pin(z) a -> Link la -> ball b -> Link lb;
            }
            /// A closed chain.
            pub chain $loop {
                method = $method;
                gravity = [0, -9.8, 0] m/s^2;
                body Link {
                    mass = 1 kg; com = [0.5, 0.1, 0] m; output = [1, 0, 0] m;
                    inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
                }
                ground -> ball a -> Link la -> pin(z) b -> Link lb -> ball c
                    -> ground at [1.2, 0, 0] m;
                hinge a { start = rpy(0, 0, 50) deg; }
                hinge b { start = -100 deg; }
            }
            /// Motions with quaternions that are prescribed.
            pub chain $moved {
                method = $method;
                body Link {
                    mass = 1 kg; com = [0.5, 0.1, 0] m; output = [1, 0, 0] m;
                    inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
                }
                moving deck -> pin(z) a -> Link la -> ball b -> Link lb
                    -> repeat 3 { ball c -> Link lc -> pin(y) d -> Link ld };
                hinge b, c { motion = input; }
            }
        }
    };
}

chains! { riccati: Written Repeated Adrift Loop Moved }
chains! { transfer: WrittenByTransfer RepeatedByTransfer AdriftByTransfer LoopByTransfer MovedByTransfer }

/// The states' quaternions by the place of their w and the name of their hinge.
pub const WRITTEN: &[(usize, &str)] = &[(0, "a"), (5, "c"), (12, "d")];
pub const REPEATED: &[(usize, &str)] =
    &[(2, "b"), (7, "b"), (12, "b"), (16, "c"), (23, "d"), (31, "d")];
pub const ADRIFT: &[(usize, &str)] = &[(3, "hull"), (8, "b")];
pub const LOOP: &[(usize, &str)] = &[(0, "a"), (5, "c")];

/// A number that the tests run in.
pub trait Number: Scalar<Real = Self, Mask = bool> + PartialOrd + Into<f64> {
    /// Lengths whose squares are zero, or infinite.
    const TINY: Self;
    const HUGE: Self;
    const NAN: Self;
    const INFINITE: Self;
}

macro_rules! numbers {
    ($($number:ident $tiny:literal $huge:literal;)*) => { $(
        impl Number for $number {
            const TINY: Self = $tiny;
            const HUGE: Self = $huge;
            const NAN: Self = $number::NAN;
            const INFINITE: Self = $number::INFINITY;
        }
    )* };
}

numbers! {
    f32 1e-30 1e30;
    f64 1e-200 1e200;
}

/// A chain that the tests can compare.
pub trait Compared:
    GeneratedChain<
        Scalar: Number,
        State: Debug + PartialEq,
        Inputs: Copy,
        Workspace: Clone + Debug + PartialEq,
    > + Default
{
}

impl<C> Compared for C where
    C: GeneratedChain<
            Scalar: Number,
            State: Debug + PartialEq,
            Inputs: Copy,
            Workspace: Clone + Debug + PartialEq,
        > + Default
{
}

/// A direction of four components, each of another size.
const DIRECTION: [f64; 4] = [0.8, -0.4, 0.4, 0.2];

/// A quaternion of this length.
pub fn of_length<T: Scalar>(length: f64) -> [T; 4] {
    DIRECTION.map(|x| T::constant(x * length))
}

/// Quaternions that are rejected.
pub fn refused<T: Number>() -> Vec<[T; 4]> {
    let zero = T::default();
    let mut all = vec![[zero; 4], [T::TINY; 4], [T::HUGE; 4], [zero, zero, T::HUGE, T::TINY]];
    all.extend([0.0, 1e-3, 0.5, 0.89, 0.8999, 1.1001, 1.11, 2.0, 1e3].map(of_length));
    all
}

/// Quaternions that are accepted.
pub fn accepted<T: Number>() -> Vec<[T; 4]> {
    [0.9, 0.9001, 0.95, 1.0, 1.05, 1.0999, 1.1].map(of_length).into()
}

/// The results of `step` and `advance_to` of all integrators from a state, with the states that they leave.
pub fn moved<C: Compared>(
    chain: &C,
    state: &C::State,
    inputs: &C::Inputs,
) -> Vec<(&'static str, Result<(), Error>, C::State)> {
    let mut found = Vec::new();
    let small = C::Scalar::constant(1.0 / 1024.0);
    let end = state.time() + C::Scalar::constant(1.0 / 256.0);
    macro_rules! by {
        ($($name:ident $integrator:expr;)*) => { $(
            let mut moved = state.clone();
            let result = $integrator.step(chain, &mut moved, |_, _| *inputs);
            found.push((concat!(stringify!($name), "::step"), result, moved));
            let mut moved = state.clone();
            let result = $integrator.advance_to(chain, &mut moved, end, |_, _| *inputs);
            found.push((concat!(stringify!($name), "::advance_to"), result, moved));
            // The state is checked even if no step is needed.
            let mut moved = state.clone();
            let result = $integrator.advance_to(chain, &mut moved, state.time(), |_, _| *inputs);
            if result.is_err() {
                found.push((concat!(stringify!($name), "::advance_to"), result, moved));
            }
        )* };
    }
    by! {
        Rk4 Rk4::new(small);
        Dopri5 Dopri5::new(C::Scalar::constant(1e-3), C::Scalar::constant(1e-3));
        SemiImplicitEuler SemiImplicitEuler::new(small);
        LinearlyImplicitEuler LinearlyImplicitEuler::new(small);
        Newmark Newmark::new(small);
    }
    found
}

/// Fails unless everything that takes a state and inputs from outside refuses them with `error`,
/// and leaves everything as it was.
pub fn assert_refused<C: Compared>(chain: &C, state: &C::State, inputs: &C::Inputs, error: Error) {
    for (by, result, left) in moved(chain, state, inputs) {
        assert_eq!(result, Err(error), "{by} of {state:?}");
        assert!(format!("{left:?}") == format!("{state:?}"), "{by}: {left:?} of {state:?}");
    }
    // Results of an earlier call are gone.
    let mut at = chain.workspace();
    let fresh = at.clone();
    chain.solve_into(&chain.initial_state(), &chain.no_inputs(), &mut at).expect("a start");
    assert!(at != fresh);
    assert_eq!(chain.solve_into(state, inputs, &mut at), Err(error), "{state:?}");
    assert_eq!(at, fresh);
    if matches!(error, Error::InvalidQuaternion { .. }) {
        let mut assembled = state.clone();
        assert_eq!(chain.assemble(&mut assembled, inputs), Err(error), "{state:?}");
        assert!(format!("{assembled:?}") == format!("{state:?}"));
    }
}
