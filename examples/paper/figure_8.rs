//! Figure 8: what an evaluation of all accelerations costs against the number of rods, by generated
//! code of both methods, by Lagrange's equations and by a recursion of order n.

use std::hint::black_box;

use mstmm::prelude::*;
use mstmm::{Error, GeneratedChain};

use crate::output::exhibit::{Exhibit, KnownDifference, Row};
use crate::output::log_plot::{LogFigure, Series, Way};
use crate::output::progress::Progress;
use crate::power_law;
use crate::rods::{Recursion, Rods};
use crate::section::Outcome;
use crate::system::GRAVITY;
use crate::timing::{BATCHES, Evaluation, Generated, difference, fastest};

/// From so many rods on a power law is fitted.
const LONG: usize = 20;

/// The first two are generated code.
const WAYS: [&str; 4] =
    ["riccati", "transfer", "Lagrange, Cholesky", "recursion of order n, at run time"];

/// What an evaluation by each way takes in s, and how far the ways differ from the first.
struct Timing {
    rods: usize,
    seconds: Vec<f64>,
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
        let long = series(way).into_iter().filter(|(rods, _)| *rods >= LONG as f64);
        let exponent = power_law::exponent(&long.collect::<Vec<_>>());
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
    A: GeneratedChain<Scalar = f64>,
    B: GeneratedChain<Scalar = f64>,
{
    let angle = |k: usize| 0.4 * (1.7 * k as f64 + 0.3).sin();
    let rods = Rods {
        gravity: GRAVITY,
        angles: (0..count).map(angle).collect(),
        rates: (0..count).map(|k| 0.5 * (2.3 * k as f64).cos()).collect(),
    };
    let mut by_riccati = Generated::new(riccati, &rods.angles, &rods.rates);
    let mut by_transfer = Generated::new(transfer, &rods.angles, &rods.rates);
    let mut work = Recursion::new(count);
    by_riccati.evaluate()?;
    by_transfer.evaluate()?;
    let (lagrange, recursion) = (rods.by_lagrange(), rods.by_recursion(&mut work));
    let all = [by_transfer.accelerations(), &lagrange, &recursion];
    let differences = all.map(|other| difference(by_riccati.accelerations(), other));

    let mut ways: [Evaluation; WAYS.len()] = [
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
    let seconds = fastest(&mut ways, BATCHES);
    let difference = differences.into_iter().max_by(f64::total_cmp).unwrap_or(f64::NAN);
    Ok(Timing { rods: count, seconds, difference })
}
