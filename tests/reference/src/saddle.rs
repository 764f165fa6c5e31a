//! Newton's and Euler's equations of all bodies, together with all that the hinges forbid.
//!
//! With the bodies' accelerations `x` (six to a body: centre of mass, then angular, inertial axes)
//! and the hinges' loads `λ`, the system is
//!
//! ```text
//! M x - Jᵀ λ = loads        one row to every freedom of a body left alone
//! J x        = demands      one row to everything a hinge forbids
//! ```
//!
//! The rows of a hinge say that its two points accelerate together, and that it does not turn about
//! its locked directions; `λ` is then the force, and the moment about these directions, that the
//! hinge exerts on its outboard side.

use crate::mechanism::{Freedom, Joint, Mechanism, Motion, Place};
use crate::rotation::{self, Vec3};
use nalgebra::{DMatrix, DVector, Dyn, LU};

/// The system matrix at one instant, ready to be solved for any right-hand sides.
pub(crate) struct Saddle<'a> {
    mechanism: &'a Mechanism,
    motions: &'a [Motion],
    contacts: Vec<Contact>,
    matrix: DMatrix<f64>,
    factors: LU<f64, Dyn, Dyn>,
}

/// A hinge at one instant.
pub(crate) struct Contact {
    pub(crate) inboard: Place,
    pub(crate) outboard: Place,
    /// The directions the hinge cannot turn about, inertial, fixed to the inboard side.
    locked: Vec<Vec3>,
    /// The first row of the hinge among the rows of `J`.
    first_row: usize,
}

/// The solution of the equations of motion.
pub(crate) struct Dynamics {
    /// The acceleration of every centre of mass.
    pub(crate) linear: Vec<Vec3>,
    /// The angular acceleration of every body.
    pub(crate) angular: Vec<Vec3>,
    /// The force of every hinge on its outboard side.
    pub(crate) hinge_forces: Vec<Vec3>,
    /// The moment of every hinge on its outboard side about the hinge point, motors included.
    pub(crate) hinge_moments: Vec<Vec3>,
}

