//! The equations of motion: those of the paper, and those that a general chain needs in addition.
//!
//! All equations are generic over the scalar: the compiler runs them on formulas, the tests on
//! plain numbers.
//!
//! # Notation
//!
//! | symbol | in code | meaning |
//! |---|---|---|
//! | `a = [r̈; Ω̇]` | [`Motion`](crate::math::Motion) | spatial acceleration of a connection point |
//! | `F = [q; n]`, `n = −m` | [`Wrench`](crate::math::Wrench) | wrench that a hinge exerts on its child; `q` and `m` are the paper's force and moment |
//! | `Iᴬ`, `pᴬ` | [`SpatialInertia`](crate::math::SpatialInertia), `Wrench` | articulated inertia and bias force, `F = Iᴬ a + pᴬ`; the Riccati pair of the transfer matrix method |
//! | `S`, `v` | [`hinge::HingeGeometry`], [`hinge::SubspaceBasis`] | motion subspace of a hinge, and its rates |
//! | `s`, `J` | [`hinge::StrainMap`] | strains of a hinge (distance from rest), `ṡ = J v` |
//! | `T`, `W`, `λ` | `loop_hinge` | constraint-force subspace and active-force subspace of the loop hinge, constraint forces |
//! | `c` | the *point* of a link | where a body is attached to its hinge: its input, or its output if the chain is held at its end only |
//!
//! Frames: the equations of a link are written in its *work axes*, which are fixed in its part and
//! aligned with its hinge ([`Axes`]). Each file names its further symbols and frames at its head.
//!
//! The sweeps over the links are in `sweep`. The decisions that depend on costs are in `strategy`.
//!
//! Signs: on a body, the force at the input end is `+q_I` and the force at the output end is
//! `−q_O`; the torque at the input end is `−m_I` and the torque at the output end is `+m_O`.
//!
//! # References
//!
//! - `[P]` X. Rui, D. Bestle, J. Zhang, Q. Zhou: A new version of transfer matrix method for multibody systems. Multibody System Dynamics 38 (2016).
//! - R. Featherstone: Rigid Body Dynamics Algorithms. Springer 2008. Its notation is used unless the paper has its own.

mod acceleration_field;
mod composite;
mod constraint_forces;
mod coriolis;
mod dense_matrix;
mod derivatives;
mod energy;
mod forward_dynamics;
mod free_base;
pub mod hinge;
mod inverse_dynamics;
mod inverse_mass_matrix;
mod jacobian;
mod kinematics;
mod linearization;
mod loads;
mod loop_hinge;
mod projection;
mod reflection;
mod symbol_values;

mod base_parameters;
mod eval_context;
mod flatten;
mod hinge_wrenches;
mod momentum;
mod motion_problem;
mod open_chain;
mod point_reader;
mod pull;
mod push;
mod regressor;
mod regressor_motions;
mod report;
mod riccati;
mod springs;
mod strategy;
mod sweep;
mod tangent;
mod trace;
mod transfer;

pub use composite::mass_matrix;
pub use coriolis::{coriolis_matrix, coriolis_matrix_times};
pub use dense_matrix::DenseMatrix;
pub use derivatives::InverseDynamicsTangent;
pub use energy::{Energy, energy};
pub use eval_context::EvalContext;
pub use forward_dynamics::{
    ForwardDynamics, LoopReaction, OutboardState, SweepResult, forward_dynamics,
    forward_dynamics_with_wrenches,
};
pub use inverse_dynamics::{
    gravity_efforts, inverse_dynamics, inverse_dynamics_with_wrenches, mass_matrix_times,
    passive_efforts,
};
pub use inverse_mass_matrix::inverse_mass_matrix;
pub use jacobian::{BodyMotion, ChainKinematics, chain_kinematics, point_jacobian};
pub use kinematics::{LinkKinematics, kinematics};
pub use linearization::{Linearization, linearization};
pub use momentum::{ChainMomentum, momentum, momentum_matrix};
pub use motion_problem::HingePivot;
pub use open_chain::OpenChain;
pub use point_reader::{FramedVector, PointState};
pub use projection::{Projection, closure_jacobian_times, displace, project, size};
pub use pull::virtual_power;
pub use push::{PushedDynamics, missing_efforts, push};
pub use regressor::{dynamic_parameters, regressor, regressor_times};
pub use regressor_motions::{GivenMotion, RegressorMotions, regressor_motions};
pub use report::{Report, report};
pub use springs::{SpringReport, spring_report};
pub use strategy::{AXES, Axes, leaves_out_zeros, takes_rates_together, writes_matrices_out};
pub use sweep::{Channel, LinkTree, LoopHook};
pub use symbol_values::SymbolValues;
pub use tangent::{Direction, Tangent};
pub use trace::{Trace, TraceSection};
