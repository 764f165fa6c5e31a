//! Decisions that depend on costs: which of several exact formulas the sweeps use.
//!
//! The sweeps ask the functions here, so that the formulas contain no cost considerations.
//! Decisions depend on which values are zero in every state, on the structure of the chain and on
//! the method, never on values. Times are for the chains of the benchmarks (`benches/README.md`):
//! D7 is the Panda, C7 has seven pins about alternating axes, A10 has ten pins in a plane, B3 to
//! B100 have that many balls.
//!
//! Branches of one shape, such as the legs of a robot, do not share a loop with constants for each of
//! them: each has separate straight-line code. Four legs of HyQ in a row on its trunk cost 377 ns
//! written out, 456 ns as a loop with equal constants and 497 ns with constants from memory, in a third of
//! the code. Code that exceeds the first-level instruction cache of 32 KB costs less than that: on the same
//! processor (Zen 5) one arm of G1 costs 0.11 ns an operation (20 KB), half of G1 0.14 (42 KB) and all of
//! G1 0.15 (82 KB). Loops over its two legs and two arms would leave 45 KB. Scalar types with SIMD lanes
//! compute such branches side by side instead (`passes/limbs`).

use crate::math::{
    Mat3, Motion, PlaneFormula, Rotation, Scalar, SpatialInertia, Sym3, Vec3, Wrench,
};
use crate::model::{Layout, SolutionMethod};

/// The work axes, in which the equations of the links are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    /// Axes fixed in each part and aligned with the inboard hinge of its link: inertias stay
    /// constant, and the propagated quantities are rotated at every hinge.
    Body,
    /// Inertial axes: nothing is rotated at a hinge, but the inertias are rotated.
    Inertial,
}

/// The work axes of generated code. In inertial axes `riccati` needed 45 % more operations in the
/// best case measured (thirty balls) and six times as many in the worst case (one ball).
pub const AXES: Axes = Axes::Body;

/// The largest number of bodies that a wrench in a hinge is summed over.
///
/// For more bodies, and at the boundaries of repeated parts, the wrench is `Iᴬ a' + pᴬ`. This needs
/// about as many operations, but 20 values must be stored until the accelerations are known. The
/// rounding error of the sum grows with the square of the number of bodies. Times with sums instead
/// of `Iᴬ a' + pᴬ`, together with base parameters in the energies: D7 500 → 458 ns, C7 409 → 377,
/// B3 183 → 152.
pub const MAX_SUMMED_BODIES: usize = 8;

/// Whether the Riccati transfer stores `Iᴬ` and `pᴬ` for the wrenches in hinges. In a closed chain
/// they would contain the constraint forces, which needs as many products as the sum over all
/// bodies.
pub fn keeps_affine_wrenches(is_closed: bool) -> bool {
    !is_closed
}

/// The largest number of rates for which matrices are written out entry by entry.
///
/// The code grows with the square of the number, that of products of matrices with the cube. Matrices of
/// more rates are computed column by column, in loops over products with unit vectors.
pub const MAX_DENSE_RATES: usize = 40;

/// The largest number of rates between the ground and a free end for which the mass matrix is factorised.
const MAX_FACTORIZED_PATH: usize = 12;

/// Whether the inverse of the mass matrix follows from factors of the mass matrix, not from the factors of
/// the Riccati transfer; and whether accelerations, if this inverse is there, are its product with the
/// efforts.
///
/// Factors of the matrix cost the cube of the number of rates on a path from the ground to a free end, since pairs on
/// different branches stay zero. The Riccati transfer costs more for each link. The inverse of D7 takes 705 instead of 1257
/// operations, that of B3 about 900 instead of 552. That of HyQ, with nine rates on each path, takes 3840 operations: 670 → 350
/// ns on Zen 4. For many rates the factors of the matrix lose digits, by the ratio of its largest entries to the pivots.
pub fn factorizes_mass_matrix(layout: &Layout) -> bool {
    layout.longest_path() <= MAX_FACTORIZED_PATH && 2 * layout.dof_count() <= 3 * layout.links.len()
}

/// Whether the matrices of a chain are written out entry by entry.
pub fn writes_matrices_out(has_repeats: bool, rates: usize) -> bool {
    !has_repeats && rates <= MAX_DENSE_RATES
}

/// Whether a product with a matrix leaves out the entries that vanish in every state, for their number and that of all entries.
///
/// Loops of known length over full columns are faster as long as there are few of these entries. On Zen 4, A and B of HyQ without
/// half of the entries take 1620 instead of 1725 ns, and those of three balls would take 519 instead of 366.
pub fn leaves_out_zeros(vanishing: usize, entries: usize) -> bool {
    4 * vanishing > entries
}

/// The smallest number of pairs of a body and a rate that moves it for which a regressor is computed with several rates at a
/// time.
const FEWEST_MOVING_PAIRS: usize = 64;

