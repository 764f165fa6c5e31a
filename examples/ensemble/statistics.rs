//! The distribution of a quantity over all arms.

use serde::Serialize;

/// Half the width of the 95 % interval of a normal distribution, in standard errors.
const NORMAL_95: f64 = 1.96;

/// The mean and the range of 95 % of the values.
#[derive(Debug, Serialize)]
pub struct Spread {
    pub mean: f64,
    /// Half the width of the 95 % confidence interval of the mean.
    pub mean_error: f64,
    /// The 2.5 % and 97.5 % quantiles.
    pub low: f64,
    pub high: f64,
    pub largest: f64,
}

impl Spread {
    pub fn of(values: impl Iterator<Item = f64>) -> Result<Self, &'static str> {
        let mut values: Vec<f64> = values.collect();
        values.sort_by(f64::total_cmp);
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
        let deviation = (squares / (count - 1.0).max(1.0)).sqrt();
        let quantile = |part: f64| values.get((part * (count - 1.0)).round() as usize).copied();
        let ends = (quantile(0.025), quantile(0.975), values.last());
        let (Some(low), Some(high), Some(&largest)) = ends else { return Err("no arms") };
        Ok(Self { mean, mean_error: NORMAL_95 * deviation / count.sqrt(), low, high, largest })
    }

    /// Converts m to mm.
    pub fn in_millimetres(&self) -> Self {
        let [mean, mean_error, low, high, largest] =
            [self.mean, self.mean_error, self.low, self.high, self.largest].map(|way| 1e3 * way);
        Self { mean, mean_error, low, high, largest }
    }
}
