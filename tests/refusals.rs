//! Calls that fail report the reason, return no results and change nothing: invalid parameters, singular
//! mechanisms, numbers that are not finite.

mod support;

use mstmm::Error;
use mstmm::description::Origin;
use mstmm::prelude::*;
use mstmm_reference::Random;
use support::difference;
use support::mechanism::{Mechanism, both, mechanisms};

mstmm_chain! {
    chain Loaded {
        gravity = [0, -9.8, 0] m/s^2;
        param payload = 0.5 kg;
        param length = 1 m;
        body Link {
            mass = 2 kg;
            com = [0.5, 0, 0.1] m;
            output = [length, 0, 0];
            inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com;
        }
        body Hand {
            mass = 1 kg + payload;
            com = [0.2, 0.1, 0] m;
            inertia = diag(0.05, 0.04, 0.03) kg*m^2 about com;
        }
        ground -> ball shoulder -> Link link -> pin(y) wrist -> Hand hand;
        hinge wrist { torque = input; }
    }

    /// The same with numbers in place of the parameters: 0.7 kg and 1.2 m.
    chain Fixed {
        gravity = [0, -9.8, 0] m/s^2;
        body Link {
            mass = 2 kg;
            com = [0.5, 0, 0.1] m;
            output = [1.2, 0, 0] m;
            inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com;
        }
        body Hand {
            mass = 1.7 kg;
            com = [0.2, 0.1, 0] m;
            inertia = diag(0.05, 0.04, 0.03) kg*m^2 about com;
        }
        ground -> ball shoulder -> Link link -> pin(y) wrist -> Hand hand;
        hinge wrist { torque = input; }
    }
}

mechanisms! {
    Loaded [Ball, Pin];
    Fixed [Ball, Pin];
}

#[test]
fn a_parameter_counts_like_the_number_written() -> Result<(), Error> {
    let mut loaded = Loaded::<f64>::new();
    assert_eq!((loaded.parameters().payload(), loaded.parameters().length()), (0.5, 1.0));
    loaded.set_payload(0.7)?;
    loaded.set_length(1.2)?;
    assert_eq!((loaded.parameters().payload(), loaded.parameters().length()), (0.7, 1.2));
    let fixed = Fixed::<f64>::new();
    for seed in 0..20 {
        let mut random = Random::new(seed);
        let state = loaded.random_state(&mut random);
        let mut same = fixed.initial_state();
        same.q.copy_from(&state.q);
        same.v.copy_from(&state.v);
        let torque = random.between(-5.0, 5.0);
        let with_parameters = loaded.answer(&state, &LoadedInputs { wrist: torque })?;
        let with_numbers = fixed.answer(&same, &FixedInputs { wrist: torque })?;
        let off = difference(&with_parameters.accelerations, &with_numbers.accelerations);
        // 1 + 0.7 may round otherwise than 1.7, and constants fold in another order.
        assert!(off < 1e-12, "seed {seed}: {off:e}");
        let energies = [&with_parameters, &with_numbers].map(|answer| answer.energy.total());
        assert!(difference(&energies[..1], &energies[1..]) < 1e-13, "seed {seed}");
    }
    Ok(())
}

#[test]
fn a_refused_parameter_leaves_the_old_one() {
    let mut chain = Loaded::<f64>::new();
    chain.set_payload(0.25).expect("a good number");
    let before = chain.clone();
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, -1.5] {
        let refused = chain.set_payload(bad);
        let Err(Error::InvalidParameter { name, reason }) = refused else {
            panic!("{bad}: {refused:?}")
        };
        assert_eq!(name, "payload");
        assert!(reason.contains(if bad.is_finite() { "hand" } else { "finite" }), "{reason}");
        assert_eq!(chain, before, "{bad}");
    }
    assert!(matches!(
        chain.set_length(f64::NAN),
        Err(Error::InvalidParameter { name: "length", .. })
    ));
    assert_eq!(chain, before);
    // A mass that is small but there, and a length of any sign, are physical.
    chain.set_payload(-0.999).expect("a mass of a gram");
    chain.set_length(-3.0).expect("a length on the other side");
}

