//! Compares the paper's printed matrices with the compiler's equations. At random states each matrix transfers the state vector
//! that the compiler reports inboard of an element to the one outboard of it, and the overall product with the solution of
//! the boundary equations gives the compiler's state vectors for the chains of the examples.

mod common;

use common::paper::{Case, Hinges, Moving, apart, axis, matrix, plain, reported};
use common::{Point, compute, read};
use mstmm_codegen::equations::Axes;
use mstmm_codegen::math::Structured;
use mstmm_codegen::model::SolutionMethod;
use mstmm_reference::Random;
use mstmm_runtime::nalgebra::{SVector, Vector2, Vector3};
use mstmm_runtime::paper::chain::{self, InputEnd, OutputEnd};
use mstmm_runtime::paper::{line, plane, rotation, state};

/// The number of cases of each kind.
const CASES: u64 = 25;
const BODIES: usize = 3;

/// The tolerance: each element divides by a matrix with a condition number of up to a few hundred.
const ELEMENT: f64 = 1e-12;

type Plain = Structured<f64>;

/// Returns the largest error of the transfer of a reported state vector by any element.
fn check_elements(case: &Case, moving: &Moving<f64>) -> f64 {
    let points = &moving.computed.report.points;
    let elements = case.elements::<f64>(moving);
    let apart = elements.iter().zip(points.windows(2)).map(|(element, ends)| {
        let [before, behind] = [0, 1].map(|end| reported(&ends[end]));
        // (43) divides by a number that may be small by chance; the size of its entries shows it.
        let size = element.amax().max(1.0);
        apart(&(element * before), &behind) / size
    });
    apart.fold(0.0, f64::max)
}

fn random_cases(
    hinges: impl Fn(&mut Random) -> Hinges,
) -> impl Iterator<Item = (Case, Moving<f64>)> {
    (0..CASES).map(move |seed| {
        let mut random = Random::new(seed);
        let hinges = hinges(&mut random);
        let case = Case::random(&mut random, hinges, BODIES);
        let moving = case.at_random(seed, SolutionMethod::Riccati);
        (case, moving)
    })
}

#[test]
fn bodies_and_balls_transfer_the_reported_z() {
    for (case, moving) in random_cases(|_| Hinges::Balls) {
        let apart = check_elements(&case, &moving);
        assert!(apart < ELEMENT, "{apart:e}");
    }
}

#[test]
fn bodies_and_pins_transfer_the_reported_z() {
    let axes = |random: &mut Random| Hinges::Pins((0..BODIES).map(|_| axis(random)).collect());
    for (case, moving) in random_cases(axes) {
        let apart = check_elements(&case, &moving);
        assert!(apart < ELEMENT, "{apart:e}");
    }
}

#[test]
fn bodies_and_acceleration_hinges_transfer_the_reported_z() {
    for (case, moving) in random_cases(|_| Hinges::Floating) {
        let apart = check_elements(&case, &moving);
        assert!(apart < ELEMENT, "{apart:e}");
    }
}

/// (35), (36) and (44): the wrench that a pin transmits, and its acceleration.
#[test]
fn pins_accelerate_as_is_reported() {
    let axes = |random: &mut Random| Hinges::Pins((0..BODIES).map(|_| axis(random)).collect());
    for (case, moving) in random_cases(axes) {
        for k in 0..BODIES {
            let pin = case.pin::<f64>(k, &moving);
            let [input, output] =
                [2 * k, 2 * k + 1].map(|at| reported(&moving.computed.report.points[at]));
            let acceleration = moving.computed.accelerations[k];
            let scale = output.amax();
            assert!((pin.acceleration(&input, &output) - acceleration).abs() < 1e-12 * scale);
            let [before, behind] = [input, output].map(|z| state::blocks(&z));
            assert!(pin.axial_moment(&before.moment()).abs() < 1e-12 * scale);
            let turned =
                pin.output_angular_acceleration(&before.angular_acceleration(), acceleration);
            assert!((turned - behind.angular_acceleration()).amax() < 1e-12 * scale);
        }
    }
}

