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
//! | `S`, `v` | [`hinge::HingeGeometry`], [`hinge::SubspaceBasis`] | free directions of a hinge and its rates |
//! | `s`, `J` | [`hinge::StrainMap`] | how far a hinge is from rest, `ṡ = J v` |
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

mod constraint_forces;
mod energy;
mod forward_dynamics;
pub mod hinge;
mod inverse_dynamics;
mod kinematics;
mod loads;
mod loop_hinge;
mod projection;
mod reflection;
mod symbol_values;

mod base_parameters;
mod connection_points;
mod eval_context;
mod hinge_wrenches;
mod motion_problem;
mod report;
mod riccati;
mod strategy;
mod sweep;
mod trace;
mod transfer;

pub use energy::{Energy, energy};
pub use eval_context::EvalContext;
pub use forward_dynamics::{
    ForwardDynamics, LoopReaction, OutboardState, SweepResult, forward_dynamics,
    forward_dynamics_with_wrenches,
};
pub use inverse_dynamics::bias_efforts;
pub use kinematics::{LinkKinematics, kinematics};
pub use motion_problem::HingePivot;
pub use projection::{Projection, displace, project};
pub use report::{FramedVector, PointState, Report, report};
pub use strategy::{AXES, Axes};
pub use sweep::{LinkTree, LoopHook};
pub use symbol_values::SymbolValues;
pub use trace::{Trace, TraceSection};
