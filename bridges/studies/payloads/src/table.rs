//! The results of a study: their hash, and statistics.

use crate::Sample;
use sha2::{Digest, Sha256};

/// The names of the numbers drawn.
pub const DRAWN: [&str; 14] = [
    "mass", "x", "y", "z", "edge_x", "edge_y", "edge_z", "start_1", "start_2", "start_3",
    "start_4", "start_5", "start_6", "start_7",
];

/// The names of the results: the distance of the flange from its target at the end, and its height above it, in m.
pub const RESULTS: [&str; 2] = ["distance", "height"];

/// A sample with its results.
pub type Row = (Sample, [f64; RESULTS.len()]);

/// Returns the SHA-256 of all names and all bits, as `mstmm_studies.digest` does: for each name in alphabetic order the
/// name, then its values, and `sample` is the number of the row.
#[must_use]
pub fn digest(rows: &[Row]) -> String {
    let mut names: Vec<&str> = DRAWN.into_iter().chain(RESULTS).chain(["sample"]).collect();
    names.sort_unstable();
    let mut hash = Sha256::new();
    for name in names {
        hash.update(name);
        let place = |list: &[&str]| list.iter().position(|it| *it == name);
        let (drawn, result) = (place(&DRAWN), place(&RESULTS));
        for (number, (sample, results)) in rows.iter().enumerate() {
            hash.update(match (drawn, result) {
                (Some(index), _) => sample.values()[index].to_le_bytes(),
                (_, Some(index)) => results[index].to_le_bytes(),
                _ => (number as u64).to_le_bytes(),
            });
        }
    }
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The distribution of a result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary {
    /// The mean.
    pub mean: f64,
    /// Half the width of the 95 % interval of the mean.
    pub mean_error: f64,
    /// The 2.5 %, 95 % and 97.5 % quantiles.
    pub quantiles: [f64; 3],
    /// The largest value.
    pub largest: f64,
}

/// Returns the distribution of a result; `None` without values.
#[must_use]
pub fn summary(values: impl Iterator<Item = f64>) -> Option<Summary> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    let deviation = (squares / (count - 1.0).max(1.0)).sqrt();
    // Between the two nearest values, as numpy's `quantile`.
    let quantile = |part: f64| {
        let place = part * (count - 1.0);
        let [low, high] =
            [place.floor(), place.ceil()].map(|place| values.get(place as usize).copied());
        Some(low? + (high? - low?) * place.fract())
    };
    let quantiles = [quantile(0.025)?, quantile(0.95)?, quantile(0.975)?];
    let mean_error = 1.959_963_984_540_054 * deviation / count.sqrt();
    Some(Summary { mean, mean_error, quantiles, largest: *values.last()? })
}