/// A rod along x and a link on a route. Without thickness nothing of the rod resists a turn about
/// x.
macro_rules! with_a_thin_rod {
    ($riccati:ident $transfer:ident $hinges:tt { $($route:tt)* }) => {
        both! { $riccati $transfer $hinges {
            gravity = [0, -9.8, 0] m/s^2;
            param thickness = 0.01;
            body Link {
                mass = 2 kg;
                com = [0.5, 0.1, -0.2] m;
                output = [1, 0.3, 0] m turned rpy(10, 70, -20) deg;
                inertia = tensor(0.3, 0.5, 0.6, 0.1, -0.04, 0.02) kg*m^2 about com;
            }
            body Rod {
                mass = 1 kg;
                com = [0.5, 0, 0] m;
                output = [1, 0, 0] m;
                inertia = diag(thickness, 1/12, 1/12) kg*m^2 about com;
            }
            $($route)*
        } }
    };
}

with_a_thin_rod! { Tip TipByTransfer [Pin, Ball] {
    ground -> pin(z) arm -> Link link -> ball loose -> Rod rod;
} }

with_a_thin_rod! { Balls BallsByTransfer [Ball, Ball] {
    ground -> ball shoulder -> Link link -> ball loose -> Rod rod;
} }

with_a_thin_rod! { Deep DeepByTransfer [Pin, Ball, Ball] {
    ground -> pin(y) arm -> Link link -> ball loose -> Rod rod -> ball wrist -> Link hand;
} }

with_a_thin_rod! { Axle AxleByTransfer [Pin, Ball] {
    ground -> pin(x) loose -> Rod rod -> ball wrist -> Link hand;
} }

/// A thickness that is lost in rounding; by one of zero something would be divided when it is set.
const THIN: f64 = 1e-22;

/// Solves in many states; each must be refused with the loose hinge's name, and say nothing else.
macro_rules! is_loose {
    ($($name:ident)*) => { $(
        let (mut chain, mut single) = ($name::<f64>::new(), $name::<f32>::new());
        chain.set_thickness(THIN).expect("a thin rod");
        single.set_thickness(THIN as f32).expect("a thin rod");
        for seed in 0..200 {
            let state = chain.random_state(&mut Random::new(seed));
            let expected = Err(Error::Singular { hinge: "loose" });
            let mut at = chain.workspace();
            let empty = at.clone();
            let found = chain.solve_into(&state, &chain.no_inputs(), &mut at);
            assert_eq!(found, expected, "{}, seed {seed}", stringify!($name));
            assert_eq!(at, empty);
            let mut accelerations = *at.accelerations();
            accelerations.fill(7.0);
            let untouched = accelerations;
            let found = chain.accelerations_into(&state, &chain.no_inputs(), &mut accelerations);
            assert_eq!((found, accelerations), (expected, untouched));
            let mut stepped = state.clone();
            let found = Rk4::new(1e-3).step(&chain, &mut stepped, |_, _| chain.no_inputs());
            assert_eq!(found, expected);
            assert_eq!(stepped, state);

            let mut short = single.initial_state();
            short.coordinates_mut().iter_mut().zip(state.coordinates()).for_each(|(to, &from)| *to = from as f32);
            let found = single.accelerations(&short, &single.no_inputs()).map(|_| ());
            assert_eq!(found, expected, "{} in single precision, seed {seed}", stringify!($name));
        }
    )* };
}

#[test]
fn a_thin_rod_on_a_ball_at_the_tip_has_no_answer() {
    is_loose! { Tip }
    is_loose! { Balls }
}

#[test]
fn a_thin_rod_on_a_ball_at_the_tip_has_no_answer_by_transfer() {
    is_loose! { TipByTransfer }
    is_loose! { BallsByTransfer }
}

#[test]
fn a_thin_rod_inside_is_singular() {
    is_loose! { Deep }
    is_loose! { Axle }
}

