//! Uses of parameters.

use super::{
    Attachment, Body, Chain, Drive, Effort, Frame, Friction, Hinge, Limits, Load, ParameterId,
    Passive, RepeatId, Source, Spring, SpringEnd, Value,
};
use crate::diag::Diagnostics;

/// Reports parameters with one value for each repetition that are used outside one repeated part.
pub(super) fn repeated_parameters_stay_in_their_part(chain: &Chain, diagnostics: &mut Diagnostics) {
    for (id, parameter) in chain.parameters.enumerate() {
        let Some(times) = parameter.repetitions else { continue };
        let name = &parameter.name;
        let mut parts = chain.parts_that_use(id);
        parts.dedup();
        let message = match parts[..] {
            [] => continue,
            [Some(part)] if chain.repeats[part].count == times => continue,
            [Some(part)] => {
                let count = chain.repeats[part].count;
                format!(
                    "`{name}` has {times} values, but its part is repeated {count} times: \
                         write the same count in both"
                )
            }
            [None] => format!(
                "`{name}` has a value for each of {times} repetitions: only a part that is repeated as many times can use \
                 it"
            ),
            _ => format!(
                "`{name}` has one value for each repetition of a part, and is used elsewhere \
                 too: write a separate parameter for the other uses"
            ),
        };
        diagnostics.error(name.span(), message);
    }
}

impl Chain {
    /// Returns the repeated part that a parameter belongs to. A parameter that nothing uses belongs to the first part with
    /// as many repetitions as it has values.
    pub fn repeat_of_parameter(&self, parameter: ParameterId) -> Option<RepeatId> {
        let times = self.parameters[parameter].repetitions?;
        let using = self.parts_that_use(parameter).into_iter().flatten().next();
        using.or_else(|| self.repeats.position(|repeat| repeat.count == times))
    }

    /// Returns whether frames, axes or the start depend on a parameter. The rank of the loop
    /// constraints may then depend on it, too.
    pub fn closure_uses(&self, parameter: ParameterId) -> bool {
        let start = self.hinges.iter().flat_map(|hinge| &hinge.start);
        self.geometry().chain(start).any(|value| value.uses(parameter))
    }

    /// Returns whether all frames and axes are known values.
    pub fn geometry_is_known(&self) -> bool {
        self.geometry().all(|value| value.known().is_some())
    }

    /// Returns the values of all frames and axes.
    fn geometry(&self) -> impl Iterator<Item = &Value> {
        let frames = self.bodies.iter().flat_map(|body| {
            let points = body.points.iter().map(|point| &point.frame);
            points.chain([&body.output]).flat_map(of_frame)
        });
        let hinges = self.hinges.iter();
        frames.chain(hinges.flat_map(|hinge| [of_attachments(hinge), hinge.kind.values()].concat()))
    }

    /// Returns the repeated parts in which a parameter is used, in their order; `None` is
    /// everything else.
    fn parts_that_use(&self, parameter: ParameterId) -> Vec<Option<RepeatId>> {
        let used = |values: Vec<&Value>| values.into_iter().any(|value| value.uses(parameter));
        let bodies = self.bodies.enumerate();
        let bodies = bodies.map(|(index, body)| (self.repeat_of_body(index), of_body(body)));
        let hinges = self.hinges.enumerate();
        let hinges = hinges.map(|(index, hinge)| (self.repeat_of_hinge(index), of_hinge(hinge)));
        let loads = self.loads.iter();
        let loads = loads.map(|load| (self.repeat_of_body(load.body), of_load(load)));
        let springs = self.springs.iter();
        let springs =
            springs.map(|spring| (self.repeat_of_body(spring.on.body), of_spring(spring)));
        let attachments = self.hinges.iter().map(|hinge| (None, of_attachments(hinge)));
        let gravity = std::iter::once((None, of_source(&self.gravity)));
        let users =
            bodies.chain(hinges).chain(loads).chain(springs).chain(attachments).chain(gravity);
        let mut parts: Vec<Option<RepeatId>> =
            users.filter(|(_, values)| used(values.clone())).map(|(part, _)| part).collect();
        parts.sort();
        parts
    }
}

fn of_frame(frame: &Frame) -> Vec<&Value> {
    frame.position.iter().chain(frame.rotation.iter().flatten()).collect()
}

fn of_source(source: &Source) -> Vec<&Value> {
    match source {
        Source::Constant(values) => values.iter().collect(),
        Source::Nothing | Source::Input => Vec::new(),
    }
}

fn of_body(body: &Body) -> Vec<&Value> {
    let mut values = vec![&body.mass];
    values.extend(&body.com);
    values.extend(&body.inertia.tensor);
    values.extend(of_frame(&body.output));
    values.extend(body.points.iter().flat_map(|point| of_frame(&point.frame)));
    values
}

fn of_hinge(hinge: &Hinge) -> Vec<&Value> {
    let Hinge { kind, start, start_rate, rest, drive, passive, .. } = hinge;
    let mut values: Vec<&Value> = start.iter().chain(start_rate).chain(rest).collect();
    values.extend(kind.values());
    if let Drive::Efforts(efforts) = drive {
        values.extend(efforts.iter().filter_map(of_effort));
    }
    values.extend(passive.iter().flat_map(of_passive));
    values
}

fn of_effort(effort: &Effort) -> Option<&Value> {
    match effort {
        Effort::Constant(value) => Some(value),
        Effort::Free | Effort::Input => None,
    }
}

fn of_passive(passive: &Passive) -> Vec<&Value> {
    let Passive { stiffness, damping, armature, friction, limits } = passive;
    let mut values = vec![stiffness, damping, armature];
    if let Some(Friction { effort, speed }) = friction {
        values.extend([effort, speed]);
    }
    if let Some(Limits { low, high, stiffness, damping }) = limits {
        values.extend([low, high, stiffness, damping]);
    }
    values
}

fn of_attachments(hinge: &Hinge) -> Vec<&Value> {
    let mut values = Vec::new();
    for attachment in [&hinge.inboard, &hinge.outboard] {
        if let Attachment::Ground(frame) = attachment {
            values.extend(of_frame(frame));
        }
    }
    values
}

fn of_load(load: &Load) -> Vec<&Value> {
    let mut values = of_frame(&load.at);
    values.extend(of_source(&load.force));
    values.extend(of_source(&load.torque));
    values
}

fn of_spring(spring: &Spring) -> Vec<&Value> {
    let Spring { on, to, stiffness, damping, length, force, .. } = spring;
    let (to, first) = match to {
        SpringEnd::Ground(point) => (point, None),
        SpringEnd::Body(point) => (&point.at, None),
        SpringEnd::Previous { point, first } => (&point.at, Some(&first.at)),
    };
    let ends = on.at.iter().chain(to).chain(first.into_iter().flatten());
    ends.chain([stiffness, damping, length]).chain(of_effort(force)).collect()
}
