//! Hinges: axes, start values, torques, ends and methods.

use mstmm::nalgebra::{UnitQuaternion, Vector3};
use mstmm::{ChainState, mstmm_chain};

/// The angular velocity of a body on a pin that turns with 1 rad/s.
macro_rules! turning {
    ($($pin:tt)*) => {{
        mstmm_chain! {
            chain Turning {
                body Disc { mass = 1; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; }
                ground -> $($pin)* axle -> Disc disc;
                hinge axle { start = 90 deg; start_rate = 1 rad/s; }
            }
        }
        let turning = Turning::<f64>::new();
        let mut at = turning.workspace();
        turning
            .solve_into(&turning.initial_state(), &turning.no_inputs(), &mut at)
            .expect("a regular chain");
        at.disc().input().angular_velocity()
    }};
}

#[test]
fn pins_rotate_about_their_axes() {
    crate::assert_close(turning!(pin(x)), [1.0, 0.0, 0.0]);
    crate::assert_close(turning!(pin(y)), [0.0, 1.0, 0.0]);
    crate::assert_close(turning!(pin(z)), [0.0, 0.0, 1.0]);
    crate::assert_close(turning!(pin), [0.0, 0.0, 1.0]);
    crate::assert_close(turning!(pin(-z)), [0.0, 0.0, -1.0]);
    let half = 0.5_f64.sqrt();
    crate::assert_close(turning!(pin([1, 1, 0])), [half, half, 0.0]);
    crate::assert_close(turning!(pin([0, -3, 4])), [0.0, -0.6, 0.8]);
}

/// A positive angle rotates the outboard side relative to the inboard side, right-handed.
#[test]
fn angles_are_right_handed() {
    mstmm_chain! {
        chain Crank {
            body Bar {
                mass = 1;
                com = [0, 0, 0];
                output = [1, 0, 0];
                inertia = diag(1, 1, 1) about com;
            }
            body Load { mass = 1; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; }
            ground -> pin crank -> Bar bar -> weld seam -> Load load;
            hinge crank { start = 90 deg; }
        }
    }
    let crank = Crank::<f64>::new();
    let mut at = crank.workspace();
    crank.solve_into(&crank.initial_state(), &crank.no_inputs(), &mut at).expect("a regular chain");
    crate::assert_close(at.bar().output().position(), [0.0, 1.0, 0.0]);
}

#[test]
fn balls_start_turned_and_driven() {
    mstmm_chain! {
        chain Ball {
            body Lump { mass = 1; com = [0, 0, 0]; inertia = diag(2, 4, 5) about com; }
            ground -> ball socket -> Lump lump;
            hinge socket {
                start = rpy(0, 0, 90) deg;
                start_rate = [0, 60, 0] rpm;
                torque = [1000, 0, 5] N*mm;
            }
        }
        chain Same {
            body Lump { mass = 1; com = [0, 0, 0]; inertia = diag(2, 4, 5) about com; }
            ground -> ball socket -> Lump lump;
            hinge socket { start = quaternion(1, 0, 0, 1); start_rate = [0, 1, 0] rev/s; torque = input; }
        }
    }
    let (ball, same) = (Ball::<f64>::new(), Same::<f64>::new());
    let (state, other) = (ball.initial_state(), same.initial_state());
    let quarter = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), std::f64::consts::FRAC_PI_2);
    crate::assert_close(state.socket().orientation().coords, quarter.coords);
    crate::assert_close(state.q, other.q);
    // In the frame of the body, which the torque is in too.
    crate::assert_close(state.socket().rate(), [0.0, std::f64::consts::TAU, 0.0]);
    let accelerations = ball.accelerations(&state, &ball.no_inputs()).expect("a regular chain");
    crate::assert_close(accelerations, [0.5, 0.0, 0.001]);
    let inputs = SameInputs { socket: [1.0, 0.0, 0.005].into() };
    let again = same.accelerations(&other, &inputs).expect("a regular chain");
    crate::assert_close(again, accelerations);
    crate::assert_close(same.accelerations(&other, &same.no_inputs()).expect("regular"), [0.0; 3]);
}

