//! A procedure: a function with its loads, tests and stores, in the order in which they run. Printers write it in a
//! programming language; the tests have an interpreter.
//!
//! Loops do not nest, and the only branches are those that end the procedure.

use super::{ArrayLayout, BlockId, Operand, Section, ValueBound, ValueId, ValueNames};
use crate::ids::{IdVec, InputId, ParameterId, RepeatId, declare_id};

declare_id! {
    /// An array of a procedure.
    ArrayId,
    /// A test whether a pivot of a repeated part vanishes in any repetition.
    CheckId,
}

/// A procedure.
#[derive(Clone, Debug, PartialEq)]
pub struct Procedure {
    /// The names of its values.
    pub values: ValueNames,
    /// The arrays that it reads and writes.
    pub arrays: IdVec<ArrayId, Array>,
    /// The number of pivots of repeated parts that it tests.
    pub checks: usize,
    /// The contents of its results after a failure.
    pub failure: Failure,
    /// Its steps.
    pub body: Vec<Step>,
}

/// An array of numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Array {
    /// Its role.
    pub role: ArrayRole,
    /// Its layout.
    pub layout: ArrayLayout,
    /// Values that are the same in every state, by their index in the array. They are written when the array is created,
    /// not by the procedure.
    pub initial: Vec<(usize, f64)>,
}

impl Array {
    /// Returns an array whose entries are all computed.
    pub fn new(role: ArrayRole, layout: ArrayLayout) -> Self {
        Array { role, layout, initial: Vec::new() }
    }
}

/// The role of an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArrayRole {
    /// An argument, which is only read.
    Argument(Argument),
    /// A result, which is only written.
    Result(OutputId),
    /// The values that the loop of this block stores for later loops.
    Local(BlockId),
}

/// An argument of a procedure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Argument {
    /// A parameter.
    Parameter(ParameterId),
    /// The constants of the user's crate.
    Constants,
    /// Which steps of the elimination of a loop closure are taken: one or zero each.
    ClosureSteps,
    /// The joint coordinates `q`.
    Coordinates,
    /// The joint rates `v`.
    Rates,
    /// The time.
    Time,
    /// An input.
    Input(InputId),
    /// The length of a linearly implicit step.
    Step,
    /// A vector that the caller gives.
    Given(Given),
    /// The slots: values that the setup derives from parameters and constants, of one repeated part or of everything
    /// outside of repeated parts.
    Slots(Option<RepeatId>),
}

impl Argument {
    /// Returns whether it is the factor of a product. Several vectors at a time may be given for it.
    pub fn is_factor(self) -> bool {
        match self {
            Argument::Given(given) => match given {
                Given::Vector
                | Given::CoordinateDirection
                | Given::RateDirection
                | Given::InputDirection
                | Given::ParameterDirection
                | Given::DynamicParameters => true,
                Given::Accelerations | Given::VirtualRates | Given::Place => false,
            },
            _ => false,
        }
    }
}

/// A vector that the caller gives to a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Given {
    /// Accelerations, one for each rate.
    Accelerations,
    /// The factor of a product, one entry for each rate.
    Vector,
    /// Values of the dynamic parameters.
    DynamicParameters,
    /// The position of a point in the frame of its body.
    Place,
    /// The rates of a virtual motion. They are replaced by formulas before a function is compiled.
    VirtualRates,
    /// The part of a direction along the coordinates: a small motion along the rates.
    CoordinateDirection,
    /// The part of a direction along the rates.
    RateDirection,
    /// The part of a direction along the inputs.
    InputDirection,
    /// The part of a direction along the parameters.
    ParameterDirection,
}

/// A result of a procedure, by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct OutputId {
    /// The name.
    pub name: &'static str,
    /// The repeated part that it belongs to, if every part has its own.
    pub part: Option<RepeatId>,
}

impl OutputId {
    /// Returns the result with this name.
    pub const fn new(name: &'static str) -> Self {
        OutputId { name, part: None }
    }
}

/// A contiguous part of a segment of an array.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArraySlice {
    /// The array.
    pub array: ArrayId,
    /// The index of its segment.
    pub segment: usize,
    /// The first entry, relative to the segment.
    pub first: usize,
    /// The repetition.
    pub repetition: Repetition,
}

/// A repetition of a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Repetition {
    /// The only one.
    Only,
    /// The repetition of the enclosing loop.
    Current,
    /// All repetitions.
    All,
}

