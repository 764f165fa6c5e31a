//! Results for the loop of a closed chain.

use crate::{Mask, Scalar};

/// The redundant directions of the `C` loop constraints of a closed chain.
///
/// Along a redundant direction the motion is unique, but the reactions are not: a plane loop of four pins in space can
/// be assembled with any stress across its plane. The reported reactions are those of least norm: the smallest sum of
/// squares of the forces in N and the moments in N m at the closing hinge, which is the last hinge of the first
/// route that is not a weld.
#[doc(alias("redundant constraints", "overconstrained", "constraint forces"))]
#[doc(alias("RigidConstraintModel", "AddBallConstraint", "AddWeldConstraint"))]
#[doc(alias("equality/connect", "equality/weld"))]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoopClosure<T, const C: usize> {
    undetermined: [[T; 6]; C],
    redundant: [T; C],
}

impl<T: Scalar, const C: usize> LoopClosure<T, C> {
    /// Makes the result; for generated code.
    ///
    /// `redundant` is positive for redundant directions and zero for the others. The rows of `undetermined` are zero
    /// for the others, too.
    #[inline]
    pub fn new(undetermined: [[T; 6]; C], redundant: [T; C]) -> Self {
        Self { undetermined, redundant }
    }

    /// Returns the number of redundant directions, counting those that are redundant in at least one lane.
    pub fn redundant(&self) -> usize {
        let zero = T::default();
        self.redundant.iter().filter(|flag| !(!flag.simd_gt(zero)).all()).count()
    }

    /// Returns a unit wrench for each redundant direction, which can be added to the reactions without changing any
    /// motion, and zero for the other directions.
    ///
    /// A wrench is a force and then a moment. It acts at the outboard origin of the closing hinge, in components of the
    /// hinge's inboard frame.
    #[inline]
    pub fn undetermined(&self) -> &[[T; 6]; C] {
        &self.undetermined
    }
}

/// No redundant direction.
impl<T: Scalar, const C: usize> Default for LoopClosure<T, C> {
    fn default() -> Self {
        Self::new([[T::default(); 6]; C], [T::default(); C])
    }
}
