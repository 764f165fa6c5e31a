//! Closing a chain by corrections that generated code supplies.

mod common;

use common::State;
use mstmm_runtime::generated::{
    self, Residual, RotationCoordinates, check_rank, check_rotations, limit_rotations, rank_steps,
};
use mstmm_runtime::{ChainState, Error, Scalar};

type Start<T> = State<T, 1, 1>;

fn start(q: f64) -> Start<f64> {
    State { q: [q], v: [1.0], t: 3.0 }
}

/// Of a chain of unit size.
fn residual<T: Scalar>(distance: T, excess: T) -> Residual<T> {
    Residual { distance, relative: distance, excess }
}

/// Of a chain without redundant directions.
fn assemble<T: Scalar>(
    state: &mut Start<T>,
    mut correct: impl FnMut(&mut Start<T>) -> T,
) -> Result<(), Error> {
    generated::close(state, "hook", |state| residual(correct(state), T::constant(0.0)))
}

/// Newton's method on q² = 2; the rate is to be 2q.
fn toward_the_root_of_two(state: &mut Start<f64>) -> f64 {
    let [q] = state.q;
    state.q = [q - (q * q - 2.0) / (2.0 * q)];
    state.v = [2.0 * state.q[0]];
    (state.q[0] * state.q[0] - 2.0).abs()
}

#[test]
fn a_start_nearby_is_closed() {
    for q in [1.0, 0.01, 300.0] {
        let mut state = start(q);
        assert_eq!(assemble(&mut state, toward_the_root_of_two), Ok(()));
        assert!((state.q[0] - 2f64.sqrt()).abs() < 1e-15);
        assert_eq!((state.v[0], state.t), (2.0 * state.q[0], 3.0));
    }
}

#[test]
fn single_precision_is_closed_to_its_own_accuracy() {
    let mut state = State { q: [1.0f32], v: [0.0], t: 0.0 };
    let closed = assemble(&mut state, |state: &mut Start<f32>| {
        let [q] = state.q;
        state.q = [q - (q * q - 2.0) / (2.0 * q)];
        (state.q[0] * state.q[0] - 2.0).abs()
    });
    assert_eq!(closed, Ok(()));
    // 64 ε in q² are 23 in q.
    assert!((state.q[0] - 2f32.sqrt()).abs() < 23.0 * f32::EPSILON);
}

/// q² = −2 has no root: corrections go astray until they are given up.
#[test]
fn a_chain_that_cannot_be_closed_is_refused_and_unchanged() {
    let mut state = start(1.0);
    let mut corrections = 0;
    let refused = assemble(&mut state, |state| {
        corrections += 1;
        let [q] = state.q;
        state.q = [q - (q * q + 2.0) / (2.0 * q)];
        state.coordinates_mut()[0].powi(2) + 2.0
    });
    assert_eq!((refused, corrections), (Err(Error::NotAssembled), 50));
    assert_eq!(state, start(1.0));
}

#[test]
fn values_that_are_not_finite_are_refused_at_once() {
    for broken in [f64::NAN, f64::INFINITY] {
        let (mut state, mut corrections) = (start(1.0), 0);
        let refused = assemble(&mut state, |state| {
            corrections += 1;
            state.q = [broken];
            // Near before it breaks.
            if corrections == 1 { 1e-11 } else { broken }
        });
        assert_eq!((refused, corrections), (Err(Error::NotAssembled), 2));
        assert_eq!(state, start(1.0));
    }
}

/// Long chains leave more than 64 ε; what no longer shrinks below ε^⅝ is rounding.
#[test]
fn rounding_that_stays_is_accepted() {
    let told = |residuals: &[f64]| {
        let (mut state, mut corrections) = (start(1.0), 0);
        let outcome = assemble(&mut state, |_| {
            corrections += 1;
            residuals.get(corrections - 1).copied().unwrap_or(*residuals.last().unwrap())
        });
        (outcome, corrections)
    };
    assert_eq!(told(&[1e-3, 1e-6, 1e-12, 2e-13, 3e-13]), (Ok(()), 5));
    assert_eq!(told(&[1e-3, 1e-15]), (Ok(()), 2));
    assert_eq!(told(&[1e-3, 2e-3, 1e-3, 1e-12, 1e-12]), (Ok(()), 5));
    assert_eq!(told(&[1e-9]), (Err(Error::NotAssembled), 50));
}

