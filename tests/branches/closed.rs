//! A first route that closes, on the ground or at a moving end, with branches on its bodies.

use crate::support::difference;
use crate::support::matter::Lump;
use crate::support::moving::energy_rate;
use mstmm::nalgebra::Vector3;
use mstmm::{
    Chain, ChainState, Dual, FloatingState, GeneratedChain, HingeMotion, Rk4, mstmm_chain,
};
use mstmm_reference::Random;

/// The condition of these linkages is some ten to a hundred, with a hundred roundings on the way to a
/// number.
const TOLERANCE: f64 = 1e-11;

const GRAVITY: [f64; 3] = [1.0, -2.0, -9.5];

/// Bennett's linkage, which moves although three constraints are redundant. The arguments
/// describe its coupler and its branches. Its rational angles are those of `overconstrained/bennett.rs`.
macro_rules! bennett {
    ($($name:ident [$($weight:tt)*] { $($coupler:tt)* } { $($branches:tt)* })*) => { $(
        mstmm_chain! { chain $name {
            gravity = [1.0, -2.0, -9.5] m/s^2;
            body Crank {
                mass = 1.015625 kg; com = [0.25, -0.25, -0.0625] m;
                inertia = tensor(0.083984375, 0.107421875, 0.125, 0.009765625, 0.01171875,
                                 0.005859375) kg*m^2 about com;
                output = [0.703125, 0, 0] m turned quaternion(2, 1, 0, 0);
            }
            body Coupler {
                com = [-0.109375, -0.21875, 0.171875] m;
                output = [0.52734375, 0, 0] m turned quaternion(3, 1, 0, 0);
                point hook = [-0.109375, -0.21875, 0.171875] m;
                $($coupler)*
            }
            body Rocker {
                mass = 2.140625 kg; com = [0.125, -0.046875, -0.09375] m;
                inertia = tensor(0.11328125, 0.13671875, 0.083984375, 0.001953125, -0.017578125,
                                 -0.017578125) kg*m^2 about com;
                output = [0.703125, 0, 0] m turned quaternion(2, 1, 0, 0);
                point hook = [0.2, 0.1, 0.3] m turned rpy(10, 20, 30) deg;
            }
            $($weight)*
            body Bob {
                mass = 0.75 kg; com = [0.2, 0.1, -0.1] m;
                inertia = diag(0.02, 0.03, 0.025) kg*m^2 about com;
            }
            ground -> pin a -> Crank crank -> pin b -> Coupler coupler -> pin c -> Rocker rocker
                -> pin d -> ground at [-0.52734375, 0, 0] m turned quaternion(3, -1, 0, 0);
            $($branches)*
            hinge a { start = 0.5 rad; start_rate = 1.5 rad/s; }
            hinge b { start = -3.039544536633868 rad; start_rate = 0.3187286112180239 rad/s; }
            hinge c { start = -0.5 rad; start_rate = -1.5 rad/s; }
            hinge d { start = 3.039544536633868 rad; start_rate = -0.3187286112180239 rad/s; }
        } }
    )* };
}

