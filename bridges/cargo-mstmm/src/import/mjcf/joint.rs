//! The joints of a MuJoCo model.

use nalgebra::Vector3;
use std::f64::consts::PI;

use super::super::error::Result;
use super::super::frame::Frame;
use super::super::robot::{Joint, Kind, Limit, Note};
use super::attributes::{Attributes, BOOL_OR_AUTO};
use super::{Reader, WORLD};

impl Reader<'_> {
    /// Reads the joint between two links.
    pub(super) fn joint(
        &mut self,
        joint: &Attributes,
        body: &str,
        [parent, child]: [usize; 2],
        origin: Frame,
    ) -> Result<Joint> {
        let element = joint.element();
        let kind = kind(joint)?;
        if kind == Kind::Floating && parent != WORLD {
            return Err(element.error(
                "a free joint in a body of another body: MuJoCo has them only in bodies of the world",
            ));
        }
        for refused in ["ref", "stiffness", "springdamper"] {
            if joint.numbers_of(refused)?.iter().any(|number| *number != 0.0) {
                return Err(element.error(format!("`{refused}` of a joint is not read")));
            }
        }
        let axis = joint.vector("axis", [0.0, 0.0, 1.0])?;
        if axis == Vector3::zeros() {
            return Err(element.error("the axis is zero"));
        }
        let limit = self.limit(joint, kind)?;
        let kind = match (kind, limit.range) {
            (Kind::Continuous, Some(_)) => Kind::Revolute,
            (kind, _) => kind,
        };
        let name = element.name().map_or_else(|| format!("{body}_joint"), str::to_owned);
        let damping = self.damping(joint, &name)?;
        let friction = not_negative(joint, "frictionloss", joint.numbers("frictionloss")?)?;
        let armature = not_negative(joint, "armature", joint.numbers("armature")?)?;
        Ok(Joint {
            mimic: self.couples.get(&name).cloned(),
            name,
            place: element.place(),
            kind,
            parent,
            child,
            origin,
            axis,
            limit,
            damping,
            friction: if self.settings.friction { friction } else { 0.0 },
            armature,
        })
    }

    /// Returns the coefficient of the rate. Coefficients of higher powers give a warning.
    fn damping(&mut self, joint: &Attributes, name: &str) -> Result<f64> {
        let numbers = joint.numbers_of("damping")?;
        if numbers.len() > 3 {
            let count = numbers.len();
            let message = format!("`damping` has {count} numbers, and at most 3 are possible");
            return Err(joint.element().error(message));
        }
        let first = not_negative(joint, "damping", numbers.first().map(|first| [*first]))?;
        if !self.settings.dampers {
            return Ok(0.0);
        }
        if numbers.iter().skip(1).any(|other| *other != 0.0) {
            let text = format!(
                "joint `{name}` has damping by higher powers of the rate in the file, and only the linear damping \
                 {first} here"
            );
            self.robot.notes.push(Note::new(joint.element().place(), text));
        }
        Ok(first)
    }

    /// Returns the range of a joint, if it is limited. The range of a ball begins with zero.
    fn limit(&self, joint: &Attributes, kind: Kind) -> Result<Limit> {
        let efforts = joint.numbers::<2>("actuatorfrcrange")?.unwrap_or_default();
        let effort = efforts.iter().fold(0.0, |largest: f64, effort| largest.max(effort.abs()));
        let range = self.range(joint, kind)?;
        let range = match kind {
            Kind::Continuous => range.map(|range| range.map(|angle| self.compiler.angle(angle))),
            Kind::Prismatic => range,
            // A ball is never further than half a turn from rest.
            Kind::Ball => {
                let angles = range.map(|range| range.map(|angle| self.compiler.angle(angle)));
                angles.filter(|[_, high]| *high <= PI)
            }
            _ => None,
        };
        Ok(Limit { range: range.filter(|_| self.settings.limits), effort, velocity: 0.0 })
    }

    /// Returns the numbers of `range`, if they limit the joint.
    fn range(&self, joint: &Attributes, kind: Kind) -> Result<Option<[f64; 2]>> {
        let wrong = |message: String| Err(joint.element().error(message));
        let range = joint.numbers::<2>("range")?;
        let has_width = range.is_some_and(|[low, high]| low < high);
        let is_limited = match joint.keyword("limited", &BOOL_OR_AUTO)? {
            Some("true") => true,
            Some("false") => false,
            _ => self.compiler.limits_alone && has_width,
        };
        if !is_limited || kind == Kind::Floating {
            return Ok(None);
        }
        match range {
            Some([low, high]) if low >= high => wrong(format!(
                "`range` begins with the smaller number if `limited` is `true`, and {low} is not below {high}"
            )),
            None => wrong("`limited` needs a `range`".to_owned()),
            Some([low, _]) if kind == Kind::Ball && low != 0.0 => wrong(format!(
                "the range of a ball begins with 0, not {low}: it is the largest angle from rest"
            )),
            range => Ok(range),
        }
    }
}

/// Returns the type of a joint. A hinge becomes a revolute joint if it has limits.
fn kind(joint: &Attributes) -> Result<Kind> {
    let element = joint.element();
    Ok(match (element.tag(), joint.text("type").unwrap_or("hinge")) {
        ("freejoint", _) | (_, "free") => Kind::Floating,
        (_, "hinge") => Kind::Continuous,
        (_, "slide") => Kind::Prismatic,
        (_, "ball") => Kind::Ball,
        (_, other) => return Err(element.error(format!("`{other}` is not a type of joint"))),
    })
}

/// Returns a number, or zero if the attribute is absent. Negative numbers are errors.
fn not_negative(joint: &Attributes, name: &str, number: Option<[f64; 1]>) -> Result<f64> {
    match number {
        Some([value]) if value < 0.0 => {
            Err(joint.element().error(format!("the {name} {value} is negative")))
        }
        number => Ok(number.map_or(0.0, |[value]| value)),
    }
}
