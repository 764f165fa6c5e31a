//! The loop hinge, which closes a chain that is held at both ends: its constraints and its forces.
//!
//! With `a_p` of the link on its inboard side, `a_c` of its outboard side (which is known), the
//! motion subspace `S`, the constraint-force subspace `T` with `Tᵀ S = 0` and the active-force
//! subspace `W` with `Wᵀ S = 1` (Featherstone's `T_a`):
//!
//! (1)  `Tᵀ (a_c − X a_p − b) = 0`, `F = T λ + W τ`
//! (2)  `q̈ = Wᵀ (a_c − X a_p − b)`
//!
//! All quantities belong to the hinge, on its outboard side, in the work axes of a link on that
//! side. `X` carries the acceleration of the inboard link there, and `b` is the bias acceleration
//! of the hinge.
//!
//! A rotor with inertia `I` along a rate adds a constraint with an inertia: its wrench is `−I W`,
//! and its `λ` is the acceleration `q̈ = Wᵀ (a_c − X a_p − b)`, so that `F = W (τ − I q̈)`.

use super::kinematics::{
    HingeKinematics, LinkKinematics, PartKinematics, hinge_kinematics, link_of,
};
use super::reflection::{Reflection, VectorSpace};
use super::sweep::PerLink;
use super::{Axes, EvalContext, hinge};
use crate::ids::LinkId;
use crate::math::{Mat3, Motion, Rotation, Scalar, Vec3, Wrench};
use crate::model::{Hinge, HingeId};

/// The loop hinge.
#[derive(Clone, Debug)]
pub struct LoopHinge<S> {
    /// The kinematics of the hinge, seen from its inboard side.
    pub hinge: HingeKinematics<S>,
    /// The link on its inboard side; `None` for the ground.
    pub parent: Option<LinkId>,
    /// The link on its outboard side; `None` for the ground.
    pub child: Option<LinkId>,
    /// From the point of the outboard link to the hinge, work axes of that link.
    child_arm: Vec3<S>,
    /// Rotation from the work axes of the outboard link to those of the hinge.
    child_to_work: Mat3<S>,
    /// The constraints `T`.
    pub constraints: Vec<Constraint<S>>,
    /// The active-force subspace `W`: each wrench does work on one rate only.
    pub active_forces: Vec<Wrench<S>>,
}

/// One constraint of the loop hinge.
#[derive(Clone, Copy, Debug)]
pub struct Constraint<S> {
    /// The wrench of a unit constraint force, on the outboard side at the hinge, work axes.
    pub wrench: Wrench<S>,
    /// The rotor inertia, if only a rotor acts along this wrench; zero for a kinematic constraint.
    pub inertia: S,
}

/// Returns the loop hinge, if the chain is closed.
pub fn loop_hinge<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    links: &PerLink<LinkKinematics<S>>,
) -> Option<LoopHinge<S>> {
    let index = match context.layout.loop_hinges[..] {
        [] => return None,
        [index] => index,
        ref all => bug!("{} hinges close a chain", all.len()),
    };
    let Hinge { kind, inboard, outboard, .. } = &context.chain.hinges[index];
    let (inboard, ..) = context.frame_of(inboard);
    let (outboard, origin, rotation) = context.frame_of(outboard);
    let (parent, child) = (link_of(inboard), link_of(outboard));
    let part =
        |link: Option<LinkId>| link.map_or(PartKinematics::ground(), |link| links[link].part());
    let hinge = hinge_kinematics(context, axes, (index, false), &part(parent));
    let alignment = kind.law().alignment(context.values);
    let PartKinematics { part_to_work, point, .. } = part(child);
    let part_to_work = part_to_work.matrix();
    let child_to_work =
        hinge.child_to_work.matrix() * (part_to_work * (rotation * alignment)).transposed();
    let child_arm = part_to_work * (origin - point);
    let to_work = Rotation::from_matrix(hinge.child_to_work.matrix());
    let active_forces: Vec<Wrench<S>> = active_forces(&hinge.aligned_subspace)
        .into_iter()
        .map(|force| force.rotated(&to_work))
        .collect();
    let constraints = constraints(context, index, &hinge, &active_forces);
    Some(LoopHinge { hinge, parent, child, child_arm, child_to_work, constraints, active_forces })
}

impl<S: Scalar> LoopHinge<S> {
    /// Returns the hinge with kinematic constraints that have translations as errors: a rotation is that of a point at
    /// the distance `1 / per_length`.
    pub fn with_constraints_of_one_unit(&self, per_length: S) -> Self {
        let of_one_unit = |&Constraint { wrench, inertia }: &Constraint<S>| {
            let (force, moment) = (wrench.force, wrench.moment * per_length);
            let norm = (force.dot(force) + moment.dot(moment)).sqrt();
            let factor = if inertia.vanishes() { norm.recip() } else { S::one() };
            Constraint { wrench: wrench.scaled(factor), inertia }
        };
        let constraints = self.constraints.iter().map(of_one_unit).collect();
        LoopHinge { constraints, ..self.clone() }
    }
}

