//! A free base: a link that can move in all directions of the chain's dimension relative to the
//! ground, without any effort.
//!
//! The wrench in the hinge of a free base vanishes about every point, so the base may have any point.
//! The point is moved to the hinge of a child, as the points of all other links are at hinges: the
//! articulated inertia of this child then needs no translation, and the child has no centripetal
//! acceleration. The accelerations of HyQ's trunk with one leg need 870 operations instead of 998,
//! those of the whole robot 3049 instead of 3135.
//!
//! Light bases lose less accuracy. With a thousandth of the trunk's mass and random torques, the errors
//! decrease from 57 to 0.7 units in the last place (median of the largest in 400 states, `f32`). With
//! the trunk's own mass, those of its angular acceleration grow from 1.4 to 1.9 units; the largest
//! error of all accelerations is unchanged.
//!
//! Vectors are in the work axes of the base; `r` is from the origin `O` of its hinge to the new point
//! `P`.

use super::EvalContext;
use super::kinematics::{LinkKinematics, attachments};
use super::strategy;
use super::sweep::PerLink;
use crate::ids::LinkId;
use crate::math::{Motion, Scalar, Vec3};
use crate::model::HingeId;

/// A free base whose point was moved.
#[derive(Clone, Copy, Debug)]
pub struct FreeBase<S> {
    /// Its link.
    pub link: LinkId,
    /// The hinge of the link.
    pub hinge: HingeId,
    /// `r`
    to_point: Vec3<S>,
}

/// Moves the points of all free bases to the hinge of a child if this saves operations
/// ([`strategy::saves_translation`]). Returns the bases. Motion subspace and bias acceleration of
/// their hinges remain those of `O`.
pub fn move_to_children<S: Scalar>(
    context: &EvalContext<S>,
    links: &mut PerLink<LinkKinematics<S>>,
) -> Vec<FreeBase<S>> {
    let roots = context.tree.roots().into_iter();
    let roots: Vec<LinkId> = roots.filter(|&link| may_move(context, link, &links[link])).collect();
    roots.into_iter().map(|root| move_to_child(context, root, links)).collect()
}

/// Whether a link is a free base that may be moved. The boundaries of repeated parts stay.
fn may_move<S: Scalar>(context: &EvalContext<S>, index: LinkId, link: &LinkKinematics<S>) -> bool {
    let is_at_boundary = |&link: &LinkId| context.layout.is_at_repeat_boundary(link);
    link.is_free(context.chain.dimension)
        && !context.layout.links[index].reversed
        && !context.tree.children_of(index).iter().chain([&index]).any(is_at_boundary)
}

fn move_to_child<S: Scalar>(
    context: &EvalContext<S>,
    index: LinkId,
    links: &mut PerLink<LinkKinematics<S>>,
) -> FreeBase<S> {
    let children = context.tree.children_of(index);
    let is_chosen = |&child: &LinkId| {
        let LinkKinematics { hinge, first_moment, .. } = &links[child];
        let is_last = context.tree.children_of(child).is_empty();
        hinge.is_concentric()
            && strategy::saves_translation(&hinge.subspace, *first_moment, is_last)
    };
    let chosen = children.iter().copied().find(is_chosen);
    let base = &mut links[index];
    let to_point = chosen.map_or(Vec3::zero(), |child| {
        let (from, _) = attachments(context.chain, &context.layout.links[child]);
        base.part_to_work * (context.frame_of(from).1 - base.point)
    });
    base.point = base.point + base.part_to_work.transposed() * to_point;
    base.rigid_inertia().shifted_from(-to_point).write_to(base);
    // Loads need the position and the velocity of the point.
    base.hinge.arm = base.hinge.arm + base.hinge.to_parent.rotate(to_point);
    base.hinge.relative_velocity = base.hinge.relative_velocity.shifted_to(to_point);
    let omega = base.omega;
    for child in children {
        let hinge = &mut links[child].hinge;
        hinge.arm = hinge.arm - to_point;
        hinge.bias_acceleration.on_parent = hinge.arm.centripetal_by_products(omega);
    }
    FreeBase { link: index, hinge: links[index].hinge.id, to_point }
}

impl<S: Scalar> FreeBase<S> {
    /// Returns `v̇` of the base, from the proper acceleration `a` of `P`. Translations are along
    /// inboard axes, in which the acceleration of the ground is constant and is subtracted last.
    pub fn rates(
        &self,
        context: &EvalContext<S>,
        base: &LinkKinematics<S>,
        a: Motion<S>,
    ) -> Vec<S> {
        let r = self.to_point;
        let linear = a.shifted_to(-r).linear - r.centripetal_by_products(base.omega);
        let (from, _) = attachments(context.chain, &context.layout.links[self.link]);
        let (_, _, inboard) = context.frame_of(from);
        let ground = inboard.transposed() * context.base_acceleration().linear;
        let translations = context.chain.dimension.translations();
        let translation =
            |(&axis, column): (&usize, &Motion<S>)| column.linear.dot(linear) - ground[axis];
        let (along, about) = base.hinge.subspace.split_at(translations.len());
        let about = about.iter().map(|column| column.angular.dot(a.angular));
        translations.iter().zip(along).map(translation).chain(about).collect()
    }
}
