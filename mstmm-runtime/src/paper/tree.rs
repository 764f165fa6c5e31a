//! Trees: a rigid body with several inputs and one output, and the overall equation.
//!
//! The paper treats chains. For the transfer equations of trees it refers to Rui, Zhang and Zhou,
//! *Automatic deduction theorem of overall transfer equation of multibody systems*, Advances in
//! Mechanical Engineering 6, 2014 (doi 10.1155/2014/378047); the theorem for branched systems with
//! accelerations in the state vectors was published in 2016 (doi 10.1177/1687814016651586). This
//! module has their structure, one main transfer equation and several geometric equations. Its
//! matrices are derived here from Newton's and Euler's laws in the notation of the paper.
//!
//! Elements transfer state vectors from the tips to the root: the input of an element is on the side
//! of the tips. Chains of `mstmm_chain!` are written from the root to the tips, so their state
//! vectors at the same points have −m and −q. All vectors are in the inertial frame, as everywhere in
//! this module; the inputs and the output of a body are points without axes.
//!
//! A body with the inputs I₁ = I to I_L and the output O has one main transfer equation, and
//! 6 (L − 1) geometric equations, since all inputs move as one body:
//!
//! ```text
//! z_O = U₁ z_I + U₂ z_I₂ + … + U_L z_I_L
//! H₁ⱼ z_I = Hⱼ z_Iⱼ         j = 2 … L
//! ```
//!
//! U₁ is [`Blocks::transfer_matrix`](super::body::Blocks::transfer_matrix), Uⱼ is
//! [`FurtherInput::transfer_matrix`], H₁ⱼ is [`FurtherInput::geometry`], and Hⱼ = \[I₆ 0\] selects r̈
//! and Ω̇ of a state vector.
//!
//! # Solution
//!
//! 1. At each tip r̈ and Ω̇ are unknown ([`Columns::free_tip`]). The unknowns of all tips form one
//!    column x, and every state vector is an affine function of x, its [`Columns`].
//! 2. The elements of an arm transfer its columns to the body with several inputs.
//! 3. The pin between an arm and this body has no matrix (43), because the moment at O depends on the
//!    other inputs, too. Its angular acceleration Θ̈ is another unknown ([`Columns::over_pin`]).
//! 4. The conditions on x are the geometric equations, those of the root's output, and for each arm
//!    [`Columns::axial_moment`] = 0 at its first pin. The matrix (43) contains the condition of the
//!    *next* pin; that of the first pin would be missing, as in (45). [`solve`] computes x.
//!
//! For L arms of pins on a free body, this overall equation has 7 L rows and 7 L unknowns, whatever
//! the length of the arms. If the arms branch again, each further body with several inputs adds its
//! geometric equations, the Θ̈ of the pins at its inputs, and the condition of the pin at its output.
//!
//! # Limits
//!
//! The overall equation grows with the number of tips, and its coefficients are products along the
//! arms, which lose accuracy with their length as in chains. Relative errors of r̈ and Ω̇ in `f64` for
//! a free cube with three arms of the paper's cubes on oblique pins, the largest of ten random states,
//! compared with a solution in maximal coordinates (the compiler's test `paper_tree_limits`):
//!
//! | bodies of each arm | 1 | 3 | 5 | 8 | 12 | 16 |
//! |---|---|---|---|---|---|---|
//! | overall equation | 3e-15 | 2e-12 | 2e-10 | 2e-7 | 8e-4 | lost |
//! | the same elements, null space of each condition | 8e-16 | 1e-15 | 3e-15 | 3e-15 | 1e-14 | 1e-14 |
//! | Riccati's method, as in `mstmm_chain!` | 8e-16 | 9e-16 | 5e-15 | 7e-15 | 9e-15 | 1e-14 |
//!
//! The second row does without the matrices (43). Each condition at a pin or at the body with several
//! inputs removes one unknown by a Householder reflection, so no condition is solved for one of the
//! unknowns. This needs a reflection for each condition, and is not more accurate than Riccati's
//! method, which needs no overall equation. `method = transfer` is therefore for chains only.
//!
//! # Three arms on a hub
//!
//! A torque accelerates a hub with three arms on pins.
//!
//! ```
//! use mstmm_runtime::nalgebra::{Matrix3, Rotation3, SVector, Vector3};
//! use mstmm_runtime::paper::body::{Body, Load, Motion};
//! use mstmm_runtime::paper::chain::OutputEnd;
//! use mstmm_runtime::paper::pin::Pin;
//! use mstmm_runtime::paper::tree::{self, Columns, FurtherInput};
//! use mstmm_runtime::paper::state;
//!
//! let turned = |degrees: f64| {
//!     *Rotation3::from_axis_angle(&Vector3::z_axis(), degrees.to_radians()).matrix()
//! };
//! let rest = |orientation| Motion { orientation, angular_velocity: Vector3::zeros() };
//! let load = |moment| Load { force: Vector3::zeros(), moment: Vector3::new(0.0, 0.0, moment) };
//!
//! // The arms at 0°, 120° and 240°. Their inputs are the tips, so their frames point inwards.
//! let arm = Body {
//!     mass: 1.0,
//!     com: Vector3::new(0.5, 0.0, 0.0),
//!     output: Vector3::new(1.0, 0.0, 0.0),
//!     inertia: Matrix3::from_diagonal(&Vector3::new(1.0 / 6.0, 5.0 / 12.0, 5.0 / 12.0)),
//! };
//! // The hub, with its first input at 0° and 1 m from its centre, which is also its output.
//! let hub = Body {
//!     mass: 2.0,
//!     com: Vector3::new(-1.0, 0.0, 0.0),
//!     output: Vector3::new(-1.0, 0.0, 0.0),
//!     inertia: Matrix3::from_diagonal(&Vector3::new(0.6, 2.6, 3.0)),
//! };
//! let hub_at = rest(Matrix3::identity());
//! let pin = Pin { orientation: Matrix3::identity(), angular_velocity: Vector3::zeros(), rate: 0.0 };
//!
//! let (mut inputs, mut conditions) = (Vec::new(), Vec::new());
//! for k in 0..3 {
//!     let u = arm.blocks(&rest(turned(180.0 + 120.0 * k as f64)), &load(0.0)).transfer_matrix();
//!     let end = Columns::<f64, 13, 21>::free_tip(7 * k).through(&u);
//!     conditions.extend(end.axial_moment(&pin).rows());
//!     inputs.push(end.over_pin(&pin, 7 * k + 6));
//! }
//! let mut output = inputs[0].through(&hub.blocks(&hub_at, &load(2.2)).transfer_matrix());
//! for k in 1..3 {
//!     let position = turned(120.0 * k as f64) * Vector3::x() - Vector3::x();
//!     let further = FurtherInput::new(&hub, &hub_at, &position);
//!     conditions.extend(further.geometric_equations(&inputs[0], &inputs[k]).rows());
//!     output = output + inputs[k].through(&further.transfer_matrix());
//! }
//! let free = OutputEnd::free().conditions; // neither force nor moment at the hub's centre
//! conditions.extend(output.through(&free).rows());
//! let x: SVector<f64, 21> = tree::solve::<f64, 21, 21>(conditions);
//!
//! // By hand: (1 + 3 · 1) α + 3 · 0.5 β = 2.2 about the centre, 0.5 α + 5/12 β = 0 about each pin.
//! let (hub_turning, arm_turning) = (1.0, -1.2);
//! let centre = state::blocks(&output.at(&x));
//! assert!((centre.angular_acceleration().z - hub_turning).abs() < 1e-12);
//! assert!(centre.acceleration().norm() < 1e-12);
//! for k in 0..3 {
//!     assert!((x[7 * k + 5] - arm_turning).abs() < 1e-12); // Ω̇_z of the tip
//!     assert!((x[7 * k + 6] - (hub_turning - arm_turning)).abs() < 1e-12); // Θ̈
//! }
//! ```

