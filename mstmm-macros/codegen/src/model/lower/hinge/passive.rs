//! Springs, dampers, friction, limits and rotors of a hinge: read by the groups of its degrees of
//! freedom, the same way for all kinds.

use super::field_names::{FieldNames, measures};
use crate::model::lower::context::Context;
use crate::model::lower::dimension::Quantity;
use crate::model::lower::fields::Fields;
use crate::model::{DofGroup, Friction, Limits, Passive, Representation, Value};
use crate::syntax::ValueSyntax;

/// Reads the passive forces along the strains of a group.
pub(super) fn passive(
    group: &DofGroup,
    names: &FieldNames,
    fields: &Fields,
    context: &mut Context,
) -> Vec<Passive> {
    let mut reader = PassiveReader { group, fields, context };
    let measures = measures(group);
    let stiffness = reader.each(names.stiffness, measures.stiffness);
    let damping = reader.each(names.damping, measures.damping);
    let armature = reader.each(names.armature, measures.inertia);
    let friction = reader.friction(names);
    let limits = reader.limits(names);
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

/// Reads the fields of a group. A field that is not readable, or that another field needs, is
/// reported and has a valid default, so that the other fields are still checked.
struct PassiveReader<'r, 'f, 'c> {
    group: &'r DofGroup,
    fields: &'r Fields<'f>,
    context: &'r mut Context<'c>,
}

impl PassiveReader<'_, '_, '_> {
    /// Reads a number for each strain: one for all of them, or several. The strains of a quaternion
    /// share one.
    fn each(&mut self, name: &str, expected: &Quantity) -> Vec<Value> {
        let count = self.group.rates.len();
        let shared = self.group.representation == Representation::Quaternion;
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
    fn friction(&mut self, names: &FieldNames) -> Vec<Option<Friction>> {
        let measures = measures(self.group);
        let efforts = self.each(names.friction, measures.effort);
        let speed = self.number(names.friction_speed, measures.rate, 1.0);
        // Without friction its speed is still checked.
        let alone = self.gives(&[names.friction_speed]) && !self.gives(&[names.friction]);
        let friction = |effort: Value| {
            let acts = alone || !effort.is_zero();
            acts.then(|| Friction { effort, speed: speed.clone() })
        };
        efforts.into_iter().map(friction).collect()
    }

    /// Limits of all strains.
    fn limits(&mut self, names: &FieldNames) -> Option<Limits> {
        let measures = measures(self.group);
        let form = self.group.representation;
        let [low, high] = self.context.readable(
            self.fields.get(names.limits),
            || [-1.0, 1.0].map(Value::number),
            |context, written| match form {
                Representation::Quaternion => {
                    let angle = context.written_number(written, measures.strain)?;
                    Some([angle.clone().negated(), angle])
                }
                Representation::Numbers | Representation::Angles => {
                    interval(context, written, measures.strain)
                }
            },
        );
        let stiffness = self.number(names.limit_stiffness, measures.stiffness, 1.0);
        let damping = self.number(names.limit_damping, measures.damping, 0.0);
        let given = self.gives(&[names.limits, names.limit_stiffness, names.limit_damping]);
        given.then_some(Limits { low, high, stiffness, damping })
    }
}

fn interval(
    context: &mut Context,
    written: &ValueSyntax,
    expected: &Quantity,
) -> Option<[Value; 2]> {
    match written {
        ValueSyntax::Vector(list) => context.vector(list, 2, expected)?.try_into().ok(),
        other => {
            let message =
                format!("expected two limits `[lowest, highest]`, found {}", other.described());
            context.refuse(other.extent(), message)
        }
    }
}