impl<'a> Saddle<'a> {
    pub(crate) fn new(mechanism: &'a Mechanism, motions: &'a [Motion]) -> Saddle<'a> {
        let contacts = contacts_of(mechanism, motions);
        let matrix = system_matrix(mechanism, motions, &contacts);
        let factors = matrix.clone().lu();
        Saddle { mechanism, motions, contacts, matrix, factors }
    }

    pub(crate) fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// Solves the equations of motion with one effort to every rate of the chain.
    pub(crate) fn dynamics(&self, efforts: &[f64]) -> Dynamics {
        let torques: Vec<Vec3> = self.motor_torques(efforts);
        let (x, multipliers) = self.solve(&self.loads(&torques), &self.demands());
        let vector = |all: &DVector<f64>, first: usize| all.fixed_rows::<3>(first).into_owned();
        let bodies = 0..self.mechanism.bodies.len();
        let moment = |(contact, motor): (&Contact, &Vec3)| {
            let reaction =
                |(k, direction): (usize, &Vec3)| direction * multipliers[contact.first_row + 3 + k];
            contact.locked.iter().enumerate().map(reaction).sum::<Vec3>() + motor
        };
        Dynamics {
            linear: bodies.clone().map(|body| vector(&x, 6 * body)).collect(),
            angular: bodies.map(|body| vector(&x, 6 * body + 3)).collect(),
            hinge_forces: self.contacts.iter().map(|c| vector(&multipliers, c.first_row)).collect(),
            hinge_moments: self.contacts.iter().zip(&torques).map(moment).collect(),
        }
    }

    /// Returns the smallest change of the bodies' velocities, measured by kinetic energy, after
    /// which no hinge is violated: the change takes back `violations`, one to a row of `J`.
    pub(crate) fn correction(&self, violations: &DVector<f64>) -> DVector<f64> {
        let no_loads = DVector::zeros(6 * self.mechanism.bodies.len());
        self.solve(&no_loads, &-violations).0
    }

    /// Returns by how much the velocities of the bodies violate the hinges.
    pub(crate) fn velocity_violations(&self) -> DVector<f64> {
        self.rows(|contact| {
            let spin = contact.outboard.spin - contact.inboard.spin;
            let about = contact.locked.iter().map(|direction| direction.dot(&spin)).collect();
            (contact.outboard.velocity - contact.inboard.velocity, about)
        })
    }

    /// Returns by how much the poses of the bodies violate the hinges, to first order.
    pub(crate) fn pose_violations(&self) -> DVector<f64> {
        let joints = &self.mechanism.joints;
        let errors = self.contacts.iter().zip(joints).map(|(contact, joint)| {
            let turn = contact.inboard.rotation.transpose() * contact.outboard.rotation;
            let error = match &joint.freedom {
                Freedom::None | Freedom::AnyTurn => rotation::sine_vector(&turn),
                Freedom::About(axis) => axis.cross(&(turn * axis)),
            };
            contact.inboard.rotation * error
        });
        let mut errors = errors.collect::<Vec<Vec3>>().into_iter();
        self.rows(|contact| {
            let error = errors.next().unwrap_or_default();
            let about = contact.locked.iter().map(|direction| direction.dot(&error)).collect();
            (contact.outboard.position - contact.inboard.position, about)
        })
    }

    /// Returns what the hinges demand of the accelerations: minus the parts of the constraints'
    /// second derivatives that the velocities alone make up.
    fn demands(&self) -> DVector<f64> {
        self.rows(|contact| {
            let Contact { inboard, outboard, locked, .. } = contact;
            let spin = outboard.spin - inboard.spin;
            // The locked directions turn with the inboard side.
            let about = |direction: &Vec3| -inboard.spin.cross(direction).dot(&spin);
            (inboard.centripetal() - outboard.centripetal(), locked.iter().map(about).collect())
        })
    }

    /// Puts together a vector with one entry to every row of `J`, from the part about the points
    /// and the part about the locked directions of every hinge.
    fn rows(&self, mut of_hinge: impl FnMut(&Contact) -> (Vec3, Vec<f64>)) -> DVector<f64> {
        let mut entries: Vec<f64> = Vec::new();
        for contact in &self.contacts {
            let (of_points, about_locked) = of_hinge(contact);
            entries.extend(of_points.iter());
            entries.extend(about_locked);
        }
        DVector::from_vec(entries)
    }

    /// Returns the torque of every motor on its outboard side, inertial.
    fn motor_torques(&self, efforts: &[f64]) -> Vec<Vec3> {
        let torque = |(joint, contact): (&Joint, &Contact)| {
            let own = &efforts[joint.first_rate..];
            match &joint.freedom {
                Freedom::None => Vec3::zeros(),
                Freedom::About(axis) => contact.inboard.rotation * axis * own[0],
                Freedom::AnyTurn => contact.outboard.rotation * Vec3::from_column_slice(&own[..3]),
            }
        };
        self.mechanism.joints.iter().zip(&self.contacts).map(torque).collect()
    }

    /// Returns the loads on the bodies that do not depend on the accelerations.
    fn loads(&self, motor_torques: &[Vec3]) -> DVector<f64> {
        let mut loads = DVector::zeros(6 * self.mechanism.bodies.len());
        for (body, (rigid, motion)) in self.mechanism.bodies.iter().zip(self.motions).enumerate() {
            let inertia = motion.rotation * rigid.inertia * motion.rotation.transpose();
            let weight = self.mechanism.gravity * rigid.mass;
            let gyroscopic = -motion.spin.cross(&(inertia * motion.spin));
            loads.fixed_rows_mut::<3>(6 * body).copy_from(&weight);
            loads.fixed_rows_mut::<3>(6 * body + 3).copy_from(&gyroscopic);
        }
        for (contact, torque) in self.contacts.iter().zip(motor_torques) {
            for (place, sign) in contact.sides() {
                if let Some(body) = place.body {
                    let mut moment = loads.fixed_rows_mut::<3>(6 * body + 3);
                    moment += torque * sign;
                }
            }
        }
        loads
    }

    /// Solves the system and returns the accelerations and the multipliers.
    fn solve(&self, loads: &DVector<f64>, demands: &DVector<f64>) -> (DVector<f64>, DVector<f64>) {
        let (unknowns, rows) = (loads.len(), demands.len());
        let mut right = DVector::zeros(unknowns + rows);
        right.rows_mut(0, unknowns).copy_from(loads);
        right.rows_mut(unknowns, rows).copy_from(demands);
        let mut solution = self.back_substitute(&right);
        // One step of refinement takes back what elimination without scaling has lost.
        let residual = &right - &self.matrix * &solution;
        solution += self.back_substitute(&residual);
        (solution.rows(0, unknowns).into_owned(), solution.rows(unknowns, rows).into_owned())
    }

    fn back_substitute(&self, right: &DVector<f64>) -> DVector<f64> {
        let solution = self.factors.solve(right);
        solution.expect("bodies with mass and inertia in an open chain have a regular system")
    }
}

