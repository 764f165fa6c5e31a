//! Newton's and Euler's equations of all bodies, with the constraints of all hinges.
//!
//! The unknowns are the accelerations of the bodies (six per body: centre of mass, then angular,
//! inertial axes) and the derivatives of the hinges' rates `v`. The multipliers are the wrenches of the
//! hinges on their outboard sides (force, then moment about the outboard origin, inertial axes).
//! With the motion subspace `S` of a hinge, the system is
//!
//! ```text
//! M x  - Aᵀ F      = loads           six rows per body
//! I v̇  + Sᵀ F      = efforts         one row per rate of a hinge; I is the inertia of its rotors
//! A x  - S v̇       = demands         six rows per hinge: the relative acceleration
//! ```
//!
//! A prescribed hinge adds demands and no unknowns. In the plane and along a line, the rows and
//! columns of directions without motion are omitted.

use crate::chain::State;
use crate::mechanism::{FrameState, Joint, Mechanism, Motion};
use crate::passive::Passive;
use crate::placement::{relative_pose, relative_twist};
use crate::relative::{Relative, Twist, to_inertial, twist};
use crate::rotation::{self, Vec3};
use crate::saddle::Saddle;
use nalgebra::{DMatrix, DVector, Matrix6xX};

/// The equations of a chain at one instant.
pub(crate) struct Equations<'a> {
    mechanism: &'a Mechanism<'a>,
    motions: &'a [Motion],
    pub(crate) contacts: Vec<Contact<'a>>,
    pub(crate) saddle: Saddle,
    /// The unknowns that can differ from zero.
    columns: Vec<usize>,
    /// The demands that can differ from zero.
    rows: Vec<usize>,
}

/// A hinge at one instant.
pub(crate) struct Contact<'a> {
    joint: &'a Joint<'a>,
    pub(crate) inboard: FrameState,
    pub(crate) outboard: FrameState,
    relative: Relative,
    pub(crate) passive: Passive,
    /// The rates, prescribed or not.
    v: Vec<f64>,
    /// The index of the hinge's first unknown, if the hinge is not prescribed.
    first_unknown: usize,
}

/// The solution of the equations of motion.
pub(crate) struct Dynamics {
    /// The acceleration of every centre of mass.
    pub(crate) linear: Vec<Vec3>,
    /// The angular acceleration of every body.
    pub(crate) angular: Vec<Vec3>,
    /// The derivatives of every hinge's rates.
    pub(crate) hinge_accelerations: Vec<Vec<f64>>,
    /// The wrench of every hinge on its outboard side about the outboard origin, motors included.
    pub(crate) wrenches: Vec<Twist>,
    /// The effort of every hinge's motor, or of the drive if the hinge is prescribed.
    pub(crate) efforts: Vec<Vec<f64>>,
}

