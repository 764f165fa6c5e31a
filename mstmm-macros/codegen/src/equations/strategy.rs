//! What the generator knows of costs: where a quantity can be computed in several ways, which one
//! is taken.
//!
//! All ways are exact, and the sweeps ask here, so that formulas stand alone. Every decision
//! depends on which numbers are zero for every state, on the structure of the chain or on the
//! method, never on values. Times are for chains of the benchmarks (`benches/README.md`): D7 is the
//! Panda, C7 has seven pins about alternating axes, A10 ten pins in a plane, B3 to B100 that many
//! balls.

use crate::math::{Mat3, PlaneFormula, Rotation, Scalar, SpatialInertia, Sym3, Vec3, Wrench};
use crate::model::SolutionMethod;

/// The axes in which the equations of the links are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    /// Axes fixed in each part, aligned with the hinge that it hangs on: inertias stay constant,
    /// what is transferred turns at every hinge.
    Body,
    /// The inertial axes: nothing turns at a hinge, the inertias do.
    Inertial,
}

/// The axes of the sweeps. In inertial axes `riccati` took 45 % more operations in the best case
/// measured (thirty balls) and six times as many in the worst (one ball).
pub const AXES: Axes = Axes::Body;

/// Over so many bodies at most a transmitted wrench is a sum of what every body takes.
///
/// Beyond, and at the boundaries of repeated parts, it is `Iᴬ a' + pᴬ`: that takes about as many
/// operations, but the 20 numbers have to be kept until accelerations are known, and rounding of
/// the sum grows with the square of the number of bodies. Sums in place of relations: D7 500 → 458
/// ns, C7 409 → 377, B3 183 → 152, together with base parameters in the energies.
pub const MAX_SUMMED_BODIES: usize = 8;

/// Whether the relations of the Riccati transfer are kept for transmitted wrenches. With a closing
/// hinge they would contain its reactions, in as many products as the sum over all bodies takes.
pub fn keeps_affine_wrenches(is_closed: bool) -> bool {
    !is_closed
}

/// Whether accelerations are computed with base parameters.
///
/// They take 2 to 5 % less time. In inertial axes inertias turn with the parts, so nothing is
/// saved. The transfer takes the bodies as they are, and so do constraints.
pub fn uses_base_parameters(method: SolutionMethod, axes: Axes, is_closed: bool) -> bool {
    method == SolutionMethod::Riccati && axes == Axes::Body && !is_closed
}

/// About how many operations a rigid body takes in a sweep: to be added to what comes from the
/// children, and for its velocity load. A rod is given to the parent if that makes the sum of both
/// smaller.
///
/// Masses in the middle of balls might be given as well, for one operation in a hundred less; three
/// balls took 6 % more time then, ten 12 %.
pub fn operation_count<S: Scalar>(mass: S, moment: Vec3<S>, inertia: Sym3<S>) -> usize {
    let count = |numbers: &[S]| numbers.iter().filter(|x| !x.vanishes()).count();
    let Sym3(entries) = inertia;
    let [diagonal, beside] = [&entries[..3], &entries[3..]].map(count);
    let difference = |(i, j): (usize, usize)| entries[i] - entries[j];
    let gyroscopic = match beside {
        0 => 2 * count(&[(0, 1), (0, 2), (1, 2)].map(difference)),
        _ => 2 * diagonal + 4 * beside + 9,
    };
    let added = 3 * count(&[mass]) + 2 * count(&moment.0) + diagonal + beside;
    added + 6 * count(&moment.0) + gyroscopic
}

/// How many directions a plane has.
const PLANE: usize = 3;

/// Whether what follows on the elimination of an axis waits for `1 / D`, `U = Iᴬ s` having few
/// entries as in a plane: then products `U Uᵀ` are computed meanwhile, and back outwards `Kᵀ a'` is
/// taken apart into what depends on the parent and what does not. Some operations more, of A10's
/// 155 ns 17 less.
pub fn waits_for_pivot<S: Scalar>(u: &Wrench<S>) -> bool {
    (0..6).filter(|&k| !u.at(k).vanishes()).count() <= PLANE
}

/// The formula by which an articulated inertia is turned. Where it leaves the plane of the turn
/// alone, as in plane chains, there is so little to compute for each body that results are waited
/// for: the formula with the shortest path takes 39 ns from A10's 194. Of chains in space it makes
/// C7 1 % faster and D7 2 % slower.
pub fn plane_formula<S: Scalar>(
    rotation: &Rotation<S>,
    inertia: &SpatialInertia<S>,
) -> PlaneFormula {
    let is_apart = |axis: usize| {
        (0..3).filter(|&row| row != axis).all(|row| {
            inertia.linear.at(row, axis).vanishes()
                && inertia.coupling[row].iter().all(|entry| entry.vanishes())
        })
    };
    match rotation.axis() {
        Some(axis) if is_apart(axis) => PlaneFormula::ShortestPath,
        _ => PlaneFormula::FewestOperations,
    }
}

/// Whether tensors are turned about a hinge's axis first and by the fixed `mount` then: only where
/// that exchanges axes, and so costs nothing: accelerations of the Panda take 1324 operations in
/// place of 1508.
pub fn rotates_in_steps<S: Scalar>(mount: Mat3<S>) -> bool {
    mount.0.iter().all(|row| row.iter().filter(|entry| entry.vanishes()).count() == 2)
}

/// Whether `1 / D` of the last axis of a hinge is computed from `Iᴬ` before the axis before it was
/// eliminated, in place of after it: if the two depend on each other by `coupling`. One operation
/// more, 13 of 147 cycles a ball less: B100 3610 → 3330 ns, B3 46.1 → 46.9.
pub fn inverts_early<S: Scalar>(coupling: S) -> bool {
    !coupling.vanishes()
}
