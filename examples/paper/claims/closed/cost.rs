//! The cost of closing a chain: "the difficulty and computational scale will not increase distinctly
//! compared with the corresponding chain system" [P, section 2.4].

use std::f64::consts::PI;
use std::hint::black_box;

use mstmm::prelude::*;
use mstmm::{Error, GeneratedChain};

use super::comparison::SECTION;
use crate::output::drawing::{Canvas, Drawing, FROM_LEFT, Point};
use crate::output::progress::Progress;
use crate::output::result_table::{ResultTable, Row};
use crate::power_law;
use crate::section::{Measurement, SectionResult};
use crate::timing::{BATCHES, Evaluation, Generated, fastest};

/// The angle of the rods of a zigzag against the line between its ends, in rad.
const TILT: f64 = 0.5;

/// The time of one evaluation in s, for an open and a closed chain.
struct Cost {
    rods: f64,
    open: f64,
    closed: f64,
}

macro_rules! rods {
    ($($open:ident $closed:ident $count:tt)*) => {
        mstmm_chain! { $(
            plane chain $open {
                gravity = [0, -9.8] m/s^2;
                body Rod { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 1/12 kg*m^2 about com; }
                ground -> repeat $count { pin joint -> Rod rod };
            }
            plane chain $closed {
                gravity = [0, -9.8] m/s^2;
                body Rod { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 1/12 kg*m^2 about com; }
                ground -> repeat $count { pin joint -> Rod rod } -> pin last
                       -> ground at [$count * cos(TILT), 0] m;
            }
        )* }

        fn costs(progress: &Progress) -> Result<Vec<Cost>, Error> {
            Ok(vec![$({
                progress.begin(concat!("closed: cost, ", $count, " rods"));
                cost(&$open::new(), &$closed::new(), $count)?
            }),*])
        }

        /// The number of lengths that are timed.
        pub const LENGTHS: usize = [$($count),*].len();
    };
}

rods! {
    Open4 Closed4 4
    Open10 Closed10 10
    Open30 Closed30 30
    Open100 Closed100 100
    Open300 Closed300 300
}

pub fn run(progress: &Progress) -> Result<SectionResult, Error> {
    let costs = costs(progress)?;
    let row = |name: &str, value: fn(&Cost) -> f64| {
        let points: Vec<_> = costs.iter().map(|cost| (cost.rods, value(cost))).collect();
        let exponent = power_law::exponent(&points);
        let values = points.into_iter().map(|(_, value)| value).chain([exponent]);
        Row { name: name.into(), values: values.collect() }
    };
    let columns = costs.iter().map(|cost| format!("{} rods", cost.rods));
    let table = ResultTable {
        section: SECTION,
        title: "time for one evaluation of all accelerations of rods on pins in s",
        columns: columns.chain(["exponent".into()]).collect(),
        rows: vec![
            row("held at one end", |cost| cost.open),
            row("held at both ends", |cost| cost.closed),
            Row {
                name: "ratio".into(),
                values: costs.iter().map(|cost| cost.closed / cost.open).collect(),
            },
        ],
        note: "Closing a chain adds columns for the reactions at the closing hinge, and a small system of \
               equations at the end of the chain. All times were measured in this run, on this machine.",
        verdicts: Vec::new(),
    };
    let ratios = costs.first().zip(costs.last()).map(|(short, long)| {
        let ratio = |cost: &Cost| format!("{:.2} for {} rods", cost.closed / cost.open, cost.rods);
        format!(
            "time of a closed chain over that of an open one: {}, {}",
            ratio(short),
            ratio(long)
        )
    });
    let measurements = ratios.map(|text| Measurement { text, figure: None });
    Ok(SectionResult {
        drawings: vec![drawing()],
        tables: vec![table],
        measurements: measurements.into_iter().collect(),
        ..SectionResult::default()
    })
}

/// Times open and closed zigzags of `count` rods at rest.
fn cost<A, B>(open: &A, closed: &B, count: usize) -> Result<Cost, Error>
where
    A: GeneratedChain<Scalar = f64>,
    B: GeneratedChain<Scalar = f64>,
{
    let joints = |k: usize| match k {
        0 => TILT,
        _ if k == count => TILT,
        _ if k.is_multiple_of(2) => 2.0 * TILT,
        _ => -2.0 * TILT,
    };
    let angles: Vec<f64> = (0..=count).map(joints).collect();
    let rates = vec![0.0; count + 1];
    let mut open = Generated::new(open, &angles[..count], &rates[..count]);
    let mut closed = Generated::new(closed, &angles, &rates);
    open.evaluate()?;
    closed.evaluate()?;
    let mut evaluations: [Evaluation; 2] = [
        Box::new(|| {
            let _ = black_box(open.evaluate());
        }),
        Box::new(|| {
            let _ = black_box(closed.evaluate());
        }),
    ];
    let seconds = fastest(&mut evaluations, BATCHES);
    Ok(Cost { rods: count as f64, open: seconds[0], closed: seconds[1] })
}

fn drawing() -> Drawing {
    const DRAWN: usize = 6;
    let mut canvas = Canvas::new([-0.6, 6.3], [-0.75, 1.3], 420.0);
    let point = |k: usize| -> Point {
        [k as f64 * TILT.cos(), if k.is_multiple_of(2) { 0.0 } else { TILT.sin() }]
    };
    let points: Vec<Point> = (0..=DRAWN).map(point).collect();
    canvas.support(points[0], FROM_LEFT);
    canvas.support(points[DRAWN], PI);
    points.windows(2).for_each(|ends| canvas.rod(ends[0], ends[1]));
    points.iter().for_each(|&point| canvas.pin(point));
    canvas.gravity([2.65, -0.1]);
    canvas.finish(
        "Closed chains, times: a zigzag of rods",
        "Rods of 1 m and 1 kg on pins, here six. The last pin is on the ground, or omitted in the open chain.",
    )
}