#[test]
fn a_thin_rod_inside_is_singular_by_transfer() {
    is_loose! { DeepByTransfer }
    is_loose! { AxleByTransfer }
}

/// A rod with a ten-millionth of the inertia about its axis rotates fast, but has a solution.
#[test]
fn a_wire_has_an_answer() {
    let (mut riccati, mut transfer) = (Deep::<f64>::new(), DeepByTransfer::<f64>::new());
    riccati.set_thickness(1e-7).expect("a physical inertia");
    transfer.set_thickness(1e-7).expect("a physical inertia");
    for seed in 0..50 {
        let state = riccati.random_state(&mut Random::new(seed));
        let mut same = transfer.initial_state();
        same.q.copy_from(&state.q);
        same.v.copy_from(&state.v);
        let a = riccati.fast_accelerations(&state, &riccati.no_inputs());
        let b = transfer.fast_accelerations(&same, &transfer.no_inputs());
        // The mass ratio of 1e7 costs as many units in the last place.
        assert!(difference(&a, &b) < 1e-7, "seed {seed}: {:e}", difference(&a, &b));
    }
}

both! { Driven DrivenByTransfer [Pin, Ball] {
    gravity = [0, -9.8, 0] m/s^2;
    body Link {
        mass = 2 kg;
        com = [0.5, 0.1, -0.2] m;
        output = [1, 0.3, 0] m turned rpy(10, 70, -20) deg;
        inertia = tensor(0.3, 0.5, 0.6, 0.1, -0.04, 0.02) kg*m^2 about com;
    }
    ground -> pin(x) base -> Link link -> ball wrist -> Link hand;
    hinge base, wrist { torque = input; }
} }

/// Puts each bad number at every place of state and inputs.
macro_rules! refuses_values_that_are_not_finite {
    ($($name:ident)*) => { $(
        let chain = $name::<f64>::new();
        let state = chain.random_state(&mut Random::new(3));
        let good = state.clone();
        let solve = |state: &_, inputs: &_, origin: Origin, what: String| {
            let mut at = chain.workspace();
            let new = at.clone();
            chain.solve_into(&good, &chain.no_inputs(), &mut at).expect("an answer");
            assert_ne!(at, new);
            let found = chain.solve_into(state, inputs, &mut at);
            assert_eq!(found, Err(Error::NotFinite(origin)), "{}, {what}", stringify!($name));
            assert_eq!(at, new, "{}, {what}", stringify!($name));
            let fast = chain.accelerations(state, inputs).map(|_| ());
            assert_eq!(fast, Err(Error::NotFinite(origin)), "{}, {what}", stringify!($name));
        };
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for place in 0..state.coordinates().len() {
                let mut broken = state.clone();
                broken.coordinates_mut()[place] = bad;
                solve(&broken, &chain.no_inputs(), Origin::Coordinate(place), format!("{bad} in q[{place}]"));
            }
            for place in 0..state.rates().len() {
                let mut broken = state.clone();
                broken.rates_mut()[place] = bad;
                solve(&broken, &chain.no_inputs(), Origin::Rate(place), format!("{bad} in v[{place}]"));
            }
            let mut broken = state.clone();
            broken.set_time(bad);
            solve(&broken, &chain.no_inputs(), Origin::Time, format!("the time is {bad}"));
            let mut inputs = chain.no_inputs();
            inputs.base = bad;
            solve(&state, &inputs, Origin::Input(0), format!("{bad} at the base"));
            for place in 0..3 {
                let mut inputs = chain.no_inputs();
                inputs.wrist[place] = bad;
                solve(&state, &inputs, Origin::Input(1 + place), format!("{bad} at the wrist, {place}"));
            }
        }
        let (mut stepped, mut rk4) = (state.clone(), Rk4::new(1e-3));
        let late = |time: f64, _: &_| {
            let mut inputs = $name::<f64>::new().no_inputs();
            inputs.base = if time > 0.0 { f64::NAN } else { 0.0 };
            inputs
        };
        assert_eq!(rk4.step(&chain, &mut stepped, late), Err(Error::NotFinite(Origin::Input(0))));
        assert_eq!(stepped, state);
    )* };
}

