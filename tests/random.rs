//! Random chains with all features of the language, compiled by the macro and compared with the independent
//! solver: accelerations, efforts, every quantity at every connection point, energies, in both methods.
//!
//! `random/chains.rs` contains the chains printed from the seeds; a test compares it, and
//! `MSTMM_BLESS=1 cargo test --test random` rewrites it.

mod random {
    // Kept as printed.
    #[rustfmt::skip]
    // Random starts of closed chains may give a warning.
    #[allow(deprecated)]
    pub mod chains;
    pub mod compare;
    pub mod face;
    pub mod print;
}
mod support;

use mstmm::description::Origin;
use mstmm::{ChainState, Error};
use mstmm_reference::{
    Chain, Dimension, Drives, End, Ends, Gravity, HingeChoice, HingeKind, HingeMotion, Random,
    Recipe, Source, random_mechanism, random_motion,
};
use random::chains;
use random::compare::compare;
use random::face::Printed;
use random::print::printed;

/// The chain of a seed: up to four bodies, all ends and dimensions; everything may occur.
fn chain(seed: u64) -> Chain {
    let ends = Ends::ALL[seed as usize % Ends::ALL.len()];
    let dimension = match seed {
        4 | 14 => Dimension::Line,
        _ if seed % 5 == 1 && seed != FLAT => Dimension::Plane,
        _ => Dimension::Space,
    };
    let bodies = if seed == FLAT { 4 } else { 1 + (seed as usize * 3 + 1) % 4 };
    let recipe = if seed == FLAT {
        let kinds = [HingeChoice::Pin, HingeChoice::Slider];
        Recipe { flat: true, ..Recipe::rich(dimension, bodies, ends, &kinds) }
    } else {
        let recipe = Recipe::rich(dimension, bodies, ends, &HingeChoice::ALL);
        Recipe { prescribed: 0.25, springs: 0.4, ..recipe }
    };
    let name = format!("Random{seed}");
    let chains =
        (0..).map(|again| random_mechanism(&mut Random::new(seed + 1000 * again), &name, &recipe));
    chains.into_iter().find(moves).expect("one of many chains")
}

/// Whether a chain has more degrees of freedom than loop constraints: the language rejects chains that
/// cannot move.
fn moves(chain: &Chain) -> bool {
    let driven = chain.hinges().any(|hinge| hinge.prescribed)
        || [&chain.start, &chain.finish].iter().any(|end| matches!(end, End::Moving { .. }));
    let dof_count: usize = chain.hinges().map(|hinge| hinge.dof_count()).sum();
    let directions = match chain.dimension {
        Dimension::Space => 6,
        Dimension::Plane => 3,
        Dimension::Line => 1,
    };
    !chain.closed() || driven || dof_count > directions || chain.name == format!("Random{FLAT}")
}

/// A seed whose chain is closed, and lies in a plane: its hinges are redundant in space.
const FLAT: u64 = 21;

