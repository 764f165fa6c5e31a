//! What a chain's solution says.

/// What `solve_into` computes beside accelerations, efforts and, of a closed chain, its closure.
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
