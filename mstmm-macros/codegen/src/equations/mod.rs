//! The paper's equations and what a general chain needs besides, generic over the scalar: the
//! compiler runs them on formulas, the tests on plain numbers.
//!
//! # Notation
//!
//! | symbol | in code | meaning |
//! |---|---|---|
//! | `a = [r̈; Ω̇]` | [`Motion`] | accelerations at a connection point |
//! | `F = [q; n]`, `n = −m` | [`Wrench`](crate::math::Wrench) | what a hinge exerts on its child's side |
//! | `A`, `e` | [`SpatialInertia`](crate::math::SpatialInertia), `Wrench` | Riccati pair, `F = A a + e` |
//! | `S`, `v` | [`hinge::Freedom`] | free directions of a hinge and its rates |
//! | `c` | the *point* of a link | where a body hangs on its hinge: its input, or its output if the chain is held at its end |
//!
//! Sign rule: on a body the force at the input end is `+q_I`, at the output end `−q_O`; the torque
//! at the input end is `−m_I`, at the output end `+m_O`.
//!
//! # References
//!
//! `[P]` X. Rui, D. Bestle, J. Zhang, Q. Zhou: A new version of transfer matrix method for multibody
//! systems. Multibody System Dynamics 38 (2016).

mod accelerations;
mod elimination;
mod energy;
pub mod hinge;
mod motion;
mod numbers;
mod report;
mod riccati;
mod trace;
mod transfer;

pub use accelerations::{Pivot, Solved, accelerations};
pub use energy::{Energy, energy};
pub use motion::{Axes, LinkMotion, motion};
pub use numbers::Numbers;
pub use report::{Point, Report, report};
pub use trace::{Section, Trace};

use crate::math::{Motion, Scalar, Vec3};
use crate::model::{Chain, Layout};

/// A chain in a given state: what every set of equations starts from.
#[derive(Clone, Debug)]
pub struct Situation<'a, S> {
    /// The chain.
    pub chain: &'a Chain,
    /// Its layout.
    pub layout: &'a Layout,
    /// What stands for its symbols.
    pub numbers: &'a Numbers<S>,
    /// Coordinates.
    pub q: &'a [S],
    /// Rates.
    pub v: &'a [S],
    /// Inputs.
    pub inputs: &'a [S],
}

impl<S: Scalar> Situation<'_, S> {
    /// Gravity as an acceleration of the ground: cheaper than a force on every body.
    fn ground(&self) -> Motion<S> {
        let gravity = self.numbers.vector(&self.chain.gravity);
        Motion { linear: -gravity, angular: Vec3::zero() }
    }
}
