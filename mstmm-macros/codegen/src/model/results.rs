//! What a chain's solution says.

/// The results that `solve_into` computes in addition to accelerations, efforts and loop closure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Results {
    /// Positions and orientations of all connection points.
    pub poses: bool,
    /// Their velocities and angular velocities.
    pub velocities: bool,
    /// Their state vectors z.
    pub z: bool,
    /// Kinetic and potential energy.
    pub energies: bool,
}

impl Results {
    /// No results but those that every solution has.
    pub const NONE: Results =
        Results { poses: false, velocities: false, z: false, energies: false };

    /// Everything.
    pub const ALL: Results = Results { poses: true, velocities: true, z: true, energies: true };
}
