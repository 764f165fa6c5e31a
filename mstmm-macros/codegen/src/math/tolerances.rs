//! Tolerances and limits. The runtime defines the same constants for generated code.

/// For a pivot, in units in the last place of its scale: a pivot that should vanish is the difference
/// of a few rounded products of the size of its scale.
pub const PIVOT_ULPS: f64 = 8.0;

/// For [`Scalar::recip_above`](super::Scalar::recip_above), in units in the last place: rows of
/// dependent constraints contain the rounding errors of many operations.
pub const RANK_ULPS: f64 = 1024.0;

/// The largest number of corrections until a closed chain is assembled.
pub const CORRECTIONS: u32 = 50;

/// The largest rotation of a hinge by one correction, in rad. Near a pose where its links are in line,
/// Newton's method asks for rotations by many turns.
pub const LARGEST_ROTATION: f64 = 0.5;

#[cfg(test)]
mod tests {
    use mstmm_runtime::generated;

    #[test]
    fn the_runtime_has_the_same_tolerances() {
        assert_eq!(
            [super::PIVOT_ULPS, super::RANK_ULPS, super::LARGEST_ROTATION],
            [generated::PIVOT_ULPS, generated::RANK_ULPS, generated::LARGEST_ROTATION]
        );
        assert_eq!(super::CORRECTIONS, generated::CORRECTIONS);
    }
}
