//! Evaluates a chain a number of times, for `benches/instructions`, which counts the instructions.

use std::env;
use std::error::Error;
use std::hint::black_box;

use mstmm::{ChainState, Rk4};
use mstmm_benches::{
    Balls3, Balls10, Balls100, Case, Panda, Pins7, Pins30, Rods3, Rods10, Rods100, Rods1000,
    samples, with_cases, with_z,
};

const USAGE: &str = "evaluate accelerations|z|all|rk4 CASE COUNT";

/// The number of states, which are evaluated cyclically.
const STATES: usize = 16;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [what, case, count] = arguments.as_slice() else { return Err(USAGE.into()) };
    let count = count.parse()?;
    macro_rules! run {
        ($($chain:ident)*) => {
            match (what.as_str(), case.as_str()) {
                $(
                    ("z", $chain::<f64>::NAME) => run::<with_z::$chain<f64>>(what, count),
                    (_, $chain::<f64>::NAME) => run::<$chain<f64>>(what, count),
                )*
                _ => Err("no such case".into()),
            }
        };
    }
    with_cases!(run)
}

fn run<C: Case<Scalar = f64>>(what: &str, count: usize) -> Result<(), Box<dyn Error>> {
    let chain = C::default();
    let samples = samples(&chain, STATES);
    let samples = samples.iter().cycle().take(count);
    match what {
        "accelerations" => {
            let mut rate = C::State::zero_position();
            for (state, inputs) in samples {
                chain.accelerations_into(black_box(state), inputs, black_box(&mut rate))?;
            }
        }
        "all" | "z" => {
            let mut at = chain.workspace();
            for (state, inputs) in samples {
                chain.solve_into(black_box(state), inputs, black_box(&mut at))?;
            }
        }
        "rk4" => {
            let mut rk4 = Rk4::new(1e-3);
            for (state, inputs) in samples {
                let mut state = black_box(state).clone();
                rk4.step(&chain, &mut state, |_, _| inputs.clone())?;
                black_box(&state);
            }
        }
        _ => return Err(USAGE.into()),
    }
    Ok(())
}
