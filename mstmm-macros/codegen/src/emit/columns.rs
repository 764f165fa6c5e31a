//! Which values of a procedure have several lanes, in a type `C`; all others have the scalar type `T`.
//!
//! - A matrix is computed several columns at a time. A product with a matrix is linear in its factor, the vector that the
//!   caller gives. Values that depend on the factor differ between the columns, and `C` is `T::Columns`. All others are
//!   computed once for all columns.
//! - Limbs of one shape are computed side by side. Packs have a lane for each limb, and `C` is `T::Pack`.

use crate::compile::outputs;
use crate::ids::IdVec;
use crate::program::{
    Argument, Array, ArrayId, ArrayRole, ArraySlice, ForLoop, Operand, Procedure, ResultCheck,
    Section, Statement, Step, ValueId, Witness,
};

/// The values and entries of arrays that differ between columns.
#[derive(Clone)]
pub struct Varying {
    /// Each value.
    values: Vec<bool>,
    /// The entries of each array.
    entries: Vec<Vec<bool>>,
    /// Whether several columns are computed at a time.
    of_columns: bool,
}

impl Varying {
    /// Returns that no value differs: all values have the type `T`.
    pub fn none(procedure: &Procedure) -> Self {
        let entries = |array: &Array| vec![false; array.layout.entries()];
        Varying {
            values: vec![false; procedure.values.all().len()],
            entries: procedure.arrays.iter().map(entries).collect(),
            of_columns: false,
        }
    }

    /// Returns what depends on the factor of a product. All results do, except the accelerations.
    pub fn of(procedure: &Procedure) -> Self {
        let mut varying = Varying { of_columns: true, ..Varying::none(procedure) };
        for (array, entries) in procedure.arrays.iter().zip(&mut varying.entries) {
            if matches!(array.role, ArrayRole::Result(id) if id != outputs::ACCELERATIONS) {
                entries.fill(true);
            }
        }
        // A value that a loop carries may depend on a later one of the repetition before.
        while varying.follow(&procedure.arrays, &procedure.body) {}
        varying
    }

    /// Returns the packs.
    pub fn packs(procedure: &Procedure) -> Self {
        let mut varying = Varying::none(procedure);
        varying.follow(&procedure.arrays, &procedure.body);
        varying
    }

    /// Returns whether a value differs between columns.
    pub fn value(&self, value: ValueId) -> bool {
        self.values[value.index()]
    }

    /// Returns whether an operand differs between columns.
    pub fn operand(&self, operand: &Operand) -> bool {
        operand.value().is_some_and(|value| self.value(value))
    }

    /// Returns whether an operand of a statement differs between columns.
    pub fn statement(&self, statement: &Statement) -> bool {
        statement.operands().any(|operand| self.operand(operand))
    }

    /// Returns whether any entry of an array differs between columns.
    pub fn array(&self, array: ArrayId) -> bool {
        self.entries[array.index()].contains(&true)
    }

    /// Returns whether an entry of an array differs between columns.
    pub fn entry(&self, array: ArrayId, entry: usize) -> bool {
        self.entries[array.index()][entry]
    }

    /// Returns whether an argument is a factor that differs between columns.
    pub fn is_factor(&self, argument: Argument) -> bool {
        self.of_columns && argument.is_factor()
    }

    /// Splits the steps of a procedure into those that are the same for all columns and those that differ. The former
    /// need nothing of the latter.
    pub fn split(&self, steps: &[Step]) -> [Vec<Step>; 2] {
        let (mut once, mut columns) = (Vec::new(), Vec::new());
        for step in steps {
            match step {
                Step::Compute(section) => {
                    let (varying, same): (Vec<_>, Vec<_>) = section
                        .statements
                        .iter()
                        .cloned()
                        .partition(|statement| self.statement(statement));
                    let part =
                        |statements| Step::Compute(Section { statements, ..section.clone() });
                    once.push(part(same));
                    columns.push(part(varying));
                }
                Step::CheckResults(check) => {
                    let (varying, same) =
                        check.finite.iter().cloned().partition(|it| self.witness(it));
                    once.push(Step::CheckResults(ResultCheck { finite: same, ..check.clone() }));
                    columns.push(Step::CheckResults(ResultCheck {
                        pivots: Vec::new(),
                        finite: varying,
                        unless_bounded: Vec::new(),
                    }));
                }
                _ if self.step(step) => columns.push(step.clone()),
                _ => once.push(step.clone()),
            }
        }
        [once, columns].map(|steps| steps.into_iter().filter(|step| !is_empty(step)).collect())
    }

