//! `approx`: comparisons of states.

use approx::{
    assert_abs_diff_eq, assert_abs_diff_ne, assert_relative_eq, assert_relative_ne, assert_ulps_eq,
    assert_ulps_ne,
};
use mstmm::ChainState;
use mstmm::nalgebra::{UnitQuaternion, Vector3};
use mstmm_formats::{ArmState, CrabState, RopeState};

/// Each value is compared, within the tolerance.
#[test]
fn every_value_counts() {
    let state = RopeState::<f64>::default();
    let changes = |change: f64| {
        let (coordinates, rates) = (state.coordinates().len(), state.rates().len());
        (0..=coordinates + rates).map(move |index| {
            let mut changed = RopeState::<f64>::default();
            match (changed.q.get_mut(index), index.checked_sub(coordinates)) {
                (Some(place), _) => *place += change,
                (_, Some(index)) if index < rates => changed.v[index] += change,
                _ => changed.t += change,
            }
            changed
        })
    };
    for changed in changes(0.5e-6) {
        assert_abs_diff_eq!(state, changed, epsilon = 1e-6);
        assert_abs_diff_ne!(state, changed);
        assert_ulps_ne!(state, changed);
    }
    for changed in changes(2e-6) {
        assert_abs_diff_ne!(state, changed, epsilon = 1e-6);
        assert_relative_ne!(state, changed);
    }
}

#[test]
fn tolerances_are_those_of_the_scalar() {
    let mut state = ArmState::<f64>::default();
    state.v[1] = 1e6;
    let mut next = state.clone();
    next.v[1] = 1e6 + 1e-4;
    assert_relative_eq!(state, next, max_relative = 1e-9);
    assert_relative_ne!(state, next, max_relative = 1e-11);
    next.v[1] = f64::from_bits(1e6f64.to_bits() + 3);
    assert_ulps_eq!(state, next, max_ulps = 3);
    assert_ulps_ne!(state, next, max_ulps = 2);
    next.v[1] = f64::NAN;
    assert_abs_diff_ne!(next, next, epsilon = 1.0);
}

/// A quaternion and its negative are one rotation. Of one quaternion all components change their signs.
#[test]
fn negative_quaternions_are_equal() {
    let mut state = CrabState::<f64>::default();
    let turn = UnitQuaternion::from_scaled_axis(Vector3::new(0.3, -0.2, 0.5));
    state.trunk_mut().set_orientation(turn);
    let start = state.coordinates().iter().position(|w| *w == turn.w).expect("the quaternion");
    let mut negative = state.clone();
    negative.q.rows_mut(start, 4).neg_mut();
    assert_abs_diff_eq!(state, negative);
    assert_relative_eq!(state, negative);
    assert_ulps_eq!(state, negative);
    let mut mixed = state.clone();
    mixed.q.rows_mut(start, 2).neg_mut();
    assert_abs_diff_ne!(state, mixed, epsilon = 1e-3);
    // Other coordinates have signs.
    let mut other = state.clone();
    (state.q[0], other.q[0]) = (1.0, -1.0);
    assert_abs_diff_ne!(state, other, epsilon = 1e-3);
}
