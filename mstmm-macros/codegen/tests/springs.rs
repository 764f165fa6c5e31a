//! Springs between bodies, with loops and without: forces, energies, momenta and results.

mod common;

use common::cords::{Cord, End, To, cord, forms, ladder, routes, twins, with_springs};
use common::double_double::DoubleDouble;
use common::interpreter::{Arrays, Judge, run};
use common::points::{points, springs};
use common::scalars::difference_of;
use common::twins::{Numbers, Twin, Twins};
use mstmm_codegen::compile::outputs;
use mstmm_codegen::ids::InputId;
use mstmm_codegen::math::Dual;
use mstmm_codegen::model::Answer;
use mstmm_codegen::program::{Argument, ArrayRole};
use mstmm_reference::Random;
use std::collections::HashMap;
use std::fmt::Write;

const STATES: u64 = 5;

fn solve<S: Judge>(twin: &Twin, given: &Arrays<S>, answer: Answer) -> Arrays<S> {
    let mut arrays = given.clone();
    let ran = run(&twin.compiled.function(answer).procedure, &mut arrays);
    ran.unwrap_or_else(|failed| panic!("{}: {failed:?}", twin.chain.name));
    arrays
}

/// Returns random arguments of a chain.
fn arguments(twin: &Twin, seed: u64) -> HashMap<Argument, Vec<f64>> {
    twin.random_arguments(&mut Random::new(seed))
}

/// Returns a chain with two loads for each spring between bodies, and one for each spring to the ground.
fn with_loads(text: &str, cords: &[Cord]) -> Twin {
    let mut loads = String::new();
    let mut load = |name: &str, suffix: &str, (body, at): End| {
        let at = match text {
            text if text.contains("line chain") => format!("{:?} m", at[0]),
            text if text.contains("plane chain") => format!("{:?} m", &at[..2]),
            _ => format!("{at:?} m"),
        };
        write!(loads, "load {name}_{suffix} {{ on = {body}; at = {at}; force = input; }}")
            .expect("text can be written");
    };
    for Cord { name, on, to } in cords {
        load(name, "on", *on);
        if let To::Body(end) = *to {
            load(name, "to", end);
        }
    }
    let loaded = Twin::new(&text.replace("SPRINGS", &loads), Numbers::Written);
    loaded.unwrap_or_else(|error| panic!("{error}"))
}

/// Returns the forces of springs as inputs of the chain with loads, which follow `inputs` others.
fn forces(cords: &[Cord], results: &[f64], inputs: usize) -> HashMap<Argument, Vec<f64>> {
    let results = results.chunks(results.len() / cords.len());
    let forces = cords.iter().zip(results).flat_map(|(cord, result)| {
        // Length, tension and force belong together.
        let [length, rate, tension] = [result[0], result[1], result[2]];
        let force = result[3..].to_vec();
        let size = force.iter().map(|x| x * x).sum::<f64>().sqrt();
        assert!((size - tension.abs()).abs() < 1e-12 * (1.0 + size), "{}", cord.name);
        let expected = 30.0 * (length - 0.3) + 2.0 * rate;
        assert!((expected - tension).abs() < 1e-12 * (1.0 + size), "{}", cord.name);
        let opposite = force.iter().map(|x| -x).collect();
        let on_body = matches!(cord.to, To::Body(_)).then_some(opposite);
        std::iter::once(force).chain(on_body)
    });
    forces.enumerate().map(|(k, force)| (Argument::Input(InputId(inputs + k)), force)).collect()
}

/// Compares accelerations, efforts, internal forces and bias with those of two loads for each spring.
#[test]
fn springs_pull_like_two_loads() {
    for (text, cords) in (0..3).map(routes).chain(forms()) {
        let (sprung, loaded) = (with_springs(&text, &cords), with_loads(&text, &cords));
        for seed in 0..STATES {
            let mut arguments = arguments(&sprung, seed);
            let at = sprung.set_up(arguments.clone());
            let solution = solve(&sprung, &at, Answer::Solution);
            let is_input = |argument: &&Argument| matches!(argument, Argument::Input(_));
            let inputs = arguments.keys().filter(is_input).count();
            arguments.extend(forces(&cords, &solution.result(outputs::SPRINGS), inputs));
            let pushed = loaded.set_up(arguments);
            let check = |what: &str, ours: &[f64], theirs: &[f64]| {
                let off = difference_of(ours, theirs);
                assert!(off < 1e-10, "{what} are off by {off:e}\n{text}");
            };
            for function in &sprung.compiled.functions {
                let id = match function.answer {
                    Some(Answer::BiasEfforts) => outputs::BIAS_EFFORTS,
                    Some(Answer::Accelerations) => outputs::ACCELERATIONS,
                    Some(Answer::Solution) => outputs::EFFORTS,
                    _ => continue,
                };
                let answer = function.answer.expect("an answer");
                let ours = solve(&sprung, &at, answer).result(id);
                check(id.name, &ours, &solve(&loaded, &pushed, answer).result(id));
            }
            let ours = points(&sprung.chain, &sprung.compiled, &solution);
            let theirs = solve(&loaded, &pushed, Answer::Solution);
            check("points", &ours, &points(&loaded.chain, &loaded.compiled, &theirs));
        }
    }
}

