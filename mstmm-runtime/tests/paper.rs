//! The paper's matrices by themselves: identities, cuts, and a rival's equations.

use mstmm_runtime::nalgebra::{Matrix3, SMatrix, Vector2, Vector3};
use mstmm_runtime::paper::body::{Blocks, Body, Load, Motion};
use mstmm_runtime::paper::chain::{self, InputEnd, OutputEnd};
use mstmm_runtime::paper::lagrange::{self, Rod};
use mstmm_runtime::paper::{
    TransferMatrix, acceleration_hinge, ball, elastic, line, plane, rotation, state,
};

const ANGLES: [f64; 3] = [0.7, -0.4, 2.1];
const RATES: [f64; 3] = [-1.2, 0.8, 0.5];

fn body() -> Body<f64> {
    Body {
        mass: 2.0,
        com: Vector3::new(0.3, -0.1, 0.2),
        output: Vector3::new(1.0, 0.4, -0.5),
        inertia: Matrix3::new(0.9, 0.05, -0.1, 0.05, 1.1, 0.02, -0.1, 0.02, 0.8),
    }
}

fn motion() -> Motion<f64> {
    Motion {
        orientation: rotation::rotation_matrix(&ANGLES.into()),
        angular_velocity: Vector3::new(0.4, -1.5, 0.9),
    }
}

fn load() -> Load<f64> {
    Load { force: Vector3::new(1.0, -19.6, 0.5), moment: Vector3::new(0.2, 0.1, -0.3) }
}

fn blocks() -> Blocks<f64> {
    body().blocks(&motion(), &load())
}

#[test]
fn the_rotation_matrix_is_that_of_three_turns() {
    let [x, y, z] = ANGLES;
    let turn = |axis: Vector3<f64>, angle: f64| {
        mstmm_runtime::nalgebra::Rotation3::from_scaled_axis(axis * angle).into_inner()
    };
    let product = turn(Vector3::z(), z) * turn(Vector3::y(), y) * turn(Vector3::x(), x);
    let printed = rotation::rotation_matrix(&ANGLES.into());
    assert!((printed - product).amax() < 1e-15);
    assert!((rotation::angles(&printed) - Vector3::from(ANGLES)).amax() < 1e-14);
}

/// Ȧ Aᵀ by central differences, and the way from Ω̇ back to θ̈.
#[test]
fn angular_velocities_are_those_of_the_rotation_matrix() {
    let (angles, rates) = (Vector3::from(ANGLES), Vector3::from(RATES));
    let accelerations = Vector3::new(0.3, 0.9, -2.0);
    let step = 1e-5;
    let at = |time: f64| angles + rates * time + accelerations * (0.5 * time * time);
    let rates_at = |time: f64| rates + accelerations * time;
    let matrix = |time: f64| rotation::rotation_matrix(&at(time));
    let omega = rotation::angular_velocity(&angles, &rates);
    let spin = (matrix(step) - matrix(-step)) / (2.0 * step) * matrix(0.0).transpose();
    let seen = Vector3::new(spin[(2, 1)], spin[(0, 2)], spin[(1, 0)]);
    assert!((omega - seen).amax() < 1e-9);

    let h = |time: f64| rotation::rate_matrix(&at(time));
    let change = (h(step) - h(-step)) / (2.0 * step);
    assert!((rotation::rate_matrix_rate(&angles, &rates) - change).amax() < 1e-9);

    let omega_at = |time: f64| rotation::angular_velocity(&at(time), &rates_at(time));
    let turning = (omega_at(step) - omega_at(-step)) / (2.0 * step);
    let back = rotation::angle_accelerations(&angles, &rates, &turning);
    assert!((back - accelerations).amax() < 1e-8);
}

#[test]
fn at_a_right_angle_the_angles_fail() {
    let angles = Vector3::new(0.1, core::f64::consts::FRAC_PI_2, 0.2);
    let found = rotation::angle_accelerations(&angles, &RATES.into(), &Vector3::x());
    assert!(found.amax() > 1e15 || found.iter().any(|x| !x.is_finite()));
}

