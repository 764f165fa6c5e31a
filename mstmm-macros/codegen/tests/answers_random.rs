//! The answers of random chains and trees: identities between them, and comparisons with a reference that computes them by
//! their definitions in twice the precision.

mod common;

mod answers_random {
    pub mod coriolis;
    pub mod differences;
    pub mod efforts;
    pub mod gradients;
    pub mod homogeneity;
    pub mod laws;
    pub mod matrices;
    pub mod products;
    pub mod samples;
    pub mod workspaces;
}

use answers_random::{differences, products, samples};
