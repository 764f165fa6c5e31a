//! Lengths near one: what the documentation of `accelerations_into` says of them.

use super::models::*;
use mstmm::ChainState;
use mstmm_reference::Random;
use nalgebra::Vector3;

use crate::support::states::random_state;

/// The matrix of a quaternion of length n is (1 − n²) 1 + n² R, to be seen where a pose is read.
#[test]
fn matrices_are_a_mean_of_the_rotation_and_none() {
    let chain = Written::<f64>::new();
    let inputs = chain.no_inputs();
    let tip = |length: f64| -> Vector3<f64> {
        let mut state = chain.initial_state();
        state.q.as_mut_slice()[..4].copy_from_slice(&of_length::<f64>(length));
        let mut at = chain.workspace();
        chain.solve_into(&state, &inputs, &mut at).expect("a regular chain");
        at.la().output().position()
    };
    for length in [0.9, 0.97, 1.0, 1.02, 1.1] {
        let square = length * length;
        let expected = Vector3::x() * (1.0 - square) + tip(1.0) * square;
        assert!((tip(length) - expected).norm() < 1e-15, "{length}");
    }
}

/// Accelerations are those of the rotation up to terms of the order of n² − 1, and rates of
/// quaternions n times those of the unit quaternion.
fn check<C: Compared>(places: &[(usize, &'static str)]) {
    let chain = C::default();
    let inputs = chain.no_inputs();
    let rate = |state: &C::State| {
        let mut rate = state.clone();
        chain.derivative_into(state, &inputs, &mut rate).expect("a regular chain");
        rate
    };
    let numbers = |slice: &[C::Scalar]| -> Vec<f64> { slice.iter().map(|&x| x.into()).collect() };
    for seed in 0..20 {
        let state = random_state::<C>(&mut Random::new(seed));
        let unit = rate(&state);
        let (unit_q, unit_v) = (numbers(unit.coordinates()), numbers(unit.rates()));
        let size = unit_v.iter().fold(1.0_f64, |size, x| size.max(x.abs()));
        let epsilon: f64 = <C::Scalar as mstmm::Scalar>::epsilon().into();
        for excess in [-1e-2, 1e-3, 1e-5] {
            let mut scaled = state.clone();
            for &(place, _) in places {
                for x in &mut scaled.coordinates_mut()[place..place + 4] {
                    *x *= <C::Scalar as mstmm::Scalar>::constant(1.0 + excess);
                }
            }
            let found = rate(&scaled);
            // The condition of these chains is some tens.
            let near = 100.0 * (excess.abs() + 10.0 * epsilon) * size;
            for (a, b) in numbers(found.rates()).iter().zip(&unit_v) {
                assert!((a - b).abs() < near, "seed {seed}, {excess}: {a} and {b}");
            }
            let found_q = numbers(found.coordinates());
            for &(place, _) in places {
                for k in place..place + 4 {
                    let off = found_q[k] - (1.0 + excess) * unit_q[k];
                    assert!(off.abs() < 16.0 * epsilon, "{off:e}");
                }
            }
        }
    }
}

#[test]
fn accelerations_are_those_of_the_rotation_to_first_order() {
    check::<Written<f64>>(WRITTEN);
    check::<Written<f32>>(WRITTEN);
    check::<WrittenByTransfer<f64>>(WRITTEN);
    check::<Repeated<f64>>(REPEATED);
    check::<Adrift<f64>>(ADRIFT);
    check::<AdriftByTransfer<f64>>(ADRIFT);
}
