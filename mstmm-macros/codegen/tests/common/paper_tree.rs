//! Trees for the reference solver, the compiler and the paper's matrices: a free hub with three arms of pins.

use super::paper::{
    GRAVITY, about_com, cube, frame_about, matrix, plain, random_body, reported, vector,
};
use super::{Point, compute, read};
use mstmm_codegen::equations::Axes;
use mstmm_codegen::math::Structured;
use mstmm_codegen::model::SolutionMethod;
use mstmm_reference::{
    self as reference, Element, End, Frame, Hinge, HingeKind, NamedPoint, Random, State,
};
use mstmm_runtime::nalgebra::{Matrix3, SVector, Vector3};
use mstmm_runtime::paper::body::{Body, Load, Motion};
use mstmm_runtime::paper::chain::OutputEnd;
use mstmm_runtime::paper::pin::Pin;
use mstmm_runtime::paper::tree::{self, Columns, FurtherInput};
use mstmm_runtime::paper::{TransferMatrix, state};

pub const ARMS: usize = 3;

/// The number of unknowns: six at each tip, and Θ̈ of each pin at the hub.
const UNKNOWNS: usize = 7 * ARMS;

/// A body of an arm, with the axis of the pin at its input.
type Link = (Body<f64>, Vector3<f64>);

/// A free hub with arms of equal length. The input of each body is at the side of the hub.
pub struct Tree {
    pub hub: Body<f64>,
    /// The first points of the arms, in the hub's frame.
    pub places: [Vector3<f64>; ARMS],
    /// The bodies of each arm from the hub on.
    pub arms: [Vec<Link>; ARMS],
}

/// A connection point in motion.
pub struct Place {
    pub motion: Motion<f64>,
    /// The state vector for a transfer from the tips to the hub.
    pub z: SVector<f64, 13>,
}

/// The elements of an arm from the tip to the hub.
pub struct ArmElements {
    pub bodies: Vec<TransferMatrix<f64>>,
    /// The pin at the output of each body.
    pub pins: Vec<Pin<f64>>,
}

/// The elements of a tree in motion.
pub struct Elements {
    pub arms: [ArmElements; ARMS],
    /// The matrix of the hub, from its first input to the origin of its frame.
    pub hub: TransferMatrix<f64>,
    pub further: [FurtherInput<f64>; ARMS - 1],
}

impl Tree {
    /// Returns a tree of random bodies and axes.
    pub fn random(random: &mut Random, count: usize) -> Self {
        let arm = |random: &mut Random| {
            (0..count).map(|_| (random_body(random), super::paper::axis(random))).collect()
        };
        Tree {
            hub: random_body(random),
            places: [0; ARMS].map(|_| vector(random, 1.0)),
            arms: [0; ARMS].map(|_| arm(random)),
        }
    }

    /// Returns a tree of the paper's cubes on a larger one, with oblique pins.
    pub fn of_cubes(count: usize) -> Self {
        let axes = [[1.0, 2.0, 3.0], [1.0, 1.0, 2.0], [0.0, 1.0, 3.0]];
        let arm = |arm: usize| {
            let axis = |k: usize| Vector3::from(axes[(arm + k) % 3]).normalize();
            (0..count).map(|k| (cube(), axis(k))).collect()
        };
        let hub = Body {
            mass: 8.0,
            com: Vector3::zeros(),
            output: Vector3::zeros(),
            inertia: Matrix3::identity() * (16.0 / 3.0),
        };
        let places = [Vector3::x(), Vector3::y(), -Vector3::x()];
        Tree { hub, places, arms: std::array::from_fn(arm) }
    }

    fn count(&self) -> usize {
        self.arms[0].len()
    }

