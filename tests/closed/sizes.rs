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

mstmm_chain! {
    /// Bennett's linkage, which starts open. Two of its five constraints depend on the others where it is closed.
    chain Redundant {
        param size = 1 m;
        param square = 1 kg*m^2;
        body Long {
            mass = 1 kg; com = [size*0.5, 0, 0]; inertia = diag(square*0.02, square*0.1, square*0.1) about com;
            output = [size, 0, 0] turned rpy(60, 0, 0) deg;
        }
        body Short {
            mass = 0.5 kg; com = [size*0.25, 0, 0]; inertia = diag(square*0.01, square*0.02, square*0.02) about com;
            output = [size*0.5, 0, 0] turned rpy(0.44783239692893245, 0, 0) rad;
        }
        ground -> pin a -> Long first -> pin b -> Short second -> pin c -> Long third -> pin d -> Short last
            -> weld w -> ground;
        hinge a { start = 1 rad; start_rate = 1 rad/s; }
        hinge b { start = 2.3 rad; }
        hinge c { start = 1 rad; }
        hinge d { start = -2.3 rad; }
    }
}

/// Linkages of all sizes are closed by the same motion, which fits constraints that cannot all be fulfilled at first.
#[test]
fn redundant_constraints_of_all_sizes_are_fitted_alike() -> Result<(), Error> {
    let closed = |size: f64| -> Result<_, Error> {
        let mut chain = Redundant::<f64>::new();
        chain.set_size(size)?;
        chain.set_square(size * size)?;
        let mut state = chain.initial_state();
        chain.assemble(&mut state, &chain.no_inputs())?;
        Ok((state.q, state.v))
    };
    let (q, v) = closed(1.0)?;
    for size in [1e-9, 1e-6, 1e-3, 30.0, 1e3, 1e6] {
        let (found_q, found_v) = closed(size)?;
        // The closed pose is found to 1e-9 of the size, and lies on a curve.
        let off = (found_q - q).abs().max().max((found_v - v).abs().max());
        assert!(off < 1e-8, "{size} m: {off:e}");
    }
    Ok(())
}
