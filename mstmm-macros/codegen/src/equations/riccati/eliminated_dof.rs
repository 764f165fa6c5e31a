//! What the elimination of a free direction leaves for the way back.

use super::super::hinge::{BasisVector, dot};
use crate::math::{Scalar, Wrench};

/// A free direction that has been eliminated.
pub struct EliminatedDof<S> {
    /// `s`
    pub direction: BasisVector<S>,
    /// `D`
    pub pivot: S,
    /// `1 / D`
    pub inverse: S,
    /// `K`
    pub gain: Wrench<S>,
    /// `ε / D`
    pub u_over_d: S,
    /// `t`
    pub t: Vec<S>,
    /// `t / D`
    pub t_over_d: Vec<S>,
    /// What the squares of `t` would be if nothing in them cancelled.
    pub t_scales: Vec<S>,
    /// The axis that it is, if what follows waits for `1 / D`.
    pub waiting_axis: Option<usize>,
}

impl<S: Scalar> EliminatedDof<S> {
    /// `K` without its entry along the axis, which is one.
    pub fn gain_without(&self, axis: usize) -> Wrench<S> {
        Wrench::from_fn(|k| if k == axis { S::zero() } else { self.gain.at(k) })
    }

    /// Takes the reactions of a closing hinge into `ε`.
    pub fn add_reactions(&mut self, reactions: &[S]) {
        self.u_over_d = self.u_over_d - dot(&self.t_over_d, reactions);
    }
}
