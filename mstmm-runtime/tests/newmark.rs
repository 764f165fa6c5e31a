//! Newmark's method: its formula, its order, how many iterations it needs, what it does to energy.

mod common;

use common::{
    Pendulum, Spring, State, Top, assert_order, distance, spring_error, swing, swing_error,
    top_error,
};
use mstmm_runtime::{Chain, Newmark, Rk4};

/// β, γ and how many iterations.
type Settings = (f64, f64, u32);

const DEFAULT: Settings = (0.25, 0.5, 3);

fn newmark<C: Chain<Scalar = f64>>(h: f64, (beta, gamma, iterations): Settings) -> Newmark<C> {
    Newmark::new(h).with_parameters(beta, gamma).with_iterations(iterations)
}

/// Steps and the errors after 2 s of a spring, a driven pendulum, a free top and a pendulum in
/// space.
fn errors(settings: Settings) -> [Vec<(f64, f64)>; 4] {
    let mut truth = Top::start();
    let hanging = Top::hanging();
    Rk4::new(1.0 / 2048.0).advance_to(&hanging, &mut truth, 2.0, |_, _| ()).unwrap();
    let steps = || (4..10).map(|i| 2.0 / f64::from(1 << i));
    [
        steps()
            .map(|h| {
                let (spring, mut state) = (Spring::new(1.0, 0.0), Spring::at(1.0, 0.0));
                newmark(h, settings).advance_to(&spring, &mut state, 2.0, |_, _| 0.0).unwrap();
                (h, spring_error(&state))
            })
            .collect(),
        steps()
            .map(|h| {
                let (pendulum, mut state) = (Pendulum::new(), Pendulum::at(0.0, 1.0));
                let mut method = newmark(h, settings);
                method.advance_to(&pendulum, &mut state, 2.0, |t, _| swing(t)).unwrap();
                (h, swing_error(&state))
            })
            .collect(),
        steps()
            .map(|h| {
                let mut state = Top::start();
                newmark(h, settings).advance_to(&Top::new(), &mut state, 2.0, |_, _| ()).unwrap();
                (h, top_error(&state))
            })
            .collect(),
        steps()
            .map(|h| {
                let mut state = Top::start();
                newmark(h, settings).advance_to(&hanging, &mut state, 2.0, |_, _| ()).unwrap();
                (h, distance(&state, truth.q, truth.v))
            })
            .collect(),
    ]
}

#[test]
fn order_two() {
    errors(DEFAULT).iter().for_each(|samples| assert_order(2.0, samples));
}

#[test]
fn order_two_with_one_iteration_and_with_other_betas() {
    for settings in [(0.25, 0.5, 1), (0.25, 0.5, 2), (1.0 / 6.0, 0.5, 3), (0.0, 0.5, 3)] {
        errors(settings).iter().for_each(|samples| assert_order(2.0, samples));
    }
}

#[test]
fn order_one_with_another_gamma() {
    errors((0.3025, 0.6, 3)).iter().for_each(|samples| assert_order(1.0, samples));
}

/// More iterations than three change the error by less than a twentieth.
#[test]
fn three_iterations_suffice() {
    for (three, many) in errors(DEFAULT).iter().zip(errors((0.25, 0.5, 12))) {
        for (few, many) in three.iter().zip(many) {
            assert!(few.1 < 1.05 * many.1, "{few:?} {many:?}");
        }
    }
}

/// The default is what it is said to be, and no iteration at all is one.
#[test]
fn settings_are_as_documented() {
    let stepped = |mut method: Newmark<Pendulum<f64>>| {
        let mut state = Pendulum::at(0.3, 1.0);
        method.step(&Pendulum::new(), &mut state, |t, _| t).unwrap();
        state
    };
    assert_eq!(stepped(Newmark::new(0.1)), stepped(newmark(0.1, DEFAULT)));
    assert_eq!(stepped(newmark(0.1, (0.25, 0.5, 0))), stepped(newmark(0.1, (0.25, 0.5, 1))));
}

