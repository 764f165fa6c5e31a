//! The values of a page: 16 bits over the range of each column, as differences, compressed by zlib.
//!
//! A quantised column is replaced by its differences of the order, from zero to four, that needs the fewest bits, modulo
//! 2¹⁶. The low bytes of all columns precede the high bytes, which are nearly all zero.

use flate2::Compression;
use flate2::write::ZlibEncoder;
use serde_json::{Value, json};
use std::collections::HashMap;
use std::io::{self, Write};

/// The number of steps of a range.
const STEPS: f64 = 65535.0;
/// The largest order of differences.
const ORDERS: usize = 4;

/// The encoded columns.
#[derive(Debug, Default)]
pub struct Encoder {
    frames: usize,
    low: Vec<u8>,
    high: Vec<u8>,
    stored: usize,
    /// The columns by their bits, because inputs and outputs that coincide have the same values.
    seen: HashMap<Vec<u64>, Value>,
}

/// How a page finds the values of a column.
impl Encoder {
    /// Makes an encoder of columns with this number of values.
    pub fn new(frames: usize) -> Self {
        Encoder { frames, ..Encoder::default() }
    }

    /// Adds a column and returns how the page finds its values: a constant, `first` and `step` of equal steps, or the
    /// number among the stored columns with lowest value, step and order of the differences.
    ///
    /// # Errors
    /// If a value or the range is not finite.
    pub fn add(&mut self, name: &str, values: &[f64]) -> io::Result<Value> {
        let low = values.iter().copied().fold(f64::INFINITY, f64::min);
        let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let is_finite = values.iter().all(|value| value.is_finite()) && (high - low).is_finite();
        if !is_finite {
            let message =
                format!("`{name}` has a value that is not finite, which a page cannot show");
            return Err(io::Error::new(io::ErrorKind::InvalidData, message));
        }
        if low == high {
            return Ok(json!({ "constant": low }));
        }
        let bits: Vec<u64> = values.iter().map(|value| value.to_bits()).collect();
        if let Some(same) = self.seen.get(&bits) {
            return Ok(same.clone());
        }
        let found = match equal_steps(values) {
            Some([first, step]) => json!({ "first": first, "step": step }),
            None => self.store(values, low, (high - low) / STEPS),
        };
        self.seen.insert(bits, found.clone());
        Ok(found)
    }

    fn store(&mut self, values: &[f64], low: f64, step: f64) -> Value {
        let quantised = quantised(values, low, step);
        let (order, differences) = best_differences(quantised);
        self.low.extend(differences.iter().map(|value| value.to_le_bytes()[0]));
        self.high.extend(differences.iter().map(|value| value.to_le_bytes()[1]));
        self.stored += 1;
        json!({ "stored": self.stored - 1, "low": low, "step": step, "order": order })
    }

    /// Returns the number of stored columns.
    pub fn stored(&self) -> usize {
        self.stored
    }

    /// Returns the compressed bytes of all stored columns.
    pub fn finish(self) -> io::Result<Vec<u8>> {
        debug_assert_eq!(self.low.len(), self.stored * self.frames);
        let mut zlib = ZlibEncoder::new(Vec::new(), Compression::default());
        zlib.write_all(&self.low)?;
        zlib.write_all(&self.high)?;
        zlib.finish()
    }
}

/// Returns the multiples of the step that are nearest to the values, counted from the lowest one.
fn quantised(values: &[f64], low: f64, step: f64) -> Vec<u16> {
    let steps = |value: f64| ((value - low) / step).round().clamp(0.0, STEPS);
    // The value is an integer of 16 bits.
    values.iter().map(|value| steps(*value) as u16).collect()
}

/// Returns first value and step if the values have equal steps up to rounding, as the time often has.
fn equal_steps(values: &[f64]) -> Option<[f64; 2]> {
    let (first, last) = (*values.first()?, *values.last()?);
    let step = (last - first) / (values.len() - 1) as f64;
    let near = 1e-9 * step.abs();
    let mut expected = (0..).map(|index| first + f64::from(index) * step);
    let are_equal = values
        .iter()
        .all(|value| expected.next().is_some_and(|expected| (value - expected).abs() <= near));
    are_equal.then_some([first, step])
}

/// Returns the order of the differences with the fewest bits, and the differences with their sign in the last bit.
fn best_differences(mut values: Vec<u16>) -> (usize, Vec<u16>) {
    let mut best = (u64::MAX, 0, Vec::new());
    for order in 0..=ORDERS {
        let folded: Vec<u16> = values.iter().map(|value| fold(*value)).collect();
        let bits = folded.iter().map(|value| u64::from(16 - value.leading_zeros())).sum();
        if bits < best.0 {
            best = (bits, order, folded);
        }
        let mut before = 0;
        for value in &mut values {
            (*value, before) = (value.wrapping_sub(before), *value);
        }
    }
    (best.1, best.2)
}

