//! Answers about a chain by their definitions, in twice the working precision.
//!
//! Nothing here is a recursion of rigid-body dynamics. The poses of all bodies depend on time through the
//! coordinates; their first two derivatives are carried along with their values, so that velocities,
//! accelerations and Jacobians are the derivatives of poses. Efforts follow from the virtual power of
//! d'Alembert's principle at unit rates, derivatives with respect to states and inputs from central
//! differences, and accelerations from the dense mass matrix.
//!
//! # Notation
//!
//! | symbol | meaning | axes |
//! |---|---|---|
//! | `v_k`, `ω_k` | velocity of a body's frame and its angular velocity if rate `k` is 1 and all others, prescribed ones and moving frames included, are 0 | inertial |
//! | `F`, `N` | force and moment about the frame's origin that accelerate a body | inertial |
//! | `τ_k = Σ F·v_k + N·ω_k` | effort of the drive of rate `k` | rates |

mod change;
mod coriolis;
mod differences;
mod external;
mod graph;
mod hinge;
mod inertial_parameters;
mod jet;
mod linear;
mod momentum;
mod passive;
mod space;

pub use change::Change;
pub use momentum::Momentum;

use crate::chain::{Chain, State};
use crate::double_double::DoubleDouble;
use crate::drives::Drives;
use crate::hinge::Source;
use crate::load::Load;
use crate::mechanism::Mechanism;
use external::{acting, place, wrench};
use graph::{Moves, closing_joint, joint_motion, poses};
use hinge::Motion;
use inertial_parameters::Matter;
use linear::solved;
use passive::passive;
use space::{
    Matrix, Pose, Vector, constant_matrix, cross, dot, minus, plus, product, scaled, times,
    transposed,
};

/// The numbers of this module.
type Real = DoubleDouble;

/// The answers about a chain in a state.
pub struct Answers<'a> {
    mechanism: Mechanism<'a>,
    closing: Option<usize>,
    now: Now,
}

/// Everything that derivatives are taken by.
#[derive(Clone)]
struct Now {
    /// The time for which frames move at their velocities, to first order.
    time: Real,
    q: Vec<Real>,
    v: Vec<Real>,
    /// The given accelerations of inverse dynamics.
    a: Vec<Real>,
    /// The motion of every prescribed hinge, by joints.
    prescribed: Vec<Option<Motion>>,
    efforts: Vec<Real>,
    loads: Vec<[Vector; 2]>,
    /// The forces of the actuators of springs.
    actuators: Vec<Real>,
    gravity: Vector,
    matter: Vec<Matter>,
}

impl Now {
    /// Returns the same without loads and without the actuators of springs.
    fn without_loads(&self) -> Now {
        Now {
            loads: vec![[[Real::new(0.0); 3]; 2]; self.loads.len()],
            actuators: vec![Real::new(0.0); self.actuators.len()],
            ..self.clone()
        }
    }
}

/// The velocity of a body's frame and its angular velocity.
type Twist = [Vector; 2];

impl Chain {
    /// Returns the answers in a state.
    ///
    /// # Panics
    ///
    /// Panics if the state or the drives have the wrong length.
    pub fn answers<'a>(&'a self, state: &State, drives: &'a Drives) -> Answers<'a> {
        self.check_lengths(state, drives);
        let mechanism = Mechanism::new(self, drives);
        let prescribed = mechanism.joints.iter().map(|joint| {
            let motion = joint.prescribed?;
            Some(Motion { q: reals(&motion.q), v: reals(&motion.v), a: reals(&motion.a) })
        });
        let base = reals(&vec![0.0; self.base_dof_count()]);
        let free = mechanism.joints.iter().filter(|joint| joint.prescribed.is_none());
        let motors = free.flat_map(|joint| reals(&joint.motor));
        let load = |(load, input): (&Load, &crate::drives::LoadInput)| {
            let vector = |source: &Source<[f64; 3]>, input: [f64; 3]| match source {
                Source::None => [0.0; 3],
                Source::Constant(constant) => *constant,
                Source::Input => input,
            };
            let both = [vector(&load.force, input.force), vector(&load.torque, input.torque)];
            both.map(|vector| vector.map(Real::new))
        };
        let actuators = self.springs.iter().zip(&drives.springs);
        let actuators = actuators.map(|(spring, &input)| spring.actuator(input));
        let now = Now {
            time: Real::new(0.0),
            q: reals(&state.q),
            v: reals(&state.v),
            a: reals(&vec![0.0; state.v.len()]),
            prescribed: prescribed.collect(),
            efforts: base.into_iter().chain(motors).collect(),
            loads: self.loads.iter().zip(&drives.loads).map(load).collect(),
            actuators: actuators.map(Real::new).collect(),
            gravity: <[f64; 3]>::from(mechanism.gravity).map(Real::new),
            matter: self.bodies().map(Matter::of).collect(),
        };
        Answers { closing: closing_joint(&mechanism), mechanism, now }
    }
}

