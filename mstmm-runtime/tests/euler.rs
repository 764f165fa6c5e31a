//! Both methods of Euler: their formulas, their orders, what they do to energy, and how stiff a
//! spring may be.

mod common;

use common::{
    Pendulum, Spring, State, Top, assert_order, distance, spring_error, swing, swing_error,
    top_error,
};
use mstmm_runtime::{Error, LinearlyImplicitEuler, Rk4, SemiImplicitEuler};

/// Steps for 2 s, halved again and again.
fn steps() -> impl Iterator<Item = f64> {
    (4..10).map(|i| 2.0 / f64::from(1 << i))
}

/// The pendulum in space after 2 s, to about 1e-13.
fn hanging_after_two_seconds() -> State<f64, 4, 3> {
    let mut state = Top::start();
    Rk4::new(1.0 / 2048.0).advance_to(&Top::hanging(), &mut state, 2.0, |_, _| ()).unwrap();
    state
}

macro_rules! order_one {
    ($($test:ident: $method:ident;)*) => {
        $(#[test]
        fn $test() {
            let on_a_spring = steps().map(|h| {
                let mut state = Spring::at(1.0, 0.0);
                let spring = Spring::new(1.0, 0.0);
                $method::new(h).advance_to(&spring, &mut state, 2.0, |_, _| 0.0).unwrap();
                (h, spring_error(&state))
            });
            assert_order(1.0, &on_a_spring.collect::<Vec<_>>());

            let with_inputs = steps().map(|h| {
                let mut state = Pendulum::at(0.0, 1.0);
                let driven = |t: f64, _: &State<f64, 1, 1>| swing(t);
                $method::new(h).advance_to(&Pendulum::new(), &mut state, 2.0, driven).unwrap();
                (h, swing_error(&state))
            });
            assert_order(1.0, &with_inputs.collect::<Vec<_>>());

            let with_a_quaternion = steps().map(|h| {
                let mut state = Top::start();
                $method::new(h).advance_to(&Top::new(), &mut state, 2.0, |_, _| ()).unwrap();
                (h, top_error(&state))
            });
            assert_order(1.0, &with_a_quaternion.collect::<Vec<_>>());

            let truth = hanging_after_two_seconds();
            let in_space = steps().map(|h| {
                let mut state = Top::start();
                $method::new(h).advance_to(&Top::hanging(), &mut state, 2.0, |_, _| ()).unwrap();
                (h, distance(&state, truth.q, truth.v))
            });
            assert_order(1.0, &in_space.collect::<Vec<_>>());
        })*
    };
}

order_one! {
    semi_implicit_is_of_order_one: SemiImplicitEuler;
    linearly_implicit_is_of_order_one: LinearlyImplicitEuler;
}

#[test]
fn semi_implicit_uses_the_new_rates() {
    let mut state = Pendulum::<f64>::at(0.4, 2.0);
    SemiImplicitEuler::new(0.5).step(&Pendulum::new(), &mut state, |_, _| 3.0).unwrap();
    let ([sine], _) = <f64 as mstmm_runtime::Scalar>::sin_cos([0.4]);
    let v = 2.0 + 0.5 * (3.0 - sine);
    assert_eq!(state, State { q: [0.4 + 0.5 * v], v: [v], t: 0.5 });
}

/// On a linear spring it is the implicit method of Euler: v₁ = v₀ + h (u − k x₁ − c v₁), x₁ = x₀ + h
/// v₁.
#[test]
fn linearly_implicit_is_implicit_on_a_spring() {
    let (k, c, h) = (70.0, 5.0, 0.3);
    let mut state = Spring::at(0.4, 2.0);
    let spring = Spring::new(k, c);
    LinearlyImplicitEuler::new(h).step(&spring, &mut state, |_, _| 3.0).unwrap();
    let ([x], [v]) = (state.q, state.v);
    assert!((v - (2.0 + h * (3.0 - k * x - c * v))).abs() < 1e-14);
    assert!((x - (0.4 + h * v)).abs() < 1e-15);
}

/// Where nothing is stiff, both are the same.
#[test]
fn linearly_implicit_without_springs_is_semi_implicit() {
    let (chain, mut one, mut other) = (Top::<f64>::hanging(), Top::start(), Top::start());
    SemiImplicitEuler::new(0.01).advance_to(&chain, &mut one, 1.0, |_, _| ()).unwrap();
    LinearlyImplicitEuler::new(0.01).advance_to(&chain, &mut other, 1.0, |_, _| ()).unwrap();
    assert_eq!(one, other);
}

