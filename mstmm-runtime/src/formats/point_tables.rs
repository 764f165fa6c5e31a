//! The tables of connection points.

use core::fmt;

use super::table::{self, Row, Show};
use crate::Scalar;
use crate::point::{BodyPoint, Group, LinePoint, PlanePoint, Point, PointRow, Results};

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

/// Returns the rows of a point of a body that its chain has the results for; `has` omits the last rows, of force and
/// moment.
pub fn shown_of_body<'a, T>(
    rows: &'a [PointRow<'a, T>],
    has: &'a [bool],
) -> impl Iterator<Item = Row<'a, &'static str, T>> {
    let rows = rows.iter().zip(has).filter(|(_, has)| **has);
    rows.map(|(&(_, label, values, unit), _)| Row::of(label, values, unit))
}

/// Which rows of a point of a body its chain has the results for: its velocity needs the pose of the body, its acceleration
/// all results.
pub trait Shown {
    /// Whether the chain has each row of motion.
    const SHOWN: &'static [bool];
}

/// Implements the traits for points of bodies, each with the results that its rows need.
macro_rules! tables_of_bodies {
    ($($point:ident($poses:ident, $velocities:ident, $z:ident): [$($has:expr),*];)*) => { $(
        impl<T, const $poses: bool, const $velocities: bool, const $z: bool> Shown
            for BodyPoint<$point<T, Results<$poses, $velocities, $z>>>
        {
            const SHOWN: &'static [bool] = &[$($has),*];
        }
        /// Shows its motion as a table with units, as the tables of connection points, in the inertial frame.
        impl<T: Scalar + fmt::Display, const P: bool, const V: bool, const Z: bool> fmt::Display
            for BodyPoint<$point<T, Results<P, V, Z>>>
        {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                let point = self.motion();
                let rows = point.rows();
                table::write(f, <T as fmt::Display>::fmt, || shown_of_body(&rows, Self::SHOWN))
            }
        }
        /// Shows the same table as [`Display`](fmt::Display), with powers of ten.
        impl<T: Scalar + fmt::LowerExp, const P: bool, const V: bool, const Z: bool> fmt::LowerExp
            for BodyPoint<$point<T, Results<P, V, Z>>>
        {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                let point = self.motion();
                let rows = point.rows();
                table::write(f, <T as fmt::LowerExp>::fmt, || shown_of_body(&rows, Self::SHOWN))
            }
        }
    )* };
}

tables_of_bodies! {
    Point(P, V, Z): [P, P, P, P, P && V, V, P && V && Z, Z];
    PlanePoint(P, V, Z): [P, P, P && V, V, P && V && Z, Z];
    LinePoint(P, V, Z): [P, V, Z];
}
