//! The groups of a solution's results, in their order; a program of accelerations has the first three.

/// Accelerations that are solved for.
pub const ACCELERATIONS: usize = 0;
/// Pivots.
pub const PIVOTS: usize = 1;
/// What pivots are sums of.
pub const SCALES: usize = 2;
/// Accelerations of all rates, prescribed ones as well.
pub const ALL_RATES: usize = 3;
/// What drives every rate.
pub const EFFORTS: usize = 4;
/// Kinetic and potential energy, if they are asked for.
pub const ENERGIES: usize = 5;
/// Undetermined reactions of a closing hinge, six numbers each.
pub const UNDETERMINED: usize = 6;
/// What connection points are read off.
pub const NUMBERS: usize = 7;
/// What is felt at rest, if z is asked for.
pub const AT_REST: usize = 8;