    /// Returns the tree as the reference solver describes it.
    pub fn reference(&self) -> reference::Chain {
        let mut hub = described("hub", &self.hub);
        let point = |(arm, place): (usize, &Vector3<f64>)| NamedPoint {
            name: format!("p{arm}"),
            frame: Frame::at((*place).into()),
        };
        hub.points = self.places.iter().enumerate().map(point).collect();
        let route = |(arm, bodies): (usize, &Vec<Link>)| {
            let elements = bodies.iter().enumerate().flat_map(|(k, (body, axis))| {
                let name = |letter: &str| format!("{letter}{arm}_{k}");
                let kind = HingeKind::Pin { axis: (*axis).into() };
                let hinge = Element::Hinge(Hinge::new(&name("j"), kind));
                [hinge, Element::Body(described(&name("b"), body))]
            });
            reference::Route::from_place("hub", &format!("p{arm}"), elements.collect())
        };
        let chain = reference::Chain::new("Tree", GRAVITY, vec![Element::Body(hub)]);
        reference::Chain {
            start: End::Free,
            later_routes: self.arms.iter().enumerate().map(route).collect(),
            ..chain
        }
    }

    /// Returns a random state, in numbers that are exact in `f32`.
    pub fn random_state(&self, seed: u64) -> State {
        let mut random = Random::new(seed);
        let pins = ARMS * self.count();
        let mut short = |limit: f64| f64::from(random.between(-limit, limit) as f32);
        let mut q: Vec<f64> = (0..7 + pins).map(|_| short(1.0)).collect();
        let v = (0..6 + pins).map(|_| short(2.0)).collect();
        let length = q[3..7].iter().map(|x| x * x).sum::<f64>().sqrt();
        q[3..7].iter_mut().for_each(|x| *x /= length);
        State { q, v }
    }

    /// Returns the elements, with the motion of all points and the rates of the state.
    pub fn elements(&self, places: &[Place], v: &[f64]) -> Elements {
        let arm = |arm: usize| {
            let motion = |k: usize| match k {
                0 => &places[0].motion,
                _ => &places[self.input(arm, k - 1)].motion,
            };
            let body = |k: usize| transfer_matrix(&reversed(&self.arms[arm][k].0), motion(k + 1));
            let pin = |k: usize| Pin {
                orientation: motion(k).orientation * frame_about(&self.arms[arm][k].1),
                angular_velocity: motion(k).angular_velocity,
                rate: -v[6 + arm * self.count() + k],
            };
            let inwards = || (0..self.count()).rev();
            ArmElements {
                bodies: inwards().map(body).collect(),
                pins: inwards().map(pin).collect(),
            }
        };
        let [first, ..] = self.places;
        let hub = about(&self.hub, &first, &Vector3::zeros());
        let motion = &places[0].motion;
        let further = |k: usize| FurtherInput::new(&hub, motion, &(self.places[k + 1] - first));
        Elements {
            arms: std::array::from_fn(arm),
            hub: transfer_matrix(&hub, motion),
            further: std::array::from_fn(further),
        }
    }

    /// Returns the index of a body's input among the connection points; its output follows.
    fn input(&self, arm: usize, body: usize) -> usize {
        2 + ARMS + 2 * (arm * self.count() + body)
    }

    /// Returns the state vectors at all points: for each arm from the tip to the hub, those at the input and the output of
    /// each body and at the input of the hub; then the one at the output of the hub.
    pub fn states(&self, places: &[Place]) -> Vec<SVector<f64, 13>> {
        let ends = |arm: usize, k: usize| [self.input(arm, k) + 1, self.input(arm, k)];
        let along =
            |arm: usize| (0..self.count()).rev().flat_map(move |k| ends(arm, k)).chain([2 + arm]);
        (0..ARMS).flat_map(along).chain([0]).map(|point| places[point].z).collect()
    }

    /// Returns the connection points as the reference solver computes them.
    pub fn independent(&self, state: &State) -> Vec<Place> {
        let chain = self.reference();
        let efforts = vec![0.0; chain.dof_count()];
        chain.solve(state, &efforts).points.iter().map(Place::of_reference).collect()
    }

    /// Returns the connection points as the compiler's equations compute them by Riccati's method.
    pub fn riccati(&self, state: &State) -> Vec<Place> {
        let (way, efforts) = ((SolutionMethod::Riccati, Axes::Body), vec![0.0; state.v.len()]);
        let chain = read(&self.reference().to_macro_text(None));
        let computed = compute::<f64>(&chain, way, &state.q, &state.v, &efforts);
        computed.report.points.iter().map(Place::of_compiler).collect()
    }
}

