//! The classical method: its order, its clock, its errors.

mod common;

use common::{
    Pendulum, Spring, State, Top, assert_order, norm_error, spring_error, swing, swing_error,
    top_at, top_error,
};
use mstmm_runtime::description::Origin;
use mstmm_runtime::{Error, Rk4};

/// Errors at t = 2 for steps halved again and again.
fn halved<E>(mut error_for: impl FnMut(f64, usize) -> E) -> Vec<(f64, E)> {
    (4..10)
        .map(|i| 1usize << i)
        .map(|steps| (2.0 / steps as f64, error_for(2.0 / steps as f64, steps)))
        .collect()
}

#[test]
fn order_four_with_inputs_that_change_in_time() {
    let samples = halved(|h, steps| {
        let (chain, mut state, mut rk4) = (Pendulum::new(), Pendulum::at(0.0, 1.0), Rk4::new(h));
        for _ in 0..steps {
            rk4.step(&chain, &mut state, |t, _| swing(t)).unwrap();
        }
        swing_error(&state)
    });
    assert_order(4.0, &samples);
}

#[test]
fn order_four_with_quaternions() {
    let samples = halved(|h, steps| {
        let (chain, mut state, mut rk4) = (Top::new(), Top::start(), Rk4::new(h));
        for _ in 0..steps {
            rk4.step(&chain, &mut state, |_, _| ()).unwrap();
        }
        top_error(&state)
    });
    assert_order(4.0, &samples);
}

#[test]
fn order_four_on_a_spring() {
    let samples = halved(|h, _| {
        let (chain, mut state) = (Spring::new(1.0, 0.0), Spring::at(1.0, 0.0));
        Rk4::new(h).advance_to(&chain, &mut state, 2.0, |_, _| 0.0).unwrap();
        spring_error(&state)
    });
    assert_order(4.0, &samples);
}

/// An undamped spring loses (hω)⁶/72 of its energy a step, and is stable up to hω = √8.
#[test]
fn energy_is_lost_by_the_sixth_power_of_the_step() {
    let kept = |h: f64| {
        let (chain, mut state) = (Spring::new(1.0, 0.0), Spring::at(1.0, 0.0));
        let mut rk4 = Rk4::new(h);
        for _ in 0..10_000 {
            rk4.step(&chain, &mut state, |_, _| 0.0).unwrap();
        }
        state.q[0].powi(2) + state.v[0].powi(2)
    };
    for h in [0.05f64, 0.1, 0.2, 0.5] {
        let (lost, expected) = (-kept(h).ln() / 1e4, h.powi(6) / 72.0);
        assert!((lost / expected - 1.0).abs() < 0.1, "{h} {lost:e} {expected:e}");
    }
    assert!(kept(2.82) < 1.0 && kept(2.84) > 1e6);
}

#[test]
fn quaternions_stay_on_the_unit_sphere_and_energy_stays() {
    let (chain, mut state, mut rk4) = (Top::new(), Top::start(), Rk4::new(0.01));
    let energy =
        |s: &State<f64, 4, 3>| 0.5 * (s.v[0].powi(2) + s.v[1].powi(2) + 2.0 * s.v[2].powi(2));
    let before = energy(&state);
    for _ in 0..10_000 {
        rk4.step(&chain, &mut state, |_, _| ()).unwrap();
        assert!(norm_error(&state) < 4.0 * f64::EPSILON);
    }
    // 1e4 steps of local error h⁵ c; c for this motion is below 0.1.
    assert!((energy(&state) - before).abs() < 1e4 * 0.1 * 1e-10);
}

#[test]
fn pendulum_keeps_its_energy() {
    let (chain, mut state, mut rk4) =
        (Pendulum::<f64>::new(), Pendulum::at(1.0, 0.0), Rk4::new(1e-3));
    for _ in 0..10_000 {
        rk4.step(&chain, &mut state, |_t, _state| chain.no_inputs()).unwrap();
    }
    let energy = 0.5 * state.v[0].powi(2) - state.q[0].cos();
    assert!((energy + 1f64.cos()).abs() < 1e-13, "{energy}");
}

#[test]
fn single_precision_follows_to_its_own_accuracy() {
    let (chain, mut state, mut rk4) = (Top::<f32>::new(), Top::start(), Rk4::new(1.0 / 64.0));
    for _ in 0..128 {
        rk4.step(&chain, &mut state, |_, _| ()).unwrap();
    }
    let (q, v) = top_at(f64::from(state.t));
    let sign = if f64::from(state.q[0]) * q[0] < 0.0 { -1.0 } else { 1.0 };
    // 128 roundings of half a unit each for each number, all to one side, times the number of terms
    // in a stage.
    let bound = 128.0 * f64::from(f32::EPSILON);
    assert!(
        state.q.iter().zip(q).all(|(&a, b)| (sign * f64::from(a) - b).abs() < bound),
        "{:?} {q:?}",
        state.q
    );
    assert!(
        state.v.iter().zip(v).all(|(&a, b)| (f64::from(a) - b).abs() < bound),
        "{:?} {v:?}",
        state.v
    );
}

