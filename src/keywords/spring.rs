// Written by the test `keywords` of `mstmm-codegen` from `src/language.md`: change the tables there.

/// `at`: where the spring acts, as for loads.
///
/// Unit: m. Default: `com`; not if `on` has a place.
///
/// See [loads and springs](crate::mstmm_chain#loads-and-springs).
pub enum at {}

/// `damping` along the spring.
///
/// Unit: N s/m. Default: 0.
///
/// See [loads and springs](crate::mstmm_chain#loads-and-springs).
pub enum damping {}

/// `force` of an actuator along the spring, positive if it pushes the ends apart: a number, or
/// the keyword `input`.
///
/// Unit: N. Default: 0.
///
/// See [loads and springs](crate::mstmm_chain#loads-and-springs).
pub enum force {}

/// `length` without load.
///
/// Unit: m. Default: 0.
///
/// See [loads and springs](crate::mstmm_chain#loads-and-springs).
pub enum length {}

/// `on`: the body, or a place on it such as `rod.tip`, as for loads.
///
/// Default: required.
///
/// See [loads and springs](crate::mstmm_chain#loads-and-springs).
pub enum on {}

/// `stiffness` along the spring.
///
/// Unit: N/m. Default: required without `force` or with `length`.
///
/// See [loads and springs](crate::mstmm_chain#loads-and-springs).
pub enum stiffness {}

/// `to`: a place on another body, such as `trunk.tip`, or a point on the ground as a vector,
/// inertial frame.
///
/// Unit: m. Default: required.
///
/// See [loads and springs](crate::mstmm_chain#loads-and-springs).
pub enum to {}
