//! The solvers of `diffsol` on chains, checked by closed forms, statics, energy and exact derivatives of `Dopri5`.

use diffsol::{
    NalgebraLU, NalgebraMat, OdeBuilder, OdeSolverMethod, OdeSolverStopReason, Vector, VectorCommon,
};
use mstmm::Dual;
use mstmm::prelude::*;
use mstmm_diffsol::{
    Linearized, by_parameters, dimension, jacobian, rhs, start, start_by_parameters, state,
};
use std::cell::Cell;
use std::error::Error;

type Matrix = NalgebraMat<f64>;
type Lu = NalgebraLU<f64>;

mstmm_chain! {
    /// A rod alone has the decay rate damping / inertia = 10 / (1e-4 + 0.1 · 0.05²) = 29 000 /s; next to others it is
    /// higher. The slowest mode of the whole decays at 0.4 /s.
    plane chain Rods {
        gravity = [0, -9.81] m/s^2;
        answers = linearize;
        body Rod {
            mass = 0.1 kg; com = [0.05, 0] m; inertia = 1e-4 kg*m^2 about com; output = [0.1, 0] m;
        }
        ground -> repeat 20 { pin joint -> Rod rod };
        hinge joint { stiffness = 100 N*m/rad; damping = 10 N*m*s/rad; }
    }
}

mstmm_chain! {
    /// A weight above a floor.
    line chain Drop {
        gravity = -9.81 m/s^2;
        param height = 1 m;
        body Weight { mass = 2 kg; }
        ground -> slider fall -> Weight weight;
        hinge fall { start = height; }
    }
}

mstmm_chain! {
    /// A rod on a pin, with its centre of mass at a distance to be chosen.
    plane chain Pendulum {
        gravity = [0, -9.81] m/s^2;
        answers = linearize;
        param length = 0.5 m;
        body Rod { mass = 2 kg; com = [0, -length]; inertia = 0.1 kg*m^2 about com; }
        ground -> pin joint -> Rod rod;
        hinge joint { start = 60 deg; }
    }
}

const GRAVITY: f64 = 9.81;

/// Returns the bending moments of a resting rope: of the weights of all rods outboard of each joint.
fn moments(angles: &[f64]) -> Vec<f64> {
    let (mut joint, mut direction, mut joints, mut centres) = (0.0, 0.0, vec![], vec![]);
    for angle in angles {
        direction += angle;
        joints.push(joint);
        centres.push(joint + 0.05 * direction.cos());
        joint += 0.1 * direction.cos();
    }
    let moment = |(at, joint): (usize, &f64)| -> f64 {
        centres[at..].iter().map(|centre| 0.1 * GRAVITY * (centre - joint)).sum()
    };
    joints.iter().enumerate().map(moment).collect()
}

/// Twenty rods on stiff hinges come to rest. `Dopri5` is as accurate, with steps that stiffness limits.
#[test]
fn a_stiff_chain_comes_to_rest() -> Result<(), Box<dyn Error>> {
    const EARLY: f64 = 0.05;
    let (chain, dual) = (Rods::<f64>::new(), Rods::<Dual<f64>>::new());
    let linearized = Linearized::new(chain.clone()).ok_or("no linearize")?;
    let mut explicit = chain.initial_state();
    let mut dopri5 = Dopri5::new(1e-6, 1e-6);
    dopri5.advance_to(&chain, &mut explicit, EARLY, |_, _| chain.no_inputs())?;
    assert!(dopri5.is_stiff());
    println!("Dopri5 to {EARLY} s: {:?}", dopri5.statistics());

    let evaluations = Cell::new(0);
    for by_linearize in [false, true] {
        evaluations.set(0);
        let problem = OdeBuilder::<Matrix>::new()
            .rtol(1e-6)
            .atol([1e-6])
            .rhs_implicit(
                |y: &[f64], p: &[f64], t, dy: &mut [f64]| {
                    evaluations.set(evaluations.get() + 1);
                    rhs(&chain, (y, p, t), dy);
                },
                |y: &[f64], p: &[f64], t, along: &[f64], product: &mut [f64]| match by_linearize {
                    true => linearized.jacobian((y, p, t), along, product),
                    false => jacobian(&dual, (y, p, t), along, product),
                },
            )
            .init(|p: &[f64], _, y: &mut [f64]| start(&chain, p, y), dimension(&chain))
            .build()?;
        let mut solver = problem.bdf::<Lu>()?;
        let mut advance = |end: f64| -> Result<RodsState<f64>, Box<dyn Error>> {
            solver.set_stop_time(end)?;
            while !matches!(solver.step()?, OdeSolverStopReason::TstopReached) {}
            Ok(state(solver.state().y.inner().iter().copied(), end))
        };
        let early = advance(EARLY)?;
        let difference = (early.q - explicit.q).amax();
        let early_evaluations = evaluations.get();
        let rest = advance(40.0)?;
        let torques = moments(rest.q.as_slice());
        let worst =
            torques.iter().zip(&rest.q).map(|(moment, angle)| (moment + 100.0 * angle).abs());
        let worst = worst.fold(0.0, f64::max);
        println!(
            "BDF, linearize {by_linearize}: {early_evaluations} evaluations to {EARLY} s, difference {difference:.1e} \
             rad; {} evaluations and {} steps to 40 s; moments {:.3} N m, off by {worst:.1e} N m",
            evaluations.get(),
            solver.get_statistics().number_of_steps,
            torques[0],
        );
        assert!(early_evaluations * 10 < dopri5.statistics().evaluations);
        // Some hundred steps with local errors of 1e-6, in each method.
        assert!(difference < 1e-4 && explicit.q.amax() > 100.0 * difference, "{difference}");
        // An error of the angles of the order of the tolerance, times the stiffness.
        assert!(worst < 1e-6 * 100.0 * 20.0 && torques[0] > 10.0, "{worst}");
    }
    Ok(())
}

