//! The tables of results.

use std::fmt::{Display, Write};

use crate::Report;
use crate::description::Description;
use crate::evaluation::Errors;
use crate::motion::Motion;
use crate::sample::DISTRIBUTION;
use crate::statistics::Spread;

/// Returns the results as text.
pub fn text(report: &Report, description: &Description) -> String {
    let mut text = Text::default();
    let Report { chain, seed, scales, .. } = report;
    let inputs = if report.random_inputs { "random" } else { "zero" };
    text.line(format_args!(
        "{chain}: f32 compared with f64, {} random states, seed {seed}, inputs {inputs}",
        report.states_asked
    ));
    text.line("");
    text.line(format_args!(
        "Characteristic length {:.3e} m, rate {:.3e} rad/s, internal force {:.1e} N, moment {:.1e} N m.",
        scales.length, scales.rate, scales.force, scales.moment
    ));
    if report.start_drawn {
        text.line("The chain cannot be closed from its start; a random start is used instead.");
    }
    text.line(DISTRIBUTION[usize::from(description.closed)]);
    text.errors(&report.errors);
    if let Some(motion) = &report.motion {
        text.motion(motion, description);
        text.steps(motion);
    }
    text.line("");
    text.line("Verdict");
    for sentence in &report.verdict {
        text.wrapped(sentence);
    }
    text.0
}

/// The lines so far.
#[derive(Default)]
struct Text(String);

/// The width of a line.
const WIDTH: usize = 98;

impl Text {
    fn line(&mut self, line: impl Display) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.0, "{line}");
    }

    /// Adds a sentence after a dash.
    fn wrapped(&mut self, sentence: &str) {
        let mut line = String::from("-");
        for word in sentence.split(' ') {
            if line.chars().count() + 1 + word.chars().count() > WIDTH {
                self.line(&line);
                line = String::from(" ");
            }
            line.push(' ');
            line.push_str(word);
        }
        self.line(line);
    }

    fn errors(&mut self, errors: &Errors) {
        self.line("");
        self.line(format_args!(
            "{:58}{:>10}{:>10}{:>10}",
            format!("Relative errors of f32 in {} states", errors.states),
            "median",
            "99 %",
            "worst"
        ));
        for (what, spread) in [
            ("accelerations, relative to the largest", errors.accelerations),
            ("accelerations, each relative to itself", errors.each_acceleration),
            ("forces, relative to the largest", errors.forces),
            ("moments, relative to the largest", errors.moments),
            ("accelerations in f64, state rounded to f32", errors.state),
        ] {
            if let Some(Spread { median, most, worst }) = spread {
                self.line(format_args!("{what:58}{median:10.1e}{most:10.1e}{worst:10.1e}"));
            }
        }
        if let Some(name) = &errors.worst_acceleration {
            self.line(format_args!(
                "The acceleration with the largest relative error is that of {name}."
            ));
        }
        for (count, what) in [
            (errors.not_closed, "could not be closed and were replaced"),
            (errors.singular, "are singular in f64 and were replaced"),
            (errors.refused, "fail only in f32"),
        ] {
            if count > 0 {
                self.line(format_args!("{count} states {what}."));
            }
        }
    }

    fn motion(&mut self, motion: &Motion, description: &Description) {
        self.line("");
        self.line(format_args!(
            "{:28}{:>12}{:>12}{:>12}{:>12}",
            format!("Motion, steps of {:.3e} s", motion.step),
            "turns",
            "shifts",
            "any point",
            "tip"
        ));
        let shown = |is: bool, way: f64, unit: &str| match is {
            true => format!("{way:.1e} {unit}"),
            false => "–".to_owned(),
        };
        let has =
            |rotational: bool| description.groups().any(|group| group.rotational == rotational);
        for row in &motion.differences {
            self.line(format_args!(
                "{:28}{:>12}{:>12}{:10.1e} m{:>12}",
                format!("largest until {:.3} s", row.time),
                shown(has(true), row.turn, "rad"),
                shown(has(false), row.shift, "m"),
                row.point,
                // The last point of a closed chain is on the ground.
                shown(!description.closed, row.tip, "m"),
            ));
        }
        let what = if description.conservative { "drift" } else { "change by efforts and loads" };
        self.line(format_args!(
            "energy {what}: f64 {:.1e} J, f32 {:.1e} J; largest kinetic energy {:.1e} J",
            motion.energy_double, motion.energy_single, motion.kinetic
        ));
        if let (Some(double), Some(single)) = (motion.opened_double, motion.opened_single) {
            self.line(format_args!(
                "position error of the loop: f64 {double:.1e}, f32 {single:.1e}, in rad or relative to the size"
            ));
        }
    }

    fn steps(&mut self, motion: &Motion) {
        if motion.steps.is_empty() {
            return;
        }
        self.line("");
        self.line(format_args!(
            "{:22}{:>12}{:>12}{:>16}{:>16}{:>14}",
            format!("Until {:.3} s", motion.steps_until),
            "truncation",
            "rounding",
            "of the state",
            "of the rates",
            "error of f32"
        ));
        let number = |number: Option<f64>| match number {
            Some(number) => format!("{number:.1e}"),
            None => "stops".to_owned(),
        };
        for step in &motion.steps {
            self.line(format_args!(
                "{:22}{:>12}{:>12}{:>16}{:>16}{:>14}",
                format!("steps of {:.3e} s", step.step),
                number(step.truncation),
                number(step.rounding),
                number(step.of_state),
                number(step.of_rates),
                number(step.single),
            ));
        }
        self.line("In rad, or relative to the chain's size.");
    }
}
