//! Generated code as a contender of `benches/peers`, whose README describes its input and output.

use std::error::Error;
use std::hint::black_box;
use std::time::Duration;
use std::{env, fs};

use mstmm::wide::{f32x16, f64x8};
use mstmm::{ChainState, Rk4, Scalar};
use mstmm_benches::{
    Balls3, Balls10, Balls100, Case, G1, Hyq, Lanes, Panda, Pins7, Pins30, Rods3, Rods10, Rods100,
    Rods1000, Times, from_bytes, numbers_of_state, random_states, samples_from, to_bytes,
    with_cases, with_z,
};

const USAGE: &str = "contender states CASE COUNT STATES_OUT
contender accelerations|z|all|rk4|lanes|lanes32 CASE STATES_IN RESULTS_OUT MILLISECONDS";

/// The step of the integration in s.
const STEP: f64 = 1e-3;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let &[what, case, ..] = arguments.as_slice() else { return Err(USAGE.into()) };
    macro_rules! run {
        ($($chain:ident)*) => {
            match (what, case) {
                $(
                    ("lanes", $chain::<f64>::NAME) => run::<$chain<f64x8>>(&arguments),
                    ("lanes32", $chain::<f64>::NAME) => run::<$chain<f32x16>>(&arguments),
                    ("z", $chain::<f64>::NAME) => run::<with_z::$chain<f64>>(&arguments),
                    (_, $chain::<f64>::NAME) => run::<$chain<f64>>(&arguments),
                )*
                _ => run_tree(&arguments),
            }
        };
    }
    with_cases!(run)
}

/// Runs a robot that branches. Only the smaller one has lanes, since they take minutes to compile.
fn run_tree(arguments: &[&str]) -> Result<(), Box<dyn Error>> {
    match *arguments {
        ["lanes", Hyq::<f64>::NAME, ..] => run::<Hyq<f64x8>>(arguments),
        [_, Hyq::<f64>::NAME, ..] => run::<Hyq<f64>>(arguments),
        [_, G1::<f64>::NAME, ..] => run::<G1<f64>>(arguments),
        _ => Err("no such case".into()),
    }
}

fn run<C: Case>(arguments: &[&str]) -> Result<(), Box<dyn Error>> {
    match *arguments {
        ["states", _, count, path] => {
            let numbers = random_states::<C::State>(count.parse()?);
            Ok(fs::write(path, to_bytes(&numbers))?)
        }
        [what, _, states, results, milliseconds] => {
            let numbers = from_bytes(&fs::read(states)?);
            let chain = C::undamped();
            let samples = samples_from(&chain, &numbers);
            let budget = Duration::from_millis(milliseconds.parse()?);
            let mut run = match what {
                "accelerations" | "lanes" | "lanes32" => accelerations(&chain, &samples, budget)?,
                "all" | "z" => all(&chain, &samples, budget)?,
                "rk4" => rk4(&chain, &samples, budget)?,
                _ => return Err(USAGE.into()),
            };
            // The padding of the last lanes is not a state.
            let states = numbers.len() / numbers_of_state::<C::State>();
            run.results.truncate(states * C::State::zero_position().rates().len());
            if results != "-" {
                fs::write(results, to_bytes(&run.results))?;
            }
            run.times.print();
            Ok(())
        }
        _ => Err(USAGE.into()),
    }
}

/// The results for each state, and the times.
struct Run {
    results: Vec<f64>,
    times: Times,
}

fn accelerations<C: Case>(
    chain: &C,
    samples: &[(C::State, C::Inputs)],
    budget: Duration,
) -> Result<Run, mstmm::Error> {
    let mut rate = C::State::zero_position();
    let mut results = Vec::new();
    for (state, inputs) in samples {
        chain.accelerations_into(state, inputs, &mut rate)?;
        push_lanes(&mut results, rate.rates());
    }
    let times = Times::of(budget, samples, C::Scalar::COUNT, |(state, inputs)| {
        let result = chain.accelerations_into(black_box(state), inputs, black_box(&mut rate));
        let _ = black_box(result);
    });
    Ok(Run { results, times })
}

fn all<C: Case>(
    chain: &C,
    samples: &[(C::State, C::Inputs)],
    budget: Duration,
) -> Result<Run, mstmm::Error> {
    let mut at = chain.workspace();
    let mut results = Vec::new();
    for (state, inputs) in samples {
        chain.solve_into(state, inputs, &mut at)?;
        push_lanes(&mut results, C::accelerations_at(&at));
    }
    let times = Times::of(budget, samples, C::Scalar::COUNT, |(state, inputs)| {
        let result = chain.solve_into(black_box(state), inputs, black_box(&mut at));
        let _ = black_box(result);
    });
    Ok(Run { results, times })
}

/// Takes a step from each of the states, with constant torques.
fn rk4<C: Case>(
    chain: &C,
    samples: &[(C::State, C::Inputs)],
    budget: Duration,
) -> Result<Run, mstmm::Error> {
    let mut integrator = Rk4::new(Scalar::constant(STEP));
    let mut results = Vec::new();
    for sample in samples {
        let mut state = sample.0.clone();
        integrator.step(chain, &mut state, |_, _| sample.1.clone())?;
        push_lanes(&mut results, state.rates());
    }
    let times = Times::of(budget, samples, C::Scalar::COUNT, |sample| {
        let mut state = black_box(sample).0.clone();
        let result = integrator.step(chain, &mut state, |_, _| sample.1.clone());
        let _ = black_box((result, &state));
    });
    Ok(Run { results, times })
}

/// Adds numbers state by state.
fn push_lanes<T: Lanes>(results: &mut Vec<f64>, numbers: &[T]) {
    for lane in 0..T::COUNT {
        results.extend(numbers.iter().map(|number| number.lane(lane)));
    }
}
