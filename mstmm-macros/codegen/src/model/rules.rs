//! Rules on the values of bodies, springs and hinges. The compiler checks known values, `rustc`
//! those that depend on Rust constants, and setters those that depend on parameters.

use std::f64::consts::{FRAC_PI_2, PI};

use super::condition::{Bound, Condition};
use super::length::{self, BOUNDS};
use super::lower::FieldNames;
use super::{
    Body, Chain, DofGroup, Hinge, Limits, Passive, RepeatId, Representation, Spring, Value,
};
use crate::diag::SpanRange;

/// A rule on a value.
pub(super) struct ValueRule {
    /// The bound that it must satisfy.
    pub must: Bound,
    /// The compiler's message for a value that breaks the rule.
    message: &'static str,
    /// The unit with which the compiler shows a value that depends on parameters.
    unit: Option<&'static str>,
    /// The name of the value in the errors of setters.
    called: &'static str,
}

pub(super) const MASS: ValueRule =
    ValueRule { unit: Some("kg"), ..positive("a mass must be positive", "mass") };
pub(super) const MOMENT: ValueRule = ValueRule {
    unit: Some("kg*m^2"),
    ..not_negative("a moment of inertia cannot be negative", "moments of inertia")
};
pub(super) const STIFFNESS: ValueRule = not_negative("a stiffness cannot be negative", "stiffness");
pub(super) const DAMPING: ValueRule = not_negative("a damping cannot be negative", "damping");
pub(super) const LENGTH: ValueRule = not_negative("a length cannot be negative", "length");
pub(super) const WIDTH: ValueRule = ValueRule {
    unit: None,
    ..positive("the first limit must be less than the second", "width of the limits")
};
pub(super) const LARGEST_ANGLE: ValueRule =
    ValueRule { message: "the largest angle must be positive", ..WIDTH };

const fn positive(message: &'static str, called: &'static str) -> ValueRule {
    ValueRule { must: Bound::BePositive, message, unit: Some(""), called }
}

const fn not_negative(message: &'static str, called: &'static str) -> ValueRule {
    ValueRule { must: Bound::NotBeNegative, message, unit: Some(""), called }
}

/// A rule on the springs, dampers, rotors, friction and limits of a hinge.
pub(super) struct PassiveRule {
    /// The rule.
    pub rule: ValueRule,
    /// The field of the value.
    pub field: fn(&FieldNames) -> &'static str,
    /// The value, if the hinge has one.
    pub number: fn(&Passive) -> Option<&Value>,
}

/// All passive rules except that on the width of limits, which has no field.
pub(super) const PASSIVE: &[PassiveRule] = &[
    PassiveRule {
        rule: STIFFNESS,
        field: |names| names.stiffness,
        number: |passive| Some(&passive.stiffness),
    },
    PassiveRule {
        rule: DAMPING,
        field: |names| names.damping,
        number: |passive| Some(&passive.damping),
    },
    PassiveRule {
        rule: not_negative("an armature cannot be negative", "armature"),
        field: |names| names.armature,
        number: |passive| Some(&passive.armature),
    },
    PassiveRule {
        rule: not_negative("friction cannot be negative", "friction"),
        field: |names| names.friction,
        number: |passive| Some(&passive.friction.as_ref()?.effort),
    },
    PassiveRule {
        // Friction divides by this speed.
        rule: positive("the friction speed must be positive", "friction speed"),
        field: |names| names.friction_speed,
        number: |passive| Some(&passive.friction.as_ref()?.speed),
    },
    PassiveRule {
        // Limits without stiffness have no effect.
        rule: positive("the limit stiffness must be positive", "limit stiffness"),
        field: |names| names.limit_stiffness,
        number: |passive| Some(&passive.limits.as_ref()?.stiffness),
    },
    PassiveRule {
        rule: not_negative("a damping cannot be negative", "limit damping"),
        field: |names| names.limit_damping,
        number: |passive| Some(&passive.limits.as_ref()?.damping),
    },
];

/// A check of a value that is known only at run time.
#[derive(Clone, Debug)]
pub struct Check {
    /// The value.
    pub value: Value,
    /// The bound, in addition to being finite.
    pub must: Bound,
    /// The bound in words.
    pub reason: String,
    /// The repeated part that it belongs to.
    pub part: Option<RepeatId>,
}

impl ValueRule {
    /// Returns the condition for a value at this span of the description.
    pub fn condition(&self, value: Value, at: SpanRange) -> Condition {
        Condition { shown: self.unit, ..Condition::new(value, self.must, at, self.message) }
    }

    /// Returns the check of a value of an owner, such as a body; `None` if the compiler has checked
    /// the value.
    fn check(&self, value: &Value, owner: &str) -> Option<Check> {
        let ValueRule { must, called, .. } = self;
        let adjective = match must {
            Bound::BeFinite => "finite",
            Bound::BePositive => "positive",
            Bound::NotBeNegative => "not negative",
        };
        Check::new(value.clone(), *must, format!("must leave the {called} of {owner} {adjective}"))
    }
}

impl Check {
    /// Returns the check of a value; `None` if the compiler has checked the value.
    fn new(value: Value, must: Bound, reason: String) -> Option<Self> {
        value.known().is_none().then_some(Check { value, must, reason, part: None })
    }
}

impl Limits {
    /// Returns the distance between the limits.
    pub(super) fn width(&self) -> Value {
        self.high.clone().minus(self.low.clone())
    }

    /// Returns the distance of the largest angle of a quaternion to 180°, which no angle exceeds.
    pub(super) fn to_half_turn(&self) -> Value {
        Value::number(PI).minus(self.high.clone())
    }
}

