//! dynibo's algorithms for the answers, on an arm from a URDF file:
//!
//! ```text
//! contender MODEL WHAT STATES RESULTS MILLISECONDS
//! ```
//!
//! The tip is the link `tip`. The arm has as many coordinates as rates.

#[path = "../../src/timing.rs"]
mod timing;

use std::error::Error;
use std::hint::black_box;
use std::time::Duration;
use std::{env, fs};

use dynibo::{LinkId, Robot};
use timing::{Times, from_bytes, to_bytes};

/// The numbers of a state for each rate: coordinates, rates, efforts, accelerations, a direction and weights.
const PARTS: usize = 8;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [model, what, states, results, milliseconds] = arguments.as_slice() else {
        return Err("contender MODEL WHAT STATES RESULTS MILLISECONDS".into());
    };
    let mut robot = Robot::from_urdf(model)?;
    let tip = robot.link_id("tip")?;
    let count = robot.generalized_count();
    let numbers = from_bytes(&fs::read(states)?);
    let states: Vec<&[f64]> = numbers.chunks_exact(PARTS * count).collect();
    let (evaluate, size) = question(what, count).ok_or("no such question")?;
    let mut result = vec![0.0; size];
    if results != "-" {
        let mut all = Vec::new();
        for state in &states {
            evaluate(&mut robot, tip, state, &mut result)?;
            all.extend_from_slice(&result);
        }
        fs::write(results, to_bytes(&all))?;
    }
    let budget = Duration::from_millis(milliseconds.parse()?);
    let times = Times::of(budget, &states, 1, |state| {
        let evaluated = evaluate(&mut robot, tip, black_box(state), black_box(&mut result));
        let _ = black_box(evaluated);
    });
    times.print();
    Ok(())
}

type Evaluate = fn(&mut Robot, LinkId, &[f64], &mut [f64]) -> dynibo::Result<()>;

/// Returns the function of a question and the number of its results.
fn question(name: &str, count: usize) -> Option<(Evaluate, usize)> {
    Some(match name {
        "accelerations" => (
            |robot, _, state, result| {
                robot.forward_dynamics(part(state, 0), part(state, 1), part(state, 2), &[], result)
            },
            count,
        ),
        "inverse_dynamics" => (
            |robot, _, state, result| {
                robot.inverse_dynamics(part(state, 0), part(state, 1), part(state, 3), &[], result)
            },
            count,
        ),
        "mass_matrix" => {
            (|robot, _, state, result| robot.mass_matrix(part(state, 0), result), count * count)
        }
        "jacobian" => (|robot, tip, state, result| robot.jacobian(part(state, 0), tip, result), 6 * count),
        _ => return None,
    })
}

/// Returns a part of a state.
fn part(state: &[f64], index: usize) -> &[f64] {
    let count = state.len() / PARTS;
    &state[index * count..(index + 1) * count]
}
