//! Units and arithmetic, weighed: a lump at 2 m/s has the kinetic energy of twice its mass.

use mstmm::mstmm_chain;
use std::f64::consts::PI;

/// The mass that is written, as the chain has it.
macro_rules! mass {
    ($($mass:tt)*) => {{
        mstmm_chain! {
            chain Lump {
                body Mass {
                    mass = $($mass)*;
                    com = [0, 0, 0];
                    inertia = diag(1, 1, 1) about com;
                }
                Mass lump;
                body lump { start_velocity = [2, 0, 0] m/s; }
            }
        }
        let lump = Lump::<f64>::new();
        lump.energy(&lump.initial_state()).kinetic / 2.0
    }};
}

/// The angle and the rate that a pin starts with.
macro_rules! start {
    ([$($angle:tt)*], [$($rate:tt)*]) => {{
        mstmm_chain! {
            chain Wheel {
                body Disc { mass = 1; com = [0, 0, 0]; inertia = diag(1, 1, 2) about com; }
                ground -> pin axle -> Disc disc;
                hinge axle { start = $($angle)*; start_rate = $($rate)*; }
            }
        }
        let state = Wheel::<f64>::new().initial_state();
        [state.axle().angle(), state.axle().rate()]
    }};
}

#[test]
fn units_scale() {
    assert_eq!(mass!(1.2 kg), 1.2);
    assert_eq!(mass!(1.2), 1.2, "without a unit: SI");
    assert_eq!(mass!(250 g), 0.25);
    assert_eq!(mass!(0.003 t), 3.0);
    assert_eq!(mass!(4e6 mg), 4.0);
    assert_eq!(mass!(0.5kg), 0.5, "the unit right behind the digits");
    assert_eq!(mass!(1_000. g), 1.0);
    assert_eq!(mass!(2 N*s^2/m), 2.0);
    assert_eq!(mass!(3 J*s^2/m^2), 3.0);
    assert_eq!(mass!(2 W*s^3/m/m), 2.0);
    assert_eq!(mass!(5 Pa*m*s^2), 5.0);
    assert_eq!(mass!(7 kg*Hz*s), 7.0);
    assert_eq!(mass!(1 kg*min/h), 1.0 / 60.0);
}

#[test]
fn terms_add_and_units_close_products() {
    assert_eq!(mass!(1 kg + 250 g), 1.25);
    assert_eq!(mass!(1 kg - 250 g + 0), 0.75);
    assert_eq!(mass!(1 / 6), 1.0 / 6.0, "a real number");
    assert_eq!(mass!(1/4 kg), 0.25);
    assert_eq!(mass!((2 kg) * 3), 6.0);
    assert_eq!(mass!((6 N) / (2 m/s^2)), 3.0);
    assert_eq!(mass!((1 m + 250 mm) * (2 kg/m)), 2.5);
    assert_eq!(mass!(-(-2) kg), 2.0);
    assert_eq!(mass!(2^3 kg), 8.0);
    assert_eq!(mass!(2^-1 * 3 kg), 1.5);
}

#[test]
fn functions_of_numbers() {
    assert_eq!(mass!(sqrt(2) kg), 2_f64.sqrt());
    assert_eq!(mass!(sqrt(2) * (1 kg)), 2_f64.sqrt());
    assert_eq!(mass!(sqrt(9 kg^2)), 3.0);
    assert_eq!(mass!(sin(90 deg) kg), 1.0, "right angles are exact");
    assert_eq!(mass!(cos(PI/3) kg), (PI / 3.0).cos());
    assert_eq!(mass!(PI kg), PI);
}

#[test]
fn angles_and_rates() {
    crate::assert_close(start!([30 deg], [90 deg/s]), [PI / 6.0, PI / 2.0]);
    crate::assert_close(start!([PI/2], [30 rpm]), [PI / 2.0, PI]);
    crate::assert_close(start!([0.25 rev], [2 rev/s]), [PI / 2.0, 4.0 * PI]);
    crate::assert_close(start!([-100 mrad], [1 s^-1]), [-0.1, 1.0]);
    crate::assert_close(start!([90 deg + 1 rad - (1 rev) / 4], [0]), [1.0, 0.0]);
}

/// What a macro passes on as an expression is one factor, as it is in Rust.
#[test]
fn expressions_from_macros_stay_whole() {
    macro_rules! twice {
        ($expression:expr) => {
            mass!(2 * $expression)
        };
    }
    macro_rules! square {
        ($number:literal) => {
            mass!($number^2 kg)
        };
    }
    macro_rules! less {
        ($expression:expr) => {
            mass!((10 - $expression) kg)
        };
    }
    macro_rules! power {
        ($power:literal) => {
            mass!(2^$power kg)
        };
    }
    assert_eq!(twice!(1 + 2), 6.0);
    assert_eq!(
        [twice!(-1 + 3), less!(-3 - 1)],
        [4.0, 14.0],
        "a sign at the beginning stays inside"
    );
    assert_eq!([square!(-3), power!(-1)], [9.0, 0.5]);
}
