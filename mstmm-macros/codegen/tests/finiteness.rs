//! Tests that functions reject arguments that are not finite: NaN and infinity in every entry, also of repeated parts. Tests
//! the order in which the checks of a function fail.

mod common;

use common::interpreter::{Arrays, Failed, run};
use common::twins::{Numbers, Twin, Twins};
use mstmm_codegen::compile::compile;
use mstmm_codegen::model::{Answer, Layout};
use mstmm_codegen::program::{Argument, ArrayRole, Failure, Procedure, Step};
use mstmm_codegen::read_and_examine;

const BAD: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

const TESTED: [Answer; 4] =
    [Answer::Accelerations, Answer::ImplicitAccelerations, Answer::Solution, Answer::BiasEfforts];

/// Returns the functions of a chain that test whether values are finite.
fn tested(twin: &Twin) -> impl Iterator<Item = (Answer, &Procedure)> {
    let functions = TESTED.into_iter().filter_map(|answer| twin.compiled.find(answer));
    functions.map(|function| (function.answer.expect("an answer"), &function.procedure))
}

/// Returns the entries that the caller supplies at every step. Parameters, slots and elimination steps of a loop closure are
/// checked when they are set.
fn places(given: &Arrays<f64>) -> Vec<(Argument, usize)> {
    let is_given = |argument: &&Argument| {
        use Argument::{Coordinates, Input, Rates, Time};
        matches!(argument, Coordinates | Rates | Input(_) | Time)
    };
    let arguments = given.arguments.iter().filter(|(argument, _)| is_given(argument));
    let places =
        arguments.flat_map(|(&argument, values)| (0..values.len()).map(move |k| (argument, k)));
    places.collect()
}

/// Returns the results of a procedure, with none for entries that have not been written.
fn results_of(procedure: &Procedure, arrays: &Arrays<f64>) -> Vec<Vec<Option<f64>>> {
    let roles = procedure.arrays.iter().map(|array| array.role);
    let ids = roles.filter_map(|role| match role {
        ArrayRole::Result(id) => Some(id),
        _ => None,
    });
    ids.map(|id| arrays.results.get(&id).cloned().unwrap_or_default()).collect()
}

/// Puts NaN and infinities into every entry of the arguments of a chain.
fn refuses_values_that_are_not_finite(seed: u64, twin: &Twin, good: &Arrays<f64>) {
    for (answer, procedure) in tested(twin) {
        let mut before = good.clone();
        let ran = run(procedure, &mut before);
        assert_eq!(ran, Ok(()), "seed {seed}, {answer:?}: a regular state");
        let entries = results_of(procedure, &before).concat();
        assert!(entries.iter().all(|x| x.is_some_and(f64::is_finite)), "seed {seed}, {answer:?}");
        for (argument, entry) in places(good) {
            for bad in BAD {
                let mut after = before.clone();
                after.arguments.get_mut(&argument).expect("it is given")[entry] = bad;
                let ran = run(procedure, &mut after);
                let what = format!("seed {seed}, {answer:?}: {bad} at {entry} of {argument:?}");
                assert_eq!(ran, Err(Failed::NotFinite), "{what}");
                let left = results_of(procedure, &after);
                match procedure.failure {
                    Failure::Untouched => {
                        assert_eq!(left, results_of(procedure, &before), "{what}")
                    }
                    Failure::PartlyWritten => {}
                    Failure::Reset => {
                        let initial = procedure.arrays.iter().flat_map(|array| &array.initial);
                        let initial: Vec<f64> = initial.map(|&(_, value)| value).collect();
                        let mut left = left.concat().into_iter().flatten();
                        assert!(left.all(|x| initial.contains(&x)), "{what}");
                    }
                }
            }
        }
    }
}

#[test]
fn every_entry_is_tested() {
    for seed in 0..24 {
        let Some(twins) = Twins::random(seed, Numbers::Written) else { continue };
        let [repeated, unrolled] = twins.state::<f64>(0);
        refuses_values_that_are_not_finite(seed, &twins.repeated, &repeated);
        if seed.is_multiple_of(4) {
            refuses_values_that_are_not_finite(seed, &twins.unrolled, &unrolled);
        }
    }
}

/// Returns a chain of repeated hinges whose last body has a mass for every repetition, and no other inertia.
fn points(method: &str, hinges: &str) -> Twin {
    let text = format!(
        "chain Points {{
             method = {method};
             param mass[3] = 1 kg;
             gravity = [0, -9.8, 0] m/s^2;
             body Rod {{ mass = 1 kg; com = [0.5, 0, 0] m; output = [1, 0, 0] m;
                 inertia = diag(0, 0.1, 0.1) kg*m^2 about com; }}
             body Point {{ mass = mass; com = [0.3, 0, 0] m; output = [1, 0, 0] m;
                 inertia = diag(0, 0, 0) kg*m^2 about com; }}
             ground -> pin(z) first -> Rod base -> repeat 3 {{ {hinges} }};
         }}"
    );
    Twin::new(&text, Numbers::Written).unwrap_or_else(|error| panic!("{error}"))
}