#[test]
fn the_clock_loses_nothing() {
    let (chain, mut state, mut rk4) =
        (Pendulum::<f64>::new(), Pendulum::at(0.0, 0.0), Rk4::new(1e-3));
    for steps in 1..=100_000 {
        rk4.step(&chain, &mut state, |_, _| 0.0).unwrap();
        let exact = f64::from(steps) * 1e-3;
        assert!((state.t - exact).abs() <= exact * f64::EPSILON, "{} {exact}", state.t);
    }
    // In single precision plain addition would be off by 1.4 s after a thousand.
    let (chain, mut state, mut rk4) =
        (Pendulum::<f32>::new(), Pendulum::at(0.0, 0.0), Rk4::new(1e-3));
    for _ in 0..1_000_000 {
        rk4.step(&chain, &mut state, |_, _| 0.0).unwrap();
    }
    assert!((f64::from(state.t) - 1e6 * f64::from(1e-3f32)).abs() < 1e-4, "{}", state.t);
}

#[test]
fn setting_the_time_starts_the_clock_anew() {
    let (chain, mut state, mut rk4) =
        (Pendulum::<f64>::new(), Pendulum::at(0.0, 0.0), Rk4::new(0.1));
    for _ in 0..3 {
        rk4.step(&chain, &mut state, |_, _| 0.0).unwrap();
    }
    state.t = 7.0;
    rk4.step(&chain, &mut state, |_, _| 0.0).unwrap();
    assert_eq!(state.t, 7.1);
}

#[test]
fn inputs_are_asked_at_start_middle_and_end() {
    let (chain, mut state, mut rk4) =
        (Pendulum::<f64>::new(), Pendulum::at(0.0, 0.0), Rk4::new(0.5));
    let mut asked = Vec::new();
    rk4.step(&chain, &mut state, |t, s| {
        asked.push((t, s.t));
        0.0
    })
    .unwrap();
    assert_eq!(asked, [(0.0, 0.0), (0.25, 0.25), (0.25, 0.25), (0.5, 0.5)]);
}

#[test]
fn back_and_forth_returns() {
    let (chain, mut state, mut rk4) =
        (Pendulum::<f64>::new(), Pendulum::at(1.0, 0.0), Rk4::new(0.01));
    rk4.step(&chain, &mut state, |_, _| 0.0).unwrap();
    rk4.set_step_size(-rk4.step_size());
    rk4.step(&chain, &mut state, |_, _| 0.0).unwrap();
    assert!((state.q[0] - 1.0).abs() < 1e-12 && state.v[0].abs() < 1e-12 && state.t == 0.0);
}

#[test]
fn an_error_leaves_the_state_as_it_was() {
    let mut chain = Pendulum::<f64>::new();
    let start = Pendulum::at(0.1, 1.0);
    let mut state = start.clone();
    let mut rk4 = Rk4::new(0.1);
    let from_the_middle_on = |t: f64, _: &State<f64, 1, 1>| if t > 0.0 { f64::NAN } else { 0.0 };
    assert_eq!(
        rk4.step(&chain, &mut state, from_the_middle_on),
        Err(Error::NotFinite(Origin::Input(0)))
    );
    assert_eq!(state, start);

    chain.singular_beyond = 0.12;
    assert_eq!(rk4.step(&chain, &mut state, |_, _| 0.0), Err(Error::Singular { hinge: "pivot" }));
    assert_eq!(state, start);

    // After an error the integrator works on as if nothing had been.
    chain.singular_beyond = f64::INFINITY;
    rk4.step(&chain, &mut state, |_, _| 0.0).unwrap();
    let mut other = start.clone();
    Rk4::new(0.1).step(&chain, &mut other, |_, _| 0.0).unwrap();
    assert_eq!(state, other);
}

#[test]
fn a_result_that_is_not_finite_is_an_error() {
    let top = Top::<f64>::new();
    let mut state = Top::start();
    state.v = [1e200, 1e200, 1e200];
    let before = state.clone();
    let overflow = Rk4::new(0.1).step(&top, &mut state, |_, _| ());
    assert_eq!(overflow, Err(Error::NotFinite(Origin::Coordinate(0))));
    assert_eq!(state, before);
    let mut state = Pendulum::<f64>::at(0.0, 0.0);
    assert_eq!(
        Rk4::new(f64::NAN).step(&Pendulum::new(), &mut state, |_, _| 0.0),
        Err(Error::NotFinite(Origin::Coordinate(0)))
    );
}
