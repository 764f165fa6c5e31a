//! The tables of connection points.

use core::fmt;

use super::table::{self, Row, Show};
use crate::point::{Group, LinePoint, PlanePoint, Point, PointRow, Results};

/// Returns the rows of the results that a point has.
pub fn shown<'a, T>(
    rows: &'a [PointRow<'a, T>],
    [poses, velocities, z]: [bool; 3],
) -> impl Iterator<Item = Row<'a, &'static str, T>> {
    let has = move |group| match group {
        Group::Pose => poses,
        Group::Velocity => velocities,
        Group::Z => z,
    };
    let rows = rows.iter().filter(move |(group, ..)| has(*group));
    rows.map(|&(_, label, values, unit)| Row::of(label, values, unit))
}

fn write<T>(
    f: &mut fmt::Formatter<'_>,
    show: Show<T>,
    rows: &[PointRow<'_, T>],
    has: [bool; 3],
) -> fmt::Result {
    table::write(f, show, || shown(rows, has))
}

/// Implements the traits for connection points.
macro_rules! tables {
    ($($point:ident)*) => { $(
        /// Shows the results that the chain computes as a table with units, in the inertial frame.
        ///
        /// The precision, 4 if omitted, and a sign `+` of the format are used: `{:+.6}`. `{:e}` writes powers of ten.
        /// The rows of an orientation are those of the rotation matrix A.
        impl<T: fmt::Display, const P: bool, const V: bool, const Z: bool> fmt::Display
            for $point<T, Results<P, V, Z>>
        {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write(f, T::fmt, &self.rows(), [P, V, Z])
            }
        }
        /// Shows the same table as [`Display`](fmt::Display), with powers of ten.
        impl<T: fmt::LowerExp, const P: bool, const V: bool, const Z: bool> fmt::LowerExp
            for $point<T, Results<P, V, Z>>
        {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write(f, T::fmt, &self.rows(), [P, V, Z])
            }
        }
    )* };
}

tables! { Point PlanePoint LinePoint }
