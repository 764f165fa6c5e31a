//! Converts the drives of the reference solver to inputs of the compiler.

use mstmm_codegen::compile::Compiled;
use mstmm_codegen::ids::LoadId;
use mstmm_codegen::model::{
    Chain, Drive, Effort, Hinge, HingeId, HingeKind, Input, InputKind, Layout,
};
use mstmm_codegen::program::Argument;
use mstmm_reference::{Drives, FrameMotion, State};

/// Returns the inputs if only motors are driven; `efforts` has an entry for every rate.
pub fn of_motors(chain: &Chain, efforts: &[f64]) -> Vec<f64> {
    let layout = Layout::of(chain);
    let of = |input: &Input| match input.what {
        InputKind::Efforts(hinge) => motor(chain, &layout, hinge, efforts),
        _ => vec![0.0; input.range.len()],
    };
    layout.inputs.iter().flat_map(of).collect()
}

/// Returns the inputs for `drives` of the same chain of the reference.
pub fn inputs(chain: &Chain, truth: &mstmm_reference::Chain, drives: &Drives) -> Vec<f64> {
    let layout = Layout::of(chain);
    let (translations, rotations) = (chain.dimension.translations(), chain.dimension.rotations());
    let pick = |vector: &[f64; 3], axes: &[usize]| axes.iter().map(|&k| vector[k]).collect();
    let of = |input: &Input| -> Vec<f64> {
        match input.what {
            InputKind::Gravity => pick(&drives.gravity, translations),
            InputKind::Force(load) => pick(&drives.loads[load.index()].force, translations),
            InputKind::Torque(load) => pick(&drives.loads[load.index()].torque, rotations),
            InputKind::SpringForce(spring) => vec![drives.springs[spring.index()]],
            InputKind::Efforts(hinge) => motor(chain, &layout, hinge, &drives.efforts),
            InputKind::Motion(hinge) => motion(chain, hinge, truth, drives),
        }
    };
    layout.inputs.iter().flat_map(of).collect()
}

/// Returns the arguments of all functions for a state and `drives` of the same chain of the reference, in which elements of
/// repeated parts have their repetition after their names.
pub fn arguments(
    chain: &Chain,
    compiled: &Compiled,
    truth: &mstmm_reference::Chain,
    (state, drives): (&State, &Drives),
) -> Vec<(Argument, Vec<f64>)> {
    let layout = Layout::of(chain);
    let of = |argument| match argument {
        Argument::Coordinates => Some(state.q.clone()),
        Argument::Rates => Some(state.v.clone()),
        Argument::Input(input) => {
            let what = layout.inputs[input].what;
            let times = chain.repeat_of_input(what).map(|part| chain.repeats[part].count);
            Some(input_values(chain, what, times, truth, drives))
        }
        _ => None,
    };
    let arguments = compiled.unknowns.arguments();
    arguments.filter_map(|(argument, _)| Some((argument, of(argument)?))).collect()
}

/// Returns the names of an element in all its repetitions.
pub fn repeated(name: &str, times: Option<usize>) -> Vec<String> {
    match times {
        None => vec![name.to_owned()],
        Some(times) => (0..times).map(|time| format!("{name}_{time}")).collect(),
    }
}

/// Returns the values of an input in all repetitions.
fn input_values(
    chain: &Chain,
    what: InputKind,
    times: Option<usize>,
    truth: &mstmm_reference::Chain,
    drives: &Drives,
) -> Vec<f64> {
    let (translations, rotations) = (chain.dimension.translations(), chain.dimension.rotations());
    let pick = |vector: &[f64; 3], axes: &[usize]| axes.iter().map(|&k| vector[k]).collect();
    let load = |name: &str| {
        let place = truth.loads.iter().position(|load| load.name == name);
        &drives.loads[place.expect("a load of this name")]
    };
    let hinge = |id: HingeId| (chain.hinges[id].name.to_string(), &chain.hinges[id]);
    let of_load = |id: LoadId, value: &dyn Fn(&str) -> Vec<f64>| {
        let names = repeated(&chain.loads[id].name.to_string(), times);
        names.iter().flat_map(|name| value(name)).collect()
    };
    match what {
        InputKind::Gravity => pick(&drives.gravity, translations),
        InputKind::Force(id) => of_load(id, &|name| pick(&load(name).force, translations)),
        InputKind::Torque(id) => of_load(id, &|name| pick(&load(name).torque, rotations)),
        InputKind::SpringForce(id) => {
            let names = repeated(&chain.springs[id].name.to_string(), times);
            let place =
                |name: &String| truth.springs.iter().position(|spring| spring.name == *name);
            let force = |name| drives.springs[place(name).expect("a spring of this name")];
            names.iter().map(force).collect()
        }
        InputKind::Efforts(id) => {
            let (name, hinge) = hinge(id);
            let Drive::Efforts(kinds) = &hinge.drive else { return Vec::new() };
            let of_hinge = |name: &String| {
                // The rates of a floating base come first. It is not among the hinges of the reference.
                let is_hinge = truth.hinges().any(|hinge| hinge.name == *name);
                let first = if is_hinge { truth.first_rate(name) } else { 0 };
                let given = kinds.iter().zip(&drives.efforts[first..]);
                given.filter(|(kind, _)| **kind == Effort::Input).map(|(_, &effort)| effort)
            };
            repeated(&name, times).iter().flat_map(of_hinge).collect()
        }
        InputKind::Motion(id) => {
            let (name, hinge) = hinge(id);
            let names = repeated(&name, times);
            names.iter().flat_map(|name| named_motion(name, &hinge.kind, truth, drives)).collect()
        }
    }
}

fn motor(chain: &Chain, layout: &Layout, hinge: HingeId, efforts: &[f64]) -> Vec<f64> {
    let Drive::Efforts(kinds) = &chain.hinges[hinge].drive else { return Vec::new() };
    let own = &efforts[layout.v[hinge].clone()];
    let given = kinds.iter().zip(own).filter(|(kind, _)| **kind == Effort::Input);
    given.map(|(_, &effort)| effort).collect()
}

fn motion(
    chain: &Chain,
    hinge: HingeId,
    truth: &mstmm_reference::Chain,
    drives: &Drives,
) -> Vec<f64> {
    let Hinge { name, kind, .. } = &chain.hinges[hinge];
    named_motion(&name.to_string(), kind, truth, drives)
}

/// Returns the motion of a prescribed hinge or of a moving end.
fn named_motion(
    name: &str,
    kind: &HingeKind,
    truth: &mstmm_reference::Chain,
    drives: &Drives,
) -> Vec<f64> {
    if let Some(frame) = truth.frame_motion(drives, name) {
        return frame_motion(kind, frame);
    }
    let mut prescribed = truth.hinges().filter(|hinge| hinge.prescribed);
    let place = prescribed.position(|hinge| hinge.name == name).expect("a prescribed hinge");
    let motion = &drives.motions[place];
    [&motion.q[..], &motion.v, &motion.a].concat()
}

fn frame_motion(kind: &HingeKind, frame: &FrameMotion) -> Vec<f64> {
    let FrameMotion { position: r, orientation, velocity: v, rate, acceleration: a, .. } = frame;
    let turning = frame.rate_derivative;
    match kind {
        HingeKind::Floating => [&r[..], orientation, v, rate, a, &turning].concat(),
        HingeKind::Planar { .. } => {
            let angle = 2.0 * orientation[3].atan2(orientation[0]);
            vec![r[0], r[1], angle, v[0], v[1], rate[2], a[0], a[1], turning[2]]
        }
        _ => vec![r[0], v[0], a[0]],
    }
}
