//! Springs, dampers, friction, limits and rotors of a hinge: read by the groups of its degrees of
//! freedom, the same way for all kinds.

use super::words::{Words, measures};
use crate::model::lower::context::Context;
use crate::model::lower::dimension::Quantity;
use crate::model::lower::fields::Fields;
use crate::model::{Form, Freedoms, Friction, Limits, Passive, Value};
use crate::syntax::Written;

/// What acts on the strains of a group.
pub(super) fn passive(
    group: &Freedoms,
    words: &Words,
    fields: &Fields,
    context: &mut Context,
) -> Option<Vec<Passive>> {
    let mut reader = Reader { group, fields, context };
    let measures = measures(group);
    // All of it is read before giving up, so that all mistakes in it are reported.
    let stiffness = reader.each(words.stiffness, measures.stiffness);
    let damping = reader.each(words.damping, measures.damping);
    let armature = reader.each(words.armature, measures.inertia);
    let friction = reader.friction(words);
    let limits = reader.limits(words);
    let (friction, limits) = (friction?, limits?);
    let parts = stiffness?.into_iter().zip(damping?).zip(armature?).zip(friction);
    let passive = |(((stiffness, damping), armature), friction)| Passive {
        stiffness,
        damping,
        armature,
        friction,
        limits: limits.clone(),
    };
    Some(parts.map(passive).collect())
}

/// What reads the fields of a group.
struct Reader<'r, 'f, 'c> {
    group: &'r Freedoms,
    fields: &'r Fields<'f>,
    context: &'r mut Context<'c>,
}

impl Reader<'_, '_, '_> {
    /// A number for each strain: one that stands for all of them, or several. The strains of a
    /// quaternion have no axes of their own, so they share one.
    fn each(&mut self, name: &str, expected: &Quantity) -> Option<Vec<Value>> {
        let count = self.group.rates.len();
        let shared = self.group.form == Form::Quaternion;
        self.context.optional(
            self.fields.get(name),
            || vec![Value::number(0.0); count],
            |context, written| match shared {
                true => context.written_number(written, expected).map(|all| vec![all; count]),
                false => context.each(written, count, expected),
            },
        )
    }

    /// A number for all strains; nothing inside where it is not given.
    fn number(&mut self, name: &str, expected: &Quantity) -> Option<Option<Value>> {
        self.context.optional(
            self.fields.get(name),
            || None,
            |context, written| context.written_number(written, expected).map(Some),
        )
    }

    /// Friction for each strain. Where its speed is missing there is none: a rule reports that.
    fn friction(&mut self, words: &Words) -> Option<Vec<Option<Friction>>> {
        let measures = measures(self.group);
        let efforts = self.each(words.friction, measures.effort);
        let speed = self.number(words.friction_speed, measures.rate);
        let (efforts, speed) = (efforts?, speed?);
        let friction = |effort: Value| {
            let speed = speed.clone().filter(|_| !effort.is_zero())?;
            Some(Friction { effort, speed })
        };
        Some(efforts.into_iter().map(friction).collect())
    }

    /// Limits of all strains. Where their stiffness is missing there are none: a rule reports that.
    fn limits(&mut self, words: &Words) -> Option<Option<Limits>> {
        let measures = measures(self.group);
        let form = self.group.form;
        let ends = self.context.optional(
            self.fields.get(words.limits),
            || None,
            |context, written| match form {
                Form::Quaternion => {
                    let angle = context.written_number(written, measures.strain)?;
                    Some(Some([angle.clone().negated(), angle]))
                }
                Form::Numbers | Form::Angles => interval(context, written, measures.strain),
            },
        );
        let stiffness = self.number(words.limit_stiffness, measures.stiffness);
        let damping = self.number(words.limit_damping, measures.damping);
        let (ends, stiffness, damping) = (ends?, stiffness?, damping?);
        Some(ends.zip(stiffness).map(|([low, high], stiffness)| Limits {
            low,
            high,
            stiffness,
            damping: damping.unwrap_or(Value::number(0.0)),
        }))
    }
}

fn interval(
    context: &mut Context,
    written: &Written,
    expected: &Quantity,
) -> Option<Option<[Value; 2]>> {
    match written {
        Written::Vector(list) => Some(context.vector(list, 2, expected)?.try_into().ok()),
        other => {
            let message =
                format!("limits are two: `[lowest, highest]`, found {}", other.described());
            context.refuse(other.extent(), message)
        }
    }
}
