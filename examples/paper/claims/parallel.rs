//! The overall product in parts: the two-port form of a part is associative.
//!
//! "The overall transfer matrix (10) could be computed by a parallel algorithm, not necessarily by
//! serial processing" [P, section 2.4]; the paper does not try. Here a pendulum of rods is cut into
//! parts, one for each thread, and timed beside generated code, which goes from rod to rod.

mod pendulum;
mod two_port;

use std::hint::black_box;
use std::num::NonZero;
use std::thread::available_parallelism;

use mstmm::prelude::*;
use mstmm::{Error, GeneratedChain};
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};

use crate::output::exhibit::{Exhibit, KnownDifference, Row};
use crate::output::log_plot::{LogFigure, Series, Way};
use crate::output::progress::Progress;
use crate::rods::{Recursion, Rods};
use crate::section::Outcome;
use crate::system::GRAVITY;
use crate::timing::{Evaluation, Generated, difference, fastest};
use pendulum::Parts;

const SECTION: &str = "Section 2.4, in parallel";

/// The ways besides two-ports in parallel.
const SERIAL: [&str; 3] = [
    "generated code, riccati",
    "recursion of order n, at run time",
    "two-ports, one after the other",
];
/// Numbers of parts and threads that are tried, as far as the machine has them.
const PARALLEL: [(usize, &str); 6] = [
    (2, "two-ports on 2 threads"),
    (4, "two-ports on 4 threads"),
    (8, "two-ports on 8 threads"),
    (16, "two-ports on 16 threads"),
    (32, "two-ports on 32 threads"),
    (64, "two-ports on 64 threads"),
];
/// The places of generated code and of two-ports one after the other in [`SERIAL`].
const GENERATED: usize = 0;
const ONE_BY_ONE: usize = 2;

/// Batches that are timed: all threads have to be left alone in one of them.
const BATCHES: usize = 40;
/// Long chains keep their states on the stack.
const STACK: usize = 1 << 28;

/// What an evaluation by each way takes in s, first the serial ones, and how far the ways differ from
/// the first.
struct Timing {
    rods: usize,
    seconds: Vec<f64>,
    difference: f64,
}

impl Timing {
    /// The number of rods, and what each of them takes in s.
    fn for_a_rod(&self, way: usize) -> (f64, f64) {
        let rods = self.rods as f64;
        (rods, self.seconds[way] / rods)
    }
}

macro_rules! pendulums {
    ($($name:ident $count:tt)*) => {
        mstmm_chain! { $(
            plane chain $name {
                method = riccati;
                gravity = [0, -9.8] m/s^2;
                body Rod { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 1/12 kg*m^2 about com; }
                ground -> repeat $count { pin joint -> Rod rod };
            }
        )* }

        fn timings(pool: &ThreadPool, progress: &Progress) -> Result<Vec<Timing>, Error> {
            Ok(vec![$({
                progress.begin(concat!("parallel: ", $count, " rods"));
                // In a thread of the pool, which then need not be woken.
                pool.install(|| timing(&$name::new(), $count))?
            }),*])
        }

        /// How many parts the progress counts.
        pub const MOTIONS: usize = [$($count),*].len();
    };
}

pendulums! {
    Rods10 10
    Rods30 30
    Rods100 100
    Rods300 300
    Rods1000 1000
    Rods3000 3000
    Rods10000 10000
    Rods30000 30000
    Rods100000 100000
}

pub fn run(progress: &Progress) -> Result<Outcome, Error> {
    let threads = available_parallelism().map_or(1, NonZero::get);
    let pool = ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK).build();
    let pool = match pool {
        Ok(pool) => pool,
        Err(error) => return Ok(without_threads(&error)),
    };
    let timings = timings(&pool, progress)?;
    let names: Vec<&str> =
        SERIAL.into_iter().chain(parallel(threads).map(|(_, name)| name)).collect();
    let exhibits = vec![times(&timings, &names), pays(&timings, &names)];
    Ok(Outcome { exhibits, log_figures: vec![figure(&timings, &names)], ..Outcome::default() })
}

/// The numbers of threads to try on a machine that has so many.
fn parallel(threads: usize) -> impl Iterator<Item = (usize, &'static str)> {
    PARALLEL.into_iter().filter(move |(count, _)| *count <= threads)
}

