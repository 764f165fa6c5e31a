//! A seeded set of random chains, compiled through the macro, against the independent solver:
//! accelerations, every quantity at every connection point, energies, in both methods.
//!
//! `random/chains.rs` holds the chains as they are printed from the seeds; a test keeps it so, and
//! `MSTMM_BLESS=1 cargo test --test random` writes it anew.

mod random {
    // Kept as printed.
    #[rustfmt::skip]
    pub mod chains;
}
mod support;

use mstmm_reference::{
    Chain, Ends, HingeKind, Joining, Random, random_chain, random_efforts, random_state,
};
use random::chains;
use std::fmt::Write;
use support::{Entries, difference, matches};

/// States tried for each chain.
const STATES: u64 = 20;

/// The condition numbers of these chains reach a few thousand, and the reference solves a dense
/// system of up to 96 unknowns.
const TOLERANCE: f64 = 1e-10;

/// The chain of a seed: one to eight bodies, all ends, all hinges.
fn chain(seed: u64) -> Chain {
    let mut random = Random::new(seed);
    let ends = [Ends::HeldFree, Ends::FreeFree, Ends::FreeHeld][seed as usize % 3];
    let kinds = [Joining::Pin, Joining::Ball, Joining::Weld, Joining::Pin, Joining::Ball];
    let bodies = 1 + (seed as usize * 5) % 8;
    random_chain(&mut random, &format!("Random{seed}"), bodies, ends, &kinds)
}

fn text() -> String {
    let mut text =
        String::from("//! Printed from the seeds in `../random.rs`; not to be edited.\n");
    for seed in SEEDS {
        let chain = chain(seed);
        for method in ["riccati", "transfer"] {
            let mut chain = chain.clone();
            chain.name = format!("{}{}", chain.name, ["R", "T"][usize::from(method == "transfer")]);
            write!(text, "\nmstmm::mstmm_chain! {{\n{}}}\n", chain.to_macro_text(Some(method)))
                .expect("text can be written");
            text.push_str(&inputs(&chain));
        }
    }
    text
}

/// A function that takes a chain's inputs out of all its efforts.
fn inputs(chain: &Chain) -> String {
    let mut place = if chain.floats() { 6 } else { 0 };
    let mut fields = Vec::new();
    for hinge in chain.hinges() {
        let (a, b, c) = (place, place + 1, place + 2);
        match hinge.kind {
            HingeKind::Ball if hinge.motor => {
                fields.push(format!("{}: [{a}, {b}, {c}].map(|k| efforts[k]).into()", hinge.name));
            }
            _ if hinge.motor => fields.push(format!("{}: efforts[{a}]", hinge.name)),
            _ => {}
        }
        place += hinge.kind.freedoms();
    }
    let (name, function) = (&chain.name, chain.name.to_lowercase());
    let (argument, value) = if fields.is_empty() {
        ("_efforts", format!("{name}Inputs::default()"))
    } else {
        ("efforts", format!("{name}Inputs {{ {} }}", fields.join(", ")))
    };
    format!(
        "\npub fn inputs_{function}({argument}: &[f64]) -> {name}Inputs<f64> {{\n    {value}\n}}\n"
    )
}

#[test]
fn the_chains_are_those_of_the_seeds() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/random/chains.rs");
    if std::env::var_os("MSTMM_BLESS").is_some() {
        std::fs::write(path, text()).expect("a writable folder");
    }
    let committed = std::fs::read_to_string(path).expect("the committed chains");
    assert!(committed == text(), "MSTMM_BLESS=1 cargo test --test random prints them anew");
}

/// Compares one generated type with the reference in many states.
macro_rules! compare {
    ($name:ident, $inputs:ident, $seed:expr) => {{
        let reference = chain($seed);
        let generated = chains::$name::<f64>::new();
        let mut worst = 0.0_f64;
        for number in 0..STATES {
            let mut random = Random::new(1000 * $seed + number);
            let motion = random_state(&mut random, &reference);
            let efforts = random_efforts(&mut random, &reference);
            let expected = reference.solve(&motion, &efforts);
            let mut state = generated.initial_state();
            state.q.as_mut_slice().copy_from_slice(&motion.q);
            state.v.as_mut_slice().copy_from_slice(&motion.v);
            let inputs = chains::$inputs(&efforts);
            let mut at = generated.workspace();
            generated.solve_into(&state, &inputs, &mut at).expect("a regular chain");
            let fast = generated.accelerations(&state, &inputs).expect("a regular chain");
            let energy = generated.energy(&state);
            let computed = Entries {
                accelerations: at.accelerations().as_slice(),
                points: at.points(),
                energies: [at.kinetic_energy(), at.potential_energy()],
            };
            worst = worst
                .max(matches(&computed, &expected))
                .max(difference(fast.as_slice(), &expected.accelerations))
                .max(difference(&[energy.kinetic, energy.potential], &computed.energies));
            assert!(
                worst < TOLERANCE,
                "{}, seed {}, state {number}: {worst:e}",
                stringify!($name),
                $seed
            );
        }
        println!("{} {worst:.1e}", stringify!($name));
    }};
}

/// One test a seed, for both methods.
macro_rules! seeds {
    ($($seed:literal $test:ident $riccati:ident $ri:ident $transfer:ident $ti:ident;)*) => {
        const SEEDS: [u64; [$($seed),*].len()] = [$($seed),*];
        $(
            #[test]
            fn $test() {
                compare!($riccati, $ri, $seed);
                compare!($transfer, $ti, $seed);
            }
        )*
    };
}

seeds! {
    0 seed_0 Random0R inputs_random0r Random0T inputs_random0t;
    1 seed_1 Random1R inputs_random1r Random1T inputs_random1t;
    2 seed_2 Random2R inputs_random2r Random2T inputs_random2t;
    3 seed_3 Random3R inputs_random3r Random3T inputs_random3t;
    4 seed_4 Random4R inputs_random4r Random4T inputs_random4t;
    5 seed_5 Random5R inputs_random5r Random5T inputs_random5t;
    6 seed_6 Random6R inputs_random6r Random6T inputs_random6t;
    7 seed_7 Random7R inputs_random7r Random7T inputs_random7t;
    8 seed_8 Random8R inputs_random8r Random8T inputs_random8t;
    9 seed_9 Random9R inputs_random9r Random9T inputs_random9t;
    10 seed_10 Random10R inputs_random10r Random10T inputs_random10t;
    11 seed_11 Random11R inputs_random11r Random11T inputs_random11t;
}
