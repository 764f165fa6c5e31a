//! Programs compute what the equations say: an interpreter runs them on `f64` for random chains,
//! without rustc, and the passes keep the value of random formulas.

mod common;

use common::given::Given;
use common::interpreter::{Arrays, run};
use common::points::points;
use common::{Point, compute, compute_with, difference, drives, read};
use mstmm_codegen::compile::{compile, outputs};
use mstmm_codegen::equations::Axes;
use mstmm_codegen::examine::Findings;
use mstmm_codegen::expr::{Edge, Expr, Graph, Node, Stage};
use mstmm_codegen::function::{Function, Output, Unknowns};
use mstmm_codegen::math::{Scalar, Structured, Vec3};
use mstmm_codegen::model::{Answer, Dimension, Layout, Method};
use mstmm_codegen::passes::{
    Setup, early_stores, factor, linearize, list_schedule, lower, reassociate,
};
use mstmm_codegen::program::{Argument, ArrayLayout, ArrayRole, OutputId};
use mstmm_reference::{Random, Recipe, random_mechanism, random_motion};

/// What is read off a solution of a point, in inertial axes.
fn numbers(point: &Point<Structured<f64>>, dimension: Dimension) -> Vec<f64> {
    let (shifts, turns) = (dimension.shifts(), dimension.turns());
    let pick = |vector: Vec3<Structured<f64>>, axes: &[usize]| -> Vec<f64> {
        axes.iter().map(|&axis| vector[axis].value()).collect()
    };
    let rotation = point.rotation.transposed().0.map(Vec3);
    [
        pick(point.position, shifts),
        rotation[..dimension.columns()].iter().flat_map(|&column| pick(column, shifts)).collect(),
        pick(point.velocity, shifts),
        pick(point.omega, turns),
        pick(point.acceleration.linear, shifts),
        pick(point.acceleration.angular, turns),
        pick(point.moment, turns),
        pick(point.force, shifts),
    ]
    .concat()
}

/// One random chain in a random state: programs against equations.
fn one_chain(seed: u64) {
    let mut random = Random::new(seed);
    let recipe = Recipe::any(&mut random, 5);
    let description = random_mechanism(&mut random, "Random", &recipe);
    let (state, driven) = random_motion(&mut random, &description);
    for (word, method) in [("riccati", Method::Riccati), ("transfer", Method::Transfer)] {
        let chain = read(&description.to_macro_text(Some(word)));
        let compiled = compile(&chain, &Findings::default(), &Layout::of(&chain));
        let inputs = drives::inputs(&chain, &driven);
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
    let expected =
        compute::<f64>(&read(&text("2 kg")), (Method::Riccati, Axes::Body), &q, &v, &[0.0, 0.0]);
    let off = difference(&computed.result(outputs::ACCELERATIONS), &expected.accelerations);
    assert!(off < 1e-14);
    let checked = arrays.result(outputs::CHECKED);
    assert_eq!(checked, [2.0, 2.0], "both masses hang on the parameter");
    let read = &compiled.function(Answer::Accelerations).procedure;
    let parameter = read.array(ArrayRole::Argument(Argument::Parameter(0)));
    assert!(parameter.is_none(), "the step reads the parameter's slots, not the parameter");
}

/// Every kind of number may be a parameter: the program with parameters at their defaults computes
/// what the same chain with plain numbers does.
#[test]
fn parameters_may_stand_anywhere() {
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
    for method in [Method::Riccati, Method::Transfer] {
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

/// A random formula of every kind of node.
fn formula<'g>(random: &mut Random, unknowns: &[Expr<'g>], depth: usize) -> Expr<'g> {
    if depth == 0 || random.chance(0.1) {
        return if random.chance(0.2) {
            Expr::number(*random.choose(&[0.0, 1.0, -1.0, 2.0, -0.5]))
        } else {
            *random.choose(unknowns)
        };
    }
    let a = formula(random, unknowns, depth - 1);
    let b = formula(random, unknowns, depth - 1);
    let positive = Expr::number(1.0) + a * a;
    match random.below(12) {
        0 | 1 => a + b,
        2 | 3 => a - b,
        4 | 5 => a * b,
        6 => a * b + a * formula(random, unknowns, depth - 1),
        7 => positive.recip(),
        8 => positive.sqrt().copysign(b + Expr::number(0.3)),
        9 => a.atan2(positive),
        10 => positive.recip_above(b * b),
        _ => (a + b).sin_cos().0 * b.sin_cos().1,
    }
}

/// The value of a formula straight from the graph.
fn evaluate(graph: &Graph, edge: Edge, unknowns: &[f64]) -> f64 {
    let go = |edge| evaluate(graph, edge, unknowns);
    let plain = match graph.node(edge.node()) {
        Node::Number(bits) => f64::from_bits(bits),
        Node::Symbol(number) => unknowns[number as usize],
        Node::Sum(a, b) => go(a) + go(b),
        Node::Product(a, b) => go(a) * go(b),
        Node::Recip(a) => go(a).recip(),
        Node::Sqrt(a) => go(a).sqrt(),
        Node::Sin(a) => libm::sin(go(a)),
        Node::Cos(a) => libm::cos(go(a)),
        Node::CopySign(a, b) => go(a).copysign(go(b)),
        Node::Atan2(a, b) => libm::atan2(go(a), go(b)),
        Node::RecipAbove(a, b) => go(a).recip_above(go(b)),
    };
    if edge.is_negative() { -plain } else { plain }
}

#[test]
fn passes_keep_the_value_of_every_formula() {
    let result = OutputId::new("formulas");
    let mut unknowns = Unknowns::default();
    let names = (0..4).map(|k| format!("x{k}")).collect();
    unknowns.add(Argument::Coordinates, ArrayLayout::once(4), names);
    for seed in 0..500 {
        let mut random = Random::new(seed);
        let graph = Graph::default();
        let symbols: Vec<Expr> = (0..4).map(|k| graph.symbol(k, Stage::State)).collect();
        let values: Vec<f64> = (0..4).map(|_| random.between(-2.0, 2.0)).collect();
        let edges: Vec<Edge> =
            (0..3).map(|_| graph.edge(formula(&mut random, &symbols, 5))).collect();
        let output =
            Output { id: result, layout: ArrayLayout::once(3), values: edges, by_entry: false };
        let function = Function {
            graph: &graph,
            unknowns: &unknowns,
            stage: Stage::State,
            sections: Vec::new(),
            loops: Vec::new(),
            outputs: vec![output],
            pivots: Vec::new(),
        };
        let evaluated = |function: &Function| -> Vec<f64> {
            function.results().map(|edge| evaluate(&graph, edge, &values)).collect()
        };
        let expected = evaluated(&function);
        let factored = factor(function);
        let direct = evaluated(&factored);
        let ordered = reassociate(factored);
        let reordered = evaluated(&ordered);
        let mut setup = Setup::default();
        let program = list_schedule(linearize(&ordered, &mut setup));
        let procedure = early_stores(lower(program, &ordered, None, &setup));
        let mut arrays = Arrays::default();
        arrays.arguments.insert(Argument::Coordinates, values.clone());
        run(&procedure, &mut arrays).expect("nothing is tested");
        // Factoring and order round anew: a few dozen operations on numbers that may grow to thousands.
        assert!(difference(&direct, &expected) < 1e-12, "seed {seed}: factor");
        assert!(difference(&reordered, &direct) < 1e-12, "seed {seed}: reassociate");
        let off = difference(&arrays.result(result), &reordered);
        assert!(off == 0.0, "seed {seed}: linearize and lower");
    }
}
