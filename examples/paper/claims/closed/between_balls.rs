//! Three spatial links between two balls on the ground.

use mstmm::Error;
use mstmm::prelude::*;
use mstmm_reference::{
    About, Body, Chain, Element, End, Frame, Hinge, HingeKind, Sample, Solution, State, simulate,
};
use nalgebra::Vector3;

use super::comparison::{
    ClosedChainComparison, Motion, Record, ShownCoordinate, Start, Texts, assembled, mark_times,
    motion,
};
use crate::output::drawing::{Canvas, Drawing, FROM_ABOVE, Point, Side};
use crate::output::progress::Progress;
use crate::system::GRAVITY;

/// The centre of mass of a link in m.
const CENTRE: [f64; 3] = [0.5, 0.0, 0.1];
/// The position of the last ball on the ground in m.
const END: [f64; 3] = [2.0, 0.3, 0.0];

mstmm_chain! {
    /// Links whose centres of mass are not on the line between their balls, so that they roll.
    chain BetweenBalls {
        gravity = [0, -9.8, 0] m/s^2;
        body Link {
            mass = 1 kg; com = [0.5, 0, 0.1] m; output = [1, 0, 0] m;
            inertia = diag(0.02, 0.09, 0.1) kg*m^2 about com;
        }
        ground -> ball a -> Link first -> ball b -> Link second -> ball c -> Link third
               -> ball d -> ground at [2, 0.3, 0] m;
        hinge a { start = rpy(0, -60, 0) deg; start_rate = [0, 0, 1] rad/s; }
        hinge b { start = rpy(0, 60, 0) deg; start_rate = [2, 0, 0] rad/s; }
        hinge c { start = rpy(0, 60, 0) deg; }
        hinge d { start = rpy(0, -60, 0) deg; }
    }
}

pub fn compare(progress: &Progress) -> Result<ClosedChainComparison, Error> {
    let chain = BetweenBalls::<f64>::new();
    let start = assembled(&chain)?;
    progress.begin("closed: links between two balls, generated code");
    let mut at = chain.workspace();
    let generated = motion(&chain, &start, progress, |time, state| {
        chain.solve_into(state, &chain.no_inputs(), &mut at)?;
        let links = [at.first(), at.second(), at.third()].map(|link| link.input());
        let centres = links.map(|at| at.position() + at.orientation() * Vector3::from(CENTRE));
        let end = at.d().input();
        let coordinates = centres.iter().flatten().copied().collect();
        let record = Record { time, coordinates, force: end.force().as_slice().into() };
        Ok((record, (end.position() - Vector3::from(END)).norm()))
    })?;

    chain.solve_into(&start, &chain.no_inputs(), &mut at)?;
    let accelerations = [at.b().input().acceleration(), at.c().input().acceleration()];
    progress.begin("closed: links between two balls, Newton–Euler");
    let newton_euler = newton_euler();
    let state = State { q: start.coordinates().to_vec(), v: start.rates().to_vec() };
    let at_start = solved(&newton_euler, &state);
    Ok(ClosedChainComparison {
        name: "links between two balls",
        reference: "Newton–Euler",
        start: Start {
            title: "links between two balls, accelerations of balls b and c at the start in m/s²",
            unit: "m/s²",
            names: &["ẍ of b", "ÿ of b", "z̈ of b", "ẍ of c", "ÿ of c", "z̈ of c"],
            generated: accelerations.iter().flatten().copied().collect(),
            reference: INNER.map(|point| at_start.points[point].acceleration).concat(),
        },
        motion: Motion {
            title: "links between two balls, position of the second one's centre of mass in m",
            unit: "m",
            shown: &[
                ShownCoordinate { index: 4, name: "y" },
                ShownCoordinate { index: 5, name: "z" },
            ],
            generated,
            reference: reference_motion(&newton_euler, &state, progress),
        },
        texts: Texts {
            file_name: "between_balls.svg",
            figure: "Links between two balls: centre of the second link, force at the closing ball",
            caption: "Lines: generated code. Crosses: the Newton–Euler equations of all links, with a \
                      Lagrange multiplier for each constrained direction.",
            axis: "position in m",
            note: "The reference has six coordinates per link and solves for all reactions at once. Three of \
                   the nine degrees of freedom are rotations of a link about the line between its balls.",
        },
        drawing: drawing([at.b().input().position(), at.c().input().position()]),
    })
}

