//! Connection points and results: what goes in comes out, in the documented frames and orders.

use mstmm_runtime::generated::{PointSlots, locate_point};
use mstmm_runtime::nalgebra::{Rotation2, Rotation3, Vector2, Vector3};
use mstmm_runtime::{
    BodyPoint, BodyResult, HingeResult, LinePoint, LineStateVector, LoopClosure, PlanePoint,
    PlaneStateVector, Point, SpringResult, StateVector,
};

#[test]
fn points_in_space_and_results() {
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

    let hinge = HingeResult::new(3.0, -1.0, rest, point);
    assert_eq!((hinge.acceleration(), hinge.effort()), (3.0, -1.0));
    assert_eq!((hinge.input(), hinge.output()), (rest, point));
    let spring = SpringResult::new(0.5, -0.1, 3.0, Vector3::new(1.0, 2.0, 2.0));
    assert_eq!((spring.length(), spring.length_rate(), spring.tension()), (0.5, -0.1, 3.0));
    assert_eq!(spring.force(), Vector3::new(1.0, 2.0, 2.0));
    let body: BodyResult<f64> = BodyResult::new(point, rest, [1.0, 2.0, 3.0]);
    assert_eq!((body.input(), body.output()), (point, rest));
    let com = body.com();
    assert_eq!(com, BodyPoint::new(point, [1.0, 2.0, 3.0]));
    let arm = Vector3::new(-2.0, 1.0, 3.0);
    assert_eq!(com.position(), point.position() + arm);
    assert_eq!(com.orientation(), point.orientation());
    let omega = point.angular_velocity();
    assert_eq!(com.angular_velocity(), omega);
    assert!((com.velocity() - (point.velocity() + omega.cross(&arm))).norm() < 1e-14);
    let turning = point.angular_acceleration();
    assert_eq!(com.angular_acceleration(), turning);
    let felt = turning.cross(&arm) + omega.cross(&omega.cross(&arm));
    assert!((com.acceleration() - (point.acceleration() + felt)).norm() < 1e-13);
}

#[test]
fn points_in_the_plane() {
    let z = PlaneStateVector::new([1.0, 2.0], 3.0, 4.0, [5.0, 6.0]);
    assert_eq!(z.to_vector().as_slice(), [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 1.0]);

    let turn = Rotation2::new(0.3);
    let point = PlanePoint::new([0.1, 0.2], [turn[(0, 0)], turn[(1, 0)]], [0.4, 0.5], 0.6, z);
    assert_eq!(point.position(), Vector2::new(0.1, 0.2));
    assert_eq!(point.orientation(), turn);
    assert_eq!(point.cos_sin(), (turn[(0, 0)], turn[(1, 0)]));
    assert_eq!(point.velocity(), Vector2::new(0.4, 0.5));
    assert_eq!(point.angular_velocity(), 0.6);
    assert_eq!(*point.z(), z);
    assert_eq!(point.acceleration(), Vector2::new(1.0, 2.0));
    assert_eq!(point.angular_acceleration(), 3.0);
    assert_eq!(point.moment(), 4.0);
    assert_eq!(point.force(), Vector2::new(5.0, 6.0));

    let rest = PlanePoint::<f64>::default();
    assert_eq!(rest.orientation(), Rotation2::identity());
    let body: BodyResult<f64, PlanePoint<f64>> = BodyResult::new(point, rest, [1.0, 2.0]);
    assert_eq!((body.input(), body.output()), (point, rest));
    let (com, arm) = (body.com(), turn * Vector2::new(1.0, 2.0));
    assert_eq!((com.orientation(), com.cos_sin()), (turn, point.cos_sin()));
    assert!((com.position() - (point.position() + arm)).norm() < 1e-15);
    let across = Vector2::new(-arm.y, arm.x);
    assert!((com.velocity() - (point.velocity() + 0.6 * across)).norm() < 1e-15);
    let felt = 3.0 * across - 0.36 * arm;
    assert!((com.acceleration() - (point.acceleration() + felt)).norm() < 1e-14);
    assert_eq!((com.angular_velocity(), com.angular_acceleration()), (0.6, 3.0));
    let hinge = HingeResult::new(Vector2::new(1.0, 2.0), Vector2::new(3.0, 4.0), point, rest);
    assert_eq!((hinge.input(), hinge.output()), (point, rest));
    assert_eq!(hinge.effort(), Vector2::new(3.0, 4.0));
}

