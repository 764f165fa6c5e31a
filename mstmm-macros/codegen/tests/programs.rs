//! Compares procedures with the equations on random chains: an interpreter runs the procedures on `f64`, without rustc.

mod common;

use common::given::Given;
use common::interpreter::{Arrays, run};
use common::points::points;
use common::{Point, compute, compute_with, difference, drives, read};
use mstmm_codegen::compile::{compile, outputs};
use mstmm_codegen::equations::Axes;
use mstmm_codegen::examine::Findings;
use mstmm_codegen::math::{Structured, Vec3};
use mstmm_codegen::model::{Answer, Dimension, Layout, SolutionMethod};
use mstmm_codegen::program::{Argument, ArrayRole};
use mstmm_reference::{Random, Recipe, random_mechanism, random_motion};

/// Returns the results at a point, in inertial axes.
fn numbers(point: &Point<Structured<f64>>, dimension: Dimension) -> Vec<f64> {
    let (translations, rotations) = (dimension.translations(), dimension.rotations());
    let pick = |vector: Vec3<Structured<f64>>, axes: &[usize]| -> Vec<f64> {
        axes.iter().map(|&axis| vector[axis].value()).collect()
    };
    let rotation = point.rotation.transposed().0.map(Vec3);
    [
        pick(point.position, translations),
        rotation[..dimension.columns()]
            .iter()
            .flat_map(|&column| pick(column, translations))
            .collect(),
        pick(point.velocity, translations),
        pick(point.omega, rotations),
        pick(point.acceleration.linear, translations),
        pick(point.acceleration.angular, rotations),
        pick(point.moment, rotations),
        pick(point.force, translations),
    ]
    .concat()
}

/// Compares procedures and equations of one random chain in a random state.
fn one_chain(seed: u64) {
    let mut random = Random::new(seed);
    let recipe = Recipe::any(&mut random, 5);
    let description = random_mechanism(&mut random, "Random", &recipe);
    let (state, driven) = random_motion(&mut random, &description);
    for (word, method) in
        [("riccati", SolutionMethod::Riccati), ("transfer", SolutionMethod::Transfer)]
    {
        let chain = read(&description.to_macro_text(Some(word)));
        let compiled = compile(&chain, &Findings::default(), &Layout::of(&chain));
        let inputs = drives::inputs(&chain, &description, &driven);
        let unknowns = [&state.q[..], &state.v, &inputs, &[0.0]].concat();
        let given = Given::new(&compiled, &unknowns);
        let run = |answer| given.run(answer).unwrap_or_else(|failed| panic!("{seed}: {failed:?}"));
        let expected =
            compute_with::<f64>(&chain, (method, Axes::Body), (&state.q, &state.v, &inputs));
        let (fast, full) = (run(Answer::Accelerations), run(Answer::Solution));
        let plain = |values: &[Structured<f64>]| values.iter().map(|x| x.value()).collect();
        let energies: Vec<f64> = plain(&[expected.energy.kinetic, expected.energy.potential]);
        let efforts: Vec<f64> = plain(&expected.report.efforts);
        let points = points(&chain, &compiled, &full);
        let expected_points: Vec<f64> = expected
            .report
            .points
            .iter()
            .flat_map(|point| numbers(point, chain.dimension))
            .collect();
        let off =
            |arrays: &Arrays<f64>, id, expected: &[f64]| difference(&arrays.result(id), expected);
        let accelerations = outputs::ACCELERATIONS;
        let mut differences = vec![
            ("fast accelerations", off(&fast, accelerations, &expected.accelerations)),
            ("accelerations", off(&full, accelerations, &expected.accelerations)),
            ("energies", off(&full, outputs::ENERGIES, &energies)),
            ("energies alone", off(&run(Answer::Energy), outputs::ENERGIES, &energies)),
            ("efforts", off(&full, outputs::EFFORTS, &efforts)),
            ("points", difference(&points, &expected_points)),
        ];
        if compiled.find(Answer::ImplicitAccelerations).is_some() {
            // A step of no length is an explicit one.
            let explicit = run(Answer::ImplicitAccelerations);
            differences.push(("implicit", off(&explicit, accelerations, &expected.accelerations)));
        }
        if compiled.find(Answer::Correction).is_some() {
            let corrected = run(Answer::Correction);
            let residual = corrected.result(outputs::RESIDUAL)[0];
            differences.extend([
                ("closed coordinates", off(&corrected, outputs::COORDINATES, &state.q)),
                ("closed rates", off(&corrected, outputs::RATES, &state.v)),
                ("residual", residual),
            ]);
        }
        for (what, size) in differences {
            // The same operations but for reordering: condition numbers of a few thousand. The
            // reference closes chains to 1e-12.
            let tolerance =
                if what.contains("closed") || what == "residual" { 1e-9 } else { 1e-10 };
            assert!(size < tolerance, "seed {seed}, {method:?}: {what} differ by {size:e}");
        }
    }
}

