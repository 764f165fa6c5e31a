//! Views of hinges: what goes in comes out, in the documented frames and orders.

use mstmm_runtime::nalgebra::{Rotation3, UnitQuaternion, Vector2, Vector3, Vector6};
use mstmm_runtime::{
    BallState, BallStateMut, CylindricalState, CylindricalStateMut, ElasticState, ElasticStateMut,
    FloatingState, FloatingStateMut, GimbalState, GimbalStateMut, HingeMotion, PinState,
    PinStateMut, PlanarState, PlanarStateMut, PlaneElasticState, PlaneElasticStateMut, ScrewState,
    ScrewStateMut, SliderState, SliderStateMut, UniversalState, UniversalStateMut,
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
fn slider() {
    let (mut q, mut v) = ([0.0f32; 2], [0.0f32; 2]);
    SliderStateMut::new(&mut q[1], &mut v[0]).set_position(0.5).set_velocity(-2.0);
    assert_eq!((q, v), ([0.0, 0.5], [-2.0, 0.0]));
    let view = SliderState::new(q[1], v[0]);
    assert_eq!((view.position(), view.velocity()), (0.5, -2.0));
    assert_eq!(view.into_groups(), (0.5, -2.0));
}

#[test]
fn screw() {
    let (mut q, mut v) = ([0.0; 2], [0.0; 2]);
    ScrewStateMut::new(&mut q[1], &mut v[0]).set_angle(0.5).set_rate(-2.0);
    assert_eq!((q, v), ([0.0, 0.5], [-2.0, 0.0]));
    let view = ScrewState::new(q[1], v[0]);
    assert_eq!((view.angle(), view.rate()), (0.5, -2.0));
    assert_eq!(view.into_groups(), (0.5, -2.0));
}

#[test]
fn cylindrical() {
    let ([mut x, mut angle], [mut velocity, mut rate]) = ([0.0; 2], [0.0; 2]);
    CylindricalStateMut::new(&mut x, &mut angle, &mut velocity, &mut rate)
        .set_position(1.0)
        .set_angle(2.0)
        .set_velocity(3.0)
        .set_rate(4.0);
    assert_eq!([x, angle, velocity, rate], [1.0, 2.0, 3.0, 4.0]);
    let view = CylindricalState::new(x, angle, velocity, rate);
    assert_eq!((view.position(), view.angle()), (1.0, 2.0));
    assert_eq!((view.velocity(), view.rate()), (3.0, 4.0));
    assert_eq!(view.into_groups(), (1.0, 2.0, 3.0, 4.0));
}

#[test]
fn universal() {
    let (mut q, mut v) = ([0.0; 2], [0.0; 2]);
    UniversalStateMut::new(q.each_mut(), v.each_mut())
        .set_angles(Vector2::new(1.0, 2.0))
        .set_rates(Vector2::new(3.0, 4.0));
    assert_eq!((q, v), ([1.0, 2.0], [3.0, 4.0]));
    let view = UniversalState::new(q, v);
    assert_eq!(view.angles(), Vector2::new(1.0, 2.0));
    assert_eq!(view.rates(), Vector2::new(3.0, 4.0));
    assert_eq!(view.into_groups(), (q, v));
}

#[test]
fn gimbal() {
    let (mut q, mut v) = ([0.0; 3], [0.0; 3]);
    GimbalStateMut::new(q.each_mut(), v.each_mut())
        .set_angles(Vector3::new(1.0, 2.0, 3.0))
        .set_rates(Vector3::new(4.0, 5.0, 6.0));
    assert_eq!((q, v), ([1.0, 2.0, 3.0], [4.0, 5.0, 6.0]));
    let view = GimbalState::new(q, v);
    assert_eq!(view.angles(), Vector3::new(1.0, 2.0, 3.0));
    assert_eq!(view.rates(), Vector3::new(4.0, 5.0, 6.0));
    assert_eq!(view.into_groups(), (q, v));
}

#[test]
fn planar() {
    let (mut q, mut v) = ([0.0; 3], [0.0; 3]);
    let ([u, w, angle], [du, dw, rate]) = (q.each_mut(), v.each_mut());
    PlanarStateMut::new([u, w], angle, [du, dw], rate)
        .set_position(Vector2::new(1.0, 2.0))
        .set_angle(3.0)
        .set_velocity(Vector2::new(4.0, 5.0))
        .set_rate(6.0);
    assert_eq!((q, v), ([1.0, 2.0, 3.0], [4.0, 5.0, 6.0]));
    let view = PlanarState::new([1.0, 2.0], 3.0, [4.0, 5.0], 6.0);
    assert_eq!((view.position(), view.angle()), (Vector2::new(1.0, 2.0), 3.0));
    assert_eq!((view.velocity(), view.rate()), (Vector2::new(4.0, 5.0), 6.0));
    assert_eq!(view.into_groups(), ([1.0, 2.0], 3.0, [4.0, 5.0], 6.0));
}

#[test]
fn elastic() {
    let [mut displacement, mut angles, mut velocity, mut rate] = [[0.0; 3]; 4];
    ElasticStateMut::new(
        displacement.each_mut(),
        angles.each_mut(),
        velocity.each_mut(),
        rate.each_mut(),
    )
    .set_displacement(Vector3::new(1.0, 2.0, 3.0))
    .set_angles(Vector3::from(ANGLES))
    .set_velocity(Vector3::new(4.0, 5.0, 6.0))
    .set_rate(Vector3::new(7.0, 8.0, 9.0));
    let groups = ([1.0, 2.0, 3.0], ANGLES, [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]);
    assert_eq!((displacement, angles, velocity, rate), groups);
    let view = ElasticState::new(displacement, angles, velocity, rate);
    assert_eq!(view.displacement(), Vector3::new(1.0, 2.0, 3.0));
    assert_eq!(view.angles(), Vector3::from(ANGLES));
    assert_eq!(view.velocity(), Vector3::new(4.0, 5.0, 6.0));
    assert_eq!(view.rate(), Vector3::new(7.0, 8.0, 9.0));
    assert_eq!(view.into_groups(), groups);
}

#[test]
fn plane_elastic() {
    let (mut q, mut v) = ([0.0; 3], [0.0; 3]);
    let ([x, y, angle], [vx, vy, rate]) = (q.each_mut(), v.each_mut());
    PlaneElasticStateMut::new([x, y], angle, [vx, vy], rate)
        .set_displacement(Vector2::new(1.0, 2.0))
        .set_angle(3.0)
        .set_velocity(Vector2::new(4.0, 5.0))
        .set_rate(6.0);
    assert_eq!((q, v), ([1.0, 2.0, 3.0], [4.0, 5.0, 6.0]));
    let view = PlaneElasticState::new([1.0, 2.0], 3.0, [4.0, 5.0], 6.0);
    assert_eq!((view.displacement(), view.angle()), (Vector2::new(1.0, 2.0), 3.0));
    assert_eq!((view.velocity(), view.rate()), (Vector2::new(4.0, 5.0), 6.0));
    assert_eq!(view.into_groups(), ([1.0, 2.0], 3.0, [4.0, 5.0], 6.0));
}

#[test]
fn unspecified_rest_is_the_zero_position() {
    let (one, zero) = ([1.0, 0.0, 0.0, 0.0], [0.0; 3]);
    assert_eq!(PinState::default().into_groups(), (0.0, 0.0));
    assert_eq!(SliderState::default().into_groups(), (0.0, 0.0));
    assert_eq!(ScrewState::default().into_groups(), (0.0, 0.0));
    assert_eq!(CylindricalState::default().into_groups(), (0.0, 0.0, 0.0, 0.0));
    assert_eq!(UniversalState::default().into_groups(), ([0.0; 2], [0.0; 2]));
    assert_eq!(GimbalState::default().into_groups(), (zero, zero));
    assert_eq!(BallState::default().into_groups(), (one, zero));
    assert_eq!(PlanarState::default().into_groups(), ([0.0; 2], 0.0, [0.0; 2], 0.0));
    assert_eq!(FloatingState::default().into_groups(), (zero, one, zero, zero));
    assert_eq!(ElasticState::default().into_groups(), (zero, zero, zero, zero));
    assert_eq!(PlaneElasticState::default().into_groups(), ([0.0; 2], 0.0, [0.0; 2], 0.0));
    assert_eq!(BallState::<f64>::default().orientation(), UnitQuaternion::identity());
}

#[test]
fn prescribed_motions_are_views_with_accelerations() {
    let still = HingeMotion::<PinState<f64>, f64>::default();
    assert_eq!(still, HingeMotion { state: PinState::new(0.0, 0.0), acceleration: 0.0 });
    let frame = HingeMotion {
        state: FloatingState::new([1.0, 2.0, 3.0], [0.0, 0.0, 0.0, 1.0], [0.5; 3], [0.25; 3]),
        acceleration: Vector6::<f64>::repeat(0.125),
    };
    let copy = frame;
    assert_eq!(copy.state.position(), Vector3::new(1.0, 2.0, 3.0));
    let resting = HingeMotion::<FloatingState<f64>, Vector6<f64>>::default();
    assert_eq!(resting.acceleration, Vector6::zeros());
}
