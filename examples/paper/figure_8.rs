//! Figure 8: what an evaluation of all accelerations costs against the number of rods, by generated
//! code of both methods, by Lagrange's equations and by a recursion of order n. All are timed in one
//! run, in turns, so that what else the machine does falls on all of them.

use std::hint::black_box;
use std::time::Instant;

use mstmm::prelude::*;
use mstmm::{Error, GeneratedChain};

use crate::output::exhibit::{Exhibit, KnownDifference, Row};
use crate::output::log_plot::{LogFigure, Series, Way};
use crate::output::progress::Progress;
use crate::rods::{Recursion, Rods};
use crate::section::Outcome;
use crate::system::GRAVITY;

/// How long a batch of evaluations is timed in s, and how many batches of each way; the fastest counts,
/// which other work on the machine has slowed least.
const BATCH: f64 = 1e-3;
const BATCHES: usize = 15;
/// From so many rods on a power law is fitted.
const LONG: usize = 20;

/// The first two are generated code.
const WAYS: [&str; 4] =
    ["riccati", "transfer", "Lagrange, Cholesky", "recursion of order n, at run time"];

/// What an evaluation by each way takes in s, and how far the ways differ from the first.
struct Timing {
    rods: usize,
    seconds: [f64; WAYS.len()],
    difference: f64,
}

macro_rules! pendulums {
    ($($riccati:ident $transfer:ident $count:tt)*) => {
        mstmm_chain! { $(
            plane chain $riccati {
                method = riccati;
                gravity = [0, -9.8] m/s^2;
                body Rod { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 1/12 kg*m^2 about com; }
                ground -> repeat $count { pin joint -> Rod rod };
            }
            plane chain $transfer {
                method = transfer;
                gravity = [0, -9.8] m/s^2;
                body Rod { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 1/12 kg*m^2 about com; }
                ground -> repeat $count { pin joint -> Rod rod };
            }
        )* }

        fn timings(progress: &Progress) -> Result<Vec<Timing>, Error> {
            Ok(vec![$({
                progress.begin(concat!("4.3: Figure 8, ", $count, " rods"));
                timing(&$riccati::new(), &$transfer::new(), $count)?
            }),*])
        }

        /// How many lengths are timed.
        pub const LENGTHS: usize = [$($count),*].len();
    };
}

pendulums! {
    Rods1 Rods1ByTransfer 1
    Rods2 Rods2ByTransfer 2
    Rods5 Rods5ByTransfer 5
    Rods10 Rods10ByTransfer 10
    Rods20 Rods20ByTransfer 20
    Rods50 Rods50ByTransfer 50
    Rods100 Rods100ByTransfer 100
    Rods200 Rods200ByTransfer 200
    Rods500 Rods500ByTransfer 500
}

pub fn run(progress: &Progress) -> Result<Outcome, Error> {
    let timings = timings(progress)?;
    let series = |way: usize| {
        timings.iter().map(|timing| (timing.rods as f64, timing.seconds[way])).collect::<Vec<_>>()
    };
    let rows = WAYS.iter().enumerate().map(|(way, name)| {
        let exponent = exponent(&series(way));
        let seconds = timings.iter().map(|timing| timing.seconds[way]);
        Row { name: (*name).to_owned(), values: seconds.chain([exponent]).collect() }
    });
    let largest = timings.iter().map(|timing| timing.difference).max_by(f64::total_cmp);
    let columns = timings.iter().map(|timing| format!("{} rods", timing.rods));
    let exhibit = Exhibit {
        section: "Section 4.3",
        title: "Figure 8, time for one evaluation of all accelerations in s",
        columns: columns.chain([format!("exponent, n ≥ {LONG}")]).collect(),
        rows: rows.collect(),
        says: vec![
            "Generated code takes a time that grows with the number of rods, as that of the recursion",
            "does; that of Lagrange's equations grows with its square, and with its cube at last.",
        ],
        differences: vec![KnownDifference {
            what: "largest difference of the ways, of the largest acceleration".into(),
            size: largest.unwrap_or(f64::NAN),
            unit: "",
        }],
        faults: Vec::new(),
    };
    let figure = LogFigure {
        file_name: "figure_8.svg",
        title: "Figure 8: time for one evaluation of all accelerations",
        says: "The time of both methods grows with the number of rods, as that of the recursion does; that \
               of Lagrange's equations grows faster. All were timed in this run, on this machine.",
        x: "number of rods",
        y: "time in s",
        series: WAYS
            .iter()
            .enumerate()
            .map(|(way, name)| Series {
                label: name,
                way: if way < 2 { Way::Method } else { Way::Rival },
                points: series(way),
            })
            .collect(),
    };
    Ok(Outcome { exhibits: vec![exhibit], log_figures: vec![figure], ..Outcome::default() })
}

