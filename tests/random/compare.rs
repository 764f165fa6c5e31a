//! Compares generated chains with the reference.

use super::face::{Answer, Printed};
use crate::support::{ComparedPoint, difference, loads_match, motions_match, worst};
use mstmm_reference::{Chain, Random, Solution, SpringState, random_motion};

/// Motions tried for each chain.
const MOTIONS: u64 = 20;

/// The condition numbers of these chains reach a few thousand.
const TOLERANCE: f64 = 1e-11;

/// Compares one generated type with the reference in many motions.
pub fn compare<C: Printed>(name: &str, reference: &Chain, seed: u64)
where
    C::Point: ComparedPoint,
{
    let generated = C::default();
    let mut largest = 0.0_f64;
    for number in 0..MOTIONS {
        let mut random = Random::new(1000 * seed + number);
        let (motion, drives) = random_motion(&mut random, reference);
        let expected = reference.solve_driven(&motion, &drives);
        let state = generated.state(&motion.q, &motion.v);
        let answer = generated.answer(&state, &generated.inputs(&drives));
        for (what, off) in differences(&answer, &expected) {
            assert!(off < TOLERANCE, "{name}, seed {seed}, motion {number}: {what} off by {off:e}");
            largest = worst(largest, off);
        }
    }
    println!("{name} {largest:.1e}");
}

/// Where reactions are not unique, the reference has the same motion but not the same loads.
fn differences<P: ComparedPoint>(
    answer: &Answer<P>,
    expected: &Solution,
) -> Vec<(&'static str, f64)> {
    let energies = [expected.kinetic_energy, expected.potential_energy];
    let fast = [answer.fast_energy.kinetic, answer.fast_energy.potential];
    let mut differences = vec![
        ("accelerations", difference(&answer.accelerations, &expected.accelerations)),
        ("fast accelerations", difference(&answer.fast_accelerations, &expected.accelerations)),
        ("points", motions_match(&answer.points, expected)),
        ("energy", difference(&[answer.energy.kinetic, answer.energy.potential], &energies)),
        ("fast energy", difference(&fast, &energies)),
        ("springs", difference(&answer.springs, &springs(expected, answer.springs.len()))),
    ];
    if expected.reactions_unique {
        differences.push(("efforts", difference(&answer.efforts, &expected.efforts.concat())));
        differences.push(("loads", loads_match(&answer.points, expected)));
    }
    differences
}

/// Length, rate of the length, tension and force of all springs, `count` numbers.
fn springs(expected: &Solution, count: usize) -> Vec<f64> {
    let each = count.checked_div(expected.springs.len()).unwrap_or(3);
    let numbers = |spring: &SpringState| {
        let lengths = [spring.length, spring.length_rate, spring.tension];
        [&lengths[..], &spring.force[..each - 3]].concat()
    };
    expected.springs.iter().flat_map(numbers).collect()
}
