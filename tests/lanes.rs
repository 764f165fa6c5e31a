//! Chains in SIMD lanes: every lane has exactly the bits of the same chain alone, with the same state,
//! parameters and inputs. A decision for all lanes is that of the worst lane.

mod lanes {
    mod bits;
    mod chains;
    mod native;
    mod numbers;
    mod operations;
    mod sample;
    mod worst;
}
