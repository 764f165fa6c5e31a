//! An inertia that is lost by rounding next to much larger ones: `f32` with mass ratios of 10⁶ reports an
//! error, and suggests a remedy.

use mstmm::prelude::*;
use mstmm::{Error, GeneratedChain};

macro_rules! chains {
    ($method:ident: $line:ident $space:ident $repeated:ident) => {
        mstmm_chain! {
            /// A light body that a heavy one leaves alone.
            pub line chain $line {
                method = $method;
                param light = 1 g;
                gravity = -9.8 m/s^2;
                body Slide { mass = light; output = 1 m; }
                body Block { mass = 1 t; }
                ground -> slider a -> Slide slide -> slider b -> Block block;
            }
        }
        mstmm_chain! {
            /// A light body between balls.
            pub chain $space {
                method = $method;
                param light = 1 g;
                gravity = [0, 0, -9.8] m/s^2;
                body Rod {
                    mass = light; com = [0.5, 0, 0] m; output = [1, 0, 0] m;
                    inertia = diag(light * (0.1 m^2), light * (0.1 m^2), light * (0.1 m^2)) about com;
                }
                body Block {
                    mass = 1 t; com = [0.5, 0.2, 0] m;
                    inertia = diag(100, 100, 100) kg*m^2 about com;
                }
                ground -> ball a -> Rod rod -> ball b -> Block block;
                hinge a { start = rpy(10, 20, 30) deg; }
                hinge b { start = rpy(-20, 10, 30) deg; }
            }
        }
        mstmm_chain! {
            /// Light and heavy bodies in turn.
            pub line chain $repeated {
                method = $method;
                param light = 1 g;
                gravity = -9.8 m/s^2;
                body Slide { mass = light; output = 1 m; }
                body Block { mass = 1 t; output = 1 m; }
                ground -> repeat 3 { slider a -> Slide slide -> slider b -> Block block };
            }
        }
    };
}

chains! { riccati: Line Space Repeated }
chains! { transfer: LineByTransfer SpaceByTransfer RepeatedByTransfer }

/// What a chain makes of its start.
fn outcome<C: GeneratedChain>(chain: &C) -> Result<(), Error> {
    let (state, inputs) = (chain.initial_state(), chain.no_inputs());
    let solved = chain.solve_into(&state, &inputs, &mut chain.workspace());
    let derived = chain.derivative_into(&state, &inputs, &mut state.clone());
    assert_eq!(solved, derived);
    solved
}

#[test]
fn masses_far_apart_are_named_in_single_precision() {
    macro_rules! check {
        ($($chain:ident)*) => { $(
            let mut chain = $chain::<f32>::new();
            let error = outcome(&chain).expect_err("lost in rounding");
            assert_eq!(error, Error::Singular { hinge: "a" }, stringify!($chain));
            let text = error.to_string();
            for part in ["`a`", "rounding", "`f64`", "masses that differ less"] {
                assert!(text.contains(part), "{text}");
            }
            // The suggested remedies help: double precision, or masses that differ less.
            assert_eq!(outcome(&$chain::<f64>::new()), Ok(()), stringify!($chain));
            chain.set_light(1.0).expect("a mass");
            assert_eq!(outcome(&chain), Ok(()), stringify!($chain));
        )* };
    }
    check! { Line Space Repeated LineByTransfer SpaceByTransfer RepeatedByTransfer }
}

#[test]
fn masses_further_apart_are_named_in_double_precision() {
    macro_rules! check {
        ($($chain:ident)*) => { $(
            let mut chain = $chain::<f64>::new();
            chain.set_light(1e-13).expect("a mass");
            assert_eq!(outcome(&chain), Err(Error::Singular { hinge: "a" }), stringify!($chain));
        )* };
    }
    check! { Line Space Repeated LineByTransfer SpaceByTransfer RepeatedByTransfer }
}

/// A step returns the same error and leaves the state unchanged.
#[test]
fn a_step_says_so_too() {
    let chain = Space::<f32>::new();
    let mut state = chain.initial_state();
    let result = Rk4::new(1e-3).step(&chain, &mut state, |_, _| chain.no_inputs());
    assert_eq!((result, state), (Err(Error::Singular { hinge: "a" }), chain.initial_state()));
}
