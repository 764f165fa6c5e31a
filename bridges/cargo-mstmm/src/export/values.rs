//! The values of a chain, with its parameters at their defaults.

use mstmm_codegen::model::{Chain, Frame, Value};
use nalgebra::{Matrix3, Vector3};

/// The defaults of the parameters.
pub struct Values(Vec<Option<f64>>);

impl Values {
    /// Returns nothing if a default depends on a Rust constant.
    pub fn of_chain(chain: &Chain) -> Self {
        Values(chain.parameters.iter().map(|parameter| parameter.default.known()).collect())
    }

    /// Returns a value; one that depends on Rust constants, whose values only `rustc` knows, is not a number.
    pub fn of(&self, value: &Value) -> f64 {
        value.at(&self.0).unwrap_or(f64::NAN)
    }

    pub fn vector(&self, vector: &[Value; 3]) -> Vector3<f64> {
        vector.each_ref().map(|value| self.of(value)).into()
    }

    pub fn matrix(&self, rows: &[[Value; 3]; 3]) -> Matrix3<f64> {
        Matrix3::from_fn(|row, column| self.of(&rows[row][column]))
    }

    /// Returns the position of a frame, and roll, pitch and yaw: as written if they are.
    pub fn frame(&self, frame: &Frame) -> (Vector3<f64>, Vector3<f64>) {
        let angles = match &frame.angles {
            Some(angles) => self.vector(angles),
            None => crate::import::angles_of(&self.matrix(&frame.rotation)).into(),
        };
        (self.vector(&frame.position), angles)
    }
}
