//! The adaptive method: its orders, its clock, its step control, its errors.

mod common;

use common::{
    Pendulum, State, Top, assert_order, norm_error, swing, swing_error, top_at, top_error,
};
use mstmm_runtime::description::Origin;
use mstmm_runtime::{Chain, ChainState, Dopri5, Error};

/// An integrator that takes steps of `h` whatever the error.
fn fixed<C: Chain<Scalar = f64>>(h: f64) -> Dopri5<C> {
    Dopri5::new(1e6, 1e6).with_first_step(h).with_step_limits(0.0, h)
}

/// Steps for 2 s, halved again and again.
fn steps() -> impl Iterator<Item = (f64, usize)> {
    (3..8).map(|i| (2.0 / f64::from(1 << i), 1usize << i))
}

#[test]
fn order_five_with_inputs_that_change_in_time() {
    let samples: Vec<_> = steps()
        .map(|(h, count)| {
            let (chain, mut state, mut integrator) =
                (Pendulum::new(), Pendulum::at(0.0, 1.0), fixed(h));
            for _ in 0..count {
                integrator.step(&chain, &mut state, |t, _| swing(t)).unwrap();
            }
            assert_eq!(state.t, 2.0);
            (h, swing_error(&state))
        })
        .collect();
    assert_order(5.0, &samples);
}

#[test]
fn order_five_with_quaternions() {
    let samples: Vec<_> = steps()
        .map(|(h, count)| {
            let (chain, mut state, mut integrator) = (Top::new(), Top::start(), fixed(h));
            for _ in 0..count {
                integrator.step(&chain, &mut state, |_, _| ()).unwrap();
            }
            (h, top_error(&state))
        })
        .collect();
    assert_order(5.0, &samples);
}

/// An interpolation of order four is off by h⁵ within a step.
#[test]
fn interpolation_is_of_order_four() {
    let samples: Vec<_> = steps()
        .map(|(h, _)| {
            let (chain, mut state, mut integrator) = (Top::new(), Top::start(), fixed(h));
            integrator.step(&chain, &mut state, |_, _| ()).unwrap();
            let mut between = Top::start();
            let worst = (1..16).map(|i| f64::from(i) / 16.0 * h).fold(0.0, |worst: f64, t| {
                integrator.interpolate(&chain, t, &mut between).unwrap();
                assert_eq!(between.t, t);
                worst.max(top_error(&between))
            });
            (h, worst)
        })
        .collect();
    assert_order(5.0, &samples);
}

#[test]
fn interpolation_has_unit_quaternions_and_meets_both_ends() {
    let (chain, mut state) = (Top::<f64>::new(), Top::start());
    let mut integrator = Dopri5::new(1e-8, 1e-8);
    for _ in 0..20 {
        let before = state.clone();
        integrator.step(&chain, &mut state, |_, _| ()).unwrap();
        let mut at = Top::start();
        for i in 0..=10 {
            let time = before.t + (state.t - before.t) * f64::from(i) / 10.0;
            integrator.interpolate(&chain, time.min(state.t), &mut at).unwrap();
            assert!(norm_error(&at) < 4.0 * f64::EPSILON, "{}", norm_error(&at));
        }
        for (end, time) in [(&before, before.t), (&state, state.t)] {
            integrator.interpolate(&chain, time, &mut at).unwrap();
            let near = |a: &f64, b: &f64| (a - b).abs() < 1e-15;
            assert!(at.q.iter().zip(&end.q).all(|(a, b)| near(a, b)), "{at:?} {end:?}");
            assert!(at.v.iter().zip(&end.v).all(|(a, b)| near(a, b)), "{at:?} {end:?}");
        }
    }
}

