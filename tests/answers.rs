//! `answers = […]`: generated methods against identities between them, in both precisions and in lanes.

mod answers {
    pub mod asked;
    pub mod chains;
    mod identities;
    mod lanes;
    mod tangents;
}
#[path = "lanes/numbers.rs"]
#[allow(dead_code)]
mod numbers;
#[path = "lanes/sample.rs"]
#[allow(dead_code)]
mod sample;