/// (1): the compiler's rotation by Bryan angles is the printed matrix.
#[test]
fn bryan_angles_equal_the_printed_matrix() {
    let mut random = Random::new(7);
    for _ in 0..CASES {
        let angles = Vector3::from_fn(|_, _| random.between(-1.5, 1.5));
        let turn = angles.as_slice();
        let text = format!(
            "chain Turned {{ body B {{ mass = 1 kg; com = [1, 2, 3] m; inertia = diag(1, 1, 1) \
             kg*m^2 about com; }} ground turned rpy({:?}, {:?}, {:?}) -> pin j -> B b; }}",
            turn[0], turn[1], turn[2]
        );
        let way = (SolutionMethod::Riccati, Axes::Body);
        let computed = compute::<f64>(&read(&text), way, &[0.0], &[0.0], &[0.0]);
        let reported = matrix(computed.report.points[0].rotation);
        assert!((rotation::rotation_matrix(&angles) - reported).amax() < 1e-14);
    }
}

/// Compares the overall product and the solution of the boundary equations with all reported state vectors.
fn check_chain<const N: usize, const K: usize>(
    case: &Case,
    moving: &Moving<f64>,
    input: &InputEnd<f64, 13, K>,
) {
    let elements: [_; N] = case.elements(moving).try_into().expect("an element and a body each");
    let states = chain::solve(&elements, input, &OutputEnd::free());
    let points = moving.computed.report.points.iter().map(reported);
    let found = [&states.input].into_iter().chain(&states.outputs);
    for (found, reported) in found.zip(points) {
        let apart = apart(found, &reported);
        // Three bodies cost three digits.
        assert!(apart < 1e-10, "{apart:e}");
    }
}

#[test]
fn the_ball_pendulum_of_section_4_1() {
    let case = Case::of_cubes(Hinges::Balls, 3);
    let aligned = [1.0, 0.0, 0.0, 0.0];
    let mut rates = [0.0; 9];
    rates[7] = 0.1;
    let start = case.at(SolutionMethod::Riccati, &[aligned; 3].concat(), &rates);
    check_chain::<6, 3>(&case, &start, &InputEnd::ball());
    for seed in 0..CASES {
        let moving = case.at_random(seed, SolutionMethod::Transfer);
        check_chain::<6, 3>(&case, &moving, &InputEnd::ball());
    }
}

#[test]
fn the_pinned_arm_of_section_4_2() {
    let case = Case::of_cubes(Hinges::Pins(vec![Vector3::z(); 3]), 3);
    let start = case.at(SolutionMethod::Riccati, &[0.0; 3], &[0.0, 1.0, 0.0]);
    let input = |moving: &Moving<f64>| InputEnd::pin(&case.pin(0, moving).orientation);
    check_chain::<6, 5>(&case, &start, &input(&start));
    for seed in 0..CASES {
        let moving = case.at_random(seed, SolutionMethod::Transfer);
        check_chain::<6, 5>(&case, &moving, &input(&moving));
    }
}

#[test]
fn oblique_pins_in_a_chain() {
    let axes = [[1.0, 2.0, 3.0], [1.0, 1.0, 2.0], [0.0, 1.0, 3.0]];
    let axes = axes.map(|axis| Vector3::from(axis).normalize());
    let case = Case::of_cubes(Hinges::Pins(axes.to_vec()), 3);
    for seed in 0..CASES {
        let moving = case.at_random(seed, SolutionMethod::Riccati);
        let input = InputEnd::pin(&case.pin(0, &moving).orientation);
        check_chain::<6, 5>(&case, &moving, &input);
    }
}

