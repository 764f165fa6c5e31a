//! Identifies the dynamic parameters of a robot arm from a motion and noisy torques.
//!
//! `cargo run --release --example identify`; with `-- --page identify.html` it also writes a page that shows the motion.

mod page;
mod plot;

use std::f64::consts::TAU;

use mstmm::linear::solve_positive_definite;
use mstmm::nalgebra::{SMatrix, SVector};
use mstmm::prelude::*;
use page::Page;
use plot::Plot;

include!("panda.rs");

panda! {
    /// The Franka Emika Panda with viscous friction in its joints.
    pub chain Arm {
        bodies { answers = [inverse_dynamics, regressor]; }
        hinges {
            hinge j1, j2, j3, j4, j5, j6, j7 { damping = 0.5 N*m*s/rad; armature = 0.1 kg*m^2; }
        }
    }
}

type Joints = SVector<f64, 7>;

/// The number of base parameters: those that the torques depend on.
const BASE: usize = Arm::<f64>::BASE_PARAMETERS.len();
/// The rows of the regressor for these parameters.
type Rows = SMatrix<f64, 7, BASE>;

/// Standard deviation of the measured torques in N m.
const NOISE: f64 = 0.5;

/// Random numbers (SplitMix64).
struct Random(u64);

impl Random {
    /// Returns a number between 0 and 1.
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Returns a normally distributed number with mean 0 and standard deviation 1.
    fn normal(&mut self) -> f64 {
        (-2.0 * (1.0 - self.uniform()).ln()).sqrt() * (TAU * self.uniform()).cos()
    }
}

/// A periodic motion of all joints: sums of sines with random phases.
struct Motion([[f64; 5]; 7]);

impl Motion {
    fn random(seed: u64) -> Self {
        let mut random = Random(seed);
        Self([(); 7].map(|()| [(); 5].map(|()| TAU * random.uniform())))
    }

    /// Returns angles, rates and accelerations; the period is 10 s.
    fn at(&self, time: f64) -> [Joints; 3] {
        let mut motion = [Joints::zeros(); 3];
        for (joint, phases) in self.0.iter().enumerate() {
            for (harmonic, phase) in phases.iter().enumerate() {
                let omega = (1.0 + harmonic as f64) * TAU / 10.0;
                let (sine, cosine) = (omega * time + phase).sin_cos();
                motion[0][joint] += 0.4 * sine;
                motion[1][joint] += 0.4 * omega * cosine;
                motion[2][joint] -= 0.4 * omega * omega * sine;
            }
        }
        motion
    }
}

/// Returns the rows of the regressor and the exact torques at a time of a motion.
fn sample(arm: &Arm<f64>, motion: &Motion, time: f64) -> Result<(Rows, Joints), mstmm::Error> {
    let mut state = arm.initial_state();
    let accelerations;
    [state.q, state.v, accelerations] = motion.at(time);
    let regressor = arm.regressor(&state, &accelerations, &arm.no_inputs())?;
    let torques = arm.inverse_dynamics(&state, &accelerations, &arm.no_inputs())?;
    let base = Arm::<f64>::BASE_PARAMETERS;
    Ok((Rows::from_fn(|row, column| regressor[(row, base[column])]), torques))
}

/// Runs the study and returns its picture.
fn study() -> Result<Plot, mstmm::Error> {
    let arm = Arm::<f64>::new();
    let (motion, mut random) = (Motion::random(1), Random(2));

    // Least squares over 10 s at 100 Hz: once with noisy torques, once with exact ones for comparison.
    let mut normal = SMatrix::<f64, BASE, BASE>::zeros();
    let mut right = SMatrix::<f64, BASE, 2>::zeros();
    let mut page = Page::of(&arm, 2);
    for step in 0..1000 {
        let (rows, exact) = sample(&arm, &motion, 0.01 * step as f64)?;
        let mut state = arm.initial_state();
        [state.q, state.v, _] = motion.at(0.01 * step as f64);
        state.set_time(0.01 * step as f64);
        let [j1, j2, j3, j4, j5, j6, j7] = exact.into();
        page.record(&state, &ArmInputs { j1, j2, j3, j4, j5, j6, j7 })?;
        let measured = exact + Joints::from_fn(|_, _| NOISE * random.normal());
        normal += rows.tr_mul(&rows);
        right += rows.tr_mul(&SMatrix::from_columns(&[measured, exact]));
    }
    page.write();
    let identity = SMatrix::<f64, BASE, BASE>::identity();
    let covariance = solve_positive_definite(&normal, &identity)? * NOISE.powi(2);
    let parameters = solve_positive_definite(&normal, &right)?;
    let (found, exact) = (parameters.column(0), parameters.column(1));

    // The error of no base parameter exceeds four standard errors: that of a normal distribution does once in 300 runs.
    // An arm with seven pins has 43 for its masses (Gaz et al. 2019); the other twelve are five rotors and the dampers.
    assert_eq!(BASE, 43 + 5 + 7);
    println!("{:24} {:>9} {:>9} {:>9}", "base parameter with", "found", "exact", "std. err.");
    let mut sum = 0.0;
    for (row, &index) in Arm::<f64>::BASE_PARAMETERS.iter().enumerate() {
        let deviation = covariance[(row, row)].sqrt();
        let name = Arm::<f64>::DYNAMIC_PARAMETERS[index];
        println!("{name:24} {:9.4} {:9.4} {deviation:9.4}", found[row], exact[row]);
        assert!((found[row] - exact[row]).abs() < 4.0 * deviation, "{name}");
        sum += ((found[row] - exact[row]) / deviation).powi(2);
    }
    println!("errors {:.2} standard errors (root mean square)", (sum / BASE as f64).sqrt());

    // The parameters predict the torques of another motion, with errors below the noise.
    let other = Motion::random(3);
    let (mut squares, mut measured, mut predicted) = (0.0, Vec::new(), Vec::new());
    for step in 0..500 {
        let time = 0.02 * step as f64;
        let (rows, exact) = sample(&arm, &other, time)?;
        let prediction = rows * found;
        squares += (prediction - exact).norm_squared();
        measured.push([time, exact[3] + NOISE * random.normal()]);
        predicted.push([time, prediction[3]]);
    }
    let error = (squares / 3500.0).sqrt();
    println!("error of the predicted torques {error:.3} N m, noise {NOISE} N m");
    assert!(error < NOISE / 3.0);

    Ok(Plot::new("Torques of joint 4 in another motion", ["time in s", "torque in N m"])
        .curve("measured", measured)
        .curve("predicted", predicted))
}

fn main() -> Result<(), mstmm::Error> {
    study()?.save("identify");
    Ok(())
}

#[test]
fn base_parameters_are_found() -> Result<(), mstmm::Error> {
    study()?.check("identify");
    Ok(())
}
