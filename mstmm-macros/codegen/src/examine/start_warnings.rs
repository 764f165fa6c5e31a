//! Warnings of a start that is valid, but probably not what was meant.

use proc_macro2::Span;

use super::dry_run::{Configuration, DryRun, Number};
use crate::diag::Diagnostics;
use crate::equations;
use crate::model::{Hinge, HingeId, Limits, Passive, Value};

/// The name of the warning of a closed chain that cannot be closed near its start.
const OPEN_LOOP: &str = "CHAIN_NOT_CLOSED_NEAR_ITS_START";

/// The name of the warning of a closed chain that can be closed near its start, but not from it.
const CLOSES_NEARBY: &str = "CHAIN_NOT_CLOSED_FROM_ITS_START";

/// The name of the warning of a closed chain whose loop constraints are singular at its start.
const SINGULAR_CLOSURE: &str = "SINGULAR_LOOP_CONSTRAINTS_AT_ITS_START";

/// The name of the warning of an open chain whose accelerations are `Singular` at its start.
const SINGULAR_ACCELERATIONS: &str = "NO_ACCELERATIONS_AT_ITS_START";

/// The name of the warning of a hinge that starts beyond its limits.
const BEYOND_LIMITS: &str = "START_BEYOND_LIMITS";

/// The overshoot from which a start is beyond its limits, relative to the distance between them, or in m or rad if they are
/// further apart: one of them may stand for no limit. Rotation vectors have rounding errors.
const OVERSHOOT: f64 = 1e-9;

/// The largest difference of the coordinates of equal closed poses, in rad or relative to the size of the chain. In a singular
/// pose, a residual of 1e-9 leaves its root.
const EQUAL: f64 = 1e-3;

/// Returns the span of the `start` of a hinge, or of its name on the route if no start is written.
fn start_of(hinge: &Hinge) -> Span {
    hinge.start_field.as_ref().unwrap_or(&hinge.name).span()
}

impl DryRun {
    /// Warns of hinges that start beyond their limits. Prescribed motions have no start.
    pub fn warn_of_limits(&self, diagnostics: &mut Diagnostics) {
        for hinge in self.chain.hinges.iter().filter(|hinge| !hinge.is_prescribed()) {
            let path = &hinge.path;
            if self.starts_beyond_limits(hinge) {
                let message = format!(
                    "hinge `{path}` starts beyond its limits, whose springs push it back: write a `start` within them"
                );
                diagnostics.warn(start_of(hinge), BEYOND_LIMITS, message);
            }
        }
    }

    /// Returns whether a hinge starts beyond its limits: springs there store energy. They store half a joule at an overshoot
    /// of one, in the unit of [`OVERSHOOT`].
    fn starts_beyond_limits(&self, hinge: &Hinge) -> bool {
        let stiff = |limits: &Limits| {
            let [low, high] =
                [&limits.low, &limits.high].map(|limit| self.values.scalar(limit).value());
            Limits { stiffness: Value::number((high - low).min(1.0).powi(-2)), ..limits.clone() }
        };
        let limits_of = |passive: &Passive| Passive {
            limits: passive.limits.as_ref().map(stiff),
            ..Passive::none()
        };
        let passive = hinge.passive.iter().map(limits_of).collect();
        let stops = Hinge { passive, ..hinge.clone() };
        let number = |value: &Value| Number::variable(self.values.scalar(value).value());
        let start: Vec<Number> = hinge.start.iter().map(number).collect();
        let start = equations::hinge::normalized(&hinge.kind, &start);
        let at_rest = vec![Number::variable(0.0); hinge.kind.dof_count()];
        let elements =
            equations::hinge::passive_elements(&stops, &self.values, &start, &at_rest, None);
        elements.energy.value() > 0.5 * OVERSHOOT * OVERSHOOT
    }

    /// Warns of hinges of an open chain that have a zero pivot at the start. Prescribed motions have no start.
    pub fn warn_of_singular_accelerations(
        &self,
        at_start: &[HingeId],
        diagnostics: &mut Diagnostics,
    ) {
        let is_closed = !self.merged.loop_hinges.is_empty();
        if is_closed || self.chain.hinges.iter().any(Hinge::is_prescribed) {
            return;
        }
        for hinge in at_start.iter().map(|&hinge| &self.chain.hinges[hinge]) {
            let name = &hinge.path;
            let message = format!(
                "accelerations are `Singular` at the start: there hinge `{name}` is free in a direction in which the bodies \
                 that it moves have no inertia, or its axes are in one plane; write another `start`"
            );
            diagnostics.warn(start_of(hinge), SINGULAR_ACCELERATIONS, message);
        }
    }

    /// Warns of a closed chain for which no closed pose is found from the start, but perhaps `nearby`. The positions of
    /// prescribed motions are known at run time only.
    pub fn warn_of_open_loop(&self, nearby: bool, diagnostics: &mut Diagnostics) {
        let closing = self.merged.loop_hinges.first().map(|&hinge| &self.chain.hinges[hinge]);
        let is_prescribed = self.chain.hinges.iter().any(Hinge::is_prescribed);
        let Some(closing) = closing.filter(|_| !is_prescribed) else { return };
        let (rule, message) = if nearby {
            (
                CLOSES_NEARBY,
                "`assemble` cannot close this chain from its start, but from poses next to it: write a `start` of the \
                 hinges with the links bent, closer to a closed pose",
            )
        } else {
            (
                OPEN_LOOP,
                "no pose near the start closes this chain, so `assemble` fails: check the lengths of the bodies and \
                 the positions of the ends, or write a `start` of the hinges near a closed pose",
            )
        };
        diagnostics.warn(closing.name.span(), rule, message);
    }

    /// Warns of a closed chain whose links are in line at its start: it has no other closed pose nearby, or fewer independent
    /// loop constraints than in those. `poses` are the closed poses, the first one from the start.
    pub fn warn_of_singular_closure(&self, poses: &[Configuration], diagnostics: &mut Diagnostics) {
        let closing = self.merged.loop_hinges.first().map(|&hinge| &self.chain.hinges[hinge]);
        let is_prescribed = self.chain.hinges.iter().any(Hinge::is_prescribed);
        let Some(closing) = closing.filter(|_| !is_prescribed) else { return };
        let [start, others @ ..] = poses else { return };
        // No hinge is prescribed.
        let hinges = self.chain.hinges.iter();
        let units =
            hinges.flat_map(|hinge| self.units(&hinge.kind, |group| group.coordinates.clone()));
        let units: Vec<f64> = units.collect();
        let is_other = |pose: &Configuration| {
            let changes = pose.q.iter().zip(&start.q).map(|(a, b)| (a.value() - b.value()).abs());
            changes.zip(&units).any(|(change, unit)| change > EQUAL * unit)
        };
        let message = if others.len() > 1 && !others.iter().any(is_other) {
            "this closed chain has no other closed pose near its start, and accelerations fail or have no meaning there: its links \
             are in line and cannot move; check the lengths of the bodies and the positions of the ends"
        } else if self.closure_rank(&poses[..1]) < self.closure_rank(poses) {
            "the loop constraints of this chain are singular at its start, and accelerations fail or have no meaning there: \
             write a `start` of the hinges with the links bent"
        } else {
            return;
        };
        diagnostics.warn(closing.name.span(), SINGULAR_CLOSURE, message);
    }
}
