//! Coordinates, rates and accelerations: hinge by hinge along the route, and repetition by repetition.

use mstmm::prelude::*;
use mstmm::{HingeMotion, PinState, Scalar};

macro_rules! chains {
    ($method:ident: $repeated:ident $unrolled:ident) => {
        mstmm_chain! {
            pub chain $repeated {
                method = $method;
                gravity = [1, -9.8, 2] m/s^2;
                body Rod {
                    mass = 1 kg; com = [0.5, 0.1, 0] m; output = [1, 0, 0.2] m;
                    inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
                }
                Rod hull -> repeat 3 { pin(z) a -> Rod la -> ball b -> Rod lb }
                    -> pin(y) driven -> Rod lt
                    -> repeat 2 { cylindrical c -> Rod lc -> weld w -> Rod lw -> pin(x) d -> Rod ld }
                    -> slider e -> Rod le;
                hinge driven { motion = input; }
            }
        }
        mstmm_chain! {
            /// The same, written out.
            pub chain $unrolled {
                method = $method;
                gravity = [1, -9.8, 2] m/s^2;
                body Rod {
                    mass = 1 kg; com = [0.5, 0.1, 0] m; output = [1, 0, 0.2] m;
                    inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
                }
                Rod hull -> pin(z) a0 -> Rod la0 -> ball b0 -> Rod lb0
                    -> pin(z) a1 -> Rod la1 -> ball b1 -> Rod lb1
                    -> pin(z) a2 -> Rod la2 -> ball b2 -> Rod lb2
                    -> pin(y) driven -> Rod lt
                    -> cylindrical c0 -> Rod lc0 -> weld w0 -> Rod lw0 -> pin(x) d0 -> Rod ld0
                    -> cylindrical c1 -> Rod lc1 -> weld w1 -> Rod lw1 -> pin(x) d1 -> Rod ld1
                    -> slider e -> Rod le;
                hinge driven { motion = input; }
            }
        }
    };
}

chains! { riccati: Repeated Written }
chains! { transfer: RepeatedByTransfer WrittenByTransfer }

/// Of floating hull, then three times a pin and a ball, then twice a cylindrical hinge and a pin, then
/// a slider: as many numbers.
const COORDINATES: usize = 7 + 3 * (1 + 4) + 2 * (2 + 1) + 1;
const RATES: usize = 6 + 3 * (1 + 3) + 2 * (2 + 1) + 1;

/// Returns numbers that equal their index; quaternions have unit length.
fn filled<S: ChainState>(state: &mut S) {
    let number = |k: usize| S::Scalar::constant(0.01 * k as f64);
    let zero_position = state.coordinates().to_vec();
    for (k, (q, rest)) in state.coordinates_mut().iter_mut().zip(&zero_position).enumerate() {
        let zero = S::Scalar::default();
        let in_quaternion = zero_position[k.saturating_sub(3)..=k].iter().any(|&x| x != zero);
        *q = if in_quaternion { *rest } else { number(k) };
    }
    for (k, v) in state.rates_mut().iter_mut().enumerate() {
        *v = number(k);
    }
}

