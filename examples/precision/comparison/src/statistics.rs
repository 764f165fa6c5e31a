//! The distribution of errors.

use serde::Serialize;

/// Quantiles of many errors.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Spread {
    /// Half of the errors are below.
    pub median: f64,
    /// 99 % of the errors are below.
    #[serde(rename = "percentile_99")]
    pub most: f64,
    /// The largest error.
    pub worst: f64,
}

impl Spread {
    /// Returns the quantiles, none if there are no errors.
    pub fn of(mut errors: Vec<f64>) -> Option<Self> {
        errors.sort_by(f64::total_cmp);
        let quantile = |part: f64| {
            let rank = (part * errors.len() as f64).ceil() as usize;
            errors.get(rank.saturating_sub(1)).copied()
        };
        Some(Self { median: quantile(0.5)?, most: quantile(0.99)?, worst: quantile(1.0)? })
    }
}

/// Returns an error relative to a size: zero for a zero error, and infinity for NaN.
pub fn relative(error: f64, size: f64) -> f64 {
    match error {
        0.0 => 0.0,
        _ if error.is_nan() => f64::INFINITY,
        _ => error / size,
    }
}

/// Returns the number of correct decimal digits for a relative error.
pub fn digits(error: f64) -> f64 {
    -error.clamp(f64::from(f32::EPSILON) / 2.0, 1.0).log10()
}

/// Returns the distance between two points or vectors.
pub fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    length([a[0] - b[0], a[1] - b[1], a[2] - b[2]])
}

/// Returns the length of a vector.
pub fn length([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

/// Returns the largest number, at least zero; NaN if one is NaN.
pub fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    let larger = |a: f64, b: f64| if a.is_nan() || a > b { a } else { b };
    numbers.into_iter().fold(0.0, larger)
}
