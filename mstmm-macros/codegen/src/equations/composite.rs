//! Composite bodies: everything outboard of a hinge as one body, with the hinges further outboard held.
//! From them follow the mass matrix, the derivatives of inverse dynamics in
//! [`derivatives`](super::derivatives), and the Coriolis matrix in [`coriolis`](super::coriolis).
//!
//! # Notation
//!
//! All quantities of a link belong to its point, in its work axes; `r` is from this point to a mass, and
//! `ṙ` is its rate in axes that do not rotate.
//!
//! | symbol | in code | meaning |
//! |---|---|---|
//! | `m`, `h`, `J` | `rigid` | mass, first moment and inertia |
//! | `P = ∫ ṙ dm` | `twice_momentum` is `2 P` | momentum relative to the point |
//! | `E = ∫ ṙ rᵀ dm` | `spin` is `B = 2 (tr E 1 − E)` | `B δΩ = 2 ∫ r × (δΩ × ṙ) dm` |
//! | `u` | `twice_velocity` is `2 u` | velocity of a link's point relative to its parent's; parent's axes |
//!
//! # Equations
//!
//! Of a link's own part, `P = Ω × h` and `E = Ω̃ ∫ r rᵀ dm`, thus
//!
//! (1)  `B = 2 Ω̃ J − tr J Ω̃`
//!
//! and inward, from a child at `arm`, with `k = h + m arm` of the child
//!
//! (2)  `P ← P + m u`, `E ← E + P armᵀ + u kᵀ`
//!
//! The mass matrix of a chain at rest is `M = Sᵀ I S` over pairs of hinges on one path to the ground
//! (R. Featherstone, *Rigid Body Dynamics Algorithms*, section 6.2).

use super::base_parameters::base_kinematics;
use super::dense_matrix::DenseMatrix;
use super::kinematics::{HingeKinematics, LinkKinematics, RigidInertia};
use super::loop_hinge::loop_hinge;
use super::sweep::{Flatten, PerLink};
use super::{Axes, EvalContext, Trace};
use crate::ids::LinkId;
use crate::math::{Mat3, Motion, Scalar, SpatialInertia, Vec3, Wrench};
use crate::model::Layout;
use std::ops::Range;

/// Everything outboard of a link's hinge as one body.
#[derive(Clone, Copy, Debug)]
pub(super) struct CompositeBody<S> {
    /// `m`, `h`, `J`
    pub rigid: RigidInertia<S>,
    /// `2 P`
    pub twice_momentum: Vec3<S>,
    /// `B`
    pub spin: Mat3<S>,
}

impl<S: Scalar> CompositeBody<S> {
    /// Returns `I s`: the wrench that accelerates the composite body by a motion of its point.
    pub fn wrench(&self, motion: Motion<S>) -> Wrench<S> {
        let RigidInertia { mass, first_moment, inertia } = self.rigid;
        SpatialInertia::rigid(mass, first_moment, inertia).times(motion)
    }

    /// Returns the own part of a link, by equation (1).
    fn of_link(link: &LinkKinematics<S>) -> Self {
        let &LinkKinematics { omega, first_moment, inertia, .. } = link;
        let twice = omega * S::number(2.0);
        CompositeBody {
            rigid: link.rigid_inertia(),
            twice_momentum: twice.cross(first_moment),
            spin: twice.skew() * inertia.full() - omega.skew() * inertia.trace(),
        }
    }

    /// Returns the body about the parent's point, in the parent's axes, by equation (2).
    fn to_parent(self, hinge: &HingeKinematics<S>) -> Self {
        let (arm, rotation) = (hinge.arm, &hinge.to_parent);
        let RigidInertia { mass, first_moment, inertia } = self.rigid;
        let rotated = RigidInertia {
            mass,
            first_moment: rotation.rotate(first_moment),
            inertia: rotation.rotate_symmetric(inertia),
        };
        let rigid = rotated.shifted_from(arm);
        let (u, momentum) = (twice_velocity(hinge), rotation.rotate(self.twice_momentum));
        let k = rigid.first_moment;
        let even = momentum.dot(arm) + u.dot(k);
        let uneven = |i: usize, j: usize| momentum[i] * arm[j] + u[i] * k[j];
        let shift = Mat3::from_fn(|i, j| {
            let diagonal = if i == j { even } else { S::zero() };
            diagonal - uneven(i, j)
        });
        CompositeBody {
            rigid,
            twice_momentum: momentum + u * mass,
            spin: rotation.rotate_tensor(self.spin) + shift,
        }
    }

    fn plus(self, other: Self) -> Self {
        CompositeBody {
            rigid: self.rigid.plus(other.rigid),
            twice_momentum: self.twice_momentum + other.twice_momentum,
            spin: self.spin + other.spin,
        }
    }
}

impl<S: Scalar> Flatten<S> for CompositeBody<S> {
    fn visit(self, _: &mut dyn FnMut(S) -> S) -> Self {
        bug!("a composite body reaches the boundary of a repeated part")
    }
}

/// Returns `2 u` of a hinge.
pub(super) fn twice_velocity<S: Scalar>(hinge: &HingeKinematics<S>) -> Vec3<S> {
    hinge.point_velocity() * S::number(2.0)
}

