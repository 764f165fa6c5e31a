//! The integrators with springs whose oscillations are shorter than most steps.

use mstmm::Error;

use super::methods;
use super::{Cubes, SECTION, reference};
use crate::output::progress::Progress;
use crate::output::result_table::{ResultTable, Row};

/// In N m/rad. The shortest period is about a millisecond.
const STIFFNESS: f64 = 1e6;
/// There are 2^k steps for these k.
const EXPONENTS: [u32; 5] = [6, 8, 10, 12, 14];
const TOLERANCE: f64 = 1e-11;

pub fn table(progress: &Progress) -> Result<ResultTable, Error> {
    let mut chain = Cubes::<f64>::new();
    chain.set_stiffness(STIFFNESS)?;
    progress.begin("integrators: stiff springs, reference");
    let exact = reference(&chain, TOLERANCE)?;
    let mut rows = Vec::new();
    for method in methods::ALL {
        progress.begin(&format!("integrators: stiff springs, {}", method.name));
        let errors = EXPONENTS.map(|exponent| method.run(&chain, &exact, exponent).error);
        rows.push(Row { name: method.name.into(), values: errors.to_vec() });
    }
    Ok(ResultTable {
        section: SECTION,
        title: "the same errors with springs of 1e6 N m/rad",
        columns: EXPONENTS.iter().map(|exponent| format!("h = 2^-{exponent} s")).collect(),
        rows,
        note: "The largest error of any coordinate or rate at t = 1 s in rad or rad/s. A dash: the motion diverged. \
               Only the linearly implicit Euler integrator remains stable with steps longer than the periods \
               of the springs; its error is that of their oscillations, which it damps.",
        verdicts: Vec::new(),
    })
}
