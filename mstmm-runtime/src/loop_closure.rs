//! What a solution says of a chain that is held at both ends.

use crate::{Mask, Scalar};

/// What a solution says of the closure of a chain that is held at both ends: which of its `C`
/// closing directions the others imply already.
///
/// Along such a redundant direction the motion is unique, the reactions are not: a plane loop of
/// four pins in space may be assembled with any stress across its plane. Those reported are the
/// smallest ones, in the sense of least squares of forces in N and moments in N m at the closing
/// hinge, which is the last one of the chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoopClosure<T, const C: usize> {
    undetermined: [[T; 6]; C],
    redundant: [T; C],
}

impl<T: Scalar, const C: usize> LoopClosure<T, C> {
    /// Puts the result together; generated code does.
    ///
    /// `redundant` is positive for the directions that are redundant, and zero for the others, as
    /// are their rows of `undetermined`.
    #[inline]
    pub fn new(undetermined: [[T; 6]; C], redundant: [T; C]) -> Self {
        Self { undetermined, redundant }
    }

    /// How many closing directions are redundant; of several lanes, in at least one of them.
    pub fn redundant(&self) -> usize {
        let zero = T::default();
        self.redundant.iter().filter(|flag| !(!flag.simd_gt(zero)).all()).count()
    }

    /// For each redundant closing direction a unit wrench, force and then moment, that can be added
    /// to the reactions without changing any motion; zero for the other directions.
    ///
    /// It acts at the closing hinge's outboard origin and has its components along the axes of the
    /// hinge's inboard frame, not along inertial ones.
    #[inline]
    pub fn undetermined(&self) -> &[[T; 6]; C] {
        &self.undetermined
    }
}

/// Nothing redundant.
impl<T: Scalar, const C: usize> Default for LoopClosure<T, C> {
    fn default() -> Self {
        Self::new([[T::default(); 6]; C], [T::default(); C])
    }
}
