//! Masses and their sums.

use nalgebra::{Matrix3, Vector3};

use super::frame::Frame;

/// A mass, its centre, and its inertia tensor about the centre.
#[derive(Clone, Debug, PartialEq)]
pub struct Mass {
    /// In kg.
    pub mass: f64,
    /// In m.
    pub com: Vector3<f64>,
    /// In kg m².
    pub tensor: Matrix3<f64>,
}

impl Mass {
    pub fn none() -> Self {
        Mass { mass: 0.0, com: Vector3::zeros(), tensor: Matrix3::zeros() }
    }

    pub fn is_none(&self) -> bool {
        self.mass == 0.0 && self.tensor == Matrix3::zeros()
    }

    /// Returns the same mass in the outer frame of `frame`.
    pub fn seen_from(&self, frame: &Frame) -> Mass {
        let r = &frame.rotation;
        let tensor = r * self.tensor * r.transpose();
        // The product of rotations is symmetric up to rounding.
        let tensor =
            if frame.is_parallel() { self.tensor } else { (tensor + tensor.transpose()) * 0.5 };
        Mass { mass: self.mass, com: frame.position + r * self.com, tensor }
    }

    /// Returns the sum of masses that are fixed to each other. A single one keeps all its bits.
    pub fn sum(masses: &[Mass]) -> Mass {
        let mut heavy = masses.iter().filter(|mass| !mass.is_none());
        match (heavy.next(), heavy.next()) {
            (None, _) => return Mass::none(),
            (Some(one), None) => return one.clone(),
            _ => {}
        }
        let mass: f64 = masses.iter().map(|part| part.mass).sum();
        if mass == 0.0 {
            let tensor = masses.iter().map(|part| part.tensor).sum();
            return Mass { tensor, ..Mass::none() };
        }
        let moment: Vector3<f64> = masses.iter().map(|part| part.com * part.mass).sum();
        let com = moment / mass;
        let tensor = masses.iter().map(|part| part.about(com)).sum();
        Mass { mass, com, tensor }
    }

    /// Makes moments of inertia zero that are negative by less than a point mass has at a distance of 1 µm.
    /// Returns whether there were any.
    pub fn round_moments(&mut self) -> bool {
        let negligible = self.mass * 1e-12;
        let mut rounded = false;
        for axis in 0..3 {
            let moment = &mut self.tensor[(axis, axis)];
            if *moment < 0.0 && *moment > -negligible {
                *moment = 0.0;
                rounded = true;
            }
        }
        rounded
    }

    /// Returns the inertia tensor about a point: J + m (d·d 1 − d dᵀ), Huygens and Steiner.
    fn about(&self, point: Vector3<f64>) -> Matrix3<f64> {
        let d = self.com - point;
        self.tensor + (Matrix3::identity() * d.dot(&d) - d * d.transpose()) * self.mass
    }
}
