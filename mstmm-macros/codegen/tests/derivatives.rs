//! Runs procedures on dual numbers, including loops: the derivatives agree with difference quotients, and the energy changes
//! by the power of the motors.

mod common;

use common::double_double::DoubleDouble;
use common::interpreter::{Arrays, Judge, run};
use common::scalars::difference_of;
use common::twins::{Numbers, Twin, Twins};
use mstmm_codegen::compile::outputs;
use mstmm_codegen::math::Dual;
use mstmm_codegen::model::Answer;
use mstmm_codegen::program::{Argument, ArrayRole, Procedure};
use mstmm_reference::{Ends, HingeChoice, Random, Recipe};
use std::collections::HashMap;

type Arguments<S> = HashMap<Argument, Vec<S>>;

/// Combines the values of two sets of arguments.
fn zip<S: Copy, T>(
    one: &Arguments<S>,
    other: &Arguments<S>,
    join: impl Fn(S, S) -> T,
) -> Arguments<T> {
    let joined = |(argument, values): (&Argument, &Vec<S>)| {
        let pairs = values.iter().zip(&other[argument]);
        (*argument, pairs.map(|(&one, &other)| join(one, other)).collect())
    };
    one.iter().map(joined).collect()
}

fn results<S: Judge>(twin: &Twin, procedure: &Procedure, arguments: Arguments<S>) -> Vec<S> {
    let mut arrays: Arrays<S> = twin.set_up(arguments);
    let ran = run(procedure, &mut arrays);
    ran.unwrap_or_else(|failed| panic!("{}: {failed:?}", twin.chain.name));
    let roles = procedure.arrays.iter().map(|array| array.role);
    let ids = roles.filter_map(|role| match role {
        ArrayRole::Result(id) => Some(id),
        _ => None,
    });
    ids.flat_map(|id| arrays.result(id)).collect()
}

/// Compares the derivatives of all results of all functions along a random direction of all arguments.
fn compare_with_differences(seed: u64, twins: &Twins) {
    // The step leaves an error of its square, and rounding divided by it, which terms that cancel enlarge: both
    // are below that of `f64`.
    let step = DoubleDouble::new(1e-7);
    let half = (step + step).recip();
    let twin = &twins.repeated;
    let [at, _] = twins.state::<DoubleDouble>(0);
    let mut random = Random::new(seed);
    // One direction after the other in an order that is the same everywhere.
    let mut along = at.arguments.clone();
    let unknowns = twin.compiled.unknowns.arguments();
    for argument in unknowns.map(|(argument, _)| argument).chain([Argument::Time]) {
        let values = along.get_mut(&argument).expect("it is given");
        values.iter_mut().for_each(|x| *x = DoubleDouble::new(random.between(-1.0, 1.0)));
    }
    for function in &twin.compiled.functions {
        let answer = function.answer.expect("an answer");
        let run_at = |step| {
            let moved = zip(&at.arguments, &along, |x, slope| x + slope * step);
            results(twin, &function.procedure, moved)
        };
        let (forth, back) = (run_at(step), run_at(-step));
        let quotients = forth.iter().zip(&back).map(|(&forth, &back)| (forth - back) * half);
        let quotients: Vec<f64> = quotients.map(Judge::plain).collect();
        let dual = |x: DoubleDouble, slope: DoubleDouble| Dual::new(x.high, slope.high);
        let moving = results(twin, &function.procedure, zip(&at.arguments, &along, dual));
        let derivatives: Vec<f64> = moving.into_iter().map(Dual::derivative).collect();
        let off = difference_of(&derivatives, &quotients);
        assert!(off < 1e-9, "seed {seed}, {answer:?}: off by {off:e}");
    }
}

/// Open chains only: a loop closure without constraints has square roots of zero, which have no derivative.
#[test]
fn derivatives_are_those_of_differences() {
    for seed in (0..48).filter(|seed| seed % 4 != 3) {
        if let Some(twins) = Twins::random(seed, Numbers::Written) {
            compare_with_differences(seed, &twins);
        }
    }
}

/// Returns the power of all motors of a chain.
fn power(twin: &Twin, given: &Arrays<f64>) -> f64 {
    let rates = &given.arguments[&Argument::Rates];
    let solution = &twin.compiled.function(Answer::Solution).procedure;
    let mut arrays = given.clone();
    run(solution, &mut arrays).expect("a regular chain");
    arrays.result(outputs::EFFORTS).iter().zip(rates).map(|(effort, rate)| effort * rate).sum()
}

/// Returns the time derivative of the energy of a chain that moves with its accelerations.
fn energy_rate(twin: &Twin, given: &Arrays<f64>) -> f64 {
    let result = |answer, id| {
        let mut arrays = given.clone();
        run(&twin.compiled.function(answer).procedure, &mut arrays).expect("a regular chain");
        arrays.result(id)
    };
    let still = |values: &Vec<f64>| vec![0.0; values.len()];
    let slopes = given.arguments.iter().map(|(&argument, values)| {
        let slopes = match argument {
            Argument::Coordinates => result(Answer::CoordinateRates, outputs::COORDINATE_RATES),
            Argument::Rates => result(Answer::Accelerations, outputs::ACCELERATIONS),
            _ => still(values),
        };
        (argument, slopes)
    });
    let moving = zip(&given.arguments, &slopes.collect(), Dual::new);
    let mut arrays = twin.set_up(moving);
    run(&twin.compiled.function(Answer::Energy).procedure, &mut arrays).expect("no test");
    arrays.result(outputs::ENERGIES).into_iter().map(Dual::derivative).sum()
}

#[test]
fn energy_changes_by_the_power_of_motors() {
    for seed in 0..40 {
        let mut random = Random::new(seed);
        let ends = [Ends::HeldFree, Ends::FreeFree][seed as usize % 2];
        let recipe = Recipe::plain(3, ends, &HingeChoice::ALL);
        let Some(twins) = Twins::of(seed, &mut random, &recipe, Numbers::Written) else { continue };
        let [given, _] = twins.state::<f64>(0);
        let (power, rate) = (power(&twins.repeated, &given), energy_rate(&twins.repeated, &given));
        assert!((power - rate).abs() < 1e-10 * (1.0 + power.abs()), "seed {seed}: {power} {rate}");
    }
}
