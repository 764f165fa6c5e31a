// Written by the test `keywords` of `mstmm-codegen` from `src/language.md`: change the tables there.
// Names of other tools are from `src/terms.md`.

/// `armature`: inertia of a rotor that moves with the hinge, at the side of the hinge.
///
/// Unit: kg for translations, kg m² for rotations. Default: 0.
///
/// See [hinges](crate::mstmm_chain#hinges).
///
/// Other tools: `Model::armature`, `gear_ratio`, `rotor_inertia`.
#[doc(alias = "Model::armature")]
#[doc(alias = "gear_ratio")]
#[doc(alias = "rotor_inertia")]
pub enum armature {}

/// `damping` of a damper.
///
/// Unit: N s/m for translations, N m s/rad for rotations. Default: 0.
///
/// See [hinges](crate::mstmm_chain#hinges).
///
/// Other tools: `Model::damping`, `default_damping`.
#[doc(alias = "Model::damping")]
#[doc(alias = "default_damping")]
pub enum damping {}

/// `force` of a motor: constant, or the keyword `input`.
///
/// Unit: N. Default: 0.
///
/// See [hinges](crate::mstmm_chain#hinges).
///
/// Other tools: `AddJointActuator`, `actuator/motor`, `qfrc_applied`, `tau`.
#[doc(alias = "AddJointActuator")]
#[doc(alias = "actuator/motor")]
#[doc(alias = "qfrc_applied")]
#[doc(alias = "tau")]
pub enum force {}

/// `friction`: dry friction at speed.
///
/// Unit: N for translations, N m for rotations. Default: 0.
///
/// See [hinges](crate::mstmm_chain#hinges).
///
/// Other tools: `DoorHinge`, `Model::friction`, `frictionloss`.
#[doc(alias = "DoorHinge")]
#[doc(alias = "Model::friction")]
#[doc(alias = "frictionloss")]
pub enum friction {}

/// `friction_speed`: the speed that smooths friction.
///
/// Unit: m/s for translations, rad/s for rotations. Default: required with `friction`.
///
/// See [hinges](crate::mstmm_chain#hinges).
pub enum friction_speed {}

/// `limit_damping`: the damping beyond the limits.
///
/// Unit: N s/m for translations, N m s/rad for rotations. Default: 0.
///
/// See [hinges](crate::mstmm_chain#hinges).
pub enum limit_damping {}

/// `limit_stiffness`: the stiffness beyond the limits.
///
/// Unit: N/m for translations, N m/rad for rotations. Default: required with `limits`.
///
/// See [hinges](crate::mstmm_chain#hinges).
pub enum limit_stiffness {}

/// `limits`: `[lowest, highest]` coordinate, not relative to `rest`.
///
/// Unit: m for translations, rad for rotations. Default: none.
///
/// See [hinges](crate::mstmm_chain#hinges).
///
/// Other tools: `lowerPositionLimit`, `position_lower_limits`, `position_upper_limits`,
/// `range`, `upperPositionLimit`.
#[doc(alias = "lowerPositionLimit")]
#[doc(alias = "position_lower_limits")]
#[doc(alias = "position_upper_limits")]
#[doc(alias = "range")]
#[doc(alias = "upperPositionLimit")]
pub enum limits {}

/// `motion`: the motion of the whole hinge is prescribed at each step.
///
///  Default: the hinge moves freely.
///
/// See [hinges](crate::mstmm_chain#hinges).
///
/// Other tools: `Joint::Lock`.
#[doc(alias = "Joint::Lock")]
pub enum motion {}

/// `rest`: coordinates at which springs are unloaded.
///
/// Unit: m for translations, rad for rotations. Default: zero position.
///
/// See [hinges](crate::mstmm_chain#hinges).
///
/// Other tools: `nominal_angle`, `nominal_position`, `springref`.
#[doc(alias = "nominal_angle")]
#[doc(alias = "nominal_position")]
#[doc(alias = "springref")]
pub enum rest {}

