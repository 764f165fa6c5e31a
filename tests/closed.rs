//! Closed chains: a loop in the plane and in space, parallelograms and a gate in closed form,
//! singular poses, assembly, long simulations.

// Closed chains here start with their links in line, which gives a warning; the tests bend them.
#![allow(deprecated)]

#[path = "closed/sizes.rs"]
mod sizes;
mod support;

use mstmm::description::Origin;
use mstmm::prelude::*;
use mstmm::{Error, GeneratedChain, HingeMotion, PinState};
use mstmm_reference::Random;
use nalgebra::{Vector2, Vector3};
use std::f64::consts::PI;
use support::{difference, worst};

mstmm_chain! {
    /// A loop of four pins with bars of different lengths; it does not close at first.
    plane chain FourBar {
        gravity = [0, -9.8] m/s^2;
        body Crank {
            mass = 1 kg; com = [0.2, 0] m; inertia = 0.02 kg*m^2 about com; output = [0.4, 0] m;
        }
        body Coupler {
            mass = 2 kg; com = [0.5, 0.1] m; inertia = 0.2 kg*m^2 about com; output = [1.1, 0] m;
        }
        body Rocker {
            mass = 1.5 kg; com = [0.3, 0] m; inertia = 0.1 kg*m^2 about com; output = [0.7, 0] m;
        }
        ground -> pin a -> Crank crank -> pin b -> Coupler coupler -> pin c -> Rocker rocker
            -> pin d -> ground at [0.9, 0] m;
        hinge a { start = 60 deg; start_rate = 3 rad/s; }
        hinge b { start = -50 deg; }
        hinge c { start = -120 deg; }
        hinge d { start = 100 deg; }
    }
    chain FourBarInSpace {
        gravity = [0, -9.8, 0] m/s^2;
        body Crank {
            mass = 1 kg; com = [0.2, 0, 0] m; inertia = diag(0.01, 0.02, 0.02) kg*m^2 about com;
            output = [0.4, 0, 0] m;
        }
        body Coupler {
            mass = 2 kg; com = [0.5, 0.1, 0] m; inertia = diag(0.05, 0.2, 0.2) kg*m^2 about com;
            output = [1.1, 0, 0] m;
        }
        body Rocker {
            mass = 1.5 kg; com = [0.3, 0, 0] m; inertia = diag(0.05, 0.1, 0.1) kg*m^2 about com;
            output = [0.7, 0, 0] m;
        }
        ground -> pin a -> Crank crank -> pin b -> Coupler coupler -> pin c -> Rocker rocker
            -> pin d -> ground at [0.9, 0, 0] m;
        hinge a { start = 60 deg; start_rate = 3 rad/s; }
        hinge b { start = -50 deg; }
        hinge c { start = -120 deg; }
        hinge d { start = 100 deg; }
    }
}

/// The distance between the two sides of the closing hinge, in m.
fn gap(at: &FourBarWorkspace<f64>) -> f64 {
    (at.d().input().position() - Vector2::new(0.9, 0.0)).norm()
}

fn gap_in_space(at: &FourBarInSpaceWorkspace<f64>) -> f64 {
    (at.d().input().position() - Vector3::new(0.9, 0.0, 0.0)).norm()
}

fn closed<C: GeneratedChain<Scalar = f64>>(chain: &C) -> C::State {
    let mut state = chain.initial_state();
    chain.assemble(&mut state, &chain.no_inputs()).expect("bars that reach");
    state
}