/// A step of a procedure.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// Fails unless all values of these arguments are finite.
    CheckArguments(Vec<ArrayId>),
    /// Reads some entries of a slice.
    Load {
        /// The slice.
        from: ArraySlice,
        /// The value for each entry of the slice; none for an entry that is not read.
        into: Vec<Option<ValueId>>,
    },
    /// Runs the statements of a section.
    Compute(Section),
    /// Writes some entries of a slice.
    Store {
        /// The slice.
        to: ArraySlice,
        /// The value for each entry of the slice; none for an entry that stays unchanged.
        values: Vec<Option<Operand>>,
    },
    /// A loop.
    Loop(ForLoop),
    /// Tests a pivot in a repetition.
    CheckPivot {
        /// The test that collects the answers of all repetitions.
        check: CheckId,
        /// The pivot.
        value: Operand,
        /// The scale of its rounding error.
        scale: Operand,
    },
    /// Finds whether the magnitudes of values are below bounds.
    TestBounds(Vec<ValueBound>),
    /// Fails if a pivot vanishes, or if a value is not finite.
    CheckResults(ResultCheck),
}

impl Step {
    /// Returns whether it writes to an array, also in a loop.
    pub fn stores_into(&self, array: ArrayId) -> bool {
        match self {
            Step::Store { to, .. } => to.array == array,
            Step::Loop(loop_) => loop_.body.iter().any(|step| step.stores_into(array)),
            _ => false,
        }
    }
}

/// A loop over the repetitions of a part.
#[derive(Clone, Debug, PartialEq)]
pub struct ForLoop {
    /// The repeated part.
    pub repeat: RepeatId,
    /// The number of repetitions.
    pub repetitions: usize,
    /// Whether it runs from the last repetition to the first.
    pub inward: bool,
    /// The loop-carried values.
    pub carries: Vec<CarriedValue>,
    /// Its steps: loads, then sections, then stores and tests.
    pub body: Vec<Step>,
}

/// A loop-carried value.
#[derive(Clone, Debug, PartialEq)]
pub struct CarriedValue {
    /// The value after the last repetition.
    pub exit: ValueId,
    /// The value at the start of a repetition.
    pub phi: ValueId,
    /// The value at the start of the first repetition.
    pub init: Operand,
    /// The value at the end of a repetition.
    pub next: Operand,
}

/// The test whether the results are valid.
#[derive(Clone, Debug, PartialEq)]
pub struct ResultCheck {
    /// The pivots, in the order in which they are tested.
    pub pivots: Vec<PivotTest>,
    /// The values that must be finite.
    pub finite: Vec<Witness>,
    /// The results that must be finite, and are so within the bounds of [`Step::TestBounds`].
    pub unless_bounded: Vec<ArrayId>,
}

impl ResultCheck {
    /// Iterates over its operands.
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
    /// The name of the hinge.
    pub hinge: String,
    /// The pivot.
    pub pivot: PivotValue,
}

/// The value of a pivot.
#[derive(Clone, Debug, PartialEq)]
pub enum PivotValue {
    /// A pivot outside of repeated parts: value and scale.
    Once(Operand, Operand),
    /// A pivot of a repeated part, which a loop tests.
    Repeated(CheckId),
}

/// A value or values that must be finite.
#[derive(Clone, Debug, PartialEq)]
pub enum Witness {
    /// A value.
    Value(Operand),
    /// An entry of an argument, outside of repeated parts.
    Entry(ArrayId, usize),
    /// A whole array.
    Array(ArrayId),
}

/// The contents of the results after a failure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failure {
    /// The results keep their previous contents.
    Untouched,
    /// The results are reset to their initial values.
    Reset,
    /// Some entries of the results have new values, others keep the previous ones.
    PartlyWritten,
}

impl Failure {
    /// Returns whether results may be written before they are checked.
    pub fn allows_early_stores(self) -> bool {
        self != Failure::Untouched
    }
}

impl Procedure {
    /// Iterates over all sections; sections of loops count once.
    pub fn sections(&self) -> impl Iterator<Item = &Section> {
        let steps = self.body.iter().flat_map(|step| match step {
            Step::Loop(loop_) => loop_.body.iter(),
            _ => std::slice::from_ref(step).iter(),
        });
        steps.filter_map(|step| match step {
            Step::Compute(section) => Some(section),
            _ => None,
        })
    }

    /// Returns the array with a role, if the procedure has it.
    pub fn array(&self, role: ArrayRole) -> Option<ArrayId> {
        self.arrays.position(|array| array.role == role)
    }
}