/// `start`: initial coordinates.
///
/// Unit: m for translations, rad for rotations. Default: zero position.
///
/// See [hinges](crate::mstmm_chain#hinges).
///
/// Other tools: `keyframe`, `set_default_positions`.
#[doc(alias = "keyframe")]
#[doc(alias = "set_default_positions")]
pub enum start {}

/// `start_rate`: initial rates.
///
/// Unit: rad/s. Default: 0.
///
/// See [hinges](crate::mstmm_chain#hinges).
pub enum start_rate {}

/// `start_velocity`: initial rates.
///
/// Unit: m/s. Default: 0.
///
/// See [hinges](crate::mstmm_chain#hinges).
pub enum start_velocity {}

/// `stiffness` of a spring.
///
/// Unit: N/m for translations, N m/rad for rotations. Default: 0.
///
/// See [hinges](crate::mstmm_chain#hinges).
///
/// Other tools: `PrismaticSpring`, `RevoluteSpring`.
#[doc(alias = "PrismaticSpring")]
#[doc(alias = "RevoluteSpring")]
pub enum stiffness {}

/// `torque` of a motor: constant, or the keyword `input`.
///
/// Unit: N m. Default: 0.
///
/// See [hinges](crate::mstmm_chain#hinges).
///
/// Other tools: `AddJointActuator`, `actuator/motor`, `qfrc_applied`, `tau`.
#[doc(alias = "AddJointActuator")]
#[doc(alias = "actuator/motor")]
#[doc(alias = "qfrc_applied")]
#[doc(alias = "tau")]
pub enum torque {}

/// `turning_armature`: the field `armature` of the rotations.
///
/// In a hinge that also has translations, `armature` is that of the translations.
///
/// Unit: kg m². Default: 0.
///
/// See [hinges](crate::mstmm_chain#hinges).
pub enum turning_armature {}

/// `turning_damping`: the field `damping` of the rotations.
///
/// In a hinge that also has translations, `damping` is that of the translations.
///
/// Unit: N m s/rad. Default: 0.
///
/// See [hinges](crate::mstmm_chain#hinges).
pub enum turning_damping {}

/// `turning_friction`: the field `friction` of the rotations.
///
/// In a hinge that also has translations, `friction` is that of the translations.
///
/// Unit: N m. Default: 0.
///
/// See [hinges](crate::mstmm_chain#hinges).
pub enum turning_friction {}

/// `turning_friction_speed`: the field `friction_speed` of the rotations.
///
/// In a hinge that also has translations, `friction_speed` is that of the translations.
///
/// Unit: rad/s. Default: required with `friction`.
///
/// See [hinges](crate::mstmm_chain#hinges).
pub enum turning_friction_speed {}

/// `turning_limit_damping`: the field `limit_damping` of the rotations.
///
/// In a hinge that also has translations, `limit_damping` is that of the translations.
///
/// Unit: N m s/rad. Default: 0.
///
/// See [hinges](crate::mstmm_chain#hinges).
pub enum turning_limit_damping {}

/// `turning_limit_stiffness`: the field `limit_stiffness` of the rotations.
///
/// In a hinge that also has translations, `limit_stiffness` is that of the translations.
///
/// Unit: N m/rad. Default: required with `limits`.
///
/// See [hinges](crate::mstmm_chain#hinges).
pub enum turning_limit_stiffness {}

/// `turning_limits`: the field `limits` of the rotations.
///
/// In a hinge that also has translations, `limits` is that of the translations.
///
/// Unit: rad. Default: none.
///
/// See [hinges](crate::mstmm_chain#hinges).
pub enum turning_limits {}

/// `turning_stiffness`: the field `stiffness` of the rotations.
///
/// In a hinge that also has translations, `stiffness` is that of the translations.
///
/// Unit: N m/rad. Default: 0.
///
/// See [hinges](crate::mstmm_chain#hinges).
pub enum turning_stiffness {}