/// The loop in space has three redundant constraints and moves like the loop in the plane: the
/// accelerations agree to rounding times the condition number of the loop, some hundreds, and so does
/// the motion of two seconds, over which differences grow some hundredfold.
#[test]
fn a_loop_in_space_moves_as_in_the_plane() {
    let (plane, space) = (FourBar::<f64>::new(), FourBarInSpace::<f64>::new());
    let (mut flat, mut spatial) = (closed(&plane), closed(&space));
    let off = difference(spatial.coordinates(), flat.coordinates());
    assert!(off < 1e-12, "assembled {off:e} apart");
    let (mut at, mut beside) = (plane.workspace(), space.workspace());
    let [mut first, mut second] = [0.0; 2];
    let (mut on_plane, mut in_space) = (Rk4::new(1e-3), Rk4::new(1e-3));
    for _ in 0..2000 {
        plane.solve_into(&flat, &plane.no_inputs(), &mut at).expect("a regular loop");
        space.solve_into(&spatial, &space.no_inputs(), &mut beside).expect("a regular loop");
        assert_eq!((at.closure().redundant(), beside.closure().redundant()), (0, 3));
        let fast = space.accelerations(&spatial, &space.no_inputs()).expect("a regular loop");
        assert!(difference(fast.as_slice(), beside.accelerations().as_slice()) < 1e-12);
        let accelerations =
            difference(beside.accelerations().as_slice(), at.accelerations().as_slice());
        (first, second) = (worst(first, accelerations), worst(second, gap(&at)));
        on_plane.step(&plane, &mut flat, |_, _| plane.no_inputs()).expect("a step");
        in_space.step(&space, &mut spatial, |_, _| space.no_inputs()).expect("a step");
    }
    let motion = difference(spatial.coordinates(), flat.coordinates());
    println!("accelerations off by {first:.1e}, motion by {motion:.1e}, gap {second:.1e}");
    assert!(first < 1e-10 && motion < 1e-10 && second < 1e-12);
}

/// The redundant directions leave forces normal to the plane and moments in the plane undetermined.
#[test]
fn undetermined_wrenches_are_out_of_the_plane() {
    let chain = FourBarInSpace::<f64>::new();
    let mut at = chain.workspace();
    chain.solve_into(&closed(&chain), &chain.no_inputs(), &mut at).expect("a regular loop");
    for [fx, fy, _, _, _, mz] in at.closure().undetermined() {
        assert!([fx, fy, mz].into_iter().all(|x| x.abs() < 1e-12));
    }
    for point in at.points() {
        let (force, moment) = (point.force(), point.moment());
        assert!(force.z.abs() < 1e-12 && moment.x.abs() < 1e-12 && moment.y.abs() < 1e-12);
    }
}

#[test]
fn assembly_closes_rough_starts() {
    let chain = FourBarInSpace::<f64>::new();
    let (mut at, mut found) = (chain.workspace(), 0);
    for seed in 0..100 {
        let mut random = Random::new(seed);
        let mut state = chain.initial_state();
        for (q, start) in
            state.coordinates_mut().iter_mut().zip(chain.initial_state().coordinates())
        {
            *q = start + random.between(-0.4, 0.4);
        }
        let before = state.clone();
        match chain.assemble(&mut state, &chain.no_inputs()) {
            Ok(()) => {
                chain.solve_into(&state, &chain.no_inputs(), &mut at).expect("a regular loop");
                assert!(gap_in_space(&at) < 1e-12, "seed {seed}: {:e}", gap_in_space(&at));
                let moving = at.d().input().velocity().norm();
                assert!(moving < 1e-11, "seed {seed}: {moving:e}");
                found += 1;
            }
            Err(error) => {
                assert_eq!((error, &state), (Error::NotAssembled, &before), "seed {seed}");
            }
        }
    }
    assert!(found >= 95, "only {found} of 100 starts led anywhere");
}

mstmm_chain! {
    /// Bars of one metre and a gap that the parameter widens.
    plane chain TooShort {
        param gap = 2 m;
        body Bar {
            mass = 1 kg; com = [0.5, 0] m; inertia = 0.1 kg*m^2 about com; output = [1, 0] m;
        }
        ground -> pin a -> Bar left -> pin b -> Bar middle -> pin c -> Bar right
               -> pin d -> ground at [gap, 0 m];
        hinge a { start = 20 deg; start_rate = 1 rad/s; }
    }
}