    /// Returns whether a step reads or writes anything that differs between columns.
    fn step(&self, step: &Step) -> bool {
        match step {
            Step::CheckArguments(_) | Step::TestBounds(_) => false,
            Step::Load { into, .. } => into.iter().flatten().any(|&value| self.value(value)),
            Step::Compute(section) => section.statements.iter().any(|it| self.statement(it)),
            Step::Store { to, .. } => self.array(to.array),
            Step::CheckPivot { value, scale, .. } => self.operand(value) || self.operand(scale),
            Step::Loop(loop_) => {
                let carries = &mut loop_.carries.iter();
                carries.any(|carry| self.value(carry.phi))
                    || loop_.body.iter().any(|step| self.step(step))
            }
            Step::CheckResults(check) => check.finite.iter().any(|it| self.witness(it)),
        }
    }

    /// Returns whether what must be finite differs between columns.
    fn witness(&self, witness: &Witness) -> bool {
        match witness {
            Witness::Value(value) => self.operand(value),
            Witness::Array(array) => self.array(*array),
            Witness::Entry(..) => false,
        }
    }

    /// Marks what depends on marked values; returns whether there is any.
    fn follow(&mut self, arrays: &IdVec<ArrayId, Array>, steps: &[Step]) -> bool {
        let mut changed = false;
        for step in steps {
            changed |= match step {
                Step::Load { from, into } => self.load(&arrays[from.array], from, into),
                Step::Compute(section) => {
                    let statements = section.statements.iter();
                    statements.fold(false, |changed, statement| self.compute(statement) | changed)
                }
                Step::Store { to, values } => self.store(&arrays[to.array], to, values),
                Step::Loop(loop_) => self.carry(loop_) | self.follow(arrays, &loop_.body),
                Step::CheckArguments(_)
                | Step::TestBounds(_)
                | Step::CheckPivot { .. }
                | Step::CheckResults(_) => false,
            };
        }
        changed
    }

    fn mark(&mut self, value: ValueId) -> bool {
        !std::mem::replace(&mut self.values[value.index()], true)
    }

    fn load(&mut self, array: &Array, from: &ArraySlice, into: &[Option<ValueId>]) -> bool {
        let mut changed = false;
        let first = first_entry(array, from);
        for (entry, value) in into.iter().enumerate() {
            let is_varying = match array.role {
                ArrayRole::Argument(argument) => self.is_factor(argument),
                _ => self.entry(from.array, first + entry),
            };
            if let Some(value) = value.filter(|_| is_varying) {
                changed |= self.mark(value);
            }
        }
        changed
    }

    fn compute(&mut self, statement: &Statement) -> bool {
        if !matches!(statement, Statement::Pack { .. }) && !self.statement(statement) {
            return false;
        }
        statement.defined().fold(false, |changed, value| self.mark(value) | changed)
    }

    fn store(&mut self, array: &Array, to: &ArraySlice, values: &[Option<Operand>]) -> bool {
        let mut changed = false;
        let first = first_entry(array, to);
        for (entry, value) in values.iter().enumerate() {
            if value.as_ref().is_some_and(|value| self.operand(value)) {
                let place = &mut self.entries[to.array.index()][first + entry];
                changed |= !std::mem::replace(place, true);
            }
        }
        changed
    }

    fn carry(&mut self, loop_: &ForLoop) -> bool {
        let mut changed = false;
        for carry in &loop_.carries {
            if self.operand(&carry.init) || self.operand(&carry.next) {
                changed |= self.mark(carry.phi) | self.mark(carry.exit);
            }
        }
        changed
    }
}

/// Returns whether a step does nothing.
fn is_empty(step: &Step) -> bool {
    match step {
        Step::Compute(section) => section.statements.is_empty(),
        Step::CheckResults(check) => check.pivots.is_empty() && check.finite.is_empty(),
        _ => false,
    }
}

/// Returns the index of the first entry of a slice in its array; entries of repeated parts count once.
fn first_entry(array: &Array, slice: &ArraySlice) -> usize {
    array.layout.segments[slice.segment].first + slice.first
}
