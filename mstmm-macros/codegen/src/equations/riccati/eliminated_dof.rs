//! The quantities of an eliminated degree of freedom that the outward sweep needs.

use super::super::hinge::{BasisVector, dot};
use crate::math::{Scalar, Wrench};

/// An eliminated degree of freedom; the letters are those of [`super`].
pub struct EliminatedDof<S> {
    /// Its index in the basis of the motion subspace.
    pub column: usize,
    /// Its direction `s`.
    pub direction: BasisVector<S>,
    /// The pivot `D`.
    pub pivot: S,
    /// `1 / D`
    pub inverse: S,
    /// The gain `K`.
    pub gain: Wrench<S>,
    /// `u / D`
    pub u_over_d: S,
    /// `t`
    pub t: Vec<S>,
    /// `t / D`
    pub t_over_d: Vec<S>,
    /// The scale of `t²`: its value if nothing cancelled in `t`.
    pub t_scales: Vec<S>,
    /// The axis of the direction, if later computations wait for `1 / D`.
    pub waiting_axis: Option<usize>,
}

impl<S: Scalar> EliminatedDof<S> {
    /// Returns `K` without its entry along the axis, which is one.
    pub fn gain_without(&self, axis: usize) -> Wrench<S> {
        Wrench::from_fn(|k| if k == axis { S::zero() } else { self.gain.at(k) })
    }

    /// Adds the constraint forces of a loop hinge to `u`.
    pub fn add_reactions(&mut self, reactions: &[S]) {
        self.u_over_d = self.u_over_d - dot(&self.t_over_d, reactions);
    }
}
