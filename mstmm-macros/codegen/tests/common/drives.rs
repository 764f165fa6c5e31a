//! Converts the drives of the reference solver to inputs of the compiler.

use mstmm_codegen::model::{
    Chain, Drive, Effort, Hinge, HingeId, HingeKind, Input, InputKind, Layout,
};
use mstmm_reference::{Drives, FrameMotion};

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
            InputKind::Efforts(hinge) => motor(chain, &layout, hinge, &drives.efforts),
            InputKind::Motion(hinge) => motion(chain, hinge, truth, drives),
        }
    };
    layout.inputs.iter().flat_map(of).collect()
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
    if let Some(frame) = truth.frame_motion(drives, &name.to_string()) {
        return frame_motion(kind, frame);
    }
    let mut prescribed = truth.hinges().filter(|hinge| hinge.prescribed);
    let place = prescribed.position(|hinge| *name == hinge.name).expect("a prescribed hinge");
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
