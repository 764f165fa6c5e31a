//! The paper's equations and what a general chain needs besides, generic over the scalar: the
//! compiler runs them on formulas, the tests on plain numbers.
//!
//! # Notation
//!
//! | symbol | in code | meaning |
//! |---|---|---|
//! | `a = [r̈; Ω̇]` | [`Motion`](crate::math::Motion) | accelerations at a connection point |
//! | `F = [q; n]`, `n = −m` | [`Wrench`](crate::math::Wrench) | what a hinge exerts on its child's side |
//! | `Iᴬ`, `pᴬ` | [`SpatialInertia`](crate::math::SpatialInertia), `Wrench` | Riccati pair, `F = Iᴬ a + pᴬ` |
//! | `S`, `v` | [`hinge::Geometry`], [`hinge::Freedom`] | free directions of a hinge and its rates |
//! | `s`, `J` | [`hinge::Strains`] | how far a hinge is from rest, `ṡ = J v` |
//! | `T`, `W`, `λ` | `closing` | directions that a closing hinge holds, wrenches that do work on one rate each, reactions |
//! | `c` | the *point* of a link | where a body hangs on its hinge: its input, or its output if the chain is held at its end |
//!
//! Each file names its further letters and frames at its head. Sweeps over the links are those of
//! `sweep`; what the generator knows of costs stands in `strategy`.
//!
//! Sign rule: on a body the force at the input end is `+q_I`, at the output end `−q_O`; the torque
//! at the input end is `−m_I`, at the output end `+m_O`.
//!
//! # References
//!
//! `[P]` X. Rui, D. Bestle, J. Zhang, Q. Zhou: A new version of transfer matrix method for
//! multibody systems. Multibody System Dynamics 38 (2016).

mod accelerations;
mod closing;
mod closure;
mod correction;
mod elimination;
mod energy;
pub mod hinge;
mod inverse;
mod kinematics;
mod load;
mod numbers;

mod problem;
mod redistribution;
mod report;
mod riccati;
mod situation;
mod spots;
mod strategy;
mod sweep;
mod trace;
mod transfer;
mod transmitted;

pub use accelerations::{Behind, Reaction, Solved, Swept, accelerations, sweep};
pub use correction::{Correction, correction, moved};
pub use energy::{Energy, energy};
pub use inverse::bias_efforts;
pub use kinematics::{LinkMotion, motion};
pub use numbers::Numbers;
pub use problem::Pivot;
pub use report::{Point, Report, Seen, report};
pub use situation::Situation;
pub use strategy::{AXES, Axes};
pub use sweep::{LinkTree, Weave};
pub use trace::{Section, Trace};