/// A weight falls on the floor and bounces with half of its speed: times and velocities in closed form.
#[test]
fn a_weight_bounces_at_its_events() -> Result<(), Box<dyn Error>> {
    const RESTITUTION: f64 = 0.5;
    let (chain, dual) = (Drop::<f64>::new(), Drop::<Dual<f64>>::new());
    let problem = OdeBuilder::<Matrix>::new()
        .rtol(1e-8)
        .atol([1e-8])
        .rhs_implicit(
            |y: &[f64], p: &[f64], t, dy: &mut [f64]| rhs(&chain, (y, p, t), dy),
            |y: &[f64], p: &[f64], t, along: &[f64], product: &mut [f64]| {
                jacobian(&dual, (y, p, t), along, product);
            },
        )
        .init(|p: &[f64], _, y: &mut [f64]| start(&chain, p, y), dimension(&chain))
        .root(|y: &[f64], _: &[f64], _, height: &mut [f64]| height[0] = y[0], 1)
        .reset(|y: &[f64], _: &[f64], _, after: &mut [f64]| {
            after.copy_from_slice(&[0.0, -RESTITUTION * y[1]]);
        })
        .build()?;
    let mut solver = problem.bdf::<Lu>()?;
    let (mut time, mut speed) = ((2.0 / GRAVITY).sqrt(), (2.0 * GRAVITY).sqrt());
    for impact in 0..3 {
        let found = loop {
            if let OdeSolverStopReason::RootFound(time, _) = solver.step()? {
                break time;
            }
        };
        solver.state_mut_back(found)?;
        let velocity = solver.state().y.get_index(1);
        println!("impact {impact} after {found:.9} s at {velocity:.9} m/s");
        // The constant acceleration leaves the errors of the start and of the root: some tolerances.
        assert!((found - time).abs() < 1e-6, "{found} is not {time}");
        assert!((velocity + speed).abs() < 1e-6, "{velocity} is not -{speed}");
        solver.apply_reset()?;
        speed *= RESTITUTION;
        time += 2.0 * speed / GRAVITY;
    }
    Ok(())
}

/// Returns the arithmetic-geometric mean.
fn agm(mut a: f64, mut b: f64) -> f64 {
    for _ in 0..10 {
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
    }
    a
}

