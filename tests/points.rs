//! Centres of mass and named points of bodies, read from a workspace: they move like points fixed in the
//! bodies, and fulfil the laws of mechanics.

mod support;

#[path = "points/chains.rs"]
mod chains;

use chains::*;
use mstmm::{ChainState, Dual, GeneratedChain, Rk4, Scalar};
use mstmm_reference::Random;
use nalgebra::{Vector2, Vector3};
use support::moving::moving;
use support::states::{copied, random_state};
use support::{difference, worst};

/// Random states tried of each chain.
const STATES: u64 = 20;

/// Some hundred operations on numbers near one, in chains whose condition is below a hundred.
const TOLERANCE: f64 = 1e-11;

/// Calls a check for each pair of chains, which are the same by both methods.
macro_rules! for_each_pair {
    ($check:ident) => {
        for_each_open_pair!($check);
        $check!(Loop LoopByTransfer);
    };
}

/// The same for chains that are not closed: dual numbers do not pass a closure's choice of directions.
macro_rules! for_each_open_pair {
    ($check:ident) => {
        $check!(Arm ArmByTransfer);
        $check!(Written WrittenByTransfer);
        $check!(Repeated RepeatedByTransfer);
        $check!(Thrown ThrownByTransfer);
        $check!(Rope RopeByTransfer);
        $check!(Rods RodsByTransfer);
        $check!(Train TrainByTransfer);
        $check!(Cars CarsByTransfer);
    };
}

fn solved<C: Read>(chain: &C, state: &C::State) -> C::Workspace {
    let mut at = chain.workspace();
    chain.solve_into(state, &chain.no_inputs(), &mut at).expect("a regular chain");
    at
}

/// Velocities are the rates of positions and accelerations those of velocities, exactly.
#[test]
fn motions_are_derivatives() {
    fn check<C: Read<Scalar = f64>, D: Read<Scalar = Dual<f64>>>() -> f64 {
        let (chain, same) = (C::prepared(), D::prepared());
        let mut largest = 0.0;
        for seed in 0..STATES {
            let state = random_state::<C>(&mut Random::new(seed));
            let points = C::read(&solved(&chain, &state));
            let on_the_way = moving(&chain, &same, &state, &chain.no_inputs());
            let moving = D::read(&solved(&same, &on_the_way));
            assert_eq!(points.len(), moving.len());
            for (number, (point, rate)) in points.iter().zip(&moving).enumerate() {
                let rates = |values: &[Dual<f64>]| {
                    values.iter().map(|x| x.derivative()).collect::<Vec<_>>()
                };
                let off = worst(
                    difference(&point.velocity, &rates(&rate.position)),
                    difference(&point.acceleration, &rates(&rate.velocity)),
                );
                assert!(off <= TOLERANCE, "seed {seed}: point {number} off by {off:e}");
                largest = worst(largest, off);
            }
        }
        largest
    }
    macro_rules! check {
        ($($chain:ident)*) => { $(
            println!("{}: {:.1e}", stringify!($chain), check::<$chain<f64>, $chain<Dual<f64>>>());
        )* };
    }
    for_each_open_pair!(check);
}

/// The same along a trajectory, by differences of positions.
#[test]
fn motions_are_differences_along_a_trajectory() {
    const STEP: f64 = 1e-4;
    fn check<C: Read<Scalar = f64>>() {
        let chain = C::prepared();
        let mut state = random_state::<C>(&mut Random::new(1));
        chain.assemble(&mut state, &chain.no_inputs()).expect("a closed chain");
        let mut rk4 = Rk4::new(STEP);
        let mut steps = Vec::new();
        for _ in 0..30 {
            rk4.step(&chain, &mut state, |_, _| chain.no_inputs()).expect("regular");
            steps.push(C::read(&solved(&chain, &state)));
        }
        for now in 1..steps.len() - 1 {
            for (number, point) in steps[now].iter().enumerate() {
                let [before, after] = [&steps[now - 1][number], &steps[now + 1][number]];
                let slope = |a: &[f64], b: &[f64]| -> Vec<f64> {
                    a.iter().zip(b).map(|(a, b)| (b - a) / (2.0 * STEP)).collect()
                };
                let off = worst(
                    difference(&point.velocity, &slope(&before.position, &after.position)),
                    difference(&point.acceleration, &slope(&before.velocity, &after.velocity)),
                );
                // The differences err by STEP² / 6 times a third derivative.
                assert!(off < 1e-5, "point {number} off by {off:e}");
            }
        }
    }
    macro_rules! check {
        ($($chain:ident)*) => { $(check::<$chain<f64>>();)* };
    }
    for_each_pair!(check);
}

