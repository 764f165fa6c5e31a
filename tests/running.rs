//! Generated chains in the integrators: order, tolerance, unit quaternions, dense output, inputs
//! that depend on time and state, single precision.

mod support;

use mstmm::prelude::*;
use mstmm::{Error, Scalar};
use mstmm_reference::Random;
use nalgebra::Vector3;
use support::mechanism::{Mechanism, both};
use support::worst;

both! { Pendulum PendulumByTransfer [Ball, Pin, Ball] {
    gravity = [0, -9.8, 0] m/s^2;
    body Link {
        mass = 1 kg;
        com = [0.5, 0, 0] m;
        output = [1, 0, 0] m;
        inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com;
    }
    ground
        -> ball shoulder -> Link upper -> pin(z) elbow -> Link middle -> ball wrist -> Link lower;
    hinge shoulder { start = rpy(0, 20, -30) deg; start_rate = [0.5, 1, 0] rad/s; }
    hinge elbow { start = 40 deg; }
    hinge wrist { start_rate = [3, 0.1, -1] rad/s; }
} }

mstmm_chain! {
    /// An arm of two links with motors, level at the start.
    chain Arm {
        gravity = [0, -9.8, 0] m/s^2;
        body Link {
            mass = 1.5 kg;
            com = [0.4, 0, 0] m;
            output = [0.8, 0, 0] m;
            inertia = diag(0.01, 0.08, 0.08) kg*m^2 about com;
        }
        ground -> pin(z) shoulder -> Link upper -> pin(z) elbow -> Link lower;
        hinge shoulder, elbow { torque = input; }
    }
}

mstmm_chain! {
    /// One link on a motor.
    chain Swing {
        gravity = [0, -9.8, 0] m/s^2;
        body Link {
            mass = 1.5 kg;
            com = [0.4, 0, 0] m;
            inertia = diag(0.01, 0.08, 0.08) kg*m^2 about com;
        }
        ground -> pin(z) joint -> Link link;
        hinge joint { torque = input; }
    }
}

/// The largest difference of any coordinate or rate.
fn apart<S: ChainState<Scalar = f64>>(a: &S, b: &S) -> f64 {
    let pairs = a.coordinates().iter().zip(b.coordinates()).chain(a.rates().iter().zip(b.rates()));
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, worst)
}

/// The state at `end`, far beyond the accuracy of what is compared with it.
fn exact<C: Mechanism>(chain: &C, end: f64) -> C::State
where
    C::Inputs: Default,
{
    let mut state = chain.start();
    let mut dopri5 = Dopri5::new(1e-13, 1e-13);
    dopri5.advance_to(chain, &mut state, end, |_, _| C::Inputs::default()).expect("steps");
    state
}

/// The slope of log(error) over log(size), by least squares.
fn slope(samples: &[(f64, f64)]) -> f64 {
    let logs: Vec<(f64, f64)> = samples.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let count = logs.len() as f64;
    let mean = logs.iter().fold((0.0, 0.0), |m, l| (m.0 + l.0 / count, m.1 + l.1 / count));
    let along: f64 = logs.iter().map(|l| (l.0 - mean.0) * (l.1 - mean.1)).sum();
    along / logs.iter().map(|l| (l.0 - mean.0).powi(2)).sum::<f64>()
}

/// Errors from 1e-4 to 1e-8 lie above rounding and below where higher orders count.
#[test]
fn the_classical_method_is_of_order_four() {
    fn check<C: Mechanism>(name: &str)
    where
        C::Inputs: Default,
    {
        let chain = C::default();
        let exact = exact(&chain, 0.5);
        let samples = [50, 100, 200, 400].map(|steps| {
            let step = 0.5 / f64::from(steps);
            let (mut state, mut rk4) = (chain.start(), Rk4::new(step));
            for _ in 0..steps {
                rk4.step(&chain, &mut state, |_, _| C::Inputs::default()).expect("a step");
            }
            (step, apart(&state, &exact))
        });
        let order = slope(&samples);
        println!("{name}: order {order:.2}, {samples:?}");
        assert!((order - 4.0).abs() < 0.3, "{name}: order {order}, {samples:?}");
    }
    check::<Pendulum<f64>>("riccati");
    check::<PendulumByTransfer<f64>>("transfer");
}