bennett! {
    /* The weight as a branch on a weld. */
    Welded [
        body Weight {
            mass = 0.5 kg; com = [0, 0, 0] m;
            inertia = tensor(0.02, 0.03, 0.025, 0.001, 0.002, 0.003) kg*m^2 about com;
            output = [0.3, 0, 0.1] m;
        }
    ] {
        mass = 2.3125 kg;
        inertia = tensor(0.078125, 0.1328125, 0.12890625, 0.005859375, 0.0078125, -0.017578125)
                  kg*m^2 about com;
    } {
        coupler.hook -> weld w -> Weight weight;
        rocker.hook -> ball joint -> Bob bob;
        hinge joint { start_rate = [1, -2, 0.5] rad/s; }
    }
    /* The weight as part of the coupler. */
    Merged [] {
        mass = 2.3125 kg + 0.5 kg;
        inertia = tensor(0.078125 + 0.02, 0.1328125 + 0.03, 0.12890625 + 0.025, 0.005859375 + 0.001,
                         0.0078125 + 0.002, -0.017578125 + 0.003) kg*m^2 about com;
    } {
        rocker.hook -> ball joint -> Bob bob;
        hinge joint { start_rate = [1, -2, 0.5] rad/s; }
    }
    /* A pendulum of two bodies on the coupler, a branch on its branch. */
    Hung [
        body Weight {
            mass = 0.5 kg; com = [0, 0, 0] m;
            inertia = tensor(0.02, 0.03, 0.025, 0.001, 0.002, 0.003) kg*m^2 about com;
            output = [0.3, 0, 0.1] m;
        }
    ] {
        mass = 2.3125 kg;
        inertia = tensor(0.078125, 0.1328125, 0.12890625, 0.005859375, 0.0078125, -0.017578125)
                  kg*m^2 about com;
    } {
        coupler.hook -> pin(x) near -> Weight weight -> pin(y) far -> Bob bob;
        weight.output -> universal beside -> Bob second;
        coupler.output -> slider(y) slide -> Bob third;
        hinge near { start_rate = 2 rad/s; stiffness = 3; }
        hinge slide { stiffness = 50; }
        spring cord { on = bob.com; to = rocker.hook; stiffness = 20; length = 0.3 m; }
    }
}

/// Assembles a state near the start; rates of all hinges at random.
fn assembled<C: GeneratedChain<Scalar = f64>>(chain: &C, seed: u64) -> C::State {
    let mut random = Random::new(seed);
    let mut state = chain.initial_state();
    state.coordinates_mut().iter_mut().for_each(|q| *q += random.between(-0.1, 0.1));
    state.rates_mut().iter_mut().for_each(|v| *v += random.between(-1.0, 1.0));
    chain.normalize(&mut state);
    chain.assemble(&mut state, &chain.no_inputs()).expect("a linkage nearly closed");
    state
}

#[test]
fn a_welded_branch_of_a_closed_route_is_part_of_its_body() {
    let (welded, merged) = (Welded::<f64>::new(), Merged::<f64>::new());
    let (mut at, mut twin_at) = (welded.workspace(), merged.workspace());
    for seed in 0..20 {
        let state = assembled(&welded, seed);
        let mut twin = merged.initial_state();
        twin.coordinates_mut().copy_from_slice(state.coordinates());
        twin.rates_mut().copy_from_slice(state.rates());
        // Assembled already, also for the merged one, whose masses are the same.
        let before = [twin.coordinates(), twin.rates()].concat();
        merged.assemble(&mut twin, &merged.no_inputs()).expect("a closed linkage");
        let off = difference(&[twin.coordinates(), twin.rates()].concat(), &before);
        assert!(off < TOLERANCE, "seed {seed}: assembled {off:e} apart");

        welded.solve_into(&state, &welded.no_inputs(), &mut at).expect("a movable linkage");
        merged.solve_into(&twin, &merged.no_inputs(), &mut twin_at).expect("a movable linkage");
        assert_eq!([at.closure().redundant(), twin_at.closure().redundant()], [3, 3]);
        let numbers = |at: &[f64], energies: [f64; 2]| [at, &energies].concat();
        let found =
            numbers(at.accelerations().as_slice(), [at.kinetic_energy(), at.potential_energy()]);
        let expected = numbers(
            twin_at.accelerations().as_slice(),
            [twin_at.kinetic_energy(), twin_at.potential_energy()],
        );
        let off = difference(&found, &expected);
        assert!(off < TOLERANCE, "seed {seed}: off by {off:e}");
        macro_rules! same {
            ($($hinge:ident)*) => { $(
                let (found, expected) = (at.$hinge().output(), twin_at.$hinge().output());
                let wrench = |p: &mstmm::Point<f64>| {
                    [p.force().as_slice(), p.moment().as_slice()].concat()
                };
                let off = difference(&wrench(&found), &wrench(&expected));
                assert!(off < TOLERANCE, "seed {seed}, {}: off by {off:e}", stringify!($hinge));
            )* };
        }
        same!(a b c d joint);
    }
}

