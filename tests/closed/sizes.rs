//! Closed chains of all sizes and speeds: the tolerance is relative to both.

use mstmm::{Error, Scalar, mstmm_chain};

mstmm_chain! {
    /// A four-bar linkage that starts open.
    plane chain Scaled {
        param size = 1 m;
        body Crank {
            mass = 1 kg; com = [size*0.15, 0]; output = [size*0.3, 0]; inertia = size*size*(0.01 kg) about com;
        }
        body Coupler {
            mass = 2.5 kg; com = [size*0.4, size*0.1]; output = [size*0.8, 0]; inertia = size*size*(0.1 kg) about com;
        }
        body Rocker {
            mass = 1.5 kg; com = [size*0.3, 0]; output = [size*0.6, 0]; inertia = size*size*(0.05 kg) about com;
        }
        ground -> pin a -> Crank crank -> pin b -> Coupler coupler -> pin c -> Rocker rocker
            -> pin d -> ground at [size*0.9, 0];
        hinge a { start = 60 deg; }
        hinge b { start = -40 deg; }
        hinge c { start = -70 deg; }
        hinge d { start = 50 deg; }
    }
}

/// Returns the angles and rates of a linkage of this size, whose crank has this rate at first.
fn assembled<T: Scalar<Real = T> + Into<f64>>(size: f64, rate: f64) -> Result<[f64; 8], Error> {
    let mut chain = Scaled::<T>::new();
    chain.set_size(T::constant(size))?;
    let mut state = chain.initial_state();
    state.v[0] = T::constant(rate);
    chain.assemble(&mut state, &chain.no_inputs())?;
    let numbers = state.q.iter().chain(state.v.iter());
    Ok(core::array::from_fn(|k| numbers.clone().nth(k).map_or(f64::NAN, |&x| x.into())))
}

/// Linkages of a micrometre and of kilometres have the same shape, and rates in proportion to that of the crank: up to
/// rounding times the condition number of the loop, some tens.
fn check<T: Scalar<Real = T> + Into<f64>>() -> Result<(), Error> {
    let expected = assembled::<f64>(1.0, 1.0)?;
    let tolerance = 300.0 * T::epsilon().into();
    for size in [1e-6, 1e-5, 1e-3, 0.1, 1.0, 30.0, 1e3, 1e5] {
        for rate in [0.0, 1e-3, 1.0, 30.0, 1e3, 1e5] {
            let found = assembled::<T>(size, rate)?;
            let scales = [1.0; 4].into_iter().chain([rate; 4]);
            for ((found, expected), scale) in found.into_iter().zip(expected).zip(scales) {
                let off = (found - expected * scale).abs();
                assert!(off <= tolerance * scale, "{size} m, {rate} rad/s: {off:e}");
            }
        }
    }
    Ok(())
}

#[test]
fn linkages_of_all_sizes_and_speeds_are_assembled() -> Result<(), Error> {
    check::<f64>()?;
    check::<f32>()
}
