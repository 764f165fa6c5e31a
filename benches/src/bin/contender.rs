//! Generated code as a contender of `benches/peers`, whose README describes its input and output.

use std::error::Error;
use std::hint::black_box;
use std::time::{Duration, Instant};
use std::{env, fs};

use mstmm::wide::{f32x16, f64x8};
use mstmm::{ChainState, Rk4, Scalar};
use mstmm_benches::{
    Balls3, Balls10, Balls100, Case, G1, Hyq, Lanes, Panda, Pins7, Pins30, Rods3, Rods10, Rods100,
    Rods1000, numbers_of_state, random_states, samples_from, with_cases, with_z,
};

const USAGE: &str = "contender states CASE COUNT STATES_OUT
contender accelerations|z|all|rk4|lanes|lanes32 CASE STATES_IN RESULTS_OUT MILLISECONDS";

/// The step of the integration in s.
const STEP: f64 = 1e-3;

/// The warm-up time of the processor before timing.
const WARM_UP: Duration = Duration::from_millis(5);

/// The shortest time of a batch of evaluations.
const BATCH: Duration = Duration::from_micros(200);

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
            run.results.truncate(states * C::State::default().rates().len());
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
    let mut rate = C::State::default();
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

/// Batches with the same number of evaluations, each of one state.
struct Times {
    evaluations: usize,
    nanoseconds: Vec<u128>,
}

impl Times {
    /// Times `evaluate` for all samples repeatedly, for about the given time, with a number of states per
    /// sample.
    fn of<S>(budget: Duration, samples: &[S], states: usize, mut evaluate: impl FnMut(&S)) -> Self {
        let mut samples = samples.iter().cycle();
        let mut batch = |evaluations: usize| {
            let start = Instant::now();
            samples.by_ref().take(evaluations).for_each(&mut evaluate);
            start.elapsed()
        };
        let start = Instant::now();
        while start.elapsed() < WARM_UP {
            batch(1);
        }
        let mut count = 1;
        while batch(count) < BATCH {
            count *= 2;
        }
        let start = Instant::now();
        let mut nanoseconds = vec![batch(count).as_nanos()];
        while start.elapsed() < budget {
            nanoseconds.push(batch(count).as_nanos());
        }
        Self { evaluations: count * states, nanoseconds }
    }

    fn print(&self) {
        let Self { evaluations, nanoseconds } = self;
        println!("{{\"evaluations\": {evaluations}, \"nanoseconds\": {nanoseconds:?}}}");
    }
}

/// Converts numbers from and to the format of files.
fn to_bytes(numbers: &[f64]) -> Vec<u8> {
    numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
}

fn from_bytes(bytes: &[u8]) -> Vec<f64> {
    let (numbers, _) = bytes.as_chunks();
    numbers.iter().map(|&bytes| f64::from_le_bytes(bytes)).collect()
}