/// Results in `f32` and `f64` agree up to single precision, and both methods agree.
#[test]
fn precisions_and_methods_agree() {
    fn check<A, B>(tolerance: f64, number: fn(B::Scalar) -> f64)
    where
        A: Read<Scalar = f64>,
        B: Read,
    {
        let (a, b) = (A::prepared(), B::prepared());
        let mut closed = 0;
        for seed in 0..STATES {
            let mut state = random_state::<A>(&mut Random::new(seed));
            if a.assemble(&mut state, &a.no_inputs()).is_err() {
                continue;
            }
            closed += 1;
            let mut same = b.initial_state();
            let set = |(to, &from): (&mut B::Scalar, &f64)| *to = B::Scalar::constant(from);
            same.coordinates_mut().iter_mut().zip(state.coordinates()).for_each(set);
            same.rates_mut().iter_mut().zip(state.rates()).for_each(set);
            let (expected, found) = (A::read(&solved(&a, &state)), B::read(&solved(&b, &same)));
            assert_eq!(expected.len(), found.len());
            for (number_of_point, (expected, found)) in expected.iter().zip(&found).enumerate() {
                let off =
                    expected.parts().into_iter().zip(found.parts()).map(|(expected, found)| {
                        let found: Vec<f64> = found.iter().map(|&x| number(x)).collect();
                        difference(&found, expected)
                    });
                let off = off.fold(0.0, worst);
                assert!(off <= tolerance, "seed {seed}: point {number_of_point} off by {off:e}");
            }
        }
        assert!(closed > STATES / 2, "only {closed} states close");
    }
    macro_rules! check {
        ($chain:ident $other:ident) => {
            check::<$chain<f64>, $chain<f32>>(3e-3, f64::from);
            check::<$chain<f64>, $other<f32>>(3e-3, f64::from);
            check::<$chain<f64>, $other<f64>>(1e-10, |x| x);
        };
    }
    for_each_pair!(check);
}

/// Repeated parts and the same parts written out have the same results, with different parameters in each
/// repetition.
#[test]
fn repeated_parts_have_points_by_index() {
    fn check<A: Read<Scalar = f64>, B: Read<Scalar = f64>>() {
        let (unrolled, repeated) = (A::prepared(), B::prepared());
        for seed in 0..STATES {
            let state = random_state::<A>(&mut Random::new(seed));
            let expected = A::read(&solved(&unrolled, &state));
            let found = B::read(&solved(&repeated, &copied(&state)));
            assert_eq!(expected.len(), found.len());
            for (number, (expected, found)) in expected.iter().zip(&found).enumerate() {
                let parts = expected.parts().into_iter().zip(found.parts());
                let off = parts.map(|(expected, found)| difference(found, expected));
                let off = off.fold(0.0, worst);
                assert!(off <= TOLERANCE, "seed {seed}: point {number} off by {off:e}");
            }
        }
    }
    check::<Written<f64>, Repeated<f64>>();
    check::<WrittenByTransfer<f64>, RepeatedByTransfer<f64>>();
    check::<Rods<f64>, Rope<f64>>();
    check::<RodsByTransfer<f64>, RopeByTransfer<f64>>();
    check::<Cars<f64>, Train<f64>>();
    check::<CarsByTransfer<f64>, TrainByTransfer<f64>>();
}