/// The lowest point of a pendulum: its time by the elliptic integral, its rate by the energy, and the sensitivities of
/// both to the length in closed form. The sensitivity of the state before agrees with exact derivatives of `Dopri5`.
#[test]
fn sensitivities_at_the_lowest_point() -> Result<(), Box<dyn Error>> {
    const LENGTH: f64 = 0.6;
    let (chain, dual) = (Pendulum::<f64>::new(), Pendulum::<Dual<f64>>::new());
    let problem = OdeBuilder::<Matrix>::new()
        .p([LENGTH])
        .rtol(1e-9)
        .atol([1e-9])
        .sens_rtol(1e-9)
        .sens_atol([1e-9])
        .rhs_sens_implicit(
            |y: &[f64], p: &[f64], t, dy: &mut [f64]| rhs(&chain, (y, p, t), dy),
            |y: &[f64], p: &[f64], t, along: &[f64], product: &mut [f64]| {
                jacobian(&dual, (y, p, t), along, product);
            },
            |y: &[f64], p: &[f64], t, along: &[f64], product: &mut [f64]| {
                by_parameters(&dual, (y, p, t), along, product);
            },
        )
        .init_sens(
            |p: &[f64], _, y: &mut [f64]| start(&chain, p, y),
            |p: &[f64], _, along: &[f64], product: &mut [f64]| {
                start_by_parameters(&dual, p, along, product);
            },
            dimension(&chain),
        )
        .root_sens_implicit(
            |y: &[f64], _: &[f64], _, angle: &mut [f64]| angle[0] = y[0],
            |_: &[f64], _: &[f64], _, along: &[f64], change: &mut [f64]| change[0] = along[0],
            |_: &[f64], _: &[f64], _, _: &[f64], change: &mut [f64]| change[0] = 0.0,
            1,
        )
        .build()?;
    let mut solver = problem.bdf_sens::<Lu>()?;
    let time = loop {
        if let OdeSolverStopReason::RootFound(time, _) = solver.step()? {
            break time;
        }
    };
    let (y, sensitivity) = (solver.interpolate(time)?, solver.interpolate_sens(time)?);
    let (rate, by_length) = (y.get_index(1), sensitivity.inner());
    let acceleration = solver.interpolate_dy(time)?.get_index(1);
    // The event is at q(t, p) = 0.
    let time_by_length = -by_length[0] / rate;
    let rate_by_length = by_length[1] + acceleration * time_by_length;

    // ω₀² = m g l / (J + m l²), and dω₀² / dl.
    let (weight, inertia) = (2.0 * GRAVITY * LENGTH, 0.1 + 2.0 * LENGTH * LENGTH);
    let square = weight / inertia;
    let square_by_length = 2.0 * GRAVITY / inertia - square * 4.0 * LENGTH / inertia;
    let amplitude = 60f64.to_radians();
    let quarter = std::f64::consts::FRAC_PI_2 / (square.sqrt() * agm(1.0, (amplitude / 2.0).cos()));
    let fastest = -(2.0 * square * (1.0 - amplitude.cos())).sqrt();
    let close = |what: &str, found: f64, exact: f64| {
        println!("{what}: {found:.9}, exact {exact:.9}");
        // A hundred steps with local errors of 1e-9, which the fastest growth increases less than tenfold.
        assert!(
            (found - exact).abs() < 1e-6 * exact.abs().max(1.0),
            "{what}: {found} is not {exact}"
        );
    };
    close("time of the lowest point", time, quarter);
    close("rate there", rate, fastest);
    close("time by length", time_by_length, -0.5 * quarter * square_by_length / square);
    close("rate by length", rate_by_length, 0.5 * fastest * square_by_length / square);

    let mut exact = Pendulum::<Dual<f64>>::new();
    exact.set_length(Dual::variable(LENGTH))?;
    let mut end = exact.initial_state();
    Dopri5::new(1e-12, 1e-12).advance_to(&exact, &mut end, time, |_, _| exact.no_inputs())?;
    close("angle by length", by_length[0], end.q[0].derivative());
    close("rate by length at this time", by_length[1], end.v[0].derivative());
    Ok(())
}

/// Both Jacobians are central differences up to the errors of these; the start by a parameter is exact.
#[test]
fn products_are_those_of_the_jacobian() {
    let (chain, dual) = (Rods::<f64>::new(), Rods::<Dual<f64>>::new());
    let linearized = Linearized::new(chain.clone()).expect("the answer linearize");
    let y: Vec<f64> = (0..40).map(|k| 0.01 * f64::from(k)).collect();
    let direction: Vec<f64> = (0..40).map(|k| f64::from(k % 3) - 1.0).collect();
    let (mut by_dual, mut by_linearize) = ([0.0; 40], [0.0; 40]);
    jacobian(&dual, (&y, &[], 0.0), &direction, &mut by_dual);
    linearized.jacobian((&y, &[], 0.0), &direction, &mut by_linearize);
    let step = 1e-6;
    let [forward, backward] = [step, -step].map(|step| {
        let moved: Vec<f64> = y.iter().zip(&direction).map(|(y, d)| y + step * d).collect();
        let mut dy = [0.0; 40];
        rhs(&chain, (&moved, &[], 0.0), &mut dy);
        dy
    });
    let scale = by_dual.iter().fold(0.0f64, |scale, entry| scale.max(entry.abs()));
    for k in 0..40 {
        let difference = (forward[k] - backward[k]) / (2.0 * step);
        // Rounding errors of 1e-16 of 40 terms, divided by the step.
        assert!((by_dual[k] - difference).abs() < 1e-6 * scale, "{k}: {} {difference}", by_dual[k]);
        assert!((by_dual[k] - by_linearize[k]).abs() < 1e-11 * scale, "{k}");
    }
}

/// Values that the chain refuses are NaN, which a solver rejects.
#[test]
fn refused_values_are_not_numbers() {
    let chain = Drop::<f64>::new();
    let mut dy = [0.0; 2];
    rhs(&chain, (&[f64::INFINITY, 0.0], &[], 0.0), &mut dy);
    assert!(dy.iter().all(|value| value.is_nan()));
    // Two parameters, where the chain has one.
    rhs(&chain, (&[1.0, 0.0], &[1.0, 2.0], 0.0), &mut dy);
    assert!(dy.iter().all(|value| value.is_nan()));
    assert!(Linearized::new(chain).is_none());
}

/// The chapter shows the adapter unchanged.
#[test]
fn the_chapter_shows_the_adapter() {
    let chapter = include_str!("../../../src/tutorial/diffsol.md");
    let (_, adapter) = include_str!("../src/lib.rs").split_once('\n').expect("a doc line");
    assert!(
        chapter.contains(adapter.trim_end()),
        "src/tutorial/diffsol.md differs from src/lib.rs"
    );
}