/// Compares the 7×7 matrices of a chain in the plane, element by element and as a product.
#[test]
fn a_chain_in_the_plane() {
    for (hinge, seed) in (0..2 * CASES).map(|seed| (["pin", "floating"][(seed % 2) as usize], seed))
    {
        let mut random = Random::new(seed);
        let mut pair = |size: f64| Vector2::from_fn(|_, _| random.between(-size, size));
        let bodies = [0, 1, 2].map(|_| {
            let (com, output, [mass, inertia]) = (pair(0.5), pair(1.0), pair(0.5).into());
            let (mass, inertia) = (mass + 1.0, inertia + 1.5);
            plane::Body { mass, com, output, inertia }
        });
        let (mut types, mut route) = (String::new(), String::from("ground"));
        for (k, plane::Body { mass, com, output, inertia }) in bodies.iter().enumerate() {
            types += &format!(
                "body B{k} {{ mass = {mass:?} kg; com = {:?} m; output = {:?} m;
                inertia = {inertia:?} kg*m^2 about input; }}\n",
                com.as_slice(),
                output.as_slice()
            );
            route += &format!(" -> {hinge} j{k} -> B{k} b{k}");
        }
        let text = format!("plane chain Flat {{ gravity = [0.3, -9.8] m/s^2; {types} {route}; }}");
        let chain = read(&text);
        let count = if hinge == "pin" { 3 } else { 9 };
        let mut numbers = || (0..count).map(|_| random.between(-1.5, 1.5)).collect::<Vec<_>>();
        let (q, v) = (numbers(), numbers());
        let way = (SolutionMethod::Riccati, Axes::Body);
        let computed = compute::<f64>(&chain, way, &q, &v, &vec![0.0; count]);
        let points = &computed.report.points;

        let body = |k: usize| {
            let point = &points[2 * k + 1];
            let turn = matrix(point.rotation);
            bodies[k].transfer_matrix(&plane::Acting {
                angle: turn[(1, 0)].atan2(turn[(0, 0)]),
                angular_velocity: plain(point.omega).z,
                force: Vector2::new(0.3, -9.8) * bodies[k].mass,
                moment: 0.0,
            })
        };
        let matrices: Vec<_> = (0..3)
            .flat_map(|k| match hinge {
                "pin" => [plane::pin(&body(k)), body(k)],
                _ => [plane::acceleration_hinge(&body(k)), body(k)],
            })
            .collect();
        let z: Vec<_> = points.iter().map(flat).collect();
        for (element, ends) in matrices.iter().zip(z.windows(2)) {
            let apart = apart(&(element * ends[0]), &ends[1]);
            assert!(apart < ELEMENT, "{hinge} seed {seed}: {apart:e}");
        }
        if hinge == "pin" {
            let elements: [_; 6] = matrices.try_into().expect("six elements");
            let (input, output) = (InputEnd::entries([4, 5]), OutputEnd::entries([3, 4, 5]));
            let states = chain::solve(&elements, &input, &output);
            for (found, reported) in states.outputs.iter().zip(&z[1..]) {
                let apart = apart(found, reported);
                assert!(apart < 1e-11, "seed {seed}: {apart:e}");
            }
        }
    }
}

/// Returns z in the plane.
fn flat(point: &Point<Plain>) -> SVector<f64, 7> {
    let z = reported(point);
    SVector::from([0, 1, 5, 8, 9, 10, 12].map(|entry| z[entry]))
}

/// The masses between springs of section 4.4, from body 2 on as the paper has them.
#[test]
fn masses_between_springs_of_section_4_4() {
    const COUNT: usize = 5;
    let mut random = Random::new(44);
    for (stiffness, damping) in [(1000.0, 0.0), (700.0, 3.0)] {
        let route: String = (0..COUNT).map(|k| format!(" -> elastic j{k} -> Mass b{k}")).collect();
        let names = (0..COUNT).map(|k| format!("j{k}")).collect::<Vec<_>>().join(", ");
        let text = format!(
            "line chain Masses {{ body Mass {{ mass = 0.1 kg; output = 0 m; }} ground{route};
            hinge {names} {{ stiffness = {stiffness} N/m; damping = {damping} N*s/m; }}
            load push {{ on = b0; force = 100 N; }} }}"
        );
        let mut numbers = |size: f64| [0.0; COUNT].map(|_: f64| random.between(-size, size));
        let (q, v) = (numbers(0.2), numbers(3.0));
        let way = (SolutionMethod::Riccati, Axes::Body);
        let computed = compute::<f64>(&read(&text), way, &q, &v, &[0.0; COUNT]);
        let sum = |relative: &[f64], k: usize| relative[..=k].iter().sum::<f64>();
        let masses = std::array::from_fn::<_, COUNT, _>(|k| line::Mass {
            position: sum(&q, k),
            velocity: sum(&v, k),
            force: if k == 0 { 100.0 } else { 0.0 },
            stiffness,
            damping,
        });
        let loads = line::loads(&masses);
        let elements = std::array::from_fn::<_, { 2 * COUNT - 1 }, _>(|place| match place % 2 {
            0 => line::body(0.1, loads[place / 2]),
            _ => line::acceleration_hinge(0.1, loads[place / 2 + 1]),
        });
        let states = chain::solve(&elements, &InputEnd::entries([0]), &OutputEnd::entries([1]));
        for (k, z) in states.outputs.iter().step_by(2).enumerate() {
            // Between the elements of body k the acceleration is the reported one, and the force is zero.
            let expected = reported(&computed.report.points[2 * k + 1])[0];
            assert!((z[0] - expected).abs() < 1e-11 * expected.abs().max(1e3), "{k}: {z}");
            assert!(z[1].abs() < 1e-10);
        }
    }
}