/// (21) row by row, and its determinant.
#[test]
fn a_body_transfers_by_its_rows() {
    let u = blocks().transfer_matrix();
    let unknown = |seed: f64| Vector3::new(seed, -0.5 * seed, 2.0 - seed);
    let [acceleration, turning, moment, force] = [1.0, 2.0, 3.0, 4.0].map(unknown);
    let output = state::blocks(&(u * state::column(&acceleration, &turning, &moment, &force)));
    let expected = blocks().output_acceleration(&acceleration, &turning);
    assert!((output.acceleration() - expected).amax() < 1e-14);
    assert_eq!(output.angular_acceleration(), turning);
    let expected = blocks().output_force(&acceleration, &turning, &force);
    assert!((output.force() - expected).amax() < 1e-13);
    let expected = blocks().output_moment(&acceleration, &turning, &moment, &output.force());
    assert!((output.moment() - expected).amax() < 1e-13);
    assert!((u.determinant() - 1.0).abs() < 1e-13);

    // Newton and Euler about the centre of mass, which (21) does not know.
    let Motion { orientation, angular_velocity: omega } = motion();
    let (com, end) = (orientation * body().com, orientation * body().output);
    let of_com = acceleration + turning.cross(&com) + omega.cross(&omega.cross(&com));
    let newton = force - output.force() + load().force - of_com * 2.0;
    assert!(newton.amax() < 1e-13);
    let steiner = Matrix3::identity() * com.norm_squared() - com * com.transpose();
    let central = orientation * body().inertia * orientation.transpose() - steiner * 2.0;
    let spin = central * turning + omega.cross(&(central * omega));
    let levers = (com - end).cross(&output.force()) - com.cross(&force);
    let euler = output.moment() - moment + load().moment + levers - spin;
    assert!(euler.amax() < 1e-13);
}

#[test]
fn the_plane_body_is_the_cut_of_the_spatial_one() {
    let flat = plane::Body {
        mass: 1.5,
        com: Vector2::new(0.4, 0.1),
        output: Vector2::new(0.9, -0.2),
        inertia: 0.8,
    };
    let acting = plane::Acting {
        angle: 0.6,
        angular_velocity: -1.3,
        force: Vector2::new(0.3, -9.8),
        moment: 0.7,
    };
    let body = Body {
        mass: flat.mass,
        com: flat.com.push(0.0),
        output: flat.output.push(0.0),
        inertia: Matrix3::from_diagonal(&Vector3::new(0.5, 0.6, flat.inertia)),
    };
    let motion = Motion {
        orientation: rotation::rotation_matrix(&Vector3::new(0.0, 0.0, acting.angle)),
        angular_velocity: Vector3::z() * acting.angular_velocity,
    };
    let load = Load { force: acting.force.push(0.0), moment: Vector3::z() * acting.moment };
    let spatial = body.blocks(&motion, &load).transfer_matrix();
    let u = flat.transfer_matrix(&acting);
    assert!((u - plane::cut(&spatial)).amax() < 1e-15);
    assert!((plane::pin(&u) - plane::cut(&ball::transfer_matrix(&spatial))).amax() < 1e-14);
    let hinge = acceleration_hinge::Blocks::of(&spatial).transfer_matrix();
    assert!((plane::acceleration_hinge(&u) - plane::cut(&hinge)).amax() < 1e-14);
}

/// (52) is not the line cut of (66); the two agree at a hinge that passes no force.
#[test]
fn the_line_matrices_are_cuts() {
    let point = Body { mass: 0.1, com: Vector3::zeros(), output: Vector3::zeros(), ..body() };
    let still = Motion { orientation: Matrix3::identity(), angular_velocity: Vector3::zeros() };
    let push = Load { force: Vector3::x() * 3.0, moment: Vector3::zeros() };
    let spatial = point.blocks(&still, &push).transfer_matrix();
    assert_eq!(line::body(0.1, 3.0), line::cut(&spatial));
    let hinge = line::cut(&acceleration_hinge::Blocks::of(&spatial).transfer_matrix());
    assert!((line::acceleration_hinge_for_any_force(0.1, 3.0) - hinge).amax() < 1e-13);
    let printed = line::acceleration_hinge(0.1, 3.0);
    assert!((printed - hinge).amax() > 9.0);
    let without_force = Vector3::new(5.0, 0.0, 1.0);
    assert!((printed * without_force - hinge * without_force).amax() < 1e-13);
}

