//! The working of the equations, kept in their order and under their names: what the generated
//! code shows to a reader, and what a test can look into.

use crate::math::{Mat3, Motion, Scalar, SpatialInertia, Sym3, Vec3, Wrench};

/// A headed group of intermediate results.
#[derive(Clone, Debug)]
pub struct Section<S> {
    /// What is computed.
    pub title: String,
    /// Where the equations are from.
    pub source: &'static str,
    /// Names and values, in the order in which they come up.
    pub values: Vec<(String, S)>,
}

/// Intermediate results by section.
#[derive(Clone, Debug, Default)]
pub struct Trace<S> {
    /// The sections in their order.
    pub sections: Vec<Section<S>>,
}

impl<S: Scalar> Trace<S> {
    /// An empty trace.
    pub fn new() -> Self {
        Trace { sections: Vec::new() }
    }

    /// Begins a section.
    pub fn section(&mut self, title: impl Into<String>, source: &'static str) {
        self.sections.push(Section { title: title.into(), source, values: Vec::new() });
    }

    /// Names a number.
    pub fn number(&mut self, name: impl Into<String>, value: S) {
        if let Some(section) = self.sections.last_mut() {
            section.values.push((name.into(), value));
        }
    }

    /// Names the components of a vector.
    pub fn vector(&mut self, name: &str, Vec3(values): Vec3<S>) {
        for (axis, value) in ["x", "y", "z"].into_iter().zip(values) {
            self.number(format!("{name}_{axis}"), value);
        }
    }

    /// Names the entries of a matrix.
    pub fn matrix(&mut self, name: &str, Mat3(rows): Mat3<S>) {
        for (row, values) in ["x", "y", "z"].into_iter().zip(rows) {
            self.vector(&format!("{name}_{row}"), Vec3(values));
        }
    }

    /// Names the entries of a symmetric matrix.
    pub fn symmetric(&mut self, name: &str, Sym3(values): Sym3<S>) {
        for (place, value) in ["xx", "yy", "zz", "xy", "xz", "yz"].into_iter().zip(values) {
            self.number(format!("{name}_{place}"), value);
        }
    }

    /// Names the entries of a motion.
    pub fn motion(&mut self, name: &str, motion: Motion<S>) {
        self.vector(&format!("{name}_lin"), motion.linear);
        self.vector(&format!("{name}_ang"), motion.angular);
    }

    /// Names the entries of a wrench.
    pub fn wrench(&mut self, name: &str, wrench: Wrench<S>) {
        self.vector(&format!("{name}_force"), wrench.force);
        self.vector(&format!("{name}_moment"), wrench.moment);
    }

    /// Names the entries of a spatial inertia.
    pub fn inertia(&mut self, name: &str, inertia: SpatialInertia<S>) {
        self.symmetric(&format!("{name}_k"), inertia.linear);
        self.matrix(&format!("{name}_b"), inertia.coupling);
        self.symmetric(&format!("{name}_j"), inertia.angular);
    }
}
