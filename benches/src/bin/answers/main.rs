//! The answers of generated code as a contender of `benches/peers`, whose README describes its input and
//! output.

mod asked;
#[path = "../../models/with_answers/mod.rs"]
mod models;
mod questions;
mod sample;

use std::error::Error;
use std::time::Duration;
use std::{env, fs};

use asked::Asked;
use models::{Balls3, Balls30, G1, Hyq, Panda};
use mstmm::ChainState;
use mstmm::wide::f64x8;
use mstmm_benches::{Times, from_bytes, random_angles, random_states, to_bytes};
use sample::Task;

const USAGE: &str = "answers states CASE COUNT STATES_OUT
answers repeat CASE COUNT QUESTION
answers QUESTION[_lanes] CASE STATES_IN RESULTS_OUT MILLISECONDS";

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments.as_slice() {
        [question, "D7", ..] if is_wide(question) => run::<Panda<f64x8>>(&arguments),
        [question, "B3", ..] if is_wide(question) => run::<Balls3<f64x8>>(&arguments),
        [_, "D7", ..] => run::<Panda<f64>>(&arguments),
        [_, "B3", ..] => run::<Balls3<f64>>(&arguments),
        [_, "B30", ..] => run::<Balls30<f64>>(&arguments),
        [_, "HyQ", ..] => run::<Hyq<f64>>(&arguments),
        [_, "G1", ..] => run::<G1<f64>>(&arguments),
        _ => Err(USAGE.into()),
    }
}

fn is_wide(question: &str) -> bool {
    question.ends_with("_lanes")
}

fn run<A: Asked>(arguments: &[&str]) -> Result<(), Box<dyn Error>> {
    match *arguments {
        ["states", _, count, path] => {
            let numbers = random_states::<A::State>(count.parse()?);
            Ok(fs::write(path, to_bytes(&numbers))?)
        }
        ["repeat", _, count, question] => {
            let rates = A::State::zero_position().rates().len();
            let state = random_states::<A::State>(1);
            let others = random_angles(5 * rates);
            let numbers = [state, others].concat();
            let task = Task::Repeat(count.parse()?);
            A::default().run(question, &numbers, task).ok_or("no such question")??;
            Ok(())
        }
        [question, _, states, results, milliseconds] => {
            let numbers = from_bytes(&fs::read(states)?);
            let task = Task::Time(Duration::from_millis(milliseconds.parse()?));
            let question = question.trim_end_matches("_lanes");
            let run = A::default().run(question, &numbers, task).ok_or("no such question")??;
            if results != "-" {
                fs::write(results, to_bytes(&run.results))?;
            }
            run.times.iter().for_each(Times::print);
            Ok(())
        }
        _ => Err(USAGE.into()),
    }
}
