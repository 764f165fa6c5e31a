//! Three links in space that hang between two balls on the ground.

use mstmm::Error;
use mstmm::prelude::*;
use mstmm_reference::{
    About, Body, Chain, Element, End, Frame, Hinge, HingeKind, Sample, Solution, State, simulate,
};
use nalgebra::Vector3;

use super::beside::{Beside, Motion, Record, Shown, Start, Words, assembled, mark_times, motion};
use crate::output::progress::Progress;
use crate::system::GRAVITY;

/// The centre of mass of a link.
const CENTRE: [f64; 3] = [0.5, 0.0, 0.1];
/// Where the last ball is on the ground.
const END: [f64; 3] = [2.0, 0.3, 0.0];

mstmm_chain! {
    /// Links with their centres of mass beside the line between their balls, so that they roll.
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

pub fn beside(progress: &Progress) -> Result<Beside, Error> {
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
    Ok(Beside {
        name: "links between two balls",
        rival: "Newton–Euler",
        start: Start {
            title: "links between two balls, accelerations of balls b and c at the start in m/s²",
            unit: "m/s²",
            names: &["ẍ of b", "ÿ of b", "z̈ of b", "ẍ of c", "ÿ of c", "z̈ of c"],
            generated: accelerations.iter().flatten().copied().collect(),
            rival: INNER.map(|point| at_start.points[point].acceleration).concat(),
        },
        motion: Motion {
            title: "links between two balls, position of the second one's centre of mass in m",
            unit: "m",
            shown: &[Shown { place: 4, name: "y" }, Shown { place: 5, name: "z" }],
            generated,
            rival: moved(&newton_euler, &state, progress),
        },
        words: Words {
            file_name: "between_balls.svg",
            figure: "Links closed over ground by two balls: centre of the second, force at the closing ball",
            figure_says: "Lines are generated code, crosses Newton's and Euler's equations of all \
                          links with a multiplier for every direction that a ball holds.",
            axis: "position in m",
            says: vec![
                "The rival keeps six coordinates for every link and solves for all reactions at once.",
                "Of nine freedoms three are rolls of the links about their own lines. Motion and force",
                "are the same.",
            ],
        },
    })
}

/// Places among the connection points, which are the input of `a` and the outputs of all that follows:
/// before the second and the third link, and before the last ball.
const INNER: [usize; 2] = [2, 4];
const CLOSING: usize = 6;

/// The same chain as the independent solver takes it.
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

/// The rival's motion.
fn moved(chain: &Chain, start: &State, progress: &Progress) -> Vec<Record> {
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