#[test]
fn values_that_are_not_finite_are_refused() {
    refuses_values_that_are_not_finite! { Driven }
}

mstmm_chain! {
    chain Rope {
        gravity = [0, -9.8, 0] m/s^2;
        body Rod { mass = 1 kg; com = [0.5, 0, 0] m; output = [1, 0, 0] m;
                   inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com; }
        ground -> repeat 5 { ball joint -> Rod rod };
        hinge joint { torque = input; }
    }
}

#[test]
fn a_refused_rope_leaves_no_changes() {
    let chain = Rope::<f64>::new();
    let (new, mut at) = (chain.workspace(), chain.workspace());
    for place in 0..5 {
        chain.solve_into(&chain.initial_state(), &chain.no_inputs(), &mut at).expect("an answer");
        assert_ne!(at, new);
        let mut inputs = chain.no_inputs();
        inputs.joint[place][1] = f64::NAN;
        let found = chain.solve_into(&chain.initial_state(), &inputs, &mut at);
        assert_eq!(
            (found, &at),
            (Err(Error::NotFinite(Origin::Input(3 * place + 1))), &new),
            "{place}"
        );
    }
}

#[test]
fn values_that_are_not_finite_are_refused_by_transfer() {
    refuses_values_that_are_not_finite! { DrivenByTransfer }
}

/// A state so large that sums overflow is not a singular hinge.
#[test]
fn overflow_is_not_reported_as_singular() {
    let chain = Driven::<f64>::new();
    let mut state = chain.initial_state();
    state.rates_mut().iter_mut().for_each(|rate| *rate = 1e300);
    let overflow = Error::NotFinite(Origin::Result);
    assert_eq!(chain.accelerations(&state, &chain.no_inputs()), Err(overflow));
    // A pivot that does not vanish beside a scale that overflows, and results whose sum does.
    let (pivots, scales) = ([1.0], [f64::INFINITY]);
    assert!(!mstmm::generated::pivots_ok(pivots, scales, [0.0]));
    let error = |pivots, scales| {
        let (state, inputs) = (chain.initial_state(), chain.no_inputs());
        mstmm::generated::pivot_error::<Driven<f64>, _>(&["hinge"], pivots, scales, &state, &inputs)
    };
    assert_eq!(error(pivots, scales), overflow);
    assert!(!mstmm::generated::pivots_ok([1.0], [1.0], [f64::MAX, f64::MAX]));
    assert_eq!(error([1.0], [1.0]), overflow);
    assert!(mstmm::generated::pivots_ok([1.0], [1.0], [f64::MAX, 0.0]));
    // One that does.
    let (pivots, scales) = ([f64::EPSILON], [1.0]);
    assert!(!mstmm::generated::pivots_ok(pivots, scales, [0.0]));
    let singular = Error::Singular { hinge: "hinge" };
    assert_eq!(error(pivots, scales), singular);
}

/// Whichever of the numbers it is that is not finite, and however many there are.
#[test]
fn all_values_are_checked() {
    fn looks_at_all<const N: usize>() {
        assert!(mstmm::generated::pivots_ok([1.0; 0], [], [1.0; N]), "{N}");
        for place in 0..N {
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let mut numbers = [1.0; N];
                numbers[place] = bad;
                assert!(
                    !mstmm::generated::pivots_ok([1.0; 0], [], numbers),
                    "{bad} at {place} of {N}"
                );
            }
        }
    }
    looks_at_all::<0>();
    looks_at_all::<1>();
    looks_at_all::<2>();
    looks_at_all::<3>();
    looks_at_all::<7>();
    // More are added in eight sums.
    looks_at_all::<32>();
    looks_at_all::<33>();
    looks_at_all::<41>();
    looks_at_all::<114>();
}
