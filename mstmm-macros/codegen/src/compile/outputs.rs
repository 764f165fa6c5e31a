//! The results of a chain's functions.

use crate::ids::RepeatId;
use crate::program::OutputId;

/// Accelerations that are solved for, in the order of `v`.
pub const ACCELERATIONS: OutputId = OutputId::new("accelerations");
/// Accelerations of all rates, those of prescribed hinges as well.
pub const ALL_ACCELERATIONS: OutputId = OutputId::new("all_accelerations");
/// What drives every rate.
pub const EFFORTS: OutputId = OutputId::new("efforts");
/// Kinetic and potential energy.
pub const ENERGIES: OutputId = OutputId::new("energies");
/// Undetermined reactions of a closing hinge, six numbers each.
pub const UNDETERMINED: OutputId = OutputId::new("undetermined");
/// What connection points are read off.
pub const POINT_NUMBERS: OutputId = OutputId::new("points");
/// What a point at rest feels.
pub const AT_REST: OutputId = OutputId::new("at_rest");
/// Time derivatives of coordinates.
pub const COORDINATE_RATES: OutputId = OutputId::new("coordinate_rates");
/// Coordinates.
pub const COORDINATES: OutputId = OutputId::new("coordinates");
/// Rates.
pub const RATES: OutputId = OutputId::new("rates");
/// How far from closed a chain was, and how much redundant directions held.
pub const RESIDUAL: OutputId = OutputId::new("residual");
/// Pivots of a closing hinge's directions, the largest first.
pub const CLOSURE_PIVOTS: OutputId = OutputId::new("closure_pivots");
/// Efforts of drives at which no rate changes, in the order of `v`.
pub const BIAS_EFFORTS: OutputId = OutputId::new("bias_efforts");
/// Numbers that are checked when a parameter is set.
pub const CHECKED: OutputId = OutputId::new("checks");

/// What the setup derives: for every repetition of a part, or what stands once.
pub const fn slots(part: Option<RepeatId>) -> OutputId {
    OutputId { name: "slots", part }
}
