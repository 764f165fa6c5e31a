//! Linear algebra for controllers: products, small linear systems, the discrete model of a step, and the
//! linear-quadratic regulator. All of it is in fixed arrays, without heap, for every scalar type.
//!
//! | function | computes |
//! |---|---|
//! | [`negative_product`], [`negative_product_of_rows`] | −A D, for the derivatives −M⁻¹ D of accelerations |
//! | [`solve`], [`solve_positive_definite`] | A⁻¹ B |
//! | [`null_space`] | a basis B of the vectors with G b = 0, such as the rates that keep a chain closed |
//! | [`discretize`] | the discrete model x⁺ = A x + B u of a step with held inputs |
//! | [`lqr`] | the gain of the linear-quadratic regulator of a discrete model |
//!
//! The number of operations depends on the sizes only, except for [`lqr`]: it ends when it has converged, and its number
//! of operations has a bound. N is the number of rates of a chain, U is the number of its inputs, X = 2 N is the number of its states.
//! Matrices are those of nalgebra. Errors are reported instead of results that are not finite.
//!
//! The state x of a linear model is the displacement from the reference along the rates, followed by the change of the
//! rates. In a chain with quaternions, [`Described::displacement_to_slice`](crate::Described::displacement_to_slice)
//! computes the displacement.
//!
//! A controller in both precisions is generic over `T: Scalar`. If it also multiplies matrices of nalgebra, its bound is
//! `T: Scalar<Real = T, Mask = bool> + nalgebra::RealField`, which `f32` and `f64` have. Functions that both traits name, such as
//! `abs`, are then written `Scalar::abs(x)`.
//!
//! # Example
//!
//! A cart with a pole is balanced by a controller that samples at 50 Hz. [`Linearize`] is implemented here by hand.
//!
//! ```
//! use mstmm_runtime::linear::{ContinuousModel, Linearize, discretize, lqr};
//! use mstmm_runtime::nalgebra::{Matrix1, Matrix2, Matrix4, Vector2, Vector4};
//! use mstmm_runtime::{Chain, ChainState, Error, Rk4, Scalar};
//!
//! /// A cart of 1 kg with a mass of 0.1 kg on a massless pole of 0.5 m, which stands upright at θ = 0.
//! struct CartPole;
//!
//! /// Position of the cart and angle of the pole, and their rates.
//! #[derive(Clone, Default)]
//! struct State { q: [f64; 2], v: [f64; 2], t: f64 }
//!
//! impl ChainState for State {
//!     type Scalar = f64;
//!     fn coordinates(&self) -> &[f64] { &self.q }
//!     fn coordinates_mut(&mut self) -> &mut [f64] { &mut self.q }
//!     fn rates(&self) -> &[f64] { &self.v }
//!     fn rates_mut(&mut self) -> &mut [f64] { &mut self.v }
//!     fn time(&self) -> f64 { self.t }
//!     fn set_time(&mut self, time: f64) { self.t = time }
//! }
//!
//! impl Chain for CartPole {
//!     type Scalar = f64;
//!     type State = State;
//!     type Inputs = f64; // the force on the cart
//!
//!     fn derivative_into(&self, state: &State, force: &f64, rate: &mut State) -> Result<(), Error> {
//!         let (sine, cosine) = state.q[1].sin_cos();
//!         let cart = (force + 0.1 * sine * (0.5 * state.v[1].powi(2) - 9.81 * cosine))
//!             / (1.0 + 0.1 * sine * sine);
//!         (rate.q, rate.v) = (state.v, [cart, (9.81 * sine - cart * cosine) / 0.5]);
//!         Ok(())
//!     }
//!
//!     fn configuration_rate_into(&self, state: &State, rate: &mut State) {
//!         rate.q = state.v;
//!     }
//!
//!     fn normalize(&self, _: &mut State) {}
//! }
//!
//! impl Linearize<2, 1> for CartPole {
//!     /// At rest with the pole upright, where it is used here.
//!     fn linearize_into(
//!         &self,
//!         _: &State,
//!         force: &f64,
//!         at: &mut ContinuousModel<f64, 2, 1>,
//!     ) -> Result<(), Error> {
//!         at.accelerations = Vector2::new(*force, -2.0 * force);
//!         at.by_coordinates = Matrix2::new(0.0, -0.981, 0.0, 2.0 * (9.81 + 0.981));
//!         at.by_rates = Matrix2::zeros();
//!         at.by_inputs = Vector2::new(1.0, -2.0);
//!         at.tangent_rate = Matrix2::zeros();
//!         Ok(())
//!     }
//! }
//!
//! let model = discretize(&CartPole, &State::default(), &0.0, 0.02)?;
//! let weights = Matrix4::from_diagonal(&Vector4::new(10.0, 10.0, 1.0, 1.0));
//! let regulator = lqr(&model.a(), &model.b(), &weights, &Matrix1::new(0.1))?;
//!
//! // The nonlinear chain stays upright.
//! let (mut state, mut rk4) = (State { q: [0.0, 0.3], ..State::default() }, Rk4::new(0.02));
//! for _ in 0..500 {
//!     let x = Vector4::new(state.q[0], state.q[1], state.v[0], state.v[1]);
//!     let force = -(regulator.gain * x).x;
//!     rk4.step_held(&CartPole, &mut state, &force)?;
//! }
//! assert!(state.q[0].abs() < 1e-3 && state.q[1].abs() < 1e-3);
//! # Ok::<(), Error>(())
//! ```

use crate::Scalar;

mod discrete;
mod null_space;
mod product;
mod regulator;
mod solve;

pub use discrete::{ContinuousModel, DiscreteModel, Linearize, Sensitivity, discretize};
pub use null_space::null_space;
pub use product::{negative_product, negative_product_of_rows};
pub use regulator::{Lqr, lqr};
pub use solve::{solve, solve_positive_definite};

/// The columns of a matrix with R rows, as nalgebra stores them.
type Columns<T, const R: usize, const C: usize> = [[T; R]; C];

/// Returns the largest magnitude in each lane. NaN is skipped.
fn largest<'a, T: Scalar>(entries: impl IntoIterator<Item = &'a T>) -> T {
    entries.into_iter().fold(T::constant(0.0), |largest, entry| {
        T::select(entry.abs().simd_gt(largest), entry.abs(), largest)
    })
}
