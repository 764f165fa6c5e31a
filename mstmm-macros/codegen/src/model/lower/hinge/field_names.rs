//! The names of the fields of a hinge, by the groups of its degrees of freedom.

use crate::model::lower::dimension::{
    ANGLE, DAMPING, FORCE, INERTIA, LENGTH, MASS, Quantity, RATE, ROTATIONAL_DAMPING,
    ROTATIONAL_STIFFNESS, STIFFNESS, TORQUE, VELOCITY,
};
use crate::model::{DofGroup, HingeSpec};

/// The fields of a group of degrees of freedom.
pub(crate) struct FieldNames {
    /// Rates at the start.
    pub start_rate: &'static str,
    /// The effort of a motor.
    pub effort: &'static str,
    /// See [`crate::model::Passive`].
    pub stiffness: &'static str,
    /// See [`crate::model::Passive`].
    pub damping: &'static str,
    /// See [`crate::model::Passive`].
    pub armature: &'static str,
    /// See [`crate::model::Friction`].
    pub friction: &'static str,
    /// See [`crate::model::Friction`].
    pub friction_speed: &'static str,
    /// See [`crate::model::Limits`].
    pub limits: &'static str,
    /// See [`crate::model::Limits`].
    pub limit_stiffness: &'static str,
    /// See [`crate::model::Limits`].
    pub limit_damping: &'static str,
}

/// Of translations.
const TRANSLATION_FIELDS: FieldNames = FieldNames {
    start_rate: "start_velocity",
    effort: "force",
    stiffness: "stiffness",
    damping: "damping",
    armature: "armature",
    friction: "friction",
    friction_speed: "friction_speed",
    limits: "limits",
    limit_stiffness: "limit_stiffness",
    limit_damping: "limit_damping",
};

/// Of rotations.
const ROTATION_FIELDS: FieldNames =
    FieldNames { start_rate: "start_rate", effort: "torque", ..TRANSLATION_FIELDS };

/// Of rotations in a hinge that also has translations.
const PREFIXED_ROTATION_FIELDS: FieldNames = FieldNames {
    stiffness: "turning_stiffness",
    damping: "turning_damping",
    armature: "turning_armature",
    friction: "turning_friction",
    friction_speed: "turning_friction_speed",
    limits: "turning_limits",
    limit_stiffness: "turning_limit_stiffness",
    limit_damping: "turning_limit_damping",
    ..ROTATION_FIELDS
};

/// What the fields of a group measure.
pub(super) struct Measures {
    pub strain: &'static Quantity,
    pub rate: &'static Quantity,
    pub effort: &'static Quantity,
    pub stiffness: &'static Quantity,
    pub damping: &'static Quantity,
    pub inertia: &'static Quantity,
}

const TRANSLATION_MEASURES: Measures = Measures {
    strain: LENGTH,
    rate: VELOCITY,
    effort: FORCE,
    stiffness: STIFFNESS,
    damping: DAMPING,
    inertia: MASS,
};

pub(super) const ROTATION_MEASURES: Measures = Measures {
    strain: ANGLE,
    rate: RATE,
    effort: TORQUE,
    stiffness: ROTATIONAL_STIFFNESS,
    damping: ROTATIONAL_DAMPING,
    inertia: INERTIA,
};

/// The groups of a hinge, each with its fields.
pub(crate) fn groups(
    spec: &'static HingeSpec,
) -> impl Iterator<Item = (&'static DofGroup, &'static FieldNames)> {
    let has_translations = spec.groups.len() > 1;
    spec.groups.iter().map(move |group| match (group.rotational, has_translations) {
        (false, _) => (group, &TRANSLATION_FIELDS),
        (true, false) => (group, &ROTATION_FIELDS),
        (true, true) => (group, &PREFIXED_ROTATION_FIELDS),
    })
}

/// What the fields of a group measure.
pub(super) fn measures(group: &DofGroup) -> &'static Measures {
    if group.rotational { &ROTATION_MEASURES } else { &TRANSLATION_MEASURES }
}

/// The fields of a hinge on the route.
pub(crate) fn fields(spec: &'static HingeSpec) -> Vec<&'static str> {
    let of_group = |(_, names): (_, &FieldNames)| {
        [
            names.stiffness,
            names.damping,
            names.armature,
            names.friction,
            names.friction_speed,
            names.limits,
            names.limit_stiffness,
            names.limit_damping,
            names.effort,
        ]
    };
    let more = groups(spec).flat_map(of_group).chain(["rest", "motion"]);
    let any = !spec.groups.is_empty();
    start_fields(spec).into_iter().chain(more.filter(|_| any)).collect()
}

/// The fields that say how it starts.
pub(crate) fn start_fields(spec: &'static HingeSpec) -> Vec<&'static str> {
    let rates = groups(spec).map(|(_, names)| names.start_rate);
    let any = !spec.groups.is_empty();
    any.then_some("start").into_iter().chain(rates).collect()
}
