//! An integrator of order twelve: the modified midpoint rule, extrapolated to a step of zero.
//!
//! The method needs no table of coefficients, in which an error could hide, and is accurate enough for
//! pendulums that amplify every error.

use nalgebra::DVector;

/// The numbers of substeps of the midpoint rule; each adds two orders.
const SUBSTEPS: [usize; 6] = [2, 4, 6, 8, 10, 12];

/// Returns the values of `y' = rate(y)` after `step`, and an estimate of their largest error. The error
/// is relative for values above one, and infinite if the step is far too long.
pub(crate) fn extrapolated_step(
    rate: &impl Fn(&DVector<f64>) -> DVector<f64>,
    start: &DVector<f64>,
    step: f64,
) -> (DVector<f64>, f64) {
    let start_rate = rate(start);
    // One row of Neville's scheme: values of rising order, from the first k numbers of substeps.
    let mut row: Vec<DVector<f64>> = Vec::new();
    for (k, &substeps) in SUBSTEPS.iter().enumerate() {
        let mut next = vec![midpoint_rule(rate, start, &start_rate, step, substeps)];
        for (order, previous) in row.iter().enumerate() {
            let ratio = substeps as f64 / SUBSTEPS[k - 1 - order] as f64;
            let refined = &next[order] + (&next[order] - previous) / (ratio * ratio - 1.0);
            next.push(refined);
        }
        row = next;
    }
    let (best, second) = (&row[SUBSTEPS.len() - 1], &row[SUBSTEPS.len() - 2]);
    if best.iter().any(|value| !value.is_finite()) {
        return (best.clone(), f64::INFINITY);
    }
    let relative = |(a, b): (&f64, &f64)| (a - b).abs() / a.abs().max(1.0);
    let error = best.iter().zip(second.iter()).map(relative).fold(0.0, f64::max);
    (best.clone(), error)
}

/// Returns the factor for the next step with which its error meets `tolerance`.
pub(crate) fn step_factor(error: f64, tolerance: f64) -> f64 {
    let exponent = 1.0 / (2 * SUBSTEPS.len() - 1) as f64;
    (0.9 * (tolerance / error).powf(exponent)).clamp(0.2, 2.0)
}

/// Applies the modified midpoint rule, whose error has only even powers of the step.
fn midpoint_rule(
    rate: &impl Fn(&DVector<f64>) -> DVector<f64>,
    start: &DVector<f64>,
    start_rate: &DVector<f64>,
    step: f64,
    substeps: usize,
) -> DVector<f64> {
    let h = step / substeps as f64;
    let mut behind = start.clone();
    let mut here = start + start_rate * h;
    for _ in 1..substeps {
        let ahead = &behind + rate(&here) * (2.0 * h);
        behind = std::mem::replace(&mut here, ahead);
    }
    here
}