impl Answers<'_> {
    /// Returns the efforts of the drives of all free rates, as [`Chain::inverse_dynamics`] does.
    pub fn inverse_dynamics(&self, accelerations: &[f64]) -> Vec<f64> {
        floats(&self.efforts(&Now { a: reals(accelerations), ..self.now.clone() }))
    }

    /// Returns the efforts of the drives that balance only gravity.
    pub fn gravity_efforts(&self) -> Vec<f64> {
        let poses = self.at_rest(&self.now);
        let weight = |(pose, matter): (&Pose, &Matter)| -> Twist {
            let force = scaled(self.now.gravity, -matter.mass);
            [force, cross(times(values(pose), matter.com()), force)]
        };
        let wrenches: Vec<Twist> = poses.iter().zip(&self.now.matter).map(weight).collect();
        floats(&self.power(&self.columns(&self.now), &wrenches))
    }

    /// Returns the efforts with which springs, dampers, friction and limits of all free hinges act, and
    /// those of springs between bodies.
    pub fn passive_efforts(&self) -> Vec<f64> {
        let now = self.now.without_loads();
        let mut efforts = self.applied(&now);
        self.for_each_hinge(&now, |first, passive| {
            for (k, &effort) in passive.efforts.iter().enumerate() {
                efforts[first + k] += effort;
            }
        });
        floats(&efforts)
    }

    /// Returns the efforts with which the loads and the actuators of springs act.
    pub fn load_efforts(&self) -> Vec<f64> {
        let without = self.now.without_loads();
        let (all, springs) = (self.applied(&self.now), self.applied(&without));
        all.iter().zip(&springs).map(|(&all, &springs)| (all - springs).high).collect()
    }

    /// Returns the mass matrix row by row, including the inertias of rotors.
    pub fn mass_matrix(&self) -> Vec<Vec<f64>> {
        self.mass(&self.now).iter().map(|row| floats(row)).collect()
    }

    /// Returns the inverse of the mass matrix row by row.
    ///
    /// A closing hinge without rotors has no inertia; the matrix is singular then.
    pub fn inverse_mass_matrix(&self) -> Vec<Vec<f64>> {
        let mass = self.mass(&self.now);
        let unit = |k: usize| -> Vec<Real> {
            (0..mass.len()).map(|j| Real::new(f64::from(u8::from(j == k)))).collect()
        };
        (0..mass.len()).map(|k| floats(&solved(&mass, &unit(k)))).collect()
    }

    /// Returns the derivatives of the rates of an open chain under its motors.
    pub fn accelerations(&self) -> Vec<f64> {
        floats(&self.solved_accelerations(&self.now))
    }

    /// Returns the velocity of a point of a body, given in the body's frame, and the angular velocity:
    /// six numbers in inertial axes.
    pub fn velocity(&self, body: usize, at: [f64; 3]) -> Vec<f64> {
        let pose = self.moving(&self.now)[body];
        let [spin, _] = pose.spin();
        let velocity = place(&pose, at.map(Real::new)).map(|entry| entry.rate);
        floats(&[velocity, spin].concat())
    }

    /// Returns the acceleration of a point of a body and the angular acceleration for given derivatives
    /// of the rates.
    pub fn acceleration(&self, body: usize, at: [f64; 3], accelerations: &[f64]) -> Vec<f64> {
        let pose = self.moving(&Now { a: reals(accelerations), ..self.now.clone() })[body];
        let [_, angular] = pose.spin();
        let acceleration = place(&pose, at.map(Real::new)).map(|entry| entry.second);
        floats(&[acceleration, angular].concat())
    }

    /// Returns the Jacobian of a point of a body, six rows: velocity and angular velocity at unit rates,
    /// with prescribed hinges and moving frames at rest.
    pub fn jacobian(&self, body: usize, at: [f64; 3]) -> Vec<Vec<f64>> {
        let arm = times(values(&self.at_rest(&self.now)[body]), at.map(Real::new));
        let columns = self.columns(&self.now).into_iter().map(|column| {
            let [velocity, spin] = column[body];
            [plus(velocity, cross(spin, arm)), spin].concat()
        });
        let columns: Vec<Vec<Real>> = columns.collect();
        (0..6).map(|row| columns.iter().map(|column| column[row].high).collect()).collect()
    }

    /// Returns the poses of all bodies with all derivatives.
    fn moving(&self, now: &Now) -> Vec<Pose> {
        let moves = Moves { rates: &now.v, accelerations: &now.a, prescribed: true };
        poses(&self.mechanism, self.closing, now, moves)
    }

    /// Returns the poses of all bodies without derivatives.
    fn at_rest(&self, now: &Now) -> Vec<Pose> {
        let rest = reals(&vec![0.0; now.v.len()]);
        let moves = Moves { rates: &rest, accelerations: &rest, prescribed: false };
        poses(&self.mechanism, self.closing, now, moves)
    }

    /// Returns the twists of all bodies at unit rates, by rates.
    fn columns(&self, now: &Now) -> Vec<Vec<Twist>> {
        let rest = reals(&vec![0.0; now.v.len()]);
        let column = |k: usize| {
            let mut rates = rest.clone();
            rates[k] = Real::new(1.0);
            let moves = Moves { rates: &rates, accelerations: &rest, prescribed: false };
            poses(&self.mechanism, self.closing, now, moves).iter().map(twist).collect()
        };
        (0..rest.len()).map(column).collect()
    }

    /// Returns the power of wrenches about the origins of the bodies at unit rates.
    fn power(&self, columns: &[Vec<Twist>], wrenches: &[Twist]) -> Vec<Real> {
        let of_body =
            |(twist, wrench): (&Twist, &Twist)| dot(twist[0], wrench[0]) + dot(twist[1], wrench[1]);
        let of_rate = |column: &Vec<Twist>| {
            column.iter().zip(wrenches).map(of_body).fold(Real::new(0.0), |sum, it| sum + it)
        };
        columns.iter().map(of_rate).collect()
    }

    /// Returns the efforts with which loads and springs between bodies act.
    fn applied(&self, now: &Now) -> Vec<Real> {
        self.power(&self.columns(now), &self.external(now, &self.moving(now)))
    }

    /// Returns the wrenches of loads and springs on all bodies, about the origins of their frames.
    fn external(&self, now: &Now, poses: &[Pose]) -> Vec<Twist> {
        let mut wrenches = vec![[[Real::new(0.0); 3]; 2]; poses.len()];
        for acting in acting(self.mechanism.chain, now, poses) {
            let [force, moment] = wrench(&acting, &poses[acting.body]);
            let total = &mut wrenches[acting.body];
            *total = [plus(total[0], force), plus(total[1], moment)];
        }
        wrenches
    }

    /// Calls a function with the first rate of every free hinge and with what acts in the hinge.
    fn for_each_hinge(&self, now: &Now, mut call: impl FnMut(usize, passive::Passive)) {
        let moves = Moves { rates: &now.v, accelerations: &now.a, prescribed: true };
        for (number, joint) in self.mechanism.joints.iter().enumerate() {
            if joint.prescribed.is_none() {
                let motion = joint_motion(&self.mechanism, number, now, moves);
                call(joint.first_rate, passive(joint.hinge, &motion));
            }
        }
    }

    /// Returns the efforts of inverse dynamics.
    fn efforts(&self, now: &Now) -> Vec<Real> {
        let poses = self.moving(now);
        let external = self.external(now, &poses);
        let inertial =
            poses.iter().zip(&now.matter).zip(external).map(|((pose, matter), acting)| {
                let [force, moment] = matter.inertial_wrench(pose, now.gravity);
                [minus(force, acting[0]), minus(moment, acting[1])]
            });
        let wrenches: Vec<Twist> = inertial.collect();
        let mut efforts = self.power(&self.columns(now), &wrenches);
        self.for_each_hinge(now, |first, passive| {
            for (k, (&rotors, &own)) in passive.rotors.iter().zip(&passive.efforts).enumerate() {
                efforts[first + k] += rotors - own;
            }
        });
        efforts
    }

    /// Returns the mass matrix: the momenta at unit rates, multiplied by unit rates.
    fn mass(&self, now: &Now) -> Vec<Vec<Real>> {
        let poses = self.at_rest(now);
        let columns = self.columns(now);
        let momenta = |column: &Vec<Twist>| -> Vec<Twist> {
            let bodies = poses.iter().zip(&now.matter).zip(column);
            bodies
                .map(|((pose, matter), twist)| matter.momentum_about_origin(values(pose), *twist))
                .collect()
        };
        let mut rows: Vec<Vec<Real>> =
            columns.iter().map(|column| self.power(&columns, &momenta(column))).collect();
        let count = rows.len();
        for k in 0..count {
            // The efforts of rotors are linear in the derivatives of the rates.
            let mut a = reals(&vec![0.0; count]);
            let still = Now { v: a.clone(), a: a.clone(), ..now.clone() };
            a[k] = Real::new(1.0);
            let unit = Now { a, ..still };
            self.for_each_hinge(&unit, |first, passive| {
                for (j, &rotor) in passive.rotors.iter().enumerate() {
                    rows[first + j][k] += rotor;
                }
            });
        }
        rows
    }

    fn solved_accelerations(&self, now: &Now) -> Vec<Real> {
        let none = reals(&vec![0.0; now.v.len()]);
        let bias = self.efforts(&Now { a: none, ..now.clone() });
        let left = now.efforts.iter().zip(&bias).map(|(&effort, &bias)| effort - bias);
        solved(&self.mass(now), &left.collect::<Vec<_>>())
    }
}

fn reals(values: &[f64]) -> Vec<Real> {
    values.iter().copied().map(Real::new).collect()
}

fn floats(values: &[Real]) -> Vec<f64> {
    values.iter().map(|value| value.high).collect()
}

/// Returns the rotation of a pose without its derivatives.
fn values(pose: &Pose) -> Matrix {
    pose.rotation.map(|row| row.map(|entry| entry.value))
}

fn twist(pose: &Pose) -> Twist {
    let [spin, _] = pose.spin();
    [pose.velocity(), spin]
}
