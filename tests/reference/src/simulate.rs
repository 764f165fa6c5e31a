//! Simulation of a chain in the coordinates of its bodies.

use crate::chain::{Chain, Dimension, State};
use crate::drives::Drives;
use crate::equations::Equations;
use crate::extrapolation::{extrapolated_step, step_factor};
use crate::hinge::HingeKind;
use crate::mechanism::{Joint, Mechanism, Motion};
use crate::passive::Passive;
use crate::rotation::{self, Vec3};
use crate::strain::Strains;
use nalgebra::DVector;

/// The error tolerance of one step, far below the tolerances of the comparisons.
const TOLERANCE: f64 = 1e-12;
/// The longest step in s, short enough to count the turns of a pin.
const LONGEST_STEP: f64 = 0.1;
/// A step in s that is accepted with any error, since the error is then only rounding.
const SHORTEST_STEP: f64 = 1e-6;
/// Entries of one body in the integrated vector: position, quaternion, velocity, angular velocity.
const ENTRIES: usize = 13;

/// The motion of a chain at one requested time.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// The time in s since the start.
    pub time: f64,
    /// The motion of every body in written order.
    pub bodies: Vec<BodySample>,
    /// One entry for every hinge in written order: the angle of a pin in rad, continuous over
    /// full turns, and nothing for other hinges.
    pub pin_angles: Vec<Option<f64>>,
    /// The same motion as coordinates and rates of the chain, computed from the bodies. Angles are
    /// continuous over full turns and quaternions do not change their sign.
    pub state: State,
    /// The kinetic energy in J.
    pub kinetic_energy: f64,
    /// The potential energy in J, as in [`crate::Solution`].
    pub potential_energy: f64,
}

/// The motion of one body, in inertial axes.
#[derive(Clone, Debug, PartialEq)]
pub struct BodySample {
    /// The position of the centre of mass in m.
    pub position: [f64; 3],
    /// The rotation matrix from body to inertial components, row by row.
    pub rotation: [[f64; 3]; 3],
    /// The velocity of the centre of mass in m/s.
    pub velocity: [f64; 3],
    /// The angular velocity in rad/s.
    pub angular_velocity: [f64; 3],
}

/// Simulates a chain from `start` at time zero and returns its motion at each of `times`, which must
/// not decrease and are in s.
///
/// `efforts` are as in [`Chain::solve`] and stay constant.
///
/// # Panics
///
/// Panics like [`simulate_driven`].
pub fn simulate(
    chain: &Chain,
    start: &State,
    efforts: &[f64],
    times: &[f64],
    report: impl FnMut(&Sample),
) {
    let drives = Drives { efforts: efforts.to_vec(), ..Drives::none(chain) };
    simulate_driven(chain, start, &drives, times, report);
}

/// Simulates a chain like [`simulate`], with constant drives. Hinges with prescribed motions and
/// moving ends have to be at rest.
///
/// The positions, quaternions, velocities and angular velocities of all bodies are integrated; the
/// hinges' coordinates are integrated only to count turns. After every step the bodies are projected
/// onto the constraints of the hinges, so the hinges do not drift apart.
///
/// # Panics
///
/// Panics like [`Chain::solve_driven`], and if the motion is no longer finite.
pub fn simulate_driven(
    chain: &Chain,
    start: &State,
    drives: &Drives,
    times: &[f64],
    mut report: impl FnMut(&Sample),
) {
    chain.check_lengths(start, drives);
    let mechanism = Mechanism::new(chain, drives);
    let mut run = Run::new(&mechanism, start);
    for &time in times {
        run.advance(time);
        report(&run.sample(time));
    }
}

/// A running simulation.
struct Run<'a> {
    mechanism: &'a Mechanism<'a>,
    time: f64,
    /// The step to try next.
    step: f64,
    motions: Vec<Motion>,
    /// The coordinates and rates of the motions.
    state: State,
}

