//! Welded bodies move as one body with the sum of their inertias, and the weld transmits the wrench that
//! Newton's law requires for each part.

// Closed chains here start with their links in line, which gives a warning; the tests bend them.
#![allow(deprecated)]

mod support;

use mstmm_reference::Random;
use nalgebra::Vector3;
use support::matter::{Lump, ends};
use support::mechanism::{Mechanism, both};
use support::{difference, worst};

const STATES: u64 = 50;

/// Some hundred roundings, in a system of a condition of some ten.
const TOLERANCE: f64 = 1e-13;

const GRAVITY: [f64; 3] = [1.0, -9.8, 2.0];

/// The parts, each in its own axes: the second sits at (0.4, 0, 0) of the first, turned by 90°
/// about z, and the third at (0.5, 0, 0) of the second, not turned.
const PARTS: [Lump; 4] = [
    Lump { mass: 2.0, com: [0.2, 0.0, 0.1], inertia: [0.1, 0.2, 0.25, 0.0, 0.0, 0.0] },
    Lump { mass: 1.0, com: [0.3, 0.0, 0.2], inertia: [0.05, 0.09, 0.1, 0.01, 0.0, 0.0] },
    Lump { mass: 0.5, com: [0.1, 0.1, 0.0], inertia: [0.02, 0.03, 0.04, 0.0, 0.0, 0.0] },
    Lump { mass: 1.2, com: [0.3, 0.0, 0.0], inertia: [0.01, 0.05, 0.05, 0.0, 0.0, 0.0] },
];

both! { Welded WeldedByTransfer [Ball, Pin] {
    gravity = [1, -9.8, 2] m/s^2;
    body Base {
        mass = 2 kg; com = [0.2, 0, 0.1] m; inertia = diag(0.1, 0.2, 0.25) kg*m^2 about com;
        output = [0.4, 0, 0] m turned rpy(0, 0, 90) deg;
    }
    body Arm {
        mass = 1 kg; com = [0.3, 0, 0.2] m;
        inertia = tensor(0.05, 0.09, 0.1, 0.01, 0, 0) kg*m^2 about com;
        output = [0.5, 0, 0] m;
    }
    body Knob {
        mass = 0.5 kg; com = [0.1, 0.1, 0] m; inertia = diag(0.02, 0.03, 0.04) kg*m^2 about com;
        output = [0.1, 0, 0.3] m;
    }
    body Tip {
        mass = 1.2 kg; com = [0.3, 0, 0] m; inertia = diag(0.01, 0.05, 0.05) kg*m^2 about com;
    }
    ground -> ball joint -> Base base -> weld first -> Arm arm -> weld second -> Knob knob
        -> pin([1, 1, 0]) wrist -> Tip tip;
} }

/// All three in axes of the first: turned by 90° about z, x of a part is y and y is −x.
mod whole {
    pub const MASS: f64 = 2.0 + 1.0 + 0.5;
    pub const X: f64 = (2.0 * 0.2 + 1.0 * 0.4 + 0.5 * (0.4 - 0.1)) / MASS;
    pub const Y: f64 = (1.0 * 0.3 + 0.5 * (0.5 + 0.1)) / MASS;
    pub const Z: f64 = (2.0 * 0.1 + 1.0 * 0.2) / MASS;
    /// About the input, by Steiner: each part's own, and m (r² 1 − r rᵀ).
    pub const XX: f64 =
        0.1 + 2.0 * 0.1 * 0.1 + 0.09 + 1.0 * (0.3 * 0.3 + 0.2 * 0.2) + 0.03 + 0.5 * (0.6 * 0.6);
    pub const YY: f64 = 0.2
        + 2.0 * (0.2 * 0.2 + 0.1 * 0.1)
        + 0.05
        + 1.0 * (0.4 * 0.4 + 0.2 * 0.2)
        + 0.02
        + 0.5 * (0.3 * 0.3);
    pub const ZZ: f64 = 0.25
        + 2.0 * 0.2 * 0.2
        + 0.1
        + 1.0 * (0.4 * 0.4 + 0.3 * 0.3)
        + 0.04
        + 0.5 * (0.3 * 0.3 + 0.6 * 0.6);
    pub const XY: f64 = -0.01 - 1.0 * 0.4 * 0.3 - 0.5 * 0.3 * 0.6;
    pub const XZ: f64 = -2.0 * 0.2 * 0.1 - 1.0 * 0.4 * 0.2;
    pub const YZ: f64 = -(0.3 * 0.2);
}

both! { Merged MergedByTransfer [Ball, Pin] {
    gravity = [1, -9.8, 2] m/s^2;
    body Whole {
        mass = whole::MASS;
        com = [whole::X, whole::Y, whole::Z];
        inertia =
            tensor(whole::XX, whole::YY, whole::ZZ, whole::XY, whole::XZ, whole::YZ) about input;
        output = [0.4, 0.6, 0.3] m turned rpy(0, 0, 90) deg;
    }
    body Tip {
        mass = 1.2 kg; com = [0.3, 0, 0] m; inertia = diag(0.01, 0.05, 0.05) kg*m^2 about com;
    }
    ground -> ball joint -> Whole base -> pin([1, 1, 0]) wrist -> Tip tip;
} }