impl<'a> Equations<'a> {
    /// Sets up the equations for bodies whose motions agree with the state.
    pub(crate) fn new(
        mechanism: &'a Mechanism<'a>,
        motions: &'a [Motion],
        state: &State,
    ) -> Equations<'a> {
        let contacts = contacts_of(mechanism, motions, state);
        let directions = mechanism.chain.dimension.directions();
        let every = |blocks: usize| {
            (0..blocks).flat_map(|block| directions.iter().map(move |k| 6 * block + k))
        };
        let of_bodies = 6 * mechanism.bodies.len();
        let own = contacts.iter().map(|contact| contact.unknowns()).sum::<usize>();
        let columns: Vec<usize> =
            every(mechanism.bodies.len()).chain(of_bodies..of_bodies + own).collect();
        let rows: Vec<usize> = every(contacts.len()).collect();
        let inertia = inertia_matrix(mechanism, motions, &contacts, of_bodies + own);
        let constraints = constraint_matrix(&contacts, of_bodies + own);
        let saddle = Saddle::new(
            &inertia.select_rows(&columns).select_columns(&columns),
            &constraints.select_rows(&rows).select_columns(&columns),
            mechanism.has_loops(),
        );
        Equations { mechanism, motions, contacts, saddle, columns, rows }
    }

    /// Solves the equations of motion.
    pub(crate) fn dynamics(&self) -> Dynamics {
        let (x, multipliers) = self.solve(&self.loads(), &self.stacked(|contact| contact.demand()));
        let vector = |first: usize| x.fixed_rows::<3>(first).into_owned();
        let bodies = 0..self.mechanism.bodies.len();
        let wrenches: Vec<Twist> =
            (0..self.contacts.len()).map(|k| multipliers.fixed_rows::<6>(6 * k).into()).collect();
        let hinge_accelerations: Vec<Vec<f64>> =
            self.contacts.iter().map(|contact| contact.accelerations(&x)).collect();
        let driven = self.contacts.iter().zip(&wrenches).zip(&hinge_accelerations);
        Dynamics {
            linear: bodies.clone().map(|body| vector(6 * body)).collect(),
            angular: bodies.map(|body| vector(6 * body + 3)).collect(),
            efforts: driven.map(|((contact, f), a)| contact.effort(f, a)).collect(),
            hinge_accelerations,
            wrenches,
        }
    }

    /// Returns the change of the bodies' velocities, six entries per body, that has the least kinetic
    /// energy and changes the constrained relative motions at the hinges by the given amounts.
    pub(crate) fn correction(&self, wanted: impl Fn(&Contact) -> Twist) -> DVector<f64> {
        let demands = self.stacked(wanted);
        self.solve(&DVector::zeros(self.unknowns()), &demands).0
    }

    /// Solves the system, with entries for all directions.
    fn solve(&self, loads: &DVector<f64>, demands: &DVector<f64>) -> (DVector<f64>, DVector<f64>) {
        let (x, multipliers) =
            self.saddle.solve(&loads.select_rows(&self.columns), &demands.select_rows(&self.rows));
        let spread = |found: &DVector<f64>, places: &[usize], length: usize| {
            let mut all = DVector::zeros(length);
            places.iter().zip(found.iter()).for_each(|(place, value)| all[*place] = *value);
            all
        };
        (
            spread(&x, &self.columns, self.unknowns()),
            spread(&multipliers, &self.rows, 6 * self.contacts.len()),
        )
    }

    fn unknowns(&self) -> usize {
        let own = self.contacts.iter().map(|contact| contact.unknowns()).sum::<usize>();
        6 * self.mechanism.bodies.len() + own
    }

    /// Returns the right-hand sides of the bodies' equations and of the hinges' efforts.
    fn loads(&self) -> DVector<f64> {
        let mut loads = DVector::zeros(self.unknowns());
        for (body, (rigid, motion)) in self.mechanism.bodies.iter().zip(self.motions).enumerate() {
            let inertia = motion.rotation * rigid.inertia * motion.rotation.transpose();
            let weight = self.mechanism.gravity * rigid.mass;
            let gyroscopic = -motion.spin.cross(&(inertia * motion.spin));
            loads.fixed_rows_mut::<3>(6 * body).copy_from(&weight);
            loads.fixed_rows_mut::<3>(6 * body + 3).copy_from(&gyroscopic);
        }
        for load in &self.mechanism.external_loads {
            for (body, force, moment) in load.wrenches(self.motions) {
                let mut on_body = loads.fixed_rows_mut::<6>(6 * body);
                on_body += twist(force, moment);
            }
        }
        for contact in self.contacts.iter().filter(|contact| contact.unknowns() > 0) {
            let motor = DVector::from_column_slice(&contact.joint.motor);
            let efforts = motor + &contact.passive.efforts - &contact.passive.inertia_bias;
            loads.rows_mut(contact.first_unknown, contact.unknowns()).copy_from(&efforts);
        }
        loads
    }

    /// Returns the right-hand sides of the constraints of all hinges.
    fn stacked(&self, of_hinge: impl Fn(&Contact) -> Twist) -> DVector<f64> {
        let mut all = DVector::zeros(6 * self.contacts.len());
        for (k, contact) in self.contacts.iter().enumerate() {
            all.fixed_rows_mut::<6>(6 * k).copy_from(&of_hinge(contact));
        }
        all
    }
}