#[test]
fn interpolation_outside_the_last_step_is_refused() {
    let (chain, mut state) = (Pendulum::<f64>::new(), Pendulum::at(1.0, 0.0));
    let mut integrator = Dopri5::new(1e-8, 1e-8);
    let mut out = Pendulum::at(0.5, 0.5);
    let refused = |integrator: &Dopri5<_>, time, out: &mut State<f64, 1, 1>| {
        assert_eq!(integrator.interpolate(&chain, time, out), Err(Error::OutsideStep));
        assert_eq!(*out, Pendulum::at(0.5, 0.5));
    };
    refused(&integrator, 0.0, &mut out);
    integrator.step(&chain, &mut state, |_, _| 0.0).unwrap();
    refused(&integrator, -1e-9, &mut out);
    refused(&integrator, state.t * 1.001, &mut out);
    refused(&integrator, f64::NAN, &mut out);
    // A start that is not finite is an error of the arguments: the last step is kept.
    integrator.step(&chain, &mut Pendulum::at(f64::NAN, 0.0), |_, _| 0.0).unwrap_err();
    assert_eq!(integrator.interpolate(&chain, 0.5 * state.t, &mut out.clone()), Ok(()));
    integrator.step(&chain, &mut state, |_, _| f64::NAN).unwrap_err();
    refused(&integrator, state.t, &mut out);
}

/// The result meets the tolerance: the error at the end falls with the tolerance and stays
/// near it.
#[test]
fn the_error_follows_the_tolerance() {
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        let (chain, mut state) = (Top::new(), Top::start());
        let mut integrator = Dopri5::new(tolerance, tolerance);
        integrator.advance_to(&chain, &mut state, 10.0, |_, _| ()).unwrap();
        let error = top_error(&state);
        assert_eq!(state.t, 10.0);
        assert!(error < 30.0 * tolerance, "{tolerance:e} {error:e}");
        // One step of Newton's method squares what a step moved the length by.
        assert!(norm_error(&state) < 10.0 * tolerance * tolerance + 4.0 * f64::EPSILON);
    }
}

#[test]
fn single_precision_follows_to_its_own_accuracy() {
    let (chain, mut state) = (Top::<f32>::new(), Top::start());
    let mut integrator = Dopri5::new(1e-5, 1e-5);
    integrator.advance_to(&chain, &mut state, 4.0, |_, _| ()).unwrap();
    let (q, v) = top_at(4.0);
    let sign = if f64::from(state.q[0]) * q[0] < 0.0 { -1.0 } else { 1.0 };
    assert_eq!(state.t, 4.0);
    assert!(
        state.q.iter().zip(q).all(|(&a, b)| (sign * f64::from(a) - b).abs() < 1e-4),
        "{:?} {q:?}",
        state.q
    );
    assert!(
        state.v.iter().zip(v).all(|(&a, b)| (f64::from(a) - b).abs() < 1e-4),
        "{:?} {v:?}",
        state.v
    );
}

#[test]
fn advance_lands_exactly_forwards_and_backwards() {
    let (chain, mut state) = (Pendulum::<f64>::new(), Pendulum::at(1.0, 0.0));
    let mut integrator = Dopri5::new(1e-10, 1e-10);
    for end in [0.1, 0.1, 1.0 / 3.0, 2.7, 1.3, 0.0] {
        integrator.advance_to(&chain, &mut state, end, |_, _| 0.0).unwrap();
        assert_eq!(state.t, end);
    }
    assert!((state.q[0] - 1.0).abs() < 1e-8 && state.v[0].abs() < 1e-8, "{state:?}");
}

#[test]
fn advance_by_adds_the_duration_to_the_time() {
    let chain = Pendulum::<f64>::new();
    let start = || State { t: 0.4, ..Pendulum::at(1.0, 0.0) };
    let dopri5 = || Dopri5::new(1e-6, 1e-6);
    for duration in [0.3, -0.15, 0.0] {
        let (mut to, mut by, mut try_by) = (start(), start(), start());
        dopri5().advance_to(&chain, &mut to, 0.4 + duration, |t, _| t).unwrap();
        dopri5().advance_by(&chain, &mut by, duration, |t, _| t).unwrap();
        dopri5().try_advance_by(&chain, &mut try_by, duration, |t, _| Ok::<_, Error>(t)).unwrap();
        assert_eq!([&by, &try_by], [&to, &to]);
    }
}

