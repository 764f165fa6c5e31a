//! Setters of views.

use super::models::*;
use mstmm::Error;
use mstmm::description::Origin;
use nalgebra::{Quaternion, UnitQuaternion};

/// The setters of all kinds of accessors: once, repeated, in a chain with repeated parts, floating.
fn check<T: Number>() {
    macro_rules! through {
        ($hinge:literal of $state:ident: $($view:tt)*) => {
            let mut state = $state::<T>::default();
            let mut set = |quaternion: [T; 4]| {
                let before = state.clone();
                let result = state $($view)*.set_quaternion(quaternion).map(|_| ());
                if result.is_err() {
                    assert_eq!(state, before);
                }
                result
            };
            for quaternion in refused() {
                assert_eq!(set(quaternion), Err(Error::InvalidQuaternion { hinge: $hinge }));
            }
            for broken in [T::NAN, T::INFINITE] {
                let mut quaternion = of_length(1.0);
                quaternion[2] = broken;
                assert_eq!(set(quaternion), Err(Error::NotFinite(Origin::Argument { name: "quaternion", index: 2 })));
            }
            for quaternion in accepted() {
                assert_eq!(set(quaternion), Ok(()));
            }
            assert!(state != $state::<T>::default());
        };
    }
    through!("c" of WrittenState: .c_mut());
    through!("d" of WrittenState: .d_mut());
    through!("b" of RepeatedState: .b_mut(1).expect("of three"));
    through!("c" of RepeatedState: .c_mut());
    through!("d" of RepeatedState: .d_mut(1).expect("of two"));
    through!("hull" of AdriftState: .hull_mut());
}

#[test]
fn components_that_are_no_rotation_are_refused() {
    check::<f64>();
    check::<f32>();
}

fn check_length<T: Number>() {
    let mut state = WrittenState::<T>::default();
    for quaternion in accepted() {
        state.c_mut().set_quaternion(quaternion).expect("a rotation");
        state.d_mut().set_quaternion(quaternion).expect("a rotation");
        for (k, expected) in of_length::<T>(1.0).into_iter().enumerate() {
            for found in [state.q[5 + k], state.q[12 + k]] {
                let (off, epsilon): (f64, f64) =
                    ((found - expected).abs().into(), T::epsilon().into());
                assert!(off < 4.0 * epsilon, "{quaternion:?}: {off:e}");
            }
        }
    }
}

#[test]
fn components_are_brought_to_unit_length() {
    check_length::<f64>();
    check_length::<f32>();
}

/// A wrong unit quaternion made by `new_unchecked` is detected when the state is used.
#[test]
fn unchecked_unit_quaternions_are_refused_where_the_state_is_used() {
    let chain = Written::<f64>::new();
    for length in [0.0, 0.5, 2.0] {
        let [w, x, y, z] = of_length(length);
        let unchecked = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
        let mut state = chain.initial_state();
        state.d_mut().set_orientation(unchecked);
        let error = Error::InvalidQuaternion { hinge: "d" };
        assert_refused(&chain, &state, &chain.no_inputs(), error);
    }
    let chain = Repeated::<f64>::new();
    let mut state = chain.initial_state();
    state.set_each_b(|index| {
        mstmm::BallState::new(of_length(if index == 2 { 0.3 } else { 1.0 }), [0.0; 3])
    });
    let error = Error::InvalidQuaternion { hinge: "b" };
    assert_refused(&chain, &state, &chain.no_inputs(), error);
}