/// The error of a whole motion is near proportional to the tolerance of a step.
#[test]
fn the_error_of_dopri5_follows_its_tolerance() {
    fn check<C: Mechanism>(name: &str)
    where
        C::Inputs: Default,
    {
        let chain = C::default();
        let exact = exact(&chain, 0.5);
        let samples = [1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10].map(|tolerance| {
            let (mut state, mut dopri5) = (chain.start(), Dopri5::new(tolerance, tolerance));
            dopri5.advance_to(&chain, &mut state, 0.5, |_, _| C::Inputs::default()).expect("steps");
            (tolerance, apart(&state, &exact))
        });
        let power = slope(&samples);
        println!("{name}: power {power:.2}, {samples:?}");
        // Steps of order 4 to 5 in their error: 4/5 to 1.
        assert!((0.75..1.2).contains(&power), "{name}: {power}, {samples:?}");
        assert!(samples.iter().all(|(tolerance, error)| *error < 100.0 * tolerance), "{samples:?}");
    }
    check::<Pendulum<f64>>("riccati");
    check::<PendulumByTransfer<f64>>("transfer");
}

#[test]
fn quaternions_stay_of_unit_length() {
    let chain = Pendulum::<f64>::new();
    let (mut state, mut rk4) = (chain.initial_state(), Rk4::new(2e-3));
    for step in 0..5000 {
        rk4.step(&chain, &mut state, |_, _| chain.no_inputs()).expect("a step");
        for orientation in [state.shoulder().orientation(), state.wrist().orientation()] {
            let off = (orientation.into_inner().norm() - 1.0).abs();
            // One rounding of each component and of the norm here.
            assert!(off <= 4.0 * f64::EPSILON, "step {step}: {off:e}");
        }
    }
}

/// The interpolation is of order four; against steps that end at the same times its error is that
/// of a step with a hundred times the tolerance.
#[test]
fn dense_output_lies_on_the_motion() -> Result<(), Error> {
    let chain = Pendulum::<f64>::new();
    let (mut state, mut dopri5) = (chain.initial_state(), Dopri5::new(1e-9, 1e-9));
    let mut between = chain.initial_state();
    let mut random = Random::new(1);
    while state.t < 0.5 {
        let start = state.clone();
        dopri5.step(&chain, &mut state, |_, _| chain.no_inputs())?;
        let time = random.between(start.t, state.t);
        dopri5.interpolate(&chain, time, &mut between)?;
        let off = apart(&between, &exact(&chain, time));
        assert!(off < 1e-6 && between.t == time, "at {time} s: {off:e}");
        dopri5.interpolate(&chain, start.t, &mut between)?;
        assert!(apart(&between, &start) < 1e-14);
        dopri5.interpolate(&chain, state.t, &mut between)?;
        assert!(apart(&between, &state) < 1e-14);
    }
    assert_eq!(dopri5.interpolate(&chain, state.t + 1.0, &mut between), Err(Error::OutsideStep));
    Ok(())
}

/// With J = 0.08 + 1.5 · 0.4² kg·m² and m g l = 1.5 · 9.8 · 0.4 N·m the torque
/// J θ̈ + m g l cos θ makes θ = sin t.
#[test]
fn a_torque_that_depends_on_time_makes_the_motion_asked_for() -> Result<(), Error> {
    let chain = Swing::<f64>::new();
    let mut state = chain.initial_state();
    state.joint_mut().set_rate(1.0);
    let torque = |time: f64| {
        let angle = time.sin();
        SwingInputs { joint: -0.32 * angle + 5.88 * angle.cos() }
    };
    let mut dopri5 = Dopri5::new(1e-11, 1e-11);
    for time in [0.5, 1.0, 2.0] {
        dopri5.advance_to(&chain, &mut state, time, |time, _| torque(time))?;
        // An error in θ grows at most with the rate √(m g l / J) = 4.3 /s, in two seconds 6e3
        // times.
        let off = (state.joint().angle() - time.sin()).abs();
        assert!(off < 6e-8, "at {time} s: {off:e}");
    }
    Ok(())
}

/// The torques that hold the arm against gravity, from the lever arms of its two centres of mass.
fn against_gravity(state: &ArmState<f64>) -> ArmInputs<f64> {
    let (first, second) =
        (state.shoulder().angle(), state.shoulder().angle() + state.elbow().angle());
    let weight = 1.5 * 9.8;
    let elbow = weight * 0.4 * second.cos();
    ArmInputs { shoulder: weight * (0.4 + 0.8) * first.cos() + elbow, elbow }
}

