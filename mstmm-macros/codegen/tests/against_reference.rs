//! The equations on `f64` against an independent maximal-coordinate solver: random chains of
//! balls, pins and welds, held, floating and held at the end, both methods in all axes.

mod common;

use common::{WAYS, compute, difference, read};
use mstmm_codegen::equations::Point;
use mstmm_reference::{
    Ends, Joining, Random, Solution, random_chain, random_efforts, random_state,
};

/// Chains a run; each of up to eight bodies.
const CHAINS: u64 = 600;

/// Both solvers have condition numbers of up to a few thousand on these chains, and the reference
/// solves a dense system of up to 96 unknowns: 1e-10 leaves them three digits to spare.
const TOLERANCE: f64 = 1e-10;

#[test]
fn random_chains_move_as_the_reference_says() {
    let mut worst = 0.0_f64;
    for seed in 0..CHAINS {
        worst = worst.max(one_chain(seed));
    }
    println!("{CHAINS} chains, worst relative difference {worst:.2e}");
}

fn one_chain(seed: u64) -> f64 {
    let mut random = Random::new(seed);
    let ends = *random.choose(&[Ends::HeldFree, Ends::FreeFree, Ends::FreeHeld]);
    let kinds: &[Joining] = random.choose::<&[Joining]>(&[
        &[Joining::Weld, Joining::Pin, Joining::Ball],
        &[Joining::Pin],
        &[Joining::Ball],
        &[Joining::Pin, Joining::Ball],
    ]);
    let bodies = 1 + random.below(8);
    let truth = random_chain(&mut random, "Random", bodies, ends, kinds);
    let state = random_state(&mut random, &truth);
    let efforts = random_efforts(&mut random, &truth);
    let expected = truth.solve(&state, &efforts);
    let text = truth.to_macro_text(None);
    let chain = read(&text);
    let mut worst = 0.0_f64;
    for way in WAYS {
        let computed = compute::<f64>(&chain, way, &state.q, &state.v, &efforts);
        let differences = [
            ("accelerations", difference(&computed.accelerations, &expected.accelerations)),
            ("points", points(&computed.report.points, &expected)),
            ("kinetic energy", difference(&[computed.energy.kinetic], &[expected.kinetic_energy])),
            (
                "potential energy",
                difference(&[computed.energy.potential], &[expected.potential_energy]),
            ),
        ];
        for (what, size) in differences {
            assert!(size < TOLERANCE, "seed {seed}, {way:?}: {what} differ by {size:e}\n{text}");
            worst = worst.max(size);
        }
    }
    worst
}

/// The largest difference of any quantity at any connection point, each relative to its largest
/// value along the chain.
fn points(computed: &[Point<f64>], expected: &Solution) -> f64 {
    type Entries = Vec<f64>;
    let quantity = |ours: fn(&Point<f64>) -> Entries,
                    theirs: fn(&mstmm_reference::Point) -> Entries| {
        let ours: Entries = computed.iter().flat_map(ours).collect();
        let theirs: Entries = expected.points.iter().flat_map(theirs).collect();
        difference(&ours, &theirs)
    };
    [
        quantity(|p| p.position.0.into(), |p| p.position.into()),
        quantity(|p| p.rotation.0.concat(), |p| p.rotation.concat()),
        quantity(|p| p.velocity.0.into(), |p| p.velocity.into()),
        quantity(|p| p.omega.0.into(), |p| p.angular_velocity.into()),
        quantity(|p| p.acceleration.linear.0.into(), |p| p.acceleration.into()),
        quantity(|p| p.acceleration.angular.0.into(), |p| p.angular_acceleration.into()),
        quantity(|p| p.moment.0.into(), |p| p.moment.into()),
        quantity(|p| p.force.0.into(), |p| p.force.into()),
    ]
    .into_iter()
    .fold(0.0, |worst, d| if d.is_nan() || d > worst { d } else { worst })
}