#[test]
fn a_chain_that_starts_and_ends_with_a_body_floats() {
    mstmm_chain! {
        chain Satellite {
            gravity = [0, 0, -2] m/s^2;
            body Hub {
                mass = 4;
                com = [0, 0, 0];
                output = [0, 0, 1];
                inertia = diag(1, 1, 1) about com;
            }
            body Mast { mass = 1; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; }
            Hub hub -> pin boom -> Mast mast;
            body hub {
                start = [1, 2, 3] m turned rpy(0, 90, 0) deg;
                start_velocity = [10, 0, 0] cm/s;
                start_rate = [0, 0, 90] deg/s;
            }
            hinge boom { start_rate = -90 deg/s; }
        }
    }
    let satellite = Satellite::<f64>::new();
    let state = satellite.initial_state();
    crate::assert_close(state.hub().position(), [1.0, 2.0, 3.0]);
    crate::assert_close(state.hub().velocity(), [0.1, 0.0, 0.0]);
    let mut at = satellite.workspace();
    satellite.solve_into(&state, &satellite.no_inputs(), &mut at).expect("a regular chain");
    // The body's z axis lies along x, and so does its rate; the mast does not turn.
    crate::assert_close(at.hub().output().position(), [2.0, 2.0, 3.0]);
    let quarter = std::f64::consts::FRAC_PI_2;
    crate::assert_close(at.hub().input().angular_velocity(), [quarter, 0.0, 0.0]);
    crate::assert_close(at.mast().input().angular_velocity(), [0.0; 3]);
    // Free fall: gravity is its acceleration.
    crate::assert_close(at.hub().input().acceleration(), [0.0, 0.0, -2.0]);
    crate::assert_close(at.boom().input().force(), [0.0; 3]);
}

/// The signs of z: the force +q and the moment −m at its input hold a body at rest.
#[test]
fn a_held_body_is_carried_by_its_input() {
    mstmm_chain! {
        chain Lamp {
            gravity = [0, -10, 0] m/s^2;
            body Rod {
                mass = 2 kg;
                com = [0.5, 0, 0] m;
                output = [1, 0, 0] m;
                inertia = diag(1, 1, 1) about com;
            }
            ground -> pin joint -> Rod rod;
            hinge joint { torque = 10 N*m; }
        }
        // The same, written from the free end: the rod's input is free, its output held.
        chain Turned {
            gravity = [0, -10, 0] m/s^2;
            body Rod {
                mass = 2 kg;
                com = [0.5, 0, 0] m;
                output = [1, 0, 0] m;
                inertia = diag(1, 1, 1) about com;
            }
            Rod rod -> pin joint -> ground at [1, 0, 0] m;
            hinge joint { torque = 10 N*m; }
        }
    }
    let lamp = Lamp::<f64>::new();
    let mut at = lamp.workspace();
    lamp.solve_into(&lamp.initial_state(), &lamp.no_inputs(), &mut at).expect("a regular chain");
    assert_eq!(at.joint().acceleration(), 0.0);
    assert_eq!(at.joint().effort(), 10.0);
    crate::assert_close(at.rod().input().force(), [0.0, 20.0, 0.0]);
    crate::assert_close(at.rod().input().moment(), [0.0, 0.0, -10.0]);
    crate::assert_close(at.rod().output().force(), [0.0; 3]);

    let turned = Turned::<f64>::new();
    let mut at = turned.workspace();
    turned
        .solve_into(&turned.initial_state(), &turned.no_inputs(), &mut at)
        .expect("a regular chain");
    assert_eq!(at.joint().acceleration(), 0.0);
    crate::assert_close(at.rod().output().force(), [0.0, -20.0, 0.0]);
    crate::assert_close(at.rod().output().moment(), [0.0, 0.0, -10.0]);
    crate::assert_close(at.rod().input().force(), [0.0; 3]);
}

/// The method does not change the results.
#[test]
fn methods_agree() {
    macro_rules! accelerations {
        ($($method:tt)*) => {{
            mstmm_chain! {
                chain Tail {
                    gravity = [0, -9.81, 0] m/s^2;
                    $($method)*
                    body Link {
                        mass = 1;
                        com = [0.5, 0, 0];
                        output = [1, 0, 0];
                        inertia = diag(1, 1, 1) about com;
                    }
                    ground -> pin(y) a -> Link one -> ball b -> Link two -> pin(z) c -> Link three;
                    hinge a { start = 1; start_rate = 1; }
                    hinge b { start = rpy(1, 0.5, 2); start_rate = [1, 2, 3]; }
                }
            }
            let tail = Tail::<f64>::new();
            tail.accelerations(&tail.initial_state(), &tail.no_inputs()).expect("a regular chain")
        }};
    }
    let cheapest = accelerations!();
    crate::assert_close(accelerations!(method = riccati;) / 100.0, cheapest / 100.0);
    crate::assert_close(accelerations!(method = transfer;) / 100.0, cheapest / 100.0);
}

/// Without gravity, start values and torques all is zero, and nothing moves.
#[test]
fn omitted_values_are_zero() {
    mstmm_chain! {
        chain Still {
            body Link {
                mass = 1;
                com = [0.5, 0, 0];
                output = [1, 0, 0];
                inertia = diag(1, 1, 1) about com;
            }
            ground -> pin a -> Link one -> ball b -> Link two;
        }
    }
    let still = Still::<f64>::new();
    let state = still.initial_state();
    assert_eq!(state, StillState::zero_position());
    let accelerations = still.accelerations(&state, &still.no_inputs()).expect("a regular chain");
    crate::assert_close(accelerations, [0.0; 4]);
}
