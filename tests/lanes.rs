//! Chains in lanes of SIMD registers: every lane has exactly the bits that the same chain has alone, in
//! the same state with the same parameters and inputs; and where a single decision is taken for all
//! lanes, the worst one takes it.

mod lanes {
    mod bits;
    mod chains;
    mod native;
    mod numbers;
    mod operations;
    mod sample;
    mod worst;
}