impl<'a> Run<'a> {
    fn new(mechanism: &'a Mechanism<'a>, start: &State) -> Run<'a> {
        let motions = mechanism.motions(start);
        let state = mechanism.measure(&motions, start);
        Run { mechanism, time: 0.0, step: 0.01, motions, state }
    }

    /// Continues until `time`.
    fn advance(&mut self, time: f64) {
        while self.time < time {
            // Two equal steps avoid a tiny last step.
            let left = time - self.time;
            let step = if left <= self.step { left } else { self.step.min(0.5 * left) };
            let rate = |packed: &DVector<f64>| self.rate(packed);
            let (packed, error) =
                extrapolated_step(&rate, &pack(&self.motions, &self.state.q), step);
            let longer = (step * step_factor(error, TOLERANCE)).min(LONGEST_STEP);
            let accepted = error <= TOLERANCE || step <= SHORTEST_STEP;
            if accepted {
                assert!(packed.iter().all(|value| value.is_finite()), "the motion is not finite");
                self.accept(&packed);
                self.time = if step == left { time } else { self.time + step };
                // After a step shortened by `time`, the next step is not limited, unless it must shrink.
                self.step = if step < self.step { longer.max(self.step) } else { longer };
            } else {
                self.step = longer;
            }
            self.step = self.step.max(SHORTEST_STEP);
        }
    }

    /// Accepts the motions after a step.
    fn accept(&mut self, packed: &DVector<f64>) {
        let (motions, state) = self.unpack(packed);
        self.motions = closed(self.mechanism, motions, &state);
        self.state = self.mechanism.measure(&self.motions, &state);
    }

    /// Returns the motions in an integrated vector, and their state.
    fn unpack(&self, packed: &DVector<f64>) -> (Vec<Motion>, State) {
        let (of_bodies, q) = packed.as_slice().split_at(ENTRIES * self.motions.len());
        let motions = motions_from(of_bodies);
        let near = State { q: q.to_vec(), v: self.state.v.clone() };
        let state = self.mechanism.measure(&motions, &near);
        (motions, state)
    }

    /// Returns the derivative of the integrated vector.
    fn rate(&self, packed: &DVector<f64>) -> DVector<f64> {
        if packed.iter().any(|value| !value.is_finite()) {
            // The step is far too long and will be rejected.
            return DVector::repeat(packed.len(), f64::NAN);
        }
        let (motions, state) = self.unpack(packed);
        let dynamics = Equations::new(self.mechanism, &motions, &state).dynamics();
        let mut rate = DVector::zeros(packed.len());
        for (body, motion) in motions.iter().enumerate() {
            let first = ENTRIES * body;
            let quaternion = packed.fixed_rows::<4>(first + 3).into_owned();
            let quaternion_rate = quaternion_rate(&motion.spin, quaternion.as_slice());
            rate.fixed_rows_mut::<3>(first).copy_from(&motion.velocity);
            rate.fixed_rows_mut::<4>(first + 3).copy_from_slice(&quaternion_rate);
            rate.fixed_rows_mut::<3>(first + 7).copy_from(&dynamics.linear[body]);
            rate.fixed_rows_mut::<3>(first + 10).copy_from(&dynamics.angular[body]);
        }
        let mut place = ENTRIES * motions.len();
        if let Dimension::Plane | Dimension::Line = self.mechanism.chain.dimension {
            let base = self.mechanism.chain.base_dof_count();
            rate.rows_mut(place, base).copy_from_slice(&state.v[..base]);
        }
        place += self.mechanism.chain.base_coordinates();
        for joint in self.mechanism.joints.iter().filter(|joint| joint.prescribed.is_none()) {
            // Quaternions do not count turns; the last state determines their sign.
            if !joint.kind().has_quaternion() {
                let strains = Strains::new(joint.hinge, joint.q(&state), joint.v(&state));
                rate.rows_mut(place, strains.rates.len()).copy_from(&strains.rates);
            }
            place += joint.hinge.coordinates();
        }
        rate
    }

    fn sample(&self, time: f64) -> Sample {
        let joints = &self.mechanism.joints;
        let angle = |joint: &Joint| match joint.kind() {
            HingeKind::Pin { .. } => Some(joint.q(&self.state)[0]),
            _ => None,
        };
        let passive = joints.iter().map(|joint| {
            let passive = Passive::new(joint.hinge, joint.q(&self.state), joint.v(&self.state));
            [passive.kinetic_energy, passive.potential_energy]
        });
        let [kinetic, potential] =
            passive.fold([0.0; 2], |sum, next| [sum[0] + next[0], sum[1] + next[1]]);
        Sample {
            time,
            bodies: self.motions.iter().map(BodySample::new).collect(),
            pin_angles: joints.iter().map(angle).collect(),
            state: self.state.clone(),
            kinetic_energy: self.mechanism.kinetic_energy(&self.motions) + kinetic,
            potential_energy: self.mechanism.potential_energy(&self.motions) + potential,
        }
    }
}