#[test]
fn programs_compute_the_equations() {
    (0..100).for_each(one_chain);
}

#[test]
fn parameters_are_folded_into_slots_once() {
    let text = |mass: &str| {
        format!(
            "chain Arm {{ gravity = [0, -9.8, 0]; param extra = 0.7 kg;
             body Rod {{ mass = {mass}; com = [0.5, 0, 0]; output = [1, 0, 0];
                 inertia = diag(0.1, 1, 1) about com; }}
             ground -> pin(z) a -> Rod upper -> pin(y) b -> Rod lower; }}"
        )
    };
    let (q, v) = ([0.3, -0.4], [1.0, 2.0]);
    let with = read(&text("1.3 kg + extra"));
    let compiled = compile(&with, &Findings::default(), &Layout::of(&with));
    let given = Given::new(&compiled, &[0.7, q[0], q[1], v[0], v[1], 0.0]);
    let mut arrays = given.arrays.clone();
    run(&compiled.setup.procedure, &mut arrays).expect("a setup cannot fail");
    let computed = given.run(Answer::Accelerations).expect("a regular chain");
    let expected = compute::<f64>(
        &read(&text("2 kg")),
        (SolutionMethod::Riccati, Axes::Body),
        &q,
        &v,
        &[0.0, 0.0],
    );
    let off = difference(&computed.result(outputs::ACCELERATIONS), &expected.accelerations);
    assert!(off < 1e-14);
    let checked = arrays.result(outputs::CHECKED);
    assert_eq!(checked, [2.0, 2.0], "both masses depend on the parameter");
    let read = &compiled.function(Answer::Accelerations).procedure;
    let parameter =
        read.array(ArrayRole::Argument(Argument::Parameter(mstmm_codegen::ids::ParameterId(0))));
    assert!(parameter.is_none(), "the step reads the parameter's slots, not the parameter");
}

/// Every kind of number may be a parameter: with parameters at their defaults the results are those of the same chain with
/// literal numbers.
#[test]
fn every_number_may_be_a_parameter() {
    let text = |value: fn(&str, f64) -> String, params: &str| {
        let n = |name: &str, number: f64| value(name, number);
        format!(
            "chain Arm {{ gravity = [{}, {}, -1]; {params}
             body Rod {{ mass = 1 + {}; com = [{}, 0.1, 0];
                 output = [1, {}, 0] turned rpy({}, 0, 0.3);
                 inertia = tensor({}, 1.5, 1.4, 0.1, 0, 0) about com; }}
             ground at [0, {}, 0] -> pin([1, {}, 0]) a -> Rod upper -> ball b -> Rod lower
                 -> pin([0, 0, {}]) c -> Rod last; }}",
            n("g", 0.5),
            n("h", -9.8),
            n("m", 0.7),
            n("x", 0.4),
            n("y", -0.2),
            n("r", 0.6),
            n("i", 1.1),
            n("s", 2.0),
            n("axis", 0.5),
            n("z", -3.0),
        )
    };
    let defaults = [
        ("g", 0.5),
        ("h", -9.8),
        ("m", 0.7),
        ("x", 0.4),
        ("y", -0.2),
        ("r", 0.6),
        ("i", 1.1),
        ("s", 2.0),
        ("axis", 0.5),
        ("z", -3.0),
        ("a_angle", 1.0),
    ];
    let params: String =
        defaults.iter().map(|(name, number)| format!("param {name} = {number};")).collect();
    let (with, without) = (
        read(&text(|name, _| name.to_owned(), &params)),
        read(&text(|_, number| format!("({number})"), "")),
    );
    let q = [0.3, 0.5, -0.5, 0.5, 0.5, -0.8];
    let v = [1.0, -0.5, 0.7, 0.2, 2.0];
    let layout = Layout::of(&with);
    for method in [SolutionMethod::Riccati, SolutionMethod::Transfer] {
        let mut with = with.clone();
        with.method = Some(method);
        let compiled = compile(&with, &Findings::default(), &layout);
        let parameters = defaults.iter().map(|&(_, x)| x);
        let unknowns: Vec<f64> = parameters.chain(q).chain(v).chain([0.0]).collect();
        let computed =
            Given::new(&compiled, &unknowns).run(Answer::Solution).expect("a regular chain");
        let expected = compute::<f64>(&without, (method, Axes::Body), &q, &v, &[0.0; 5]);
        let energies = [expected.energy.kinetic, expected.energy.potential].map(|x| x.value());
        let off = |id, expected: &[f64]| difference(&computed.result(id), expected);
        assert!(off(outputs::ACCELERATIONS, &expected.accelerations) < 1e-12, "{method:?}");
        assert!(off(outputs::ENERGIES, &energies) < 1e-13, "{method:?}");
    }
}