/// Times a length; the pose is that of Figure 8.
fn timing<C: GeneratedChain<Scalar = f64>>(chain: &C, count: usize) -> Result<Timing, Error> {
    let rods = Rods {
        gravity: GRAVITY,
        angles: (0..count).map(|k| 0.4 * (1.7 * k as f64 + 0.3).sin()).collect(),
        rates: (0..count).map(|k| 0.5 * (2.3 * k as f64).cos()).collect(),
    };
    let rods = &rods;
    let mut generated = Generated::new(chain, &rods.angles, &rods.rates);
    generated.evaluate()?;
    let found = generated.accelerations().to_vec();
    let mut differences = Vec::new();
    let mut check = |other: &[f64]| differences.push(difference(&found, other));

    let mut recursion = Recursion::new(count);
    check(&rods.by_recursion(&mut recursion));
    let mut one = Parts::new(count, 1);
    check(one.in_turn(rods));
    let mut ways: Vec<Evaluation> = vec![
        Box::new(move || {
            let _ = black_box(generated.evaluate());
        }),
        Box::new(move || {
            black_box(black_box(rods).by_recursion(&mut recursion));
        }),
        Box::new(move || {
            black_box(one.in_turn(black_box(rods)));
        }),
    ];
    for (threads, _) in parallel(rayon::current_num_threads()) {
        let mut parts = Parts::new(count, threads);
        check(parts.at_once(rods));
        ways.push(Box::new(move || {
            black_box(parts.at_once(black_box(rods)));
        }));
    }
    // In this order NaN is the largest of all.
    let difference = differences.into_iter().max_by(f64::total_cmp).unwrap_or(f64::NAN);
    Ok(Timing { rods: count, seconds: fastest(&mut ways, BATCHES), difference })
}

fn times(timings: &[Timing], names: &[&str]) -> Exhibit {
    let row = |(way, name): (usize, &&str)| Row {
        name: (*name).into(),
        values: timings.iter().map(|timing| timing.seconds[way]).collect(),
    };
    let largest = timings.iter().map(|timing| timing.difference).max_by(f64::total_cmp);
    Exhibit {
        section: SECTION,
        title: "time for one evaluation of all accelerations in s",
        columns: timings.iter().map(|timing| format!("{} rods", timing.rods)).collect(),
        rows: names.iter().enumerate().map(row).collect(),
        says: vec![
            "A two-port has unknowns at both ends, so joining two of them takes more than the step from",
            "rod to rod that generated code takes: threads have to win that back first.",
        ],
        differences: vec![KnownDifference {
            what: "largest difference of the ways, of the largest acceleration".into(),
            size: largest.unwrap_or(f64::NAN),
            unit: "",
        }],
        faults: Vec::new(),
    }
}

/// From which length on threads are faster.
fn pays(timings: &[Timing], names: &[&str]) -> Exhibit {
    let against = |other: usize| {
        let columns = SERIAL.len()..names.len();
        columns.map(|way| pays_from(timings, way, other)).collect::<Vec<_>>()
    };
    let row = |name: &str, values: Vec<f64>| Row { name: name.into(), values };
    let longest = |other: usize| {
        let timing = timings.last();
        let gain =
            |way: usize| timing.map_or(f64::NAN, |one| one.seconds[other] / one.seconds[way]);
        (SERIAL.len()..names.len()).map(gain).collect::<Vec<_>>()
    };
    Exhibit {
        section: SECTION,
        title: "the number of rods from which on threads are faster",
        columns: PARALLEL[..names.len() - SERIAL.len()]
            .iter()
            .map(|(count, _)| format!("{count} threads"))
            .collect(),
        rows: vec![
            row("than two-ports one after the other", against(ONE_BY_ONE)),
            row("than generated code", against(GENERATED)),
            row("how many times, longest chain, than two-ports", longest(ONE_BY_ONE)),
            row("how many times, longest chain, than generated", longest(GENERATED)),
        ],
        says: vec![
            "A dash: not up to the longest chain. All numbers are of this run on this machine, where other",
            "work on its cores takes from what threads gain, and of rods in a plane, which need little",
            "arithmetic each.",
        ],
        differences: Vec::new(),
        faults: Vec::new(),
    }
}

/// The shortest chain from which on one way is always faster than the other.
fn pays_from(timings: &[Timing], way: usize, other: usize) -> f64 {
    let faster = |timing: &&Timing| timing.seconds[way] < timing.seconds[other];
    let from = timings.iter().rev().take_while(faster).last();
    from.map_or(f64::NAN, |timing| timing.rods as f64)
}

fn figure(timings: &[Timing], names: &[&'static str]) -> LogFigure {
    let series = |(way, label): (usize, &&'static str)| Series {
        label,
        way: if way == GENERATED { Way::Method } else { Way::Rival },
        points: timings.iter().map(|timing| timing.for_a_rod(way)).collect(),
    };
    LogFigure {
        file_name: "parallel.svg",
        title: "The overall product in parts: time for a rod in an evaluation of all accelerations",
        says: "Generated code goes from rod to rod; two-ports may be joined in any grouping, so that each \
               thread takes a part of the chain. Sharing the work out costs about a microsecond or two, \
               more than short chains take. All were timed in this run, on this machine.",
        x: "number of rods",
        y: "time for a rod in s",
        series: names.iter().enumerate().map(series).collect(),
    }
}

fn without_threads(error: &ThreadPoolBuildError) -> Outcome {
    let exhibit = Exhibit {
        section: SECTION,
        title: "not computed",
        columns: Vec::new(),
        rows: Vec::new(),
        says: vec!["The machine gives no threads."],
        differences: Vec::new(),
        faults: vec![format!("no threads: {error}")],
    };
    Outcome { exhibits: vec![exhibit], ..Outcome::default() }
}
