//! Springs, dampers, friction, limits and rotors of a hinge: read by the groups of its degrees of
//! freedom, the same way for all kinds.

use super::field_names::{FieldNames, Measures, ROTATION_MEASURES, measures};
use crate::model::lower::context::Context;
use crate::model::lower::dimension::Quantity;
use crate::model::lower::fields::Fields;
use crate::model::{DofGroup, Friction, Limits, Passive, Representation, Value};
use crate::syntax::ValueSyntax;

/// Reads the passive forces along the strains of a group. `rotation` has the fields of the rotations
/// of the same hinge, if the group has its translations.
pub(super) fn passive(
    group: &DofGroup,
    names: &FieldNames,
    rotation: Option<&FieldNames>,
    fields: &Fields,
    context: &mut Context,
) -> Vec<Passive> {
    let mut reader = PassiveReader { group, names, rotation, fields, context };
    let stiffness = reader.each(|names| names.stiffness, |measures| measures.stiffness);
    let damping = reader.each(|names| names.damping, |measures| measures.damping);
    let armature = reader.each(|names| names.armature, |measures| measures.inertia);
    let friction = reader.friction();
    let limits = reader.limits();
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
    names: &'r FieldNames,
    rotation: Option<&'r FieldNames>,
    fields: &'r Fields<'f>,
    context: &'r mut Context<'c>,
}

/// A field of a group.
type Field = fn(&FieldNames) -> &'static str;

impl PassiveReader<'_, '_, '_> {
    /// Returns the quantity of a field. It also has the field of the rotations.
    fn quantity(&self, field: Field, measure: fn(&Measures) -> &'static Quantity) -> Quantity {
        let rotational =
            self.rotation.map(|names| (measure(&ROTATION_MEASURES).dimension, field(names)));
        Quantity { rotational, ..*measure(measures(self.group)) }
    }

    /// Reads a number for each strain: one for all of them, or several. The strains of a quaternion
    /// share one.
    fn each(&mut self, field: Field, measure: fn(&Measures) -> &'static Quantity) -> Vec<Value> {
        let expected = &self.quantity(field, measure);
        let count = self.group.rates.len();
        let shared = self.group.representation == Representation::Quaternion;
        self.context.readable(
            self.fields.get(field(self.names)),
            || vec![Value::number(0.0); count],
            |context, syntax| match shared {
                true => context.read_number(syntax, expected).map(|value| vec![value; count]),
                false => context.each(syntax, count, expected),
            },
        )
    }

    /// A number for all strains.
    fn number(
        &mut self,
        field: Field,
        measure: fn(&Measures) -> &'static Quantity,
        default: f64,
    ) -> Value {
        let expected = &self.quantity(field, measure);
        self.context.readable(
            self.fields.get(field(self.names)),
            || Value::number(default),
            |context, syntax| context.read_number(syntax, expected),
        )
    }

    /// Whether one of these is given.
    fn gives(&self, names: &[&str]) -> bool {
        names.iter().any(|name| self.fields.get(name).is_some())
    }

    /// Friction for each strain.
    fn friction(&mut self) -> Vec<Option<Friction>> {
        let names = self.names;
        let efforts = self.each(|names| names.friction, |measures| measures.effort);
        let speed = self.number(|names| names.friction_speed, |measures| measures.rate, 1.0);
        // Without friction its speed is still checked.
        let alone = self.gives(&[names.friction_speed]) && !self.gives(&[names.friction]);
        let friction = |effort: Value| {
            let acts = alone || !effort.is_zero();
            acts.then(|| Friction { effort, speed: speed.clone() })
        };
        efforts.into_iter().map(friction).collect()
    }

    /// Limits of all strains.
    fn limits(&mut self) -> Option<Limits> {
        let names = self.names;
        let strain = &self.quantity(|names| names.limits, |measures| measures.strain);
        let representation = self.group.representation;
        let [low, high] = self.context.readable(
            self.fields.get(names.limits),
            || [-1.0, 1.0].map(Value::number),
            |context, syntax| match representation {
                Representation::Quaternion => {
                    let angle = context.read_number(syntax, strain)?;
                    Some([angle.clone().negated(), angle])
                }
                Representation::Numbers | Representation::Angles => {
                    interval(context, syntax, strain)
                }
            },
        );
        let stiffness =
            self.number(|names| names.limit_stiffness, |measures| measures.stiffness, 1.0);
        let damping = self.number(|names| names.limit_damping, |measures| measures.damping, 0.0);
        let is_limited = self.gives(&[names.limits, names.limit_stiffness, names.limit_damping]);
        is_limited.then_some(Limits { low, high, stiffness, damping })
    }
}

fn interval(
    context: &mut Context,
    syntax: &ValueSyntax,
    expected: &Quantity,
) -> Option<[Value; 2]> {
    match syntax {
        ValueSyntax::Vector(list) => context.vector(list, 2, expected)?.try_into().ok(),
        other => {
            let message =
                format!("expected two limits `[lowest, highest]`, found {}", other.described());
            context.refuse(other.extent(), message)
        }
    }
}
