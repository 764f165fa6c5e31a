//! Programs compute what the equations say: an interpreter runs them on `f64` for random chains,
//! without rustc, and the passes keep the value of random formulas.

mod common;

use common::interpreter::{self, Arguments};
use common::{Point, compute, compute_with, difference, drives, read};
use mstmm_codegen::compile::{self, Place, Programs, Sight, groups};
use mstmm_codegen::equations::Axes;
use mstmm_codegen::examine::Findings;
use mstmm_codegen::expr::{Edge, Expr, Graph, Node, Stage};
use mstmm_codegen::math::{Scalar, Structured, Vec3};
use mstmm_codegen::model::{Dimension, Layout, Method};
use mstmm_codegen::passes::{Setup, Unknowns, factor, order, schedule};
use mstmm_codegen::program::Program;
use mstmm_reference::{Random, Recipe, random_mechanism, random_motion};

/// Runs a program without loops; `symbols` by number, `slots` by index.
fn run(program: &Program, symbols: &[f64], slots: &[f64]) -> Vec<Vec<f64>> {
    let symbols = symbols.iter().map(|&symbol| vec![symbol]).collect();
    let arguments = Arguments { symbols, slots: slots.to_vec(), ..Arguments::default() };
    interpreter::run(program, &arguments).into_iter().map(|group| group.concat()).collect()
}

/// All points in inertial axes, read off the numbers of a solution as the runtime does.
fn points(programs: &Programs, dimension: Dimension, full: &[Vec<f64>]) -> Vec<f64> {
    let (shifts, turns) = (dimension.shifts(), dimension.turns());
    let mut all = Vec::new();
    for point in &programs.places.points {
        let entries = |place: &Place, count: usize| -> Vec<f64> {
            let Some(first) = place.first.checked_sub(1) else { return vec![0.0; count] };
            assert_eq!(place.count, count);
            full[groups::NUMBERS][first..first + count].to_vec()
        };
        let inertial = |Sight { axes, vector }: &Sight, along: &[usize]| -> Vec<f64> {
            let vector = entries(vector, along.len());
            match axes.as_deref() {
                None => vector,
                Some([cos_sin]) => {
                    let [c, s] = entries(cos_sin, 2)[..] else { panic!("cosine and sine") };
                    vec![c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]]
                }
                Some(columns) => {
                    let columns: Vec<Vec<f64>> = columns.iter().map(|x| entries(x, 3)).collect();
                    (0..3).map(|k| (0..3).map(|j| columns[j][k] * vector[j]).sum()).collect()
                }
            }
        };
        let mut vectors = point.vectors.iter();
        let mut next = |along: &[usize]| {
            (!along.is_empty())
                .then(|| inertial(vectors.next().expect("a vector"), along))
                .into_iter()
        };
        let (velocity, omega) = (next(shifts), next(turns));
        let felt = next(shifts)
            .map(|felt| felt.iter().zip(&full[groups::AT_REST]).map(|(a, g)| a - g).collect());
        let (turning, moment, force) = (next(turns), next(turns), next(shifts));
        all.extend(entries(&point.position, shifts.len()));
        match &point.orientation {
            Some(columns) => all.extend(columns.iter().flat_map(|x| entries(x, shifts.len()))),
            None => {
                all.extend(UNITS[..dimension.columns()].iter().flat_map(|x| &x[..shifts.len()]))
            }
        }
        all.extend(
            velocity.chain(omega).chain(felt).chain(turning).chain(moment).chain(force).flatten(),
        );
    }
    all
}

/// The same of a point in inertial axes.
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