/// A point at the output moves like the output, whose motion is computed by the sweeps.
#[test]
fn a_point_at_the_output_moves_as_the_output() {
    macro_rules! check {
        ($($chain:ident)*) => { $(
            let chain = $chain::<f64>::prepared();
            for seed in 0..STATES {
                let state = random_state::<$chain<f64>>(&mut Random::new(seed));
                let at = solved(&chain, &state);
                for body in [at.upper(), at.glued()] {
                    let (end, output) = (body.end(), body.output());
                    let off = [
                        (end.position() - output.position()).norm(),
                        (end.velocity() - output.velocity()).norm() / 10.0,
                        (end.acceleration() - output.acceleration()).norm() / 100.0,
                    ];
                    assert!(off.iter().all(|&off| off <= TOLERANCE), "seed {seed}: {off:?}");
                    assert_eq!(end.orientation(), body.input().orientation());
                    assert_eq!(end.angular_velocity(), output.angular_velocity());
                    assert_eq!(end.angular_acceleration(), output.angular_acceleration());
                }
            }
        )* };
    }
    check!(Arm ArmByTransfer);
}

/// Newton's law for the whole chain: the force of the ground accelerates all centres of mass.
#[test]
fn forces_accelerate_centres_of_mass() {
    macro_rules! check {
        ($($chain:ident)*) => { $(
            let chain = $chain::<f64>::prepared();
            let gravity = Vector3::from(GRAVITY);
            for seed in 0..STATES {
                let state = random_state::<$chain<f64>>(&mut Random::new(seed));
                let at = solved(&chain, &state);
                let held = at.shoulder().input().force();
                let needed = (at.upper().com().acceleration() - gravity) * LINK
                    + (at.glued().com().acceleration() - gravity) * LINK
                    + (at.tool().com().acceleration() - gravity) * TOOL;
                let off = (held - needed).norm() / held.norm();
                assert!(off <= TOLERANCE, "seed {seed}: off by {off:e}");
            }
        )* };
    }
    check!(Arm ArmByTransfer);
}

/// The centre of mass of a thrown chain falls with gravity, in both precisions, and its momentum gives the
/// energy of a chain of lumps.
#[test]
fn a_thrown_chain_falls() {
    fn centre<T: Scalar>(points: &[Motion<T>]) -> Vec<T> {
        let mass = T::constant(LINK);
        let total = (points.len() as f64 * LINK).recip();
        let sum =
            |k: usize| points.iter().fold(T::default(), |sum, p| sum + p.acceleration[k] * mass);
        (0..3).map(|k| sum(k) * T::constant(total)).collect()
    }
    macro_rules! check {
        ($($chain:ident)*) => { $(
            for seed in 0..STATES {
                let double = $chain::<f64>::prepared();
                let state = random_state::<$chain<f64>>(&mut Random::new(seed));
                let at = solved(&double, &state);
                let coms = [at.first().com(), at.second().com(), at.third().com()];
                let all = coms.map(|com| Motion::of(&com));
                assert!(difference(&centre(&all), &GRAVITY) <= TOLERANCE, "seed {seed}");

                let single = $chain::<f32>::prepared();
                let state = random_state::<$chain<f32>>(&mut Random::new(seed));
                let at = solved(&single, &state);
                let coms = [at.first().com(), at.second().com(), at.third().com()];
                let found: Vec<f64> =
                    centre(&coms.map(|com| Motion::of(&com))).into_iter().map(f64::from).collect();
                assert!(difference(&found, &GRAVITY) <= 1e-4, "seed {seed}: {found:?}");
            }
        )* };
    }
    check!(Thrown ThrownByTransfer);
}

