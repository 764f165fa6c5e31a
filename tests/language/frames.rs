//! Frames and tensors: where points are, how they are turned, and what an inertia is about.

use mstmm::mstmm_chain;
use mstmm::nalgebra::{Matrix3, Rotation3, Vector3};

/// A rod with a frame at its end, welded to a frame on the ground.
macro_rules! placed {
    ([$($ground:tt)*], [$($output:tt)*]) => {{
        mstmm_chain! {
            chain Placed {
                body Rod {
                    mass = 1;
                    com = [0, 0, 0];
                    output = $($output)*;
                    inertia = diag(1, 1, 1) about com;
                }
                body Load { mass = 1; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; }
                ground $($ground)* -> weld foot -> Rod rod -> pin joint -> Load load;
            }
        }
        let placed = Placed::<f64>::new();
        let mut at = placed.workspace();
        let state = placed.initial_state();
        placed.solve_into(&state, &placed.no_inputs(), &mut at).expect("a regular chain");
        let end = at.rod().output();
        (end.position(), end.orientation())
    }};
}

#[track_caller]
fn assert_turned(found: Rotation3<f64>, expected: Matrix3<f64>) {
    crate::assert_close(found.matrix().as_slice(), expected.as_slice());
}

#[test]
fn positions_are_whole_values() {
    let (position, orientation) = placed!([at [1, 2, 3] m], [[100, 0, 5] mm]);
    crate::assert_close(position, [1.1, 2.0, 3.005]);
    assert_turned(orientation, Matrix3::identity());
    let (position, _) = placed!([], [[1 m, 0, 5 mm]]);
    crate::assert_close(position, [1.0, 0.0, 0.005]);
}

/// Roll, pitch and yaw turn about fixed axes in this order: A = A_z A_y A_x.
#[test]
fn rpy_is_roll_pitch_yaw() {
    let [roll, pitch, yaw] = [20.0, -30.0, 50.0].map(f64::to_radians);
    let about = |axis, angle| Rotation3::from_axis_angle(&axis, angle);
    let expected = about(Vector3::z_axis(), yaw)
        * about(Vector3::y_axis(), pitch)
        * about(Vector3::x_axis(), roll);
    let (_, orientation) = placed!([], [[0, 0, 0] turned rpy(20, -30, 50) deg]);
    assert_turned(orientation, expected.into_inner());
    let (_, orientation) = placed!([turned rpy(20 deg, -30 deg, 50 deg)], [[0, 0, 0]]);
    assert_turned(orientation, expected.into_inner());
}

/// w, x, y, z, of any length.
#[test]
fn quaternions_turn() {
    let (_, orientation) = placed!([], [[0, 0, 0] turned quaternion(2, 2, 0, 0)]);
    assert_turned(orientation, Matrix3::new(1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0));
}

/// Outer frames turn the inner ones.
#[test]
fn frames_follow_each_other() {
    let (position, orientation) = placed!(
        [at [0, 0, 1] m turned rpy(0, 0, 90) deg],
        [[1, 0, 0] m turned quaternion(1, 0, 1, 0)]
    );
    crate::assert_close(position, [0.0, 1.0, 1.0]);
    // The new z axis is the old x axis, which lies along y.
    crate::assert_close(orientation * Vector3::z(), [0.0, 1.0, 0.0]);
    crate::assert_close(orientation * Vector3::x(), [0.0, 0.0, -1.0]);
}

/// One rod, its inertia written in four ways: 1/3 about its end is 1/12 about its middle.
#[test]
fn inertias_are_about_a_point() {
    macro_rules! accelerations {
        ($($inertia:tt)*) => {{
            mstmm_chain! {
                chain Pair {
                    gravity = [0, -9.81, 0] m/s^2;
                    body Rod {
                        mass = 12 kg;
                        com = [0.5, 0, 0] m;
                        output = [1, 0, 0] m;
                        inertia = $($inertia)*;
                    }
                    ground -> pin a -> Rod upper -> ball b -> Rod lower;
                    hinge a { start_rate = 1; }
                    hinge b { start = rpy(0.1, 0.2, 0.3); start_rate = [1, 2, 3] rad/s; }
                }
            }
            let pair = Pair::<f64>::new();
            pair.accelerations(&pair.initial_state(), &pair.no_inputs()).expect("a regular chain")
        }};
    }
    let expected = accelerations!(diag(0.1, 1, 1) kg*m^2 about com);
    crate::assert_close(accelerations!(diag(0.1, 4, 4) kg*m^2 about input), expected);
    crate::assert_close(accelerations!(tensor(0.1, 1, 1, 0, 0, 0) kg*m^2 about com), expected);
    let mixed = accelerations!(diag(1e5 kg*mm^2, 4 kg*m^2, 4 kg*m^2) about input);
    crate::assert_close(mixed, expected);
}

/// xx, yy, zz, xy, xz, yz, as the tensor has them: a plate turned by 45° about z.
#[test]
fn tensors_carry_their_products() {
    mstmm_chain! {
        chain Plate {
            body Turned { mass = 1; com = [0, 0, 0]; inertia = tensor(1.5, 1.5, 3, 0.5, 0, 0) about com; }
            Turned plate;
            body plate { start_rate = [1, 0, 0] rad/s; }
        }
        chain Mixed {
            body Turned { mass = 1; com = [0, 0, 0]; inertia = tensor(3, 4, 5, 0.1, 0.2, 0.3) about com; }
            Turned plate;
            body plate { start_rate = [1, 2, 4] rad/s; }
        }
    }
    let plate = Plate::<f64>::new();
    let state = plate.initial_state();
    assert_eq!(plate.energy(&state).kinetic, 0.75);
    // Euler: J ω̇ = −ω × J ω with J ω = (1.5, 0.5, 0) leads to ω̇_z = −0.5/3.
    let accelerations = plate.accelerations(&state, &plate.no_inputs()).expect("a regular chain");
    crate::assert_close([accelerations[5]], [-0.5 / 3.0]);
    let mixed = Mixed::<f64>::new();
    // ½ (3 + 4·4 + 5·16) + 0.1·2 + 0.2·4 + 0.3·8
    crate::assert_close([mixed.energy(&mixed.initial_state()).kinetic], [52.9]);
}
