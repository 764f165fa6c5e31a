//! Names of elements that the generated code has locals, fields or words of Rust of.

use mstmm::mstmm_chain;

mstmm_chain! {
    chain Odd {
        gravity = [0, -9.81, 0] m/s^2;
        body Rod {
            mass = 2;
            com = [1, 0, 0];
            output = [1, 0, 0];
            inertia = diag(1, 1, 1) about com;
        }
        ground -> pin c -> Rod t0 -> ball state -> Rod inputs -> pin zero -> Rod one
               -> weld at -> Rod value -> pin x -> Rod y -> ball none -> Rod self_
               -> pin input -> Rod output -> pin com -> Rod eq;
        hinge c, state, zero, x, none, input { torque = input; }
    }
    chain Plain {
        gravity = [0, -9.81, 0] m/s^2;
        body Rod {
            mass = 2;
            com = [1, 0, 0];
            output = [1, 0, 0];
            inertia = diag(1, 1, 1) about com;
        }
        ground -> pin hinge1 -> Rod body1 -> ball hinge2 -> Rod body2 -> pin hinge3 -> Rod body3
               -> weld hinge4 -> Rod body4 -> pin hinge5 -> Rod body5 -> ball hinge6 -> Rod body6
               -> pin hinge7 -> Rod body7 -> pin hinge8 -> Rod body8;
        hinge hinge1, hinge2, hinge3, hinge5, hinge6, hinge7 { torque = input; }
    }
}

#[test]
fn names_mean_nothing() {
    let (odd, plain) = (Odd::<f64>::new(), Plain::<f64>::new());
    let (mut a, mut b) = (odd.initial_state(), plain.initial_state());
    a.c_mut().set_angle(0.3).set_rate(-1.0);
    b.hinge1_mut().set_angle(0.3).set_rate(-1.0);
    a.state_mut().set_bryan_angles([0.1, 0.2, 0.3]);
    b.hinge2_mut().set_bryan_angles([0.1, 0.2, 0.3]);
    let a_inputs = OddInputs {
        c: 1.0,
        state: [1.0, 2.0, 3.0].into(),
        zero: 2.0,
        x: 3.0,
        none: [3.0, 2.0, 1.0].into(),
        input: 4.0,
    };
    let b_inputs = PlainInputs {
        hinge1: 1.0,
        hinge2: [1.0, 2.0, 3.0].into(),
        hinge3: 2.0,
        hinge5: 3.0,
        hinge6: [3.0, 2.0, 1.0].into(),
        hinge7: 4.0,
    };
    assert_eq!(odd.accelerations(&a, &a_inputs), plain.accelerations(&b, &b_inputs));
    let (mut a_at, mut b_at) = (odd.workspace(), plain.workspace());
    odd.solve_into(&a, &a_inputs, &mut a_at).expect("a regular chain");
    plain.solve_into(&b, &b_inputs, &mut b_at).expect("a regular chain");
    assert_eq!(a_at.points(), b_at.points());
    crate::assert_close(a_at.none().effort(), [3.0, 2.0, 1.0]);
}

// Parameters and hinges whose names would collide with those of the generated code, or with each other in
// lower case and in normal form.
mstmm_chain! {
    plane chain PlainRepeat {
        param damping1 = 0.5;
        param stiffness1 = 0.25;
        param damping2[3] = 0.125;
        body R { mass = 1; com = [0.3, 0.1]; inertia = 0.2 about com; output = [1, 0]; }
        ground -> repeat 3 { pin hinge1 -> R body1 -> pin hinge2 -> R body2 };
        hinge hinge1 { damping = damping1; stiffness = stiffness1; torque = input; }
        hinge hinge2 { damping = damping2; }
    }
    chain OddTop {
        param turn_x_x = 0.5;
        param a_input = 0.25;
        param a_input_2 = 0.125;
        param j_xx = 0.1;
        body S {
            mass = 1;
            com = [0.3, 0.1, 0.2];
            inertia = diag(1, 1.1, 1.2) about com;
            output = [1, 0, 0];
        }
        ground -> ball known_a -> S r -> ball H̱ -> S known -> ball ẖ -> S u;
        hinge known_a { damping = a_input; torque = input; }
        hinge H̱ { damping = a_input_2 + turn_x_x; torque = input; }
        hinge ẖ { damping = j_xx; torque = input; }
    }
    chain PlainTop {
        param damping1 = 0.25;
        param damping2 = 0.125;
        param damping3 = 0.1;
        param damping4 = 0.5;
        body S {
            mass = 1;
            com = [0.3, 0.1, 0.2];
            inertia = diag(1, 1.1, 1.2) about com;
            output = [1, 0, 0];
        }
        ground -> ball hinge1 -> S body1 -> ball hinge2 -> S body2 -> ball hinge3 -> S body3;
        hinge hinge1 { damping = damping1; torque = input; }
        hinge hinge2 { damping = damping2 + damping4; torque = input; }
        hinge hinge3 { damping = damping3; torque = input; }
    }
    plane chain OddPendulum {
        param a_ang_z = 0.5;
        param v1 = 0.25;
        gravity = [0, -9];
        body R { mass = 1; com = [0.3, 0.1]; inertia = 0.2 about com; output = [1, 0]; }
        ground -> pin known -> R r -> pin known_ -> R s;
        hinge known, known_ { damping = a_ang_z; stiffness = v1; }
    }
    plane chain PlainPendulum {
        param damping1 = 0.5;
        param stiffness1 = 0.25;
        gravity = [0, -9];
        body R { mass = 1; com = [0.3, 0.1]; inertia = 0.2 about com; output = [1, 0]; }
        ground -> pin hinge1 -> R body1 -> pin hinge2 -> R body2;
        hinge hinge1, hinge2 { damping = damping1; stiffness = stiffness1; }
    }
}