#[test]
fn a_chain_that_cannot_reach_is_not_assembled() {
    let mut chain = TooShort::<f64>::new();
    chain.set_gap(4.0).expect("a length");
    let mut state = chain.initial_state();
    let refused = chain.assemble(&mut state, &chain.no_inputs());
    assert_eq!((refused, state), (Err(Error::NotAssembled), chain.initial_state()));
}

/// The energy drift is the error of the method of order four: with half the step, about a sixteenth
/// remains. The loop stays closed, since every step projects onto its constraint.
#[test]
fn energy_and_closure_last() {
    fn run<C: GeneratedChain<Scalar = f64>>(chain: &C, step: f64) -> (f64, C::State) {
        let mut state = closed(chain);
        let before = chain.energy(&state).total();
        Rk4::new(step)
            .advance_to(chain, &mut state, 10.0, |_, _| chain.no_inputs())
            .expect("steps");
        (difference(&[chain.energy(&state).total()], &[before]), state)
    }
    let (plane, space) = (FourBar::<f64>::new(), FourBarInSpace::<f64>::new());
    let (coarse, _) = run(&plane, 1e-3);
    let ((flat, state), (spatial, same)) = (run(&plane, 5e-4), run(&space, 5e-4));
    let (mut at, mut beside) = (plane.workspace(), space.workspace());
    plane.solve_into(&state, &plane.no_inputs(), &mut at).expect("a regular loop");
    space.solve_into(&same, &space.no_inputs(), &mut beside).expect("a regular loop");
    let gaps = [gap(&at), gap_in_space(&beside)];
    println!("energies off by {coarse:.1e}, {flat:.1e} {spatial:.1e}, gaps {gaps:?}");
    assert!(coarse < 1e-6 && flat.max(spatial) < coarse / 12.0 + 1e-11);
    assert!(gaps.into_iter().all(|gap| gap < 1e-12));
}

/// A parallelogram whose crank and rocker are 0.5 m long; everything acts in its last hinge.
macro_rules! parallelogram {
    ($name:ident { $($crank:tt)* }) => {
        mstmm_chain! { plane chain $name {
            gravity = [0, -9.8] m/s^2;
            body Crank {
                mass = 1 kg; com = [0.25, 0] m; inertia = 0.1 kg*m^2 about input;
                output = [0.5, 0] m;
            }
            body Coupler {
                mass = 2 kg; com = [0.5, 0.1] m; inertia = 0.3 kg*m^2 about com;
                output = [1.2, 0] m;
            }
            body Rocker {
                mass = 1.5 kg; com = [0.2, 0] m; inertia = 0.05 kg*m^2 about com;
                output = [0.5, 0] m;
            }
            ground -> pin a -> Crank crank -> pin b -> Coupler coupler -> pin c -> Rocker rocker
                -> pin d -> ground at [1.2, 0] m;
            hinge a { $($crank)* }
            hinge b { armature = 0.04 kg*m^2; }
            hinge d {
                stiffness = 30 N*m/rad; rest = -200 deg; damping = 0.5 N*m*s/rad;
                armature = 0.2 kg*m^2; torque = input;
            }
        } }
    };
}

parallelogram! { Parallelogram { torque = input; } }
parallelogram! { ParallelogramTold { motion = input; } }

/// The torque at the crank for its angle θ, rate and acceleration:
/// J θ̈ + c θ̇ + τ_d + G cos θ − k (d − d₀), where d = −θ − π.
fn crank_torque([angle, rate, acceleration]: [f64; 3], closing_torque: f64) -> f64 {
    let rocker = 0.05 + 1.5 * 0.3 * 0.3;
    let inertia = 0.1 + 2.0 * 0.25 + rocker + 0.04 + 0.2;
    let weight = 9.8 * (0.25 + 2.0 * 0.5 + 1.5 * 0.3) * angle.cos();
    let spring = 30.0 * (-angle - PI + 200.0_f64.to_radians());
    inertia * acceleration + 0.5 * rate + closing_torque + weight - spring
}

