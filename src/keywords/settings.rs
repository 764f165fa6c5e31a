// Written by the test `keywords` of `mstmm-codegen` from `src/language.md`: change the tables there.

/// `answers`: the functions to generate in addition to those that every chain has, [see the
/// reference](crate::mstmm_chain#answers).
///
/// Default: none.
///
/// See [the chain](crate::mstmm_chain#the-chain).
pub enum answers {}

/// `gravity`: acceleration of free fall in m/s², inertial frame; or the keyword `input`.
///
/// Default: no gravity.
///
/// See [the chain](crate::mstmm_chain#the-chain).
pub enum gravity {}

/// `method`: `riccati` or `transfer`: how the accelerations are computed, [see the
/// reference](crate::mstmm_chain#two-methods).
///
/// Default: `riccati`.
///
/// See [the chain](crate::mstmm_chain#the-chain).
pub enum method {}

/// `results`: the results of `solve_into` in addition to accelerations, efforts and loop
/// constraints, [see the reference](crate::mstmm_chain#fewer-results).
///
/// Default: all.
///
/// See [the chain](crate::mstmm_chain#the-chain).
pub enum results {}