/// A chain named after a type that the generated code has.
mod primitive {
    #![allow(non_camel_case_types)]

    mstmm::mstmm_chain! {
        pub plane chain usize {
            param a_input = 0.5;
            param o0 = 0.25;
            param o1_0[3] = 0.125;
            body R { mass = 1; com = [0.3, 0.1]; inertia = 0.2 about com; output = [1, 0]; }
            ground -> repeat 3 { pin known_a -> R r -> pin usize -> R bool };
            hinge known_a { damping = a_input; stiffness = o0; torque = input; }
            hinge usize { damping = o1_0; }
        }
    }
}

/// Chains named after primitive types, and next to types of such names, with the constants and types of all answers.
mod primitives {
    #![allow(non_camel_case_types)]

    /// Shadows the primitive type.
    pub struct usize;

    /// Shadows the primitive type.
    pub struct bool;

    mstmm::mstmm_chain! {
        pub plane chain str {
            answers = [basic, derivatives, linearize, jacobian, regressor];
            param mass = 1 kg;
            body R { mass = mass; com = [0.3, 0.1]; inertia = 0.2 about com; output = [1, 0]; }
            ground -> pin a -> R r -> pin b -> R s;
        }
        pub plane chain f64 {
            answers = [basic, derivatives, linearize, momentum, kinematics, regressor];
            param mass[3] = 1 kg;
            body u32 { mass = mass; com = [0.3, 0.1]; inertia = 0.2 about com; output = [1, 0]; }
            ground -> repeat 3 { pin a -> u32 r };
        }
    }
}

#[test]
fn names_of_primitive_types_mean_nothing() {
    let _ = (primitives::usize, primitives::bool);
    let names = primitives::str::<f64>::DYNAMIC_PARAMETERS;
    assert_eq!(names.len(), 8);
    let base = primitives::str::<f64>::BASE_PARAMETERS;
    assert!(base.iter().all(|&index| index < names.len()), "{base:?}");
    let chain = primitives::f64::<f64>::new();
    assert_eq!(*chain.parameters().mass(), [1.0; 3]);
}

/// Constants and traits of the user, which generated code does not use.
mod around {
    #![allow(non_upper_case_globals, dead_code)]

    const f: u8 = 1;
    const state: u8 = 2;
    const at: u8 = 3;
    const index: u8 = 4;

    /// Its methods are found before those of other traits.
    trait Everywhere {
        fn get(&self) {}
        fn map(&self) {}
        fn copied(&self) {}
    }

    impl<X: ?Sized> Everywhere for X {}

    mstmm::mstmm_chain! {
        pub plane chain Short {
            answers = [basic, derivatives, linearize, push, pull, kinematics, momentum, regressor];
            param mass = 1 kg;
            body R { mass = mass; com = [0.3, 0.1]; inertia = 0.2 about com; output = [1, 0]; point tip = [1, 1]; }
            ground -> pin a -> R r -> pin b -> R s;
            load push { on = r.tip; force = input; }
            spring coil { on = s.tip; to = [2, 1]; stiffness = 2; }
            hinge a { torque = input; limits = [-1, 1]; limit_stiffness = 9; }
        }
        pub plane chain Long {
            answers = [basic, derivatives, linearize, push, pull, kinematics, momentum, regressor];
            param mass[3] = 1 kg;
            body R { mass = mass; com = [0.3, 0.1]; inertia = 0.2 about com; output = [1, 0]; point tip = [1, 1]; }
            ground -> repeat 3 { pin a -> R r };
            load push { on = r.tip; force = input; }
            hinge a { torque = input; damping = 0.1; }
        }
        pub chain Closed {
            body R { mass = 1; com = [0.3, 0.1, 0]; inertia = diag(0.2, 0.2, 0.3) about com; output = [1, 0, 0]; }
            ground -> ball a -> R r -> pin(z) b -> R s -> ball c -> ground at [1, 1, 0];
            hinge a { start = rpy(10, 20, 30) deg; }
            hinge b { start = 90 deg; }
        }
    }
}

