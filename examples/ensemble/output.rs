//! Output of the results, as text and as JSON.

use std::error::Error;

use mstmm_payloads::{STEP, STEPS, Summary};
use serde::Serialize;

use crate::Outcome;
use crate::run::{Run, count};

/// The mean and the range of 95 % of the values.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Spread {
    mean: f64,
    /// Half the width of the 95 % confidence interval of the mean.
    mean_error: f64,
    /// The 2.5 % and 97.5 % quantiles.
    low: f64,
    high: f64,
    largest: f64,
}

impl Spread {
    pub fn of(summary: Summary) -> Self {
        let Summary { mean, mean_error, quantiles: [low, _, high], largest } = summary;
        Self { mean, mean_error, low, high, largest }
    }

    fn in_millimetres(self) -> Self {
        let Self { mean, mean_error, low, high, largest } = self;
        let [mean, mean_error, low, high, largest] =
            [mean, mean_error, low, high, largest].map(|value| 1e3 * value);
        Self { mean, mean_error, low, high, largest }
    }
}

pub fn print(outcome: &Outcome, json: bool) -> Result<(), Box<dyn Error>> {
    if json {
        println!("{}", serde_json::to_string_pretty(outcome)?);
        return Ok(());
    }
    let Outcome { seed, .. } = outcome;
    println!(
        "{} Pandas with random payloads of 0.1 to 3 kg, whose controller assumes 1.5 kg;\n\
         each {:.3} s in {} steps of the classical Runge-Kutta method; seed {seed}\n",
        outcome.arms,
        STEP * f64::from(STEPS),
        STEPS,
    );
    print_paces(&outcome.runs);
    println!();
    print_spreads(outcome);
    Ok(())
}

fn print_paces(runs: &[Run]) {
    // One by one on one core.
    let slowest = runs.first().map_or(f64::NAN, |run| run.steps_per_second);
    println!("{:36}{:>9}{:>9}  steps a second", "", "arms", "time");
    for Run { number, lanes, cores, arms, seconds, steps_per_second } in runs {
        let way = match lanes {
            1 => format!("one by one, {number}, {}", count(*cores, "core")),
            _ => format!("{lanes} side by side, {number}, {}", count(*cores, "core")),
        };
        let (millions, times) = (steps_per_second / 1e6, steps_per_second / slowest);
        println!(
            "{way:36}{arms:9}{seconds:7.1} s  {millions:.3} million, {times:.2} times the first"
        );
    }
    println!("A step evaluates all accelerations four times.");
}

fn print_spreads(outcome: &Outcome) {
    println!("Final position of the flange, in mm");
    println!("{:36}{:>20}{:>20}{:>9}", "", "mean", "95 % of the arms", "largest");
    let row = |name: &str, spread: &Spread| {
        let Spread { mean, mean_error, low, high, largest } = spread.in_millimetres();
        let (mean, range) =
            (format!("{mean:.3} ± {mean_error:.3}"), format!("{low:.2} to {high:.2}"));
        println!("{name:36}{mean:>20}{range:>20}{largest:9.2}");
    };
    row("distance from its target", &outcome.distance);
    row("above it", &outcome.height);
    println!(
        "Half the step changes that by {:.1e} mm at most. The first {} have the same bits in\n\
         lanes and one by one.",
        1e3 * outcome.step_error,
        count(outcome.compared, "arm"),
    );
    println!("sha256 {}", outcome.sha256);
    if let Some(error) = outcome.single_error {
        println!("Single precision changes it by {:.1e} mm at most.", 1e3 * error);
    }
}
