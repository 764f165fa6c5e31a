//! The estimated payload compared with the true one.

use std::fmt;

use anyhow::{Context, Result};
use models::{MOTION_STEPS, PAYLOAD, PAYLOAD_HEIGHT, PRIOR_DEVIATIONS, TORQUE_DEVIATION};

use crate::case::Precision;

/// Roundings of one torque by inverse dynamics: about ten for each body.
const ROUNDINGS: f64 = 80.0;

/// The results of the case `computed_torque`.
#[derive(Clone, Debug)]
pub struct Payload {
    /// The estimates and true values of the mass, the first moments and the inertia xx, yy, zz, xy, xz, yz about the
    /// input of the hand, and the tolerances.
    parameters: [Parameter; 10],
    /// The largest error of an angle in rad without the estimate, and with it.
    pub errors: [f64; 2],
}

#[derive(Clone, Copy, Debug)]
struct Parameter {
    estimate: f64,
    exact: f64,
    tolerance: f64,
}

impl Payload {
    /// Reads the bits of results.
    pub fn read(bits: &[u64], precision: Precision) -> Result<Self> {
        let numbers: Vec<f64> = bits.iter().map(|&bits| precision.number(bits)).collect();
        let (estimates, rest) = numbers.split_first_chunk::<10>().context("ten parameters")?;
        let (deviations, rest) = rest.split_first_chunk::<10>().context("ten deviations")?;
        let &[before, after, torque] = rest else { anyhow::bail!("two errors and a torque") };
        let tolerances = tolerances(deviations, torque, precision.rounding());
        let parameters = core::array::from_fn(|index| Parameter {
            estimate: estimates[index],
            exact: exact()[index],
            tolerance: tolerances[index],
        });
        Ok(Self { parameters, errors: [before, after] })
    }

    /// Returns whether the estimates are within their tolerances, and these are small compared with the payload.
    pub fn is_found(&self) -> bool {
        let [mass, ..] = self.parameters;
        let within = |p: &Parameter| (p.estimate - p.exact).abs() <= p.tolerance;
        self.parameters.iter().all(within) && mass.tolerance < mass.exact / 500.0
    }
}

/// Returns the dynamic parameters of a point mass.
fn exact() -> [f64; 10] {
    let moment = PAYLOAD * PAYLOAD_HEIGHT;
    let inertia = moment * PAYLOAD_HEIGHT;
    [PAYLOAD, 0.0, 0.0, moment, inertia, inertia, 0.0, 0.0, 0.0, 0.0]
}

/// Returns the largest errors of an estimate, from the standard deviations `d` of its parameters for torques with the
/// standard deviation `σ`.
///
/// Least squares errs by `(YᵀY)⁻¹ Yᵀ δ` for errors `δ` of the torques, of which entry `j` is at most `|δ| d_j / σ`. There are
/// 7 n torques for n samples. The unit roundoff `u` changes each torque by `80 u` of the largest. Each entry of the
/// triangle is rotated 7 n times with three roundings, which add up like independent errors, so these have the effect of
/// torques that err by `√(21 n) u`. The prior with the deviations `D` changes parameter `j` by
/// `Σ (YᵀY)⁻¹_ji σ² x_i / D_i²`, which is at most `d_j Σ d_i |x_i| / D_i²`.
fn tolerances(deviations: &[f64; 10], torque: f64, roundoff: f64) -> [f64; 10] {
    let samples = MOTION_STEPS as f64;
    let one = (ROUNDINGS + (21.0 * samples).sqrt()) * roundoff * torque;
    let all = (7.0 * samples).sqrt() * one / TORQUE_DEVIATION;
    let of_prior =
        |index: usize| deviations[index] * exact()[index].abs() / PRIOR_DEVIATIONS[index].powi(2);
    let prior: f64 = (0..10).map(of_prior).sum();
    deviations.map(|deviation| deviation * (all + prior))
}

impl fmt::Display for Payload {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [mass, _, _, moment, ..] = self.parameters;
        let [before, after] = self.errors;
        write!(f, "payload of {mass} kg with the first moment {moment} kg m; ")?;
        write!(f, "errors {before:.1e} rad before the model has it, {after:.1e} rad after")
    }
}

impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { estimate, exact, tolerance } = self;
        write!(f, "{estimate} (exact {exact}, tolerance {tolerance:.1e})")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Results in single precision with an error of the mass.
    fn with_error(error: f64) -> Payload {
        let mut numbers = exact().to_vec();
        numbers[0] += error;
        numbers.extend([3e-4; 10]);
        numbers.extend([0.1, 1e-4, 60.0]);
        let bits: Vec<u64> = numbers.iter().map(|&x| u64::from((x as f32).to_bits())).collect();
        Payload::read(&bits, Precision::Single).expect("all results are there")
    }

    #[test]
    fn a_wrong_mass_is_not_found() {
        assert!(with_error(0.0).is_found());
        assert!(!with_error(0.01).is_found());
        assert!(!with_error(f64::NAN).is_found());
    }

    #[test]
    fn results_without_a_number_are_none() {
        assert!(Payload::read(&[0; 22], Precision::Double).is_err());
    }
}