use core::ops::{Add, Sub};

use nalgebra::{SMatrix, SVector, Vector3};

use super::TransferMatrix;
use super::algebra::{self, Times, block, entry, identity, set, tilde, with, zeros};
use super::body::{Body, Motion};
use super::pin::{Pin, axis};
use crate::Scalar;

/// An input Iⱼ of a body in addition to its first input I; vectors in the inertial frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FurtherInput<T> {
    /// r_IIⱼ, the vector from I to Iⱼ, in m.
    pub from_first: Vector3<T>,
    /// r_IⱼO, the vector from Iⱼ to O, in m.
    pub to_output: Vector3<T>,
    /// Ω̃ Ω̃ r_IIⱼ in m/s².
    pub centripetal: Vector3<T>,
}

impl<T: Scalar> FurtherInput<T> {
    /// Returns the input of a body at `position` l_IIⱼ relative to I, in m, in the body frame.
    pub fn new(body: &Body<T>, motion: &Motion<T>, position: &Vector3<T>) -> Self {
        let Motion { orientation, angular_velocity } = motion;
        let from_first = orientation.times(position);
        let to_output = orientation.times(&body.output) - from_first;
        let omega = tilde(angular_velocity);
        let centripetal = omega.times(&omega.times(&from_first));
        FurtherInput { from_first, to_output, centripetal }
    }

    /// Returns Uⱼ of the main transfer equation.
    ///
    /// With the wrenches of all inputs, Newton's law `[P, Eq. (14)]` and Euler's law about I
    /// `[P, Eq. (15)]` are
    ///
    /// ```text
    /// q_O = Σ q_Iⱼ + E₃ r̈_I + E₄ Ω̇_I + E₅
    /// m_O = Σ (m_Iⱼ − r̃_IIⱼ q_Iⱼ) + E₆ q_O + E₇ r̈_I + E₈ Ω̇_I + E₉
    /// ```
    ///
    /// so Iⱼ adds q_Iⱼ to q_O and m_Iⱼ + r̃_IⱼO q_Iⱼ to m_O. All other rows are zero, also the last
    /// one: U₁ has the accelerations at O, the inertia and the loads.
    pub fn transfer_matrix(&self) -> TransferMatrix<T> {
        let u = with(zeros(), (6, 6), &identity::<T, 6>());
        with(u, (6, 9), &tilde(&self.to_output))
    }

