//! Which results the connection points of a chain have.

use core::fmt;

/// Which results the connection points of a chain have: poses, velocities and the state vector z.
///
/// A chain's setting `results` says so; unless it does they have all of them, [`AllResults`]. What was left
/// out is not computed, and a method that reads it does not compile.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Results<const POSES: bool, const VELOCITIES: bool, const Z: bool>;

/// All results.
pub type AllResults = Results<true, true, true>;

/// Results with positions and orientations.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `results` leaves poses out",
    label = "needs positions and orientations",
    note = "add `poses` to the setting `results`, or leave it out to have everything"
)]
pub trait HasPoses {}

impl<const VELOCITIES: bool, const Z: bool> HasPoses for Results<true, VELOCITIES, Z> {}

/// Results with velocities and angular velocities.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `results` leaves velocities out",
    label = "needs velocities and angular velocities",
    note = "add `velocities` to the setting `results`, or leave it out to have everything"
)]
pub trait HasVelocities {}

impl<const POSES: bool, const Z: bool> HasVelocities for Results<POSES, true, Z> {}

/// Results with the method's state vector z: accelerations, angular accelerations, internal moments and
/// forces.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `results` leaves the state vector z out",
    label = "needs accelerations, moments and forces",
    note = "add `z` to the setting `results`, or leave it out to have everything"
)]
pub trait HasZ {}

impl<const POSES: bool, const VELOCITIES: bool> HasZ for Results<POSES, VELOCITIES, true> {}

/// Shows the fields that a point has.
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
