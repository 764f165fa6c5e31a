//! What the numbers mean, in plain words, and where each comes from.

use crate::description::Description;
use crate::evaluation::Errors;
use crate::motion::{Motion, Step};
use crate::statistics::{Spread, digits};

/// A truncation beyond this, in rad or of the chain's size, is that of a step too long.
const TOO_LONG: f64 = 1e-2;

/// One cause outweighs another that is less than a third of it.
const OUTWEIGHS: f64 = 3.0;

/// Differences below this, in rad or of the chain's size, are those that f64 has from itself.
const NOTHING: f64 = f64::EPSILON;

/// In sentences.
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
        false => "Digits are −log₁₀ of the error by the largest of a state; f32 itself has 7.2, \
                  −log₁₀ of half its last place."
            .to_owned(),
    });
    if errors.refused > 0 {
        said.push(format!(
            "f32 refuses {} of the states, which f64 solves: there it is of no use.",
            errors.refused
        ));
    }
    match motion {
        Some(motion) => said.extend(of_motion(motion, description)),
        None => said.push("All motions are told, so there is none to compare.".to_owned()),
    }
    said
}

/// The digits of one kind of results.
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
            "Even f64 stops after {:.3} s ({}): take a shorter step.",
            stop.after, stop.why
        ));
        return said;
    }
    if let Some(stop) = &motion.stopped_single {
        said.push(format!("f32 stops after {:.3} s: {}.", stop.after, stop.why));
    }
    match motion.parted {
        Some(at) => said.push(format!(
            "The motions in f32 and f64 are two different ones from {at:.3} s on, where they are \
             0.01\u{a0}rad or 1\u{a0}% of the chain's size apart{}.",
            if motion.steps.is_empty() { "" } else { "; up to there the steps are compared" },
        )),
        None => said.extend(motion.differences.last().map(|last| {
            format!(
                "Within {:.3} s the motion in f32 leaves that in f64 by {}.",
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
            true => ("it would be", ", as the fourth power of the step tells from those tried"),
            false => ("it is", ", between two of those tried"),
        };
        format!(
            "Steps below about {:.0e} s make f32 no better: {how} there that the truncation of the \
             step falls below the rounding{but}.",
            balance.step
        )
    }));
    said
}

/// How far, of the kinds that the chain has.
fn ways(turn: f64, shift: f64, description: &Description) -> String {
    let turns = description.groups().any(|group| group.turns);
    let shifts = description.groups().any(|group| !group.turns);
    let parts = [(turns, turn, "rad"), (shifts, shift, "m")];
    let parts = parts.into_iter().filter(|(has, ..)| *has);
    let parts: Vec<String> = parts.map(|(_, way, unit)| format!("{way:.1e} {unit}")).collect();
    parts.join(" and ")
}

/// What rounding comes from.
fn causes(step: &Step) -> Option<String> {
    let (state, rates) = (step.of_state?, step.of_rates?);
    if state.max(rates) < NOTHING {
        return Some("Nothing but the rounding of f64 tells both motions apart.".to_owned());
    }
    let cause = if state > OUTWEIGHS * rates {
        "nearly all of it comes from the state, which each step rounds: longer steps, or a state \
         kept in f64, help"
    } else if rates > OUTWEIGHS * state {
        "nearly all of it comes from the rates, which the model computes in f32: only computing \
         them in f64 helps"
    } else {
        "the rounding of the state in each step and that inside the model weigh alike"
    };
    Some(format!(
        "Of what rounding changes in steps of {:.1e} s, {cause} ({state:.1e} with the state alone \
         in f32, {rates:.1e} with the rates alone).",
        step.step
    ))
}

/// Whether the step asked for suits the chain.
fn length(step: &Step) -> Option<String> {
    let truncation = step.truncation?;
    (truncation > TOO_LONG).then(|| {
        format!(
            "Steps of {:.1e} s are too long for this chain in any precision: the truncation is \
             {truncation:.1e} rad or of its size.",
            step.step
        )
    })
}