    /// Returns H₁ⱼ, which transforms z_I into r̈ and Ω̇ at Iⱼ in m/s² and rad/s²:
    /// `[P, Eqs. (13), (16)]` with Iⱼ in place of O.
    pub fn geometry(&self) -> SMatrix<T, 6, 13> {
        let h = with(accelerations(), (0, 3), &-tilde(&self.from_first));
        with(h, (0, 12), &self.centripetal)
    }

    /// Returns H₁ⱼ z_I − Hⱼ z_Iⱼ, which the six geometric equations set to zero.
    pub fn geometric_equations<const K: usize>(
        &self,
        first: &Columns<T, 13, K>,
        input: &Columns<T, 13, K>,
    ) -> Columns<T, 6, K> {
        first.through(&self.geometry()) - input.through(&accelerations())
    }
}

/// Returns Hⱼ = \[I₆ 0\], which selects r̈ and Ω̇ of a state vector.
fn accelerations<T: Scalar>() -> SMatrix<T, 6, 13> {
    with(zeros(), (0, 0), &identity::<T, 6>())
}

/// D values as affine functions of the K unknowns x of a tree: `unknown` x + `known`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Columns<T, const D: usize, const K: usize> {
    /// One column for each unknown.
    pub unknown: SMatrix<T, D, K>,
    /// The values for x = 0.
    pub known: SVector<T, D>,
}

impl<T: Scalar, const D: usize, const K: usize> Columns<T, D, K> {
    /// Returns `matrix` times these values. If it is the transfer matrix of an element, the result is
    /// the state vector at its output `[P, Eq. (8)]`.
    pub fn through<const R: usize>(&self, matrix: &SMatrix<T, R, D>) -> Columns<T, R, K> {
        Columns { unknown: matrix.times(&self.unknown), known: matrix.times(&self.known) }
    }

    /// Returns the values for the given unknowns.
    pub fn at(&self, unknowns: &SVector<T, K>) -> SVector<T, D> {
        self.unknown.times(unknowns) + self.known
    }

    /// Returns each of the D values separately.
    pub fn rows(&self) -> impl Iterator<Item = Columns<T, 1, K>> + use<T, D, K> {
        let Self { unknown, known } = *self;
        (0..D).map(move |row| Columns {
            unknown: block(&unknown, (row, 0)),
            known: block(&known, (row, 0)),
        })
    }
}

impl<T: Scalar, const K: usize> Columns<T, 13, K> {
    /// Returns z of a free tip: r̈ and Ω̇ are the six unknowns from `first` on, counted from 0; m and q
    /// are zero.
    pub fn free_tip(first: usize) -> Self {
        let one = T::constant(1.0);
        Columns {
            unknown: with(zeros(), (0, first), &identity::<T, 6>()),
            known: with(zeros(), (12, 0), &SVector::<T, 1>::new(one)),
        }
    }

    /// Returns z at the output of a pin `[P, Eqs. (32) to (34), (36)]`, where `self` is z at its input;
    /// Θ̈ in rad/s² is the unknown with the index `unknown`, counted from 0.
    pub fn over_pin(&self, pin: &Pin<T>, unknown: usize) -> Self {
        let angular: Vector3<T> = block(&self.known, (3, 0));
        let angular = pin.output_angular_acceleration(&angular, T::default());
        let column = with(zeros(), (3, unknown), &axis(&pin.orientation));
        Columns { unknown: self.unknown + column, known: with(self.known, (3, 0), &angular) }
    }

    /// Returns H₂ A_{j,O}ᵀ m in N m, which vanishes at a smooth pin `[P, Eq. (35)]`.
    pub fn axial_moment(&self, pin: &Pin<T>) -> Columns<T, 1, K> {
        self.through(&with(zeros(), (0, 6), &axis(&pin.orientation).transpose()))
    }
}

impl<T: Scalar, const D: usize, const K: usize> Add for Columns<T, D, K> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Columns { unknown: self.unknown + other.unknown, known: self.known + other.known }
    }
}

impl<T: Scalar, const D: usize, const K: usize> Sub for Columns<T, D, K> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Columns { unknown: self.unknown - other.unknown, known: self.known - other.known }
    }
}

/// Returns the K unknowns of a tree for which M `conditions` are zero: the solution of its overall
/// equation.
///
/// If there are more conditions than unknowns, the sum of squares of the residuals is least, as for
/// [`chain::solve`](super::chain::solve). The unknowns are not finite if they are undetermined,
/// unless rounding hides it. Conditions after the first M are ignored.
pub fn solve<T: Scalar, const M: usize, const K: usize>(
    conditions: impl IntoIterator<Item = Columns<T, 1, K>>,
) -> SVector<T, K> {
    let (mut matrix, mut right) = (zeros::<T, M, K>(), zeros::<T, M, 1>());
    for (row, condition) in (0..M).zip(conditions) {
        matrix = with(matrix, (row, 0), &condition.unknown);
        set(&mut right, (row, 0), -entry(&condition.known, (0, 0)));
    }
    algebra::solve(matrix, right)
}
