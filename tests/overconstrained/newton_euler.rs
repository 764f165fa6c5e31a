//! The reference compared with the solver of Newton's and Euler's equations in all coordinates.

use super::algebra::{constants, dot, norm, rotation_of};
use super::linkage::{Frame, Linkage};
use super::reference::apart;
use super::states::{linkages, ordinary};
use super::svd::decomposed;
use mstmm_reference::{About, Body, Chain, Element, End, Hinge, HingeKind, State};

fn frame(frame: &Frame) -> mstmm_reference::Frame {
    let turn = rotation_of::<f64>(constants(frame.turned));
    let roll = turn[2][1].atan2(turn[2][2]);
    let pitch = (-turn[2][0]).atan2(turn[0][0].hypot(turn[1][0]));
    let yaw = turn[1][0].atan2(turn[0][0]);
    let rpy_degrees = [roll, pitch, yaw].map(f64::to_degrees);
    mstmm_reference::Frame { position: frame.position, rpy_degrees }
}

fn chain(linkage: &Linkage) -> Chain {
    let pin = |name: String, axis| Element::Hinge(Hinge::new(&name, HingeKind::Pin { axis }));
    let mut elements = Vec::new();
    for (k, link) in linkage.links.iter().enumerate() {
        elements.push(pin(format!("pin{k}"), link.axis));
        elements.push(Element::Body(Body {
            name: format!("body{k}"),
            mass: link.mass,
            com: link.com,
            output: frame(&link.output),
            inertia: link.inertia,
            about: About::Com,
            points: Vec::new(),
        }));
    }
    elements.push(pin("last".to_owned(), linkage.last));
    let open = Chain::new(linkage.name, linkage.gravity, elements);
    let ends = [&linkage.from, &linkage.to].map(|end| End::Held(frame(end)));
    let [start, finish] = ends;
    Chain { start, finish, ..open }
}

/// The solver works in double precision, with angles in degrees: six digits of sixteen are for
/// those and for the condition of its dense system. Its multipliers are those of least norm in all
/// hinges together, so that of its closing reaction only the part in the range of J is compared:
/// what is perpendicular does no work on any motion of the route.
#[test]
fn newton_and_euler_agree() {
    for linkage in linkages() {
        let chain = chain(&linkage);
        let (mut accelerations, mut reactions) = (0.0_f64, 0.0_f64);
        for crank in ordinary(&linkage) {
            let instant = linkage.instant::<f64>(crank, 1.5);
            let efforts = vec![0.0; linkage.pins()];
            let state = State { q: instant.q.clone(), v: instant.v.clone() };
            let solution = chain.solve(&state, &efforts);
            let expected = super::face::doubles(&instant.reference.accelerations);
            let off = apart(&solution.accelerations, &expected) / norm(&expected);
            accelerations = accelerations.max(off);

            let closing = &solution.points[solution.points.len() - 2];
            let force = closing.force.map(|x| -x);
            let found = [force, closing.moment].concat();
            let jacobian: Vec<Vec<f64>> =
                instant.reference.jacobian.iter().map(|c| super::face::doubles(c)).collect();
            let work: Vec<f64> = jacobian.iter().map(|column| dot(column, &found)).collect();
            let least = decomposed(&jacobian).solved_transposed(linkage.rank, &work);
            let expected = super::face::doubles(&instant.reference.reaction);
            reactions = reactions.max(apart(&least, &expected) / norm(&expected));
        }
        println!("{}: off by {accelerations:.1e}, {reactions:.1e}", linkage.name);
        assert!(accelerations < 1e-10 && reactions < 1e-10, "{}", linkage.name);
    }
}