/// Maps 0, −1, 1, −2, … modulo 2¹⁶ to 0, 1, 2, 3, …
fn fold(value: u16) -> u16 {
    let sign = if value >> 15 == 1 { u16::MAX } else { 0 };
    (value << 1) ^ sign
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::read::ZlibDecoder;
    use std::io::Read;

    /// Reads columns as the page does.
    fn decoded(frames: usize, bytes: &[u8], columns: &[Value]) -> Vec<Vec<f64>> {
        let mut planes = Vec::new();
        ZlibDecoder::new(bytes).read_to_end(&mut planes).expect("bytes of zlib");
        let (low, high) = planes.split_at(planes.len() / 2);
        let number = |column: &Value, key: &str| column[key].as_f64();
        let read = |column: &Value| -> Vec<f64> {
            if let Some(constant) = number(column, "constant") {
                return vec![constant; frames];
            }
            let step = number(column, "step").expect("a step");
            if let Some(first) = number(column, "first") {
                return (0..frames).map(|index| first + index as f64 * step).collect();
            }
            let start = column["stored"].as_u64().expect("an index") as usize * frames;
            let mut values: Vec<u16> = (start..start + frames)
                .map(|index| u16::from_le_bytes([low[index], high[index]]))
                .map(|value| (value >> 1) ^ (value & 1).wrapping_neg())
                .collect();
            for _ in 0..column["order"].as_u64().expect("an order") {
                let mut sum = 0u16;
                for value in &mut values {
                    sum = sum.wrapping_add(*value);
                    *value = sum;
                }
            }
            let low = number(column, "low").expect("a lowest value");
            values.into_iter().map(|value| low + f64::from(value) * step).collect()
        };
        columns.iter().map(read).collect()
    }

    /// A value is off by half a step, plus the rounding of the division and of the way back: a few units in the last
    /// place of the range and of the value.
    #[test]
    fn values_are_off_by_half_a_step() {
        let frames = 3000;
        let time = |index: usize| index as f64 * 1e-3;
        let of = |f: &dyn Fn(usize) -> f64| (0..frames).map(f).collect::<Vec<f64>>();
        let noise = |index: usize| ((index * 48271 % 65537) as f64 * 0.618_033_988_7).fract();
        let columns = [
            of(&time),
            of(&|_| 42.5),
            of(&|index| (7.0 * time(index)).sin()),
            of(&|index| 1e9 + 1e6 * (3.0 * time(index)).cos().powi(5)),
            of(&|index| -1e-12 * noise(index)),
            of(&|index| if index < 1500 { -1.0 } else { 1.0 }),
            of(&|index| 1e300 * noise(index + 1)),
            of(&|index| (7.0 * time(index)).sin()),
        ];
        let mut encoder = Encoder::new(frames);
        let added: Vec<Value> =
            columns.iter().map(|values| encoder.add("x", values).expect("finite values")).collect();
        assert_eq!(added[7], added[2], "equal columns are stored once");
        assert_eq!(encoder.stored(), 5);
        let bytes = encoder.finish().expect("memory");
        for (column, (found, values)) in
            decoded(frames, &bytes, &added).iter().zip(&columns).enumerate()
        {
            let high = values.iter().copied().fold(f64::MIN, f64::max);
            let low = values.iter().copied().fold(f64::MAX, f64::min);
            let largest = high.abs().max(low.abs());
            let bound = 0.5 * (high - low) / STEPS + 8.0 * f64::EPSILON * largest;
            for (found, value) in found.iter().zip(values) {
                assert!((found - value).abs() <= bound, "column {column}: {found} is not {value}");
            }
        }
    }

    #[test]
    fn values_that_are_not_finite_are_refused() {
        for wrong in [f64::NAN, f64::INFINITY] {
            let error = Encoder::new(2).add("rod.force.x", &[0.0, wrong]).expect_err("an error");
            assert!(error.to_string().contains("`rod.force.x`"), "{error}");
        }
        assert!(Encoder::new(2).add("x", &[-1e308, 1e308]).is_err());
    }

    #[test]
    fn folding_keeps_small_values_small() {
        let folded = [0, u16::MAX, 1, u16::MAX - 1, 2].map(fold);
        assert_eq!(folded, [0, 1, 2, 3, 4]);
    }
}
