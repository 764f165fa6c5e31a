// Written by the test `keywords` of `mstmm-codegen` from `src/language.md`: change the tables there.

/// `start`: position of its input, `turned …`.
///
/// Unit: m. Default: inertial origin, not rotated.
///
/// See [ends](crate::mstmm_chain#ends).
pub enum start {}

/// `start_rate`: angular velocity, body frame.
///
/// Unit: rad/s. Default: 0.
///
/// See [ends](crate::mstmm_chain#ends).
pub enum start_rate {}

/// `start_velocity` of its input, inertial frame.
///
/// Unit: m/s. Default: 0.
///
/// See [ends](crate::mstmm_chain#ends).
pub enum start_velocity {}