/// Times a length; the pose is one like any other.
fn timing<A, B>(riccati: &A, transfer: &B, count: usize) -> Result<Timing, Error>
where
    A: GeneratedChain<Scalar = f64, State: Default>,
    B: GeneratedChain<Scalar = f64, State: Default>,
{
    let angle = |k: usize| 0.4 * (1.7 * k as f64 + 0.3).sin();
    let rods = Rods {
        gravity: GRAVITY,
        angles: (0..count).map(angle).collect(),
        rates: (0..count).map(|k| 0.5 * (2.3 * k as f64).cos()).collect(),
    };
    let mut by_riccati = Generated::new(riccati, &rods);
    let mut by_transfer = Generated::new(transfer, &rods);
    let mut work = Recursion::new(count);
    by_riccati.evaluate()?;
    by_transfer.evaluate()?;
    let (lagrange, recursion) = (rods.by_lagrange(), rods.by_recursion(&mut work));
    let all = [by_transfer.accelerations(), &lagrange, &recursion];
    let differences = all.map(|other| difference(by_riccati.accelerations(), other));

    let mut ways: [Box<dyn FnMut() + '_>; WAYS.len()] = [
        Box::new(|| {
            let _ = black_box(by_riccati.evaluate());
        }),
        Box::new(|| {
            let _ = black_box(by_transfer.evaluate());
        }),
        Box::new(|| {
            black_box(black_box(&rods).by_lagrange());
        }),
        Box::new(|| {
            black_box(black_box(&rods).by_recursion(&mut work));
        }),
    ];
    let counts = ways.each_mut().map(|way| evaluations_in(BATCH, way));
    let mut times = [(); WAYS.len()].map(|()| Vec::new());
    for _ in 0..BATCHES {
        for ((way, &count), times) in ways.iter_mut().zip(&counts).zip(&mut times) {
            times.push(seconds(count, way) / f64::from(count));
        }
    }
    let seconds = times.map(|times| times.into_iter().fold(f64::INFINITY, f64::min));
    let difference = differences.into_iter().max_by(f64::total_cmp).unwrap_or(f64::NAN);
    Ok(Timing { rods: count, seconds, difference })
}

/// A generated chain in a pose.
struct Generated<'a, C: GeneratedChain> {
    chain: &'a C,
    state: C::State,
    rate: C::State,
    inputs: C::Inputs,
}

impl<'a, C: GeneratedChain<Scalar = f64, State: Default>> Generated<'a, C> {
    fn new(chain: &'a C, rods: &Rods) -> Self {
        let mut state = chain.initial_state();
        state.q_mut().copy_from_slice(&rods.angles);
        state.v_mut().copy_from_slice(&rods.rates);
        Generated { chain, state, rate: C::State::default(), inputs: chain.no_inputs() }
    }

    fn evaluate(&mut self) -> Result<(), Error> {
        let state = black_box(&self.state);
        self.chain.derivative_into(state, black_box(&self.inputs), black_box(&mut self.rate))
    }

    fn accelerations(&self) -> &[f64] {
        self.rate.v()
    }
}

/// The largest difference, of the largest number.
fn difference(a: &[f64], b: &[f64]) -> f64 {
    let largest = a.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs() / largest);
    differences.max_by(f64::total_cmp).unwrap_or(f64::NAN)
}

/// How many evaluations take about so long, at least one.
fn evaluations_in(duration: f64, way: &mut impl FnMut()) -> u32 {
    let mut count = 1;
    while seconds(count, way) < duration && count < 1 << 24 {
        count *= 2;
    }
    count
}

fn seconds(count: u32, way: &mut impl FnMut()) -> f64 {
    let start = Instant::now();
    for _ in 0..count {
        way();
    }
    start.elapsed().as_secs_f64()
}

/// The exponent of the power law through the points of long pendulums, by least squares.
fn exponent(points: &[(f64, f64)]) -> f64 {
    let long = points.iter().filter(|(rods, _)| *rods >= LONG as f64);
    let logs: Vec<(f64, f64)> = long.map(|(x, y)| (x.ln(), y.ln())).collect();
    let count = logs.len() as f64;
    let mean_x = logs.iter().map(|(x, _)| x).sum::<f64>() / count;
    let mean_y = logs.iter().map(|(_, y)| y).sum::<f64>() / count;
    let covariance: f64 = logs.iter().map(|(x, y)| (x - mean_x) * (y - mean_y)).sum();
    covariance / logs.iter().map(|(x, _)| (x - mean_x).powi(2)).sum::<f64>()
}