/// The coordinates and rates of the other hinges.
fn others(angle: f64, rate: f64) -> ([f64; 3], [f64; 3]) {
    ([-angle, angle + PI, -angle - PI], [-rate, rate, -rate])
}

#[test]
fn everything_acts_at_a_closing_hinge() {
    let (chain, told) = (Parallelogram::<f64>::new(), ParallelogramTold::<f64>::new());
    let mut at = told.workspace();
    let mut largest = 0.0;
    for seed in 0..100 {
        let mut random = Random::new(seed);
        // A tenth of a radian from the flat pose, the constraint is ten times worse conditioned.
        let angle = random.between(0.2, PI - 0.2);
        let (rate, acceleration) = (random.between(-3.0, 3.0), random.between(-9.0, 9.0));
        let d = random.between(-5.0, 5.0);
        let a = crank_torque([angle, rate, acceleration], d);
        let (q, v) = others(angle, rate);
        let mut state = chain.initial_state();
        state.coordinates_mut().copy_from_slice(&[&[angle], &q[..]].concat());
        state.rates_mut().copy_from_slice(&[&[rate], &v[..]].concat());
        let found = chain.accelerations(&state, &ParallelogramInputs { a, d }).expect("regular");
        let all = [acceleration, -acceleration, acceleration, -acceleration];
        let mut off = difference(found.as_slice(), &all);

        let mut state = told.initial_state();
        state.coordinates_mut().copy_from_slice(&q);
        state.rates_mut().copy_from_slice(&v);
        let motion = HingeMotion { state: PinState::new(angle, rate), acceleration };
        told.solve_into(&state, &ParallelogramToldInputs { a: motion, d }, &mut at)
            .expect("a regular loop");
        off = worst(off, difference(at.accelerations().as_slice(), &all[1..]));
        off = worst(off, difference(&[at.a().effort()], &[a]));
        assert!(off < 1e-12, "seed {seed}: {off:e}");
        largest = worst(largest, off);
    }
    println!("off by {largest:.1e}");
}

#[test]
fn assembly_names_a_value_that_is_not_finite() {
    let chain = FourBar::<f64>::new();
    let mut state = chain.initial_state();
    state.q[1] = f64::NAN;
    let found = chain.assemble(&mut state, &chain.no_inputs());
    assert_eq!(found, Err(Error::NotFinite(Origin::Coordinate(1))));
    (state.q[1], state.v[2]) = (0.0, f64::INFINITY);
    let found = chain.assemble(&mut state, &chain.no_inputs());
    assert_eq!(found, Err(Error::NotFinite(Origin::Rate(2))));
}

/// In the flat pose, all hinges lie in a line and two motions branch. The results must be finite and
/// an allowed motion, and the chain must pass through this pose.
#[test]
fn a_flat_pose_has_no_nan() {
    let chain = Parallelogram::<f64>::new();
    let inputs = chain.no_inputs();
    for rate in [0.0, 2.0] {
        let (q, v) = others(0.0, rate);
        let mut state = chain.initial_state();
        state.coordinates_mut().copy_from_slice(&[&[0.0], &q[..]].concat());
        state.rates_mut().copy_from_slice(&[&[rate], &v[..]].concat());
        let mut at = chain.workspace();
        chain.solve_into(&state, &inputs, &mut at).expect("accelerations that are allowed");
        assert_eq!(at.closure().redundant(), 1);
        assert!(at.accelerations().iter().all(|a| a.is_finite()), "{}", at.accelerations());
        // Forces along the line are undetermined: their least norm is some hundred N, like the weights.
        assert!(at.points().iter().all(|p| p.force().norm() < 1e3 && p.moment().abs() < 1e3));
        let mut rk4 = Rk4::new(1e-3);
        for _ in 0..1000 {
            rk4.step(&chain, &mut state, |_, _| inputs).expect("a step");
        }
        chain.solve_into(&state, &inputs, &mut at).expect("a loop");
        let end = at.d().input().position();
        assert!((end - Vector2::new(1.2, 0.0)).norm() < 1e-6, "{end}");
    }
}

