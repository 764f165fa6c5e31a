//! Derivatives of inverse and forward dynamics, which generated chains compute.

use crate::Scalar;
use crate::generated::matrix;
use nalgebra::{SMatrix, SVector};

/// Derivatives of inverse dynamics `τ = ID(q, v, v̇)` of a chain with `N` rates, one row and column per rate.
///
/// Units are SI: N m and N for τ, divided by rad and m, rad/s and m/s, or rad/s² and m/s².
#[derive(Clone, Debug, PartialEq)]
pub struct InverseDynamicsDerivatives<T, const N: usize> {
    /// With respect to the coordinates, along the rates: column `k` for the small displacement `dq = N(q) δ` with
    /// `δ` along rate `k`.
    #[doc(alias("dtau_dq"))]
    pub by_coordinates: SMatrix<T, N, N>,
    /// With respect to the rates `v`.
    #[doc(alias("dtau_dv"))]
    pub by_rates: SMatrix<T, N, N>,
    /// With respect to the accelerations `v̇`: the mass matrix.
    pub by_accelerations: SMatrix<T, N, N>,
}

impl<T: Scalar, const N: usize> Default for InverseDynamicsDerivatives<T, N> {
    /// Zeros.
    fn default() -> Self {
        InverseDynamicsDerivatives {
            by_coordinates: zeros(),
            by_rates: zeros(),
            by_accelerations: zeros(),
        }
    }
}

/// The accelerations of a chain in a state and their derivatives: the linearised equations of motion.
///
/// `N` is the number of rates, `N2 = 2 N`, `U` the number of entries of all inputs and `P` the number of parameters,
/// in the order of the fields of the chain's inputs and parameters. Units are SI: rad/s² and m/s² for `v̇`, divided by
/// those of the quantity.
///
/// Coordinates change along the rates: `dq = N(q) δ` with one entry of `δ` per rate. For a ball and for the rotation of
/// a floating or an elastic hinge `δ` is a small rotation vector in outboard axes. The derivatives with respect to
/// `δ` are those with respect to `q` if `v = q̇`.
#[derive(Clone, Debug, PartialEq)]
pub struct Linearization<T, const N: usize, const N2: usize, const U: usize, const P: usize> {
    /// The accelerations `v̇`.
    pub accelerations: SVector<T, N>,
    /// The inverse of the mass matrix: the derivatives of `v̇` with respect to the efforts along all rates.
    pub inverse_mass_matrix: SMatrix<T, N, N>,
    /// `∂v̇/∂q`, along the rates.
    #[doc(alias("ddq_dq"))]
    pub by_coordinates: SMatrix<T, N, N>,
    /// `∂v̇/∂v`
    #[doc(alias("ddq_dv"))]
    pub by_rates: SMatrix<T, N, N>,
    /// `∂v̇/∂u`, one column for each entry of the inputs.
    ///
    /// For the quaternion of a prescribed motion only changes have a meaning that keep its length.
    pub by_inputs: SMatrix<T, N, U>,
    /// `∂v̇/∂p`, one column for each parameter.
    pub by_parameters: SMatrix<T, N, P>,
    rates: SVector<T, N>,
    rotations: &'static [[usize; 3]],
}

impl<T: Scalar, const N: usize, const N2: usize, const U: usize, const P: usize> Default
    for Linearization<T, N, N2, U, P>
{
    /// Zeros.
    fn default() -> Self {
        Linearization {
            accelerations: zeros(),
            inverse_mass_matrix: zeros(),
            by_coordinates: zeros(),
            by_rates: zeros(),
            by_inputs: zeros(),
            by_parameters: zeros(),
            rates: zeros(),
            rotations: &[],
        }
    }
}

