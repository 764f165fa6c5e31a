//! What can be asked of a chain: each answer is one function of the generated code.

/// A function of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Answer {
    /// Accelerations of all hinges.
    Accelerations,
    /// Accelerations of a linearly implicit step.
    ImplicitAccelerations,
    /// Everything that `results` names.
    Solution,
    /// Kinetic and potential energy.
    Energy,
    /// Time derivatives of the coordinates.
    CoordinateRates,
    /// Coordinates with quaternions of unit length.
    Normalized,
    /// Coordinates and rates put back onto the closure.
    Correction,
    /// The pivots that tell the rank of the closure.
    ClosurePivots,
    /// The state that a simulation starts from.
    Start,
    /// Efforts that drives must supply so that no rate changes.
    BiasEfforts,
}

impl Answer {
    /// All of them, in the order in which they are computed: new ones go last, so that the text of the others
    /// stays as it is.
    pub const ALL: [Answer; 10] = [
        Answer::Accelerations,
        Answer::ImplicitAccelerations,
        Answer::Solution,
        Answer::Energy,
        Answer::CoordinateRates,
        Answer::Normalized,
        Answer::Correction,
        Answer::ClosurePivots,
        Answer::Start,
        Answer::BiasEfforts,
    ];

    /// Its name in texts for people.
    pub fn name(self) -> &'static str {
        match self {
            Answer::Accelerations => "accelerations",
            Answer::ImplicitAccelerations => "implicit_accelerations",
            Answer::Solution => "solution",
            Answer::Energy => "energy",
            Answer::CoordinateRates => "coordinate_rates",
            Answer::Normalized => "normalized",
            Answer::Correction => "correction",
            Answer::ClosurePivots => "closure_pivots",
            Answer::Start => "start",
            Answer::BiasEfforts => "bias_efforts",
        }
    }

    /// The word that asks for it in `answers = […];`; none for what every chain answers that can.
    pub fn word(self) -> Option<&'static str> {
        match self {
            Answer::BiasEfforts => Some(self.name()),
            Answer::Accelerations
            | Answer::ImplicitAccelerations
            | Answer::Solution
            | Answer::Energy
            | Answer::CoordinateRates
            | Answer::Normalized
            | Answer::Correction
            | Answer::ClosurePivots
            | Answer::Start => None,
        }
    }
}