/// Indices of connection points, which are the input of `a` and the outputs of all elements: the inputs of
/// the second and the third link, and the input of the last ball.
const INNER: [usize; 2] = [2, 4];
const CLOSING: usize = 6;

/// The same chain for the independent solver.
fn newton_euler() -> Chain {
    let ball = |name: &str| Element::Hinge(Hinge::new(name, HingeKind::Ball));
    let link = |name: &str| {
        Element::Body(Body {
            name: name.to_owned(),
            mass: 1.0,
            com: CENTRE,
            output: Frame::at([1.0, 0.0, 0.0]),
            inertia: [0.02, 0.09, 0.1, 0.0, 0.0, 0.0],
            about: About::Com,
            points: Vec::new(),
        })
    };
    let elements = vec![
        ball("a"),
        link("first"),
        ball("b"),
        link("second"),
        ball("c"),
        link("third"),
        ball("d"),
    ];
    let open = Chain::new("BetweenBalls", [0.0, -GRAVITY, 0.0], elements);
    Chain { finish: End::Held(Frame::at(END)), ..open }
}

fn solved(chain: &Chain, state: &State) -> Solution {
    chain.solve(state, &vec![0.0; chain.dof_count()])
}

/// The motion by the independent solver.
fn reference_motion(chain: &Chain, start: &State, progress: &Progress) -> Vec<Record> {
    let mut records = Vec::new();
    simulate(chain, start, &vec![0.0; chain.dof_count()], &mark_times(), |sample: &Sample| {
        let centres = sample.bodies.iter().flat_map(|body| body.position);
        records.push(Record {
            time: sample.time,
            coordinates: centres.collect(),
            force: solved(chain, &sample.state).points[CLOSING].force.to_vec(),
        });
        progress.reach(sample.time);
    });
    records
}

/// Draws the links in an oblique view, with the inner balls at their positions.
fn drawing([b, c]: [Vector3<f64>; 2]) -> Drawing {
    // The axis z points towards the reader, to the lower left.
    let seen = |p: Vector3<f64>| -> Point { [p.x - 0.45 * p.z, p.y - 0.35 * p.z] };
    let mut canvas = Canvas::new([-0.75, 2.6], [-0.75, 0.85], 420.0);
    let points = [Vector3::zeros(), b, c, Vector3::from(END)].map(seen);
    canvas.support(points[0], FROM_ABOVE);
    canvas.support(points[3], FROM_ABOVE);
    points.windows(2).for_each(|ends| canvas.rod(ends[0], ends[1]));
    for (point, (name, side)) in points.into_iter().zip([
        ("a", Side::Right),
        ("b", Side::Below),
        ("c", Side::Below),
        ("d", Side::Right),
    ]) {
        canvas.ball(point);
        canvas.text(point, side, name);
    }
    let origin = [-0.45, 0.3];
    for (axis, name, side) in [
        (Vector3::x(), "x", Side::Right),
        (Vector3::y(), "y", Side::Right),
        (Vector3::z(), "z", Side::Left),
    ] {
        let [x, y] = seen(axis * 0.4);
        let end = [origin[0] + x, origin[1] + y];
        canvas.arrow(origin, end);
        canvas.text(end, side, name);
    }
    canvas.gravity([2.35, -0.2]);
    canvas.finish(
        "Closed chains: links between two balls",
        "Three links of 1 m and 1 kg in an oblique view; gravity is along −y. Their centres of mass are 0.1 m away \
         from the lines between the balls.",
    )
}
