//! The motion that each rate causes, and the rates that move a body.

use core::ops::Range;

use nalgebra::{SMatrix, SVector};

use crate::Scalar;

/// Consecutive rates between the ground and a body, for generated code.
///
/// The rates of the body's path to the ground are a list of such runs. A run of a repeated part exists once; its first
/// rate depends on the repetition.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct RateRun {
    first: u32,
    count: u32,
    stride: u32,
    inboard: u32,
    enters: u32,
    previous: u32,
}

impl RateRun {
    /// Makes the run of `count` rates from index `first` on; in each further repetition the index grows by `stride`.
    ///
    /// Links to runs count from one; zero is the ground. `inboard` is the next run toward the ground, with the
    /// repetition `enters` counted from one, where zero keeps the repetition. `previous` is the next run in all
    /// repetitions but the first, if that run is in the previous repetition.
    #[must_use]
    pub const fn new(
        [first, count, stride]: [u32; 3],
        [inboard, enters, previous]: [u32; 3],
    ) -> Self {
        Self { first, count, stride, inboard, enters, previous }
    }
}

/// The columns of all rates, with the path of one body: what its Jacobians are made of.
///
/// A column is the velocity of the point at the inertial origin that moves with the body outboard of the hinge, then
/// the angular velocity of that body, for a rate of one.
#[derive(Clone, Copy, Debug)]
pub struct RateColumns<'a, T> {
    columns: &'a [T],
    runs: &'static [RateRun],
    run: u32,
    repetition: u32,
}

impl<'a, T> RateColumns<'a, T> {
    /// Makes the columns of a body, from its first run and its repetition; for generated code.
    #[doc(hidden)]
    #[inline]
    pub fn new(columns: &'a [T], runs: &'static [RateRun], run: u32, repetition: u32) -> Self {
        Self { columns, runs, run, repetition }
    }

    /// Returns the next run of rates toward the ground.
    #[inline(always)]
    fn next_run(&mut self) -> Option<Range<usize>> {
        let index = (self.run as usize).checked_sub(1)?;
        let run = self.runs.get(index)?;
        let first = run.first as usize + run.stride as usize * self.repetition as usize;
        if run.previous > 0 && self.repetition > 0 {
            (self.run, self.repetition) = (run.previous, self.repetition - 1);
        } else {
            self.run = run.inboard;
            self.repetition = run.enters.checked_sub(1).unwrap_or(self.repetition);
        }
        Some(first..first + run.count as usize)
    }
}

impl<T: Scalar> RateColumns<'_, T> {
    /// Writes the columns at a point: those of the path as `at_point` returns them, zero for all other rates.
    #[inline(always)]
    pub(super) fn fill<const R: usize, const N: usize>(
        mut self,
        matrix: &mut SMatrix<T, R, N>,
        at_point: impl Fn([T; R]) -> [T; R],
    ) {
        let (columns, _) = self.columns.as_chunks::<R>();
        matrix.data.0 = [[T::constant(0.0); R]; N];
        while let Some(run) = self.next_run() {
            if let (Some(columns), Some(places)) =
                (columns.get(run.clone()), matrix.data.0.get_mut(run))
            {
                for (place, &column) in places.iter_mut().zip(columns) {
                    *place = at_point(column);
                }
            }
        }
    }

    /// Returns the sum of the columns of the path, each times the entry of `rates`.
    #[inline(always)]
    pub(super) fn times<const R: usize, const N: usize>(mut self, rates: &SVector<T, N>) -> [T; R] {
        let (columns, _) = self.columns.as_chunks::<R>();
        let mut sum = [T::constant(0.0); R];
        while let Some(run) = self.next_run() {
            if let (Some(columns), Some(rates)) =
                (columns.get(run.clone()), rates.as_slice().get(run))
            {
                for (column, &rate) in columns.iter().zip(rates) {
                    for (entry, &unit) in sum.iter_mut().zip(column) {
                        *entry = unit.mul_add(rate, *entry);
                    }
                }
            }
        }
        sum
    }

    /// Writes the products of the columns of the path with `wrench`, zero for all other rates.
    #[inline(always)]
    pub(super) fn transpose_times<const R: usize, const N: usize>(
        mut self,
        wrench: [T; R],
        efforts: &mut SVector<T, N>,
    ) {
        let (columns, _) = self.columns.as_chunks::<R>();
        efforts.data.0 = [[T::constant(0.0); N]];
        while let Some(run) = self.next_run() {
            if let (Some(columns), Some(efforts)) =
                (columns.get(run.clone()), efforts.as_mut_slice().get_mut(run))
            {
                for (effort, column) in efforts.iter_mut().zip(columns) {
                    for (&unit, &load) in column.iter().zip(&wrench) {
                        *effort = unit.mul_add(load, *effort);
                    }
                }
            }
        }
    }
}

/// No columns: the chain's setting `answers` omits `jacobian`.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoColumns;

/// Kinematics with the columns of all rates.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `jacobian`",
    label = "needs `answers = jacobian;`",
    note = "add the word to the chain's list: `answers = […, jacobian];`"
)]
pub trait HasJacobian<T>: Copy {
    /// Returns the columns of all rates.
    #[doc(hidden)]
    fn rate_columns(&self) -> RateColumns<'_, T>;
}

impl<T: Copy> HasJacobian<T> for RateColumns<'_, T> {
    #[inline(always)]
    fn rate_columns(&self) -> RateColumns<'_, T> {
        *self
    }
}
