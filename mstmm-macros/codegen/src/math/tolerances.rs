//! From where on a number counts as zero, in units in the last place of its scale. Generated code
//! judges by the same numbers, which the runtime has of its own.

/// A pivot: one that should vanish is the difference of a few rounded products of the size of its
/// scale.
pub const PIVOT_ULPS: f64 = 8.0;

/// A number of which equations ask with [`Scalar::recip_above`](super::Scalar::recip_above): rows
/// of a closure that hang on others leave the rounding of many operations.
pub const RANK_ULPS: f64 = 1024.0;

#[cfg(test)]
mod tests {
    use mstmm_runtime::generated;

    #[test]
    fn the_runtime_judges_by_the_same_numbers() {
        assert_eq!(
            (super::PIVOT_ULPS, super::RANK_ULPS),
            (generated::PIVOT_ULPS, generated::RANK_ULPS)
        );
    }
}
