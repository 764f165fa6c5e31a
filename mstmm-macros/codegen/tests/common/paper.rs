//! Chains for the compiler and for the paper's matrices.

use super::{Computed, Point, compute, read};
use mstmm_codegen::equations::Axes;
use mstmm_codegen::math::{Mat3, Scalar, Structured, Vec3};
use mstmm_codegen::model::SolutionMethod;
use mstmm_reference::Random;
use mstmm_runtime::Scalar as Number;
use mstmm_runtime::nalgebra::{Matrix3, SMatrix, SVector, Vector3};
use mstmm_runtime::paper::body::{Body, Load, Motion};
use mstmm_runtime::paper::pin::{self, Pin};
use mstmm_runtime::paper::{TransferMatrix, acceleration_hinge, ball, state};

pub const GRAVITY: [f64; 3] = [0.3, -9.8, 0.2];

/// The kind of all hinges of a chain.
#[derive(Clone, Debug)]
pub enum Hinges {
    Balls,
    /// Pins about these axes, in body frames.
    Pins(Vec<Vector3<f64>>),
    Floating,
}

/// A chain from the ground to a free end.
pub struct Case {
    pub hinges: Hinges,
    pub bodies: Vec<Body<f64>>,
    /// The loads in addition to weight.
    pub loads: Vec<Load<f64>>,
}

/// A case in motion: the compiler's results, and the rates.
pub struct Moving<S: Scalar> {
    pub computed: Computed<S>,
    pub rates: Vec<f64>,
}

pub fn vector(random: &mut Random, size: f64) -> Vector3<f64> {
    Vector3::from_fn(|_, _| random.between(-size, size))
}

/// Returns a random vector that is not close to zero.
pub fn axis(random: &mut Random) -> Vector3<f64> {
    loop {
        let axis = vector(random, 1.0);
        if axis.norm() > 0.3 {
            return axis.normalize();
        }
    }
}

/// Returns a random body, whose inertia is that of a few point masses.
pub fn random_body(random: &mut Random) -> Body<f64> {
    let (mass, com) = (random.between(0.5, 2.0), vector(random, 0.5));
    let inertia = (0..5).fold(about_com(mass, &com), |sum, _| {
        sum + about_com(random.between(0.05, 0.3), &vector(random, 1.0))
    });
    Body { mass, com, output: vector(random, 1.0), inertia }
}

/// Returns the inertia of a point mass about a point at distance `arm` from it.
pub fn about_com(mass: f64, arm: &Vector3<f64>) -> Matrix3<f64> {
    (Matrix3::identity() * arm.norm_squared() - arm * arm.transpose()) * mass
}

/// Returns a body's type in the language of the macro.
pub fn declared(k: usize, body: &Body<f64>) -> String {
    let Body { mass, com, output, inertia } = body;
    let entries = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].map(|at| inertia[at]);
    let [xx, yy, zz, xy, xz, yz] = entries;
    format!(
        "body B{k} {{ mass = {mass:?} kg; com = {} m; output = {} m;
        inertia = tensor({xx:?}, {yy:?}, {zz:?}, {xy:?}, {xz:?}, {yz:?}) kg*m^2 about input; }}\n",
        list(com),
        list(output),
    )
}

/// The homogeneous cube of [P, Section 4.1].
pub fn cube() -> Body<f64> {
    Body {
        mass: 1.0,
        com: Vector3::new(0.5, 0.0, 0.0),
        output: Vector3::new(1.0, 0.0, 0.0),
        inertia: Matrix3::from_diagonal(&Vector3::new(1.0 / 6.0, 5.0 / 12.0, 5.0 / 12.0)),
    }
}

impl Case {
    pub fn random(random: &mut Random, hinges: Hinges, count: usize) -> Self {
        let load =
            |random: &mut Random| Load { force: vector(random, 3.0), moment: vector(random, 1.0) };
        Case {
            hinges,
            bodies: (0..count).map(|_| random_body(random)).collect(),
            loads: (0..count).map(|_| load(random)).collect(),
        }
    }

    pub fn of_cubes(hinges: Hinges, count: usize) -> Self {
        let none = Load { force: Vector3::zeros(), moment: Vector3::zeros() };
        Case { hinges, bodies: vec![cube(); count], loads: vec![none; count] }
    }

    fn text(&self) -> String {
        let (mut types, mut route, mut loads) =
            (String::new(), String::from("ground"), String::new());
        for (k, (body, load)) in self.bodies.iter().zip(&self.loads).enumerate() {
            types += &declared(k, body);
            let hinge = match &self.hinges {
                Hinges::Balls => "ball".to_owned(),
                Hinges::Pins(axes) => format!("pin({})", list(&axes[k])),
                Hinges::Floating => "floating".to_owned(),
            };
            route += &format!(" -> {hinge} j{k} -> B{k} b{k}");
            loads += &format!(
                "load l{k} {{ on = b{k}; force = {} N; torque = {} N*m; }}\n",
                list(&load.force),
                list(&load.moment)
            );
        }
        let gravity = list(&GRAVITY.into());
        format!("chain Case {{ gravity = {gravity} m/s^2; {types} {route}; {loads} }}")
    }