impl<T: Scalar, const N: usize, const N2: usize, const U: usize, const P: usize>
    Linearization<T, N, N2, U, P>
{
    /// Sets the state that `a` needs: the rates, and for the rotations in space the index of the first rate, the
    /// distance between repetitions and their number.
    #[doc(hidden)]
    pub fn set_state(&mut self, rates: &SVector<T, N>, rotations: &'static [[usize; 3]]) {
        self.rates = *rates;
        self.rotations = rotations;
    }

    /// Returns `A` of `ẋ = A x + B u` for small changes `x = (δ, dv)` of coordinates, along the rates, and rates.
    ///
    /// The upper half is `δ̇ = dv − ω × δ` for rotations in space, since their axes move with the outboard
    /// frame, and `δ̇ = dv` for all other coordinates. The lower half has the derivatives of the accelerations.
    #[doc(alias(
        "state matrix",
        "mjd_transitionFD",
        "computeABADerivatives",
        "FirstOrderTaylorApproximation"
    ))]
    #[must_use]
    pub fn a(&self) -> SMatrix<T, N2, N2> {
        let mut columns = [[T::constant(0.0); N2]; N2];
        let lower = self.by_coordinates.data.0.iter().chain(&self.by_rates.data.0);
        for (column, values) in columns.iter_mut().zip(lower) {
            column.iter_mut().skip(N).zip(values).for_each(|(entry, &value)| *entry = value);
        }
        for (row, column) in columns.iter_mut().skip(N).enumerate() {
            column.iter_mut().skip(row).take(1).for_each(|entry| *entry = T::constant(1.0));
        }
        self.add_tangent_rate(&mut columns);
        matrix(columns)
    }

    /// Sets the entries of `−ω × …` for rotations in space, in columns of at least `N` rows.
    fn add_tangent_rate<const ROWS: usize>(&self, columns: &mut [[T; ROWS]]) {
        for first in self.first_rates() {
            for (axis, column) in columns.iter_mut().skip(first).take(3).enumerate() {
                let negative_cross = self.negative_cross(first, axis);
                let rows = column.iter_mut().skip(first).take(3);
                rows.zip(negative_cross).for_each(|(entry, value)| *entry = value);
            }
        }
    }

    /// Iterates over the indices of the first rates of rotations in space.
    fn first_rates(&self) -> impl Iterator<Item = usize> {
        let of = |&[first, step, count]: &[usize; 3]| (0..count).map(move |k| first + k * step);
        self.rotations.iter().flat_map(of)
    }

    /// Writes what the discrete model of a step needs.
    #[doc(hidden)]
    pub fn write_to(&self, at: &mut crate::linear::ContinuousModel<T, N, U>) {
        at.accelerations = self.accelerations;
        at.by_coordinates = self.by_coordinates;
        at.by_rates = self.by_rates;
        at.by_inputs = self.by_inputs;
        at.tangent_rate = zeros();
        self.add_tangent_rate(&mut at.tangent_rate.data.0);
    }

    /// Returns column `axis` of the matrix of `−ω × …`, where `ω` are three rates from `first` on.
    fn negative_cross(&self, first: usize, axis: usize) -> [T; 3] {
        let zero = T::constant(0.0);
        let mut rates = self.rates.data.0.iter().flatten().copied().skip(first);
        let [x, y, z] = [(); 3].map(|()| rates.next().unwrap_or(zero));
        match axis {
            0 => [zero, -z, y],
            1 => [z, zero, -x],
            _ => [-y, x, zero],
        }
    }

    /// Returns `B` of `ẋ = A x + B u`; see [`a`](Self::a).
    #[doc(alias("input matrix"))]
    #[must_use]
    pub fn b(&self) -> SMatrix<T, N2, U> {
        let mut columns = [[T::constant(0.0); N2]; U];
        for (column, values) in columns.iter_mut().zip(&self.by_inputs.data.0) {
            column.iter_mut().skip(N).zip(values).for_each(|(entry, &value)| *entry = value);
        }
        matrix(columns)
    }

    /// Returns the derivatives of the accelerations with respect to the components (w, x, y, z) of a quaternion of the
    /// state.
    ///
    /// `number` counts balls, floating and elastic hinges in the order of `v`, without prescribed ones; `None` if there
    /// are fewer. `quaternion` is the value in the state. Only changes that keep its length have a meaning; the
    /// derivative along a change of the length is zero.
    ///
    /// The state of an elastic hinge has angles instead of a quaternion. If `quaternion` is the orientation of its
    /// outboard frame relative to its inboard frame, the derivatives are those with respect to the components of this
    /// quaternion, at the same position.
    #[doc(alias("quaternion derivative", "derivative by quaternion components"))]
    #[must_use]
    pub fn by_quaternion(&self, number: usize, quaternion: [T; 4]) -> Option<SMatrix<T, N, 4>> {
        let first = self.first_rates().nth(number)?;
        let [w, x, y, z] = quaternion;
        // δ = 2 (w dr − r dw − r × dr), by columns.
        let tangents = [[-x, -y, -z], [w, -z, y], [z, w, -x], [-y, x, w]];
        let along = |tangent: [T; 3]| {
            let mut column = [T::constant(0.0); N];
            let of_rotation = self.by_coordinates.data.0.iter().skip(first);
            for (values, change) in of_rotation.zip(tangent) {
                let twice = change + change;
                let entries = column.iter_mut().zip(values);
                entries.for_each(|(sum, &value)| *sum = value.mul_add(twice, *sum));
            }
            column
        };
        Some(matrix(tangents.map(along)))
    }
}

fn zeros<T: Scalar, const R: usize, const C: usize>() -> SMatrix<T, R, C> {
    matrix([[T::constant(0.0); R]; C])
}
