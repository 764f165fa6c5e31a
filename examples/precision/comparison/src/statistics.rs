//! How errors spread.

use serde::Serialize;

/// Of many errors.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Spread {
    /// Half of them are below.
    pub median: f64,
    /// 99 % of them are.
    #[serde(rename = "percentile_99")]
    pub most: f64,
    /// The largest.
    pub worst: f64,
}

impl Spread {
    /// None of no errors.
    pub fn of(mut errors: Vec<f64>) -> Option<Self> {
        errors.sort_by(f64::total_cmp);
        let quantile = |part: f64| {
            let place = (part * errors.len() as f64).ceil() as usize;
            errors.get(place.saturating_sub(1)).copied()
        };
        Some(Self { median: quantile(0.5)?, most: quantile(0.99)?, worst: quantile(1.0)? })
    }
}

/// An error beside what it is an error of: nothing of nothing is none, and what is no number is
/// infinitely wrong.
pub fn relative(error: f64, size: f64) -> f64 {
    match error {
        0.0 => 0.0,
        _ if error.is_nan() => f64::INFINITY,
        _ => error / size,
    }
}

/// The decimal digits that an error leaves.
pub fn digits(error: f64) -> f64 {
    -error.clamp(f64::from(f32::EPSILON) / 2.0, 1.0).log10()
}

/// How far apart two points or vectors are.
pub fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    length([a[0] - b[0], a[1] - b[1], a[2] - b[2]])
}

/// Of a vector.
pub fn length([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

/// The largest number, at least zero; NaN if one is.
pub fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    let larger = |a: f64, b: f64| if a.is_nan() || a > b { a } else { b };
    numbers.into_iter().fold(0.0, larger)
}
