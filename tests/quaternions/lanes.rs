//! Lanes: all of them must be good.

use super::models::*;
use mstmm::description::Origin;
use mstmm::prelude::*;
use mstmm::wide::{f32x4, f64x2};
use mstmm::{Error, Mask, Scalar};

/// Good quaternions with one that is not in one lane.
fn check<W: Scalar>(lanes: usize, pack: impl Fn(usize, f64, f64) -> W) {
    let chain = Repeated::<W>::default();
    let inputs = chain.no_inputs();
    for lane in 0..lanes {
        for (length, expected) in [
            (0.0, Err(Error::InvalidQuaternion { hinge: "b" })),
            (0.8, Err(Error::InvalidQuaternion { hinge: "b" })),
            (1.2, Err(Error::InvalidQuaternion { hinge: "b" })),
            (0.95, Ok(())),
            (f64::NAN, Err(Error::NotFinite(Origin::Coordinate(7)))),
        ] {
            let mut state = chain.initial_state();
            let (good, bad) = (of_length::<f64>(1.0), of_length::<f64>(length));
            for k in 0..4 {
                state.q[7 + k] = pack(lane, good[k], bad[k]);
            }
            let mut moved = state.clone();
            let mut rk4 = Rk4::new(W::constant(1e-3));
            assert_eq!(rk4.step(&chain, &mut moved, |_, _| inputs), expected, "{length}");
            if expected.is_err() && !length.is_nan() {
                assert_eq!(moved, state);
            }
            let mut dopri5 =
                Dopri5::new(Scalar::constant(1e-3), <W::Real as Scalar>::constant(1e-3));
            let result = dopri5.step(&chain, &mut state.clone(), |_, _| inputs);
            assert_eq!(result, expected, "{length}");
            let mut at = chain.workspace();
            assert_eq!(chain.solve_into(&state, &inputs, &mut at), expected, "{length}");
        }
    }
    assert!(W::Mask::splat(true).all());
}

#[test]
fn one_bad_lane_is_refused() {
    check(2, |lane, good, bad| {
        let mut lanes = [good; 2];
        lanes[lane] = bad;
        f64x2::from(lanes)
    });
    check(4, |lane, good, bad| {
        let mut lanes = [good as f32; 4];
        lanes[lane] = bad as f32;
        f32x4::from(lanes)
    });
}
