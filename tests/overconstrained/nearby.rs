//! States that miss the closure by as much as a step of an integrator does.

use super::face::{Closed, doubles};
use super::linkage::Linkage;
use super::reference::apart;
use super::states::{OPERATIONS, RATE, ordinary};
use mstmm_reference::Random;

/// How far states are from the closure, in rad and rad/s.
const MISSES: [f64; 5] = [1e-14, 1e-12, 1e-10, 1e-8, 1e-6];

/// A state near a closed one is as redundant, and its accelerations are near. Numbers in J change
/// by the miss times the sizes of bodies, and products of rates by as much: each counts as a
/// relative change, as in `states`.
fn check<C: Closed<Scalar = f64>>(linkage: &Linkage) {
    let chain = C::default();
    let mut random = Random::new(1);
    let (mut wrong, mut largest) = (Vec::new(), 0.0_f64);
    for crank in [0.1].into_iter().chain(ordinary(linkage)) {
        let instant = linkage.instant::<f64>(crank, RATE);
        let expected = doubles(&instant.reference.accelerations);
        for miss in MISSES {
            let mut off = |x: &f64| x + miss * random.between(-1.0, 1.0);
            let q: Vec<f64> = instant.q.iter().map(&mut off).collect();
            let v: Vec<f64> = instant.v.iter().map(&mut off).collect();
            let answer = chain.answer(&chain.state(&q, &v)).expect("a regular linkage");
            let bound = OPERATIONS * (miss + f64::EPSILON) * instant.reference.acceleration_change;
            let apart = [&answer.fast, &answer.accelerations]
                .map(|found| apart(found, &expected) / bound)
                .into_iter()
                .fold(0.0, super::states::worst);
            largest = super::states::worst(largest, apart);
            // Not a number is not within.
            let within = apart < 1.0;
            let redundant = answer.redundant;
            if redundant != 6 - linkage.rank || !within {
                wrong.push(format!(
                    "at {crank} rad, off by {miss:e}: {redundant} redundant directions, \
                     accelerations off by {apart:.1e} of the bound"
                ));
            }
        }
    }
    println!("{}: accelerations off by {largest:.1e} of the bound, seed 1", linkage.name);
    assert!(wrong.is_empty(), "{}, seed 1:\n{}", linkage.name, wrong.join("\n"));
}

/// Tests each linkage by both methods.
macro_rules! nearby {
    ($($module:ident::$name:ident $riccati:ident $transfer:ident;)*) => { $(
        #[test]
        fn $name() {
            use super::$module as models;
            let linkage = models::$name();
            check::<models::$riccati<f64>>(&linkage);
            check::<models::$transfer<f64>>(&linkage);
        }
    )* };
}

each_linkage! { nearby }
