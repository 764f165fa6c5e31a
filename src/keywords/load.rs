// Written by the test `keywords` of `mstmm-codegen` from `src/language.md`: change the tables there.

/// `at`: where the force acts: `input`, `output`, `com`, a named point, or a vector in the body
/// frame.
///
/// Unit: m. Default: `com`; not if `on` has a place.
///
/// See [loads and springs](crate::mstmm_chain#loads-and-springs).
pub enum at {}

/// `axes` of both: `inertial` or `body`.
///
/// Default: `inertial`; not in a line chain.
///
/// See [loads and springs](crate::mstmm_chain#loads-and-springs).
pub enum axes {}

/// `force`: a vector, or the keyword `input`.
///
/// Unit: N. Default: 0; a load needs `force`, `torque` or both.
///
/// See [loads and springs](crate::mstmm_chain#loads-and-springs).
pub enum force {}

/// `on`: the body, or a place on it such as `rod.tip`.
///
/// Default: required.
///
/// See [loads and springs](crate::mstmm_chain#loads-and-springs).
pub enum on {}

/// `torque`, in addition to the moment of the force: a vector, in a plane a number, or the
/// keyword `input`.
///
/// Unit: N m. Default: 0; not in a line chain.
///
/// See [loads and springs](crate::mstmm_chain#loads-and-springs).
pub enum torque {}
