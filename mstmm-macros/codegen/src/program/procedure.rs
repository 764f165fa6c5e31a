//! A procedure: a function with all that it reads, tests and writes, in the order in which it does so. Printers
//! write it in a language, an interpreter runs it.
//!
//! Loops do not nest, and there are no branches but those that end the procedure.

use super::{ArrayLayout, Operand, Section, ValueId, ValueNames};
use crate::ids::{IdVec, InputId, RepeatId, declare_id};

declare_id! {
    /// An array of a procedure.
    ArrayId,
    /// A test whether a pivot of a repeated part vanishes in any repetition.
    CheckId,
}

/// A procedure.
#[derive(Clone, Debug, PartialEq)]
pub struct Procedure {
    /// What its values are called.
    pub values: ValueNames,
    /// The arrays that it reads and writes.
    pub arrays: IdVec<ArrayId, Array>,
    /// How many pivots of repeated parts it tests.
    pub checks: usize,
    /// What it leaves in its results where it fails.
    pub failure: Failure,
    /// Its steps.
    pub body: Vec<Step>,
}

/// An array of numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Array {
    /// What it is for.
    pub role: ArrayRole,
    /// Where its numbers lie.
    pub layout: ArrayLayout,
    /// Numbers that are the same in every state, by their places in the array: they are written where the array is
    /// made and not by the procedure.
    pub initial: Vec<(usize, f64)>,
}

impl Array {
    /// An array all of whose entries are computed.
    pub fn new(role: ArrayRole, layout: ArrayLayout) -> Self {
        Array { role, layout, initial: Vec::new() }
    }
}

/// What an array is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArrayRole {
    /// Something given, which is read only.
    Argument(Argument),
    /// A result, which is written only.
    Result(OutputId),
    /// What the loop of this block leaves for later ones.
    Local(usize),
}

/// What a procedure may be given.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Argument {
    /// A parameter, by its number.
    Parameter(usize),
    /// Constants of the user's crate.
    Constants,
    /// The steps of a closure's elimination that are taken.
    ClosureSteps,
    /// Coordinates `q`.
    Coordinates,
    /// Rates `v`.
    Rates,
    /// The time.
    Time,
    /// An input.
    Input(InputId),
    /// The length of a linearly implicit step.
    Step,
    /// What the setup has derived from parameters and constants, of a repeated part or of all that stands
    /// once.
    Slots(Option<RepeatId>),
}

/// A result, by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct OutputId {
    /// The name.
    pub name: &'static str,
    /// The repeated part that it belongs to, if every part has its own.
    pub part: Option<RepeatId>,
}

impl OutputId {
    /// A result with this name.
    pub const fn new(name: &'static str) -> Self {
        OutputId { name, part: None }
    }
}

/// Neighbouring numbers of a segment of an array.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArraySlice {
    /// The array.
    pub array: ArrayId,
    /// The number of its segment.
    pub segment: usize,
    /// The first entry, counted from that of the segment.
    pub first: usize,
    /// In which repetition.
    pub repetition: Repetition,
}

/// Which repetition of a segment is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Repetition {
    /// The only one.
    Only,
    /// That of the loop around.
    Current,
    /// All of them.
    All,
}

/// A step of a procedure.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// Fails unless all numbers of these arguments are finite.
    CheckGiven(Vec<ArrayId>),
    /// Reads numbers, as far as they are wanted.
    Load {
        /// Where they are.
        from: ArraySlice,
        /// The values that they are, one for each entry from the first on.
        into: Vec<Option<ValueId>>,
    },
    /// Computes.
    Compute(Section),
    /// Writes numbers.
    Store {
        /// Where they go.
        to: ArraySlice,
        /// One for each entry from the first on; what has none stays as it is.
        values: Vec<Option<Operand>>,
    },
    /// A loop.
    Loop(ForLoop),
    /// Tests a pivot in a repetition.
    CheckPivot {
        /// Under which number the answer is kept.
        check: CheckId,
        /// The pivot.
        value: Operand,
        /// What it is measured by.
        scale: Operand,
    },
    /// Fails if a pivot vanishes, or if a number is not finite.
    Finish(Finish),
}

/// A loop over the repetitions of a part.
#[derive(Clone, Debug, PartialEq)]
pub struct ForLoop {
    /// Which part.
    pub repeat: RepeatId,
    /// How often it is repeated.
    pub repetitions: usize,
    /// Whether it goes from the last repetition to the first.
    pub inward: bool,
    /// What it carries from one repetition to the next.
    pub carries: Vec<CarriedValue>,
    /// Its steps: first it loads, then computes, then stores and tests.
    pub body: Vec<Step>,
}

/// A number that a loop carries.
#[derive(Clone, Debug, PartialEq)]
pub struct CarriedValue {
    /// Under which name the last value is kept.
    pub exit: ValueId,
    /// The value that a repetition begins with.
    pub phi: ValueId,
    /// What the first repetition begins with.
    pub init: Operand,
    /// What a repetition hands on.
    pub next: Operand,
}

/// The test whether there are results.
#[derive(Clone, Debug, PartialEq)]
pub struct Finish {
    /// The pivots, in the order in which they are tested.
    pub pivots: Vec<PivotTest>,
    /// What must be finite.
    pub finite: Vec<Witness>,
}

impl Finish {
    /// What it reads.
    pub fn operands(&self) -> impl Iterator<Item = &Operand> {
        let pivots = self.pivots.iter().flat_map(|test| match &test.pivot {
            PivotValue::Once(value, scale) => [Some(value), Some(scale)],
            PivotValue::Repeated(_) => [None; 2],
        });
        let finite = self.finite.iter().filter_map(|witness| match witness {
            Witness::Value(value) => Some(value),
            Witness::Entry(..) | Witness::Array(_) => None,
        });
        pivots.flatten().chain(finite)
    }
}

/// A pivot and the hinge that it belongs to.
#[derive(Clone, Debug, PartialEq)]
pub struct PivotTest {
    /// The hinge's name.
    pub hinge: String,
    /// The number, or what a loop has found.
    pub pivot: PivotValue,
}

/// A pivot.
#[derive(Clone, Debug, PartialEq)]
pub enum PivotValue {
    /// It stands once: the number, and what it is measured by.
    Once(Operand, Operand),
    /// It stands in every repetition.
    Repeated(CheckId),
}

/// What must be finite.
#[derive(Clone, Debug, PartialEq)]
pub enum Witness {
    /// A value.
    Value(Operand),
    /// An entry of an argument that stands once.
    Entry(ArrayId, usize),
    /// A whole array.
    Array(ArrayId),
}

/// What a failing procedure leaves in its results.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failure {
    /// What was there before.
    Untouched,
    /// What they are made with.
    Reset,
}

impl Procedure {
    /// All sections, those of loops once.
    pub fn sections(&self) -> impl Iterator<Item = &Section> {
        let steps = self.body.iter().flat_map(|step| match step {
            Step::Loop(one) => one.body.iter(),
            _ => std::slice::from_ref(step).iter(),
        });
        steps.filter_map(|step| match step {
            Step::Compute(section) => Some(section),
            _ => None,
        })
    }

    /// The array with a role, if the procedure has it.
    pub fn array(&self, role: ArrayRole) -> Option<ArrayId> {
        self.arrays.position(|array| array.role == role)
    }
}
