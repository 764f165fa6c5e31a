//! How far accelerations are off against the number of bodies: by the product of the paper's matrices
//! and by both methods of generated code, in double and in single precision.

use mstmm::prelude::*;
use mstmm::{Error, Scalar};
use nalgebra::Vector3;

use super::DIGITS;
use super::measure::{Cubes, accelerations, apart, bound, error};
use super::pose::Pose;
use super::product::Product;
use super::truth;
use crate::output::exhibit::{Exhibit, Row};
use crate::output::log_plot::{LogFigure, Series, Way};
use crate::output::progress::Progress;
use crate::section::Outcome;

/// States of each length, of which the worst one counts.
const SEEDS: u64 = 3;

/// The first two are the paper's, the others generated code.
const WAYS: [&str; 6] = [
    "product as printed, f64",
    "product as printed, f32",
    "transfer, f64",
    "transfer, f32",
    "riccati, f64",
    "riccati, f32",
];
/// The units in the last place of one, of both precisions.
const UNITS: [f64; 2] = [f64::EPSILON, f32::EPSILON as f64];

const SAYS: [&str; 7] = [
    "The product of the printed matrices loses nearly a digit for each body: in double precision",
    "none is left from 20 bodies on, in single precision from 10 on (1 and more: lost; –: not even a",
    "number). Generated code keeps 13 of 16 digits, and about 5 of 7, at every length, by both methods.",
    "It gets the hinges' coordinates rounded to its precision and has to compute poses and velocities,",
    "which the product is given. Its bound is the rounding of all operations of an evaluation, 1240 a",
    "body, as if each came out whole. The reference solves Newton's and Euler's equations of all bodies,",
    "written for it alone, in 160 binary digits; with 320 it changes as the last row says.",
];

/// The errors of chains of a length.
struct Length {
    count: usize,
    errors: [f64; WAYS.len()],
    /// How far the reference is from one with twice the digits.
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

/// The errors of one length, by all ways, in poses as a function makes them of length and seed.
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

        /// How many parts the progress counts.
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

pub fn run(progress: &Progress) -> Result<Outcome, Error> {
    let (balls, pins) = (of_balls(progress)?, of_pins(progress)?);
    let figure = figure(&balls);
    let exhibits = vec![
        exhibit("relative error of all accelerations, cubes on balls", &balls, SAYS.into()),
        exhibit(
            "relative error of all accelerations, cubes on parallel pins",
            &pins,
            vec![
                "Pins about one axis, which move in a plane, lose a little less, and in the same way.",
            ],
        ),
    ];
    Ok(Outcome { exhibits, log_figures: vec![figure], ..Outcome::default() })
}

/// The largest errors over all states of a length.
fn worst(
    count: usize,
    pose: impl Fn(usize, u64) -> Pose,
    ways: impl Fn(&Pose) -> Result<[Vec<f64>; WAYS.len()], Error>,
) -> Result<Length, Error> {
    // In the order of `total_cmp` not a number is the worst of all.
    let worse = |a: f64, b: f64| if a.total_cmp(&b).is_lt() { b } else { a };
    let mut worst = Length { count, errors: [0.0; WAYS.len()], of_reference: 0.0 };
    for seed in 0..SEEDS {
        let pose = pose(count, seed);
        let truth = truth::accelerations(&pose, DIGITS)?;
        let better = truth::accelerations(&pose, 2 * DIGITS)?;
        worst.of_reference = worse(worst.of_reference, apart(&truth, &better));
        for (largest, found) in worst.errors.iter_mut().zip(ways(&pose)?) {
            *largest = worse(*largest, error(&found, &truth));
        }
    }
    Ok(worst)
}

fn exhibit(title: &'static str, lengths: &[Length], says: Vec<&'static str>) -> Exhibit {
    let row = |name: &str, value: &dyn Fn(&Length) -> f64| Row {
        name: name.to_owned(),
        values: lengths.iter().map(value).collect(),
    };
    let mut rows: Vec<Row> =
        (0..WAYS.len()).map(|way| row(WAYS[way], &|length| length.errors[way])).collect();
    rows.push(row("bound for generated code, f64", &|length| bound(length.count, UNITS[0])));
    rows.push(row("bound for generated code, f32", &|length| bound(length.count, UNITS[1])));
    rows.push(row("reference, 160 to 320 binary digits", &|length| length.of_reference));
    Exhibit {
        section: "Limits",
        title,
        columns: lengths.iter().map(|length| format!("n = {}", length.count)).collect(),
        rows,
        says,
        differences: Vec::new(),
        faults: faults(title, lengths),
    }
}

/// What does not come out as it must.
fn faults(title: &str, lengths: &[Length]) -> Vec<String> {
    let mut faults = Vec::new();
    for Length { count, errors, of_reference } in lengths {
        for way in 2..WAYS.len() {
            let (error, bound) = (errors[way], bound(*count, UNITS[way % 2]));
            // Written so that what is not a number is a fault too.
            let holds = error <= bound;
            if !holds {
                faults.push(format!(
                    "{title}: {}, n = {count}, is {error:.1e}, more than {bound:.1e}",
                    WAYS[way]
                ));
            }
        }
        // Far below what any way is measured to.
        let holds = *of_reference <= 1e-30;
        if !holds {
            faults.push(format!("{title}: the reference, n = {count}, is {of_reference:.1e} off"));
        }
    }
    faults
}

fn figure(lengths: &[Length]) -> LogFigure {
    // Above one, or where something is not a number, there is no digit left.
    let point = |way: usize, length: &Length| (length.count as f64, length.errors[way].min(1.0));
    let series = |(way, label): (usize, &&'static str)| Series {
        label,
        way: if way < 2 { Way::Rival } else { Way::Method },
        points: lengths.iter().map(|length| point(way, length)).collect(),
    };
    LogFigure {
        file_name: "accuracy.svg",
        title: "Relative error of all accelerations, cubes on balls",
        says: "Crosses are the product of the paper's matrices as they are printed, which loses nearly a \
               digit for each body; at 1 all are lost, and the error may be larger than that. Lines are \
               generated code: neither method loses accuracy with length.",
        x: "number of bodies",
        y: "relative error; 1: all digits are lost",
        series: WAYS.iter().enumerate().map(series).collect(),
    }
}
