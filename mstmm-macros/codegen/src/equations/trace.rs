//! A trace of named intermediate results, in the order of the equations. Generated code shows the
//! names to readers; tests read the values.

use crate::math::{Mat3, Motion, Scalar, SpatialInertia, Sym3, Vec3, Wrench};
use std::collections::HashSet;

/// A titled group of intermediate results.
#[derive(Clone, Debug)]
pub struct TraceSection<S> {
    /// A short name, unique in the trace, such as `elbow_riccati`. Unnamed values get names that
    /// begin with this prefix.
    pub prefix: String,
    /// What the section computes.
    pub title: String,
    /// The source of the equations.
    pub source: &'static str,
    /// Names and values, in the order of computation.
    pub values: Vec<(String, S)>,
}

/// Intermediate results by section.
#[derive(Clone, Debug, Default)]
pub struct Trace<S> {
    /// The sections, in order.
    pub sections: Vec<TraceSection<S>>,
    prefixes: HashSet<String>,
    silent: bool,
}

impl<S: Scalar> Trace<S> {
    /// Returns an empty trace.
    pub fn new() -> Self {
        Trace { sections: Vec::new(), prefixes: HashSet::new(), silent: false }
    }

    /// Returns a trace that records nothing. Names cost half of the time of the equations.
    pub fn silent() -> Self {
        Trace { silent: true, ..Trace::new() }
    }

    /// Begins a section. The prefix gets a number if an earlier section has the same prefix, for
    /// example from another sweep over the same links.
    pub fn section(
        &mut self,
        prefix: impl Into<String>,
        title: impl Into<String>,
        source: &'static str,
    ) {
        if self.silent {
            return;
        }
        let prefix = self.unique(prefix.into());
        self.sections.push(TraceSection {
            prefix,
            title: title.into(),
            source,
            values: Vec::new(),
        });
    }

    /// Returns the prefix, with the first number that makes it unique if it is taken.
    fn unique(&mut self, prefix: String) -> String {
        let mut unique = prefix.clone();
        let mut number = 1;
        while !self.prefixes.insert(unique.clone()) {
            number += 1;
            unique = format!("{prefix}{number}");
        }
        unique
    }

    /// Names a value.
    pub fn number(&mut self, name: impl Into<String>, value: S) {
        if let Some(section) = self.sections.last_mut() {
            section.values.push((name.into(), value));
        }
    }

    /// Names an entry, unless the entry vanishes in every state.
    fn entry(&mut self, name: &str, entry: &str, value: S) {
        if !self.silent && !value.vanishes() {
            self.number(format!("{name}_{entry}"), value);
        }
    }

    /// Names the components of a vector.
    pub fn vector(&mut self, name: &str, Vec3(values): Vec3<S>) {
        for (axis, value) in ["x", "y", "z"].into_iter().zip(values) {
            self.entry(name, axis, value);
        }
    }

    /// Names the entries of a matrix.
    pub fn matrix(&mut self, name: &str, Mat3(rows): Mat3<S>) {
        let names = [["xx", "xy", "xz"], ["yx", "yy", "yz"], ["zx", "zy", "zz"]];
        for (component, value) in names.into_iter().flatten().zip(rows.into_iter().flatten()) {
            self.entry(name, component, value);
        }
    }

    /// Names the entries of a symmetric matrix.
    pub fn symmetric(&mut self, name: &str, Sym3(values): Sym3<S>) {
        for (component, value) in ["xx", "yy", "zz", "xy", "xz", "yz"].into_iter().zip(values) {
            self.entry(name, component, value);
        }
    }

    /// Names mass, first moment and inertia of a rigid body.
    pub fn rigid_body(&mut self, name: &str, mass: S, first_moment: Vec3<S>, inertia: Sym3<S>) {
        self.entry(name, "mass", mass);
        self.vector(&format!("{name}_first_moment"), first_moment);
        self.symmetric(&format!("{name}_inertia"), inertia);
    }

    /// Names the entries of a motion.
    pub fn motion(&mut self, name: &str, motion: Motion<S>) {
        self.vector(&format!("{name}_lin"), motion.linear);
        self.vector(&format!("{name}_ang"), motion.angular);
    }

    /// Names the entries of a wrench.
    pub fn wrench(&mut self, name: &str, wrench: Wrench<S>) {
        let entries = wrench.force.0.into_iter().chain(wrench.moment.0);
        for (entry, value) in ["fx", "fy", "fz", "mx", "my", "mz"].into_iter().zip(entries) {
            self.entry(name, entry, value);
        }
    }

    /// Names the entries of a spatial inertia.
    pub fn inertia(&mut self, name: &str, inertia: SpatialInertia<S>) {
        self.symmetric(&format!("{name}_mass"), inertia.linear);
        self.matrix(&format!("{name}_coupling"), inertia.coupling);
        self.symmetric(&format!("{name}_inertia"), inertia.angular);
    }
}

#[cfg(test)]
mod tests {
    use super::Trace;

    #[test]
    fn prefixes_are_different() {
        let mut trace = Trace::<f64>::new();
        for prefix in ["elbow_riccati", "elbow_riccati", "elbow_riccati2", "elbow_riccati"] {
            trace.section(prefix, "", "");
        }
        let prefixes: Vec<&str> = trace.sections.iter().map(|one| one.prefix.as_str()).collect();
        let expected = ["elbow_riccati", "elbow_riccati2", "elbow_riccati22", "elbow_riccati3"];
        assert_eq!(prefixes, expected);
    }
}
