//! What closing a chain costs: "the difficulty and computational scale will not increase distinctly
//! compared with the corresponding chain system" [P, section 2.4].

use std::hint::black_box;

use mstmm::prelude::*;
use mstmm::{Error, GeneratedChain};

use super::beside::SECTION;
use crate::output::exhibit::{Exhibit, Row};
use crate::output::progress::Progress;
use crate::power_law;
use crate::timing::{BATCHES, Evaluation, Generated, fastest};

/// Every second rod is turned up by this and every other one down, so that both ends are level.
const TILT: f64 = 0.5;

/// What an evaluation takes in s.
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

        /// How many lengths are timed.
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

pub fn exhibit(progress: &Progress) -> Result<Exhibit, Error> {
    let costs = costs(progress)?;
    let row = |name: &str, value: fn(&Cost) -> f64| {
        let points: Vec<_> = costs.iter().map(|cost| (cost.rods, value(cost))).collect();
        let exponent = power_law::exponent(&points);
        let values = points.into_iter().map(|(_, value)| value).chain([exponent]);
        Row { name: name.into(), values: values.collect() }
    };
    let columns = costs.iter().map(|cost| format!("{} rods", cost.rods));
    Ok(Exhibit {
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
        says: vec![
            "Closing a chain adds columns for its closing reactions on the way and a small system at the",
            "end. That is felt in short chains; in long ones little of it is left.",
        ],
        differences: Vec::new(),
        faults: Vec::new(),
    })
}

/// Times a length of a zigzag at rest.
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
    let mut ways: [Evaluation; 2] = [
        Box::new(|| {
            let _ = black_box(open.evaluate());
        }),
        Box::new(|| {
            let _ = black_box(closed.evaluate());
        }),
    ];
    let seconds = fastest(&mut ways, BATCHES);
    Ok(Cost { rods: count as f64, open: seconds[0], closed: seconds[1] })
}
