//! The Coriolis matrix.
//!
//! The pose of a body is the 3×4 matrix `T = [R x]`, and rate `k` alone changes it by `A_k`. A mass at `r` in
//! the body's frame has the velocity `A_k [r; 1]` at this rate, whose time derivative along the motion is
//! `Ȧ_k [r; 1]`. With the second moments `P = ∫ [r; 1] [r; 1]ᵀ dm` of a body (J. J. Uicker),
//!
//! ```text
//! C_ij = Σ tr(A_i P Ȧ_jᵀ)
//! ```
//!
//! `Ȧ` follows from central differences along the motion, in which prescribed hinges and frames take part.

use super::differences::derivative;
use super::graph::{Moves, poses};
use super::hinge::coordinate_rates;
use super::inertial_parameters::Matter;
use super::passive::strain_columns;
use super::{Answers, Now, Real, floats, reals};

/// The derivative of a body's pose, by rows.
type PoseRate = [[Real; 4]; 3];

impl Answers<'_> {
    /// Returns the Coriolis matrix row by row, including the inertias of rotors.
    pub fn coriolis_matrix(&self) -> Vec<Vec<f64>> {
        let here = self.pose_rates(&self.now);
        let ahead = |step| self.pose_rates(&self.along_motion(step)).concat().concat().concat();
        let changes = derivative(ahead);
        let moments: Vec<[[Real; 4]; 4]> = self.now.matter.iter().map(second_moments).collect();
        let mut changes = changes.chunks(12);
        let count = here.len();
        let mut matrix = vec![vec![Real::new(0.0); count]; count];
        for column in 0..count {
            for (body, moments) in moments.iter().enumerate() {
                let Some(change) = changes.next() else { panic!("twelve entries for each body") };
                for (row, entry) in matrix.iter_mut().enumerate() {
                    entry[column] += trace(&here[row][body], moments, change);
                }
            }
        }
        self.add_rotors(&mut matrix);
        matrix.iter().map(|row| floats(row)).collect()
    }

    /// Returns the derivatives of the poses of all bodies at unit rates, by rates.
    fn pose_rates(&self, now: &Now) -> Vec<Vec<PoseRate>> {
        let rest = reals(&vec![0.0; now.v.len()]);
        let column = |k: usize| {
            let mut rates = rest.clone();
            rates[k] = Real::new(1.0);
            let moves = Moves { rates: &rates, accelerations: &rest, prescribed: false };
            let poses = poses(&self.mechanism, self.closing, now, moves);
            let rate = |pose: &super::Pose| -> PoseRate {
                std::array::from_fn(|row| {
                    let [x, y, z] = pose.rotation[row].map(|entry| entry.rate);
                    [x, y, z, pose.position[row].rate]
                })
            };
            poses.iter().map(rate).collect()
        };
        (0..rest.len()).map(column).collect()
    }

    /// Returns the coordinates after a short time, to first order.
    fn along_motion(&self, time: Real) -> Now {
        let now = &self.now;
        let mut moved = Now { time, q: self.moved(now, &floats(&now.v), time), ..now.clone() };
        for (joint, motion) in self.mechanism.joints.iter().zip(&mut moved.prescribed) {
            if let Some(motion) = motion {
                let change = coordinate_rates(joint.kind(), &motion.q, &motion.v);
                motion.q.iter_mut().zip(change).for_each(|(q, change)| *q += time * change);
            }
        }
        moved
    }

    /// Adds `Jᵀ R J̇` of all hinges, with the strains' rates `J v` and the rotor inertias `R`.
    fn add_rotors(&self, matrix: &mut [Vec<Real>]) {
        for (number, joint) in self.mechanism.joints.iter().enumerate() {
            if joint.prescribed.is_some() {
                continue;
            }
            let columns = |now: &Now| {
                let none = reals(&vec![0.0; now.v.len()]);
                let still = Moves { rates: &none, accelerations: &none, prescribed: false };
                let motion = super::joint_motion(&self.mechanism, number, now, still);
                strain_columns(joint.hinge, &motion)
            };
            let here = columns(&self.now);
            let changes = derivative(|step| columns(&self.along_motion(step)).concat());
            let first = joint.first_rate;
            for (row, strain) in here.iter().enumerate() {
                for (column, change) in changes.chunks(here.len().max(1)).enumerate() {
                    let armature = super::passive::armature(joint.hinge);
                    let terms = strain.iter().zip(change).zip(armature);
                    let sum = terms.fold(Real::new(0.0), |sum, ((&a, &b), c)| sum + a * b * c);
                    matrix[first + row][first + column] += sum;
                }
            }
        }
    }
}

/// Returns `∫ [r; 1] [r; 1]ᵀ dm`.
fn second_moments(matter: &Matter) -> [[Real; 4]; 4] {
    let inertia = &matter.inertia;
    let half = (inertia[0][0] + inertia[1][1] + inertia[2][2]) * Real::new(0.5);
    std::array::from_fn(|i| {
        std::array::from_fn(|j| match [i, j] {
            [3, 3] => matter.mass,
            [3, k] | [k, 3] => matter.moment[k],
            [i, j] if i == j => half - inertia[i][j],
            [i, j] => -inertia[i][j],
        })
    })
}

/// Returns `tr(A P Bᵀ)`.
fn trace(a: &PoseRate, moments: &[[Real; 4]; 4], b: &[Real]) -> Real {
    let mut sum = Real::new(0.0);
    for (row, b) in a.iter().zip(b.chunks(4)) {
        for (entry, moments) in row.iter().zip(moments) {
            for (&moment, &change) in moments.iter().zip(b) {
                sum += *entry * moment * change;
            }
        }
    }
    sum
}