const UNITS: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// One random chain in a random state: programs against equations.
fn one_chain(seed: u64) {
    let mut random = Random::new(seed);
    let recipe = Recipe::any(&mut random, 5);
    let description = random_mechanism(&mut random, "Random", &recipe);
    let (state, driven) = random_motion(&mut random, &description);
    for (word, method) in [("riccati", Method::Riccati), ("transfer", Method::Transfer)] {
        let chain = read(&description.to_macro_text(Some(word)));
        let programs = compile::programs(&chain, &Findings::default(), &Layout::of(&chain));
        let inputs = drives::inputs(&chain, &driven);
        let symbols = [&state.q[..], &state.v, &inputs, &[0.0]].concat();
        let expected =
            compute_with::<f64>(&chain, (method, Axes::Body), (&state.q, &state.v, &inputs));
        let Programs { accelerations, solution, energy, implicit, correction, .. } = &programs;
        let fast = run(accelerations, &symbols, &[]);
        let full = run(solution, &symbols, &[]);
        let plain = |values: &[Structured<f64>]| values.iter().map(|x| x.value()).collect();
        let energies = plain(&[expected.energy.kinetic, expected.energy.potential]);
        let efforts: Vec<f64> = plain(&expected.report.efforts);
        let points = points(&programs, chain.dimension, &full);
        let expected_points: Vec<f64> = expected
            .report
            .points
            .iter()
            .flat_map(|point| numbers(point, chain.dimension))
            .collect();
        let mut differences = vec![
            ("fast accelerations", difference(&fast[0], &expected.accelerations)),
            ("accelerations", difference(&full[groups::ACCELERATIONS], &expected.accelerations)),
            ("energies", difference(&full[groups::ENERGIES], &energies)),
            ("energies alone", difference(&run(energy, &symbols, &[])[0], &energies)),
            ("efforts", difference(&full[groups::EFFORTS], &efforts)),
            ("points", difference(&points, &expected_points)),
        ];
        if let Some((implicit, _)) = implicit {
            // A step of no length is an explicit one.
            let explicit = &run(implicit, &symbols, &[])[0];
            differences.push(("implicit", difference(explicit, &expected.accelerations)));
        }
        if let Some(correction) = correction {
            let corrected = run(correction, &symbols, &[]);
            differences.push(("closed coordinates", difference(&corrected[0], &state.q)));
            differences.push(("closed rates", difference(&corrected[1], &state.v)));
            differences.push(("residual", corrected[2][0]));
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
    let programs = compile::programs(&with, &Findings::default(), &Layout::of(&with));
    let slots = run(&programs.setup, &[0.7], &[]);
    let symbols = [0.7, q[0], q[1], v[0], v[1]];
    let computed = run(&programs.accelerations, &symbols, &slots[0]);
    let expected =
        compute::<f64>(&read(&text("2 kg")), (Method::Riccati, Axes::Body), &q, &v, &[0.0, 0.0]);
    assert!(difference(&computed[0], &expected.accelerations) < 1e-14);
    assert_eq!(slots[1], [2.0, 2.0], "both masses hang on the parameter");
    let step = programs.accelerations.symbols;
    assert!(!step.contains(&0), "the step reads the parameter's slots, not the parameter");
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
        let programs = compile::programs(&with, &Findings::default(), &layout);
        let symbols: Vec<f64> = defaults.iter().map(|&(_, x)| x).chain(q).chain(v).collect();
        let slots = run(&programs.setup, &symbols, &[]);
        let computed = run(&programs.solution, &symbols, &slots[0]);
        let expected = compute::<f64>(&without, (method, Axes::Body), &q, &v, &[0.0; 5]);
        let energies = [expected.energy.kinetic, expected.energy.potential].map(|x| x.value());
        assert!(difference(&computed[0], &expected.accelerations) < 1e-12, "{method:?}");
        assert!(difference(&computed[5], &energies) < 1e-13, "{method:?}");
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
    for seed in 0..500 {
        let mut random = Random::new(seed);
        let graph = Graph::default();
        let unknowns: Vec<Expr> = (0..4).map(|k| graph.symbol(k, Stage::State)).collect();
        let names: Vec<String> = (0..4).map(|k| format!("x{k}")).collect();
        let values: Vec<f64> = (0..4).map(|_| random.between(-2.0, 2.0)).collect();
        let edges: Vec<Edge> =
            (0..3).map(|_| graph.edge(formula(&mut random, &unknowns, 5))).collect();
        let expected: Vec<f64> = edges.iter().map(|&e| evaluate(&graph, e, &values)).collect();
        let factored = factor(&graph, &edges, &[], &[None; 4]).edges(&edges);
        let direct: Vec<f64> = factored.iter().map(|&e| evaluate(&graph, e, &values)).collect();
        let ordered = order(&graph, &factored, &[], &[None; 4]).edges(&factored);
        let reordered: Vec<f64> = ordered.iter().map(|&e| evaluate(&graph, e, &values)).collect();
        let unknowns = Unknowns { names: &names, parts: &[None; 4], turns: &[] };
        let program =
            schedule(&graph, &unknowns, Stage::State, &[], &[ordered], &mut Setup::default());
        let scheduled = &run(&program, &values, &[])[0];
        // Factoring and order round anew: a few dozen operations on numbers that may grow to thousands.
        assert!(difference(&direct, &expected) < 1e-12, "seed {seed}: factor");
        assert!(difference(&reordered, &direct) < 1e-12, "seed {seed}: order");
        assert!(difference(scheduled, &reordered) == 0.0, "seed {seed}: schedule");
    }
}
