//! Hinges with several degrees of freedom, compared with chains of simpler hinges and tiny masses.

use crate::samples::{assert_close, cube, disc, matrix, pin_about_z, rich_cases};
use mstmm_reference::{
    Axis, Chain, Dimension, Element, End, Group, Hinge, HingeKind, Limits, Point, Random, Solution,
    State,
};
use nalgebra::Vector3;

/// The mass of a body between simpler hinges; other bodies have about 1.
const NEXT_TO_NOTHING: f64 = 1e-8;
const TOLERANCE: f64 = 3e-6;

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// The simpler hinges that replace a hinge, each with the index of its coordinate there.
type Pieces = Vec<(HingeKind, usize)>;

fn compounds() -> Vec<(HingeKind, Pieces)> {
    let pin = |axis| HingeKind::Pin { axis };
    let slider = |axis| HingeKind::Slider { axis };
    let askew = [0.3, -0.8, 0.4];
    let shifts = |first: usize| [X, Y, Z].map(slider).into_iter().zip(first..);
    let elastic: Pieces =
        [(pin(Z), 5)].into_iter().chain(shifts(0)).chain([(pin(Y), 4), (pin(X), 3)]).collect();
    vec![
        (HingeKind::Cylindrical { axis: askew }, vec![(slider(askew), 0), (pin(askew), 1)]),
        (
            HingeKind::Universal { first: askew, second: [1.0, 0.2, 0.0] },
            vec![(pin(askew), 0), (pin([1.0, 0.2, 0.0]), 1)],
        ),
        (
            HingeKind::Gimbal { axes: [askew, [1.0, 0.2, 0.0], [0.0, -0.5, 1.0]] },
            vec![(pin(askew), 0), (pin([1.0, 0.2, 0.0]), 1), (pin([0.0, -0.5, 1.0]), 2)],
        ),
        (HingeKind::Planar { normal: Axis::Y }, vec![(slider(Z), 0), (slider(X), 1), (pin(Y), 2)]),
        (HingeKind::Floating, shifts(0).chain([(HingeKind::Ball, 3)]).collect()),
        (HingeKind::Elastic, elastic),
        (HingeKind::PlaneElastic, vec![(pin(Z), 2), (slider(X), 0), (slider(Y), 1)]),
        (HingeKind::PlaneFloating, vec![(slider(X), 0), (slider(Y), 1), (pin(Z), 2)]),
    ]
}

/// Returns a hinge with springs, dampers, rotors and so on, different for every coordinate.
fn with_everything(kind: &HingeKind) -> Hinge {
    let list =
        |first: f64, count: usize| (0..count).map(|k| first * (1.0 + 0.3 * k as f64)).collect();
    let group = |scale: f64, count: usize| Group {
        stiffness: list(20.0 * scale, count),
        damping: list(scale, count),
        armature: list(0.2 * scale, count),
        friction: list(0.5 * scale, count),
        friction_speed: 0.3,
        limits: Some(Limits { range: [-0.2, 0.25], stiffness: 50.0, damping: 0.7 }),
        ..Group::default()
    };
    let mut hinge = Hinge::new("j1", kind.clone());
    let single = |count: usize| if kind.has_quaternion() { 1 } else { count };
    if !kind.linear().is_empty() {
        hinge.linear = group(1.0, kind.linear().len());
    }
    if !kind.turning().is_empty() {
        hinge.turning = group(0.6, single(kind.turning().len()));
    }
    hinge
}

/// Returns the part of a group for one of its strains, or all of it for a ball.
fn part(group: &Group, k: usize, whole: bool) -> Group {
    let pick = |list: &Vec<f64>| if whole { list.clone() } else { vec![list[k]] };
    Group {
        stiffness: pick(&group.stiffness),
        damping: pick(&group.damping),
        armature: pick(&group.armature),
        friction: pick(&group.friction),
        ..group.clone()
    }
}

/// Returns the simpler hinges, with everything that acts along them.
fn in_pieces(hinge: &Hinge, pieces: &Pieces) -> Vec<Element> {
    let mut elements = Vec::new();
    for (number, (kind, coordinate)) in pieces.iter().enumerate() {
        if number > 0 {
            let inertia = NEXT_TO_NOTHING;
            elements.push(disc(&format!("light{number}"), NEXT_TO_NOTHING, inertia));
        }
        let mut piece = Hinge::new(&format!("piece{number}"), kind.clone());
        let shifts = hinge.kind.linear().len();
        if *coordinate < shifts {
            piece.linear = part(&hinge.linear, *coordinate, false);
        } else {
            let whole = *kind == HingeKind::Ball;
            piece.turning = part(&hinge.turning, coordinate - shifts, whole);
        }
        elements.push(Element::Hinge(piece));
    }
    elements
}

