//! States: single, repeated and closed chains, and those that float.

use super::models::*;
use mstmm::description::Origin;
use mstmm::{ChainState, Error, Scalar};

fn assert_normalized<C: Compared>(state: &C::State, place: usize) {
    let quaternion = &state.coordinates()[place..place + 4];
    let square: f64 = quaternion.iter().map(|&x| x.into() * x.into()).sum();
    assert!((square - 1.0).abs() < 1e-6, "{state:?}");
}

/// Every quaternion of a state in turn is one that is refused, accepted, or not finite.
fn check<C: Compared>(places: &[(usize, &'static str)]) {
    let chain = C::default();
    let inputs = chain.no_inputs();
    let with = |place: usize, quaternion: [C::Scalar; 4]| {
        let mut state = chain.initial_state();
        state.coordinates_mut()[place..place + 4].copy_from_slice(&quaternion);
        state
    };
    let mut assembled = chain.initial_state();
    chain.assemble(&mut assembled, &inputs).expect("a start that can be assembled");
    let is_closed = assembled != chain.initial_state();
    for &(place, hinge) in places {
        for quaternion in refused() {
            let state = with(place, quaternion);
            assert_refused(&chain, &state, &inputs, Error::InvalidQuaternion { hinge });
            // What an integrator asks for at its stages is not checked.
            let mut rate = state.clone();
            let fast = chain.derivative_into(&state, &inputs, &mut rate);
            assert!(!matches!(fast, Err(Error::InvalidQuaternion { .. })), "{fast:?}");
        }
        for quaternion in accepted() {
            let state = with(place, quaternion);
            for (by, result, left) in moved(&chain, &state, &inputs) {
                // A closed chain is not assembled in this pose: steps refuse the pose, not the quaternion.
                if is_closed && result == Err(Error::NotAssembled) {
                    assert_eq!(left, state, "{by}");
                    continue;
                }
                assert_eq!(result, Ok(()), "{by} of {state:?}");
                assert_normalized::<C>(&left, place);
            }
            assert_eq!(chain.solve_into(&state, &inputs, &mut chain.workspace()), Ok(()));
        }
        for factor in [0.95, 1.0, 1.05].map(C::Scalar::constant) {
            let mut state = assembled.clone();
            state.coordinates_mut()[place..place + 4].iter_mut().for_each(|q| *q *= factor);
            for (by, result, left) in moved(&chain, &state, &inputs) {
                assert_eq!(result, Ok(()), "{by} of {state:?}");
                assert_normalized::<C>(&left, place);
            }
        }
        for broken in [C::Scalar::NAN, C::Scalar::INFINITE, -C::Scalar::INFINITE] {
            for component in 0..4 {
                let mut quaternion = of_length(1.0);
                quaternion[component] = broken;
                let state = with(place, quaternion);
                assert_refused(
                    &chain,
                    &state,
                    &inputs,
                    Error::NotFinite(Origin::Coordinate(place + component)),
                );
            }
        }
    }
    // The first hinge of several is named.
    let mut state = chain.initial_state();
    for &(place, _) in places {
        state.coordinates_mut()[place..place + 4].fill(C::Scalar::default());
    }
    assert_refused(&chain, &state, &inputs, Error::InvalidQuaternion { hinge: places[0].1 });
}

macro_rules! states {
    ($($test:ident: $riccati:ident $transfer:ident $places:ident;)*) => { $(
        #[test]
        fn $test() {
            check::<$riccati<f64>>($places);
            check::<$riccati<f32>>($places);
            check::<$transfer<f64>>($places);
            check::<$transfer<f32>>($places);
        }
    )* };
}

states! {
    a_chain_that_is_written_out: Written WrittenByTransfer WRITTEN;
    a_chain_of_repeated_parts: Repeated RepeatedByTransfer REPEATED;
    a_chain_that_floats: Adrift AdriftByTransfer ADRIFT;
    a_closed_chain: Loop LoopByTransfer LOOP;
}

/// `accelerations` by value takes a state from outside, too.
#[test]
fn accelerations_by_value_are_checked() {
    let chain = Repeated::<f64>::new();
    let (mut state, inputs) = (chain.initial_state(), chain.no_inputs());
    assert!(chain.accelerations(&state, &inputs).is_ok());
    state.q[7] = 0.5;
    assert_eq!(chain.accelerations(&state, &inputs), Err(Error::InvalidQuaternion { hinge: "b" }));
    let mut accelerations = chain.accelerations(&chain.initial_state(), &inputs).unwrap();
    assert_eq!(chain.accelerations_into(&state, &inputs, &mut accelerations), Ok(()));
}
