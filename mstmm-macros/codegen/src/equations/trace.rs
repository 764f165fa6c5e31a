//! The working of the equations, kept in their order and under their names: what the generated
//! code shows to a reader, and what a test can look into.

use crate::math::{Mat3, Motion, Scalar, SpatialInertia, Sym3, Vec3, Wrench};
use std::collections::HashSet;

/// A headed group of intermediate results.
#[derive(Clone, Debug)]
pub struct TraceSection<S> {
    /// A short name, different from that of all other sections of the trace: `elbow_riccati`. The
    /// names of values without a name begin with it.
    pub prefix: String,
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
    pub sections: Vec<TraceSection<S>>,
    prefixes: HashSet<String>,
    silent: bool,
}

impl<S: Scalar> Trace<S> {
    /// An empty trace.
    pub fn new() -> Self {
        Trace { sections: Vec::new(), prefixes: HashSet::new(), silent: false }
    }

    /// A trace that keeps nothing, for equations whose working nobody reads: names take half of their
    /// time.
    pub fn silent() -> Self {
        Trace { silent: true, ..Trace::new() }
    }

    /// Begins a section. The prefix gets a number if an earlier section has the same one, as the
    /// second of two sweeps over the same links has.
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

    /// The prefix itself if it is free, otherwise the prefix with the first number that makes it
    /// so.
    fn unique(&mut self, prefix: String) -> String {
        let mut unique = prefix.clone();
        let mut number = 1;
        while !self.prefixes.insert(unique.clone()) {
            number += 1;
            unique = format!("{prefix}{number}");
        }
        unique
    }

    /// Names a number.
    pub fn number(&mut self, name: impl Into<String>, value: S) {
        if let Some(section) = self.sections.last_mut() {
            section.values.push((name.into(), value));
        }
    }

    /// Names an entry, unless it vanishes in every state.
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
        for (place, value) in names.into_iter().flatten().zip(rows.into_iter().flatten()) {
            self.entry(name, place, value);
        }
    }

    /// Names the entries of a symmetric matrix.
    pub fn symmetric(&mut self, name: &str, Sym3(values): Sym3<S>) {
        for (place, value) in ["xx", "yy", "zz", "xy", "xz", "yz"].into_iter().zip(values) {
            self.entry(name, place, value);
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
