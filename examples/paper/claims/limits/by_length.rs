//! The relative error of all accelerations against the number of bodies: by the product of the paper's
//! matrices and by both methods of generated code, in double and in single precision.

use mstmm::prelude::*;
use mstmm::{Error, Scalar};
use nalgebra::Vector3;

use super::DIGITS;
use super::errors::{Cubes, accelerations, apart, bound, error};
use super::pose::Pose;
use super::product::Product;
use super::reference;
use crate::output::log_figure::{LogFigure, Series, SeriesStyle};
use crate::output::progress::Progress;
use crate::output::result_table::{ResultTable, Row};
use crate::section::{Measurement, SectionResult};
use crate::verdict::{Bound, Check, Verdict};

/// The number of states of each length. The largest error counts.
const SEEDS: u64 = 3;

const FIGURE: &str = "accuracy.svg";

/// The first two are the product of the paper's matrices, the others generated code.
const METHODS: [&str; 6] = [
    "product as printed, f64",
    "product as printed, f32",
    "transfer, f64",
    "transfer, f32",
    "riccati, f64",
    "riccati, f32",
];
/// The first of [`METHODS`] that is generated code.
const FIRST_GENERATED: usize = 2;
/// The largest change of the reference, far below every measured error.
const REFERENCE_BOUND: f64 = 1e-30;
/// The machine epsilon of double and single precision.
const UNITS: [f64; 2] = [f64::EPSILON, f32::EPSILON as f64];

const NOTE: &str = "The product of the printed matrices loses nearly one digit per body: no digit is left from 20 bodies \
    in double precision and from 10 bodies in single precision (1 or more: all digits lost; –: not finite). \
    Both methods of generated code keep 13 of 16 digits in double and about 5 of 7 in single precision at every \
    length, although they compute poses and velocities from rounded coordinates, and the product is given \
    poses and velocities. The bound is the sum of the rounding errors of all operations, 1240 per body. The \
    reference solves the Newton–Euler equations of all bodies, in a separate program text, with 160 binary \
    digits; the last row is its change with 320 digits.";

/// The errors of chains of a length.
struct Length {
    count: usize,
    errors: [f64; METHODS.len()],
    /// The change of the reference with twice the digits.
    of_reference: f64,
}

macro_rules! cubes {
    ($name:ident $method:ident $count:tt [$($hinge:tt)*]) => {
        mstmm_chain! {
            chain $name {
                method = $method;
                gravity = [0, -9.8, 0] m/s^2;
                body Cube {
                    mass = 1 kg;
                    com = [0.5, 0, 0] m;
                    output = [1, 0, 0] m;
                    inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
                }
                ground -> repeat $count { $($hinge)* joint -> Cube cube };
            }
        }

        impl<T: Scalar> Cubes for $name<T> {
            fn at_inputs(at: &Self::Workspace) -> Vec<[Vector3<T>; 2]> {
                let cubes = (0..$count).filter_map(|k| at.cube(k));
                cubes
                    .map(|cube| {
                        [cube.input().acceleration(), cube.input().angular_acceleration()]
                    })
                    .collect()
            }
        }
    };
}

/// The errors of all methods for one length, in the poses that a function of length and seed gives.
macro_rules! length {
    ($what:literal $count:tt $pose:ident $transfer:ident $riccati:ident $progress:ident) => {{
        $progress.begin(concat!("limits: ", $count, " ", $what));
        worst($count, $pose, |pose| {
            Ok([
                Product::<f64>::new(pose).accelerations::<{ 2 * $count }>(),
                Product::<f32>::new(pose).accelerations::<{ 2 * $count }>(),
                accelerations(&$transfer::<f64>::new(), pose)?,
                accelerations(&$transfer::<f32>::new(), pose)?,
                accelerations(&$riccati::<f64>::new(), pose)?,
                accelerations(&$riccati::<f32>::new(), pose)?,
            ])
        })?
    }};
}

macro_rules! chains {
    ($($balls:ident $balls_by_transfer:ident $pins:ident $pins_by_transfer:ident $count:tt)*) => {
        $(
            cubes! { $balls riccati $count [ball] }
            cubes! { $balls_by_transfer transfer $count [ball] }
            cubes! { $pins riccati $count [pin(z)] }
            cubes! { $pins_by_transfer transfer $count [pin(z)] }
        )*

        fn of_balls(progress: &Progress) -> Result<Vec<Length>, Error> {
            Ok(vec![$(
                length!("cubes on balls" $count on_balls $balls_by_transfer $balls progress)
            ),*])
        }

        fn of_pins(progress: &Progress) -> Result<Vec<Length>, Error> {
            Ok(vec![$(
                length!("cubes on pins" $count on_pins $pins_by_transfer $pins progress)
            ),*])
        }

        /// The number of parts that the progress bar counts.
        pub const MOTIONS: usize = 2 * [$($count),*].len();
    };
}

chains! {
    Balls1 Balls1ByTransfer Pins1 Pins1ByTransfer 1
    Balls2 Balls2ByTransfer Pins2 Pins2ByTransfer 2
    Balls3 Balls3ByTransfer Pins3 Pins3ByTransfer 3
    Balls5 Balls5ByTransfer Pins5 Pins5ByTransfer 5
    Balls10 Balls10ByTransfer Pins10 Pins10ByTransfer 10
    Balls15 Balls15ByTransfer Pins15 Pins15ByTransfer 15
    Balls20 Balls20ByTransfer Pins20 Pins20ByTransfer 20
    Balls30 Balls30ByTransfer Pins30 Pins30ByTransfer 30
    Balls60 Balls60ByTransfer Pins60 Pins60ByTransfer 60
    Balls100 Balls100ByTransfer Pins100 Pins100ByTransfer 100
}