impl Contact {
    /// Returns the two sides with the sign their motion has in the rows of the hinge.
    fn sides(&self) -> [(&Place, f64); 2] {
        [(&self.inboard, -1.0), (&self.outboard, 1.0)]
    }
}

fn contacts_of(mechanism: &Mechanism, motions: &[Motion]) -> Vec<Contact> {
    let mut first_row = 0;
    let contact = |joint: &Joint| {
        let inboard = mechanism.place(&joint.inboard, motions);
        let outboard = mechanism.place(&joint.outboard, motions);
        let locked = joint.freedom.locked_directions();
        let locked: Vec<Vec3> = locked.iter().map(|fixed| inboard.rotation * fixed).collect();
        let contact = Contact { inboard, outboard, locked, first_row };
        first_row += 3 + contact.locked.len();
        contact
    };
    mechanism.joints.iter().map(contact).collect()
}

fn system_matrix(mechanism: &Mechanism, motions: &[Motion], contacts: &[Contact]) -> DMatrix<f64> {
    let unknowns = 6 * mechanism.bodies.len();
    let rows: usize = contacts.iter().map(|contact| 3 + contact.locked.len()).sum();
    let mut matrix = DMatrix::zeros(unknowns + rows, unknowns + rows);
    for (body, (rigid, motion)) in mechanism.bodies.iter().zip(motions).enumerate() {
        let inertia = motion.rotation * rigid.inertia * motion.rotation.transpose();
        matrix.fixed_view_mut::<3, 3>(6 * body, 6 * body).fill_diagonal(rigid.mass);
        matrix.fixed_view_mut::<3, 3>(6 * body + 3, 6 * body + 3).copy_from(&inertia);
    }
    let jacobian = constraint_jacobian(contacts, rows, unknowns);
    matrix.view_mut((0, unknowns), (unknowns, rows)).copy_from(&-jacobian.transpose());
    matrix.view_mut((unknowns, 0), (rows, unknowns)).copy_from(&jacobian);
    matrix
}

/// Returns `J`: how the velocities of the bodies move the two sides of every hinge apart.
fn constraint_jacobian(contacts: &[Contact], rows: usize, unknowns: usize) -> DMatrix<f64> {
    let mut jacobian = DMatrix::zeros(rows, unknowns);
    for contact in contacts {
        let row = contact.first_row;
        for (place, sign) in contact.sides() {
            let Some(body) = place.body else { continue };
            let by_spin = rotation::cross_matrix(&place.arm) * -sign;
            jacobian.fixed_view_mut::<3, 3>(row, 6 * body).fill_diagonal(sign);
            jacobian.fixed_view_mut::<3, 3>(row, 6 * body + 3).copy_from(&by_spin);
            for (k, direction) in contact.locked.iter().enumerate() {
                let by_spin = direction.transpose() * sign;
                jacobian.fixed_view_mut::<1, 3>(row + 3 + k, 6 * body + 3).copy_from(&by_spin);
            }
        }
    }
    jacobian
}