/// Off a closure redundant directions hold about the square of the gap; on it nothing but rounding.
#[test]
fn a_redundant_direction_that_holds_on_the_closure_is_an_error() {
    let error = Err(Error::ClosureRank { hinge: "hook" });
    assert_eq!(check_rank(residual(1e-3, 1e-2), "hook"), Ok(()));
    assert_eq!(check_rank(residual(1e-12, 1e-11), "hook"), Ok(()));
    assert_eq!(check_rank(residual(1e-12, 1e-3), "hook"), error);
    assert_eq!(check_rank(residual(1e-6_f32, 1e-5), "hook"), Ok(()));
    assert_eq!(check_rank(residual(1e-6_f32, 1e-2), "hook"), error);
    let mut state = start(1.0);
    let refused =
        generated::close(&mut state, "hook", |state| residual(toward_the_root_of_two(state), 0.1));
    assert_eq!((refused, state), (error, start(1.0)));
}

/// The whole change is shortened until no rotation exceeds half a rad; a quaternion changes by half the angle.
#[test]
fn rotations_of_a_correction_are_limited() {
    let angles =
        RotationCoordinates { first: 1, entries: 1, stride: 2, count: 2, quaternion: false };
    let quaternion =
        RotationCoordinates { first: 4, entries: 4, stride: 4, count: 1, quaternion: true };
    let (before, table) = ([0.0; 8], [angles, quaternion]);
    let limited = |after: [f64; 8]| {
        let mut found = after;
        let checked = check_rotations(&before, &after, &table);
        let changed = limit_rotations(&before, &mut found, &table);
        assert_eq!(changed, checked == Err(Error::NotAssembled));
        found
    };
    // Translations are not limited by themselves.
    let small = [300.0, 0.5, -70.0, -0.5, 0.25, 0.0, -0.25, 0.0];
    assert_eq!(limited(small), small);
    let large = [6.0, 1.0, 8.0, -4.0, 0.5, 0.0, 0.0, 0.0];
    assert_eq!(limited(large), large.map(|change| change / 8.0));
    let turned = [6.0, 0.1, 8.0, 0.0, 0.5, 0.0, 0.0, 0.0];
    assert_eq!(limited(turned), turned.map(|change| change / 2.0));
    let mut unknown = before;
    unknown[1] = f64::NAN;
    assert!(!limit_rotations(&before, &mut unknown, &table));
}

/// The pivots of a closure that is special at its start: rank one there, two elsewhere.
#[test]
fn the_rank_of_a_closure_is_the_largest_around_the_start() {
    let pivots = |state: &Start<f64>| [1.0, (state.q[0] - 1.0).powi(2), 1e-20];
    let steps = |gap: f64| rank_steps(&start(1.0), |_| {}, |_| residual(gap, 0.0), pivots);
    assert_eq!(steps(0.0), [1.0, 1.0, 0.0]);
    // What cannot be assembled says nothing: then no direction counts as redundant.
    assert_eq!(steps(1.0), [1.0; 3]);
}

mod chains {
    use super::*;
    use mstmm_runtime::{Chain, Energy, GeneratedChain};

    struct Open;

    impl Chain for Open {
        type Scalar = f64;
        type State = Start<f64>;
        type Inputs = ();

        fn derivative_into(
            &self,
            _: &Start<f64>,
            (): &(),
            rate: &mut Start<f64>,
        ) -> Result<(), Error> {
            (rate.q, rate.v) = ([5.0], [7.0]);
            Ok(())
        }

        fn configuration_rate_into(&self, _: &Start<f64>, _: &mut Start<f64>) {}

        fn normalize(&self, _: &mut Start<f64>) {}
    }

    impl GeneratedChain for Open {
        type Workspace = ();

        fn initial_state(&self) -> Start<f64> {
            start(1.0)
        }

        fn no_inputs(&self) {}

        fn workspace(&self) {}

        fn solve_into(&self, _: &Start<f64>, (): &(), (): &mut ()) -> Result<(), Error> {
            Ok(())
        }

        fn energy(&self, _: &Start<f64>) -> Energy<f64> {
            Energy::default()
        }
    }

    /// What a chain without springs and without a closure need not say.
    #[test]
    fn open_chains_are_closed_and_not_stiff() {
        let (mut state, mut rate) = (start(1.0), start(0.0));
        assert_eq!(Open.assemble(&mut state, &()), Ok(()));
        assert_eq!(state, start(1.0));
        Open.implicit_derivative_into(&state, &(), 0.1, &mut rate).unwrap();
        assert_eq!((rate.q, rate.v), ([5.0], [7.0]));
    }
}
