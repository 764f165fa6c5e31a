//! The values of a chain, with its parameters at their defaults.

use mstmm_codegen::model::{Chain, Frame, Value};
use nalgebra::{Matrix3, Vector3};
use std::cell::Cell;

/// The defaults of the parameters.
pub struct Values {
    defaults: Vec<Option<f64>>,
    /// Whether a value was asked for that is not known.
    is_incomplete: Cell<bool>,
}

impl Values {
    /// Returns nothing if a default depends on a Rust constant.
    pub fn of_chain(chain: &Chain) -> Self {
        let defaults = chain.parameters.iter().map(|parameter| parameter.default.known()).collect();
        Values { defaults, is_incomplete: Cell::new(false) }
    }

    /// Returns a value; one that depends on Rust constants, whose values only `rustc` knows, is not a number.
    pub fn of(&self, value: &Value) -> f64 {
        let value = value.at(&self.defaults).filter(|value| value.is_finite());
        self.is_incomplete.set(self.is_incomplete.get() || value.is_none());
        value.unwrap_or(f64::NAN)
    }

    /// Returns whether a value so far was not a number.
    pub fn is_incomplete(&self) -> bool {
        self.is_incomplete.get()
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