fn constraints<S: Scalar>(
    context: &EvalContext<S>,
    index: HingeId,
    hinge: &HingeKinematics<S>,
    active_forces: &[Wrench<S>],
) -> Vec<Constraint<S>> {
    let axes = context.chain.dimension.axes();
    let fixed = |wrench| Constraint { wrench, inertia: S::zero() };
    if context.chain.hinges[index].is_prescribed() {
        return axes.iter().map(|&axis| fixed(Wrench::unit(axis))).collect();
    }
    let to_work = Rotation::from_matrix(hinge.child_to_work.matrix());
    let null_space = null_space(&hinge.aligned_subspace, axes).into_iter();
    let mut all: Vec<Constraint<S>> =
        null_space.map(|wrench| fixed(wrench.rotated(&to_work))).collect();
    let inertias = hinge.passives.inertias.iter().enumerate();
    for (strain, &inertia) in inertias.filter(|(_, inertia)| !inertia.vanishes()) {
        let wrench = strain_force(hinge, active_forces, strain).scaled(-inertia);
        all.push(Constraint { wrench, inertia });
    }
    all
}

/// Returns the wrench that does work on one strain rate only.
fn strain_force<S: Scalar>(
    hinge: &HingeKinematics<S>,
    active_forces: &[Wrench<S>],
    strain: usize,
) -> Wrench<S> {
    let rates = active_forces.iter().zip(&hinge.passives.strains.jacobian[strain]);
    rates.fold(Wrench::zero(), |sum, (&force, &x)| sum + force.scaled(x))
}

/// Returns orthonormal wrenches that do no work on any of the motions, among the given axes: the
/// null space of `Sᵀ`.
///
/// Axes without motion are basis vectors unchanged. Among the other axes, each motion removes one
/// direction by a reflection. The motions with the fewest entries come first, since a motion along
/// an axis removes that axis only.
fn null_space<S: Scalar>(motions: &[Motion<S>], axes: &[usize]) -> Vec<Wrench<S>> {
    let present = |motion: &Motion<S>, k: usize| !motion.at(k).vanishes();
    let moves = |k: usize| motions.iter().any(|motion| present(motion, k));
    let (moving, still): (Vec<usize>, Vec<usize>) = axes.iter().partition(|&&k| moves(k));
    let mut left: Vec<Wrench<S>> = moving.into_iter().map(Wrench::unit).collect();
    let mut by_entries: Vec<&Motion<S>> = motions.iter().collect();
    by_entries.sort_by_key(|motion| (0..6).filter(|&k| present(motion, k)).count());
    for motion in by_entries {
        let powers: Vec<S> = left.iter().map(|&wrench| motion.power(wrench)).collect();
        if powers.iter().all(|power| power.vanishes()) {
            bug!("a closing hinge has a motion that others of it make")
        }
        Reflection::of(&powers).apply(&mut left);
    }
    still.into_iter().map(Wrench::unit).chain(left).collect()
}

/// Returns the dual basis: each wrench does work on one of the motions and none on the others.
fn active_forces<S: Scalar>(motions: &[Motion<S>]) -> Vec<Wrench<S>> {
    let as_wrench = |m: Motion<S>| Wrench { force: m.linear, moment: m.angular };
    let products: Vec<Vec<S>> =
        motions.iter().map(|a| motions.iter().map(|&b| a.power(as_wrench(b))).collect()).collect();
    let inverse = symmetric_inverse(&products);
    let force = |row: &Vec<S>| {
        motions.iter().zip(row).fold(Wrench::zero(), |sum, (&m, &x)| sum + as_wrench(m).scaled(x))
    };
    inverse.iter().map(force).collect()
}

/// Returns the inverse of a symmetric positive definite matrix, by Gauss-Jordan elimination.
fn symmetric_inverse<S: Scalar>(products: &[Vec<S>]) -> Vec<Vec<S>> {
    let count = products.len();
    let mut left = products.to_vec();
    let (mut right, _) = hinge::identity(count);
    for k in 0..count {
        let scale = left[k][k].recip();
        for side in [&mut left, &mut right] {
            side[k] = side[k].iter().map(|&x| x * scale).collect();
        }
        for i in (0..count).filter(|&i| i != k) {
            let factor = left[i][k];
            for side in [&mut left, &mut right] {
                let row = side[k].clone();
                side[i] = side[i].iter().zip(row).map(|(&x, y)| x - factor * y).collect();
            }
        }
    }
    right
}

impl<S: Scalar> VectorSpace<S> for Wrench<S> {
    fn plus_scaled(self, other: Self, factor: S) -> Self {
        self + other.scaled(factor)
    }
    fn scaled(self, factor: S) -> Self {
        Wrench::scaled(self, factor)
    }
}

