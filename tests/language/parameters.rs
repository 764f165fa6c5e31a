//! Numbers that change at run time.

use mstmm::{Error, mstmm_chain};

const HALF: f64 = 0.5;

mstmm_chain! {
    chain Lift {
        gravity = [0, -10, 0] m/s^2;
        param load = 0.5 kg;
        param arm = 500 mm;
        param tilt = 30 deg;
        param ratio = 2 * HALF;
        body Beam {
            mass = 1 kg + load;
            com = [arm, 0, 0];
            output = [2 * arm, 0, 0] turned rpy(0, 0, tilt);
            inertia = diag(2 kg*m^2, ratio * (1 kg*m^2), load * (2 m^2)) about com;
        }
        ground -> pin hub -> Beam beam -> pin wrist -> Beam tip;
        hinge hub { start = -tilt; start_rate = ratio rpm; torque = ratio * (3 N*m); }
    }

    // The same with the parameters' other values written in.
    chain Loaded {
        gravity = [0, -10, 0] m/s^2;
        body Beam {
            mass = 3 kg;
            com = [250 mm, 0, 0];
            output = [0.5, 0, 0] m turned rpy(0, 0, 45) deg;
            inertia = diag(2, 3, 4) kg*m^2 about com;
        }
        ground -> pin hub -> Beam beam -> pin wrist -> Beam tip;
        hinge hub { start = -45 deg; start_rate = 3 rpm; torque = 9 N*m; }
    }
}

#[test]
fn parameters_have_defaults_in_si_units() {
    let lift = Lift::<f64>::new();
    let parameters = lift.parameters();
    assert_eq!(
        [parameters.load(), parameters.arm(), parameters.tilt(), parameters.ratio()],
        [0.5, 0.5, 30_f64.to_radians(), 1.0]
    );
    assert_eq!(lift, Lift::default());
}

#[test]
fn a_parameter_is_as_good_as_its_number() {
    let (mut lift, loaded) = (Lift::<f64>::new(), Loaded::<f64>::new());
    lift.set_load(2.0).expect("a positive mass");
    lift.set_arm(0.25).expect("a finite length");
    lift.set_tilt(45_f64.to_radians()).expect("a finite angle");
    lift.set_ratio(3.0).expect("a finite number");
    let (a, b) = (lift.initial_state(), loaded.initial_state());
    crate::assert_close(a.q, b.q);
    crate::assert_close(a.v, b.v);
    let accelerations = lift.accelerations(&a, &lift.no_inputs()).expect("a regular chain");
    let expected = loaded.accelerations(&b, &loaded.no_inputs()).expect("a regular chain");
    crate::assert_close(accelerations, expected);
}

#[test]
fn a_parameter_that_is_refused_changes_nothing() {
    let mut lift = Lift::<f64>::new();
    let reason = "must leave the mass of body `beam` positive";
    assert_eq!(lift.set_load(-1.0), Err(Error::InvalidParameter { name: "load", reason }));
    let reason = "must be a finite number";
    assert_eq!(lift.set_arm(f64::NAN), Err(Error::InvalidParameter { name: "arm", reason }));
    assert_eq!(lift, Lift::new());
}

mstmm_chain! {
    plane chain Door {
        param inertia = 0.1 kg*m^2;
        param widest = 1 rad;
        body Leaf { mass = 1 kg; com = [0.5, 0] m; inertia = inertia about com; }
        ground -> pin edge -> Leaf leaf;
        hinge edge { limits = [0, widest]; limit_stiffness = 100 N*m/rad; }
    }
}

#[test]
fn parameters_leave_moments_and_limits_in_order() {
    let mut door = Door::<f64>::new();
    let reason = "must leave the moments of inertia of body `leaf` not negative";
    assert_eq!(door.set_inertia(-0.2), Err(Error::InvalidParameter { name: "inertia", reason }));
    let reason = "must leave the width of the limits of hinge `edge` positive";
    assert_eq!(door.set_widest(-1.0), Err(Error::InvalidParameter { name: "widest", reason }));
    assert_eq!(door, Door::new());
    door.set_inertia(0.0).expect("a point mass");
    door.set_widest(2.0).expect("a wider door");
}

mstmm_chain! {
    chain Wrist {
        param widest = 1 rad;
        param tilt = -1;
        body Rod {
            mass = 1 kg; com = [0, 0, -0.5] m; output = [0, 0, -1] m; inertia = diag(0.1, 0.1, 0.05) kg*m^2 about com;
        }
        ground -> universal([1, 1, 0], [1, tilt, 0]) cross -> Rod arm -> ball joint -> Rod hand;
        hinge joint { limits = widest; limit_stiffness = 100 N*m/rad; }
    }
}

