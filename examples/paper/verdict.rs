//! Verdicts: differences and the bounds that they must keep.

/// The verdict on one comparison. It passes if all its checks do.
pub struct Verdict {
    /// The two results that are compared.
    pub compared: String,
    /// The file of the figure that shows the comparison.
    pub figure: Option<&'static str>,
    pub checks: Vec<Check>,
}

/// A difference and its bound.
pub struct Check {
    pub what: String,
    pub size: f64,
    /// Empty for relative differences and counts.
    pub unit: &'static str,
    pub bound: Bound,
}

/// The largest difference that passes.
#[derive(Clone, Copy)]
pub enum Bound {
    /// The argument `--tolerance`.
    Tolerance,
    /// A bound that the argument does not change.
    Fixed(f64),
}

impl Bound {
    pub fn value(self, tolerance: f64) -> f64 {
        match self {
            Bound::Tolerance => tolerance,
            Bound::Fixed(bound) => bound,
        }
    }
}

impl Check {
    /// Returns whether the difference is at most its bound. NaN is not.
    pub fn passes(&self, tolerance: f64) -> bool {
        self.size <= self.bound.value(tolerance)
    }

    /// The difference as a fraction of its bound; infinite if it is NaN or if the bound is zero and
    /// the difference is not.
    fn fraction(&self, tolerance: f64) -> f64 {
        let fraction = self.size / self.bound.value(tolerance);
        match (self.passes(tolerance), fraction.is_finite()) {
            (_, true) => fraction,
            (true, false) => 0.0,
            (false, false) => f64::INFINITY,
        }
    }
}

impl Verdict {
    /// A verdict without checks has compared nothing and does not pass.
    pub fn passes(&self, tolerance: f64) -> bool {
        !self.checks.is_empty() && self.checks.iter().all(|check| check.passes(tolerance))
    }

    /// Returns the check that is nearest to its bound, or farthest beyond it.
    pub fn decisive(&self, tolerance: f64) -> Option<&Check> {
        let by_fraction =
            |a: &&Check, b: &&Check| a.fraction(tolerance).total_cmp(&b.fraction(tolerance));
        self.checks.iter().max_by(by_fraction)
    }

    /// Describes each check that fails.
    pub fn complaints(&self, tolerance: f64) -> Vec<String> {
        if self.checks.is_empty() {
            return vec![format!("{}: nothing was compared", self.compared)];
        }
        let failed = self.checks.iter().filter(|check| !check.passes(tolerance));
        failed
            .map(|Check { what, size, unit, bound }| {
                let bound = bound.value(tolerance);
                format!("{}: {what}: {size:.1e} {unit}, more than {bound:.1e}", self.compared)
            })
            .collect()
    }
}
