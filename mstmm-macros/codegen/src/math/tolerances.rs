//! Tolerances for zero, in units in the last place of a scale. The runtime defines the same
//! constants for generated code.

/// For a pivot: a pivot that should vanish is the difference of a few rounded products of the size
/// of its scale.
pub const PIVOT_ULPS: f64 = 8.0;

/// For [`Scalar::recip_above`](super::Scalar::recip_above): rows of dependent constraints contain
/// the rounding errors of many operations.
pub const RANK_ULPS: f64 = 1024.0;

#[cfg(test)]
mod tests {
    use mstmm_runtime::generated;

    #[test]
    fn the_runtime_has_the_same_tolerances() {
        assert_eq!(
            (super::PIVOT_ULPS, super::RANK_ULPS),
            (generated::PIVOT_ULPS, generated::RANK_ULPS)
        );
    }
}
