//! Ends of springs and axes of hinges, compared with the lengths and forces of springs and with velocities of points.

use super::models::{Crawler, FourBar, Kinds, Raft, Rope, Train};
use super::results::solved;
use mstmm::description::{HingeAxis, SpringEnd};
use mstmm::nalgebra::{Matrix3, Vector3};
use mstmm::{ChainState, Described, mstmm_chain};

mstmm_chain! {
    /// Springs between repetitions and between parts, whose ends depend on parameters; axes that depend on parameters.
    chain Tied {
        gravity = [0, 0, -9.8] m/s^2;
        param reach[3] = 0.1 m;
        param hook = 0.3 m;
        param tilt = 0.2;
        param lean = 0.4;
        body Link {
            mass = 1 kg; com = [0.3, 0, 0] m; output = [0.6, 0, 0] m; inertia = diag(0.1, 0.2, 0.15) kg*m^2 about com;
            point eye = [0.4 m, (2 * reach), 0.1 m];
        }
        body Root {
            mass = 1 kg; com = [0.3, 0, 0] m; output = [0.6, 0, 0] m; inertia = diag(0.1, 0.2, 0.15) kg*m^2 about com;
            point eye = [0 m, 0.1 m, hook];
        }
        ground -> pin([0, tilt, 1]) base -> Root root
            -> repeat 3 from link.eye = root.eye { universal([1, lean, 0], z) joint -> Link link }
            -> slider(x) rail -> Root tip -> gimbal([0, lean, 1], y, x) mount -> Root end;
        hinge base { start_rate = 1; }
        spring stay { on = link; at = [0.1 m, reach, 0 m]; to = last.link.eye; stiffness = 30; }
        spring rope { on = link.com; to = root.eye; stiffness = 10; }
        spring cord { on = tip; at = com; to = [1 m, hook, 2 m]; stiffness = 20; damping = 3; length = 0.5 m; }
    }
}

/// Returns position and orientation of a connection point.
fn pose<C: Described<Scalar = f64>>(
    at: &C::Workspace,
    point: usize,
) -> (Vector3<f64>, Matrix3<f64>) {
    let point = C::point(at, point).expect("a point");
    let rows = point.orientation.expect("an orientation");
    let rotation = Matrix3::from_fn(|row, column| rows[row][column]);
    (point.position.expect("a position").into(), rotation)
}

/// Returns an end of a spring in inertial axes.
fn place<C: Described<Scalar = f64>>(at: &C::Workspace, end: &SpringEnd<f64>) -> Vector3<f64> {
    let Some(body) = end.body else { return end.position };
    let name = C::DESCRIPTION.bodies().get(body).expect("a body").name();
    let input = C::DESCRIPTION.point(&format!("{name}.input")).expect("an input");
    let (position, rotation) = pose::<C>(at, input);
    position + rotation * end.position
}

/// The distance between the ends of each spring is its length, and its force, which acts on the end `on`, points from
/// there to the other end. Positions are of the order of ten metres, sums of twenty terms at most.
fn ends_have_the_length_of_springs<C: Described<Scalar = f64>>(chain: &C) {
    let (_, at) = solved(chain);
    let count = C::DESCRIPTION.springs().len();
    for index in 0..count {
        let name = C::DESCRIPTION.springs().get(index).expect("a spring").name();
        let [on, to] = chain.spring_ends(index).expect("ends").map(|end| place::<C>(&at, &end));
        let spring = C::spring(&at, index).expect("a spring");
        let between = to - on;
        assert!((between.norm() - spring.length()).abs() < 1e-13, "{name}: {between}");
        let force = between * (spring.tension() / spring.length());
        let error = (force - Vector3::from(spring.force())).norm();
        assert!(
            spring.tension() != 0.0 && error < 1e-12 * force.norm().max(1.0),
            "{name}: {error:e}"
        );
    }
    assert!(chain.spring_ends(count).is_none());
}

#[test]
fn springs_end_where_their_lengths_say() -> Result<(), mstmm::Error> {
    ends_have_the_length_of_springs(&Kinds::new());
    ends_have_the_length_of_springs(&Crawler::new());
    let mut tied = Tied::new();
    ends_have_the_length_of_springs(&tied);
    tied.set_reach(|index| 0.3 - 0.2 * index as f64)?;
    tied.set_hook(-0.7)?;
    ends_have_the_length_of_springs(&tied);
    let [on, to] = tied
        .spring_ends(Tied::<f64>::DESCRIPTION.spring("stay[2]").expect("a spring"))
        .expect("the last spring `stay`");
    let body = |name| Tied::<f64>::DESCRIPTION.body(name);
    assert_eq!((on.body, to.body), (body("link[2]"), body("link[1]")));
    assert_eq!(on.position, Vector3::new(0.1, 0.3 - 0.2 * 2.0, 0.0));
    let [on, to] = tied.spring_ends(0).expect("the first spring `stay`");
    assert_eq!((on.body, to.body), (body("link[0]"), body("root")));
    let rope = Tied::<f64>::DESCRIPTION.spring("rope[1]").expect("a spring");
    let [on, to] = tied.spring_ends(rope).expect("ends");
    assert_eq!((on.body, to.body), (body("link[1]"), body("root")));
    assert_eq!(to.position, Vector3::new(0.0, 0.1, -0.7));
    Ok(())
}

