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
) -> Vec<Passive> {
    let mut reader = Reader { group, fields, context };
    let measures = measures(group);
    let stiffness = reader.each(words.stiffness, measures.stiffness);
    let damping = reader.each(words.damping, measures.damping);
    let armature = reader.each(words.armature, measures.inertia);
    let friction = reader.friction(words);
    let limits = reader.limits(words);
    let parts = stiffness.into_iter().zip(damping).zip(armature).zip(friction);
    let passive = |(((stiffness, damping), armature), friction)| Passive {
        stiffness,
        damping,
        armature,
        friction,
        limits: limits.clone(),
    };
    parts.map(passive).collect()
}

/// What reads the fields of a group. One that cannot be read, or that is missing beside another one,
/// is reported, and gets a number that no rule is against, so that the others are judged all the same.
struct Reader<'r, 'f, 'c> {
    group: &'r Freedoms,
    fields: &'r Fields<'f>,
    context: &'r mut Context<'c>,
}

impl Reader<'_, '_, '_> {
    /// A number for each strain: one that stands for all of them, or several. The strains of a
    /// quaternion have no axes of their own, so they share one.
    fn each(&mut self, name: &str, expected: &Quantity) -> Vec<Value> {
        let count = self.group.rates.len();
        let shared = self.group.form == Form::Quaternion;
        self.context.readable(
            self.fields.get(name),
            || vec![Value::number(0.0); count],
            |context, written| match shared {
                true => context.written_number(written, expected).map(|all| vec![all; count]),
                false => context.each(written, count, expected),
            },
        )
    }

    /// A number for all strains.
    fn number(&mut self, name: &str, expected: &Quantity, without: f64) -> Value {
        self.context.readable(
            self.fields.get(name),
            || Value::number(without),
            |context, written| context.written_number(written, expected),
        )
    }

    /// Whether one of these is given.
    fn gives(&self, names: &[&str]) -> bool {
        names.iter().any(|name| self.fields.get(name).is_some())
    }

    /// Friction for each strain.
    fn friction(&mut self, words: &Words) -> Vec<Option<Friction>> {
        let measures = measures(self.group);
        let efforts = self.each(words.friction, measures.effort);
        let speed = self.number(words.friction_speed, measures.rate, 1.0);
        // Without friction its speed is still judged.
        let alone = self.gives(&[words.friction_speed]) && !self.gives(&[words.friction]);
        let friction = |effort: Value| {
            let acts = alone || !effort.is_zero();
            acts.then(|| Friction { effort, speed: speed.clone() })
        };
        efforts.into_iter().map(friction).collect()
    }

    /// Limits of all strains.
    fn limits(&mut self, words: &Words) -> Option<Limits> {
        let measures = measures(self.group);
        let form = self.group.form;
        let [low, high] = self.context.readable(
            self.fields.get(words.limits),
            || [-1.0, 1.0].map(Value::number),
            |context, written| match form {
                Form::Quaternion => {
                    let angle = context.written_number(written, measures.strain)?;
                    Some([angle.clone().negated(), angle])
                }
                Form::Numbers | Form::Angles => interval(context, written, measures.strain),
            },
        );
        let stiffness = self.number(words.limit_stiffness, measures.stiffness, 1.0);
        let damping = self.number(words.limit_damping, measures.damping, 0.0);
        let given = self.gives(&[words.limits, words.limit_stiffness, words.limit_damping]);
        given.then_some(Limits { low, high, stiffness, damping })
    }
}

fn interval(context: &mut Context, written: &Written, expected: &Quantity) -> Option<[Value; 2]> {
    match written {
        Written::Vector(list) => context.vector(list, 2, expected)?.try_into().ok(),
        other => {
            let message =
                format!("limits are two: `[lowest, highest]`, found {}", other.described());
            context.refuse(other.extent(), message)
        }
    }
}
