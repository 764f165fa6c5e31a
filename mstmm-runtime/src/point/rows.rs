//! The results of a connection point as rows of a table.

/// The group of results that a row of a point belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Positions and orientations.
    Pose,
    /// Velocities and angular velocities.
    Velocity,
    /// Accelerations, moments and forces.
    Z,
}

/// A row of a point: its group, its label, its values and their unit.
pub type PointRow<'a, T> = (Group, &'static str, &'a [T], &'static str);