impl<S: Scalar> LoopHinge<S> {
    /// Returns the motion of the outboard side at the hinge, work axes, from that of the outboard
    /// link.
    pub fn motion_from_child(&self, motion: Motion<S>) -> Motion<S> {
        motion.shifted_to(self.child_arm).rotated(self.child_to_work)
    }

    /// Returns the outboard link, and the wrench on the outboard side as one about the link's
    /// point, in the link's work axes.
    pub fn wrench_on_child(&self, wrench: Wrench<S>) -> Option<(LinkId, Wrench<S>)> {
        let back = Rotation::from_matrix(self.child_to_work);
        Some((self.child?, wrench.rotated_back(&back).shifted_from(self.child_arm)))
    }

    /// Returns the bias acceleration of the hinge that the rotation of the outboard link causes,
    /// work axes.
    pub fn child_bias_acceleration(&self, links: &PerLink<LinkKinematics<S>>) -> Motion<S> {
        let omega = self.child.map_or(Vec3::zero(), |child| links[child].omega);
        let linear = self.child_to_work * self.child_arm.centripetal(omega);
        Motion { linear, angular: Vec3::zero() }
    }

    /// Returns the hinge's rates, or their changes, for a motion relative to the inboard side.
    pub fn rates(&self, relative: Motion<S>) -> Vec<S> {
        self.active_forces.iter().map(|&force| relative.power(force)).collect()
    }

    /// Returns the wrench on the outboard side that efforts along the rates exert.
    pub fn applied_wrench(&self, efforts: &[S]) -> Wrench<S> {
        if self.is_prescribed() {
            return Wrench::zero();
        }
        let all = self.active_forces.iter().zip(efforts);
        all.fold(Wrench::zero(), |sum, (&force, &effort)| sum + force.scaled(effort))
    }

    fn is_prescribed(&self) -> bool {
        self.hinge.basis.columns.is_empty()
    }

    /// Returns the wrench on the outboard side, from the applied wrench and the constraint forces.
    pub fn wrench(&self, applied: Wrench<S>, reactions: &[S]) -> Wrench<S> {
        let all = self.constraints.iter().zip(reactions);
        all.fold(applied, |sum, (constraint, &reaction)| sum + constraint.wrench.scaled(reaction))
    }
}

#[cfg(test)]
mod tests {
    use super::null_space;
    use crate::math::{Motion, Scalar, Structured, Vec3};

    /// Motions by their entries; zeros are known while compiling.
    fn motions(entries: &[[f64; 6]]) -> Vec<Motion<Structured<f64>>> {
        let number = |x: f64| if x == 0.0 { Structured::zero() } else { Structured::variable(x) };
        let vector = |part: &[f64]| Vec3::from_fn(|k| number(part[k]));
        let motion = |e: &[f64; 6]| Motion { linear: vector(&e[..3]), angular: vector(&e[3..]) };
        entries.iter().map(motion).collect()
    }

    #[test]
    fn complements_are_orthonormal_and_do_no_work() {
        let screw = [0.0, 0.0, -0.3, 0.0, 0.0, 1.0];
        let universal = [[0.0, 0.0, 0.0, 0.6, 0.48, 0.64], [0.0, 0.0, 0.0, 0.0, 0.0, 1.0]];
        let skew = [[0.3, -0.2, 0.0, 0.5, 0.1, 0.7], [0.1, 0.4, 0.2, 0.0, -0.6, 0.2]];
        let ball = [3, 4, 5].map(|axis| [0, 1, 2, 3, 4, 5].map(|k| f64::from(k == axis)));
        let all: [&[[f64; 6]]; 5] = [&[], &[screw], &universal, &skew, &ball];
        for entries in all {
            let motions = motions(entries);
            let wrenches = null_space(&motions, &[0, 1, 2, 3, 4, 5]);
            assert_eq!(wrenches.len(), 6 - motions.len());
            for (i, wrench) in wrenches.iter().enumerate() {
                for motion in &motions {
                    // Entries are at most one; a dozen roundings.
                    assert!(motion.power(*wrench).value().abs() < 12.0 * f64::EPSILON);
                }
                for (j, other) in wrenches.iter().enumerate() {
                    let products = (0..6).map(|k| wrench.at(k).value() * other.at(k).value());
                    let error = products.sum::<f64>() - f64::from(u8::from(i == j));
                    assert!(error.abs() < 12.0 * f64::EPSILON, "{i} {j}: {error}");
                }
            }
        }
    }

    #[test]
    fn directions_along_axes_stay_whole() {
        let pin = motions(&[[0.0, 0.0, 0.0, 0.0, 0.0, 1.0]]);
        for wrench in null_space(&pin, &[0, 1, 2, 3, 4, 5]) {
            let present: Vec<usize> = (0..6).filter(|&k| !wrench.at(k).vanishes()).collect();
            assert_eq!(present.len(), 1);
        }
    }
}
