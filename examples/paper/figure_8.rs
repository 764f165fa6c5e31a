//! Section 4.3, Figure 8: the time for one evaluation of all accelerations against the number of rods, by
//! generated code of both methods, by Lagrange's equations and by a recursion of order n.

use std::hint::black_box;

use mstmm::prelude::*;
use mstmm::{Error, GeneratedChain};

use crate::output::drawing::{Canvas, Drawing, FROM_LEFT, Side};
use crate::output::log_figure::{LogFigure, Series, SeriesStyle};
use crate::output::progress::Progress;
use crate::output::result_table::{ResultTable, Row};
use crate::power_law;
use crate::rods::{Recursion, Rods};
use crate::section::{Measurement, SectionResult};
use crate::system::GRAVITY;
use crate::timing::{BATCHES, Evaluation, Generated, difference, fastest};
use crate::verdict::{Bound, Check, Verdict};

/// The power law is fitted to chains of at least this number of rods.
const LONG: usize = 20;

const FIGURE_8: &str = "figure_8.svg";

/// The first two are generated code.
const METHODS: [&str; 4] =
    ["riccati", "transfer", "Lagrange, Cholesky", "recursion of order n, at run time"];

/// The time of one evaluation by each method in s, and the largest relative difference between the
/// first method and the others.
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

        /// The number of lengths that are timed.
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

pub fn run(progress: &Progress) -> Result<SectionResult, Error> {
    let timings = timings(progress)?;
    let series = |method: usize| {
        let point = |timing: &Timing| (timing.rods as f64, timing.seconds[method]);
        timings.iter().map(point).collect::<Vec<_>>()
    };
    let exponent = |method: usize| {
        let long = series(method).into_iter().filter(|(rods, _)| *rods >= LONG as f64);
        power_law::exponent(&long.collect::<Vec<_>>())
    };
    let rows = METHODS.iter().enumerate().map(|(method, name)| {
        let seconds = timings.iter().map(|timing| timing.seconds[method]);
        Row { name: (*name).to_owned(), values: seconds.chain([exponent(method)]).collect() }
    });
    let largest = timings.iter().map(|timing| timing.difference).max_by(f64::total_cmp);
    let columns = timings.iter().map(|timing| format!("{} rods", timing.rods));
    let table = ResultTable {
        section: "Section 4.3",
        title: "Figure 8, time for one evaluation of all accelerations in s",
        columns: columns.chain([format!("exponent, n ≥ {LONG}")]).collect(),
        rows: rows.collect(),
        note: "The time of generated code and of the recursion grows with the number n of rods. The time of \
               Lagrange's equations grows with n², and with n³ for long chains. All times were measured in \
               this run, on this machine.",
        verdicts: vec![Verdict {
            compared: "all four methods, accelerations, relative".into(),
            figure: Some(FIGURE_8),
            checks: vec![Check {
                what: "largest difference of the ways, of the largest acceleration".into(),
                size: largest.unwrap_or(f64::NAN),
                unit: "",
                bound: Bound::Tolerance,
            }],
        }],
    };
    let text = format!(
        "time ~ n^{:.2} (riccati), n^{:.2} (transfer), n^{:.2} (Lagrange), n ≥ {LONG}",
        exponent(0),
        exponent(1),
        exponent(2)
    );
    let figure = LogFigure {
        file_name: FIGURE_8,
        title: "Figure 8 of the paper: time for one evaluation of all accelerations",
        caption: "Lines: generated code. Crosses: the methods that the paper compares with. All times were \
                  measured in this run, on this machine.",
        x: "number of rods",
        y: "time in s",
        series: METHODS
            .iter()
            .enumerate()
            .map(|(method, name)| Series {
                label: name,
                style: if method < 2 { SeriesStyle::Line } else { SeriesStyle::Crosses },
                points: series(method),
            })
            .collect(),
    };
    Ok(SectionResult {
        drawings: vec![drawing()],
        tables: vec![table],
        log_figures: vec![figure],
        measurements: vec![Measurement { text, figure: Some(FIGURE_8) }],
        ..SectionResult::default()
    })
}

/// The angle of hinge `k` in rad.
fn angle(k: usize) -> f64 {
    0.4 * (1.7 * k as f64 + 0.3).sin()
}

/// Times the methods for `count` rods, in a pose without symmetry.
fn timing<A, B>(riccati: &A, transfer: &B, count: usize) -> Result<Timing, Error>
where
    A: GeneratedChain<Scalar = f64>,
    B: GeneratedChain<Scalar = f64>,
{
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
    let others = [by_transfer.accelerations(), &lagrange, &recursion];
    let differences = others.map(|other| difference(by_riccati.accelerations(), other));

    let mut evaluations: [Evaluation; METHODS.len()] = [
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
    let seconds = fastest(&mut evaluations, BATCHES);
    let difference = differences.into_iter().max_by(f64::total_cmp).unwrap_or(f64::NAN);
    Ok(Timing { rods: count, seconds, difference })
}

fn drawing() -> Drawing {
    const DRAWN: usize = 6;
    let mut canvas = Canvas::new([-0.6, 7.1], [-1.1, 2.0], 420.0);
    let mut absolute = 0.0;
    let mut points = vec![[0.0, 0.0]];
    for k in 0..DRAWN {
        absolute += angle(k);
        let [x, y] = points[k];
        points.push([x + absolute.cos(), y + absolute.sin()]);
    }
    canvas.support(points[0], FROM_LEFT);
    points.windows(2).for_each(|ends| canvas.rod(ends[0], ends[1]));
    points[..DRAWN].iter().for_each(|&point| canvas.pin(point));
    canvas.text(points[DRAWN], Side::Right, "… n");
    canvas.gravity([6.3, -0.2]);
    canvas.finish(
        "Figure 8: a pendulum of n rods",
        "The first six of n homogeneous rods of 1 m and 1 kg on pins, in the timed pose. The rods of the claim on \
         parallel computation are in the same pose.",
    )
}