fn compare<S: Judge>(twins: &Twins, state: u64, epsilon: f64) {
    let [repeated, written] = twins.state::<S>(state);
    for function in &twins.repeated.compiled.functions {
        let answer = function.answer.expect("an answer");
        let ours = solve(&twins.repeated, &repeated, answer);
        let theirs = solve(&twins.unrolled, &written, answer);
        let roles = function.procedure.arrays.iter().map(|array| array.role);
        for id in roles.filter_map(|role| match role {
            ArrayRole::Result(id) if id != outputs::BASE_ACCELERATION => Some(id),
            _ => None,
        }) {
            let values = |twin: &Twin, arrays: &Arrays<S>| match id {
                outputs::POINT_NUMBERS => points(&twin.chain, &twin.compiled, arrays),
                outputs::SPRINGS => springs(&twin.chain, arrays),
                _ => arrays.result(id),
            };
            let off =
                difference_of(&values(&twins.repeated, &ours), &values(&twins.unrolled, &theirs));
            assert!(off < epsilon, "{}, {}: off by {off:e}", twins.seed, id.name);
        }
    }
}

#[test]
fn springs_of_repeated_parts_are_those_written_out() {
    let push = "param push = 3 N;";
    let cases = [(0, "riccati"), (1, "riccati"), (2, "riccati"), (0, "transfer")];
    let plain = cases.map(|(dimension, method)| twins(dimension, method, ""));
    let actuated = (0..3).map(|dimension| twins(dimension, "riccati", push));
    for twins in plain.into_iter().chain(actuated) {
        for state in 0..STATES {
            compare::<f64>(&twins, state, 1e-10);
            compare::<DoubleDouble>(&twins, state, 1e-14);
            compare::<f32>(&twins, state, 0.1);
        }
    }
}

#[test]
fn cords_of_a_ladder_are_those_written_out() {
    let ladder = ladder();
    for state in 0..STATES {
        compare::<f64>(&ladder, state, 1e-10);
        compare::<DoubleDouble>(&ladder, state, 1e-14);
        let [repeated, unrolled] = ladder.state(state);
        check_energy(&ladder.repeated, &repeated);
        check_energy(&ladder.unrolled, &unrolled);
    }
}

/// Returns the time derivative of the energy.
fn energy_rate(twin: &Twin, given: &Arrays<f64>) -> f64 {
    let result = |answer, id| solve(twin, given, answer).result(id);
    let moving = given.arguments.iter().map(|(&argument, values)| {
        let slopes = match argument {
            Argument::Coordinates => result(Answer::CoordinateRates, outputs::COORDINATE_RATES),
            Argument::Rates => result(Answer::Accelerations, outputs::ACCELERATIONS),
            _ => vec![0.0; values.len()],
        };
        let dual = values.iter().zip(slopes).map(|(&value, slope)| Dual::new(value, slope));
        (argument, dual.collect())
    });
    let at = twin.set_up::<Dual<f64>>(moving.collect());
    let energies = solve(twin, &at, Answer::Energy).result(outputs::ENERGIES);
    energies.into_iter().map(Dual::derivative).sum()
}

fn check_energy(twin: &Twin, at: &Arrays<f64>) {
    let solution = solve(twin, at, Answer::Solution);
    let count = 3 + twin.chain.dimension.translations().len();
    let all = springs(&twin.chain, &solution);
    let lost: f64 = all.chunks(count).map(|spring| 2.0 * spring[1] * spring[1]).sum();
    let rate = energy_rate(twin, at);
    assert!((rate + lost).abs() < 1e-9 * (1.0 + lost), "{rate} and {lost}");
    let energies = solve(twin, at, Answer::Energy).result(outputs::ENERGIES);
    assert!(difference_of(&energies, &solution.result(outputs::ENERGIES)) < 1e-12);
}