/// Points that depend on parameters are where they were when the workspace was written.
#[test]
fn points_are_those_of_the_last_solution() {
    macro_rules! check {
        ($chain:ident, $body:ident $(($index:literal).$some:ident($why:literal))?) => {
            let mut chain = $chain::<f64>::prepared();
            let state = chain.initial_state();
            let mut at = solved(&chain, &state);
            let length = |at: &<$chain<f64> as GeneratedChain>::Workspace| {
                let body = at.$body($($index)?)$(.$some($why))?;
                (body.end().position() - body.input().position()).norm()
            };
            let off = |found: f64, expected: f64| (found - expected).abs() / expected;
            let before = length(&at);
            chain.set_reach(4.0).expect("a finite length");
            assert_eq!(length(&at), before);
            chain.solve_into(&state, &chain.no_inputs(), &mut at).expect("regular");
            assert!(off(length(&at), 4.0) < 1e-14, "{} is not 4", length(&at));
            assert!(before < 3.0);
        };
    }
    check!(Plain, rod);
    check!(PlainByTransfer, rod);
    check!(Many, rod(1).expect("there are three"));
    check!(ManyByTransfer, rod(1).expect("there are three"));
}

/// Chains with fewer results have the same values as chains with all results.
#[test]
fn fewer_results_have_fewer_motions() {
    let (all, poses, watched) = (Everything::<f64>::new(), Poses::new(), Watched::new());
    for seed in 0..STATES {
        let state = random_state::<Everything<f64>>(&mut Random::new(seed));
        let mut at = all.workspace();
        all.solve_into(&state, &all.no_inputs(), &mut at).expect("regular");
        let mut posed = poses.workspace();
        poses.solve_into(&copied(&state), &poses.no_inputs(), &mut posed).expect("regular");
        let mut seen = watched.workspace();
        watched.solve_into(&copied(&state), &watched.no_inputs(), &mut seen).expect("regular");
        let near = |a: Vector3<f64>, b: Vector3<f64>| (a - b).norm() < TOLERANCE;
        assert!(near(at.rod().end().position(), posed.rod().end().position()));
        assert!(near(at.rod().com().position(), posed.rod().com().position()));
        assert!(near(at.rod().end().position(), seen.rod().end().position()));
        assert!(near(at.rod().com().velocity(), seen.rod().com().velocity()));
    }
}

/// A body on a moving end, with what the end does.
#[test]
fn points_on_moving_ends_move_with_them() {
    let mut inputs = CarriedInputs::<f64>::default();
    inputs.deck.state = mstmm::FloatingState::new(
        [1.0, 2.0, 3.0],
        [1.0, 0.0, 0.0, 0.0],
        [0.1, 0.2, 0.3],
        [0.4, -0.5, 0.6],
    );
    inputs.deck.acceleration = [1.0, -2.0, 3.0, -0.4, 0.5, -0.6].into();
    for seed in 0..STATES {
        let chain = Carried::<f64>::new();
        let mut at = chain.workspace();
        let state = random_state::<Carried<f64>>(&mut Random::new(seed));
        chain.solve_into(&state, &inputs, &mut at).expect("regular");
        let rod = at.rod();
        assert!((rod.end().position() - rod.output().position()).norm() < TOLERANCE);
        assert!((rod.end().velocity() - rod.output().velocity()).norm() < TOLERANCE);
        assert!((rod.end().acceleration() - rod.output().acceleration()).norm() < TOLERANCE);
    }
}

/// A chain in a function has points by the function's constants; a type of results can be named.
#[test]
fn points_may_be_constants_and_results_have_a_type() {
    const TIP: f64 = 0.75;
    mstmm::mstmm_chain! {
        plane chain Local {
            body Rod {
                mass = 1 kg; com = [TIP / 2, 0]; inertia = 0.1 kg*m^2 about com;
                point tip = [TIP, 2 * TIP];
            }
            ground -> pin joint -> Rod rod;
        }
    }
    fn tip(rod: LocalRodResult<f64>) -> Vector2<f64> {
        rod.tip().position()
    }
    let local = Local::<f64>::new();
    let at = {
        let mut at = local.workspace();
        let state = local.initial_state();
        local.solve_into(&state, &local.no_inputs(), &mut at).expect("regular");
        at
    };
    assert_eq!(tip(at.rod()), Vector2::new(0.75, 1.5));
    assert_eq!(at.rod().com().position(), Vector2::new(0.375, 0.0));
}
