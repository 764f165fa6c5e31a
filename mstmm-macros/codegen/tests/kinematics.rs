//! Kinematics and Jacobians of random chains and trees, read by the types of the runtime, against the connection points of
//! the whole solution.

mod common;

#[path = "kinematics/points.rs"]
mod points;
#[allow(dead_code)]
#[path = "answers_random/samples.rs"]
mod samples;
#[path = "kinematics/virtual_work.rs"]
mod virtual_work;

use common::interpreter::run;
use common::numbers;
use common::points::element_points;
use mstmm_codegen::compile::{RatePaths, outputs};
use mstmm_codegen::model::{Answer, BodyFrame, Element, Layout};
use mstmm_codegen::program::{Argument, Given};
use points::{Asked, BodyAt, Seen, bodies, see};
use samples::{Kind, Sample, dot, largest, samples, times};

/// Positions, velocities and accelerations are sums over at most some tens of hinges, relative to the largest value of their
/// kind in the sample.
const SUMS: f64 = 1e-12;
/// The solution loses as many digits of the accelerations as the condition number of the mass matrix has.
const SOLVED: f64 = 1e-10;

fn check(kind: Kind, seeds: std::ops::Range<u64>) {
    for sample in samples(kind, seeds, "jacobian") {
        at_all_points(&sample);
        products(&sample);
        jacobians_of_end_bodies(&sample);
    }
}

#[test]
fn routes() {
    check(Kind::Route, 0..120);
}

#[test]
fn trees() {
    check(Kind::Tree, 1000..1060);
}

#[test]
fn parts_and_repeated_parts() {
    check(Kind::Described, 2000..2060);
}

#[test]
fn parameters() {
    check(Kind::Lifted, 3000..3030);
}

/// The results of the function for kinematics.
struct Moving<'a> {
    sample: &'a Sample,
    motions: Vec<f64>,
    columns: Vec<f64>,
    layout: Layout,
    paths: RatePaths,
}

impl<'a> Moving<'a> {
    /// Calls the function, with other rates than those of the state if they are given.
    fn new(sample: &'a Sample, rates: Option<&[f64]>) -> Self {
        let mut given = sample.given::<f64>();
        if let Some(rates) = rates {
            given.arrays.arguments.insert(Argument::Rates, rates.to_vec());
        }
        let found = sample.all(&given, Answer::Kinematics, &[]);
        let layout = Layout::of(&sample.chain);
        let paths = RatePaths::of(&sample.chain, &layout);
        let [motions, columns] = [outputs::MOTIONS, outputs::COLUMNS].map(|id| found.result(id));
        Self { sample, motions, columns, layout, paths }
    }

    /// Returns the kinematics of a point of a body, given its place in the body frame; without a place, of its input.
    fn see(&self, at: &BodyAt, place: Vec<f64>, asked: &Asked) -> Seen {
        let run = self.paths.of_body(&self.layout, at.body);
        let stored = (&self.motions[..], &self.columns[..]);
        see(self.sample.chain.dimension, stored, (&self.paths, run), (at, place), asked)
    }
}

/// Returns the kinematics of points of all bodies, their places in the body frame, and what is asked.
fn seen(sample: &Sample, rates: Option<&[f64]>, at_output: bool, asked: &Asked) -> Vec<Seen> {
    let (chain, moving) = (&sample.chain, Moving::new(sample, rates));
    let values = numbers::<f64>(chain);
    let of_body = |at: &BodyAt| {
        let place = match at_output {
            true => chain.frame_values(&chain.bodies[at.body], BodyFrame::Output).position,
            false => Vec::new(),
        };
        let place = place.into_iter().map(|value| values.scalar(value).value()).collect();
        moving.see(at, place, asked)
    };
    bodies(chain).iter().map(of_body).collect()
}

/// Positions, orientations, velocities and accelerations are those of the connection points.
fn at_all_points(sample: &Sample) {
    let given = sample.given::<f64>();
    let full = sample.all(&given, Answer::Solution, &[]);
    let accelerations = full.result(outputs::ACCELERATIONS);
    let zero = vec![0.0; sample.rates()];
    let asked = Asked { rates: sample.state.v.clone(), accelerations, ..Asked::default() };
    let elements = element_points(&sample.chain, &sample.compiled, &full);
    let order = elements_in_order(sample);
    let of_bodies: Vec<_> = elements.iter().zip(order).filter(|(_, is_body)| *is_body).collect();
    for at_output in [false, true] {
        let found = seen(sample, None, at_output, &asked);
        let at_rest = seen(sample, Some(&zero), at_output, &asked);
        assert_eq!(found.len(), of_bodies.len(), "{}", sample.named("bodies"));
        let mut columns: [(&str, f64, Vec<f64>, Vec<f64>); 7] = [
            ("positions", SUMS, vec![], vec![]),
            ("orientations", SUMS, vec![], vec![]),
            ("velocities", SUMS, vec![], vec![]),
            ("angular velocities", SUMS, vec![], vec![]),
            ("accelerations", SOLVED, vec![], vec![]),
            ("angular accelerations", SOLVED, vec![], vec![]),
            ("J v", SUMS, vec![], vec![]),
        ];
        for ((own, rest), (of_element, _)) in found.iter().zip(&at_rest).zip(&of_bodies) {
            let expected = if at_output { &of_element.output } else { &of_element.input };
            let quantities = own.quantities();
            let mut expected = expected.iter().copied();
            for (index, own) in quantities.iter().enumerate() {
                let expected = expected.by_ref().take(own.len());
                if index == 1 && at_output {
                    // The output has a frame that may be rotated.
                    expected.for_each(drop);
                    continue;
                }
                columns[index].3.extend(expected);
                columns[index].2.extend(own.iter());
            }
            let moved = own.velocity.iter().chain(&own.omega);
            let moved = moved.zip(rest.velocity.iter().chain(&rest.omega));
            columns[6].2.extend(&own.jacobian_times_rates);
            columns[6].3.extend(moved.map(|(moving, rest)| moving - rest));
        }
        for (what, tolerance, found, expected) in columns {
            let scale = largest(&expected);
            sample.check(what, (&found, &expected), scale, tolerance);
        }
    }
}

