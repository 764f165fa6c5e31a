//! Momentum of a chain, and the matrix that maps the free rates to it.
//!
//! All vectors are in inertial axes. With the position `r` and the velocity `ṙ` of a link's point, mass
//! `m`, first moment `h` and inertia `J` of its part about the point, and the centre of mass `c` of the
//! chain, in which bodies that are fixed to the ground count:
//!
//! (1)  `p = Σ m ṙ + Ω × h`
//! (2)  `L = Σ J Ω + h × ṙ + (r − c) × (m ṙ + Ω × h)`
//!
//! The column of a rate follows in the same way from the motion subspace of its hinge and the inertia of
//! everything outboard.

use super::kinematics::{LinkKinematics, Pose, RigidInertia, poses};
use super::sweep::{Flatten, PerLink};
use super::{Axes, EvalContext, Trace, kinematics};
use crate::ids::LinkId;
use crate::math::{Motion, Scalar, Vec3};
use crate::model::MovesWith;

/// The momentum of a chain.
#[derive(Clone, Copy, Debug)]
pub struct ChainMomentum<S> {
    /// The mass in kg.
    pub mass: S,
    /// The centre of mass in m.
    pub center_of_mass: Vec3<S>,
    /// Linear momentum in kg m/s, and angular momentum about the centre of mass in kg m²/s.
    pub momentum: Motion<S>,
}

/// Returns the momentum of a chain.
pub fn momentum<S: Scalar>(context: &EvalContext<S>, trace: &mut Trace<S>) -> ChainMomentum<S> {
    let links = kinematics(context, Axes::Inertial, trace);
    let poses = poses(context, &links);
    let (mass, center_of_mass) = center_of_mass(context, &links, &poses);
    trace.section("momentum", "Momentum", "");
    trace.vector("center_of_mass", center_of_mass);
    let momentum = context.tree.total(Motion::zero(), |index, total| {
        let (link, pose) = (&links[index], &poses[index]);
        let velocity = Motion { linear: pose.velocity, angular: link.omega };
        let own = OutboardMass::of(link);
        total + own.momentum(velocity, pose.position - center_of_mass)
    });
    trace.motion("momentum", momentum);
    ChainMomentum { mass, center_of_mass, momentum }
}

/// Returns the columns of the matrix that maps the free rates to the momentum, in the layout's order; zero
/// for the loop hinge.
pub fn momentum_matrix<S: Scalar>(
    context: &EvalContext<S>,
    trace: &mut Trace<S>,
) -> Vec<Motion<S>> {
    let links = kinematics(context, Axes::Inertial, trace);
    let poses = poses(context, &links);
    let (_, center_of_mass) = center_of_mass(context, &links, &poses);
    let own = links.iter().map(OutboardMass::of).collect();
    let step = |index: LinkId, outboard: OutboardMass<S>, parent: &mut OutboardMass<S>| {
        *parent = parent.plus(outboard.shifted_from(links[index].hinge.arm));
        outboard
    };
    let (outboard, _) = context.tree.inward(own, OutboardMass::zero(), step);
    let mut columns = vec![Motion::zero(); context.layout.dof_count()];
    trace.section("momentum", "Momentum at each rate", "");
    links.enumerate().for_each(|(index, link)| {
        let arm = poses[index].position - center_of_mass;
        let range = context.layout.v[link.hinge.id].clone();
        let free = columns[range].iter_mut().zip(&link.hinge.subspace);
        for (number, (column, unit)) in free.enumerate() {
            *column = outboard[index].momentum(*unit, arm);
            trace.motion(&format!("{}_momentum{number}", link.hinge.name), *column);
        }
    });
    columns
}

/// Returns mass and centre of mass.
fn center_of_mass<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    poses: &PerLink<Pose<S>>,
) -> (S, Vec3<S>) {
    let (mass, moment) = context.tree.total(on_ground(context), |index, (mass, moment)| {
        let link = &links[index];
        (mass + link.mass, moment + poses[index].position * link.mass + link.first_moment)
    });
    (mass, moment * mass.recip())
}

/// Returns the mass and the first moment about the inertial origin of all bodies that are fixed to the ground.
fn on_ground<S: Scalar>(context: &EvalContext<S>) -> (S, Vec3<S>) {
    let EvalContext { chain, layout, values, .. } = context;
    let fixed = chain.physical_bodies().filter(|&body| layout.parts[body] == MovesWith::Ground);
    fixed.fold((S::zero(), Vec3::zero()), |(mass, moment), id| {
        let body = &chain.bodies[id];
        let (origin, rotation) = context.frame(id);
        let own = values.scalar(&body.mass);
        (mass + own, moment + (origin + rotation * values.vector(&body.com)) * own)
    })
}

/// The inertia of everything outboard of a hinge about the link's point, inertial axes. Unlike a
/// [`RigidInertia`] it crosses the boundaries of repeated parts.
#[derive(Clone, Copy, Debug)]
struct OutboardMass<S>(RigidInertia<S>);

impl<S: Scalar> OutboardMass<S> {
    fn zero() -> Self {
        OutboardMass(RigidInertia::zero())
    }

    fn of(link: &LinkKinematics<S>) -> Self {
        OutboardMass(link.rigid_inertia())
    }

    fn plus(self, other: Self) -> Self {
        OutboardMass(self.0.plus(other.0))
    }

    fn shifted_from(self, arm: Vec3<S>) -> Self {
        OutboardMass(self.0.shifted_from(arm))
    }

    /// Returns the momentum at a velocity of the point, about a point from which `arm` leads to it.
    fn momentum(&self, velocity: Motion<S>, arm: Vec3<S>) -> Motion<S> {
        let OutboardMass(RigidInertia { mass, first_moment, inertia }) = *self;
        let linear = velocity.linear * mass + velocity.angular.cross(first_moment);
        let about_point = inertia * velocity.angular + first_moment.cross(velocity.linear);
        Motion { linear, angular: about_point + arm.cross(linear) }
    }
}

impl<S: Scalar> Flatten<S> for OutboardMass<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let mass = replace(self.0.mass);
        let first_moment = self.0.first_moment.visit(replace);
        let inertia = self.0.inertia.visit(replace);
        OutboardMass(RigidInertia { mass, first_moment, inertia })
    }
}