/// Returns the rates of a hinge from the motions of its two sides.
fn rates(
    kind: &HingeKind,
    inboard: &Point,
    outboard: &Point,
    coordinate_rates: &[f64],
) -> Vec<f64> {
    let back = matrix(&inboard.rotation).transpose();
    let between = Vector3::from(outboard.position) - Vector3::from(inboard.position);
    let turning = Vector3::from(inboard.angular_velocity);
    let velocity = back
        * (Vector3::from(outboard.velocity)
            - Vector3::from(inboard.velocity)
            - turning.cross(&between));
    let spin = Vector3::from(outboard.angular_velocity) - turning;
    let own = matrix(&outboard.rotation).transpose() * spin;
    match kind {
        HingeKind::Floating | HingeKind::Elastic => {
            velocity.iter().chain(own.iter()).copied().collect()
        }
        HingeKind::PlaneElastic => vec![velocity.x, velocity.y, own.z],
        _ => coordinate_rates.to_vec(),
    }
}

#[test]
fn compounds_move_like_their_pieces() {
    for (number, (kind, pieces)) in compounds().into_iter().enumerate() {
        for seed in 0..5 {
            let mut random = Random::new(10 * number as u64 + seed);
            let hinge = with_everything(&kind);
            // Every strain rate once, in the order of the strains; a ball has three.
            let strain_rates: Vec<f64> =
                (0..kind.dof_count()).map(|_| random.between(-2.0, 2.0)).collect();
            let mut q: Vec<f64> =
                (0..kind.coordinates()).map(|_| random.between(-0.6, 0.6)).collect();
            if kind.has_quaternion() {
                q[3] = 1.0;
            }
            let body = pin_about_z("first");
            let chain = |between: Vec<Element>| {
                let ends = ([body.clone(), cube("b1")], [cube("b2")]);
                let elements = ends.0.into_iter().chain(between).chain(ends.1).collect();
                Chain::new("Compound", [2.0, -9.0, 1.0], elements)
            };
            let (apart, whole) =
                (chain(in_pieces(&hinge, &pieces)), chain(vec![Element::Hinge(hinge.clone())]));

            let mut state = State { q: vec![0.4], v: vec![-0.7] };
            for (piece, first) in &pieces {
                state.q.extend(&q[*first..first + piece.coordinates()]);
                state.v.extend(&strain_rates[*first..first + piece.dof_count()]);
            }
            let expected = apart.solve(&state, &vec![0.0; apart.dof_count()]);

            let last = apart.elements.len() - 1;
            let sides = (&expected.points[2], &expected.points[last]);
            let v = rates(&kind, sides.0, sides.1, &strain_rates);
            let state = State { q: [vec![0.4], q].concat(), v: [vec![-0.7], v].concat() };
            let found = whole.solve(&state, &vec![0.0; whole.dof_count()]);
            compare(&format!("{kind:?} {seed}"), &found, &expected);
        }
    }
}

/// Compares the points of the first and of the last body, and energies.
fn compare(name: &str, found: &Solution, expected: &Solution) {
    let ends = |all: &Solution| {
        let last = all.points.len() - 1;
        [0, 1, 2, last - 1, last].map(|k| all.points[k].clone())
    };
    for (found, expected) in ends(found).iter().zip(ends(expected).iter()) {
        let pairs = [
            (found.position, expected.position),
            (found.velocity, expected.velocity),
            (found.acceleration, expected.acceleration),
            (found.angular_acceleration, expected.angular_acceleration),
            (found.force, expected.force),
            (found.moment, expected.moment),
        ];
        for (found, expected) in pairs {
            let scale = 1.0 + Vector3::from(expected).norm();
            for k in 0..3 {
                assert_close(found[k], expected[k], TOLERANCE * scale, name);
            }
        }
    }
    assert_close(found.kinetic_energy, expected.kinetic_energy, TOLERANCE, name);
    assert_close(found.potential_energy, expected.potential_energy, TOLERANCE, name);
}

/// A floating hinge at the end of a closed chain constrains nothing: the rest moves as without it.
#[test]
fn closing_by_a_floating_hinge_changes_nothing() {
    let cases = rich_cases();
    let open = cases.iter().filter(|case| {
        let space = case.chain.dimension == Dimension::Space;
        space && case.chain.start != End::Free && case.chain.finish == End::Free
    });
    for case in open {
        let expected = case.solve();
        let mut chain = case.chain.clone();
        chain.elements.push(Element::Hinge(Hinge::new("last", HingeKind::Floating)));
        chain.finish = End::Moving { name: "end".to_owned() };
        let end = &expected.points[expected.points.len() - 1];
        let mut drives = case.drives.clone();
        drives.efforts.extend([0.0; 6]);
        drives.finish.position = end.position;
        drives.finish.velocity = end.velocity;
        // The frame need not rotate with the body: the hinge allows it.
        let mut state = case.state.clone();
        let turn = nalgebra::Rotation3::from_matrix_unchecked(matrix(&end.rotation).transpose());
        let quaternion = nalgebra::UnitQuaternion::from_rotation_matrix(&turn);
        let own = -Vector3::from(end.angular_velocity);
        state.q.extend([0.0; 3]);
        state.q.extend([quaternion.w, quaternion.i, quaternion.j, quaternion.k]);
        state.v.extend([0.0; 3]);
        state.v.extend(own.iter());
        let found = chain.solve_driven(&state, &drives);
        assert!(found.reactions_unique);
        for (found, expected) in found.accelerations.iter().zip(&expected.accelerations) {
            assert_close(*found, *expected, 1e-9, &chain.name);
        }
    }
}