#[test]
fn points_on_a_line() {
    let z = LineStateVector::new(1.0f32, 2.0);
    assert_eq!(z.to_vector().as_slice(), [1.0, 2.0, 1.0]);
    let point = LinePoint::new(0.1, 0.2, z);
    assert_eq!((point.position(), point.velocity()), (0.1, 0.2));
    assert_eq!((point.acceleration(), point.force()), (1.0, 2.0));
    assert_eq!(*point.z(), z);
    let rest = LinePoint::default();
    let hinge: HingeResult<f32, f32, LinePoint<f32>> = HingeResult::new(3.0, 4.0, point, rest);
    assert_eq!((hinge.acceleration(), hinge.effort()), (3.0, 4.0));
    let body: BodyResult<f32, LinePoint<f32>> =
        BodyResult::new(hinge.input(), hinge.output(), [0.5]);
    assert_eq!((body.input(), body.output()), (point, rest));
    let com = body.com();
    assert_eq!((com.position(), com.velocity(), com.acceleration()), (0.6, 0.2, 1.0));
}

#[test]
fn closures_report_redundant_directions() {
    let none = LoopClosure::<f64, 6>::default();
    assert_eq!((none.redundant(), none.undetermined()), (0, &[[0.0; 6]; 6]));
    let across = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    let loop_in_a_plane = LoopClosure::new([[0.0; 6], across], [0.0, 1.0]);
    assert_eq!(loop_in_a_plane.redundant(), 1);
    assert_eq!(loop_in_a_plane.undetermined(), &[[0.0; 6], across]);
}

/// A quarter turn about z; what is felt at rest is subtracted; place 0 is a vector of zeros.
#[test]
fn points_are_read_off_shared_numbers() {
    let numbers = [
        0.1, 0.2, 0.3, 0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 4.0, 5.0, 6.0, -1.0, -2.0,
        -3.0,
    ];
    let turned = [4, 7, 10];
    let places = PointSlots::new(
        1,
        turned,
        [(turned, 13), ([0; 3], 16), ([0; 3], 13), (turned, 0), (turned, 16), ([0; 3], 1)],
    );
    let point = Point::<f64>::read(&numbers, Some(&places), [0.0, 9.0, 1.0]);
    assert_eq!(point.position(), Vector3::new(0.1, 0.2, 0.3));
    assert_eq!(point.orientation() * Vector3::x(), Vector3::y());
    assert_eq!(point.orientation() * Vector3::z(), Vector3::z());
    assert_eq!(point.velocity(), Vector3::new(-5.0, 4.0, 6.0));
    assert_eq!(point.angular_velocity(), Vector3::new(-1.0, -2.0, -3.0));
    assert_eq!(point.acceleration(), Vector3::new(4.0, -4.0, 5.0));
    assert_eq!(point.angular_acceleration(), Vector3::zeros());
    assert_eq!(point.moment(), Vector3::new(2.0, -1.0, -3.0));
    assert_eq!(point.force(), Vector3::new(0.1, 0.2, 0.3));
    assert_eq!(Point::<f64>::read(&numbers, None, [0.0; 3]), Point::default());

    let (turned, straight) = ([4], [0]);
    let vectors =
        [(turned, 13), (straight, 15), (straight, 16), (straight, 14), (straight, 18), (turned, 1)];
    let flat = PointSlots::new(1, turned, vectors);
    let point = PlanePoint::<f64>::read(&numbers, Some(&flat), [1.0, 2.0]);
    assert_eq!(point.cos_sin(), (0.0, 1.0));
    assert_eq!(point.velocity(), Vector2::new(-5.0, 4.0));
    assert_eq!((point.angular_velocity(), point.angular_acceleration()), (6.0, 5.0));
    assert_eq!(point.acceleration(), Vector2::new(-2.0, -4.0));
    assert_eq!((point.moment(), point.force()), (-3.0, Vector2::new(-0.2, 0.1)));

    let line = PointSlots::new(2, [], [([], 13), ([], 14), ([], 18)]);
    let point = LinePoint::<f64>::read(&numbers, Some(&line), [1.0]);
    assert_eq!((point.position(), point.velocity()), (0.2, 4.0));
    assert_eq!((point.acceleration(), point.force()), (4.0, -3.0));
}

/// Two points once, three of a part that stands twice, one behind: with five numbers, seven, and two.
#[test]
fn points_of_repeated_parts_have_their_numbers_time_by_time() {
    let pieces = [[0, 2, 0, 2, 0, 5], [2, 3, 2, 6, 5, 7], [5, 1, 8, 1, 19, 2]];
    let numbers: Vec<usize> = (0..21).collect();
    let found: Vec<(usize, usize)> = (0..9)
        .map(|index| locate_point(&numbers, &pieces, index))
        .map(|(model, rest)| (model, rest[0]))
        .collect();
    let expected = [(0, 0), (1, 0), (2, 5), (3, 5), (4, 5), (2, 12), (3, 12), (4, 12), (5, 19)];
    assert_eq!(found, expected);
    assert!(locate_point(&numbers, &pieces, 9).1.is_empty());
}
