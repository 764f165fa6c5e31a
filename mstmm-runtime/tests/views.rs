//! Views of hinges, connection points and errors: what goes in comes out, in the documented frames
//! and orders.

use mstmm_runtime::nalgebra::{Rotation3, UnitQuaternion, Vector3};
use mstmm_runtime::{
    BallState, BallStateMut, BodyResult, Error, FloatingState, FloatingStateMut, HingeResult,
    PinState, PinStateMut, Point, StateVector,
};

const ANGLES: [f64; 3] = [0.4, -0.7, 1.9];

/// A = A_z A_y A_x, of elementary rotations.
fn bryan(angles: [f64; 3]) -> Rotation3<f64> {
    let [x, y, z] = angles;
    let about = |axis, angle| Rotation3::from_axis_angle(&axis, angle);
    about(Vector3::z_axis(), z) * about(Vector3::y_axis(), y) * about(Vector3::x_axis(), x)
}

#[test]
fn pin() {
    let (mut q, mut v) = ([0.0f32; 2], [0.0f32; 2]);
    PinStateMut::new(&mut q[1], &mut v[0]).set_angle(0.5).set_rate(-2.0);
    assert_eq!((q, v), ([0.0, 0.5], [-2.0, 0.0]));
    let view = PinState::new(q[1], v[0]);
    assert_eq!((view.angle(), view.rate()), (0.5, -2.0));
}

#[test]
fn ball() {
    let (mut q, mut v) = ([0.0f64; 4], [0.0f64; 3]);
    let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), core::f64::consts::FRAC_PI_2);
    BallStateMut::new(q.each_mut(), v.each_mut())
        .set_orientation(turn)
        .set_rate(Vector3::new(1.0, 2.0, 3.0));
    assert_eq!(q, [turn.w, 0.0, 0.0, turn.k]);
    assert_eq!(v, [1.0, 2.0, 3.0]);
    let view = BallState::new(q, v);
    assert_eq!(view.orientation(), turn);
    assert_eq!(view.rate(), Vector3::new(1.0, 2.0, 3.0));
    // Outboard x points along inboard y.
    assert!((view.orientation() * Vector3::x() - Vector3::y()).norm() < 1e-15);
}

#[test]
fn bryan_angles_are_those_of_the_paper() {
    let (mut q, mut v) = ([0.0f64; 4], [0.0f64; 3]);
    BallStateMut::new(q.each_mut(), v.each_mut()).set_bryan_angles(ANGLES);
    let orientation = BallState::new(q, v).orientation();
    assert!((orientation.to_rotation_matrix().matrix() - bryan(ANGLES).matrix()).norm() < 1e-15);
    assert!((orientation.norm() - 1.0).abs() < 1e-15);
    let (x, y, z) = orientation.euler_angles();
    assert!([x, y, z].iter().zip(ANGLES).all(|(a, b)| (a - b).abs() < 1e-15));
}

#[test]
fn floating() {
    let (mut q, mut v) = ([0.0f64; 7], [0.0f64; 6]);
    let [x, y, z, a, b, c, d] = q.each_mut();
    let [vx, vy, vz, wx, wy, wz] = v.each_mut();
    FloatingStateMut::new([x, y, z], [a, b, c, d], [vx, vy, vz], [wx, wy, wz])
        .set_position(Vector3::new(1.0, 2.0, 3.0))
        .set_bryan_angles(ANGLES)
        .set_velocity(Vector3::new(4.0, 5.0, 6.0))
        .set_rate(Vector3::new(7.0, 8.0, 9.0));
    let [x, y, z, quaternion @ ..] = q;
    let [vx, vy, vz, rate @ ..] = v;
    let view = FloatingState::new([x, y, z], quaternion, [vx, vy, vz], rate);
    assert_eq!(view.position(), Vector3::new(1.0, 2.0, 3.0));
    assert_eq!(view.velocity(), Vector3::new(4.0, 5.0, 6.0));
    assert_eq!(view.rate(), Vector3::new(7.0, 8.0, 9.0));
    let expected = UnitQuaternion::from_rotation_matrix(&bryan(ANGLES));
    assert!(view.orientation().angle_to(&expected) < 1e-7);

    let [x, y, z, a, b, c, d] = q.each_mut();
    let [vx, vy, vz, wx, wy, wz] = v.each_mut();
    FloatingStateMut::new([x, y, z], [a, b, c, d], [vx, vy, vz], [wx, wy, wz])
        .set_orientation(expected);
    assert_eq!(q, [1.0, 2.0, 3.0, expected.w, expected.i, expected.j, expected.k]);
}

#[test]
fn points_and_results() {
    let z = StateVector::new([1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0], [10.0, 11.0, 12.0]);
    let all = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 1.0];
    assert_eq!(z.to_vector().as_slice(), all);

    let quarter = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let point = Point::new([0.1, 0.2, 0.3], quarter, [0.4, 0.5, 0.6], [0.7, 0.8, 0.9], z);
    assert_eq!(point.position(), Vector3::new(0.1, 0.2, 0.3));
    assert_eq!(point.velocity(), Vector3::new(0.4, 0.5, 0.6));
    assert_eq!(point.angular_velocity(), Vector3::new(0.7, 0.8, 0.9));
    assert_eq!(point.orientation() * Vector3::x(), Vector3::y());
    assert_eq!(*point.z(), z);
    assert_eq!(point.acceleration(), Vector3::new(1.0, 2.0, 3.0));
    assert_eq!(point.angular_acceleration(), Vector3::new(4.0, 5.0, 6.0));
    assert_eq!(point.moment(), Vector3::new(7.0, 8.0, 9.0));
    assert_eq!(point.force(), Vector3::new(10.0, 11.0, 12.0));

    let rest = Point::<f64>::default();
    assert_eq!(rest.orientation(), Rotation3::identity());
    assert_eq!(rest.force(), Vector3::zeros());

    let hinge = HingeResult::new(3.0, -1.0, &rest, &point);
    assert_eq!((hinge.acceleration(), hinge.effort()), (3.0, -1.0));
    assert_eq!((hinge.input(), hinge.output()), (&rest, &point));
    let body = BodyResult::new(&point, &rest);
    assert_eq!((body.input(), body.output()), (&point, &rest));
}

#[test]
fn errors_speak_plainly() {
    let told = |error: Error| error.to_string();
    assert_eq!(
        told(Error::Singular { hinge: "elbow" }),
        "nothing with inertia lies beyond hinge `elbow`"
    );
    assert_eq!(told(Error::NotFinite), "a coordinate, rate, input or time is not a finite number");
    let refused = Error::Parameter { name: "payload", reason: "must not be negative" };
    assert_eq!(told(refused), "`payload` must not be negative");
    assert_eq!(
        told(Error::StepTooSmall),
        "the tolerance cannot be reached: the step became too small"
    );
    assert_eq!(told(Error::OutsideStep), "the time lies outside the last step");
    let _: &dyn core::error::Error = &refused;
}
