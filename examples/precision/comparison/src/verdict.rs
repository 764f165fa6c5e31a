//! The verdict in plain words, with the causes of errors.

use crate::description::Description;
use crate::evaluation::Errors;
use crate::motion::{Motion, Step};
use crate::statistics::{Spread, digits};

/// With a truncation error beyond this, in rad or relative to the chain's size, the step is too long.
const TOO_LONG: f64 = 1e-2;

/// One cause dominates if its error is this many times that of the other.
const OUTWEIGHS: f64 = 3.0;

/// Differences below this, in rad or relative to the chain's size, are rounding errors of f64.
const NOTHING: f64 = f64::EPSILON;

/// Returns the verdict in sentences.
pub fn verdict(errors: &Errors, motion: Option<&Motion>, description: &Description) -> Vec<String> {
    let mut said: Vec<String> = [
        ("Accelerations", errors.accelerations),
        ("Forces", errors.forces),
        ("Moments", errors.moments),
    ]
    .into_iter()
    .filter_map(|(what, spread)| Some(kept(what, spread?)))
    .collect();
    said.push(match said.is_empty() {
        true => "No state could be compared.".to_owned(),
        false => {
            "Digits are −log₁₀ of the error relative to the largest value of a state; f32 itself \
                  has 7.2, −log₁₀ of half a unit in the last place."
                .to_owned()
        }
    });
    if errors.refused > 0 {
        said.push(format!(
            "{} of the states fail in f32 and not in f64: do not use f32 there.",
            errors.refused
        ));
    }
    match motion {
        Some(motion) => said.extend(of_motion(motion, description)),
        None => said.push("All motions are prescribed, so there is none to compare.".to_owned()),
    }
    said
}

/// Returns the sentence with the digits of one kind of results.
fn kept(what: &str, Spread { median, most, worst }: Spread) -> String {
    format!(
        "{what} keep {:.1} digits in half of the states, {:.1} in 99\u{a0}% of them, {:.1} in the \
         worst.",
        digits(median),
        digits(most),
        digits(worst),
    )
}

fn of_motion(motion: &Motion, description: &Description) -> Vec<String> {
    let mut said = Vec::new();
    if let Some(stop) = &motion.stopped_double {
        said.push(format!(
            "Even f64 stops after {:.3} s ({}): use a shorter step.",
            stop.after, stop.why
        ));
        return said;
    }
    if let Some(stop) = &motion.stopped_single {
        said.push(format!("f32 stops after {:.3} s: {}.", stop.after, stop.why));
    }
    match motion.parted {
        Some(at) => said.push(format!(
            "The motions in f32 and f64 diverge at {at:.3} s, where they differ by \
             0.01\u{a0}rad or 1\u{a0}% of the chain's size{}.",
            if motion.steps.is_empty() { "" } else { "; steps are compared up to this time" },
        )),
        None => said.extend(motion.differences.last().map(|last| {
            format!(
                "Within {:.3} s the motions in f32 and f64 differ by {}.",
                last.time,
                ways(last.turn, last.shift, description)
            )
        })),
    }
    let asked = motion.steps.iter().find(|step| step.step == motion.step);
    said.extend(asked.and_then(causes));
    said.extend(asked.and_then(length));
    said.extend(motion.balance.map(|balance| {
        let (how, but) = match balance.extrapolated {
            true => ("would be", ", extrapolated from the steps tried by the fourth power"),
            false => ("is", ", interpolated between two steps tried"),
        };
        format!(
            "Steps below about {:.0e} s do not make f32 more accurate: the truncation error {how} \
             smaller than the rounding error{but}.",
            balance.step
        )
    }));
    said
}

/// Returns the differences of rotations and translations, if the chain has them.
fn ways(turn: f64, shift: f64, description: &Description) -> String {
    let has_rotations = description.groups().any(|group| group.rotational);
    let has_translations = description.groups().any(|group| !group.rotational);
    let parts = [(has_rotations, turn, "rad"), (has_translations, shift, "m")];
    let parts = parts.into_iter().filter(|(has, ..)| *has);
    let parts: Vec<String> = parts.map(|(_, way, unit)| format!("{way:.1e} {unit}")).collect();
    parts.join(" and ")
}

/// Returns the sentence with the cause of the rounding error.
fn causes(step: &Step) -> Option<String> {
    let (state, rates) = (step.of_state?, step.of_rates?);
    if state.max(rates) < NOTHING {
        return Some("The motions differ only by rounding errors of f64.".to_owned());
    }
    let cause = if state > OUTWEIGHS * rates {
        "nearly all of it comes from the state, which each step rounds: use longer steps or a \
         state in f64"
    } else if rates > OUTWEIGHS * state {
        "nearly all of it comes from the rates, which the model computes in f32: compute them in \
         f64"
    } else {
        "the rounding of the state in each step and inside the model contribute equally"
    };
    Some(format!(
        "Of the rounding error with steps of {:.1e} s, {cause} ({state:.1e} with only the state in \
         f32, {rates:.1e} with only the rates in f32).",
        step.step
    ))
}

/// Returns a sentence if the specified step is too long for the chain.
fn length(step: &Step) -> Option<String> {
    let truncation = step.truncation?;
    (truncation > TOO_LONG).then(|| {
        format!(
            "Steps of {:.1e} s are too long for this chain in any precision: the truncation error is \
             {truncation:.1e} rad or relative to its size.",
            step.step
        )
    })
}
