//! Compares all functions of random chains with repeated parts with those of the same chains written out.

mod common;

use common::double_double::DoubleDouble;
use common::interpreter::{Arrays, Judge, run};
use common::points::{points, springs};
use common::scalars::difference_of;
use common::twins::{Numbers, Twin, Twins};
use mstmm_codegen::compile::{CompiledFunction, outputs};
use mstmm_codegen::program::ArrayRole;

/// The tolerance in units in the last place, in either precision: the chains' condition numbers reach a few thousand.
const UNITS: f64 = 5e4;

/// Returns all results of a function by name; points are in inertial axes.
fn results<S: Judge>(
    twin: &Twin,
    function: &CompiledFunction,
    given: &Arrays<S>,
) -> Vec<(&'static str, Vec<S>)> {
    let mut arrays = given.clone();
    let ran = run(&function.procedure, &mut arrays);
    ran.unwrap_or_else(|failed| panic!("{}: {failed:?}", function.name()));
    let roles = function.procedure.arrays.iter().map(|array| array.role);
    let results = roles.filter_map(|role| {
        let ArrayRole::Result(id) = role else { return None };
        match id {
            outputs::BASE_ACCELERATION => None,
            outputs::POINT_NUMBERS => Some((id.name, points(&twin.chain, &twin.compiled, &arrays))),
            outputs::SPRINGS => Some((id.name, springs(&twin.chain, &arrays))),
            // Pivots and the excess are measured by what would be there if nothing cancelled, which loops add up
            // in another way.
            outputs::RESIDUAL => Some((id.name, vec![arrays.result(id)[0]])),
            outputs::CLOSURE_PIVOTS => {
                let is_there = |pivot: &S| S::number(f64::from(pivot.plain() > 1e-20));
                Some((id.name, arrays.result(id).iter().map(is_there).collect()))
            }
            _ => Some((id.name, arrays.result(id))),
        }
    });
    let mut results: Vec<_> = results.collect();
    results.sort_by_key(|(name, _)| *name);
    results
}

/// Compares all functions.
fn compare<S: Judge>(twins: &Twins, epsilon: f64) {
    let [repeated, unrolled] = twins.state::<S>(0);
    for function in &twins.repeated.compiled.functions {
        let answer = function.answer.expect("an answer");
        let one = results(&twins.repeated, function, &repeated);
        let other = results(&twins.unrolled, twins.unrolled.compiled.function(answer), &unrolled);
        for ((name, one), (other_name, other)) in one.iter().zip(&other) {
            let what = format!("seed {}, {}: {name}", twins.seed, function.name());
            assert_eq!(name, other_name, "{what}");
            let off = difference_of(one, other);
            assert!(off <= UNITS * epsilon, "{what}: off by {off:e}");
        }
        assert_eq!(one.len(), other.len());
    }
    let functions = |twin: &Twin| twin.compiled.functions.len();
    assert_eq!(functions(&twins.repeated), functions(&twins.unrolled), "seed {}", twins.seed);
}

/// Every third chain is also compared in twice the precision, with all numbers as parameters, so that nothing is rounded at
/// compile time. Both agree to the same number of units of that precision, so that they differ by rounding only.
fn check(seeds: std::ops::Range<u64>) {
    let mut compared = 0;
    for seed in seeds.clone() {
        let numbers = if seed.is_multiple_of(3) { Numbers::Lifted } else { Numbers::Written };
        let Some(twins) = Twins::random(seed, numbers) else { continue };
        compare::<f64>(&twins, f64::EPSILON);
        if numbers == Numbers::Lifted {
            compare::<DoubleDouble>(&twins, DoubleDouble::EPSILON.high);
        }
        compared += 1;
    }
    let all = seeds.end - seeds.start;
    assert!(compared > all * 9 / 10, "only {compared} of {all} chains are taken");
}

#[test]
fn random_chains() {
    check(0..70);
}

#[test]
fn more_random_chains() {
    check(70..140);
}

#[test]
fn still_more_random_chains() {
    check(140..210);
}