/// Newton's and Euler's laws of the bodies of the linkage that branches leave, and of the branches.
#[test]
fn reactions_of_a_closed_route_balance_its_branches() {
    let chain = Hung::<f64>::new();
    let coupler = Lump {
        mass: 2.3125,
        com: [-0.109375, -0.21875, 0.171875],
        inertia: [0.078125, 0.1328125, 0.12890625, 0.005859375, 0.0078125, -0.017578125],
    };
    let weight =
        Lump { mass: 0.5, com: [0.0; 3], inertia: [0.02, 0.03, 0.025, 0.001, 0.002, 0.003] };
    let bob =
        Lump { mass: 0.75, com: [0.2, 0.1, -0.1], inertia: [0.02, 0.03, 0.025, 0.0, 0.0, 0.0] };
    let mut at = chain.workspace();
    for seed in 0..20 {
        let state = assembled(&chain, seed);
        chain.solve_into(&state, &chain.no_inputs(), &mut at).expect("a movable linkage");
        assert_eq!(at.closure().redundant(), 3);
        let (body, outputs) =
            (at.coupler(), [at.near().input(), at.c().input(), at.slide().input()]);
        let outputs: Vec<_> = outputs.iter().collect();
        let off = coupler.imbalance_of_joined(&body.input(), &outputs, GRAVITY);
        assert!(off < TOLERANCE, "seed {seed}, coupler: {off:e}");
        // The output of the coupler reports the sum over both hinges that leave it.
        let sum = at.c().input().force() + at.slide().input().force();
        assert!((body.output().force() - sum).norm() < TOLERANCE * sum.norm(), "seed {seed}");
        let moments = at.c().input().moment() + at.slide().input().moment();
        let off = (body.output().moment() - moments).norm() / sum.norm().max(moments.norm());
        assert!(off < TOLERANCE, "seed {seed}: {off:e}");

        let joined = [&at.far().input(), &at.beside().input()];
        let off = weight.imbalance_of_joined(&at.weight().input(), &joined, GRAVITY);
        assert!(off < TOLERANCE, "seed {seed}, weight: {off:e}");
        for last in [at.second(), at.third()] {
            let off = bob.imbalance_of_joined(&last.input(), &[], GRAVITY);
            assert!(off < TOLERANCE, "seed {seed}, bob: {off:e}");
        }
    }
}

/// Springs and gravity keep the energy: exactly in each state, and over a motion with projections.
#[test]
fn a_closed_route_with_branches_keeps_its_energy() {
    let (chain, same) = (Hung::<f64>::new(), Hung::<Dual<f64>>::new());
    for seed in 0..20 {
        let state = assembled(&chain, seed);
        let rate = energy_rate(&chain, &same, &state, &chain.no_inputs());
        // A sum of terms of some hundred W.
        assert!(rate.abs() < 1e-10, "seed {seed}: {rate:e} W");
    }
    let mut state = assembled(&chain, 0);
    let (before, mut rk4) = (chain.energy(&state).total(), Rk4::new(1e-3));
    for _ in 0..500 {
        rk4.step(&chain, &mut state, |_, _| chain.no_inputs()).expect("a step");
    }
    let after = chain.energy(&state);
    // The error of a step is that of order five, some (10/s · 1 ms)^5; five hundred of them.
    let off = (after.total() - before).abs() / after.kinetic;
    assert!(off < 1e-7, "{off:e}");
    // Closed after each step: assembling again moves nothing but roundings.
    let closed = state.coordinates().to_vec();
    chain.assemble(&mut state, &chain.no_inputs()).expect("a closed linkage");
    let off = difference(state.coordinates(), &closed);
    assert!(off < 1e-9, "open by {off:e}");
}