/// A pendulum of rods by the 7×7 product and by (46).
#[test]
fn lagrange_agrees_with_the_product() {
    let angles: [f64; 3] = [-1.2, 0.4, 0.9];
    let rates: [f64; 3] = [0.7, -1.1, 2.0];
    let masses = [1.0, 0.7, 1.9];
    let lengths = [1.0, 1.4, 0.6];
    let rods = [0, 1, 2].map(|k| Rod {
        mass: masses[k],
        length: lengths[k],
        inertia: masses[k] * lengths[k] * lengths[k] / 12.0,
        angle: angles[k],
        rate: rates[k],
    });
    let expected = lagrange::pendulum(&rods, 9.8);
    let bodies = rods.map(|rod| {
        let half = rod.length / 2.0;
        plane::Body {
            mass: rod.mass,
            com: Vector2::new(half, 0.0),
            output: Vector2::new(rod.length, 0.0),
            inertia: rod.inertia + rod.mass * half * half,
        }
        .transfer_matrix(&plane::Acting {
            angle: rod.angle,
            angular_velocity: rod.rate,
            force: Vector2::new(0.0, -9.8 * rod.mass),
            moment: 0.0,
        })
    });
    let elements = [0, 0, 1, 1, 2, 2];
    let mut place = 0;
    let elements = elements.map(|k| {
        place += 1;
        if place % 2 == 1 { plane::pin(&bodies[k]) } else { bodies[k] }
    });
    let states =
        chain::solve(&elements, &InputEnd::entries([4, 5]), &OutputEnd::entries([3, 4, 5]));
    for k in 0..3 {
        assert!((states.outputs[2 * k + 1][2] - expected[k]).abs() < 1e-12 * expected.amax());
    }
    // A single rod: J θ̈ + m g l cos θ / 2 = 0 [P, Section 4.3].
    let single = lagrange::pendulum(&[rods[0]], 9.8)[0];
    assert!((single + 9.8 * angles[0].cos() / 2.0 * 3.0).abs() < 1e-14);
}

/// Springs between masses only move momentum, but for the one at the wall.
#[test]
fn loads_of_springs_cancel() {
    let mass = |position: f64, velocity: f64, force: f64| line::Mass {
        position,
        velocity,
        force,
        stiffness: 100.0,
        damping: 3.0,
    };
    let masses = [mass(0.1, 1.0, 2.0), mass(-0.2, 0.5, 0.0), mass(0.4, -1.0, 0.0)];
    let loads = line::loads(&masses);
    let wall = -100.0 * 0.1 - 3.0 * 1.0;
    assert!((loads.iter().sum::<f64>() - (2.0 + wall)).abs() < 1e-12);
    assert!((loads[2] - (100.0 * -0.6 + 3.0 * 1.5)).abs() < 1e-12);
}

#[test]
fn the_torque_and_force_of_springs() {
    let springs = elastic::Springs {
        stiffness: Vector3::new(1.0, 2.0, 3.0),
        damping: Vector3::new(0.1, 0.2, 0.3),
        turning_stiffness: Vector3::new(4.0, 5.0, 6.0),
        turning_damping: Vector3::new(0.4, 0.5, 0.6),
    };
    let (ones, tens) = (Vector3::repeat(1.0), Vector3::repeat(10.0));
    assert_eq!(springs.force(&ones, &tens), Vector3::new(2.0, 4.0, 6.0));
    assert_eq!(springs.torque(&ones, &tens), Vector3::new(8.0, 10.0, 12.0));
    let inboard = rotation::rotation_matrix(&RATES.into());
    let outboard = inboard * rotation::rotation_matrix(&ANGLES.into());
    let turns = elastic::turns(&elastic::relative(&inboard, &outboard));
    assert!((turns - Vector3::from(ANGLES)).amax() < 1e-14);
}

/// A body alone that nothing holds.
#[test]
fn a_free_body() {
    let u = blocks().transfer_matrix();
    let states = chain::solve(&[u], &InputEnd::free(), &OutputEnd::free());
    let end = state::blocks(&states.outputs[0]);
    assert!(end.force().amax() < 1e-13 && end.moment().amax() < 1e-13);
    let start = state::blocks(&states.input);
    let Motion { orientation, angular_velocity: omega } = motion();
    let com = orientation * body().com;
    let of_com = start.acceleration()
        + start.angular_acceleration().cross(&com)
        + omega.cross(&omega.cross(&com));
    assert!((of_com * 2.0 - load().force).amax() < 1e-12);
}

/// What cannot be solved is not finite, and nothing panics.
#[test]
fn singular_hinges_are_not_finite() {
    let nothing: TransferMatrix<f64> = SMatrix::identity();
    assert!(ball::transfer_matrix(&nothing).iter().any(|x| !x.is_finite()));
    let hinge = acceleration_hinge::Blocks::of(&nothing).transfer_matrix();
    assert!(hinge.iter().any(|x| !x.is_finite()));
    let states = chain::solve(&[nothing], &InputEnd::ball(), &OutputEnd::entries([6, 7, 8]));
    assert!(states.outputs[0].iter().any(|x| !x.is_finite()));
}