/// Returns a state in which every entry has a value.
fn state(twin: &Twin, masses: [f64; 3]) -> Arrays<f64> {
    let unknowns = twin.compiled.unknowns.arguments();
    let mut arguments = std::collections::HashMap::from([(Argument::Time, vec![0.0])]);
    for (argument, layout) in unknowns {
        let values = match argument {
            Argument::Parameter(_) => masses.to_vec(),
            _ => (0..layout.total).map(|k| 0.3 + 0.2 * k as f64).collect(),
        };
        arguments.insert(argument, values);
    }
    twin.set_up(arguments)
}

#[test]
fn a_repeated_hinge_without_inertia_is_named() {
    for (method, hinges, singular) in [
        ("riccati", "pin(z) turn -> Point b", "turn"),
        ("transfer", "pin(z) turn -> Point b", "turn"),
        ("riccati", "pin(y) bend -> Rod a -> pin(z) turn -> Point b", "turn"),
        ("riccati", "slider(x) slide -> Point b", "slide"),
    ] {
        let twin = points(method, hinges);
        for (answer, procedure) in tested(&twin).filter(|(it, _)| *it != Answer::BiasEfforts) {
            let failed = |masses| run(procedure, &mut state(&twin, masses)).err();
            assert_eq!(failed([1.0, 2.0, 3.0]), None, "{method} {hinges} {answer:?}");
            // Nothing beyond the last hinge has inertia.
            let named = Some(Failed::Singular(singular.to_owned()));
            assert_eq!(failed([1.0, 2.0, 0.0]), named, "{method} {hinges} {answer:?}");
        }
    }
}

/// Arguments that no result covers are tested first, then pivots, then results.
#[test]
fn the_first_failure_is_reported() {
    let twin = points("riccati", "pin(z) turn -> Point b");
    let singular = || Some(Failed::Singular("turn".to_owned()));
    for (answer, procedure) in tested(&twin).filter(|(it, _)| *it != Answer::BiasEfforts) {
        let failed = |masses, argument: Argument, number: f64| {
            let mut given = state(&twin, masses);
            given.arguments.get_mut(&argument).expect("it is given")[0] = number;
            run(procedure, &mut given).err()
        };
        let is_first = |argument: Argument| match procedure.body.first() {
            Some(Step::CheckArguments(arrays)) => {
                let mut roles = arrays.iter().map(|&array| procedure.arrays[array].role);
                roles.any(|role| role == ArrayRole::Argument(argument))
            }
            _ => false,
        };
        for argument in [Argument::Coordinates, Argument::Rates, Argument::Time] {
            let what = format!("{answer:?} {argument:?}");
            let found = failed([1.0, 2.0, 0.0], argument, f64::NAN);
            let expected = if is_first(argument) { Some(Failed::NotFinite) } else { singular() };
            assert_eq!(found, expected, "{what}");
            assert_eq!(
                failed([1.0, 2.0, 3.0], argument, f64::NAN),
                Some(Failed::NotFinite),
                "{what}"
            );
        }
        // Its square is not finite.
        assert_eq!(failed([1.0, 2.0, 0.0], Argument::Rates, 1e200), singular(), "{answer:?}");
        let overflow = failed([1.0, 2.0, 3.0], Argument::Rates, 1e200);
        assert_eq!(overflow, Some(Failed::NotFinite), "{answer:?}");
    }
}

/// Returns for each answer of a chain whether its results are tested only if arguments are large.
fn is_bounded(hinges: &str) -> impl Fn(Answer) -> bool {
    let text = format!(
        "chain Cubes {{ answers = [basic, regressor, derivatives, linearize];
            body Cube {{ mass = 1 kg; com = [0.5, 0, 0] m; output = [1, 0, 0] m;
                inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input; }}
            ground {hinges}; }}"
    );
    let tokens = text.parse().unwrap_or_else(|error| panic!("{error}\n{text}"));
    let chains = read_and_examine(tokens).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let (chain, findings) = &chains[0];
    let compiled = compile(chain, findings, &Layout::of(chain));
    move |answer| {
        let function = compiled.find(answer).unwrap_or_else(|| panic!("{answer:?} is missing"));
        let steps = &function.procedure.body;
        let is_bounded = steps.iter().any(|step| matches!(step, Step::TestBounds(_)));
        if is_bounded {
            let last = steps.last();
            let tests_results = |step: &Step| matches!(step, Step::CheckResults(check) if !check.unless_bounded.is_empty());
            assert!(last.is_some_and(tests_results), "{answer:?}: results are tested when stored");
        }
        is_bounded
    }
}

#[test]
fn large_matrices_without_divisions_are_tested_if_arguments_are_large() {
    let many = is_bounded(
        "-> ball a -> Cube b -> ball c -> Cube d -> ball e -> Cube f -> ball g -> Cube h",
    );
    for answer in [Answer::MassMatrix, Answer::Regressor, Answer::InverseDynamicsDerivatives] {
        assert!(many(answer), "{answer:?}");
    }
    for answer in [Answer::InverseMassMatrix, Answer::Linearization, Answer::InverseDynamics] {
        assert!(!many(answer), "{answer:?}");
    }
    let few = is_bounded("-> ball a -> Cube b -> pin(z) c -> Cube d");
    assert!(!few(Answer::MassMatrix));
}
