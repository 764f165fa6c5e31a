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

// Chains that keep values in memory until they are needed again have names for places and references.
mstmm_chain! {
    chain OddSpills {
        gravity = [0, -9.81, 0] m/s^2;
        param Q = 2 kg;
        param place0 = 1 m;
        param derived = 1 kg*m^2;
        param V = 0.1 N*m*s;
        body Rod {
            mass = Q;
            com = [place0, 0, 0];
            output = [1, 0, 0];
            inertia = diag(derived, derived, derived) about com;
        }
        ground -> ball input -> Rod place1 -> ball qx -> Rod spill -> ball qx_again -> Rod room;
        hinge input, qx, qx_again { torque = input; damping = V; }
    }
    chain PlainSpills {
        gravity = [0, -9.81, 0] m/s^2;
        param mass1 = 2 kg;
        param length1 = 1 m;
        param inertia1 = 1 kg*m^2;
        param damping1 = 0.1 N*m*s;
        body Rod {
            mass = mass1;
            com = [length1, 0, 0];
            output = [1, 0, 0];
            inertia = diag(inertia1, inertia1, inertia1) about com;
        }
        ground -> ball hinge1 -> Rod body1 -> ball hinge2 -> Rod body2 -> ball hinge3 -> Rod body3;
        hinge hinge1, hinge2, hinge3 { torque = input; damping = damping1; }
    }
}

#[test]
fn names_of_spilled_values_mean_nothing() {
    let (odd, plain) = (OddSpills::<f64>::new(), PlainSpills::<f64>::new());
    let (mut a, mut b) = (odd.initial_state(), plain.initial_state());
    a.input_mut().set_bryan_angles([0.1, 0.2, 0.3]);
    b.hinge1_mut().set_bryan_angles([0.1, 0.2, 0.3]);
    a.qx_mut().set_bryan_angles([0.3, -0.2, 0.3]);
    b.hinge2_mut().set_bryan_angles([0.3, -0.2, 0.3]);
    let torques: [_; 3] = [[1.0, 2.0, 3.0].into(), [0.5, -1.0, 2.0].into(), [3.0, 2.0, 1.0].into()];
    let a_inputs = OddSpillsInputs { input: torques[0], qx: torques[1], qx_again: torques[2] };
    let b_inputs = PlainSpillsInputs { hinge1: torques[0], hinge2: torques[1], hinge3: torques[2] };
    assert_eq!(odd.accelerations(&a, &a_inputs), plain.accelerations(&b, &b_inputs));
}
