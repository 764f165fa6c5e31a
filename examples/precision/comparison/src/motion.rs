//! The errors of single precision in a motion, and their causes: the motion is computed with the state
//! in either precision and the rates in either precision, with several step sizes.

use mstmm::{Energy, Error};
use serde::Serialize;

use crate::course::{COARSEST, Course, Instant, MotionError, Plan, course};
use crate::description::{Description, Settings};
use crate::sample::{Sampler, Start, single};
use crate::scales::Scales;
use crate::statistics::largest;
use crate::subject::Subject;

/// Beyond this difference, in rad or relative to the chain's size, the two motions have diverged:
/// differences are no longer the sum of their causes.
const PARTED: f64 = 1e-2;

/// Step sizes relative to the specified step.
const PARTS: [f64; 5] = [COARSEST as f64, 2.0, 1.0, 0.5, 0.25];

/// The number of rows in the table of differences.
const ROWS: usize = 5;

/// RK4 has order four: with half the step, a sixteenth of the error remains.
const HALVED: f64 = 16.0;

/// The results of a motion.
#[derive(Debug, Serialize)]
pub struct Motion {
    /// The duration in s.
    pub time: f64,
    /// The step in s, rounded to single precision.
    pub step: f64,
    /// The largest differences so far, at a few times.
    pub differences: Vec<Difference>,
    /// The largest change of the energy since the start, in J, computed in double precision.
    pub energy_double: f64,
    pub energy_single: f64,
    /// The largest kinetic energy in J.
    pub kinetic: f64,
    /// The position error of a closed chain: the change of its coordinates by `assemble`, in rad or
    /// relative to the chain's size.
    pub opened_double: Option<f64>,
    pub opened_single: Option<f64>,
    /// The time at which the motions diverge, in s.
    pub parted: Option<f64>,
    /// The time at which double and single precision stopped, in s, and the reason.
    pub stopped_double: Option<Stop>,
    pub stopped_single: Option<Stop>,
    /// Errors with several step sizes, until the motions diverge.
    pub steps: Vec<Step>,
    /// The end of this comparison, in s.
    pub steps_until: f64,
    /// The step at which truncation and rounding errors are equal, in s.
    pub balance: Option<Balance>,
}

/// A motion that stopped with an error.
#[derive(Debug, Serialize)]
pub struct Stop {
    pub after: f64,
    pub why: String,
}

/// The largest differences up to a time.
#[derive(Debug, Serialize)]
pub struct Difference {
    /// In s.
    pub time: f64,
    /// Of angles in rad, of translations in m, of any connection point and of the last one in m.
    pub turn: f64,
    pub shift: f64,
    pub point: f64,
    pub tip: f64,
}

/// Errors with one step size, in rad or relative to the chain's size; none if a motion stops.
#[derive(Debug, Serialize)]
pub struct Step {
    /// In s.
    pub step: f64,
    /// The truncation error in double precision.
    pub truncation: Option<f64>,
    /// The error of single precision: of state and rates, of only the state, of only the rates.
    pub rounding: Option<f64>,
    pub of_state: Option<f64>,
    pub of_rates: Option<f64>,
    /// The difference of single precision from double precision with the shortest step.
    pub single: Option<f64>,
}

/// The step at which truncation and rounding errors are equal.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Balance {
    /// The step in s.
    pub step: f64,
    /// Whether it is extrapolated from the steps tried, by the fourth power of the step.
    pub extrapolated: bool,
}

/// Simulates the chain in both precisions from the start.
pub fn motion<D, S>(
    (double, in_single): (&D, &S),
    (description, start): (&Description, &Start),
    scales: Scales,
    settings: &Settings,
) -> Result<Motion, Error>
where
    D: Subject<Scalar = f64>,
    S: Subject<Scalar = f32>,
{
    let first = Sampler::new((description, start), scales, settings).begin(double)?;
    let mut state = double.initial_state();
    first.write(&mut state);
    let from = (&state, first.inputs.as_slice());
    let plan = Plan::new(settings.time, single(settings.step));
    let apart = |a: &Course, b: &Course| -> Vec<MotionError> {
        let each = a.instants.iter().zip(&b.instants);
        let so_far = each.scan(MotionError::default(), |so_far, (a, b)| {
            *so_far = so_far.or(MotionError::of(a, b, description));
            Some(*so_far)
        });
        so_far.collect()
    };
    let base = course((double, double, double), from, plan, 1.0);
    let other = course((in_single, in_single, double), from, plan, 1.0);
    let differences = apart(&base, &other);
    let size = scales.length;
    let parted = differences.iter().position(|apart| apart.scaled(size) > PARTED);
    let together = parted.unwrap_or(differences.len()).saturating_sub(1);

    let until = plan.until(together);
    let runs: Vec<[Course; 4]> = if together == 0 { &[][..] } else { &PARTS[..] }
        .iter()
        .map(|&part| {
            [
                course((double, double, double), from, until, part),
                course((in_single, in_single, double), from, until, part),
                course((in_single, double, double), from, until, part),
                course((double, in_single, double), from, until, part),
            ]
        })
        .collect();
    let between = |a: &Course, b: &Course| {
        let whole = a.stopped.is_none() && b.stopped.is_none();
        let last = apart(a, b).last().map(|apart| apart.scaled(size));
        last.filter(|error| whole && error.is_finite())
    };
    let steps: Vec<Step> = (0..runs.len())
        .map(|number| {
            let [exact, both, state, rates] = &runs[number];
            let truncation = match runs.get(number + 1) {
                Some([finer, ..]) => between(exact, finer).map(|e| e * HALVED / (HALVED - 1.0)),
                None => between(&runs[number - 1][0], exact).map(|error| error / (HALVED - 1.0)),
            };
            Step {
                step: PARTS[number] * plan.step,
                truncation,
                rounding: between(exact, both),
                of_state: between(exact, state),
                of_rates: between(exact, rates),
                single: between(&runs[runs.len() - 1][0], both),
            }
        })
        .collect();
    Ok(Motion {
        time: plan.time(),
        step: plan.step,
        differences: rows(&base, &differences),
        energy_double: drift(&base),
        energy_single: drift(&other),
        kinetic: largest(base.instants.iter().map(|instant| instant.energy.kinetic)),
        opened_double: description.closed.then(|| opened(&base, description, size)),
        opened_single: description.closed.then(|| opened(&other, description, size)),
        parted: parted.map(|number| base.instants[number].time),
        stopped_double: stop(&base),
        stopped_single: stop(&other),
        balance: balance(&steps),
        steps,
        steps_until: until.time(),
    })
}

