//! The description of a chain for the comparison, from the compiler's model.

use mstmm_codegen::model::{
    Chain, DofGroup, Drive, Effort, Hinge, HingeId, HingeKind, InputKind, Layout, Representation,
    Source, Value,
};
use mstmm_precision as comparison;

/// Returns the description of a chain.
pub fn describe(chain: &Chain, random_inputs: bool) -> comparison::Description {
    let layout = Layout::of(chain);
    let hinge = |index: HingeId| hinge(chain, &chain.hinges[index]);
    let mut parts: Vec<comparison::Part> = Vec::new();
    let mut last = None;
    for index in chain.hinges.ids().into_iter().filter(|&index| !layout.q[index].is_empty()) {
        let repeat = chain.repeat_of_hinge(index);
        match parts.last_mut() {
            Some(part) if last == Some(repeat) => part.hinges.push(hinge(index)),
            _ => parts.push(comparison::Part {
                times: repeat.map(|repeat| chain.repeats[repeat].count),
                hinges: vec![hinge(index)],
            }),
        }
        last = Some(repeat);
    }
    let inputs = layout.inputs.iter().map(|input| {
        let count = input.range.len();
        let what = match input.what {
            InputKind::Gravity => comparison::InputKind::Gravity(count),
            InputKind::Force(_) | InputKind::SpringForce(_) => {
                comparison::InputKind::Efforts(vec![false; count])
            }
            InputKind::Torque(_) => comparison::InputKind::Efforts(vec![true; count]),
            InputKind::Efforts(index) => {
                comparison::InputKind::Efforts(driven(&chain.hinges[index]))
            }
            InputKind::Motion(index) => comparison::InputKind::Motion(hinge(index)),
        };
        comparison::Input { times: times(chain, input.what).unwrap_or(1), what }
    });
    comparison::Description {
        name: chain.name.to_string(),
        closed: !layout.loop_hinges.is_empty(),
        conservative: conservative(chain, random_inputs),
        inputs: inputs.collect(),
        parts,
    }
}

/// Returns the number of repetitions of an input, if it belongs to a repeated part.
pub fn times(chain: &Chain, what: InputKind) -> Option<usize> {
    chain.repeat_of_input(what).map(|repeat| chain.repeats[repeat].count)
}

/// Returns for each effort that is an input whether it is a torque.
fn driven(hinge: &Hinge) -> Vec<bool> {
    let Drive::Efforts(efforts) = &hinge.drive else { return Vec::new() };
    let groups = hinge.kind.spec().groups.iter();
    let rotational = groups.flat_map(|group| group.rates.clone().map(|_| group.rotational));
    let inputs = efforts.iter().zip(rotational).filter(|(effort, _)| **effort == Effort::Input);
    inputs.map(|(_, rotational)| rotational).collect()
}

fn hinge(chain: &Chain, hinge: &Hinge) -> comparison::Hinge {
    let spec = hinge.kind.spec();
    let name = |rate: usize| match spec.rates {
        [_] => String::new(),
        rates => rates[rate].to_owned(),
    };
    let group = |group: &DofGroup| {
        let quaternion = group.representation == Representation::Quaternion;
        comparison::Group {
            rotational: group.rotational,
            quaternion,
            rates: group.rates.clone().map(name).collect(),
            limits: group.rates.clone().map(|strain| limits(chain, hinge, strain)).collect(),
        }
    };
    comparison::Hinge {
        name: hinge.name.to_string(),
        elastic: matches!(hinge.kind, HingeKind::Elastic | HingeKind::PlaneElastic),
        groups: spec.groups.iter().map(group).collect(),
    }
}

/// Returns the limits of a coordinate for the defaults of parameters, if they are known.
fn limits(chain: &Chain, hinge: &Hinge, strain: usize) -> Option<[f64; 2]> {
    let defaults: Vec<Option<f64>> =
        chain.parameters.iter().map(|parameter| parameter.default.known()).collect();
    let limits = hinge.passive.get(strain)?.limits.as_ref()?;
    Some([limits.low.at(&defaults)?, limits.high.at(&defaults)?])
}

/// Returns whether all efforts and loads have a potential.
fn conservative(chain: &Chain, random_inputs: bool) -> bool {
    let no_input = !random_inputs;
    let hinge = |hinge: &Hinge| {
        let driven = match &hinge.drive {
            Drive::Prescribed => false,
            Drive::Efforts(efforts) => efforts.iter().any(|effort| match effort {
                Effort::Free => false,
                Effort::Constant(value) => !value.is_zero(),
                Effort::Input => random_inputs,
            }),
        };
        let dissipates = hinge.passive.iter().any(|passive| {
            let limits = passive.limits.as_ref();
            !passive.damping.is_zero()
                || passive.friction.is_some()
                || limits.is_some_and(|limits| !limits.damping.is_zero())
        });
        !driven && !dissipates
    };
    let acts = |source: &Source| match source {
        Source::Nothing => false,
        Source::Constant(values) => !values.iter().all(Value::is_zero),
        Source::Input => random_inputs,
    };
    chain.hinges.iter().all(hinge)
        && chain.loads.iter().all(|load| !acts(&load.force) && !acts(&load.torque))
        && chain.springs.iter().all(|spring| spring.damping.is_zero())
        && (no_input || chain.gravity != Source::Input)
}
