//! Lengths of axes and quaternions that depend on parameters: their directions are the same at any length within the
//! bounds, and setters refuse all others.

use mstmm::wide::{f32x4, f64x4};
use mstmm::{Error, Scalar, mstmm_chain};

mstmm_chain! {
    /// All axes and quaternions are proportional to the parameter.
    chain Proportional {
        gravity = [0, 0, -9.81] m/s^2;
        param s = 1;
        body Rod {
            mass = 1 kg;
            com = [0.1, 0.1, -0.5] m;
            output = [0, 0.2, -1] m turned quaternion(2*s, s, 0, s);
            inertia = diag(0.1, 0.12, 0.05) kg*m^2 about com;
        }
        ground -> pin([s, 2*s, 2*s]) a -> Rod one -> slider([s, -s, 0]) b -> Rod two
            -> universal([s, 0, 0], [0, s, s]) c -> Rod three -> ball d -> Rod four;
        hinge a { start = 0.3 rad; }
        hinge d { stiffness = 2; rest = quaternion(s, s, 0, s); start = quaternion(s, 0, 2*s, s); }
    }

    /// The same with numbers whose squares overflow.
    chain Long {
        gravity = [0, 0, -9.81] m/s^2;
        body Rod {
            mass = 1 kg;
            com = [0.1, 0.1, -0.5] m;
            output = [0, 0.2, -1] m turned quaternion(2e200, 1e200, 0, 1e200);
            inertia = diag(0.1, 0.12, 0.05) kg*m^2 about com;
        }
        ground -> pin([1e200, 2e200, 2e200]) a -> Rod one -> slider([1e200, -1e200, 0]) b -> Rod two
            -> universal([1e200, 0, 0], [0, 1e200, 1e200]) c -> Rod three -> ball d -> Rod four;
        hinge a { start = 0.3 rad; }
        hinge d { stiffness = 2; rest = quaternion(1e200, 1e200, 0, 1e200); start = quaternion(1e200, 0, 2e200, 1e200); }
    }

    /// One component of each depends on a parameter.
    chain Leaning {
        gravity = [0, 0, -9.81] m/s^2;
        param axis = 0.5;
        param along = 0.5;
        param slide = 0.5;
        param only = 1;
        param turn = 1;
        param seat = 1;
        param rest = 1;
        param start = 1;
        param each[2] = 1;
        body Rod {
            mass = 1 kg;
            com = [0.1, 0.1, -0.5] m;
            output = [0, 0, -1] m turned quaternion(turn, 0.1, 0.2, 0.3);
            inertia = diag(0.1, 0.12, 0.05) kg*m^2 about com;
        }
        ground turned quaternion(0, seat, seat, 0) -> pin([axis, 0.3, 0.4]) a -> Rod one -> cylindrical([along, 1, 1]) b -> Rod two
            -> slider([1, slide, 0]) c -> Rod three -> ball d -> Rod four -> pin([only, 0, 0]) e -> Rod five
            -> repeat 2 { pin([each, 0, each]) f -> Rod six };
        hinge d { stiffness = 1; rest = quaternion(rest, 0, 0, rest); start = quaternion(start, 0.1, 0.1, 0.1); }
    }
}

/// Returns the accelerations at the start.
macro_rules! accelerations {
    ($chain:expr) => {{
        let chain = &$chain;
        let state = chain.initial_state();
        chain.accelerations(&state, &chain.no_inputs()).map(|found| found.data.0[0].to_vec())
    }};
}

/// Some hundred operations, on accelerations of up to 20.
macro_rules! agree {
    ($found:expr, $expected:expr, $tolerance:expr) => {{
        for (found, expected) in $found.iter().zip(&$expected) {
            assert!((found - expected).abs() < 20.0 * $tolerance, "{:?} {:?}", $found, $expected);
        }
    }};
}

#[test]
fn the_length_has_no_influence() -> Result<(), Error> {
    let (mut double, mut single) = (Proportional::<f64>::new(), Proportional::<f32>::new());
    let (of_double, of_single) = (accelerations!(double)?, accelerations!(single)?);
    assert!(of_double.iter().any(|acceleration| acceleration.abs() > 1.0));
    for length in [1e-14, 1e-3, 1e14] {
        double.set_s(length)?;
        agree!(accelerations!(double)?, of_double, 1e-12);
        single.set_s(length as f32)?;
        agree!(accelerations!(single)?, of_single, 1e-4);
    }
    agree!(accelerations!(Long::<f64>::new())?, of_double, 1e-12);
    agree!(accelerations!(Long::<f32>::new())?, of_single, 1e-4);
    Ok(())
}

/// Requires that a setter refuses a value and that the chain is unchanged.
macro_rules! refused {
    ($chain:ident.$set:ident, $name:literal, $value:expr) => {{
        let before = $chain.clone();
        let result = $chain.$set($value);
        assert!(
            matches!(result, Err(Error::InvalidParameter { name: $name, .. })),
            "{}: {result:?}",
            $name
        );
        assert_eq!($chain, before);
    }};
}

/// Values that are too large for any vector, and values that are too small for a vector without other components.
macro_rules! all_refused {
    ($T:ty, $large:expr, $small:expr) => {{
        let mut chain = Leaning::<$T>::new();
        for value in $large {
            refused!(chain.set_axis, "axis", value);
            refused!(chain.set_along, "along", value);
            refused!(chain.set_slide, "slide", value);
            refused!(chain.set_turn, "turn", value);
            refused!(chain.set_start, "start", value);
        }
        for value in $large.into_iter().chain($small) {
            refused!(chain.set_only, "only", value);
            refused!(chain.set_seat, "seat", value);
            refused!(chain.set_rest, "rest", value);
            let one = <$T>::constant(1.0);
            refused!(chain.set_each, "each", |index| if index == 1 { value } else { one });
        }
    }};
}

#[test]
fn lengths_out_of_the_bounds_are_refused() {
    all_refused!(
        f64,
        [1e16, 1e25, 1e154, 1e200, -1e200, f64::MAX],
        [0.0, 1e-16, 1e-160, 1e-200, 5e-324]
    );
    all_refused!(f32, [1e16, 1e19, 1e25, -1e25, f32::MAX], [0.0, 1e-16, 1e-20, 1e-25, 1e-45]);
}

/// One lane out of the bounds is enough.
#[test]
fn lengths_of_single_lanes_are_refused() {
    let double = |value| f64x4::new([1.0, 1.0, value, 1.0]);
    all_refused!(f64x4, [1e25, 1e200].map(double), [0.0, 1e-160, 1e-200].map(double));
    let single = |value| f32x4::new([1.0, 1.0, value, 1.0]);
    all_refused!(f32x4, [1e16, 1e25].map(single), [0.0, 1e-25].map(single));
}

#[test]
fn the_reason_names_the_axis() {
    let mut chain = Leaning::<f64>::new();
    let result = chain.set_axis(1e16);
    let reason = "must leave the length of the axis of hinge `a` between 1e-15 and 1e15";
    assert_eq!(result, Err(Error::InvalidParameter { name: "axis", reason }));
    let reason = "must leave the length of a quaternion between 1e-15 and 1e15";
    assert_eq!(chain.set_turn(1e16), Err(Error::InvalidParameter { name: "turn", reason }));
}