fn stop(course: &Course) -> Option<Stop> {
    let after = course.instants.last().map_or(0.0, |instant| instant.time);
    course.stopped.as_ref().map(|error| Stop { after, why: error.to_string() })
}

/// Returns a few of the differences, at times that about double.
fn rows(course: &Course, differences: &[MotionError]) -> Vec<Difference> {
    let last = differences.len().saturating_sub(1);
    let mut numbers: Vec<usize> = (0..ROWS).map(|halved| last >> halved).collect();
    numbers.dedup();
    let row = |number: usize| {
        let MotionError { turn, shift, point, tip } = differences[number];
        Difference { time: course.instants[number].time, turn, shift, point, tip }
    };
    numbers.into_iter().rev().filter(|&number| number > 0).map(row).collect()
}

/// Returns the largest change of the energy since the start.
fn drift(course: &Course) -> f64 {
    let total = |energy: &Energy<f64>| energy.total();
    let first = course.instants.first().map_or(0.0, |instant| total(&instant.energy));
    largest(course.instants.iter().map(|instant| (total(&instant.energy) - first).abs()))
}

/// Returns the change of the coordinates by closing a chain.
fn opened(course: &Course, description: &Description, size: f64) -> f64 {
    let way = |instant: &Instant| match &instant.closed {
        Some(closed) => MotionError::of_coordinates(&instant.q, closed, description).scaled(size),
        None => f64::INFINITY,
    };
    largest(course.instants.iter().map(way))
}

/// Returns the step at which the truncation error, which grows with the step, equals the rounding error.
fn balance(steps: &[Step]) -> Option<Balance> {
    let known: Vec<(f64, f64, f64)> = steps
        .iter()
        .filter_map(|step| Some((step.step, step.truncation?, step.rounding?)))
        .filter(|&(_, truncation, rounding)| truncation > 0.0 && rounding > 0.0)
        .collect();
    let met = known.windows(2).find_map(|pair| {
        let [(longer, a, b), (shorter, c, d)] = [pair[0], pair[1]];
        let (above, below) = ((a / b).ln(), (c / d).ln());
        let step = || longer * (shorter / longer).powf(above / (above - below));
        (above >= 0.0 && below < 0.0).then(|| Balance { step: step(), extrapolated: false })
    });
    let from = |&(step, truncation, rounding): &(f64, f64, f64)| Balance {
        step: step * (rounding / truncation).powf(0.25),
        extrapolated: true,
    };
    let (first, last) = (known.first()?, known.last()?);
    // Differences at the level of rounding in double precision are not truncation errors.
    let significant = |&(_, truncation, rounding): &(f64, f64, f64)| truncation > 1e-6 * rounding;
    met.or_else(|| (first.1 < first.2 && significant(first)).then(|| from(first)))
        .or_else(|| (last.1 >= last.2).then(|| from(last)))
}

#[cfg(test)]
mod tests {
    use super::{Step, balance};

    /// Returns the balance of steps whose truncation error is `truncation` times their fourth power.
    fn balanced(truncation: f64, rounding: f64) -> Option<(f64, bool)> {
        let step = |step: f64| Step {
            step,
            truncation: Some(truncation * step.powi(4)),
            rounding: Some(rounding),
            of_state: None,
            of_rates: None,
            single: None,
        };
        balance(&[0.4, 0.2, 0.1].map(step)).map(|found| (found.step, found.extrapolated))
    }

    #[test]
    fn truncation_and_rounding_balance_where_they_are_alike() {
        for (step, outside) in [(0.3, false), (0.13, false), (1.5, true), (0.02, true)] {
            let found = balanced(1.0, f64::powi(step, 4)).expect("a step");
            assert!((found.0 / step - 1.0).abs() < 1e-12 && found.1 == outside, "{found:?}");
        }
        assert_eq!(balanced(0.0, 1.0), None);
    }
}
