//! Quantities: coordinates, rates, accelerations, efforts, inputs and parameters.

use super::hinge::Hinge;
use super::items::Element;
use super::name::{Name, repetition_in};
use super::part::{Part, QuantityKind};
use super::rows::{Input, Parameter};
use super::table::{Entry, Table};

/// A coordinate, a rate, an acceleration, an effort, an input or a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// The name, such as `elbow.angle`.
    pub name: Name,
    /// The kind.
    pub kind: QuantityKind,
    /// The unit as text, such as `N*m`; `1` for components of quaternions and plain numbers.
    pub unit: &'static str,
    /// The value at the start with default parameters; of a parameter its default, of an input its value in `no_inputs()`.
    /// `None` for accelerations and efforts, and if it is computed from Rust constants by a root, a sine or a cosine.
    pub start: Option<f64>,
    /// The lowest and the highest coordinate where the hinge has `limits`, with default parameters.
    #[doc(alias("jnt_range", "GetPositionLowerLimits", "GetPositionUpperLimits"))]
    #[doc(alias("lowerPositionLimit", "upperPositionLimit"))]
    pub limits: Option<[f64; 2]>,
    /// The index of its hinge, for coordinates, rates, accelerations and efforts.
    pub hinge: Option<usize>,
}

/// A list of quantities: all coordinates, all rates, all accelerations, all efforts, all inputs or all parameters.
#[derive(Clone, Copy, Debug)]
pub struct Quantities(List);

#[derive(Clone, Copy, Debug)]
enum List {
    Coordinates(Table<Hinge>),
    Rates(Table<Hinge>),
    Accelerations(Table<Hinge>),
    Efforts(Table<Hinge>),
    Inputs(Table<Input>),
    Parameters(Table<Parameter>),
}

/// How the rows of a table are read.
struct Reader<R> {
    count: fn(&R) -> usize,
    path: fn(&R) -> &'static str,
    part: fn(&R, usize) -> Part,
}

const COORDINATES: Reader<Hinge> =
    Reader { count: Hinge::coordinate_count, path: Element::path, part: Hinge::coordinate };
const RATES: Reader<Hinge> =
    Reader { count: Hinge::rate_count, path: Element::path, part: Hinge::rate };
const ACCELERATIONS: Reader<Hinge> =
    Reader { count: Hinge::rate_count, path: Element::path, part: Hinge::acceleration };
const EFFORTS: Reader<Hinge> =
    Reader { count: Hinge::effort_count, path: Element::path, part: Hinge::effort };
const INPUTS: Reader<Input> = Reader { count: Input::count, path: Input::path, part: Input::part };
const PARAMETERS: Reader<Parameter> =
    Reader { count: |_| 1, path: Parameter::path, part: Parameter::part };

impl Quantities {
    pub(super) const fn coordinates(hinges: Table<Hinge>) -> Self {
        Quantities(List::Coordinates(hinges))
    }

    pub(super) const fn rates(hinges: Table<Hinge>) -> Self {
        Quantities(List::Rates(hinges))
    }

    pub(super) const fn accelerations(hinges: Table<Hinge>) -> Self {
        Quantities(List::Accelerations(hinges))
    }

    pub(super) const fn efforts(hinges: Table<Hinge>) -> Self {
        Quantities(List::Efforts(hinges))
    }

    pub(super) const fn inputs(inputs: Table<Input>) -> Self {
        Quantities(List::Inputs(inputs))
    }

    pub(super) const fn parameters(parameters: Table<Parameter>) -> Self {
        Quantities(List::Parameters(parameters))
    }

    /// Returns the number of quantities.
    #[must_use]
    pub fn len(self) -> usize {
        match self.0 {
            List::Coordinates(table) => table.len(COORDINATES.count),
            List::Rates(table) => table.len(RATES.count),
            List::Accelerations(table) => table.len(ACCELERATIONS.count),
            List::Efforts(table) => table.len(EFFORTS.count),
            List::Inputs(table) => table.len(INPUTS.count),
            List::Parameters(table) => table.len(PARAMETERS.count),
        }
    }

    /// Returns whether there are no quantities.
    #[must_use]
    pub fn is_empty(self) -> bool {
        self.len() == 0
    }

    /// Returns the quantity at an index.
    #[must_use]
    pub fn get(self, index: usize) -> Option<Quantity> {
        let of_hinge = |hinges: Table<Hinge>, reader: &Reader<Hinge>| {
            let (quantity, entry) = get(hinges, reader, index)?;
            let hinge = hinges.first_of(entry.number, entry.repetition, |_| 1);
            Some(Quantity { hinge, ..quantity })
        };
        match self.0 {
            List::Coordinates(hinges) => of_hinge(hinges, &COORDINATES),
            List::Rates(hinges) => of_hinge(hinges, &RATES),
            List::Accelerations(hinges) => of_hinge(hinges, &ACCELERATIONS),
            List::Efforts(hinges) => of_hinge(hinges, &EFFORTS),
            List::Inputs(table) => get(table, &INPUTS, index).map(|(quantity, _)| quantity),
            List::Parameters(table) => get(table, &PARAMETERS, index).map(|(quantity, _)| quantity),
        }
    }

    /// Returns the index of the quantity with this name.
    ///
    /// The time does not depend on the number of repetitions.
    #[must_use]
    pub fn index(self, name: &str) -> Option<usize> {
        match self.0 {
            List::Coordinates(table) => index(table, &COORDINATES, name),
            List::Rates(table) => index(table, &RATES, name),
            List::Accelerations(table) => index(table, &ACCELERATIONS, name),
            List::Efforts(table) => index(table, &EFFORTS, name),
            List::Inputs(table) => index(table, &INPUTS, name),
            List::Parameters(table) => index(table, &PARAMETERS, name),
        }
    }

    /// Returns all quantities in their order.
    pub fn iter(self) -> impl Iterator<Item = Quantity> {
        (0..self.len()).map_while(move |index| self.get(index))
    }
}

fn get<R>(table: Table<R>, reader: &Reader<R>, index: usize) -> Option<(Quantity, Entry<R>)> {
    let at = table.entry(index, reader.count)?;
    let part = (reader.part)(at.row, at.entry);
    let quantity = Quantity {
        name: part.named((reader.path)(at.row), at.repetition),
        kind: part.kind,
        unit: part.unit,
        start: Some(part.start).filter(|start| !start.is_nan()),
        limits: part.limits,
        hinge: None,
    };
    Some((quantity, at))
}

fn index<R>(table: Table<R>, reader: &Reader<R>, name: &str) -> Option<usize> {
    let repetition = repetition_in(name)?;
    table.rows().find_map(|(number, row)| {
        let is_it = |&entry: &usize| {
            (reader.part)(row, entry).named((reader.path)(row), repetition) == *name
        };
        let entry = (0..(reader.count)(row)).find(is_it)?;
        Some(table.first_of(number, repetition, reader.count)? + entry)
    })
}