impl BodySample {
    fn new(motion: &Motion) -> BodySample {
        BodySample {
            position: motion.position.into(),
            rotation: rotation::rows(&motion.rotation),
            velocity: motion.velocity.into(),
            angular_velocity: motion.spin.into(),
        }
    }
}

/// Projects poses and then velocities of the bodies onto the constraints of the hinges.
fn closed(mechanism: &Mechanism, mut motions: Vec<Motion>, state: &State) -> Vec<Motion> {
    let moves =
        Equations::new(mechanism, &motions, state).correction(|contact| -contact.pose_violation());
    for (body, motion) in motions.iter_mut().enumerate() {
        let turn: Vec3 = moves.fixed_rows::<3>(6 * body + 3).into_owned();
        motion.position += moves.fixed_rows::<3>(6 * body);
        motion.rotation = rotation::from_vector(&turn) * motion.rotation;
    }
    let state = mechanism.measure(&motions, state);
    let changes = Equations::new(mechanism, &motions, &state)
        .correction(|contact| -contact.velocity_violation());
    for (body, motion) in motions.iter_mut().enumerate() {
        motion.velocity += changes.fixed_rows::<3>(6 * body);
        motion.spin += changes.fixed_rows::<3>(6 * body + 3);
    }
    motions
}

/// Returns the derivative of a quaternion (w, x, y, z) from body to inertial components: half the
/// product of the inertial angular velocity and the quaternion.
fn quaternion_rate(spin: &Vec3, quaternion: &[f64]) -> [f64; 4] {
    let vector = Vec3::from_column_slice(&quaternion[1..4]);
    let scalar_rate = -0.5 * spin.dot(&vector);
    let vector_rate = 0.5 * (spin * quaternion[0] + spin.cross(&vector));
    [scalar_rate, vector_rate.x, vector_rate.y, vector_rate.z]
}

/// Returns the integrated vector: the motions of the bodies, then the coordinates.
fn pack(motions: &[Motion], q: &[f64]) -> DVector<f64> {
    let mut packed: Vec<f64> = Vec::with_capacity(ENTRIES * motions.len() + q.len());
    for motion in motions {
        packed.extend(motion.position.iter());
        packed.extend(rotation::to_quaternion(&motion.rotation, &[1.0, 0.0, 0.0, 0.0]));
        packed.extend(motion.velocity.iter());
        packed.extend(motion.spin.iter());
    }
    packed.extend(q);
    DVector::from_vec(packed)
}

/// Returns the motions in a vector of [`pack`], with normalised quaternions.
fn motions_from(packed: &[f64]) -> Vec<Motion> {
    let motion = |entries: &[f64]| Motion {
        position: Vec3::from_column_slice(&entries[0..3]),
        rotation: rotation::from_quaternion(&entries[3..7]),
        velocity: Vec3::from_column_slice(&entries[7..10]),
        spin: Vec3::from_column_slice(&entries[10..13]),
    };
    packed.chunks_exact(ENTRIES).map(motion).collect()
}
