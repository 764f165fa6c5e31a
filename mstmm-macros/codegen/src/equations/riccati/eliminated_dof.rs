//! What the elimination of a free direction leaves for the way back.

use super::super::hinge::{BasisVector, dot};
use crate::math::{Scalar, Wrench};

/// A free direction that has been eliminated.
pub struct EliminatedDof<S> {
    /// `s`
    pub column: BasisVector<S>,
    /// `D`
    pub pivot: S,
    /// `1 / D`
    pub inverse: S,
    /// `K`
    pub gain: Wrench<S>,
    /// `ε / D`
    pub rest: S,
    /// `t`
    pub along: Vec<S>,
    /// `t / D`
    pub by_pivot: Vec<S>,
    /// What the squares of `t` would be if nothing in them cancelled.
    pub sizes: Vec<S>,
    /// The axis that it is, if what follows waits for `1 / D`.
    pub waiting: Option<usize>,
}

impl<S: Scalar> EliminatedDof<S> {
    /// `K` without its entry along the axis, which is one.
    pub fn gain_beside(&self, axis: usize) -> Wrench<S> {
        Wrench::from_fn(|k| if k == axis { S::zero() } else { self.gain.at(k) })
    }

    /// Takes the reactions of a closing hinge into `ε`.
    pub fn add_reactions(&mut self, reactions: &[S]) {
        self.rest = self.rest - dot(&self.by_pivot, reactions);
    }
}
