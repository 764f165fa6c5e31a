//! Elastic: six springs and dampers in the axes of an intermediate frame [P, Sect. A.1].
//!
//! The outboard frame is rotated relative to the inboard frame by `A = A_z(θ_r) A_y(θ₂) A_x(θ₁)`
//! [P, Eqs. (1), (53)]: a rotation `θ_r` of any size about the inboard `ζ` leads to the intermediate
//! frame, and small rotations lead from there to the outboard frame. Coordinates: the displacement
//! `Δ` of the outboard origin in m, in axes of the intermediate frame, then `θ₁, θ₂, θ_r` in rad.
//! Rates: as for a floating hinge.
//!
//! The efforts of [P, Eq. (54)] act along the rates of these six coordinates, on which they do
//! work. The springs therefore have an energy for all rotations and stiffnesses. In the frame of
//! (54) this adds the moment of a rotated anisotropic spring to `m_z`, and replaces `m_x` by
//! `(m_x + m_z sin θ₂)/cos θ₂`. Both reactions act at the outboard origin, so angular momentum is
//! conserved.

use super::law::{HingeLaw, identity_alignment, without_quaternions};
use super::{HingeGeometry, StrainMap, floating, strain};
use crate::equations::SymbolValues;
use crate::math::{FrameOrientation, Mat3, Scalar, Vec3};

/// An elastic hinge.
#[derive(Clone, Copy, Debug)]
pub struct Elastic;

impl<S: Scalar> HingeLaw<S> for Elastic {
    /// A translation and a rotation; all six degrees of freedom.
    fn geometry(&self, _: &SymbolValues<S>, q: &[S]) -> HingeGeometry<S> {
        let about = |k: usize| Mat3::axis_rotation(k, q[3 + k].sin_cos());
        HingeGeometry {
            rotation: FrameOrientation::from_matrix(about(2) * (about(1) * about(0))),
            offset: about(2) * Vec3([q[0], q[1], q[2]]),
            columns: floating::columns(),
            ..HingeGeometry::fixed()
        }
    }

    fn alignment(&self, _: &SymbolValues<S>) -> Mat3<S> {
        identity_alignment()
    }

    /// The strains are the coordinates minus their rest values.
    fn coordinate_rates(&self, q: &[S], v: &[S]) -> Vec<S> {
        strain::times(&self.strains(q).jacobian, v)
    }

    fn normalized(&self, q: &[S]) -> Vec<S> {
        without_quaternions(q)
    }

    /// From rates to the rates of the coordinates, and back.
    ///
    /// `Ω = ξ θ̇₁ + A_xᵀ η θ̇₂ + A_xᵀ A_yᵀ ζ θ̇_r` in outboard axes, and `ḋ = A_z (Δ̇ + θ̇_r ζ ×
    /// Δ)`.
    fn strains(&self, q: &[S]) -> StrainMap<S> {
        let (zero, one) = (S::zero(), S::one());
        let ([s1, s2, s3], [c1, c2, c3]) = sines(q);
        let tangent = s2 * c2.recip();
        let secant = c2.recip();
        // θ̇ = H⁻¹ Ω, with H of [P, Eq. (1)] for outboard axes.
        let angles =
            [[one, s1 * tangent, c1 * tangent], [zero, c1, -s1], [zero, s1 * secant, c1 * secant]];
        let spins = [[one, zero, -s2], [zero, c1, s1 * c2], [zero, -s1, c1 * c2]];
        let turned = [-q[1], q[0], zero];
        let translation = [[c3, -s3, zero], [s3, c3, zero], [zero, zero, one]];
        let (mut to, mut back) = (Vec::new(), Vec::new());
        for row in 0..3 {
            let translation_back = [0, 1, 2].map(|column| translation[column][row]);
            to.push(
                translation_back.into_iter().chain(angles[2].map(|h| -(turned[row] * h))).collect(),
            );
            let yaw = Vec3(translation[row]).dot(Vec3(turned));
            back.push(translation[row].into_iter().chain([zero, zero, yaw]).collect());
        }
        let after_translation = |row: [S; 3]| [zero; 3].into_iter().chain(row).collect::<Vec<S>>();
        to.extend(angles.map(after_translation));
        back.extend(spins.map(after_translation));
        StrainMap::new(to, back)
    }
}

fn sines<S: Scalar>(q: &[S]) -> ([S; 3], [S; 3]) {
    let all = [3, 4, 5].map(|k| q[k].sin_cos());
    (all.map(|(sin, _)| sin), all.map(|(_, cos)| cos))
}