/// Times of f32 are up to 62 ms apart at these starts, and durations a millisecond.
#[test]
fn durations_add_up_in_single_precision() {
    for start in [0.0_f32, 3e3, 2e4, 4e4, 1e6] {
        let (chain, mut state) = (Pendulum::<f32>::new(), Pendulum::at(0.0, 0.0));
        state.t = start;
        let mut integrator = Dopri5::new(1e-3, 1e-3);
        for _ in 0..1000 {
            integrator.advance_by(&chain, &mut state, 1e-3, |_, _| 0.0).unwrap();
        }
        let end = start + 1.0;
        assert!((state.t - end).abs() <= end.next_up() - end, "{start}: {}", state.t);
    }
}

/// Output at short intervals must not slow the control down: the step it goes on with is the one it
/// had found.
#[test]
fn short_intervals_do_not_shorten_the_step() {
    let (chain, mut state) = (Top::<f64>::new(), Top::start());
    let mut integrator = Dopri5::new(1e-9, 1e-9);
    integrator.advance_to(&chain, &mut state, 2.0, |_, _| ()).unwrap();
    let found = integrator.next_step();
    integrator.advance_to(&chain, &mut state, 2.0 + 1e-6, |_, _| ()).unwrap();
    assert!(integrator.next_step() >= found);
}

#[test]
fn evaluations_are_counted_and_reused_within_advance() {
    let (chain, mut state) = (Top::<f64>::new(), Top::start());
    let mut integrator = Dopri5::new(1e-9, 1e-9).with_first_step(0.5);
    integrator.advance_to(&chain, &mut state, 3.0, |_, _| ()).unwrap();
    let work = integrator.statistics();
    assert!(work.rejected > 0 && work.accepted > 10);
    assert_eq!(work.evaluations, 1 + 6 * (work.accepted + work.rejected));
    integrator.step(&chain, &mut state, |_, _| ()).unwrap();
    let more = integrator.statistics();
    let tries = more.accepted + more.rejected - work.accepted - work.rejected;
    assert_eq!(more.evaluations, work.evaluations + 1 + 6 * tries);
}

/// Reuse inside `advance_to` changes no bit: the same steps one by one give the same states.
#[test]
fn advance_is_step_by_step() {
    let (chain, mut together, mut single) = (Top::<f64>::new(), Top::start(), Top::start());
    let mut integrator = Dopri5::new(1e-8, 1e-8);
    let mut times = Vec::new();
    integrator.advance_to(&chain, &mut together, 5.0, |t, _| times.push(t)).unwrap();
    let mut other = Dopri5::new(1e-8, 1e-8);
    while single.t + 2.0 * other.next_step() < 5.0 {
        other.step(&chain, &mut single, |_, _| ()).unwrap();
    }
    other.advance_to(&chain, &mut single, 5.0, |_, _| ()).unwrap();
    assert_eq!(single, together);
    assert_eq!(integrator.statistics().accepted, other.statistics().accepted);
}

/// A motor switched between two steps acts from the first instant of the second one.
#[test]
fn inputs_may_change_between_steps() {
    let (chain, mut state) = (Pendulum::<f64>::new(), Pendulum::at(0.3, 0.0));
    let mut integrator = Dopri5::new(1e-8, 1e-8).with_first_step(0.01);
    integrator.step(&chain, &mut state, |_, _| 0.0).unwrap();
    let mut fresh = Dopri5::new(1e-8, 1e-8).with_first_step(integrator.next_step());
    let mut expected = state.clone();
    integrator.step(&chain, &mut state, |_, _| 5.0).unwrap();
    fresh.step(&chain, &mut expected, |_, _| 5.0).unwrap();
    assert_eq!(state, expected);
}