impl Contact<'_> {
    /// Returns the number of the hinge's unknowns.
    fn unknowns(&self) -> usize {
        self.joint.hinge.dof_count()
    }

    /// Returns the motion subspace of the hinge in inertial axes.
    fn directions(&self) -> Matrix6xX<f64> {
        to_inertial(&self.inboard.rotation) * &self.relative.directions
    }

    /// Returns the derivatives of the rates, given all unknowns.
    fn accelerations(&self, x: &DVector<f64>) -> Vec<f64> {
        match self.joint.prescribed {
            Some(motion) => motion.a.clone(),
            None => x.rows(self.first_unknown, self.unknowns()).iter().copied().collect(),
        }
    }

    /// Returns the motor efforts along the rates with which the hinge transmits a wrench; springs,
    /// dampers, friction and limits supply the rest.
    fn effort(&self, wrench: &Twist, accelerations: &[f64]) -> Vec<f64> {
        if self.joint.prescribed.is_none() {
            return self.joint.motor.clone();
        }
        let passed_on = self.directions().transpose() * wrench;
        let of_rotors = &self.passive.inertia * DVector::from_column_slice(accelerations)
            + &self.passive.inertia_bias;
        (passed_on + of_rotors - &self.passive.efforts).iter().copied().collect()
    }

    /// Returns the relative acceleration due to the hinge's rates and their prescribed derivatives, in
    /// inertial axes, without the accelerations of the two sides.
    fn demand(&self) -> Twist {
        let Contact { inboard, outboard, relative, .. } = self;
        let mut own = relative.bias;
        if let Some(motion) = self.joint.prescribed {
            own += relative.twist(&motion.a);
        }
        let moving = to_inertial(&inboard.rotation) * relative.twist(&self.v);
        let (velocity, spin) = (moving.fixed_rows::<3>(0), moving.fixed_rows::<3>(3));
        let between = outboard.position - inboard.position;
        // Coriolis and centripetal terms: the rates have components in the rotating inboard axes.
        let of_turning = twist(
            inboard.spin.cross(&(velocity * 2.0 + inboard.spin.cross(&between))),
            inboard.spin.cross(&spin),
        );
        let known = twist(
            outboard.known_acceleration
                - inboard.known_acceleration
                - inboard.known_angular.cross(&between),
            outboard.known_angular - inboard.known_angular,
        );
        to_inertial(&inboard.rotation) * own + of_turning - known
    }

    /// Returns the constrained part of the relative motion at the hinge, in inertial axes.
    pub(crate) fn velocity_violation(&self) -> Twist {
        let found = relative_twist(&self.inboard, &self.outboard);
        to_inertial(&self.inboard.rotation) * (found - self.relative.twist(&self.v))
    }

    /// Returns the constrained part of the displacement at the hinge, in inertial axes: a translation
    /// and a rotation vector.
    pub(crate) fn pose_violation(&self) -> Twist {
        let (rotation, offset) = relative_pose(&self.inboard, &self.outboard);
        let turn = rotation::to_vector(&(rotation * self.relative.rotation.transpose()));
        to_inertial(&self.inboard.rotation) * twist(offset - self.relative.offset, turn)
    }
}

fn contacts_of<'a>(
    mechanism: &'a Mechanism,
    motions: &[Motion],
    state: &State,
) -> Vec<Contact<'a>> {
    let mut first_unknown = 6 * mechanism.bodies.len();
    let contact = |joint: &'a Joint| {
        let (q, v) = (joint.q(state), joint.v(state));
        let contact = Contact {
            joint,
            inboard: mechanism.frame_motion(&joint.inboard, motions),
            outboard: mechanism.frame_motion(&joint.outboard, motions),
            relative: joint.kind().relative(q, v),
            passive: Passive::new(joint.hinge, q, v),
            v: v.to_vec(),
            first_unknown,
        };
        first_unknown += contact.unknowns();
        contact
    };
    mechanism.joints.iter().map(contact).collect()
}

/// Returns the inertia of bodies and rotors.
fn inertia_matrix(
    mechanism: &Mechanism,
    motions: &[Motion],
    contacts: &[Contact],
    unknowns: usize,
) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(unknowns, unknowns);
    for (body, (rigid, motion)) in mechanism.bodies.iter().zip(motions).enumerate() {
        let inertia = motion.rotation * rigid.inertia * motion.rotation.transpose();
        matrix.fixed_view_mut::<3, 3>(6 * body, 6 * body).fill_diagonal(rigid.mass);
        matrix.fixed_view_mut::<3, 3>(6 * body + 3, 6 * body + 3).copy_from(&inertia);
    }
    for contact in contacts.iter().filter(|contact| contact.unknowns() > 0) {
        let (first, own) = (contact.first_unknown, contact.unknowns());
        matrix.view_mut((first, first), (own, own)).copy_from(&contact.passive.inertia);
    }
    matrix
}

/// Returns the matrix from the unknowns to the relative accelerations of the hinges: the acceleration
/// of the outboard origin, minus that of the coincident point of the inboard side, minus that due to
/// the hinge's rates.
fn constraint_matrix(contacts: &[Contact], unknowns: usize) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(6 * contacts.len(), unknowns);
    for (k, contact) in contacts.iter().enumerate() {
        let between = contact.outboard.position - contact.inboard.position;
        let sides = [(&contact.inboard, between, -1.0), (&contact.outboard, Vec3::zeros(), 1.0)];
        for (place, further, sign) in sides {
            if let Some(body) = place.body {
                let by_spin = rotation::cross_matrix(&(place.arm + further)) * -sign;
                matrix.fixed_view_mut::<6, 6>(6 * k, 6 * body).fill_diagonal(sign);
                matrix.fixed_view_mut::<3, 3>(6 * k, 6 * body + 3).copy_from(&by_spin);
            }
        }
        let own = (6, contact.unknowns());
        if contact.unknowns() > 0 {
            matrix.view_mut((6 * k, contact.first_unknown), own).copy_from(&-contact.directions());
        }
    }
    matrix
}
