//! Generated code as a contender of `benches/peers`, whose README says what it reads and writes.

use std::error::Error;
use std::hint::black_box;
use std::time::{Duration, Instant};
use std::{env, fs};

use mstmm::{ChainState, Rk4};
use mstmm_benches::{
    Balls3, Balls10, Balls100, Case, Panda, Pins7, Pins30, Rods3, Rods10, Rods100, Rods1000,
    numbers_of_state, random_states, with_cases,
};

const USAGE: &str = "contender states CASE COUNT STATES_OUT
contender accelerations|all|rk4 CASE STATES_IN RESULTS_OUT MILLISECONDS";

/// The step of the integration in s.
const STEP: f64 = 1e-3;

/// Before anything is timed the processor comes up to speed.
const WARM_UP: Duration = Duration::from_millis(5);

/// Evaluations are timed so many at a time that they take at least so long.
const BATCH: Duration = Duration::from_micros(200);

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let &[_, case, ..] = arguments.as_slice() else { return Err(USAGE.into()) };
    macro_rules! run {
        ($($chain:ident)*) => {
            match case {
                $($chain::<f64>::NAME => run::<$chain<f64>>(&arguments),)*
                _ => Err("no such case".into()),
            }
        };
    }
    with_cases!(run)
}

fn run<C: Case<Scalar = f64>>(arguments: &[&str]) -> Result<(), Box<dyn Error>> {
    match *arguments {
        ["states", _, count, path] => {
            let numbers = random_states::<C::State>(count.parse()?);
            Ok(fs::write(path, to_bytes(&numbers))?)
        }
        [what, _, states, results, milliseconds] => {
            let numbers = from_bytes(&fs::read(states)?);
            let chain = C::default();
            let each = numbers.chunks_exact(numbers_of_state::<C::State>());
            let samples: Vec<_> = each.map(|numbers| chain.sample(numbers)).collect();
            let budget = Duration::from_millis(milliseconds.parse()?);
            let run = match what {
                "accelerations" => accelerations(&chain, &samples, budget)?,
                "all" => all(&chain, &samples, budget)?,
                "rk4" => rk4(&chain, &samples, budget)?,
                _ => return Err(USAGE.into()),
            };
            if results != "-" {
                fs::write(results, to_bytes(&run.results))?;
            }
            run.times.print();
            Ok(())
        }
        _ => Err(USAGE.into()),
    }
}

/// What came out for each state, and how long it took.
struct Run {
    results: Vec<f64>,
    times: Times,
}

fn accelerations<C: Case<Scalar = f64>>(
    chain: &C,
    samples: &[(C::State, C::Inputs)],
    budget: Duration,
) -> Result<Run, mstmm::Error> {
    let mut rate = C::State::default();
    let mut results = Vec::new();
    for (state, inputs) in samples {
        chain.accelerations_into(state, inputs, &mut rate)?;
        results.extend_from_slice(rate.v());
    }
    let times = Times::of(budget, samples, |(state, inputs)| {
        let result = chain.accelerations_into(black_box(state), inputs, black_box(&mut rate));
        let _ = black_box(result);
    });
    Ok(Run { results, times })
}

fn all<C: Case<Scalar = f64>>(
    chain: &C,
    samples: &[(C::State, C::Inputs)],
    budget: Duration,
) -> Result<Run, mstmm::Error> {
    let mut at = chain.workspace();
    let mut results = Vec::new();
    for (state, inputs) in samples {
        chain.solve_into(state, inputs, &mut at)?;
        results.extend_from_slice(C::accelerations_at(&at));
    }
    let times = Times::of(budget, samples, |(state, inputs)| {
        let result = chain.solve_into(black_box(state), inputs, black_box(&mut at));
        let _ = black_box(result);
    });
    Ok(Run { results, times })
}

/// A step from each of the states, the torques being held.
fn rk4<C: Case<Scalar = f64>>(
    chain: &C,
    samples: &[(C::State, C::Inputs)],
    budget: Duration,
) -> Result<Run, mstmm::Error> {
    let mut integrator = Rk4::new(STEP);
    let mut results = Vec::new();
    for sample in samples {
        let mut state = sample.0.clone();
        integrator.step(chain, &mut state, |_, _| sample.1.clone())?;
        results.extend_from_slice(state.v());
    }
    let times = Times::of(budget, samples, |sample| {
        let mut state = black_box(sample).0.clone();
        let result = integrator.step(chain, &mut state, |_, _| sample.1.clone());
        let _ = black_box((result, &state));
    });
    Ok(Run { results, times })
}

/// Batches of the same number of evaluations.
struct Times {
    evaluations: usize,
    nanoseconds: Vec<u128>,
}

impl Times {
    /// Times `evaluate` for all samples, again and again, for about so long.
    fn of<S>(budget: Duration, samples: &[S], mut evaluate: impl FnMut(&S)) -> Self {
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
        let mut evaluations = 1;
        while batch(evaluations) < BATCH {
            evaluations *= 2;
        }
        let start = Instant::now();
        let mut nanoseconds = vec![batch(evaluations).as_nanos()];
        while start.elapsed() < budget {
            nanoseconds.push(batch(evaluations).as_nanos());
        }
        Self { evaluations, nanoseconds }
    }

    fn print(&self) {
        let Self { evaluations, nanoseconds } = self;
        println!("{{\"evaluations\": {evaluations}, \"nanoseconds\": {nanoseconds:?}}}");
    }
}

/// Numbers as they lie in files.
fn to_bytes(numbers: &[f64]) -> Vec<u8> {
    numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
}

fn from_bytes(bytes: &[u8]) -> Vec<f64> {
    let (numbers, _) = bytes.as_chunks();
    numbers.iter().map(|&bytes| f64::from_le_bytes(bytes)).collect()
}
