// Written by the test `keywords` of `mstmm-codegen` from `src/language.md`: change the tables there.

/// `com`: centre of mass, body frame.
///
/// Unit: m. Default: required; in a line chain optional and without effect on the motion.
///
/// See [bodies](crate::mstmm_chain#bodies).
pub enum com {}

/// `inertia` in axes of the body frame: `diag(…)`, `tensor(…)` or `matrix(…)`, about `com` or
/// `input`; `turned …` gives the orientation of other axes; in a plane chain a number, about
/// `com` or `input`; in a line chain not allowed.
///
/// Unit: kg m². Default: required.
///
/// See [bodies](crate::mstmm_chain#bodies).
pub enum inertia {}

/// `mass` of the body.
///
/// Unit: kg. Default: required.
///
/// See [bodies](crate::mstmm_chain#bodies).
pub enum mass {}

/// `output`: the output point, body frame; `turned …` rotates the inboard frame of the next
/// hinge.
///
/// Unit: m. Default: the body has no output; required if the route continues.
///
/// See [bodies](crate::mstmm_chain#bodies).
pub enum output {}

/// `shape`: one [shape](crate::mstmm_chain#shapes), or several in brackets, for pictures only.
///
/// Unit: m. Default: the body has no shape.
///
/// See [bodies](crate::mstmm_chain#bodies).
pub enum shape {}