#[test]
fn energy_falls_by_the_power_of_dampers() {
    for dimension in 0..3 {
        let (text, cords) = routes(dimension);
        let twin = with_springs(&text, &cords);
        let twins = twins(dimension, "riccati", "");
        for seed in 0..STATES {
            check_energy(&twin, &twin.set_up(arguments(&twin, seed)));
            let [repeated, _] = twins.state(seed);
            check_energy(&twins.repeated, &repeated);
        }
    }
}

/// The momenta of free balls of uniform inertia that springs connect.
#[test]
fn springs_keep_the_momenta_of_a_free_chain() {
    let text = "chain Free {
        body Ball { mass = 2 kg; com = [0, 0, 0] m; inertia = diag(0.3, 0.3, 0.3) kg*m^2 about com; output = [0.5, 0.2, 0] m; }
        Ball one -> ball a -> Ball two -> slider(y) b -> Ball three -> pin(z) c -> Ball four -> universal(x, y) d
            -> Ball five -> pin(z) e -> Ball six -> pin(x) f -> Ball seven -> pin(y) g -> Ball eight;
        SPRINGS
    }";
    let cords = [
        cord("near", ("one", [0.1, 0.2, 0.3]), To::Body(("two", [0.3, 0.2, -0.3]))),
        cord("middle", ("four", [0.1, 0.2, 0.3]), To::Body(("one", [0.3, 0.2, -0.3]))),
        cord("far", ("eight", [0.1, 0.2, 0.3]), To::Body(("one", [0.3, 0.2, -0.3]))),
    ];
    let twin = with_springs(text, &cords);
    for seed in 0..STATES {
        let at = twin.set_up(arguments(&twin, seed));
        let points = points(&twin.chain, &twin.compiled, &solve(&twin, &at, Answer::Solution));
        let points: Vec<&[f64]> = points.chunks(points.len() / 16).collect();
        let mut momenta = [0.0; 6];
        let mut size = 0.0_f64;
        for body in 0..8 {
            // Position, orientation, velocity, angular velocity, acceleration, angular acceleration.
            let input = points[2 * body];
            let (r, a, alpha) = (&input[..3], &input[18..21], &input[21..24]);
            for k in 0..3 {
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                momenta[k] += 2.0 * a[k];
                momenta[3 + k] += 2.0 * (r[i] * a[j] - r[j] * a[i]) + 0.3 * alpha[k];
                size = size.max(a[k].abs());
            }
        }
        assert!(momenta.iter().all(|x| x.abs() < 1e-10 * size), "{momenta:?}");
    }
}

#[test]
fn springs_of_length_zero_are_finite() {
    let (text, mut cords) = routes(0);
    cords.truncate(1);
    (cords[0].on, cords[0].to) = (("b1", [0.0; 3]), To::Body(("a1", [0.2, 0.3, 0.1])));
    let twin = with_springs(&text, &cords);
    let at = twin.set_up(arguments(&twin, 0));
    let solution = solve(&twin, &at, Answer::Solution);
    assert!(solution.result(outputs::ACCELERATIONS).iter().all(|x| x.is_finite()));
    let spring = solution.result(outputs::SPRINGS);
    assert!(spring[0] < 1e-14, "{spring:?}");
    assert!(spring.iter().all(|x| x.abs() < 20.0), "{spring:?}");
}

/// Springs that cannot move anything cost nothing, and springs across few hinges need no poses.
#[test]
fn springs_within_a_link_cost_nothing() {
    let (text, all) = routes(0);
    let count = |name: &str| {
        let cords: Vec<Cord> = all.iter().filter(|cord| cord.name == name).cloned().collect();
        let twin = with_springs(&text, &cords);
        twin.compiled.function(Answer::Accelerations).procedure.cost().arithmetic()
    };
    let without = count("");
    assert_eq!([count("welded"), count("at_rest")], [without; 2]);
    let [next, held] = [count("next"), count("held")];
    assert!(next < without + 100, "a spring across a pin costs {} operations", next - without);
    assert!(held > next, "a spring to the ground costs {} operations", held - without);
}