    /// Runs the compiler's equations at a random state.
    pub fn at_random<S: Scalar>(&self, seed: u64, method: SolutionMethod) -> Moving<S> {
        let mut random = Random::new(seed);
        let chain = read(&self.text());
        // The numbers are exact in `f32`, so that all precisions solve the same problem.
        let mut short = |limit: f64| f64::from(random.between(-limit, limit) as f32);
        let (mut q, mut v) = (Vec::new(), Vec::new());
        for hinge in &chain.hinges {
            q.extend((0..hinge.kind.coordinates()).map(|_| short(1.0)));
            v.extend((0..hinge.kind.dof_count()).map(|_| short(2.0)));
            if hinge.kind.coordinates() > 3 {
                let quaternion = q.split_off(q.len() - 4);
                let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
                q.extend(quaternion.iter().map(|x| x / length));
            }
        }
        self.at(method, &q, &v)
    }

    /// Runs the compiler's equations at a state.
    pub fn at<S: Scalar>(&self, method: SolutionMethod, q: &[f64], v: &[f64]) -> Moving<S> {
        let chain = read(&self.text());
        let computed = compute(&chain, (method, Axes::Body), q, v, &vec![0.0; v.len()]);
        Moving { computed, rates: v.to_vec() }
    }

    /// Returns U₁ to U_n of the paper: hinge, body, hinge, body, ….
    pub fn elements<T: Number>(&self, moving: &Moving<f64>) -> Vec<TransferMatrix<T>> {
        let points = &moving.computed.report.points;
        let bodies: Vec<TransferMatrix<T>> =
            (0..self.bodies.len()).map(|k| self.body(k, &points[2 * k + 1])).collect();
        let hinge = |k: usize| match &self.hinges {
            Hinges::Balls => ball::transfer_matrix(&bodies[k]),
            Hinges::Floating => acceleration_hinge::Blocks::of(&bodies[k]).transfer_matrix(),
            Hinges::Pins(_) => self.pin_blocks(k, moving, &bodies[k]).transfer_matrix(),
        };
        (0..bodies.len()).flat_map(|k| [hinge(k), bodies[k]]).collect()
    }

    /// Returns the transfer matrix of body `k`, whose input is `point`.
    fn body<T: Number>(&self, k: usize, point: &Point<Structured<f64>>) -> TransferMatrix<T> {
        let Body { mass, com, output, inertia } = &self.bodies[k];
        let body = Body {
            mass: T::constant(*mass),
            com: cast(com),
            output: cast(output),
            inertia: cast(inertia),
        };
        let motion = Motion {
            orientation: cast(&matrix(point.rotation)),
            angular_velocity: cast(&plain(point.omega)),
        };
        let weight = Vector3::from(GRAVITY) * *mass;
        let Load { force, moment } = &self.loads[k];
        let load = Load { force: cast(&(weight + force)), moment: cast(moment) };
        body.blocks(&motion, &load).transfer_matrix()
    }

    /// Returns pin `k` as the paper describes it.
    pub fn pin<T: Number>(&self, k: usize, moving: &Moving<f64>) -> Pin<T> {
        let Hinges::Pins(axes) = &self.hinges else { panic!("no pins") };
        let point = &moving.computed.report.points[2 * k + 1];
        Pin {
            orientation: cast(&(matrix(point.rotation) * frame_about(&axes[k]))),
            angular_velocity: cast(&plain(point.omega)),
            rate: T::constant(moving.rates[k]),
        }
    }

    /// Returns E₀ to E₅ of pin `k`; the last pin uses its own axis as that of the next.
    pub fn pin_blocks<T: Number>(
        &self,
        k: usize,
        moving: &Moving<f64>,
        body: &TransferMatrix<T>,
    ) -> pin::Blocks<T> {
        let Hinges::Pins(axes) = &self.hinges else { panic!("no pins") };
        let pin = self.pin(k, moving);
        let point = &moving.computed.report.points[2 * k + 1];
        let next = axes.get(k + 1).filter(|_| k + 1 < self.bodies.len());
        let next = next
            .map_or(pin.orientation, |axis| cast(&(matrix(point.rotation) * frame_about(axis))));
        pin.blocks(body, &next)
    }
}

/// Returns a rotation whose third axis is `axis`.
pub fn frame_about(axis: &Vector3<f64>) -> Matrix3<f64> {
    let other = if axis.x.abs() < 0.6 { Vector3::x() } else { Vector3::y() };
    let second = axis.cross(&other).normalize();
    Matrix3::from_columns(&[second.cross(axis), second, *axis])
}

pub fn list(vector: &Vector3<f64>) -> String {
    format!("{:?}", vector.as_slice())
}

/// Converts numbers to another precision.
pub fn cast<T: Number, const R: usize, const C: usize>(
    matrix: &SMatrix<f64, R, C>,
) -> SMatrix<T, R, C> {
    matrix.map(T::constant)
}

pub fn plain(vector: Vec3<Structured<f64>>) -> Vector3<f64> {
    Vector3::from(vector.0.map(|x| x.value()))
}

pub fn matrix(matrix: Mat3<Structured<f64>>) -> Matrix3<f64> {
    Matrix3::from_fn(|row, column| matrix.0[row][column].value())
}

/// Returns z as the compiler reports it.
pub fn reported(point: &Point<Structured<f64>>) -> SVector<f64, 13> {
    let Point { acceleration, moment, force, .. } = *point;
    let [linear, angular, moment, force] =
        [acceleration.linear, acceleration.angular, moment, force].map(plain);
    state::column(&linear, &angular, &moment, &force)
}

/// Returns the largest difference of two columns, relative to the largest entry of the second.
pub fn apart<const D: usize>(a: &SVector<f64, D>, b: &SVector<f64, D>) -> f64 {
    super::difference(a.as_slice(), b.as_slice())
}