/// Deprecated chains, whose own code uses them without a warning.
mod deprecated {
    #![deny(warnings)]

    mstmm::mstmm_chain! {
        #[deprecated]
        pub line chain Old {
            param mass = 1 kg;
            body Block { mass = mass; }
            ground -> slider rail -> Block block;
        }
        #[deprecated = "use another"]
        pub plane chain Older {
            answers = [basic, derivatives, linearize, jacobian, momentum, kinematics, regressor];
            body Rod { mass = 1; com = [0.3, 0.1]; inertia = 0.2 about com; point tip = [1, 0]; }
            ground -> pin joint -> Rod rod;
            load push { on = rod.tip; force = input; }
        }
    }
}

#[test]
#[expect(deprecated)]
fn deprecated_chains_are_used() {
    assert_eq!(deprecated::Old::<f64>::new().parameters().mass(), 1.0);
    assert_eq!(deprecated::Older::<f64>::new().initial_state().joint().angle(), 0.0);
}

/// The same state and inputs for both chains: what they compute has to be the same.
macro_rules! assert_same {
    ($odd:ident, $odd_inputs:expr, $plain:ident, $plain_inputs:expr) => {
        let (odd, plain) = ($odd::<f64>::new(), $plain::<f64>::new());
        let (mut a, mut b) = (odd.initial_state(), plain.initial_state());
        a.v.iter_mut().zip(1..).for_each(|(rate, k)| *rate = 0.3 - 0.1 * f64::from(k));
        a.q.iter_mut().zip(1..).for_each(|(coordinate, k)| *coordinate += 0.05 * f64::from(k));
        mstmm::Chain::normalize(&odd, &mut a);
        (b.q, b.v) = (a.q, a.v);
        let expected = plain.accelerations(&b, &$plain_inputs).expect("a regular chain");
        assert_eq!(odd.accelerations(&a, &$odd_inputs), Ok(expected));
        let (mut a_at, mut b_at) = (odd.workspace(), plain.workspace());
        odd.solve_into(&a, &$odd_inputs, &mut a_at).expect("a regular chain");
        plain.solve_into(&b, &$plain_inputs, &mut b_at).expect("a regular chain");
        assert_eq!(a_at.points(), b_at.points());
    };
}

#[test]
fn names_like_those_of_generated_code_mean_nothing() {
    use primitive::usize;
    let [a, b, c]: [nalgebra::Vector3<f64>; 3] =
        [[1.0, 2.0, 3.0], [0.5, -1.0, 2.0], [3.0, 2.0, 1.0]].map(Into::into);
    assert_same!(
        usize,
        primitive::usizeInputs { known_a: [3.0, 2.0, 1.0] },
        PlainRepeat,
        PlainRepeatInputs { hinge1: [3.0, 2.0, 1.0] }
    );
    assert_same!(
        OddTop,
        OddTopInputs { known_a: a, H̱: b, ẖ: c },
        PlainTop,
        PlainTopInputs { hinge1: a, hinge2: b, hinge3: c }
    );
    let (odd, plain) = (OddPendulum::<f64>::new(), PlainPendulum::<f64>::new());
    assert_same!(OddPendulum, odd.no_inputs(), PlainPendulum, plain.no_inputs());
}

mstmm_chain! {
    plane chain Pointed {
        param place_of_x = 0.5 m;
        body rod_type {
            mass = 2 kg;
            com = [1, 0] m;
            output = [1, 0] m;
            inertia = 1 kg*m^2 about com;
            point x = [place_of_x, 0];
            point place_of_x = [2, 0] m;
            point common_ = [3, 0] m;
            point deref = [4, 0] m;
            point new = [5, 0] m;
            point T = [6, 0] m;
            point TIP = [7, 0] m;
            point rod_type = [8, 0] m;
            point rod = [9, 0] m;
            point position = [10, 0] m;
        }
        ground -> pin joint -> rod_type rod -> pin hook -> rod_type rod_type;
    }
}

#[test]
fn names_of_points_mean_nothing() {
    let pointed = Pointed::<f64>::new();
    let mut at = pointed.workspace();
    let state = pointed.initial_state();
    pointed.solve_into(&state, &pointed.no_inputs(), &mut at).expect("a regular chain");
    let rod = at.rod();
    let points = [
        rod.x(),
        rod.place_of_x(),
        rod.common_(),
        rod.deref(),
        rod.new(),
        rod.T(),
        rod.TIP(),
        rod.rod_type(),
        rod.rod(),
        rod.position(),
    ];
    let found = points.map(|point| point.position().x);
    assert_eq!(found, [0.5, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0]);
    assert_eq!((rod.com().position().x, rod.output().position().x), (1.0, 1.0));
    assert_eq!(at.rod_type().rod().position().x, 10.0);
}
