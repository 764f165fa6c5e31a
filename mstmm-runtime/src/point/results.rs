//! Markers for the results that the connection points of a chain have.

use core::fmt;

/// The results that the connection points of a chain have: poses, velocities, the state vector z.
///
/// The setting `results` of a chain lists them; without it they are [`AllResults`]. Results that are not listed are not
/// computed, and methods that read them do not compile.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Results<const POSES: bool, const VELOCITIES: bool, const Z: bool>;

/// All results.
pub type AllResults = Results<true, true, true>;

/// Results with positions and orientations.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `results` omits poses",
    label = "needs positions and orientations",
    note = "add `poses` to the setting `results`, or omit the setting to compute all results"
)]
pub trait HasPoses {}

impl<const VELOCITIES: bool, const Z: bool> HasPoses for Results<true, VELOCITIES, Z> {}

/// Results with velocities and angular velocities.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `results` omits velocities",
    label = "needs velocities and angular velocities",
    note = "add `velocities` to the setting `results`, or omit the setting to compute all results"
)]
pub trait HasVelocities {}

impl<const POSES: bool, const Z: bool> HasVelocities for Results<POSES, true, Z> {}

/// Results with the state vector z: accelerations, angular accelerations, internal moments and forces.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `results` omits the state vector z",
    label = "needs accelerations, moments and forces",
    note = "add `z` to the setting `results`, or omit the setting to compute all results"
)]
pub trait HasZ {}

impl<const POSES: bool, const VELOCITIES: bool> HasZ for Results<POSES, VELOCITIES, true> {}

/// Formats the fields that a point has.
pub(super) fn show(
    to: &mut fmt::Formatter<'_>,
    name: &str,
    fields: &[(bool, &str, &dyn fmt::Debug)],
) -> fmt::Result {
    let mut shown = to.debug_struct(name);
    for (_, name, value) in fields.iter().filter(|(has, ..)| *has) {
        shown.field(name, value);
    }
    shown.finish()
}