fn on_balls(count: usize, seed: u64) -> Pose {
    Pose::of_balls(count, seed)
}

fn on_pins(count: usize, seed: u64) -> Pose {
    Pose::of_pins(vec![[0.0, 0.0, 1.0]; count], seed)
}

pub fn run(progress: &Progress) -> Result<SectionResult, Error> {
    let (balls, pins) = (of_balls(progress)?, of_pins(progress)?);
    let figure = figure(&balls);
    let tables = vec![
        table(
            "relative error of all accelerations, cubes on balls",
            &balls,
            NOTE,
            "cubes on balls",
        ),
        table(
            "relative error of all accelerations, cubes on parallel pins",
            &pins,
            "With parallel pins, where the motion is planar, the product loses slightly less.",
            "cubes on pins",
        ),
    ];
    let measurements = vec![Measurement { text: lost_digits(&balls), figure: Some(FIGURE) }];
    Ok(SectionResult {
        tables,
        log_figures: vec![figure],
        measurements,
        ..SectionResult::default()
    })
}

/// States from how many bodies the product of the printed matrices has no correct digit.
fn lost_digits(lengths: &[Length]) -> String {
    let from = |method: usize| {
        let lost = |error: f64| error.is_nan() || error >= 1.0;
        let lost = lengths.iter().find(|length| lost(length.errors[method]));
        lost.map_or("more than 100".to_owned(), |length| length.count.to_string())
    };
    format!(
        "the printed product has no correct digit from {} balls (f64), {} (f32)",
        from(0),
        from(1)
    )
}

/// The largest errors over all states of a length.
fn worst(
    count: usize,
    pose: impl Fn(usize, u64) -> Pose,
    methods: impl Fn(&Pose) -> Result<[Vec<f64>; METHODS.len()], Error>,
) -> Result<Length, Error> {
    // In the order of `total_cmp`, NaN is the largest.
    let worse = |a: f64, b: f64| if a.total_cmp(&b).is_lt() { b } else { a };
    let mut worst = Length { count, errors: [0.0; METHODS.len()], of_reference: 0.0 };
    for seed in 0..SEEDS {
        let pose = pose(count, seed);
        let truth = reference::accelerations(&pose, DIGITS)?;
        let better = reference::accelerations(&pose, 2 * DIGITS)?;
        worst.of_reference = worse(worst.of_reference, apart(&truth, &better));
        for (largest, found) in worst.errors.iter_mut().zip(methods(&pose)?) {
            *largest = worse(*largest, error(&found, &truth));
        }
    }
    Ok(worst)
}

fn table(
    title: &'static str,
    lengths: &[Length],
    note: &'static str,
    chains: &'static str,
) -> ResultTable {
    let row = |name: &str, value: &dyn Fn(&Length) -> f64| Row {
        name: name.to_owned(),
        values: lengths.iter().map(value).collect(),
    };
    let mut rows: Vec<Row> =
        METHODS.iter().enumerate().map(|(k, name)| row(name, &|length| length.errors[k])).collect();
    rows.push(row("bound for generated code, f64", &|length| bound(length.count, UNITS[0])));
    rows.push(row("bound for generated code, f32", &|length| bound(length.count, UNITS[1])));
    rows.push(row("reference, 160 to 320 binary digits", &|length| length.of_reference));
    ResultTable {
        section: "Limits",
        title,
        columns: lengths.iter().map(|length| format!("n = {}", length.count)).collect(),
        rows,
        note,
        verdicts: vec![verdict(chains, lengths)],
    }
}

/// Compares every error of generated code with its bound, and the reference with one of twice the digits.
fn verdict(chains: &str, lengths: &[Length]) -> Verdict {
    let check = |what: String, size: f64, bound: f64| {
        let unit = "";
        Check { what, size, unit, bound: Bound::Fixed(bound) }
    };
    let checks = lengths.iter().flat_map(|Length { count, errors, of_reference }| {
        let methods = (FIRST_GENERATED..METHODS.len()).map(move |method| {
            let what = format!("{}, n = {count}", METHODS[method]);
            check(what, errors[method], bound(*count, UNITS[method % 2]))
        });
        let reference = format!("change of the reference with twice the digits, n = {count}");
        methods.chain([check(reference, *of_reference, REFERENCE_BOUND)])
    });
    Verdict {
        compared: format!("{chains}: code – 160-bit, relative"),
        figure: Some(FIGURE),
        checks: checks.collect(),
    }
}

fn figure(lengths: &[Length]) -> LogFigure {
    // An error of one or more, or NaN: no digit is correct.
    let point =
        |method: usize, length: &Length| (length.count as f64, length.errors[method].min(1.0));
    let series = |(method, label): (usize, &&'static str)| Series {
        label,
        style: if method < FIRST_GENERATED { SeriesStyle::Crosses } else { SeriesStyle::Line },
        points: lengths.iter().map(|length| point(method, length)).collect(),
    };
    LogFigure {
        file_name: FIGURE,
        title: "Relative error of all accelerations, cubes on balls",
        caption: "Crosses: the product of the paper's matrices as printed, which loses nearly one digit per \
                  body. An error of 1 (drawn also for larger errors) means that no digit is correct. Lines: \
                  generated code, whose accuracy does not depend on length.",
        x: "number of bodies",
        y: "relative error; 1: all digits are lost",
        series: METHODS.iter().enumerate().map(series).collect(),
    }
}
