//! The overall product in parts, by the associative two-port form of a part.
//!
//! "The overall transfer matrix (10) could be computed by a parallel algorithm, not necessarily by
//! serial processing" [P, section 2.4]. The paper has no example. Here a pendulum of rods is divided into
//! parts, one for each thread, and its time is compared with that of generated code, which is serial.

mod pendulum;
mod two_port;

use std::hint::black_box;
use std::num::NonZero;
use std::thread::available_parallelism;

use mstmm::prelude::*;
use mstmm::{Error, GeneratedChain};
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};

use crate::output::log_figure::{LogFigure, Series, SeriesStyle};
use crate::output::progress::Progress;
use crate::output::result_table::{ResultTable, Row};
use crate::rods::{Recursion, Rods};
use crate::section::{Measurement, SectionResult};
use crate::system::GRAVITY;
use crate::timing::{Evaluation, Generated, difference, fastest};
use crate::verdict::{Bound, Check, Verdict};
use pendulum::Parts;

const SECTION: &str = "Section 2.4, in parallel";

/// The serial methods.
const SERIAL: [&str; 3] = [
    "generated code, riccati",
    "recursion of order n, at run time",
    "two-ports, one after the other",
];
/// Numbers of parts and threads, as far as the machine has them.
const PARALLEL: [(usize, &str); 6] = [
    (2, "two-ports on 2 threads"),
    (4, "two-ports on 4 threads"),
    (8, "two-ports on 8 threads"),
    (16, "two-ports on 16 threads"),
    (32, "two-ports on 32 threads"),
    (64, "two-ports on 64 threads"),
];
/// The indices of generated code and of serial two-ports in [`SERIAL`].
const GENERATED: usize = 0;
const SERIAL_TWO_PORTS: usize = 2;
const FIGURE: &str = "parallel.svg";

/// Batches that are timed. In at least one of them, no other process should disturb any thread.
const BATCHES: usize = 40;
/// The stack of a thread in bytes. The states of long chains are on the stack.
const STACK: usize = 1 << 28;

/// The time of one evaluation by each method in s, the serial methods first, and the largest relative
/// difference between the first method and the others.
struct Timing {
    rods: usize,
    seconds: Vec<f64>,
    difference: f64,
}

impl Timing {
    /// The number of rods, and the time per rod in s.
    fn per_rod(&self, method: usize) -> (f64, f64) {
        let rods = self.rods as f64;
        (rods, self.seconds[method] / rods)
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
                // In a thread of the pool, so that it need not be woken.
                pool.install(|| timing(&$name::new(), $count))?
            }),*])
        }

        /// The number of parts that the progress bar counts.
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

pub fn run(progress: &Progress) -> Result<SectionResult, Error> {
    let threads = available_parallelism().map_or(1, NonZero::get);
    let pool = ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK).build();
    let pool = match pool {
        Ok(pool) => pool,
        Err(error) => return Ok(without_threads(&error)),
    };
    let timings = timings(&pool, progress)?;
    let names: Vec<&str> =
        SERIAL.into_iter().chain(parallel(threads).map(|(_, name)| name)).collect();
    let measurements =
        vec![Measurement { text: break_even(&timings, &names, threads), figure: Some(FIGURE) }];
    Ok(SectionResult {
        tables: vec![times(&timings, &names), break_even_table(&timings, &names)],
        log_figures: vec![figure(&timings, &names)],
        measurements,
        ..SectionResult::default()
    })
}

/// The numbers of parts to compute on a machine with this number of threads.
fn parallel(threads: usize) -> impl Iterator<Item = (usize, &'static str)> {
    PARALLEL.into_iter().filter(move |(count, _)| *count <= threads)
}

/// Times the methods for `count` rods, in the pose of Figure 8.
fn timing<C: GeneratedChain<Scalar = f64>>(chain: &C, count: usize) -> Result<Timing, Error> {
    let rods = Rods {
        gravity: GRAVITY,
        angles: (0..count).map(|k| 0.4 * (1.7 * k as f64 + 0.3).sin()).collect(),
        rates: (0..count).map(|k| 0.5 * (2.3 * k as f64).cos()).collect(),
    };
    let rods = &rods;
    let mut generated = Generated::new(chain, &rods.angles, &rods.rates);
    generated.evaluate()?;
    let accelerations = generated.accelerations().to_vec();
    let mut differences = Vec::new();
    let mut check = |other: &[f64]| differences.push(difference(&accelerations, other));

    let mut recursion = Recursion::new(count);
    check(&rods.by_recursion(&mut recursion));
    let mut serial = Parts::new(count, 1);
    check(serial.compute_serially(rods));
    let mut evaluations: Vec<Evaluation> = vec![
        Box::new(move || {
            let _ = black_box(generated.evaluate());
        }),
        Box::new(move || {
            black_box(black_box(rods).by_recursion(&mut recursion));
        }),
        Box::new(move || {
            black_box(serial.compute_serially(black_box(rods)));
        }),
    ];
    for (threads, _) in parallel(rayon::current_num_threads()) {
        let mut parts = Parts::new(count, threads);
        check(parts.compute_in_parallel(rods));
        evaluations.push(Box::new(move || {
            black_box(parts.compute_in_parallel(black_box(rods)));
        }));
    }
    // In this order NaN is the largest of all.
    let difference = differences.into_iter().max_by(f64::total_cmp).unwrap_or(f64::NAN);
    Ok(Timing { rods: count, seconds: fastest(&mut evaluations, BATCHES), difference })
}