#[test]
fn steps_stay_within_the_limits() {
    let (chain, mut state) = (Top::<f64>::new(), Top::start());
    let mut integrator = Dopri5::new(1e-3, 1e-3).with_step_limits(0.0, 0.05);
    for _ in 0..50 {
        let before = state.t;
        integrator.step(&chain, &mut state, |_, _| ()).unwrap();
        assert!(state.t - before <= 0.05 + 1e-15);
    }
    let mut integrator = Dopri5::new(1e-13, 1e-13).with_step_limits(0.1, 1.0);
    let before = state.clone();
    assert_eq!(integrator.step(&chain, &mut state, |_, _| ()), Err(Error::StepTooSmall));
    assert_eq!(state, before);
}

/// θ̈ = 6 θ² with θ = (1 − t)⁻² leaves every bound at t = 1.
struct Runaway;

impl Chain for Runaway {
    type Scalar = f64;
    type State = State<f64, 1, 1>;
    type Inputs = ();

    fn derivative_into(
        &self,
        state: &Self::State,
        (): &(),
        rate: &mut Self::State,
    ) -> Result<(), Error> {
        (rate.q, rate.v) = (state.v, [6.0 * state.q[0] * state.q[0]]);
        Ok(())
    }

    fn configuration_rate_into(&self, state: &Self::State, rate: &mut Self::State) {
        rate.q = state.v;
    }

    fn normalize(&self, _state: &mut Self::State) {}
}

#[test]
fn a_motion_that_ends_is_followed_to_its_end() {
    let mut state = State { q: [1.0], v: [2.0], t: 0.0 };
    let mut integrator = Dopri5::new(1e-6, 1e-6);
    assert_eq!(
        integrator.advance_to(&Runaway, &mut state, 2.0, |_, _| ()),
        Err(Error::StepTooSmall)
    );
    assert!((state.t - 1.0).abs() < 1e-3 && state.q[0].is_finite(), "{state:?}");
}

#[test]
fn stages_that_are_not_finite_shorten_the_step() {
    let (chain, mut state) = (Pendulum::<f64>::new(), Pendulum::at(0.1, 0.0));
    let broken_from_one_on = |t: f64, _: &State<f64, 1, 1>| if t > 1.0 { f64::NAN } else { 0.0 };
    let mut integrator = Dopri5::new(1e-6, 1e-6);
    let end = integrator.advance_to(&chain, &mut state, 2.0, broken_from_one_on);
    assert_eq!(end, Err(Error::StepTooSmall));
    assert!(state.t <= 1.0 && state.t > 1.0 - 1e-12, "{}", state.t);
    // At once at the start it is the user's error, not the step's.
    state.v[0] = f64::NAN;
    assert_eq!(
        integrator.step(&chain, &mut state, |_, _| 0.0),
        Err(Error::NotFinite(Origin::Rate(0)))
    );
    let mut state = Pendulum::at(0.1, 0.0);
    state.t = f64::INFINITY;
    assert_eq!(
        integrator.step(&chain, &mut state, |_, _| 0.0),
        Err(Error::NotFinite(Origin::Time))
    );
    assert_eq!(
        integrator.advance_to(&chain, &mut state, f64::NAN, |_, _| 0.0),
        Err(Error::NotFinite(Origin::End))
    );
}

#[test]
fn a_singular_pose_ahead_is_named() {
    let chain = Pendulum { singular_beyond: 0.5 };
    let mut state = Pendulum::<f64>::at(0.0, 1.0);
    let mut integrator = Dopri5::new(1e-6, 1e-6);
    let end = integrator.advance_to(&chain, &mut state, 2.0, |_, _| 0.0);
    assert_eq!(end, Err(Error::Singular { hinge: "pivot" }));
    assert!(state.q[0] <= 0.5 && state.q[0] > 0.49, "{state:?}");
}

