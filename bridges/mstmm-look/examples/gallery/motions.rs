//! The motions of the gallery.

use crate::chains::{Crane, Dog, FourBar, FourBarInputs, Train, TrainInputs, Tree};
use mstmm::description::{Geometry, Shape};
use mstmm::prelude::*;
use mstmm::{ChainState, Described, Error};
use mstmm_look::{Motion, Options, Recording};

/// Integrates a chain, and records a frame after every `steps` steps.
pub fn record<C>(
    chain: &C,
    (frames, steps, step): (usize, usize, f64),
    inputs: impl Fn(f64, &C::State) -> C::Inputs,
) -> Result<Motion, Error>
where
    C: Described<Scalar = f64>,
{
    let mut state = chain.initial_state();
    let at_rest = inputs(0.0, &state);
    chain.assemble(&mut state, &at_rest)?;
    let mut recording = Recording::with(chain, Options::default().stride(steps));
    let mut rk4 = Rk4::new(step);
    for _ in 0..(frames - 1) * steps + 1 {
        recording.record(&state, &inputs(state.time(), &state))?;
        rk4.step(chain, &mut state, &inputs)?;
    }
    Ok(recording.into_motion())
}

/// The crane swings for four seconds.
pub fn crane() -> Result<Motion, Error> {
    let chain = Crane::new();
    record(&chain, (401, 10, 1e-3), |_, _| chain.no_inputs())
}

/// The dog struggles for three seconds. Its bodies have shapes of all kinds.
pub fn dog() -> Result<Motion, Error> {
    let chain = Dog::new();
    let mut motion = record(&chain, (301, 10, 1e-3), |time, _| {
        let mut inputs = chain.no_inputs();
        inputs.fl_knee = 3.0 * (9.0 * time).sin();
        inputs.hr_knee = -2.0 * (9.0 * time).sin();
        inputs
    })?;
    let at = |geometry, position| Shape { geometry, position, orientation: [1.0, 0.0, 0.0, 0.0] };
    let along_x = [0.5f64.sqrt(), 0.0, 0.5f64.sqrt(), 0.0];
    for body in &mut motion.mechanism_mut().bodies {
        body.shapes = match body.type_name.as_str() {
            "Trunk" => vec![
                at(Geometry::Box([0.62, 0.22, 0.16]), [0.0; 3]),
                Shape {
                    orientation: along_x,
                    ..at(Geometry::Cylinder { radius: 0.1, length: 0.1 }, [0.34, 0.0, 0.02])
                },
            ],
            "Head" => vec![
                at(Geometry::Sphere { radius: 0.075 }, [0.16, 0.0, 0.13]),
                at(Geometry::Box([0.12, 0.07, 0.06]), [0.25, 0.0, 0.11]),
            ],
            "Thigh" => {
                vec![at(Geometry::Capsule { radius: 0.035, length: 0.22 }, [0.0, 0.0, -0.125])]
            }
            "Shank" => {
                vec![at(Geometry::Capsule { radius: 0.022, length: 0.22 }, [0.0, 0.0, -0.12])]
            }
            _ => vec![],
        };
    }
    Ok(motion)
}

/// The linkage turns for four seconds.
pub fn four_bar() -> Result<Motion, Error> {
    let chain = FourBar::new();
    record(&chain, (401, 10, 1e-3), |_, state| FourBarInputs { a: 10.0 * (6.0 - state.v[0]) })
}

/// The train is pulled for twenty seconds.
pub fn train() -> Result<Motion, Error> {
    let chain = Train::new();
    record(&chain, (201, 20, 5e-3), |time, _| TrainInputs {
        engine_force: if time < 5.0 { 4e4 } else { -1e4 },
    })
}

/// The tree moves for `frames` frames of 2 ms.
pub fn tree(frames: usize) -> Result<Motion, Error> {
    let chain = Tree::new();
    record(&chain, (frames, 1, 2e-3), |_, _| chain.no_inputs())
}
