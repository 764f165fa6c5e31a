//! Prescribed motions: of a moving end, of a hinge, of a repeated hinge.

use super::models::*;
use mstmm::prelude::*;
use mstmm::{BallState, Described, Error, FloatingState, GeneratedChain, HingeMotion};

macro_rules! check {
    ($chain:ident $inputs:ident $number:ident) => {{
        let chain = $chain::<$number>::new();
        let state = chain.initial_state();
        let with = |which: usize, quaternion: [$number; 4]| -> ($inputs<$number>, &'static str) {
            let mut inputs = chain.no_inputs();
            let ball = BallState::new(quaternion, [0.0; 3]);
            let hinge = match which {
                0 => {
                    inputs.deck.state =
                        FloatingState::new([0.0; 3], quaternion, [0.0; 3], [0.0; 3]);
                    "deck"
                }
                1 => {
                    inputs.b.state = ball;
                    "b"
                }
                _ => {
                    inputs.c[which - 2] = HingeMotion { state: ball, ..inputs.c[which - 2] };
                    "c"
                }
            };
            (inputs, hinge)
        };
        for which in 0..5 {
            for quaternion in refused() {
                let (inputs, hinge) = with(which, quaternion);
                assert_refused(&chain, &state, &inputs, Error::InvalidQuaternion { hinge });
                let refused = chain.accelerations(&state, &inputs).map(|_| ());
                assert_eq!(refused, Err(Error::InvalidQuaternion { hinge }));
            }
            for quaternion in accepted() {
                let (inputs, _) = with(which, quaternion);
                for (by, result, _) in moved(&chain, &state, &inputs) {
                    assert!(!matches!(result, Err(Error::InvalidQuaternion { .. })), "{by}");
                }
            }
            let mut quaternion = of_length(1.0);
            quaternion[1] = $number::NAN;
            let (inputs, _) = with(which, quaternion);
            let origin = $chain::<$number>::not_finite(&state, &inputs).expect("the component");
            let name = $chain::<$number>::DESCRIPTION.name_of(origin).expect("a name").to_string();
            let hinge = ["deck", "b", "c[0]", "c[1]", "c[2]"][which];
            assert_eq!(name, format!("{hinge}.state.orientation.x"));
            assert_refused(&chain, &state, &inputs, Error::NotFinite(origin));
        }
        // Inputs are given anew at every stage, so they are checked there.
        let at_stage = |number: usize| {
            let (mut moved, mut asked) = (state.clone(), 0);
            let result = Rk4::new(1e-3).step(&chain, &mut moved, |_, _| {
                asked += 1;
                if asked == number { with(1, of_length(0.5)).0 } else { chain.no_inputs() }
            });
            assert_eq!(moved, state);
            (result, asked)
        };
        for number in 1..=4 {
            assert_eq!(at_stage(number), (Err(Error::InvalidQuaternion { hinge: "b" }), number));
        }
    }};
}

#[test]
fn prescribed_quaternions_are_refused() {
    check!(Moved MovedInputs f64);
    check!(Moved MovedInputs f32);
    check!(MovedByTransfer MovedByTransferInputs f64);
    check!(MovedByTransfer MovedByTransferInputs f32);
}

mstmm_chain! {
    /// A closed chain on a frame that moves.
    chain Rocking {
        body Link {
            mass = 1 kg; com = [0.5, 0.1, 0] m; output = [1, 0, 0] m;
            inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
        }
        moving deck -> ball a -> Link la -> pin(z) b -> Link lb -> ball c
            -> ground at [1.2, 0, 0] m;
        hinge a { start = rpy(0, 0, 50) deg; }
        hinge b { start = -100 deg; }
    }
}

/// `assemble` is given prescribed motions, too, and asked at the end of a step they close the chain.
#[test]
fn closed_chains_refuse_them_when_they_are_assembled_and_closed() {
    let chain = Rocking::<f64>::new();
    let mut state = chain.initial_state();
    GeneratedChain::assemble(&chain, &mut state, &chain.no_inputs()).expect("a loop");
    let mut wrong = chain.no_inputs();
    wrong.deck.state = FloatingState::new([0.0; 3], of_length(1.2), [0.0; 3], [0.0; 3]);
    let error = Error::InvalidQuaternion { hinge: "deck" };
    assert_refused(&chain, &state, &wrong, error);
    let (mut moved, mut asked) = (state.clone(), 0);
    let result = SemiImplicitEuler::new(1e-3).step(&chain, &mut moved, |_, _| {
        asked += 1;
        if asked == 2 { wrong } else { chain.no_inputs() }
    });
    assert_eq!((result, moved), (Err(error), state));
}

/// With another length than one, the matrix of a quaternion is no rotation, and no pose would be closed.
#[test]
fn closed_chains_are_assembled_with_all_accepted_lengths() {
    let chain = Rocking::<f64>::new();
    let assembled = |quaternion: [f64; 4]| {
        let mut inputs = chain.no_inputs();
        inputs.deck.state = FloatingState::new([0.0; 3], quaternion, [0.0; 3], [0.0; 3]);
        let mut state = chain.initial_state();
        chain.assemble(&mut state, &inputs).expect("a closed pose");
        let error = chain.closure_error(&state, &inputs).expect("finite");
        // `assemble` ends within this distance of a closed pose.
        assert!(error <= 64.0 * f64::EPSILON, "{error:e} with {quaternion:?}");
        state
    };
    let unit = assembled(of_length(1.0));
    for quaternion in accepted().into_iter().chain([of_length(1.0 + 6e-8)]) {
        let state = assembled(quaternion);
        let differences = state.q.iter().zip(&unit.q).map(|(a, b)| (a - b).abs());
        // Ten times that distance, for lengths of about a metre.
        assert!(differences.fold(0.0, f64::max) < 1e-13, "{quaternion:?}: {state:?}, {unit:?}");
    }
}