/// Returns the composite bodies of all links. The chain must be written out: no values cross the
/// boundaries of repeated parts.
pub(super) fn composite_bodies<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    trace: &mut Trace<S>,
) -> PerLink<CompositeBody<S>> {
    let own = links.iter().map(CompositeBody::of_link).collect();
    let ground = CompositeBody {
        rigid: RigidInertia::zero(),
        twice_momentum: Vec3::zero(),
        spin: Mat3::zero(),
    };
    let step = |index: LinkId, body: CompositeBody<S>, parent: &mut CompositeBody<S>| {
        let hinge = &links[index].hinge;
        let name = format!("{}_composite", hinge.name);
        trace.section(name.clone(), format!("Composite body outboard of `{}`", hinge.name), "");
        let RigidInertia { mass, first_moment, inertia } = body.rigid;
        trace.rigid_body(&name, mass, first_moment, inertia);
        trace.vector(&format!("{name}_momentum"), body.twice_momentum);
        trace.matrix(&format!("{name}_spin"), body.spin);
        *parent = parent.plus(body.to_parent(hinge));
        body
    };
    context.tree.inward(own, ground, step).0
}

/// Returns the mass matrix, with one row and column for each free rate. Rotors are part of it.
pub fn mass_matrix<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> DenseMatrix<S> {
    let links = base_kinematics(context, axes, trace);
    let closed = loop_hinge(context, axes, &links);
    let bodies = composite_bodies(context, &links, trace);
    let mut matrix = of_composite_bodies(context, &links, &bodies, trace);
    if let Some(closed) = closed {
        add_rotors(context, &closed.hinge, &mut matrix);
    }
    matrix
}

/// Returns the mass matrix of the links' hinges, from the composite bodies.
pub(super) fn of_composite_bodies<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    bodies: &PerLink<CompositeBody<S>>,
    trace: &mut Trace<S>,
) -> DenseMatrix<S> {
    let count = context.layout.dof_count();
    let mut matrix = DenseMatrix::zero(count, count);
    links.enumerate().for_each(|(index, LinkKinematics { hinge, .. })| {
        let own = context.layout.v[hinge.id].clone();
        trace.section(
            format!("{}_mass", hinge.name),
            format!("Columns of the mass matrix for `{}`", hinge.name),
            "",
        );
        for (column, &motion) in own.clone().zip(&hinge.subspace) {
            let visit = |at: LinkId, wrench: &Wrench<S>| {
                let LinkKinematics { hinge, .. } = &links[at];
                for (row, s) in context.layout.v[hinge.id].clone().zip(&hinge.subspace) {
                    if at != index || row <= column {
                        let entry = s.power(*wrench);
                        trace.number(format!("mass{row}_{column}"), entry);
                        matrix.set(row, column, entry);
                        matrix.set(column, row, entry);
                    }
                }
            };
            let inward = |at: LinkId, wrench: Wrench<S>| links[at].hinge.wrench_to_parent(wrench);
            to_ground(context, index, bodies[index].wrench(motion), visit, inward);
        }
        add_rotors(context, hinge, &mut matrix);
    });
    matrix
}

/// Adds the rotors of a hinge to the mass matrix.
fn add_rotors<S: Scalar>(
    context: &EvalContext<S>,
    hinge: &HingeKinematics<S>,
    matrix: &mut DenseMatrix<S>,
) {
    let range = context.layout.v[hinge.id].clone();
    let rotors = entries_of_product(range, |unit| hinge.passives.rotor_efforts(unit));
    // One of each pair of symmetric entries, so that they are equal.
    for (row, column, effort) in rotors.into_iter().filter(|(row, column, _)| row <= column) {
        let sum = matrix.at(row, column) + effort;
        matrix.set(row, column, sum);
        matrix.set(column, row, sum);
    }
}

/// Returns row, column and value of all entries of a block on the diagonal of a matrix, from its product with a
/// vector.
pub(super) fn entries_of_product<S: Scalar>(
    range: Range<usize>,
    product: impl Fn(&[S]) -> Vec<S>,
) -> Vec<(usize, usize, S)> {
    let of_column = |k: usize| -> Vec<_> {
        let column = product(&unit_vector(range.len(), k));
        range.clone().zip(column).map(|(row, entry)| (row, range.start + k, entry)).collect()
    };
    (0..range.len()).flat_map(of_column).collect()
}

/// Carries a value from a link to the ground. `visit` sees it at the link and at every ancestor; `inward`
/// carries it from a link to its parent. Returns the value at the ground. The chain must be written out.
pub(super) fn to_ground<S: Scalar, B>(
    context: &EvalContext<S>,
    from: LinkId,
    start: B,
    mut visit: impl FnMut(LinkId, &B),
    inward: impl Fn(LinkId, B) -> B,
) -> B {
    context.tree.carry_inward(&context.tree.path_to(from), start, |link, carried| {
        visit(link, &carried);
        inward(link, carried)
    })
}

/// Returns all free rates from the ground outward, each with its link.
pub(super) fn outward_rates(layout: &Layout) -> Vec<(LinkId, usize)> {
    let each = layout.links.enumerate();
    each.flat_map(|(index, link)| layout.v[link.hinge].clone().map(move |v| (index, v))).collect()
}

/// Returns a vector of zeros with a one at index `k`.
pub(super) fn unit_vector<S: Scalar>(count: usize, k: usize) -> Vec<S> {
    (0..count).map(|i| if i == k { S::one() } else { S::zero() }).collect()
}
