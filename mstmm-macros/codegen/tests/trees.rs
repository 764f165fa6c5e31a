//! Compares the compiled functions of random trees with an independent maximal-coordinate solver: all kinds of hinges, places,
//! ends, loads and dimensions, and springs between bodies.

mod common;

use common::given::Given;
use common::interpreter::Arrays;
use common::points::{OfElement, element_points, springs};
use common::{difference, drives};
use mstmm_codegen::compile::{compile, outputs};
use mstmm_codegen::model::{self, Answer, Layout};
use mstmm_reference::{
    Chain, Dimension, Drives, Element, Ends, Features, Point, Random, Recipe, Solution, State,
    TreeRecipe, random_described_tree, random_motion, random_tree,
};

/// The tolerance, relative to the largest value of each quantity.
const TOLERANCE: f64 = 1e-11;

/// Returns the text of a random tree, and the same tree of the reference.
type Draw = fn(&mut Random, &str) -> (String, Chain);

/// Compares the trees of some seeds.
fn check(seeds: std::ops::Range<u64>, draw: Draw) {
    let first = std::env::var("MSTMM_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(0);
    let (mut worst, mut routes) = ((0.0, "nothing", 0), 0);
    for seed in seeds.start + first..seeds.end + first {
        let mut random = Random::new(seed);
        let (text, truth) = draw(&mut random, &format!("Tree{seed}"));
        let (state, driven) = random_motion(&mut random, &truth);
        let text = with_bias_efforts(&text);
        let found = differences(&truth, &text, &state, &driven);
        let found = found.unwrap_or_else(|error| panic!("seed {seed}: {error}\n{text}"));
        for (what, size) in found {
            assert!(size < TOLERANCE, "seed {seed}: {what} differ by {size:e}\n{text}");
            if size > worst.0 {
                worst = (size, what, seed);
            }
        }
        routes += 1 + truth.later_routes.len();
    }
    let (size, what, seed) = worst;
    println!("{seeds:?}: {routes} routes, largest difference {size:.1e}, {what}, seed {seed}");
}

fn tree(random: &mut Random, name: &str, bodies: usize) -> (String, Chain) {
    let recipe = TreeRecipe::any(random, bodies);
    let truth = random_tree(random, name, &recipe);
    (truth.to_macro_text(None), truth)
}

#[test]
fn small_trees() {
    check(0..120, |random, name| tree(random, name, 5));
}

#[test]
fn trees() {
    check(1000..1040, |random, name| tree(random, name, 12));
}

#[test]
fn large_trees() {
    check(2000..2008, |random, name| tree(random, name, 40));
}

/// Trees with repeated parts, which have branches of their own and places of the previous repetition.
#[test]
fn repeated_trees() {
    check(3000..3040, repeated);
}

/// Trees with instances of parts, some of them inside others.
#[test]
fn trees_of_parts() {
    check(4000..4040, of_parts);
}

/// Trees with parts in repeated parts and repeated parts in parts.
#[test]
fn trees_with_everything() {
    check(5000..5040, with_everything);
}

fn repeated(random: &mut Random, name: &str) -> (String, Chain) {
    described(random, name, &REPEATED_ENDS, Features { parts: false, repeats: true })
}

fn of_parts(random: &mut Random, name: &str) -> (String, Chain) {
    described(random, name, &Ends::ALL, Features { parts: true, repeats: false })
}

fn with_everything(random: &mut Random, name: &str) -> (String, Chain) {
    described(random, name, &REPEATED_ENDS, Features { parts: true, repeats: true })
}

/// The ends of chains with repeated parts: the start is attached, or neither end is.
const REPEATED_ENDS: [Ends; 8] = [
    Ends::HeldFree,
    Ends::MovingFree,
    Ends::FreeFree,
    Ends::FreeFree,
    Ends::HeldHeld,
    Ends::HeldMoving,
    Ends::MovingHeld,
    Ends::MovingMoving,
];

fn described(
    random: &mut Random,
    name: &str,
    ends: &[Ends],
    features: Features,
) -> (String, Chain) {
    let ends = *random.choose(ends);
    let dimension = Recipe::any(random, 1).dimension;
    let recipe = TreeRecipe::rich(random, dimension, 4, ends);
    random_described_tree(random, name, &recipe, features)
}

fn with_bias_efforts(text: &str) -> String {
    text.replacen("{\n", "{\n    answers = bias_efforts;\n", 1)
}

/// Returns the difference of every quantity from the reference, or the error of the description. Elements of repeated parts
/// have their repetition after their names in the reference.
fn differences(
    truth: &Chain,
    text: &str,
    state: &State,
    driven: &Drives,
) -> Result<Vec<(&'static str, f64)>, String> {
    let tokens = text.parse().map_err(|error| format!("{error}"))?;
    let read = mstmm_codegen::read_and_examine(tokens);
    let (chain, findings) = read.map_err(|error| error.to_string())?.remove(0);
    let expected = truth.solve_driven(state, driven);
    let compiled = compile(&chain, &findings, &Layout::of(&chain));
    let mut given = Given::zeros(&compiled);
    let arguments = drives::arguments(&chain, &compiled, truth, (state, driven));
    given.arrays.arguments.extend(arguments);
    given.set_up();
    let run = |answer| given.run(answer).map_err(|failed| format!("{answer:?}: {failed:?}"));
    let (fast, full) = (run(Answer::Accelerations)?, run(Answer::Solution)?);
    let (energy, bias) = (run(Answer::Energy)?, run(Answer::BiasEfforts)?);
    let off = |arrays: &Arrays<f64>, id, expected: &[f64]| difference(&arrays.result(id), expected);
    let energies = [expected.kinetic_energy, expected.potential_energy];
    let mut differences = vec![
        ("fast accelerations", off(&fast, outputs::ACCELERATIONS, &expected.accelerations)),
        ("accelerations", off(&full, outputs::ACCELERATIONS, &expected.accelerations)),
        ("energies", off(&full, outputs::ENERGIES, &energies)),
        ("energies alone", off(&energy, outputs::ENERGIES, &energies)),
        ("bias efforts", off(&bias, outputs::BIAS_EFFORTS, &truth.bias_efforts(state, driven))),
    ];
    if compiled.find(Answer::ImplicitAccelerations).is_some() {
        // A step of no length is an explicit one.
        let implicit = run(Answer::ImplicitAccelerations)?;
        let off = off(&implicit, outputs::ACCELERATIONS, &expected.accelerations);
        differences.push(("implicit accelerations", off));
    }
    if compiled.find(Answer::Correction).is_some() {
        let projected = run(Answer::Correction)?;
        differences.push(("closed coordinates", off(&projected, outputs::COORDINATES, &state.q)));
        differences.push(("closed rates", off(&projected, outputs::RATES, &state.v)));
    }
    if !truth.springs.is_empty() {
        let expected = spring_states(&chain, truth, &expected);
        differences.push(("springs", difference(&springs(&chain, &full), &expected)));
    }
    let points = compared_points(truth, &expected, &element_points(&chain, &compiled, &full))?;
    for (quantity, (name, is_load)) in QUANTITIES.into_iter().enumerate() {
        if is_load && !expected.reactions_unique {
            continue;
        }
        let own = |point: &Quantities| point[quantity].clone();
        let found: Vec<f64> = points.iter().flat_map(|(found, _)| own(found)).collect();
        let expected: Vec<f64> = points.iter().flat_map(|(_, expected)| own(expected)).collect();
        differences.push((name, difference(&found, &expected)));
    }
    if expected.reactions_unique {
        // The base and moving ends come first.
        let (found, expected) = (full.result(outputs::EFFORTS), expected.efforts.concat());
        let implied = found.len() - expected.len();
        differences.push(("efforts", difference(&found[implied..], &expected)));
    }
    Ok(differences)
}

/// Returns the points of all elements, with those of the reference.
fn compared_points(
    truth: &Chain,
    expected: &Solution,
    found: &[OfElement<f64>],
) -> Result<Vec<(Quantities, Quantities)>, String> {
    let elements: Vec<&Element> = truth.all_elements().collect();
    if found.len() != elements.len() {
        return Err(format!("{} elements, expected {}", found.len(), elements.len()));
    }
    let (mut points, mut bodies) = (Vec::new(), 0);
    for ((found, element), numbers) in found.iter().zip(&elements).zip(&expected.elements) {
        points.push((&found.input, &expected.points[numbers.input]));
        points.push((&found.output, &expected.points[numbers.output]));
        if let Element::Body(_) = element {
            let named = &expected.named_points[bodies];
            points.extend(found.named.iter().map(|(number, found)| (found, &named[*number])));
            bodies += 1;
        }
    }
    let pair = |(found, expected): (&Vec<f64>, &Point)| {
        let expected = quantities(expected, truth.dimension);
        let mut found = found.iter().copied();
        let split = expected.each_ref().map(|own| found.by_ref().take(own.len()).collect());
        (split, expected)
    };
    Ok(points.into_iter().map(pair).collect())
}

/// The values of the quantities at a connection point.
type Quantities = [Vec<f64>; 8];

/// The quantities at a connection point, and whether they are loads.
const QUANTITIES: [(&str, bool); 8] = [
    ("positions", false),
    ("orientations", false),
    ("velocities", false),
    ("angular velocities", false),
    ("point accelerations", false),
    ("angular accelerations", false),
    ("moments", true),
    ("forces", true),
];

/// Returns the values of a point that its dimension has, in the order of [`QUANTITIES`].
fn quantities(point: &Point, dimension: Dimension) -> Quantities {
    let (translations, rotations): (&[usize], &[usize]) = match dimension {
        Dimension::Space => (&[0, 1, 2], &[0, 1, 2]),
        Dimension::Plane => (&[0, 1], &[2]),
        Dimension::Line => (&[0], &[]),
    };
    let pick = |vector: &[f64; 3], axes: &[usize]| axes.iter().map(|&k| vector[k]).collect();
    let columns: &[usize] = match dimension {
        Dimension::Space => &[0, 1, 2],
        Dimension::Plane => &[0],
        Dimension::Line => &[],
    };
    let rotation = columns
        .iter()
        .flat_map(|&column| translations.iter().map(move |&row| point.rotation[row][column]));
    [
        pick(&point.position, translations),
        rotation.collect(),
        pick(&point.velocity, translations),
        pick(&point.angular_velocity, rotations),
        pick(&point.acceleration, translations),
        pick(&point.angular_acceleration, rotations),
        pick(&point.moment, rotations),
        pick(&point.force, translations),
    ]
}

/// Returns length, rate, tension and force of every spring, with the repetitions of each one after the other.
fn spring_states(chain: &model::Chain, truth: &Chain, expected: &Solution) -> Vec<f64> {
    let translations = chain.dimension.translations().len();
    let values = |spring: &model::Spring| {
        let name = spring.name.to_string();
        let repeat = chain.repeat_of_body(spring.on.body);
        let names = drives::repeated(&name, repeat.map(|part| chain.repeats[part].count));
        names.into_iter().flat_map(|name| {
            let place = truth.springs.iter().position(|spring| spring.name == name);
            let spring = &expected.springs[place.expect("a spring of this name")];
            let lengths = [spring.length, spring.length_rate, spring.tension];
            [&lengths[..], &spring.force[..translations]].concat()
        })
    };
    chain.springs.iter().flat_map(values).collect()
}
