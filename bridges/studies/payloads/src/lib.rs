//! The study of payloads in Rust: how far from its target does a Panda stop whose controller does not know its payload?
//!
//! `bridges/studies/payloads.py` is the same study in Python. Sample number i has the random numbers of numpy's
//! `default_rng([seed, i])`, and all results have the same bits, so the hash is the same. The example `ensemble` runs
//! this study on one machine, `bridges/studies/mpi` on many.

mod arm;
mod lanes;
mod numpy;
mod table;

pub use arm::{LoadedPanda, STEP, STEPS, simulate};
pub use lanes::Lanes;
pub use numpy::Generator;
pub use table::{DRAWN, RESULTS, Row, Summary, digest, summary};

/// A sample: the numbers drawn, in the order of [`DRAWN`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Mass of the payload in kg.
    pub mass: f64,
    /// Centre of the box from the middle of the flange, in m.
    pub centre: [f64; 3],
    /// Edge lengths of the box in m.
    pub edges: [f64; 3],
    /// Start angles relative to the target in rad.
    pub start: [f64; 7],
}

impl Sample {
    /// Draws a sample of a study; it depends on the seed and its number only.
    #[must_use]
    pub fn draw(seed: u64, number: u64) -> Self {
        let mut random = Generator::new(&[seed, number]);
        let mut between = |low, high| random.uniform(low, high);
        Sample {
            mass: between(0.1, 3.0),
            centre: [between(-0.05, 0.05), between(-0.05, 0.05), between(0.0, 0.1)],
            edges: [(); 3].map(|()| between(0.05, 0.3)),
            start: [(); 7].map(|()| between(-0.3, 0.3)),
        }
    }

    /// Returns the numbers in the order of [`DRAWN`].
    #[must_use]
    pub fn values(&self) -> [f64; DRAWN.len()] {
        let Sample { mass, centre: [x, y, z], edges: [a, b, c], start } = *self;
        let [j1, j2, j3, j4, j5, j6, j7] = start;
        [mass, x, y, z, a, b, c, j1, j2, j3, j4, j5, j6, j7]
    }
}