fn compare<A: Mechanism, B: Mechanism>(name: &str, welded: &A, merged: &B)
where
    A::Inputs: Default,
    B::Inputs: Default,
{
    use mstmm::ChainState;
    let mut largest = 0.0;
    for seed in 0..STATES {
        let state = welded.random_state(&mut Random::new(seed));
        let mut same = merged.start();
        same.coordinates_mut().copy_from_slice(state.coordinates());
        same.rates_mut().copy_from_slice(state.rates());
        let found = welded.answer(&state, &A::Inputs::default()).expect("a regular chain");
        let expected = merged.answer(&same, &B::Inputs::default()).expect("a regular chain");
        let energies = [found.energy, expected.energy].map(|e| [e.kinetic, e.potential]);
        let fast = welded.fast_accelerations(&state, &A::Inputs::default());
        let carried = |points: &[mstmm::Point<f64>]| -> Vec<f64> {
            points.iter().flat_map(|p| p.z().to_vector().as_slice().to_vec()).collect()
        };
        // The first joint and the last three points are there in both.
        let count = expected.points.len();
        let outside = [&found.points[..2], &found.points[6..]].concat();
        assert_eq!((outside.len(), found.points.len()), (count, count + 4));
        let parts = PARTS.iter().zip(ends(&found.points, 1));
        let imbalance = parts.map(|(part, at)| part.imbalance(at, GRAVITY)).fold(0.0, worst);
        let off = [
            difference(&found.accelerations, &expected.accelerations),
            difference(&fast, &expected.accelerations),
            difference(&energies[0], &energies[1]),
            difference(&carried(&outside), &carried(&expected.points)),
            imbalance,
        ]
        .into_iter()
        .fold(0.0, worst);
        assert!(off < TOLERANCE, "{name}, seed {seed}: {off:e}");
        largest = worst(largest, off);
    }
    println!("{name}: off by {largest:.1e}");
}

#[test]
fn welded_bodies_move_as_one_and_each_part_is_in_balance() {
    compare("riccati", &Welded::<f64>::new(), &Merged::<f64>::new());
    compare("transfer", &WeldedByTransfer::<f64>::new(), &MergedByTransfer::<f64>::new());
}

/// The last weld carries only the last part: its force is m (a − g) of this part.
#[test]
fn a_weld_transmits_the_force_that_moves_the_rest() {
    let chain = Welded::<f64>::new();
    let state = chain.random_state(&mut Random::new(3));
    let mut at = chain.workspace();
    chain.solve_into(&state, &chain.no_inputs(), &mut at).expect("a regular chain");
    let place = |point: &mstmm::Point<f64>, com: [f64; 3]| {
        let (arm, spin) = (point.orientation() * Vector3::from(com), point.angular_velocity());
        point.acceleration()
            + point.angular_acceleration().cross(&arm)
            + spin.cross(&spin.cross(&arm))
    };
    let gravity = Vector3::from(GRAVITY);
    let knob = (place(&at.knob().input(), PARTS[2].com) - gravity) * PARTS[2].mass;
    let tip = (place(&at.tip().input(), PARTS[3].com) - gravity) * PARTS[3].mass;
    let off = difference(at.second().output().force().as_slice(), (knob + tip).as_slice());
    assert!(off < TOLERANCE, "{off:e}");
    assert_eq!(at.second().input().force(), at.second().output().force());
}

mstmm::mstmm_chain! {
    /// Four pins between the ground and a base, which a weld holds on the ground.
    plane chain WeldedLoop {
        gravity = [1, -9.8] m/s^2;
        body Bar { mass = 1 kg; com = [0.5, 0.1] m; output = [1, 0] m; inertia = 0.1 kg*m^2 about com; }
        body Base { mass = 3 kg; com = [0.2, 0.1] m; output = [0.5, 0] m; inertia = 0.2 kg*m^2 about com; }
        ground -> pin a -> Bar left -> pin b -> Bar top -> pin c -> Bar right -> pin d -> Base base
            -> weld foot -> ground at [1.3, 0] m;
        hinge a { start = 80 deg; start_rate = 4 rad/s; }
        hinge b, c { start = -70 deg; }
        hinge d { start = 60 deg; }
    }
    /// The same four pins, the last of them on the ground.
    plane chain PinnedLoop {
        gravity = [1, -9.8] m/s^2;
        body Bar { mass = 1 kg; com = [0.5, 0.1] m; output = [1, 0] m; inertia = 0.1 kg*m^2 about com; }
        ground -> pin a -> Bar left -> pin b -> Bar top -> pin c -> Bar right
            -> pin d -> ground at [0.8, 0] m;
    }
}

/// A weld that closes a chain attaches its last body to the ground.
#[test]
fn a_weld_closes_a_chain() {
    let (welded, pinned) = (WeldedLoop::<f64>::new(), PinnedLoop::<f64>::new());
    let (inputs, mut state) = (welded.no_inputs(), welded.initial_state());
    welded.assemble(&mut state, &inputs).expect("a loop that closes");
    let mut same = pinned.initial_state();
    (same.q, same.v) = (state.q, state.v);
    let (mut at, mut expected) = (welded.workspace(), pinned.workspace());
    welded.solve_into(&state, &inputs, &mut at).expect("a regular chain");
    pinned.solve_into(&same, &pinned.no_inputs(), &mut expected).expect("a regular chain");
    assert!(state.v[0].abs() > 1.0, "{}", state.v);
    let carried = |force: nalgebra::Vector2<f64>| [force.x, force.y];
    let weight = nalgebra::Vector2::new(1.0, -9.8) * 3.0;
    let place = at.base().input();
    let off = [
        place.position().x - 0.8,
        place.position().y,
        place.velocity().norm(),
        difference(at.accelerations().as_slice(), expected.accelerations().as_slice()),
        difference(
            &carried(at.foot().input().force()),
            &carried(expected.d().input().force() + weight),
        ),
    ];
    let off = off.map(f64::abs).into_iter().fold(0.0, worst);
    assert!(off < TOLERANCE, "{off:e}");
}