impl Chain {
    /// Returns the checks when parameters are set.
    pub fn checks(&self) -> Vec<Check> {
        let with_part =
            |part, checks: Vec<Check>| checks.into_iter().map(move |check| Check { part, ..check });
        let bodies = self.bodies.enumerate();
        let bodies =
            bodies.flat_map(|(id, body)| with_part(self.repeat_of_body(id), of_body(body)));
        let hinges = self.hinges.enumerate();
        let hinges =
            hinges.flat_map(|(id, hinge)| with_part(self.repeat_of_hinge(id), of_hinge(hinge)));
        let springs = self.springs.iter();
        let springs = springs
            .flat_map(|spring| with_part(self.repeat_of_body(spring.on.body), of_spring(spring)));
        let quaternions = self.quaternions.iter();
        let quaternions = quaternions.filter_map(|square| self.of_quaternion(square));
        let mut checks: Vec<Check> =
            bodies.chain(hinges).chain(springs).chain(quaternions).collect();
        // A loop over the repetitions of a part writes to one slice of checks.
        checks.sort_by_key(|check| check.part);
        checks
    }

    /// Returns the check of the squared length of a quaternion.
    fn of_quaternion(&self, square: &Value) -> Option<Check> {
        let mut repeated = self.parameters.ids().into_iter().filter(|&parameter| {
            self.parameters[parameter].repetitions.is_some() && square.uses(parameter)
        });
        let part = match repeated.next() {
            None => None,
            // A body that no route has may use a parameter of no part.
            Some(parameter) => Some(self.repeat_of_parameter(parameter)?),
        };
        Some(Check { part, ..of_length(square.clone(), "a quaternion")? })
    }
}

/// Returns the check of the squared length of an axis or a quaternion, which is normalised; `None` if the compiler has
/// checked it.
fn of_length(square: Value, of: &str) -> Option<Check> {
    let reason = format!("must leave the length of {of} {BOUNDS}");
    Check::new(length::margin(square), Bound::BePositive, reason)
}

/// Returns the checks of a body. The triangle inequality of the moments is not checked: parameters
/// are set one by one, so three moments could never be increased.
fn of_body(body: &Body) -> Vec<Check> {
    let owner = format!("body `{}`", body.name);
    let moments = body.inertia.tensor[..3].iter().filter_map(|moment| MOMENT.check(moment, &owner));
    MASS.check(&body.mass, &owner).into_iter().chain(moments).collect()
}

fn of_hinge(hinge: &Hinge) -> Vec<Check> {
    let owner = format!("hinge `{}`", hinge.name);
    let lengths = hinge.kind.axes().iter().map(|axis| length::squared(axis));
    let mut checks: Vec<Check> =
        lengths.filter_map(|square| of_length(square, &format!("the axis of {owner}"))).collect();
    checks.extend(hinge.kind.successive_axes().filter_map(|axes| {
        let reason = format!("must not leave successive axes of {owner} parallel");
        Check::new(length::sine_margin(axes), Bound::BePositive, reason)
    }));
    checks.extend(of_pitch(hinge, &owner));
    for (strain, passive) in hinge.passive.iter().enumerate() {
        let numbers = PASSIVE
            .iter()
            .filter_map(|PassiveRule { rule, number, .. }| rule.check(number(passive)?, &owner));
        let limits = passive.limits.iter();
        let limits = limits.flat_map(|limits| of_limits(limits, hinge, strain, &owner));
        for check in numbers.chain(limits) {
            // The components of a ball's spring are one value.
            let same =
                |other: &Check| (&other.value, &other.reason) == (&check.value, &check.reason);
            if !checks.iter().any(same) {
                checks.push(check);
            }
        }
    }
    checks
}

/// Returns the checks of the angles of an elastic hinge at its start and at rest, which are singular at a right angle.
fn of_pitch(hinge: &Hinge, owner: &str) -> Vec<Check> {
    let groups = hinge.kind.spec().groups.iter();
    let pitches = groups.filter_map(DofGroup::pitch).flat_map(|pitch| {
        [("start", &hinge.start), ("rest", &hinge.rest)]
            .map(|(of, angles)| (of, angles.get(pitch).cloned()))
    });
    let checks = pitches.flat_map(|(of, pitch)| {
        let reason =
            format!("must leave the pitch angle of the {of} of {owner} between -90 deg and 90 deg");
        let margins = pitch.map(|pitch| right_angle_margins(&pitch)).into_iter().flatten();
        margins.filter_map(move |margin| Check::new(margin, Bound::BePositive, reason.clone()))
    });
    checks.collect()
}

/// Returns two values that are positive if an angle is between −90° and 90°.
pub(super) fn right_angle_margins(angle: &Value) -> [Value; 2] {
    let right_angle = || Value::number(FRAC_PI_2);
    [right_angle().minus(angle.clone()), right_angle().plus(angle.clone())]
}

fn of_limits(limits: &Limits, hinge: &Hinge, strain: usize, owner: &str) -> Vec<Check> {
    let is_of_quaternion = |group: &DofGroup| {
        group.representation == Representation::Quaternion && group.rates.contains(&strain)
    };
    let half_turn = hinge.kind.spec().groups.iter().any(is_of_quaternion).then(|| {
        let reason = format!("must not leave the limits of {owner} above 180 deg");
        Check::new(limits.to_half_turn(), Bound::NotBeNegative, reason)
    });
    WIDTH.check(&limits.width(), owner).into_iter().chain(half_turn.flatten()).collect()
}

fn of_spring(spring: &Spring) -> Vec<Check> {
    let owner = format!("spring `{}`", spring.name);
    let numbers =
        [(STIFFNESS, &spring.stiffness), (DAMPING, &spring.damping), (LENGTH, &spring.length)];
    numbers.iter().filter_map(|(rule, value)| rule.check(value, &owner)).collect()
}
