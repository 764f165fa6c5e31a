//! Every lane of an answer has exactly the bits of the chain alone.

use super::asked::{Asked, Direction};
use super::chains::{Arm, Branched, Raft, Slides, Train};
use crate::numbers::{Lanes, numbers, of_lane, same_bits};
use crate::sample::{Case, each, wide};
use mstmm::wide::{f32x8, f64x4};
use mstmm::{ChainState, Scalar};

/// Random cases of each chain.
const SEEDS: u64 = 4;

/// Returns all answers.
fn answers<C: Asked>(case: &Case<C>) -> Vec<(&'static str, Vec<f64>)> {
    let Case { chain, state, inputs, .. } = case;
    let x = state.rates();
    let direction = Direction { coordinates: x.to_vec(), rates: x.to_vec() };
    let [accelerations, change] = chain.push(state, inputs, &direction);
    vec![
        ("inverse dynamics", numbers(&chain.inverse(state, x, inputs))),
        ("bias efforts", numbers(&chain.bias(state, inputs))),
        ("gravity efforts", numbers(&chain.gravity(state, inputs))),
        ("passive efforts", numbers(&chain.passive(state, inputs))),
        ("M x", numbers(&chain.mass_times(state, inputs, x))),
        ("M⁻¹ x", numbers(&chain.inverse_mass_times(state, inputs, x))),
        ("accelerations", numbers(&accelerations)),
        ("change", numbers(&change)),
        ("workspace", numbers(&chain.workspaces(state, inputs)[1])),
    ]
}

fn check<W, C>()
where
    W: Asked<Scalar: Lanes>,
    C: Asked<Scalar = <W::Scalar as Scalar>::Real>,
    C::Scalar: Lanes + Scalar<Real = C::Scalar>,
{
    for seed in 0..SEEDS {
        let each: Vec<Case<C>> = each(seed, W::Scalar::COUNT, 0.01);
        let found = answers(&wide::<W, C>(seed, &each));
        for (lane, case) in each.iter().enumerate() {
            for ((what, found), (_, alone)) in found.iter().zip(answers(case)) {
                let found = of_lane(found, lane, W::Scalar::COUNT);
                assert!(same_bits(&found, &alone), "seed {seed}, lane {lane}: {what}");
            }
        }
    }
}

/// The stack size: unoptimised code keeps every value of a function on the stack, in all lanes.
const STACK: usize = 64 << 20;

macro_rules! chains {
    ($($test:ident: $name:ident;)*) => { $(
        #[test]
        fn $test() {
            let test = || {
                check::<$name<f64x4>, $name<f64>>();
                check::<$name<f32x8>, $name<f32>>();
            };
            let thread = std::thread::Builder::new().stack_size(STACK).spawn(test);
            if let Err(panic) = thread.expect("a thread").join() {
                std::panic::resume_unwind(panic);
            }
        }
    )* };
}

chains! {
    pins: Arm;
    all_hinges_and_prescribed_motions: Slides;
    a_tree_with_parts_and_repetitions: Branched;
    a_floating_chain_in_a_plane: Raft;
    a_line: Train;
}