#[test]
fn tolerances_must_be_usable() {
    let chain = Pendulum::<f64>::new();
    for (relative, absolute) in [(0.0, 0.0), (-1e-6, 1e-3), (1e-6, f64::NAN)] {
        let mut state = Pendulum::at(0.1, 0.0);
        let refused = Dopri5::new(relative, absolute).step(&chain, &mut state, |_, _| 0.0);
        assert!(matches!(refused, Err(Error::InvalidParameter { name: "tolerance", .. })));
    }
    let mut state = Pendulum::at(0.1, 0.0);
    Dopri5::new(0.0, 1e-6).step(&chain, &mut state, |_, _| 0.0).unwrap();
    for (minimum, maximum) in [(0.1, 0.01), (f64::NAN, 1.0), (0.0, f64::NAN), (0.0, 0.0)] {
        let mut integrator = Dopri5::new(1e-6, 1e-6).with_step_limits(minimum, maximum);
        let refused = integrator.step(&chain, &mut state, |_, _| 0.0);
        assert!(matches!(refused, Err(Error::InvalidParameter { name: "step limits", .. })));
    }
}

/// A pendulum at 1e28 rad/s needs steps of 1e-29 s, which are never done with a second.
#[test]
fn a_run_away_state_ends_in_an_error() {
    for start in [0.0, 1.0] {
        let (chain, mut state) = (Pendulum::<f64>::new(), Pendulum::at(0.1, 1e28));
        state.t = start;
        let mut integrator = Dopri5::new(1e-6, 1e-6);
        let refused = integrator.advance_by(&chain, &mut state, 1.0, |_, _| 0.0);
        assert_eq!(refused, Err(Error::StepTooSmall));
    }
}

/// The error of a state that stays zero is zero, which meets a relative tolerance too.
#[test]
fn at_rest_steps_grow() {
    for absolute in [1e-6, 1e-310, 0.0] {
        let (chain, mut state) = (Pendulum::<f64>::new(), Pendulum::at(0.0, 0.0));
        let mut integrator = Dopri5::new(1e-6, absolute);
        integrator.advance_to(&chain, &mut state, 1e6, |_, _| 0.0).unwrap();
        assert!(integrator.statistics().accepted < 50, "{:?}", integrator.statistics());
        assert_eq!(state.time(), 1e6);
    }
}

/// Torques −c θ̇ with c = 10⁴ /s leave a slow motion that any step follows, so stability limits the step to 3.3/c.
#[test]
fn strong_damping_is_reported_as_stiff() {
    let (chain, mut state) = (Pendulum::<f64>::new(), Pendulum::at(1.0, 0.0));
    let mut integrator = Dopri5::new(1e-6, 1e-6);
    integrator.advance_to(&chain, &mut state, 0.1, |_, state| -1e4 * state.v[0]).unwrap();
    assert!(integrator.is_stiff() && integrator.clone().is_stiff());
    assert!(integrator.statistics().accepted > 250);
    // Without damping the steps are free of the limit, and the report ends.
    integrator.advance_to(&chain, &mut state, 5.0, |_, _| 0.0).unwrap();
    assert!(!integrator.is_stiff());
}

#[test]
fn smooth_motions_are_not_stiff() {
    for tolerance in [1e-3, 1e-6, 1e-9, 1e-12] {
        let (chain, mut state) = (Pendulum::<f64>::new(), Pendulum::at(0.0, 1.0));
        let mut integrator = Dopri5::new(tolerance, tolerance);
        let (top, mut spinning) = (Top::<f64>::new(), Top::start());
        let mut other = Dopri5::new(tolerance, tolerance);
        for _ in 0..60 {
            integrator.step(&chain, &mut state, |t, _| swing(t)).unwrap();
            other.step(&top, &mut spinning, |_, _| ()).unwrap();
            assert!(!integrator.is_stiff() && !other.is_stiff(), "{tolerance}");
        }
    }
}
