//! Springs too stiff for the step.

use mstmm::Error;

use super::methods;
use super::{Cubes, SECTION, reference};
use crate::output::exhibit::{Exhibit, Row};
use crate::output::progress::Progress;

/// In N m/rad; the fastest oscillation takes about a millisecond.
const STIFFNESS: f64 = 1e6;
/// There are 2^k steps for these k.
const EXPONENTS: [u32; 5] = [6, 8, 10, 12, 14];
const TOLERANCE: f64 = 1e-11;

pub fn exhibit(progress: &Progress) -> Result<Exhibit, Error> {
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
    Ok(Exhibit {
        section: SECTION,
        title: "the same errors with springs of 1e6 N m/rad",
        columns: EXPONENTS.iter().map(|exponent| format!("h = 2^-{exponent} s")).collect(),
        rows,
        says: vec![
            "A dash: the motion grew beyond all bounds. The linearly implicit method alone bears steps",
            "longer than the springs' oscillations; what is left of its error are these, which it damps",
            "away.",
        ],
        differences: Vec::new(),
        faults: Vec::new(),
    })
}