fn text() -> String {
    let mut text = String::from(
        "//! Printed from the seeds in `../random.rs`; not to be edited.\n\n\
         use super::face::printed;\nuse crate::support::motion::*;\n",
    );
    for seed in SEEDS {
        text.push_str(&printed(&chain(seed)));
    }
    text
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

#[test]
fn the_seeds_have_everything() {
    let chains: Vec<Chain> = SEEDS.into_iter().map(chain).collect();
    let hinges = || chains.iter().flat_map(Chain::hinges);
    let groups = || hinges().flat_map(|hinge| hinge.groups());
    let loads = || chains.iter().flat_map(|chain| &chain.loads);
    let springs = || chains.iter().flat_map(|chain| &chain.springs);
    let has_kind = |is: fn(&HingeKind) -> bool| hinges().any(|hinge| is(&hinge.kind));
    let missing: Vec<&str> = [
        ("weld", has_kind(|kind| matches!(kind, HingeKind::Weld))),
        ("pin", has_kind(|kind| matches!(kind, HingeKind::Pin { .. }))),
        ("slider", has_kind(|kind| matches!(kind, HingeKind::Slider { .. }))),
        ("screw", has_kind(|kind| matches!(kind, HingeKind::Screw { .. }))),
        ("cylindrical", has_kind(|kind| matches!(kind, HingeKind::Cylindrical { .. }))),
        ("universal", has_kind(|kind| matches!(kind, HingeKind::Universal { .. }))),
        ("gimbal", has_kind(|kind| matches!(kind, HingeKind::Gimbal { .. }))),
        ("ball", has_kind(|kind| matches!(kind, HingeKind::Ball))),
        ("planar", has_kind(|kind| matches!(kind, HingeKind::Planar { .. }))),
        ("floating", has_kind(|kind| matches!(kind, HingeKind::Floating))),
        ("elastic", has_kind(|kind| matches!(kind, HingeKind::Elastic))),
        ("plane elastic", has_kind(|kind| matches!(kind, HingeKind::PlaneElastic))),
        ("line elastic", has_kind(|kind| matches!(kind, HingeKind::LineElastic))),
        ("plane", chains.iter().any(|chain| chain.dimension == Dimension::Plane)),
        ("closed plane", chains.iter().any(|c| c.dimension == Dimension::Plane && c.closed())),
        ("line", chains.iter().any(|chain| chain.dimension == Dimension::Line)),
        ("moving", chains.iter().any(|chain| matches!(chain.start, End::Moving { .. }))),
        ("gravity", chains.iter().any(|chain| chain.gravity == Gravity::Input)),
        ("motion", hinges().any(|hinge| hinge.prescribed)),
        ("prescribed spring", hinges().any(|h| h.prescribed && !h.turning.is_empty())),
        ("rest", hinges().any(|hinge| !hinge.rest.is_empty())),
        ("stiffness", groups().any(|(group, _)| !group.stiffness.is_empty())),
        ("damping", groups().any(|(group, _)| !group.damping.is_empty())),
        ("armature", groups().any(|(group, _)| !group.armature.is_empty())),
        ("friction", groups().any(|(group, _)| !group.friction.is_empty())),
        ("limits", groups().any(|(group, _)| group.limits.is_some())),
        ("motor", groups().any(|(group, _)| group.motor == Source::Input)),
        ("constant motor", groups().any(|(group, _)| matches!(group.motor, Source::Constant(_)))),
        ("force", loads().any(|load| load.force == Source::Input)),
        ("torque", loads().any(|load| load.torque == Source::Input)),
        ("constant force", loads().any(|load| matches!(load.force, Source::Constant(_)))),
        ("spring without length", springs().any(|spring| spring.length == 0.0)),
        ("spring with length", springs().any(|spring| spring.length > 0.0)),
        ("actuator", springs().any(|spring| spring.force == Source::Input)),
        ("constant actuator", springs().any(|it| matches!(it.force, Source::Constant(_)))),
    ]
    .into_iter()
    .filter(|(_, there)| !there)
    .map(|(what, _)| what)
    .collect();
    assert!(missing.is_empty(), "missing: {missing:?}");
}

const BAD: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// Puts each bad number at every place of a state and of what drives a chain: no result stays, and the next
/// good state has all of them again.
fn refuses_values_that_are_not_finite<C: Printed>(name: &str, seed: u64)
where
    C::Workspace: Clone + PartialEq,
{
    let (reference, generated) = (chain(seed), C::default());
    let (motion, drives) = random_motion(&mut Random::new(1000 * seed), &reference);
    let good = (generated.state(&motion.q, &motion.v), generated.inputs(&drives));
    let mut solved = generated.workspace();
    generated.solve_into(&good.0, &good.1, &mut solved).expect("a regular chain");
    let answer = |state: &C::State, inputs: &C::Inputs| {
        let (mut at, mut rate) = (solved.clone(), C::State::zero_position());
        let result = generated.solve_into(state, inputs, &mut at);
        let fast = generated.derivative_into(state, inputs, &mut rate);
        assert_eq!(result, fast, "{name}");
        assert!(result.is_ok() || at == generated.workspace(), "{name}");
        generated.solve_into(&good.0, &good.1, &mut at).expect("a regular chain");
        assert!(at == solved, "{name}");
        result.map(|()| rate.rates().to_vec())
    };
    for bad in BAD {
        let entries = motion.q.len() + motion.v.len();
        for place in 0..=entries {
            let mut state = good.0.clone();
            let origin = match place.checked_sub(motion.q.len()) {
                None => {
                    state.coordinates_mut()[place] = bad;
                    Origin::Coordinate(place)
                }
                Some(place) if place < motion.v.len() => {
                    state.rates_mut()[place] = bad;
                    Origin::Rate(place)
                }
                Some(_) => {
                    state.set_time(bad);
                    Origin::Time
                }
            };
            let found = answer(&state, &good.1);
            assert_eq!(found, Err(Error::NotFinite(origin)), "{name}: {bad} at {place} of a state");
        }
        // Not all that drives the reference is an input of the chain.
        let unchanged = answer(&good.0, &good.1);
        for (place, drives) in with_each_number_replaced(&drives, bad).iter().enumerate() {
            let found = answer(&good.0, &generated.inputs(drives));
            assert!(
                matches!(found, Err(Error::NotFinite(Origin::Input(_)))) || found == unchanged,
                "{name}: {bad} at {place} of the inputs: {found:?}"
            );
        }
    }
}

/// What drives a chain, with one number after the other replaced.
fn with_each_number_replaced(drives: &Drives, by: f64) -> Vec<Drives> {
    fn numbers(drives: &mut Drives) -> impl Iterator<Item = &mut f64> {
        let motions = drives.motions.iter_mut().flat_map(|HingeMotion { q, v, a }| [q, v, a]);
        let loads = drives.loads.iter_mut();
        let loads = loads.flat_map(|load| load.force.iter_mut().chain(&mut load.torque));
        let motions = motions.flatten().chain(loads);
        drives.efforts.iter_mut().chain(motions).chain(&mut drives.gravity)
    }
    let count = numbers(&mut drives.clone()).count();
    let replaced = |place| {
        let mut drives = drives.clone();
        numbers(&mut drives).nth(place).into_iter().for_each(|number| *number = by);
        drives
    };
    (0..count).map(replaced).collect()
}

/// One test a seed, for both methods.
macro_rules! seeds {
    ($($seed:literal $test:ident $riccati:ident $transfer:ident;)*) => {
        const SEEDS: [u64; [$($seed),*].len()] = [$($seed),*];
        $(
            #[test]
            fn $test() {
                compare::<chains::$riccati<f64>>(stringify!($riccati), &chain($seed), $seed);
                compare::<chains::$transfer<f64>>(stringify!($transfer), &chain($seed), $seed);
            }
        )*

        #[test]
        fn values_that_are_not_finite_are_refused() {
            $(
                refuses_values_that_are_not_finite::<chains::$riccati<f64>>(stringify!($riccati), $seed);
                refuses_values_that_are_not_finite::<chains::$transfer<f64>>(stringify!($transfer), $seed);
            )*
        }
    };
}

seeds! {
    0 seed_0 Random0R Random0T;
    1 seed_1 Random1R Random1T;
    2 seed_2 Random2R Random2T;
    3 seed_3 Random3R Random3T;
    4 seed_4 Random4R Random4T;
    5 seed_5 Random5R Random5T;
    6 seed_6 Random6R Random6T;
    7 seed_7 Random7R Random7T;
    8 seed_8 Random8R Random8T;
    9 seed_9 Random9R Random9T;
    10 seed_10 Random10R Random10T;
    11 seed_11 Random11R Random11T;
    12 seed_12 Random12R Random12T;
    13 seed_13 Random13R Random13T;
    14 seed_14 Random14R Random14T;
    15 seed_15 Random15R Random15T;
    16 seed_16 Random16R Random16T;
    17 seed_17 Random17R Random17T;
    18 seed_18 Random18R Random18T;
    19 seed_19 Random19R Random19T;
    20 seed_20 Random20R Random20T;
    21 seed_21 Random21R Random21T;
    27 seed_27 Random27R Random27T;
}
