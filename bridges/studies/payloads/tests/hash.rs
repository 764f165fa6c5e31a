//! The hash of a small study is that of the same study in Python (`bridges/studies/checks/test_studies.py`), for lanes of all
//! widths and any chunks.
#![allow(missing_docs)]

use mstmm::wide::{f64x2, f64x4};
use mstmm_payloads::{RESULTS, Row, Sample, digest, simulate, summary};

/// A change of generated code may change last digits and with them the hash; both tests then get the new one.
const HASH: &str = "ff2c01cb4b5fc7872dd0ef4eb1a0e6409422c6bdb6b7be63c3f3486316672f06";

type Simulate = fn(&[Sample], u32) -> Result<Vec<[f64; RESULTS.len()]>, mstmm::Error>;

fn rows(simulate: Simulate, chunk: usize) -> Result<Vec<Row>, mstmm::Error> {
    let samples: Vec<Sample> = (0..40).map(|number| Sample::draw(7, number)).collect();
    let mut ends = Vec::new();
    for chunk in samples.chunks(chunk) {
        ends.extend(simulate(chunk, 1)?);
    }
    Ok(samples.into_iter().zip(ends).collect())
}

#[test]
fn the_hash_is_that_of_python() -> Result<(), mstmm::Error> {
    for (simulate, chunk) in
        [(simulate::<f64> as Simulate, 40), (simulate::<f64x2>, 7), (simulate::<f64x4>, 16)]
    {
        assert_eq!(digest(&rows(simulate, chunk)?), HASH);
    }
    // Another order of the results is another hash.
    let mut rows = rows(simulate::<f64>, 40)?;
    rows.swap(3, 4);
    assert_ne!(digest(&rows), HASH);
    Ok(())
}

/// Mean, quantiles and interval of the numbers 0 to 100, in closed form.
#[test]
fn statistics_are_those_of_equally_spaced_numbers() {
    let of = summary((0..=100).rev().map(f64::from)).expect("values");
    assert_eq!((of.mean, of.quantiles, of.largest), (50.0, [2.5, 95.0, 97.5], 100.0));
    // The variance of n equally spaced numbers is n (n + 1) / 12.
    let expected = 1.959_963_984_540_054 * (101.0 * 102.0 / 12.0f64).sqrt() / 101f64.sqrt();
    assert!((of.mean_error / expected - 1.0).abs() < 1e-14, "{} is not {expected}", of.mean_error);
    assert!(summary(std::iter::empty()).is_none());
}