macro_rules! check {
    ($repeated:ident $repeated_state:ident $unrolled:ident $unrolled_state:ident $number:ident) => {{
        type Number = $number;
        let number = |k: usize| Number::from(k as u8) * 0.01;
        let mut state = $repeated_state::<Number>::default();
        assert_eq!((state.q.len(), state.v.len()), (COORDINATES, RATES));
        for (k, v) in state.v.iter_mut().enumerate() {
            *v = Number::constant(0.01) * Number::from(k as u8);
        }
        for (k, q) in state.q.iter_mut().enumerate() {
            *q = Number::constant(0.01) * Number::from(k as u8);
        }
        // The floating body comes first.
        let hull = state.hull();
        assert_eq!((hull.position().x, hull.velocity().x), (number(0), number(0)));
        assert_eq!((hull.orientation().w, hull.rate().z), (number(3), number(5)));
        // Then every repetition as a whole, hinge by hinge.
        for k in 0..3 {
            let (q, v) = (7 + 5 * k, 6 + 4 * k);
            let (a, b) = (state.a(k).expect("of three"), state.b(k).expect("of three"));
            assert_eq!((a.angle(), a.rate()), (number(q), number(v)));
            assert_eq!((b.orientation().w, b.orientation().k), (number(q + 1), number(q + 4)));
            assert_eq!((b.rate().x, b.rate().z), (number(v + 1), number(v + 3)));
        }
        // A prescribed hinge and welds have no place.
        for k in 0..2 {
            let (q, v) = (22 + 3 * k, 18 + 3 * k);
            let (c, d) = (state.c(k).expect("of two"), state.d(k).expect("of two"));
            assert_eq!((c.position(), c.angle()), (number(q), number(q + 1)));
            assert_eq!((c.velocity(), c.rate()), (number(v), number(v + 1)));
            assert_eq!((d.angle(), d.rate()), (number(q + 2), number(v + 2)));
        }
        assert_eq!((state.e().position(), state.e().velocity()), (number(28), number(24)));

        // Written out it is the same order: numbers can be copied from one to the other.
        let (repeated, unrolled) = ($repeated::<Number>::new(), $unrolled::<Number>::new());
        let mut state = repeated.initial_state();
        filled(&mut state);
        let twin = $unrolled_state { q: state.q, v: state.v, t: state.t };
        let driven = HingeMotion { state: PinState::new(0.3, 0.5), acceleration: 0.7 };
        let (mut inputs, mut same) = (repeated.no_inputs(), unrolled.no_inputs());
        (inputs.driven, same.driven) = (driven, driven);
        let mut at = repeated.workspace();
        repeated.solve_into(&state, &inputs, &mut at).expect("a regular chain");
        let found = repeated.accelerations(&state, &inputs).expect("a regular chain");
        let expected = unrolled.accelerations(&twin, &same).expect("a regular chain");
        let (off, size) = ((found - expected).norm(), expected.norm());
        assert!(off < 1e4 * Number::EPSILON * size, "{off:e} of {size}");

        // Accelerations are in the order of the rates.
        let accelerations = *at.accelerations();
        let (off, size) = ((found - accelerations).norm(), expected.norm());
        assert!(off < 1e4 * Number::EPSILON * size, "{off:e} of {size}");
        for k in 0..3 {
            let v = 6 + 4 * k;
            let (a, b) = (at.a(k).expect("of three"), at.b(k).expect("of three"));
            assert_eq!(a.acceleration(), accelerations[v]);
            assert_eq!(b.acceleration().as_slice(), &accelerations.as_slice()[v + 1..v + 4]);
        }
        for k in 0..2 {
            let v = 18 + 3 * k;
            let (c, d) = (at.c(k).expect("of two"), at.d(k).expect("of two"));
            assert_eq!(c.acceleration().as_slice(), &accelerations.as_slice()[v..v + 2]);
            assert_eq!(d.acceleration(), accelerations[v + 2]);
        }
        assert_eq!(at.e().acceleration(), accelerations[24]);
        // That of a prescribed hinge is known, and read by its name.
        assert_eq!(at.driven().acceleration(), 0.7);
    }};
}

#[test]
fn numbers_lie_along_the_route_and_by_repetition() {
    check!(Repeated RepeatedState Written WrittenState f64);
    check!(Repeated RepeatedState Written WrittenState f32);
    check!(RepeatedByTransfer RepeatedByTransferState WrittenByTransfer WrittenByTransferState f64);
}

mstmm_chain! {
    /// A chain held only at its end: the order is still that of the route.
    line chain Hanging {
        body Car { mass = 1 kg; output = 1 m; }
        Car first -> slider a -> Car second -> slider b -> ground;
    }
}

#[test]
fn a_chain_held_at_its_end_keeps_the_order_of_the_route() {
    let mut state = Hanging::<f64>::new().initial_state();
    state.a_mut().set_position(1.0).set_velocity(3.0);
    state.b_mut().set_position(2.0).set_velocity(4.0);
    assert_eq!((state.coordinates(), state.rates()), (&[1.0, 2.0][..], &[3.0, 4.0][..]));
}
