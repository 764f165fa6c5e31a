//! What numbers that hang on parameters and constants must be at run time.

use crate::model::{Body, Chain, Friction, Hinge, Limits, Passive, RepeatId, Spring, Value};

/// A number that is known at run time only.
#[derive(Clone, Debug)]
pub struct Check {
    /// The number.
    pub value: Value,
    /// Whether zero is too little.
    pub positive: bool,
    /// What it must be, in words.
    pub reason: String,
    /// The repeated part that it belongs to.
    pub part: Option<RepeatId>,
}

/// All of them.
pub(super) fn of(chain: &Chain) -> Vec<Check> {
    let mut checks = Vec::new();
    for (index, body) in chain.bodies.enumerate() {
        let part = chain.repeat_of_body(index);
        let own = of_body(body).into_iter();
        checks.extend(own.map(|check| Check { part, ..check }));
    }
    for (index, hinge) in chain.hinges.enumerate() {
        let part = chain.repeat_of_hinge(index);
        checks.extend(of_hinge(hinge).into_iter().map(|check| Check { part, ..check }));
    }
    for spring in &chain.springs {
        let part = chain.repeat_of_body(spring.body);
        checks.extend(of_spring(spring).into_iter().map(|check| Check { part, ..check }));
    }
    // A loop over the times of a part writes to one slice of them.
    checks.sort_by_key(|check| check.part);
    checks
}

/// That no moment is more than the sum of the others is not asked for: parameters are set one by one,
/// and three moments could never be made larger then.
fn of_body(body: &Body) -> Vec<Check> {
    let reason = format!("must leave the mass of body `{}` positive", body.name);
    let mass = unknown(&body.mass, true, reason);
    let reason = format!("must leave the moments of inertia of body `{}` not negative", body.name);
    let moments = body.inertia.tensor[..3].iter();
    mass.into_iter().chain(moments.filter_map(|one| unknown(one, false, reason.clone()))).collect()
}

fn of_hinge(hinge: &Hinge) -> Vec<Check> {
    let mut checks: Vec<Check> = Vec::new();
    for Passive { stiffness, damping, armature, friction, limits } in &hinge.passive {
        let mut numbers = vec![
            ("stiffness", stiffness, false),
            ("damping", damping, false),
            ("armature", armature, false),
        ];
        if let Some(Friction { effort, speed }) = friction {
            numbers.extend([("friction", effort, false), ("friction speed", speed, true)]);
        }
        let width;
        if let Some(Limits { low, high, stiffness, damping }) = limits {
            width = high.clone().minus(low.clone());
            numbers.extend([
                ("limit stiffness", stiffness, true),
                ("limit damping", damping, false),
                ("width of the limits", &width, true),
            ]);
        }
        for (word, value, positive) in numbers {
            let adjective = if positive { "positive" } else { "not negative" };
            let reason = format!("must leave the {word} of hinge `{}` {adjective}", hinge.name);
            // The components of a ball's spring are one number.
            if checks.iter().all(|check| check.value != *value || check.reason != reason) {
                checks.extend(unknown(value, positive, reason));
            }
        }
    }
    checks
}

fn of_spring(spring: &Spring) -> Vec<Check> {
    let numbers = [
        ("stiffness", &spring.stiffness),
        ("damping", &spring.damping),
        ("length", &spring.length),
    ];
    let check = |(word, value): (&str, &Value)| {
        let reason = format!("must leave the {word} of spring `{}` not negative", spring.name);
        unknown(value, false, reason)
    };
    numbers.into_iter().filter_map(check).collect()
}

/// A check of a number, unless that is known.
fn unknown(value: &Value, positive: bool, reason: String) -> Option<Check> {
    value.known().is_none().then(|| Check { value: value.clone(), positive, reason, part: None })
}