/// The semi-implicit method keeps x² + v² − h x v exactly, so x² + v² stays between 1/(1 + h/2)
/// and 1/(1 − h/2) of its start, however long.
#[test]
fn semi_implicit_energy_swings_and_does_not_drift() {
    for h in [0.01, 0.1, 0.5, 1.0, 1.9] {
        let (chain, mut state) = (Spring::<f64>::new(1.0, 0.0), Spring::at(1.0, 0.0));
        let mut method = SemiImplicitEuler::new(h);
        let (mut least, mut most) = (1.0f64, 1.0f64);
        for _ in 0..100_000 {
            method.step(&chain, &mut state, |_, _| 0.0).unwrap();
            let ([x], [v]) = (state.q, state.v);
            assert!((x * x + v * v - h * x * v - 1.0).abs() < 1e-9);
            (least, most) = (least.min(x * x + v * v), most.max(x * x + v * v));
        }
        assert!(least > 1.0 / (1.0 + h / 2.0) - 1e-9 && most < 1.0 / (1.0 - h / 2.0) + 1e-9);
    }
    // A pendulum likewise: from 1 rad its energy swings by a few hundredths of h, and is back.
    let (chain, mut state) = (Pendulum::<f64>::new(), Pendulum::at(1.0, 0.0));
    let energy = |s: &State<f64, 1, 1>| 0.5 * s.v[0] * s.v[0] + 1.0 - s.q[0].cos();
    let (start, mut method) = (energy(&state), SemiImplicitEuler::new(0.05));
    for _ in 0..200_000 {
        method.step(&chain, &mut state, |_, _| 0.0).unwrap();
        assert!((energy(&state) / start - 1.0).abs() < 0.05);
    }
}

/// What depends on rates is taken as it was at the start: the transverse rates of a spinning top,
/// which turn at Ω, grow by √(1 + (hΩ)²) a step.
#[test]
fn spinning_gains_energy() {
    let (h, count) = (0.01, 1000);
    let (chain, mut state) = (Top::<f64>::new(), Top::start());
    let transverse = |s: &State<f64, 4, 3>| s.v[0] * s.v[0] + s.v[1] * s.v[1];
    let (start, spin) = (transverse(&state), (chain.axial - 1.0) * state.v[2]);
    let mut method = SemiImplicitEuler::new(h);
    for _ in 0..count {
        method.step(&chain, &mut state, |_, _| ()).unwrap();
    }
    let expected = (1.0 + (h * spin) * (h * spin)).powi(count);
    assert!((transverse(&state) / start / expected - 1.0).abs() < 1e-12);
}

/// An undamped spring of any stiffness comes to rest; explicit methods leave every bound.
#[test]
fn stiff_springs_do_not_limit_the_step() {
    let h = 0.1;
    for (stiffness, damping) in [(1e4, 0.0), (1e8, 0.0), (1e12, 1e3), (0.0, 1e9)] {
        let (chain, start) = (Spring::<f64>::new(stiffness, damping), Spring::at(1.0, 1.0));
        let (mut state, mut method) = (start.clone(), LinearlyImplicitEuler::new(h));
        let mut before = f64::INFINITY;
        for _ in 0..200 {
            method.step(&chain, &mut state, |_, _| 0.0).unwrap();
            let energy = stiffness * state.q[0].powi(2) + state.v[0].powi(2);
            assert!(energy <= before);
            before = energy;
        }
        assert!(state.v[0].abs() < 1e-12, "{state:?}");

        let (mut state, mut rk4) = (start.clone(), Rk4::new(h));
        let end = rk4.advance_to(&chain, &mut state, 20.0, |_, _| 0.0);
        assert!(
            matches!(end, Err(Error::NotFinite(_))) || state.v[0].abs() > 1e50,
            "{end:?} {state:?}"
        );
        let (mut state, mut euler) = (start.clone(), SemiImplicitEuler::new(h));
        let end = euler.advance_to(&chain, &mut state, 20.0, |_, _| 0.0);
        assert!(
            matches!(end, Err(Error::NotFinite(_))) || state.v[0].abs() > 1e50,
            "{end:?} {state:?}"
        );
    }
}

/// What is slower than the step is followed past what is faster: a mass on a soft spring, pulled by
/// a constant force, comes to rest where it should, and energy falls by 1/(1 + (hω)²) a step.
#[test]
fn linearly_implicit_damps_and_comes_to_rest_where_it_should() {
    let (h, k, u) = (0.05, 4.0, 3.0);
    let (chain, mut state) = (Spring::<f64>::new(k, 0.0), Spring::at(0.0, 0.0));
    let mut method = LinearlyImplicitEuler::new(h);
    let energy = |s: &State<f64, 1, 1>| k * (s.q[0] - u / k).powi(2) + s.v[0].powi(2);
    for _ in 0..4000 {
        let before = energy(&state);
        method.step(&chain, &mut state, |_, _| u).unwrap();
        let factor = 1.0 + h * h * k;
        assert!((energy(&state) * factor - before).abs() < 1e-14);
    }
    assert!((state.q[0] - u / k).abs() < 1e-7 && state.v[0].abs() < 1e-7, "{state:?}");
}

#[test]
fn inputs_are_asked_once_at_the_start() {
    let (chain, mut state) = (Pendulum::<f64>::new(), Pendulum::at(0.0, 0.0));
    state.t = 2.0;
    let mut asked = Vec::new();
    let mut ask = |t: f64, s: &State<f64, 1, 1>| {
        asked.push((t, s.t));
        0.0
    };
    SemiImplicitEuler::new(0.5).step(&chain, &mut state, &mut ask).unwrap();
    LinearlyImplicitEuler::new(0.5).step(&chain, &mut state, &mut ask).unwrap();
    assert_eq!(asked, [(2.0, 2.0), (2.5, 2.5)]);
}