impl ArmElements {
    /// Returns the matrices of an arm, except that of its last pin: body, pin, body, …, body.
    fn matrices(&self) -> Vec<TransferMatrix<f64>> {
        let ArmElements { bodies, pins } = self;
        let neighbours = bodies.iter().skip(1).zip(pins.windows(2));
        let pairs = neighbours.flat_map(|(body, pins)| {
            [pins[0].blocks(body, &pins[1].orientation).transfer_matrix(), *body]
        });
        [bodies[0]].into_iter().chain(pairs).collect()
    }
}

impl Elements {
    /// Solves the overall equation and returns the state vectors in the order of [`Tree::states`].
    pub fn solve(&self) -> Vec<SVector<f64, 13>> {
        let (mut conditions, mut inputs, mut states) = (Vec::new(), Vec::new(), Vec::new());
        for (k, arm) in self.arms.iter().enumerate() {
            let mut z = Columns::<f64, 13, UNKNOWNS>::free_tip(7 * k);
            states.push(z);
            for element in arm.matrices() {
                z = z.through(&element);
                states.push(z);
            }
            conditions.extend(
                states[states.len() - 2 * arm.bodies.len() + 1].axial_moment(&arm.pins[0]).rows(),
            );
            z = z.over_pin(&arm.pins[arm.pins.len() - 1], 7 * k + 6);
            states.push(z);
            inputs.push(z);
        }
        let mut output = inputs[0].through(&self.hub);
        for (further, input) in self.further.iter().zip(&inputs[1..]) {
            conditions.extend(further.geometric_equations(&inputs[0], input).rows());
            output = output + input.through(&further.transfer_matrix());
        }
        conditions.extend(output.through(&OutputEnd::free().conditions).rows());
        states.push(output);
        let x = tree::solve::<f64, UNKNOWNS, UNKNOWNS>(conditions);
        states.iter().map(|z| z.at(&x)).collect()
    }
}

impl Place {
    /// Returns a point as the reference solver computes it.
    pub fn of_reference(point: &reference::Point) -> Self {
        let rows = point.rotation;
        let motion = Motion {
            orientation: Matrix3::from_fn(|row, column| rows[row][column]),
            angular_velocity: point.angular_velocity.into(),
        };
        let [linear, angular, moment, force] =
            [point.acceleration, point.angular_acceleration, point.moment, point.force]
                .map(Vector3::from);
        Place { motion, z: state::column(&linear, &angular, &-moment, &-force) }
    }

    /// Returns a point as the compiler's equations compute it.
    pub fn of_compiler(point: &Point<Structured<f64>>) -> Self {
        let motion =
            Motion { orientation: matrix(point.rotation), angular_velocity: plain(point.omega) };
        let mut z = reported(point);
        for k in 6..12 {
            z[k] = -z[k];
        }
        Place { motion, z }
    }
}

/// Returns a body as the reference solver describes it.
fn described(name: &str, body: &Body<f64>) -> reference::Body {
    let entries = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].map(|at| body.inertia[at]);
    reference::Body {
        name: name.to_owned(),
        mass: body.mass,
        com: body.com.into(),
        output: Frame::at(body.output.into()),
        inertia: entries,
        about: reference::About::Input,
        points: Vec::new(),
    }
}

/// Returns the same body with the given input and output.
fn about(body: &Body<f64>, input: &Vector3<f64>, output: &Vector3<f64>) -> Body<f64> {
    let Body { mass, com, inertia, .. } = body;
    let inertia = inertia - about_com(*mass, com) + about_com(*mass, &(com - input));
    Body { mass: *mass, com: com - input, output: output - input, inertia }
}

/// Returns a body with input and output exchanged.
fn reversed(body: &Body<f64>) -> Body<f64> {
    about(body, &body.output, &Vector3::zeros())
}

fn transfer_matrix(body: &Body<f64>, motion: &Motion<f64>) -> TransferMatrix<f64> {
    let load = Load { force: Vector3::from(GRAVITY) * body.mass, moment: Vector3::zeros() };
    body.blocks(motion, &load).transfer_matrix()
}