/// Single precision keeps its six digits, minus those lost by a second of motion and by the condition
/// number of the loop.
#[test]
fn single_precision_closes_too() {
    let (double, single) = (FourBar::<f64>::new(), FourBar::<f32>::new());
    let (mut state, mut same) = (closed(&double), single.initial_state());
    single.assemble(&mut same, &single.no_inputs()).expect("bars that reach");
    Rk4::new(1e-3).advance_to(&double, &mut state, 1.0, |_, _| double.no_inputs()).expect("steps");
    Rk4::new(1e-3).advance_to(&single, &mut same, 1.0, |_, _| single.no_inputs()).expect("steps");
    let found: Vec<f64> = same.coordinates().iter().map(|&q| f64::from(q)).collect();
    let off = difference(&found, state.coordinates());
    println!("off by {off:.1e}");
    assert!(off < 1e-4, "{off:e}");
    let mut at = single.workspace();
    single.solve_into(&same, &single.no_inputs(), &mut at).expect("a regular loop");
    assert!((at.d().input().position() - Vector2::new(0.9, 0.0)).norm() < 1e-6);
}

mstmm_chain! {
    /// A crank that can turn fully. All links are in line at the start, where Newton's method asks for many turns.
    plane chain InLine {
        gravity = [0, -9.8] m/s^2;
        body Crank { mass = 1 kg; com = [0.05, 0] m; inertia = 1e-3 kg*m^2 about com; output = [0.1, 0] m; }
        body Coupler { mass = 0.5 kg; com = [0.15, 0] m; inertia = 4e-3 kg*m^2 about com; output = [0.3, 0] m; }
        body Rocker { mass = 0.5 kg; com = [0.1, 0] m; inertia = 4e-3 kg*m^2 about com; output = [0.2, 0] m; }
        ground -> pin a -> Crank crank -> pin b -> Coupler coupler -> pin c -> Rocker rocker
            -> pin d -> ground at [0.25, 0] m;
    }
}

/// From anywhere within a rad of the straight pose the chain is closed, and no pin makes a whole turn.
#[test]
fn assembly_does_not_wind_hinges_up() {
    let chain = InLine::<f64>::new();
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let mut state = chain.initial_state();
        state.q.iter_mut().for_each(|q| *q = random.between(-1.0, 1.0));
        let start = state.q;
        assert_eq!(chain.assemble(&mut state, &chain.no_inputs()), Ok(()), "seed {seed}");
        let most = (state.q - start).amax();
        assert!(most < 2.0 * PI, "seed {seed}: {most}");
        let mut at = chain.workspace();
        chain.solve_into(&state, &chain.no_inputs(), &mut at).expect("an assembled state");
        let gap = (at.d().input().position() - Vector2::new(0.25, 0.0)).norm();
        assert!(gap < 1e-13, "seed {seed}: {gap:e}");
    }
}

/// A state that is far from closed is refused by a step, which would correct it by jumps.
#[test]
fn steps_refuse_states_that_are_far_from_assembled() {
    let chain = InLine::<f64>::new();
    let mut state = chain.initial_state();
    state.a_mut().set_angle(0.1);
    let before = state.clone();
    let result = Rk4::new(1e-3).step(&chain, &mut state, |_, _| chain.no_inputs());
    assert_eq!((result, &state), (Err(Error::NotAssembled), &before));
    let mut control = Dopri5::new(1e-8, 1e-8);
    let result = control.advance_to(&chain, &mut state, 0.1, |_, _| chain.no_inputs());
    assert_eq!(result, Err(Error::NotAssembled));
}
