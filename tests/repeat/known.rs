//! Chains with repeated parts whose accelerations or poses are the same in every state, so that no loop computes
//! them.

use mstmm::description::Origin;
use mstmm::prelude::*;
use mstmm::{Error, mstmm_chain};

mstmm_chain! {
    line chain Carts {
        body Cart { mass = 1 kg; output = 1 m; }
        ground -> slider a -> Cart b -> repeat 3 { slider c -> Cart d };
    }
    chain Plates {
        gravity = [0, -9.8, 0] m/s^2;
        results = poses;
        body Base { mass = 1 kg; com = [0, 0, 0] m; output = [1, 2, 3] m; inertia = diag(1, 1, 1) kg*m^2 about com; }
        body Plate { mass = 1 kg; com = [0, 0, 0] m; output = [0, 0, 0] m; inertia = diag(1, 1, 1) kg*m^2 about com; }
        body Flag { mass = 1 kg; com = [0.5, 0, 0] m; inertia = diag(1, 1, 1) kg*m^2 about com; }
        ground -> weld a -> Base b -> repeat 3 { weld c -> Plate d } -> pin e -> Flag f;
    }
}

/// A number on which no acceleration depends is still tested, in every repetition.
#[test]
fn unused_values_that_are_not_finite_are_found() {
    let carts = Carts::<f64>::new();
    let inputs = carts.no_inputs();
    for place in 0..4 {
        let mut wrong = [carts.initial_state(), carts.initial_state()];
        wrong[0].coordinates_mut()[place] = f64::NAN;
        wrong[1].rates_mut()[place] = f64::INFINITY;
        let origins = [Origin::Coordinate(place), Origin::Rate(place)];
        for (state, origin) in wrong.into_iter().zip(origins) {
            let refused = Error::NotFinite(origin);
            assert_eq!(carts.accelerations(&state, &inputs), Err(refused), "{place}");
            let mut at = carts.workspace();
            assert_eq!(carts.solve_into(&state, &inputs, &mut at), Err(refused), "{place}");
        }
    }
    let state = carts.initial_state();
    assert_eq!(carts.accelerations(&state, &inputs).map(|a| a.norm()), Ok(0.0));
}

/// Poses that are the same in every state are those of every repetition.
#[test]
fn poses_that_never_change_are_those_of_all_repetitions() {
    let plates = Plates::<f64>::new();
    let mut at = plates.workspace();
    let state = plates.initial_state();
    plates.solve_into(&state, &plates.no_inputs(), &mut at).expect("a regular chain");
    for index in 0..3 {
        let plate = at.d(index).expect("three plates");
        for point in [plate.input(), plate.output()] {
            assert_eq!(point.position().as_slice(), [1.0, 2.0, 3.0], "{index}");
        }
    }
    assert_eq!(at.f().input().position().as_slice(), [1.0, 2.0, 3.0]);
    assert_eq!(at.b().input().position().as_slice(), [0.0; 3]);
}