fn times(timings: &[Timing], names: &[&str]) -> ResultTable {
    let row = |(method, name): (usize, &&str)| Row {
        name: (*name).into(),
        values: timings.iter().map(|timing| timing.seconds[method]).collect(),
    };
    let largest = timings.iter().map(|timing| timing.difference).max_by(f64::total_cmp);
    ResultTable {
        section: SECTION,
        title: "time for one evaluation of all accelerations in s",
        columns: timings.iter().map(|timing| format!("{} rods", timing.rods)).collect(),
        rows: names.iter().enumerate().map(row).collect(),
        note: "A two-port has unknowns at both ends. Joining two of them therefore costs more than the step \
               of generated code from one rod to the next; threads must first make up for that. All times were \
               measured in this run, on this machine.",
        verdicts: vec![Verdict {
            compared: "two-ports, recursion – generated code, relative".into(),
            figure: Some(FIGURE),
            checks: vec![Check {
                what: "largest difference of the ways, of the largest acceleration".into(),
                size: largest.unwrap_or(f64::NAN),
                unit: "",
                bound: Bound::Tolerance,
            }],
        }],
    }
}

/// States from how many rods the largest number of threads is faster than generated code.
fn break_even(timings: &[Timing], names: &[&str], threads: usize) -> String {
    let parallel = SERIAL.len()..names.len();
    let least = parallel.map(|method| faster_from(timings, method, GENERATED));
    let least = least.filter(|rods| rods.is_finite()).min_by(f64::total_cmp);
    match least {
        Some(rods) => {
            format!("{threads} threads: two-ports are faster than generated code from {rods} rods")
        }
        None => format!("{threads} threads: generated code is faster up to 100 000 rods"),
    }
}

/// From how many rods threads are faster.
fn break_even_table(timings: &[Timing], names: &[&str]) -> ResultTable {
    let against = |other: usize| {
        let columns = SERIAL.len()..names.len();
        columns.map(|method| faster_from(timings, method, other)).collect::<Vec<_>>()
    };
    let row = |name: &str, values: Vec<f64>| Row { name: name.into(), values };
    let longest = |other: usize| {
        let timing = timings.last();
        let gain = |method: usize| {
            timing.map_or(f64::NAN, |timing| timing.seconds[other] / timing.seconds[method])
        };
        (SERIAL.len()..names.len()).map(gain).collect::<Vec<_>>()
    };
    ResultTable {
        section: SECTION,
        title: "the number of rods from which on threads are faster",
        columns: PARALLEL[..names.len() - SERIAL.len()]
            .iter()
            .map(|(count, _)| format!("{count} threads"))
            .collect(),
        rows: vec![
            row("than two-ports one after the other", against(SERIAL_TWO_PORTS)),
            row("than generated code", against(GENERATED)),
            row("how many times, longest chain, than two-ports", longest(SERIAL_TWO_PORTS)),
            row("how many times, longest chain, than generated", longest(GENERATED)),
        ],
        note: "A dash: threads are not faster up to the longest chain. The last two rows are the speed-up for the \
               longest chain. All values are those of this run on this machine, for planar rods, which need \
               little arithmetic; other processes on its cores reduce the speed-up.",
        verdicts: Vec::new(),
    }
}

/// The number of rods from which a method is always faster than another one; NaN if there is none.
fn faster_from(timings: &[Timing], method: usize, other: usize) -> f64 {
    let faster = |timing: &&Timing| timing.seconds[method] < timing.seconds[other];
    let from = timings.iter().rev().take_while(faster).last();
    from.map_or(f64::NAN, |timing| timing.rods as f64)
}

fn figure(timings: &[Timing], names: &[&'static str]) -> LogFigure {
    let series = |(method, label): (usize, &&'static str)| Series {
        label,
        style: if method == GENERATED { SeriesStyle::Line } else { SeriesStyle::Crosses },
        points: timings.iter().map(|timing| timing.per_rod(method)).collect(),
    };
    LogFigure {
        file_name: FIGURE,
        title: "The overall product in parts: time per rod for one evaluation",
        caption: "Generated code is serial. Two-ports can be joined in any grouping, so that each thread computes \
                  a part of the chain. Distributing the work costs one or two microseconds, more than a short \
                  chain takes. All times were measured in this run, on this machine.",
        x: "number of rods",
        y: "time per rod in s",
        series: names.iter().enumerate().map(series).collect(),
    }
}

fn without_threads(error: &ThreadPoolBuildError) -> SectionResult {
    let table = ResultTable {
        section: SECTION,
        title: "not computed",
        columns: Vec::new(),
        rows: Vec::new(),
        note: "The threads could not be started.",
        // Without checks: it fails.
        verdicts: vec![Verdict {
            compared: format!("no threads: {error}"),
            figure: None,
            checks: Vec::new(),
        }],
    };
    SectionResult { tables: vec![table], ..SectionResult::default() }
}
