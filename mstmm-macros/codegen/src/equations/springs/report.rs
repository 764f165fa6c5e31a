//! The state of all springs.

use super::super::kinematics::poses;
use super::super::{Axes, EvalContext, Trace, kinematics};
use super::{SpringSpan, Springs};
use crate::ids::SpringId;
use crate::math::{Scalar, Vec3};

/// The state of a spring.
#[derive(Clone, Copy, Debug)]
pub struct SpringReport<S> {
    /// Its length in m.
    pub length: S,
    /// The rate of its length in m/s.
    pub length_rate: S,
    /// Its tension in N, positive where it pulls.
    pub tension: S,
    /// The force on the body of its end `on` in N, inertial axes.
    pub force: Vec3<S>,
}

/// Returns the state of all springs, from a context with welded bodies merged.
pub fn spring_report<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> Vec<SpringReport<S>> {
    let chain = context.chain;
    if chain.springs.is_empty() {
        return Vec::new();
    }
    let links = kinematics(context, axes, &mut Trace::silent());
    let poses = poses(context, &links);
    let springs = Springs::new(context, &links, &poses);
    let reports = springs.all().map(|(id, _, span)| springs.report(id, span));
    let reports: Vec<SpringReport<S>> = reports.collect();
    trace.section("springs", "Springs", "");
    for (spring, report) in chain.springs.iter().zip(&reports) {
        let name = &spring.name;
        trace.number(format!("{name}_length"), report.length);
        trace.number(format!("{name}_length_rate"), report.length_rate);
        trace.number(format!("{name}_tension"), report.tension);
        trace.vector(&format!("{name}_force"), report.force);
    }
    reports
}

impl<S: Scalar> Springs<'_, S> {
    fn report(&self, id: SpringId, span: &SpringSpan<S>) -> SpringReport<S> {
        let spring = &self.context.chain.springs[id];
        // The vector `r` or its opposite, inertial axes.
        let (motion, inertial, reversed) = match span {
            SpringSpan::AtRest => {
                let motion = self.at_rest(spring);
                let inertial = motion.displacement;
                (motion, inertial, false)
            }
            SpringSpan::OneLink { link, reversed } => {
                let (_, inertial, motion) = self.on_one_link(spring, *link, *reversed);
                (motion, inertial, *reversed)
            }
            SpringSpan::TwoLinks { common, paths } => {
                let motion = self.on_two_links(spring, paths);
                let r = motion.displacement;
                let inertial = common.map_or(r, |common| self.poses[common].to_inertial * r);
                (motion, inertial, false)
            }
            SpringSpan::Far(end) => {
                let motion = self.far(spring, end);
                let inertial = motion.displacement;
                (motion, inertial, false)
            }
        };
        let values = self.context.values;
        let [stiffness, damping, rest] =
            [&spring.stiffness, &spring.damping, &spring.length].map(|value| values.scalar(value));
        // Sums that the forces also contain would be rounded in another order if they were used here.
        let length = motion.displacement.dot(motion.displacement).divisible_root();
        let inverse = length.recip();
        let length_rate = motion.displacement.dot(motion.velocity) * inverse;
        let passive = stiffness * (length - rest) + damping * length_rate;
        let tension = self.actuator_force(id).map_or(passive, |force| passive - force);
        let force = inertial * (tension * inverse);
        SpringReport { length, length_rate, tension, force: if reversed { force } else { -force } }
    }
}