macro_rules! suspended {
    ($($name:ident [$($from:tt)*] [$($to:tt)*] [$($crane:tt)*])*) => { $(
        mstmm_chain! { chain $name {
            gravity = input;
            body Bar {
                mass = 1 kg; com = [0.3, 0.1, 0] m; output = [0.6, 0, 0] m;
                inertia = diag(0.03, 0.12, 0.14) kg*m^2 about com;
                point side = [0.3, 0.2, 0.1] m turned rpy(10, 20, 30) deg;
            }
            $($from)* -> ball a -> Bar first -> universal(y, z) b -> Bar second -> ball c -> $($to)*;
            second.side -> repeat 2 { pin(x) d -> Bar tail };
            first.side -> pin(y) e -> Bar branch;
            $($crane)* -> ball f -> Bar load -> pin(z) g -> Bar hook;
            hinge e { stiffness = 5; }
        } }
    )* };
}

suspended! {
    Moving [moving left] [moving right] [moving crane]
    Still [ground] [ground at [0.9, 0.2, 0.1] m] [ground at [0, 1, 0] m]
}

/// The motion of an end that moves with all others, without rotating.
fn carried(
    place: [f64; 3],
    velocity: [f64; 3],
    acceleration: [f64; 3],
) -> HingeMotion<FloatingState<f64>, mstmm::nalgebra::SVector<f64, 6>> {
    let state = FloatingState::new(place, [1.0, 0.0, 0.0, 0.0], velocity, [0.0; 3]);
    let [x, y, z] = acceleration;
    HingeMotion { state, acceleration: [x, y, z, 0.0, 0.0, 0.0].into() }
}

/// Ends that accelerate together are the same as ends at rest with gravity less by the acceleration.
#[test]
fn moving_ends_that_accelerate_together_change_gravity() {
    let (moving, still) = (Moving::<f64>::new(), Still::<f64>::new());
    let (mut at, mut twin_at) = (moving.workspace(), still.workspace());
    let mut closed = 0;
    for seed in 0..20 {
        let mut random = Random::new(seed);
        let [velocity, acceleration, gravity] =
            [(); 3].map(|()| [(); 3].map(|()| random.between(-5.0, 5.0)));
        let less = Vector3::from(gravity) - Vector3::from(acceleration);
        let end = |place| carried(place, velocity, acceleration);
        let inputs = MovingInputs {
            gravity: gravity.into(),
            left: end([0.0; 3]),
            right: end([0.9, 0.2, 0.1]),
            crane: end([0.0, 1.0, 0.0]),
        };
        let twin_inputs = StillInputs { gravity: less };
        let mut twin = still.initial_state();
        twin.coordinates_mut().iter_mut().for_each(|q| *q += random.between(-0.4, 0.4));
        twin.rates_mut().iter_mut().for_each(|v| *v += random.between(-2.0, 2.0));
        still.normalize(&mut twin);
        if still.assemble(&mut twin, &twin_inputs).is_err() {
            continue;
        }
        closed += 1;
        let mut state = moving.initial_state();
        state.coordinates_mut().copy_from_slice(twin.coordinates());
        state.rates_mut().copy_from_slice(twin.rates());
        moving.solve_into(&state, &inputs, &mut at).expect("a regular tree");
        still.solve_into(&twin, &twin_inputs, &mut twin_at).expect("a regular tree");
        let off = difference(at.accelerations().as_slice(), twin_at.accelerations().as_slice());
        assert!(off < TOLERANCE, "seed {seed}: off by {off:e}");
        for (point, other) in [
            (at.a().input(), twin_at.a().input()),
            (at.c().input(), twin_at.c().input()),
            (at.f().input(), twin_at.f().input()),
            (at.d(1).expect("of two").input(), twin_at.d(1).expect("of two").input()),
        ] {
            let off = difference(point.force().as_slice(), other.force().as_slice());
            assert!(off < TOLERANCE, "seed {seed}: force off by {off:e}");
            let moves = other.acceleration() + Vector3::from(acceleration);
            let off = difference(point.acceleration().as_slice(), moves.as_slice());
            assert!(off < TOLERANCE, "seed {seed}: acceleration off by {off:e}");
        }
    }
    assert!(closed > 10, "only {closed} states close");
}
