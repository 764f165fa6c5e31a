//! The runtime of the code that `mstmm_chain!` generates: scalar types, connection points, views of hinges, integrators
//! and errors. Module [`paper`] has the matrices of the paper on which the method is based.
//!
//! The crate is `no_std`, without `alloc` and `unsafe`, and nothing panics. The default feature `std` only takes the
//! square root from `std` instead of `libm`; both are correctly rounded. Without the feature `fma` no operations are
//! fused, so results have the same bits on every target.
//!
//! # Notation
//!
//! Units are SI, frames are right-handed, and vectors are in the inertial frame unless stated otherwise. `[P, …]` is
//! Rui, Bestle, Zhang and Zhou, *A new version of transfer matrix method for multibody systems*, Multibody System
//! Dynamics, 2016.
//!
//! | here | in the paper | meaning |
//! |---|---|---|
//! | `q`, `v` | – | coordinates and rates of all hinges; v is q̇ except for quaternions and elastic hinges |
//! | `orientation` | A | rotation that takes components in the outboard frame to the inboard frame, or from the frame of a point to the inertial frame |
//! | quaternion | – | of such a rotation; w, x, y, z in the array of a state, nalgebra's type in the interface |
//! | Bryan angles θ₁, θ₂, θ₃ | θ, Eq. (1) | A = A_z(θ₃) A_y(θ₂) A_x(θ₁): roll, pitch and yaw |
//! | `rate` | – | θ̇ of one angle θ; for ball, floating and elastic hinges the angular velocity in the outboard frame |
//! | `position`, `velocity` | r, ṙ | of a point; for hinges of the outboard origin, in the inboard frame |
//! | `displacement` | Δ, Appendix A.1 | of an elastic hinge, in axes that rotate with θ₃ |
//! | `acceleration` | r̈ | second time derivative of the position; zero for a body at rest under gravity |
//! | `angular_velocity`, `angular_acceleration` | Ω, Ω̇ | of the frame at a point |
//! | `force` | q | internal force: acts on a body at its input; its negative acts at the output |
//! | `moment` | m | internal moment: acts on a body at its output; its negative acts at the input |
//! | `z` | z, Eq. (3) | \[r̈, Ω̇, moment, force, 1\] at a connection point: [`StateVector`]; in a plane [`PlaneStateVector`], on a line [`LineStateVector`] |
//! | input, output | I, O | the inboard and the outboard end of an element |
//! | `effort` | – | torque or force of the motor of a hinge along its degrees of freedom |
//!
//! # Integration
//!
//! ```
//! use mstmm_runtime::{Chain, ChainState, Error, Rk4, Scalar};
//!
//! /// A pendulum of unit length, written by hand; `mstmm_chain!` generates such types.
//! struct Pendulum;
//!
//! #[derive(Clone, Default)]
//! struct Swing { q: [f64; 1], v: [f64; 1], t: f64 }
//!
//! impl ChainState for Swing {
//!     type Scalar = f64;
//!     fn coordinates(&self) -> &[f64] { &self.q }
//!     fn coordinates_mut(&mut self) -> &mut [f64] { &mut self.q }
//!     fn rates(&self) -> &[f64] { &self.v }
//!     fn rates_mut(&mut self) -> &mut [f64] { &mut self.v }
//!     fn time(&self) -> f64 { self.t }
//!     fn set_time(&mut self, time: f64) { self.t = time }
//! }
//!
//! impl Chain for Pendulum {
//!     type Scalar = f64;
//!     type State = Swing;
//!     type Inputs = f64; // a torque
//!
//!     fn derivative_into(&self, state: &Swing, torque: &f64, rate: &mut Swing) -> Result<(), Error> {
//!         let ([sine], _) = Scalar::sin_cos(state.q);
//!         (rate.q, rate.v) = (state.v, [torque - 9.8 * sine]);
//!         Ok(())
//!     }
//!
//!     fn configuration_rate_into(&self, state: &Swing, rate: &mut Swing) {
//!         rate.q = state.v;
//!     }
//!
//!     fn normalize(&self, _: &mut Swing) {} // no quaternions here
//! }
//!
//! let mut state = Swing { q: [0.01], ..Swing::default() };
//! let mut rk4 = Rk4::new(1e-3);
//! for _ in 0..1000 {
//!     rk4.step(&Pendulum, &mut state, |_time, _state| 0.0)?;
//! }
//! assert_eq!(state.t, 1.0);
//! assert!((state.q[0] - 0.01 * 9.8f64.sqrt().cos()).abs() < 1e-6); // small swings are harmonic
//! # Ok::<(), Error>(())
//! ```
#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]
// The documentation site shows which items need a feature.
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(feature = "std")]
extern crate std;

mod body;
mod chain;
pub mod description;
mod dual;
mod energy;
mod error;
mod formats;
#[doc(hidden)]
pub mod generated;
pub mod hinge;
pub mod integrate;
mod kinematics;
#[cfg(feature = "wide")]
pub mod lanes;
pub mod linear;
mod linearization;
mod loop_closure;
mod momentum;
mod origin;
pub mod paper;
mod point;
mod primitive;
mod quaternion;
mod scalar;
mod spring;
mod trig;

pub use body::{BodyResult, HasCom, HasOutput, OptionalPoints};
pub use chain::{Chain, ChainState, GeneratedChain};
pub use description::{Answers, Described, Description};
pub use dual::Dual;
pub use energy::Energy;
pub use error::Error;
pub use hinge::{
    BallState, BallStateMut, CylindricalState, CylindricalStateMut, ElasticState, ElasticStateMut,
    FloatingState, FloatingStateMut, GimbalState, GimbalStateMut, HingeMotion, HingeResult,
    PinState, PinStateMut, PlanarState, PlanarStateMut, PlaneElasticState, PlaneElasticStateMut,
    ScrewState, ScrewStateMut, SliderState, SliderStateMut, UniversalState, UniversalStateMut,
};
pub use integrate::{Dopri5, LinearlyImplicitEuler, Newmark, Rk4, SemiImplicitEuler, Statistics};
pub use kinematics::{
    BodyKinematics, BodyMotion, FrameMotion, HasJacobian, LineMotion, NoColumns, PlaneMotion,
    PointKinematics, RateColumns, SpaceMotion,
};
pub use linearization::{InverseDynamicsDerivatives, Linearization};
pub use loop_closure::LoopClosure;
pub use momentum::{LineMomentum, Momentum, PlaneMomentum};
pub use nalgebra;
pub use point::{
    AllResults, BodyPoint, ConnectionPoint, HasPoses, HasVelocities, HasZ, LinePoint,
    LineStateVector, PlanePoint, PlaneStateVector, Point, Results, StateVector,
};
pub use scalar::{Columns, Mask, Scalar};
pub use spring::SpringResult;
#[cfg(feature = "wide")]
pub use wide;