/// Returns velocity and angular velocity of a hinge's output relative to its input, whose frame moves on to the output:
/// `v = v_O − v_I − ω_I × (r_O − r_I)`.
fn relative<C: Described<Scalar = f64>>(
    at: &C::Workspace,
    [input, output]: [usize; 2],
) -> [Vector3<f64>; 2] {
    let [from, to] = [input, output].map(|point| C::point(at, point).expect("a point"));
    let vector = |vector: Option<[f64; 3]>| Vector3::from(vector.expect("a vector"));
    let turning = vector(from.angular_velocity);
    let arm = vector(to.position) - vector(from.position);
    [
        vector(to.velocity) - vector(from.velocity) - turning.cross(&arm),
        vector(to.angular_velocity) - turning,
    ]
}

/// The relative motion at each hinge with axes is along its axes, with its rates: of pins, sliders, screws, cylindrical and
/// universal hinges, and gimbals; of a planar hinge the rotation. Returns the names of the hinges with axes.
fn axes_are_those_of_the_motion<C: Described<Scalar = f64>>(chain: &C) -> Vec<String> {
    let (it, (state, at)) = (C::DESCRIPTION, solved(chain));
    let mut found = Vec::new();
    for (index, hinge) in it.hinges().iter().enumerate() {
        let axes: Vec<HingeAxis<f64>> = (0..hinge.axis_count())
            .map(|axis| chain.hinge_axis(index, axis).expect("an axis"))
            .collect();
        assert!(chain.hinge_axis(index, axes.len()).is_none());
        let directions: Vec<Vector3<f64>> =
            axes.iter().map(|axis| pose::<C>(&at, axis.point).1 * axis.direction).collect();
        assert!(directions.iter().all(|direction| (direction.norm() - 1.0).abs() < 1e-14));
        let (Some(points), [along, others @ ..]) = (it.points_of_hinge(index), &directions[..])
        else {
            continue;
        };
        found.push(format!("{} {}", hinge.keyword(), hinge.name()));
        let rates = &state.rates()[it.rates_of(index).expect("rates")];
        let [linear, angular] = relative::<C>(&at, points);
        let close = |found: Vector3<f64>, expected: Vector3<f64>| {
            assert!(
                (found - expected).norm() < 1e-12,
                "{}: {found} is not {expected}",
                hinge.name()
            );
        };
        match (hinge.keyword(), rates, others) {
            (_, [], _) => close(angular, along * along.dot(&angular)),
            ("pin", [rate], _) => close(angular, along * *rate),
            ("slider", [rate], _) => close(linear, along * *rate),
            ("screw", [rate], _) => {
                close(angular, along * *rate);
                close(linear, along * along.dot(&linear));
            }
            ("cylindrical", [velocity, rate], _) => {
                close(linear, along * *velocity);
                close(angular, along * *rate);
            }
            ("universal", [first, second], [other]) => {
                close(angular, along * *first + other * *second);
            }
            ("gimbal", [first, second, third], [other]) => {
                // The axis between them is perpendicular to the last one here.
                let between = angular - along * *first - other * *third;
                assert!(
                    (between.norm() - second).abs() < 1e-12 && between.dot(other).abs() < 1e-12
                );
            }
            ("planar", [.., rate], _) => {
                close(angular, along * *rate);
                assert!(along.dot(&linear).abs() < 1e-12);
            }
            (keyword, ..) => panic!("{keyword} has axes"),
        }
    }
    found
}

#[test]
fn axes_are_those_that_hinges_move_along() -> Result<(), mstmm::Error> {
    let kinds = axes_are_those_of_the_motion(&Kinds::new());
    let expected =
        ["slider a", "cylindrical b", "universal c", "screw d", "planar e", "pin shaker"];
    assert_eq!(kinds, expected);
    let crawler = axes_are_those_of_the_motion(&Crawler::new());
    assert_eq!(crawler.len(), 3 + 1 + 4, "{crawler:?}");
    assert_eq!(axes_are_those_of_the_motion(&Raft::new()), ["pin b", "slider c", "planar d"]);
    // An elastic hinge on a line has the freedom of a slider.
    assert_eq!(axes_are_those_of_the_motion(&Train::new()), ["slider a", "slider b"]);
    assert_eq!(axes_are_those_of_the_motion(&Rope::new()).len(), 101);
    assert_eq!(axes_are_those_of_the_motion(&FourBar::new()).len(), 4);
    let mut tied = Tied::new();
    tied.set_tilt(-0.9)?;
    tied.set_lean(1.7)?;
    assert_eq!(axes_are_those_of_the_motion(&tied).len(), 6);
    Ok(())
}

/// The points of hinges have the frames and the names that the accessors of hinges report.
#[test]
fn points_of_hinges_are_those_of_accessors() {
    let (_, at) = solved(&Crawler::new());
    let it = Crawler::<f64>::DESCRIPTION;
    let positions = |name: &str| {
        let points = it.points_of_hinge(it.hinge(name).expect(name)).expect(name);
        points.map(|point| pose::<Crawler<f64>>(&at, point).0)
    };
    for index in 0..3 {
        let (a, b) = (at.a(index).expect("a"), at.b(index).expect("b"));
        assert_eq!(
            positions(&format!("a[{index}]")),
            [a.input().position(), a.output().position()]
        );
        assert_eq!(
            positions(&format!("b[{index}]")),
            [b.input().position(), b.output().position()]
        );
    }
    let c = at.c();
    assert_eq!(positions("c"), [c.input().position(), c.output().position()]);
    let moving = Kinds::<f64>::DESCRIPTION;
    let deck = moving.hinge("deck").expect("the motion of the moving end");
    assert!(moving.points_of_hinge(deck).is_none());
    assert_eq!(Kinds::<f64>::new().hinge_axis(deck, 0), None);
}
