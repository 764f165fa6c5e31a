//! The outputs of a chain's functions.

use crate::ids::RepeatId;
use crate::program::OutputId;

/// The unknown accelerations, in the order of `v`.
pub const ACCELERATIONS: OutputId = OutputId::new("accelerations");
/// The accelerations of all rates, including those of prescribed hinges.
pub const ALL_ACCELERATIONS: OutputId = OutputId::new("all_accelerations");
/// The effort at every rate, including the rates of prescribed hinges.
pub const EFFORTS: OutputId = OutputId::new("efforts");
/// Kinetic and potential energy.
pub const ENERGIES: OutputId = OutputId::new("energies");
/// The undetermined constraint wrenches of a closing hinge, six values each.
pub const UNDETERMINED: OutputId = OutputId::new("undetermined");
/// The stored values of connection points.
pub const POINT_NUMBERS: OutputId = OutputId::new("points");
/// The proper acceleration of a point at rest: the negative of the acceleration of free fall.
pub const BASE_ACCELERATION: OutputId = OutputId::new("base_acceleration");
/// Length, rate of the length, tension and force of every spring.
pub const SPRINGS: OutputId = OutputId::new("springs");
/// The time derivatives of the coordinates.
pub const COORDINATE_RATES: OutputId = OutputId::new("coordinate_rates");
/// The coordinates.
pub const COORDINATES: OutputId = OutputId::new("coordinates");
/// The rates.
pub const RATES: OutputId = OutputId::new("rates");
/// The closure error of a chain, and how much directions that count as redundant constrain it, from zero to one.
pub const RESIDUAL: OutputId = OutputId::new("residual");
/// The pivots of a closing hinge's constraint directions, the largest first.
pub const CLOSURE_PIVOTS: OutputId = OutputId::new("closure_pivots");
/// The bias efforts: the efforts at which all accelerations vanish, in the order of `v`.
pub const BIAS_EFFORTS: OutputId = OutputId::new("bias_efforts");
/// The product of a matrix with the given vector, in the order of `v`.
pub const PRODUCT: OutputId = OutputId::new("product");
/// The derivative of the accelerations along a direction, in the order of `v`.
pub const CHANGE: OutputId = OutputId::new("change");
/// The derivatives by the coordinates, along the rates.
pub const BY_COORDINATES: OutputId = OutputId::new("by_coordinates");
/// The derivatives by the rates.
pub const BY_RATES: OutputId = OutputId::new("by_rates");
/// The derivatives by the inputs.
pub const BY_INPUTS: OutputId = OutputId::new("by_inputs");
/// The derivatives by the parameters.
pub const BY_PARAMETERS: OutputId = OutputId::new("by_parameters");
/// The regressor, column by column.
pub const REGRESSOR: OutputId = OutputId::new("regressor");
/// The entries of the regressor's columns of passive elements.
pub const PASSIVE: OutputId = OutputId::new("passive");
/// The dynamic parameters.
pub const DYNAMIC_PARAMETERS: OutputId = OutputId::new("dynamic_parameters");
/// A matrix with one row and column for each rate, by columns.
pub const MATRIX: OutputId = OutputId::new("matrix");
/// The inverse of the mass matrix, by columns.
pub const INVERSE_MASS_MATRIX: OutputId = OutputId::new("inverse_mass_matrix");
/// Derivatives with respect to the accelerations, one column for each.
pub const BY_ACCELERATIONS: OutputId = OutputId::new("by_accelerations");
/// The motions of all bodies at zero accelerations.
pub const MOTIONS: OutputId = OutputId::new("motions");
/// The motions that the rates cause, at the inertial origin.
pub const COLUMNS: OutputId = OutputId::new("columns");
/// The frames of bodies that parameters change.
pub const FRAMES: OutputId = OutputId::new("frames");
/// Mass, centre of mass and momentum, or the columns of the matrix that maps rates to momentum.
pub const MOMENTUM: OutputId = OutputId::new("momentum");
/// The values that are checked when a parameter is set.
pub const CHECKED: OutputId = OutputId::new("checks");

/// Returns the output for the slots of a repeated part, or for the slots outside of repeated parts.
pub const fn slots(part: Option<RepeatId>) -> OutputId {
    OutputId { name: "slots", part }
}