/// Returns for each element, with repeated ones written out, whether it is a body.
fn elements_in_order(sample: &Sample) -> Vec<bool> {
    let chain = &sample.chain;
    let part = |element: &Element| match *element {
        Element::Hinge(hinge) => chain.repeat_of_hinge(hinge),
        Element::Body(body) => chain.repeat_of_body(body),
    };
    let mut all = Vec::new();
    for segment in chain.elements.chunk_by(|one, next| part(one) == part(next)) {
        for _ in 0..part(&segment[0]).map_or(1, |part| chain.repeats[part].count) {
            all.extend(segment.iter().map(|element| matches!(element, Element::Body(_))));
        }
    }
    all
}

/// The products with a vector are those of the matrix, and so are the products with a wrench; columns of rates that do not
/// move the body vanish, since the velocity of the body does not depend on them.
fn products(sample: &Sample) {
    let rows = sample.chain.dimension.axes().len();
    let (x, zero) = (sample.random_rates(1), vec![0.0; sample.rates()]);
    let wrench: Vec<f64> = (0..rows).map(|k| (1.0 + k as f64).sin()).collect();
    let asked = Asked { rates: x.clone(), accelerations: zero, wrench: wrench.clone() };
    for seen in seen(sample, None, true, &asked) {
        let jacobian: Vec<Vec<f64>> =
            seen.jacobian.iter().map(|row| row[..sample.rates()].to_vec()).collect();
        let scale = largest(&jacobian.concat()) * (1.0 + sample.rates() as f64);
        let product = times(&jacobian, &x);
        sample.check("J x", (&seen.jacobian_times_rates, &product), scale, SUMS);
        let efforts = &seen.transpose_times_wrench[..sample.rates()];
        let expected: Vec<f64> = (0..sample.rates())
            .map(|j| dot(&jacobian.iter().map(|row| row[j]).collect::<Vec<_>>(), &wrench))
            .collect();
        sample.check("Jᵀ w", (efforts, &expected), scale, SUMS);
    }
}

/// The Jacobian of a body at a free end is that of its kinematics, column by column. Both are sums over the hinges of the
/// path, in another order.
fn jacobians_of_end_bodies(sample: &Sample) {
    let (chain, compiled) = (&sample.chain, &sample.compiled);
    if compiled.jacobians.is_empty() {
        return;
    }
    let of_bodies = seen(sample, None, true, &Asked::default());
    let values = numbers::<f64>(chain);
    for (body, procedure) in &compiled.jacobians {
        let place = chain.frame_values(&chain.bodies[*body], BodyFrame::Output).position;
        let place = place.into_iter().map(|value| values.scalar(value).value()).collect();
        let mut arrays = sample.given::<f64>().arrays;
        arrays.arguments.insert(Argument::Given(Given::Place), place);
        run(procedure, &mut arrays)
            .unwrap_or_else(|error| panic!("{}: {error:?}", sample.named("jacobian")));
        let found = arrays.result(outputs::MATRIX);
        let index = bodies(chain).iter().position(|at| at.body == *body).expect("a body");
        let rows = chain.dimension.axes().len();
        let jacobian = &of_bodies[index].jacobian;
        let entry = |(column, row): (usize, usize)| jacobian[row][column];
        let all = (0..sample.rates()).flat_map(|column| (0..rows).map(move |row| (column, row)));
        let expected: Vec<f64> = all.map(entry).collect();
        let positions: Vec<f64> = of_bodies.iter().flat_map(|seen| seen.position.clone()).collect();
        let scale = largest(&expected).max(largest(&positions));
        sample.check("Jacobian of a body", (&found, &expected), scale, SUMS);
    }
}

#[test]
fn end_bodies_have_jacobians() {
    let count = |kind, seeds: std::ops::Range<u64>| -> usize {
        samples(kind, seeds, "jacobian").map(|sample| sample.compiled.jacobians.len()).sum()
    };
    assert!(count(Kind::Route, 0..20) > 5);
    assert!(count(Kind::OpenTree, 1000..1010) > 5);
}
