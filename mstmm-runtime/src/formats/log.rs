//! Errors, names, states and points in the logs of microcontrollers, by `defmt`.

use defmt::{Format, Formatter, write};

use super::labels::{Label, TIME};
use super::listing::Listing;
use super::point_tables::{Shown, shown, shown_of_body};
use super::table::Row;
use crate::description::{Name, Origin};
use crate::point::{BodyPoint, LinePoint, PlanePoint, Point, Results};
use crate::{Error, Scalar};

impl<T: Scalar + Format, const N: usize> Format for Listing<T, N> {
    fn format(&self, f: Formatter<'_>) {
        let mut separator = "";
        for (label, value, unit) in self.entries() {
            write!(f, "{=str}{} = {} {=str}", separator, label, value, unit);
            separator = ", ";
        }
    }
}

impl Format for Label {
    fn format(&self, f: Formatter<'_>) {
        match self {
            Label::Of(name) => name.format(f),
            Label::Time => write!(f, "{=str}", TIME),
        }
    }
}

impl Format for Name {
    fn format(&self, f: Formatter<'_>) {
        let ((path, after), group, component) = self.pieces();
        write!(f, "{=str}", path);
        if let (Some(after), Some(repetition)) = (after, self.repetition()) {
            write!(f, "[{=usize}]{=str}", repetition, after);
        }
        if !group.is_empty() {
            write!(f, ".{=str}", group);
        }
        if let Some(component) = component {
            write!(f, ".{=char}", component);
        }
    }
}

/// Writes rows with their units.
fn write_rows<'a, T: Format + 'a>(
    f: Formatter<'_>,
    rows: impl Iterator<Item = Row<'a, &'static str, T>>,
) {
    let mut separator = "";
    for row in rows {
        write!(f, "{=str}{=str} {=[?]} {=str}", separator, row.label, row.values, row.unit);
        separator = ", ";
    }
}

/// Implements the trait for connection points and for points of bodies.
macro_rules! points {
    ($($point:ident)*) => { $(
        impl<T: Format, const P: bool, const V: bool, const Z: bool> Format
            for $point<T, Results<P, V, Z>>
        {
            fn format(&self, f: Formatter<'_>) {
                write_rows(f, shown(&self.rows(), [P, V, Z]));
            }
        }
        impl<T: Scalar + Format, const P: bool, const V: bool, const Z: bool> Format
            for BodyPoint<$point<T, Results<P, V, Z>>>
        {
            fn format(&self, f: Formatter<'_>) {
                write_rows(f, shown_of_body(&self.motion().rows(), Self::SHOWN));
            }
        }
    )* };
}

points! { Point PlanePoint LinePoint }

/// Writes the variant with its name and index.
impl Format for Origin {
    fn format(&self, f: Formatter<'_>) {
        match *self {
            Origin::Time => write!(f, "time"),
            Origin::Coordinate(index) => write!(f, "coordinate {=usize}", index),
            Origin::Rate(index) => write!(f, "rate {=usize}", index),
            Origin::Input(index) => write!(f, "input {=usize}", index),
            Origin::Argument { name, index } => write!(f, "{=str}[{=usize}]", name, index),
            Origin::End => write!(f, "end"),
            Origin::Result => write!(f, "result"),
        }
    }
}

/// Writes the variant with its names.
impl Format for Error {
    fn format(&self, f: Formatter<'_>) {
        match *self {
            Error::Singular { hinge } => write!(f, "Singular hinge {=str}", hinge),
            Error::NotFinite(origin) => write!(f, "NotFinite {}", origin),
            Error::InvalidQuaternion { hinge } => write!(f, "InvalidQuaternion of {=str}", hinge),
            Error::InvalidParameter { name, reason } => {
                write!(f, "InvalidParameter {=str} {=str}", name, reason);
            }
            Error::StepTooSmall => write!(f, "StepTooSmall"),
            Error::OutsideStep => write!(f, "OutsideStep"),
            Error::NotAssembled => write!(f, "NotAssembled"),
            Error::ClosureRank { hinge } => write!(f, "ClosureRank of hinge {=str}", hinge),
            Error::SingularMatrix => write!(f, "SingularMatrix"),
            Error::NotStabilizable => write!(f, "NotStabilizable"),
        }
    }
}
