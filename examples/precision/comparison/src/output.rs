//! The tables.

use std::fmt::{Display, Write};

use crate::Report;
use crate::description::Description;
use crate::evaluation::Errors;
use crate::motion::Motion;
use crate::sample::DISTRIBUTION;
use crate::statistics::Spread;

/// For people.
pub fn text(report: &Report, description: &Description) -> String {
    let mut text = Text::default();
    let Report { chain, seed, scales, .. } = report;
    let inputs = if report.random_inputs { "random" } else { "zero" };
    text.line(format_args!(
        "{chain}: f32 beside f64, {} random states, seed {seed}, inputs {inputs}",
        report.states_asked
    ));
    text.line("");
    text.line(format_args!(
        "Its size is {:.3e} m, its pace {:.3e} rad/s, forces inside are {:.1e} N, moments {:.1e} N m.",
        scales.length, scales.rate, scales.force, scales.moment
    ));
    if report.start_drawn {
        text.line("It cannot be closed from the start described, so one is taken that was drawn.");
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

/// How long lines are.
const WIDTH: usize = 98;

impl Text {
    fn line(&mut self, line: impl Display) {
        // A string takes everything.
        let _ = writeln!(self.0, "{line}");
    }

    /// A sentence behind a dash.
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
            ("accelerations, by the largest", errors.accelerations),
            ("accelerations, each by itself", errors.each_acceleration),
            ("forces at connection points, by the largest", errors.forces),
            ("moments at connection points, by the largest", errors.moments),
            ("accelerations in f64, but the state rounded to f32", errors.state),
        ] {
            if let Some(Spread { median, most, worst }) = spread {
                self.line(format_args!("{what:58}{median:10.1e}{most:10.1e}{worst:10.1e}"));
            }
        }
        if let Some(name) = &errors.worst_acceleration {
            self.line(format_args!("The worst single acceleration is that of {name}."));
        }
        for (count, what) in [
            (errors.not_closed, "could not be closed, so others were drawn"),
            (errors.singular, "are singular in f64, so others were drawn"),
            (errors.refused, "are refused by f32 alone"),
        ] {
            if count > 0 {
                self.line(format_args!("Of the states {count} {what}."));
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
        let has = |turns: bool| description.groups().any(|group| group.turns == turns);
        for row in &motion.differences {
            self.line(format_args!(
                "{:28}{:>12}{:>12}{:10.1e} m{:>12}",
                format!("largest until {:.3} s", row.time),
                shown(has(true), row.turn, "rad"),
                shown(has(false), row.shift, "m"),
                row.point,
                // That of a closed chain is on the ground.
                shown(!description.closed, row.tip, "m"),
            ));
        }
        let what = if description.conservative { "drift" } else { "change by what acts" };
        self.line(format_args!(
            "energy {what}: f64 {:.1e} J, f32 {:.1e} J; largest kinetic energy {:.1e} J",
            motion.energy_double, motion.energy_single, motion.kinetic
        ));
        if let (Some(double), Some(single)) = (motion.opened_double, motion.opened_single) {
            self.line(format_args!(
                "open by: f64 {double:.1e}, f32 {single:.1e}, in rad or of the chain's size"
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
            "of state alone",
            "of rates alone",
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
        self.line("In rad, or of the chain's size.");
    }
}
