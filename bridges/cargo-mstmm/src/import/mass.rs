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

    /// Makes a tensor zero that no body has, if all its entries are rounding errors: those of a point mass at a
    /// distance of 1 µm. Returns whether it was one.
    pub fn drop_rounding_errors(&mut self) -> bool {
        let [xx, yy, zz] = [0, 1, 2].map(|axis| self.tensor[(axis, axis)]);
        let moments = [[xx, yy, zz], [yy, zz, xx], [zz, xx, yy]];
        let has_no_body = moments.iter().any(|[a, b, c]| *a < 0.0 || *a > b + c);
        let is_rounding = self.tensor.amax() < self.mass * 1e-12;
        if has_no_body && is_rounding {
            self.tensor = Matrix3::zeros();
        }
        has_no_body && is_rounding
    }

    /// Returns the inertia tensor about a point: J + m (d·d 1 − d dᵀ), Huygens and Steiner.
    fn about(&self, point: Vector3<f64>) -> Matrix3<f64> {
        let d = self.com - point;
        self.tensor + (Matrix3::identity() * d.dot(&d) - d * d.transpose()) * self.mass
    }
}