/// Refuses parallel axes and limits that no angle reaches.
macro_rules! wrists_keep_their_mobility {
    ($T:ident, $test:ident) => {
        #[test]
        fn $test() {
            use std::$T::consts::PI;
            let mut wrist = Wrist::<$T>::new();
            let reason = "must not leave the limits of hinge `joint` above 180 deg";
            let name = "widest";
            assert_eq!(wrist.set_widest(3.2), Err(Error::InvalidParameter { name, reason }));
            assert_eq!(wrist.set_widest(PI), Ok(()));
            let reason = "must not leave successive axes of hinge `cross` parallel";
            for tilt in [1.0, 1.0 + 1e-6] {
                let found = wrist.set_tilt(tilt);
                assert_eq!(found, Err(Error::InvalidParameter { name: "tilt", reason }));
            }
            for tilt in [1.0 + 1e-5, -1.0, 0.0] {
                assert_eq!(wrist.set_tilt(tilt), Ok(()));
            }
        }
    };
}

wrists_keep_their_mobility!(f64, wrists_keep_their_mobility);
wrists_keep_their_mobility!(f32, wrists_keep_their_mobility_in_single_precision);

mstmm_chain! {
    plane chain Links {
        param knot[2] = 0 kg;
        param sleeve[3] = 0 kg;
        param length = 1 m;
        body Bar { mass = 1 kg; com = [length / 2, 0]; output = [length, 0]; inertia = 0.1 kg*m^2 about com; }
        body Knot { mass = 1 kg + knot; com = [0.5, 0] m; output = [1, 0] m; inertia = 0.1 kg*m^2 about com; }
        body Sleeve { mass = 1 kg + sleeve; com = [0.5, 0] m; output = [1, 0] m; inertia = 0.1 kg*m^2 about com; }
        ground -> pin first -> Bar bar
            -> repeat 2 { pin a -> Knot b }
            -> repeat 2 { pin plain -> Bar own }
            -> repeat 3 { pin c -> Sleeve d }
            -> pin last -> Bar end;
        hinge first { torque = input; }
    }
}

/// Every repeated part keeps its derived values, whatever is between the parts.
#[test]
fn each_repeated_part_has_its_parameters() {
    let mut links = Links::<f64>::new();
    links.set_knot(|index| index as f64).expect("positive masses");
    links.set_sleeve(|index| 10.0 * index as f64).expect("positive masses");
    links.set_length(2.0).expect("a finite length");
    assert_eq!(links.parameters().knot(), &[0.0, 1.0]);
    assert_eq!(links.parameters().sleeve(), &[0.0, 10.0, 20.0]);
    let mut falling = links.initial_state();
    falling.v = Default::default();
    let inputs = LinksInputs { first: 1.0 };
    let turned = links.accelerations(&falling, &inputs).expect("regular");
    let copy = links.clone();
    links.set_sleeve(|_| 0.0).expect("positive masses");
    assert_ne!(links, copy);
    assert_ne!(links.accelerations(&falling, &inputs).expect("regular"), turned);
    links.set_sleeve(|index| 10.0 * index as f64).expect("positive masses");
    assert_eq!(links, copy);
}

/// Fields that are written at every step are public.
#[test]
fn states_and_inputs_are_written_by_field() {
    let links = Links::<f64>::new();
    let mut state = links.initial_state();
    state.q[0] = 0.5;
    state.v[1] = -1.0;
    state.t = 2.0;
    assert_eq!((state.first().angle(), state.t), (0.5, 2.0));
    let mut inputs = links.no_inputs();
    inputs.first = 3.0;
    let mut at = links.workspace();
    links.solve_into(&state, &inputs, &mut at).expect("regular");
    assert_eq!(at.first().effort(), 3.0);
}

/// Constants of a function serve a chain in it, and what the chain keeps of them is out of reach too.
#[test]
fn a_chain_in_a_function_has_parameters_and_constants() {
    const LENGTH: f64 = 0.25;
    mstmm_chain! {
        plane chain Local {
            gravity = [0, -9.8] m/s^2;
            param mass = 2 * LENGTH;
            body Rod { mass = mass * (1 kg); com = [LENGTH, 0]; inertia = 0 about com; }
            ground -> pin joint -> Rod rod;
        }
    }
    let mut local = Local::<f64>::new();
    let state = local.initial_state();
    let at_first = local.energy(&state);
    local.set_mass(3.0).expect("a positive mass");
    assert_eq!(local.parameters().mass(), 3.0);
    assert_eq!(local.energy(&state), at_first);
    let acceleration = local.accelerations(&state, &local.no_inputs()).expect("regular")[0];
    crate::assert_close([acceleration], [-9.8 / LENGTH]);
}

mstmm_chain! {
    line chain Train {
        param load = 1 kg;
        body Car { mass = 2 * load; }
        ground -> slider rail -> Car car;
    }
}

/// The chain keeps the inverse of the mass, which is infinite for a mass of zero: the reason is the mass.
#[test]
fn the_cause_of_an_infinite_value_is_reported() {
    let mut train = Train::<f64>::new();
    let reason = "must leave the mass of body `car` positive";
    assert_eq!(train.set_load(0.0), Err(Error::InvalidParameter { name: "load", reason }));
    let reason = "must leave all quantities derived from it finite";
    assert_eq!(train.set_load(1e308), Err(Error::InvalidParameter { name: "load", reason }));
    assert_eq!(train, Train::new());
}
