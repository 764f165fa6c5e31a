//! What all methods with a fixed step have in common: the clock, the way to an end time, errors.

mod common;

use common::{Pendulum, Spring, State, Top, norm_error};
use mstmm_runtime::description::Origin;
use mstmm_runtime::{Error, LinearlyImplicitEuler, Newmark, Rk4, SemiImplicitEuler};

macro_rules! common_tests {
    ($($module:ident: $method:ident, $evaluations:expr;)*) => {
        $(mod $module {
            use super::*;

            #[test]
            fn advance_lands_exactly_forwards_and_backwards() {
                let chain = Pendulum::<f64>::new();
                for h in [0.03, -0.03, 100.0] {
                    let (mut state, mut method) = (Pendulum::at(1.0, 0.0), $method::new(h));
                    for end in [0.1, 0.1, 1.0 / 3.0, 2.7, 1.3, 0.0, -1.1] {
                        method.advance_to(&chain, &mut state, end, |_, _| 0.0).unwrap();
                        assert_eq!(state.t, end);
                    }
                }
            }

            #[test]
            fn advance_by_adds_the_duration_to_the_time() {
                let chain = Pendulum::<f64>::new();
                let start = || State { t: 0.4, ..Pendulum::at(1.0, 0.0) };
                for duration in [0.3, -0.15, 0.0] {
                    let (mut to, mut by, mut try_by) = (start(), start(), start());
                    let end = 0.4 + duration;
                    $method::new(0.01).advance_to(&chain, &mut to, end, |t, _| t).unwrap();
                    $method::new(0.01).advance_by(&chain, &mut by, duration, |t, _| t).unwrap();
                    let torque = |t, _: &_| Ok::<_, Error>(t);
                    $method::new(0.01).try_advance_by(&chain, &mut try_by, duration, torque).unwrap();
                    assert_eq!((&by, by.t), (&try_by, to.t));
                    // The time 0.4 + duration is rounded.
                    assert!((by.q[0] - to.q[0]).abs() + (by.v[0] - to.v[0]).abs() < 1e-15);
                }
            }

            /// Whole steps, and no sliver where rounding would leave one.
            #[test]
            fn advance_makes_whole_steps_and_a_remainder() {
                let steps = |start: f64, h: f64, end: f64| {
                    let (mut state, mut method) = (Pendulum::at(1.0, 0.0), $method::new(h));
                    state.t = start;
                    let mut asked = 0;
                    method.advance_to(&Pendulum::new(), &mut state, end, |_, _| {
                        asked += 1;
                        0.0
                    })
                    .unwrap();
                    let whole = asked / $evaluations;
                    assert_eq!(asked, whole * $evaluations);
                    whole
                };
                assert_eq!(steps(0.0, 0.1, 1.0), 10);
                assert_eq!(steps(0.0, 0.1, 1.01), 11);
                assert_eq!(steps(0.0, 0.1, 0.99), 10);
                assert_eq!(steps(0.0, 1.0 / 3.0, 1.0), 3);
                assert_eq!(steps(1000.0, 0.7, 1007.0), 10);
                assert_eq!(steps(1000.0, 1e-4, 1001.0), 10_000);
                assert_eq!(steps(0.0, 1e-3, 100.0), 100_000);
                assert_eq!(steps(5.0, 0.1, 4.0), 10);
            }

            #[test]
            fn advance_is_step_by_step() {
                let (chain, mut together) = (Top::<f64>::hanging(), Top::start());
                $method::new(0.01).advance_to(&chain, &mut together, 0.255, |_, _| ()).unwrap();
                let (mut single, mut method) = (Top::start(), $method::new(0.01));
                for _ in 0..25 {
                    method.step(&chain, &mut single, |_, _| ()).unwrap();
                }
                assert!((single.t - 0.25).abs() < 1e-16);
                method.advance_to(&chain, &mut single, 0.255, |_, _| ()).unwrap();
                assert_eq!(single, together);
            }

            #[test]
            fn advance_in_single_precision_keeps_the_time() {
                let (chain, mut state) = (Pendulum::<f32>::new(), Pendulum::at(0.0, 0.0));
                let mut asked = 0;
                let mut method = $method::new(1e-3f32);
                method
                    .advance_to(&chain, &mut state, 100.0, |_, _| {
                        asked += 1;
                        0.0
                    })
                    .unwrap();
                assert_eq!((state.t, asked), (100.0, 100_000 * $evaluations));
            }

            #[test]
            fn advance_refuses_endless_intervals() {
                let chain = Pendulum::<f64>::new();
                let start = Pendulum::at(1.0, 0.0);
                let refused = |h: f64, end: f64| {
                    let (mut state, mut method) = (start.clone(), $method::new(h));
                    let refused = method.advance_to(&chain, &mut state, end, |_, _| 0.0);
                    assert_eq!(state, start);
                    refused.unwrap_err()
                };
                assert_eq!(refused(0.1, f64::NAN), Error::NotFinite(Origin::End));
                assert_eq!(refused(0.1, f64::INFINITY), Error::NotFinite(Origin::End));
                assert!(matches!(refused(f64::NAN, 1.0), Error::NotFinite(_)));
                let too_small = Error::InvalidParameter { name: "step", reason: "must move the clock" };
                assert_eq!(refused(0.0, 1.0), too_small);
                let (mut late, mut method) = (start.clone(), $method::new(1e-10));
                late.t = 1e9;
                let refused = method.advance_to(&chain, &mut late, 2e9, |_, _| 0.0);
                assert_eq!(refused, Err(too_small));
                // Steps below the spacing of times add up to the next one.
                let (end, mut asked) = (1e9_f64.next_up(), 0);
                method.advance_to(&chain, &mut late, end, |_, _| { asked += 1; 0.0 }).unwrap();
                assert_eq!((late.t, asked), (end, 1192 * $evaluations));
                let mut never = State { t: f64::NAN, ..start.clone() };
                let refused = $method::new(0.1).advance_to(&chain, &mut never, 1.0, |_, _| 0.0);
                assert_eq!(refused, Err(Error::NotFinite(Origin::Time)));
            }

            #[test]
            fn an_error_keeps_the_completed_steps() {
                let chain = Pendulum::<f64>::new();
                let (mut state, mut method) = (Pendulum::at(0.0, 1.0), $method::new(0.125));
                let broken = |t: f64, _: &State<f64, 1, 1>| if t > 0.6 { f64::NAN } else { 0.0 };
                let end = method.advance_to(&chain, &mut state, 2.0, broken);
                assert_eq!(end, Err(Error::NotFinite(Origin::Input(0))));
                assert!(state.t == 0.5 || state.t == 0.625, "{}", state.t);
                assert!(state.q[0].is_finite() && state.v[0].is_finite());
            }

            #[test]
            fn an_error_leaves_the_state_as_it_was() {
                let mut chain = Pendulum::<f64>::new();
                let start = Pendulum::at(0.2, 1.0);
                let (mut state, mut method) = (start.clone(), $method::new(0.1));
                let broken = method.step(&chain, &mut state, |_, _| f64::NAN);
                assert_eq!((broken, &state), (Err(Error::NotFinite(Origin::Input(0))), &start));
                chain.singular_beyond = 0.1;
                let broken = method.step(&chain, &mut state, |_, _| 0.0);
                assert_eq!((broken, &state), (Err(Error::Singular { hinge: "pivot" }), &start));
                // After an error it works on as if nothing had been.
                chain.singular_beyond = f64::INFINITY;
                method.step(&chain, &mut state, |_, _| 0.0).unwrap();
                let mut other = start.clone();
                $method::new(0.1).step(&chain, &mut other, |_, _| 0.0).unwrap();
                assert_eq!(state, other);

                let (top, mut fast) = (Top::<f64>::new(), Top::start());
                fast.v = [1e200; 3];
                let before = fast.clone();
                let broken = $method::new(0.1).step(&top, &mut fast, |_, _| ());
                let Err(Error::NotFinite(origin)) = broken else { panic!("{broken:?}") };
                // The methods compute rates or coordinates first.
                assert!(matches!(origin, Origin::Coordinate(_) | Origin::Rate(_)), "{origin}");
                assert_eq!(fast, before);
            }

            #[test]
            fn the_clock_loses_nothing() {
                let (chain, mut state) = (Spring::<f64>::new(1.0, 0.0), Spring::at(0.0, 0.0));
                let mut method = $method::new(1e-3);
                for steps in 1..=20_000 {
                    method.step(&chain, &mut state, |_, _| 0.0).unwrap();
                    let exact = f64::from(steps) * 1e-3;
                    assert!((state.t - exact).abs() <= exact * f64::EPSILON, "{}", state.t);
                }
                state.t = 7.0;
                method.set_step_size(-0.5);
                method.step(&chain, &mut state, |_, _| 0.0).unwrap();
                assert_eq!((state.t, method.step_size()), (6.5, -0.5));
            }

            /// A controller of a kilohertz, hours after the start: times are further apart than its period.
            #[test]
            fn durations_add_up_in_single_precision() {
                for start in [0.0, 3e3, 1e4, 2e4, 4e4, 1e6] {
                    let (chain, mut state) = (Pendulum::<f32>::new(), Pendulum::at(0.0, 0.0));
                    let mut method = $method::new(1e-3f32);
                    (state.t, state.v[0]) = (start, 0.0);
                    let mut asked = 0;
                    for _ in 0..1000 {
                        let count = |_: f32, _: &State<f32, 1, 1>| { asked += 1; 0.0 };
                        method.advance_by(&chain, &mut state, 1e-3, count).unwrap();
                    }
                    assert_eq!(asked, 1000 * $evaluations);
                    // Half of the spacing of times.
                    let spacing = (start + 1.0).next_up() - (start + 1.0);
                    assert!((state.t - (start + 1.0)).abs() <= spacing, "{start}: {}", state.t);
                }
            }

            #[test]
            fn quaternions_stay_of_unit_length() {
                let (chain, mut state) = (Top::<f64>::hanging(), Top::start());
                let mut method = $method::new(0.01);
                for _ in 0..1000 {
                    method.step(&chain, &mut state, |_, _| ()).unwrap();
                    // One step of Newton's method leaves ⅜ of the square of (½ h ω)².
                    assert!(norm_error(&state) < 0.375 * (0.005f64 * 4.0).powi(4));
                }
            }

            #[test]
            fn copies_go_on_alike() {
                let (chain, mut state) = (Top::<f64>::hanging(), Top::start());
                let mut method = $method::new(0.1);
                method.step(&chain, &mut state, |_, _| ()).unwrap();
                let (mut other, mut copy) = (state.clone(), method.clone());
                method.step(&chain, &mut state, |_, _| ()).unwrap();
                copy.step(&chain, &mut other, |_, _| ()).unwrap();
                assert_eq!(state, other);
                let told = format!("{method:?}");
                assert!(told.starts_with(concat!(stringify!($method), " { step_size: 0.1")));
            }
        })*
    };
}

common_tests! {
    rk4: Rk4, 4;
    newmark: Newmark, 4;
    semi_implicit_euler: SemiImplicitEuler, 1;
    linearly_implicit_euler: LinearlyImplicitEuler, 1;
}