#[test]
fn an_arm_held_against_gravity_stays_where_it_is() -> Result<(), Error> {
    let chain = Arm::<f64>::new();
    let mut state = chain.initial_state();
    state.shoulder_mut().set_angle(0.4);
    state.elbow_mut().set_angle(-1.1);
    let (start, mut rk4) = (state.clone(), Rk4::new(1e-3));
    let accelerations = chain.accelerations(&state, &against_gravity(&state))?;
    assert!(accelerations.norm() < 1e-13, "{accelerations}");
    for _ in 0..1000 {
        rk4.step(&chain, &mut state, |_, state| against_gravity(state))?;
    }
    // Held so it has no frequency: rounding of accelerations grows with the square of time.
    assert!(apart(&state, &start) < 1e-13);
    Ok(())
}

#[test]
fn a_controller_brings_the_arm_to_its_set_point() -> Result<(), Error> {
    let chain = Arm::<f64>::new();
    let (mut state, mut rk4) = (chain.initial_state(), Rk4::new(1e-3));
    let goal = [1.0, -0.5];
    // With these gains the slowest motion dies as fast as exp(−3 t): stiffness over damping.
    let control = |_time: f64, state: &ArmState<f64>| {
        let mut inputs = against_gravity(state);
        inputs.shoulder +=
            60.0 * (goal[0] - state.shoulder().angle()) - 20.0 * state.shoulder().rate();
        inputs.elbow += 60.0 * (goal[1] - state.elbow().angle()) - 20.0 * state.elbow().rate();
        inputs
    };
    for _ in 0..15_000 {
        rk4.step(&chain, &mut state, control)?;
    }
    let off = [state.shoulder().angle() - goal[0], state.elbow().angle() - goal[1]];
    assert!(off.iter().all(|off| off.abs() < 1e-12), "{off:?}");
    assert!(state.v.norm() < 1e-12);
    Ok(())
}

/// The result of half a second.
struct Outcome<T> {
    energies: [T; 2],
    tip: Vector3<T>,
    force_on_ground: Vector3<T>,
}

fn half_a_second<T>() -> Result<Outcome<T>, Error>
where
    T: Scalar<Real = T, Mask = bool> + PartialOrd,
{
    let chain = Pendulum::<T>::new();
    let mut state = chain.initial_state();
    let before = chain.energy(&state).total();
    let mut rk4 = Rk4::new(T::constant(1.0 / 512.0));
    for _ in 0..128 {
        rk4.step(&chain, &mut state, |_, _| chain.no_inputs())?;
    }
    let tolerance = T::constant(1e-6);
    let mut dopri5 = Dopri5::new(tolerance, tolerance);
    dopri5.advance_to(&chain, &mut state, T::constant(0.5), |_, _| chain.no_inputs())?;
    let mut at = chain.workspace();
    chain.solve_into(&state, &chain.no_inputs(), &mut at)?;
    Ok(Outcome {
        energies: [before, chain.energy(&state).total()],
        tip: at.lower().output().position(),
        force_on_ground: at.shoulder().input().force(),
    })
}

/// Single precision runs all that double precision does, and follows it.
#[test]
fn single_precision_runs_and_follows() -> Result<(), Error> {
    let (double, single) = (half_a_second::<f64>()?, half_a_second::<f32>()?);
    let drift = (single.energies[1] - single.energies[0]).abs();
    // Some hundred steps of a rounding of 6e-8 each, of energies of some tens of joules.
    assert!(drift < 200.0 * 6e-8 * 30.0, "{drift}");
    let [tip, force] = [single.tip, single.force_on_ground].map(|vector| vector.map(f64::from));
    let force_off = (force - double.force_on_ground).norm() / double.force_on_ground.norm();
    let off = [(tip - double.tip).norm(), force_off];
    println!("single precision: tip off by {:.1e} m, force by {:.1e}", off[0], off[1]);
    // The same rounding, in a motion that lets neighbours part by ten times.
    assert!(off.iter().all(|off| *off < 200.0 * 6e-8 * 10.0), "{off:?}");
    Ok(())
}
