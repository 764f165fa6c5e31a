//! Compares the equations on `f64` with an independent maximal-coordinate solver: random chains with all kinds of hinges,
//! ends, loads and dimensions, both methods in all axes.

mod common;

use common::{Point, WAYS, compute_with, difference, drives, read};
use mstmm_codegen::math::Structured;
use mstmm_reference::{Random, Recipe, Solution, random_mechanism, random_motion};

/// The number of chains per run; each has up to six bodies.
const CHAINS: u64 = 600;
const BODIES: usize = 6;

/// The tolerance. Both solvers have condition numbers of up to a few thousand on these chains, and the reference solves a
/// dense system of up to 96 unknowns; 1e-10 is a thousand times the error to be expected.
const TOLERANCE: f64 = 1e-10;

type Plain = Structured<f64>;

#[test]
fn random_chains_move_as_the_reference_says() {
    let first = seed();
    let mut worst = 0.0_f64;
    for seed in first..first + CHAINS {
        worst = worst.max(one_chain(seed));
    }
    println!("{CHAINS} chains from seed {first}, worst relative difference {worst:.2e}");
}

/// Returns the first seed, which `MSTMM_SEED` sets.
fn seed() -> u64 {
    std::env::var("MSTMM_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(0)
}

fn one_chain(seed: u64) -> f64 {
    let mut random = Random::new(seed);
    let recipe = Recipe::any(&mut random, BODIES);
    let truth = random_mechanism(&mut random, "Random", &recipe);
    if truth.closed() && truth.hinges().all(|hinge| hinge.dof_count() == 0) {
        // Nothing can move, which the language rejects.
        return 0.0;
    }
    let (state, driven) = random_motion(&mut random, &truth);
    let expected = truth.solve_driven(&state, &driven);
    let text = truth.to_macro_text(None);
    let chain = read(&text);
    let inputs = drives::inputs(&chain, &truth, &driven);
    let mut worst = 0.0_f64;
    for way in WAYS {
        let computed = compute_with::<f64>(&chain, way, (&state.q, &state.v, &inputs));
        let energy = computed.energy;
        let mut differences = vec![
            ("accelerations", difference(&computed.accelerations, &expected.accelerations)),
            ("motions", points(&computed.report.points, &expected, &MOTIONS)),
            ("kinetic energy", difference(&[energy.kinetic.value()], &[expected.kinetic_energy])),
            (
                "potential energy",
                difference(&[energy.potential.value()], &[expected.potential_energy]),
            ),
        ];
        if expected.reactions_unique {
            differences.push(("loads", points(&computed.report.points, &expected, &LOADS)));
            let implied = computed.report.efforts.len() - expected.efforts.concat().len();
            let efforts: Vec<f64> =
                computed.report.efforts[implied..].iter().map(|x| x.value()).collect();
            differences.push(("efforts", difference(&efforts, &expected.efforts.concat())));
        }
        for (what, size) in differences {
            assert!(size < TOLERANCE, "seed {seed}, {way:?}: {what} differ by {size:e}\n{text}");
            worst = worst.max(size);
        }
    }
    worst
}

type Entries = Vec<f64>;
type Quantity = (fn(&Point<Plain>) -> Vec<Plain>, fn(&mstmm_reference::Point) -> Entries);

const MOTIONS: [Quantity; 6] = [
    (|p| p.position.0.into(), |p| p.position.into()),
    (|p| p.rotation.0.concat(), |p| p.rotation.concat()),
    (|p| p.velocity.0.into(), |p| p.velocity.into()),
    (|p| p.omega.0.into(), |p| p.angular_velocity.into()),
    (|p| p.acceleration.linear.0.into(), |p| p.acceleration.into()),
    (|p| p.acceleration.angular.0.into(), |p| p.angular_acceleration.into()),
];

const LOADS: [Quantity; 2] =
    [(|p| p.moment.0.into(), |p| p.moment.into()), (|p| p.force.0.into(), |p| p.force.into())];

/// Returns the largest difference of any quantity at any connection point, each relative to its largest value along the
/// chain.
fn points(computed: &[Point<Plain>], expected: &Solution, quantities: &[Quantity]) -> f64 {
    let quantity = |(ours, theirs): &Quantity| {
        let ours: Entries = computed.iter().flat_map(ours).map(|x| x.value()).collect();
        let theirs: Entries = expected.points.iter().flat_map(theirs).collect();
        difference(&ours, &theirs)
    };
    let sizes = quantities.iter().map(quantity);
    sizes.fold(0.0, |worst, d| if d.is_nan() || d > worst { d } else { worst })
}