/// Whether a regressor in space with this number of rates, and of pairs of a body and a rate that moves it, is computed with
/// several rates at a time. One or two rates would leave most lanes empty. The motions of bodies and rates are stored first,
/// and the loops over both cost more for few pairs. On Zen 4, in this form and written out: D7 with 28 pairs 235 and 177 ns,
/// HyQ with 102 pairs 723 and 883.
pub fn takes_rates_together(rates: usize, moving_pairs: usize) -> bool {
    rates > 2 && moving_pairs >= FEWEST_MOVING_PAIRS
}

/// Whether forward dynamics uses base parameters.
///
/// Base parameters save 2 to 5 % of the time. In inertial axes they save nothing, since the
/// inertias rotate with the parts. The transfer method and loop constraints use the original
/// inertias.
pub fn uses_base_parameters(method: SolutionMethod, axes: Axes, is_closed: bool) -> bool {
    method == SolutionMethod::Riccati && axes == Axes::Body && !is_closed
}

/// Returns the approximate number of operations that a rigid body costs in a sweep: the sum with
/// the contributions of its children, and its velocity wrench. A rod is transferred to the parent
/// if the number for both bodies becomes smaller.
///
/// Masses at the centres of balls could be transferred as well, which saves one operation in a
/// hundred. But three balls then took 6 % more time, and ten balls 12 %.
pub fn operation_count<S: Scalar>(mass: S, moment: Vec3<S>, inertia: Sym3<S>) -> usize {
    let count = |values: &[S]| values.iter().filter(|x| !x.vanishes()).count();
    let Sym3(entries) = inertia;
    let [diagonal, off_diagonal] = [&entries[..3], &entries[3..]].map(count);
    let difference = |(i, j): (usize, usize)| entries[i] - entries[j];
    let gyroscopic = match off_diagonal {
        0 => 2 * count(&[(0, 1), (0, 2), (1, 2)].map(difference)),
        _ => 2 * diagonal + 4 * off_diagonal + 9,
    };
    let added = 3 * count(&[mass]) + 2 * count(&moment.0) + diagonal + off_diagonal;
    added + 6 * count(&moment.0) + gyroscopic
}

/// The largest number of hinges between the ends of a spring for which it is evaluated relative to the last
/// common link of its ends.
///
/// In the accelerations, a spring across one pin costs 77 operations and 23 more for each further pin; in
/// inertial axes 185 and 40, most of them for poses. Solutions with poses need these anyway: a spring across
/// six pins then costs 243 operations relative to the common link and 245 in inertial axes.
pub const MAX_SPRING_PATH: usize = 6;

/// Whether a free base is moved to the hinge of this child, which rotates about a point of the base.
/// The child's articulated inertia then needs no translation. If the child is the last of its branch
/// and its hinge does not move its centre of mass, that inertia is constant, and it costs more that
/// the inertia of the base has fewer zeros about the new point.
pub fn saves_translation<S: Scalar>(
    subspace: &[Motion<S>],
    first_moment: Vec3<S>,
    is_last: bool,
) -> bool {
    let moves_mass = |motion: &Motion<S>| {
        motion.angular.cross(first_moment).0.iter().any(|entry| !entry.vanishes())
    };
    !is_last || subspace.iter().any(moves_mass)
}

/// The number of degrees of freedom in a plane.
const PLANE: usize = 3;

/// Whether the computations after the elimination of an axis would wait for `1 / D`. This is so if
/// `U = Iᴬ s` has few entries, as in a plane. Then the products `U Uᵀ` are computed in the
/// meantime, and in the outward sweep `Kᵀ a'` is split into a part that depends on the parent and a
/// part that does not. This costs some operations more, and saves 17 ns of A10's 155.
pub fn waits_for_pivot<S: Scalar>(u: &Wrench<S>) -> bool {
    (0..6).filter(|&k| !u.at(k).vanishes()).count() <= PLANE
}

/// Returns the formula by which an articulated inertia is rotated. In plane chains the plane of the
/// rotation is not coupled to the rest, and each body has so few operations that they wait for each
/// other: the formula with the shortest path saves 39 ns of A10's 194. For chains in space, it
/// makes C7 1 % faster and D7 2 % slower.
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

/// Whether tensors are rotated in two steps: about a hinge's axis, then by the fixed `mount`. This
/// is so only if `mount` permutes the axes, which costs nothing. Accelerations of the Panda need
/// 1324 operations instead of 1508.
pub fn rotates_in_steps<S: Scalar>(mount: Mat3<S>) -> bool {
    mount.0.iter().all(|row| row.iter().filter(|entry| entry.vanishes()).count() == 2)
}

/// Whether `1 / D` of the last axis of a hinge is computed from `Iᴬ` before the elimination of the
/// axis before it, which is so if both are coupled. This costs one operation more and saves 13 of
/// 147 cycles per ball: B100 3610 → 3330 ns, B3 46.1 → 46.9.
pub fn inverts_early<S: Scalar>(coupling: S) -> bool {
    !coupling.vanishes()
}