/// With many iterations the step fulfils the implicit formulas.
#[test]
fn the_step_is_the_implicit_one() {
    let (k, c, h) = (3.0, 0.5, 0.2);
    for (beta, gamma) in [(0.25, 0.5), (1.0 / 6.0, 0.5), (0.3025, 0.6)] {
        let (chain, mut state) = (Spring::new(k, c), Spring::at(0.4, 2.0));
        newmark(h, (beta, gamma, 40)).step(&chain, &mut state, |t, _| 10.0 * t).unwrap();
        let ([x], [v]) = (state.q, state.v);
        let (before, after) = (-k * 0.4 - c * 2.0, 10.0 * h - k * x - c * v);
        let expected_x = 0.4 + h * 2.0 + h * h * ((0.5 - beta) * before + beta * after);
        let expected_v = 2.0 + h * ((1.0 - gamma) * before + gamma * after);
        assert!((x - expected_x).abs() < 1e-14 && (v - expected_v).abs() < 1e-14, "{state:?}");
    }
}

/// How much of its energy an undamped spring of unit stiffness keeps over so many steps.
fn energy_kept(h: f64, iterations: u32, steps: u32) -> f64 {
    let (chain, mut state) = (Spring::new(1.0, 0.0), Spring::at(1.0, 0.0));
    let mut method = newmark(h, (0.25, 0.5, iterations));
    for _ in 0..steps {
        method.step(&chain, &mut state, |_, _| 0.0).unwrap();
    }
    state.q[0].powi(2) + state.v[0].powi(2)
}

/// The mean acceleration keeps the energy of a spring but for what iterations leave: with three
/// (hω)⁸/128 a step is lost, and all steps up to 2/ω are stable.
#[test]
fn energy_is_lost_by_the_eighth_power_of_the_step() {
    for h in [0.2f64, 0.3, 0.5] {
        let expected = h.powi(8) / 128.0;
        let lost = -energy_kept(h, 3, 10_000).ln() / 1e4;
        assert!((lost / expected - 1.0).abs() < 0.1, "{h} {lost:e} {expected:e}");
    }
    assert!((energy_kept(0.05, 3, 100_000) - 1.0).abs() < 1e-7);
    assert!(energy_kept(1.99, 3, 10_000) < 1.0 && energy_kept(2.01, 3, 10_000) > 1e6);
    assert!(energy_kept(0.5, 2, 10_000) > 100.0);
    assert!((energy_kept(1.0, 40, 10_000) - 1.0).abs() < 1e-9);
}

/// A thousand turns of the pendulum in space: the energy strays by a few hundredths of h².
#[test]
fn energy_in_space_stays_near() {
    for h in [0.02, 0.05] {
        let (chain, mut state) = (Top::<f64>::hanging(), Top::start());
        let (start, mut method) = (chain.energy(&state), Newmark::new(h));
        for _ in 0..(1000.0 / h) as u32 {
            method.step(&chain, &mut state, |_, _| ()).unwrap();
            assert!((chain.energy(&state) - start).abs() < h * h);
        }
    }
}

#[test]
fn inputs_are_asked_at_the_start_and_in_each_iteration_at_the_end() {
    let (chain, mut state) = (Pendulum::<f64>::new(), Pendulum::at(0.0, 0.0));
    let mut asked = Vec::new();
    let ask = |t: f64, s: &State<f64, 1, 1>| {
        asked.push((t, s.t));
        0.0
    };
    Newmark::new(0.5).step(&chain, &mut state, ask).unwrap();
    assert_eq!(asked, [(0.0, 0.0), (0.5, 0.5), (0.5, 0.5), (0.5, 0.5)]);
}

#[test]
fn back_and_forth_returns() {
    let (chain, mut state) = (Pendulum::<f64>::new(), Pendulum::at(1.0, 0.0));
    let mut method = newmark(0.01, (0.25, 0.5, 12));
    method.step(&chain, &mut state, |_, _| 0.0).unwrap();
    method.set_step_size(-method.step_size());
    method.step(&chain, &mut state, |_, _| 0.0).unwrap();
    assert!((state.q[0] - 1.0).abs() < 1e-15 && state.v[0].abs() < 1e-15 && state.t == 0.0);
}
