//! An interpreter of procedures, including loops, on any scalar. Sines, cosines and arctangents of `f64` have the same bits on
//! every machine.

use mstmm_codegen::math::Scalar;
use mstmm_codegen::program::{
    Argument, Array, ArrayId, ArrayRole, ArraySlice, CheckId, Failure, ForLoop, Operand, Operation,
    OutputId, PACK, PivotValue, Procedure, Repetition, ResultCheck, Statement, Step, ValueId,
    Witness,
};
use std::collections::HashMap;

/// A scalar whose values can be tested.
pub trait Judge: Scalar {
    /// Returns whether a pivot exceeds the rounding error of its scale; false for NaN.
    fn exceeds(self, scale: Self) -> bool;
    /// Returns whether the value is finite.
    fn is_finite(self) -> bool;
    /// Returns `a b + c`, rounded once or twice.
    fn product_sum(a: Self, b: Self, c: Self, fused: bool) -> Self;
    /// Returns sine and cosine.
    fn sine_and_cosine(self) -> (Self, Self) {
        self.sin_cos()
    }
    /// Returns `atan2(self, x)`.
    fn angle(self, x: Self) -> Self {
        self.atan2(x)
    }
    /// Returns the nearest `f64`.
    fn plain(self) -> f64;

    /// Returns whether a pivot is finite and does not exceed the rounding error of its scale.
    fn is_lost(self, scale: Self) -> bool {
        self.is_finite() && scale.is_finite() && !self.exceeds(scale)
    }
}

/// The arrays that a procedure reads and writes.
#[derive(Clone, Debug)]
pub struct Arrays<S> {
    /// The arguments.
    pub arguments: HashMap<Argument, Vec<S>>,
    /// The results; an entry that is not written is none.
    pub results: HashMap<OutputId, Vec<Option<S>>>,
    /// Whether a fused product and sum are rounded once.
    pub fused: bool,
    /// Whether a failing check keeps the results instead of returning an error.
    pub untested: bool,
}

/// The reason of a failure.
#[derive(Clone, Debug, PartialEq)]
pub enum Failed {
    /// A value is not finite.
    NotFinite,
    /// The pivot of this hinge vanishes.
    Singular(String),
}

impl<S> Default for Arrays<S> {
    fn default() -> Self {
        let (arguments, results) = (HashMap::new(), HashMap::new());
        Arrays { arguments, results, fused: false, untested: false }
    }
}

impl<S: Judge> Arrays<S> {
    /// Returns a result, every entry of which must have been written.
    pub fn result(&self, id: OutputId) -> Vec<S> {
        let entries = self.results.get(&id).unwrap_or_else(|| panic!("no result {id:?}"));
        let value = |(place, value): (usize, &Option<S>)| {
            value.unwrap_or_else(|| panic!("entry {place} of {id:?} has not been written"))
        };
        entries.iter().enumerate().map(value).collect()
    }

    /// Returns whether the results have only their initial values.
    fn reset(&mut self, procedure: &Procedure) {
        for array in &procedure.arrays {
            if let ArrayRole::Result(id) = array.role {
                self.results.insert(id, initial(array));
            }
        }
    }
}

/// Returns the initial values of an array.
fn initial<S: Scalar>(array: &Array) -> Vec<Option<S>> {
    let mut values = vec![None; array.layout.total];
    for &(entry, value) in &array.initial {
        values[entry] = Some(S::number(value));
    }
    values
}

/// Runs a procedure.
pub fn run<S: Judge>(procedure: &Procedure, arrays: &mut Arrays<S>) -> Result<(), Failed> {
    let local = |array: &Array| vec![None; array.layout.total];
    let mut machine = Machine {
        procedure,
        values: vec![None; procedure.values.count()],
        locals: procedure.arrays.iter().map(local).collect(),
        checks: vec![true; procedure.checks],
        repetition: 0,
        packs: HashMap::new(),
        lane: 0,
        arrays: arrays.clone(),
    };
    machine.arrays.results.clear();
    machine.arrays.reset(procedure);
    let ran = machine.steps(&procedure.body);
    match (&ran, procedure.failure) {
        (Ok(()), _) => *arrays = machine.arrays,
        (Err(_), Failure::Reset) => arrays.reset(procedure),
        (Err(_), Failure::Untouched | Failure::PartlyWritten) => {}
    }
    ran
}

struct Machine<'a, S> {
    procedure: &'a Procedure,
    values: Vec<Option<S>>,
    /// The values that loops store for later loops, by array; empty for other arrays.
    locals: Vec<Vec<Option<S>>>,
    checks: Vec<bool>,
    /// The current repetition of a loop.
    repetition: usize,
    /// The lanes of each pack.
    packs: HashMap<ValueId, Vec<S>>,
    /// The current lane of an operation on packs.
    lane: usize,
    arrays: Arrays<S>,
}

impl<S: Judge> Machine<'_, S> {
    fn steps(&mut self, steps: &[Step]) -> Result<(), Failed> {
        steps.iter().try_for_each(|step| self.step(step))
    }

    fn step(&mut self, step: &Step) -> Result<(), Failed> {
        match step {
            Step::CheckArguments(arrays) => {
                let all =
                    arrays.iter().all(|&array| self.whole(array).iter().all(|x| x.is_finite()));
                return if all { Ok(()) } else { Err(Failed::NotFinite) };
            }
            Step::Load { from, into } => {
                for (entry, value) in into.iter().enumerate() {
                    if let Some(value) = value {
                        self.values[value.index()] = Some(self.read(from, entry));
                    }
                }
            }
            Step::Compute(section) => section.statements.iter().for_each(|it| self.statement(it)),
            Step::Store { to, values } => self.store(to, values),
            Step::Loop(one) => return self.one_loop(one),
            Step::CheckPivot { check, value, scale } => {
                let is_lost = self.value(value).is_lost(self.value(scale));
                self.checks[check.index()] &= !is_lost;
            }
            // Bounds only save tests.
            Step::TestBounds(_) => {}
            Step::CheckResults(finish) if !self.arrays.untested => return self.finish(finish),
            Step::CheckResults(_) => {}
        }
        Ok(())
    }

    /// Returns the index in the array of an entry of a slice, in a repetition.
    fn at(&self, place: &ArraySlice, entry: usize, repetition: usize) -> usize {
        let array = &self.procedure.arrays[place.array];
        let segment = &array.layout.segments[place.segment];
        let number = place.first + entry;
        assert!(number < segment.count && repetition < segment.repetitions, "outside of a layout");
        segment.offset + repetition * segment.count + number
    }

    fn read(&self, from: &ArraySlice, entry: usize) -> S {
        let repetition = match from.repetition {
            Repetition::Only => 0,
            Repetition::Current => self.repetition,
            Repetition::All => panic!("one value is read of many repetitions"),
        };
        let at = self.at(from, entry, repetition);
        match self.procedure.arrays[from.array].role {
            ArrayRole::Argument(argument) => self.argument(argument)[at],
            ArrayRole::Local(_) => {
                self.locals[from.array.index()][at].expect("a loop reads what no loop has left")
            }
            ArrayRole::Result(id) => panic!("a result is read: {id:?}"),
        }
    }

    fn argument(&self, argument: Argument) -> &[S] {
        match self.arrays.arguments.get(&argument) {
            Some(values) => values,
            None => panic!("nothing is given for {argument:?}"),
        }
    }

    fn whole(&self, array: ArrayId) -> Vec<S> {
        match self.procedure.arrays[array].role {
            ArrayRole::Argument(argument) => self.argument(argument).to_vec(),
            ArrayRole::Result(id) => self.arrays.result(id),
            ArrayRole::Local(_) => panic!("what loops leave is not tested"),
        }
    }

    fn store(&mut self, to: &ArraySlice, values: &[Option<Operand>]) {
        let count = self.procedure.arrays[to.array].layout.segments[to.segment].repetitions;
        let repetitions = match to.repetition {
            Repetition::Only => 0..1,
            Repetition::Current => self.repetition..self.repetition + 1,
            Repetition::All => 0..count,
        };
        for repetition in repetitions {
            for (entry, value) in values.iter().enumerate() {
                let Some(value) = value else { continue };
                let (at, value) = (self.at(to, entry, repetition), self.value(value));
                let place = match self.procedure.arrays[to.array].role {
                    ArrayRole::Result(id) => {
                        &mut self.arrays.results.get_mut(&id).expect("a result")[at]
                    }
                    ArrayRole::Local(_) => &mut self.locals[to.array.index()][at],
                    ArrayRole::Argument(argument) => panic!("an argument is written: {argument:?}"),
                };
                assert!(place.is_none(), "entry {at} of {to:?} is written twice");
                *place = Some(value);
            }
        }
    }

    fn one_loop(&mut self, one: &ForLoop) -> Result<(), Failed> {
        for carry in &one.carries {
            let init = self.value(&carry.init);
            self.values[carry.exit.index()] = Some(init);
        }
        let mut repetitions: Vec<usize> = (0..one.repetitions).collect();
        if one.inward {
            repetitions.reverse();
        }
        for repetition in repetitions {
            self.repetition = repetition;
            for carry in &one.carries {
                self.values[carry.phi.index()] = self.values[carry.exit.index()];
            }
            self.steps(&one.body)?;
            let next: Vec<S> = one.carries.iter().map(|carry| self.value(&carry.next)).collect();
            for (carry, next) in one.carries.iter().zip(next) {
                self.values[carry.exit.index()] = Some(next);
            }
        }
        Ok(())
    }

    /// Tests pivots first. A pivot that is not finite counts as not finite, not as singular.
    fn finish(&self, finish: &ResultCheck) -> Result<(), Failed> {
        let mut are_numbers = true;
        for test in &finish.pivots {
            let is_lost = match &test.pivot {
                PivotValue::Once(value, scale) => {
                    let (value, scale) = (self.value(value), self.value(scale));
                    are_numbers &= value.is_finite() && scale.is_finite();
                    value.is_lost(scale)
                }
                PivotValue::Repeated(CheckId(check)) => !self.checks[*check],
            };
            if is_lost {
                return Err(Failed::Singular(test.hinge.clone()));
            }
        }
        let is_finite = |witness: &Witness| match witness {
            Witness::Value(value) => self.value(value).is_finite(),
            Witness::Entry(array, entry) => self.whole(*array)[*entry].is_finite(),
            Witness::Array(array) => self.whole(*array).iter().all(|x| x.is_finite()),
        };
        let are_stored =
            finish.unless_bounded.iter().all(|&array| is_finite(&Witness::Array(array)));
        let are_numbers = are_numbers && are_stored && finish.finite.iter().all(is_finite);
        if are_numbers { Ok(()) } else { Err(Failed::NotFinite) }
    }

    fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Let(value, operation) => {
                let is_pack = |operand: &Operand| {
                    operand.value().is_some_and(|value| self.packs.contains_key(&value))
                };
                if !operation.operands().into_iter().flatten().any(is_pack) {
                    return self.set(*value, self.operation(operation));
                }
                let of_lane = |lane| {
                    self.lane = lane;
                    self.operation(operation)
                };
                let lanes = (0..PACK).map(of_lane).collect();
                self.packs.insert(*value, lanes);
            }
            Statement::Pack { pack, values } => {
                assert_eq!(values.len(), PACK);
                let lanes = values.iter().map(|value| self.value(value)).collect();
                self.packs.insert(*pack, lanes);
            }
            Statement::Lane { value, pack, lane, negative } => {
                let found = self.packs[pack][*lane];
                self.set(*value, if *negative { -found } else { found });
            }
            Statement::SinCos { sines, cosines, angles } => {
                for (k, angle) in angles.iter().enumerate() {
                    let (sin, cos) = self.value(angle).sine_and_cosine();
                    for (value, result) in [(sines[k], sin), (cosines[k], cos)] {
                        if let Some(value) = value {
                            self.set(value, result);
                        }
                    }
                }
            }
        }
    }

    fn set(&mut self, value: ValueId, result: S) {
        self.values[value.index()] = Some(result);
    }

    fn operation(&self, operation: &Operation) -> S {
        let value = |operand: &Operand| self.value(operand);
        let product_sum = |a: S, b: S, c: S| S::product_sum(a, b, c, self.arrays.fused);
        match operation {
            Operation::Sum(a, b) => value(a) + value(b),
            Operation::Difference(a, b) => value(a) - value(b),
            Operation::Product(a, b) => value(a) * value(b),
            Operation::MulAdd(a, b, c) => product_sum(value(a), value(b), value(c)),
            Operation::MulSub(a, b, c) => product_sum(value(a), value(b), -value(c)),
            Operation::MulNegAdd(a, b, c) => product_sum(-value(a), value(b), value(c)),
            Operation::Recip(a) => value(a).recip(),
            Operation::Sqrt(a) => value(a).sqrt(),
            Operation::CopySign(a, b) => value(a).copysign(value(b)),
            Operation::Atan2(a, b) => value(a).angle(value(b)),
            Operation::RecipAbove(a, b) => value(a).recip_above(value(b)),
        }
    }

    fn value(&self, operand: &Operand) -> S {
        match operand {
            Operand::Number(number) => S::number(*number),
            Operand::Minus(value) => -self.value(&Operand::Value(*value)),
            Operand::Value(value) => {
                if let Some(lanes) = self.packs.get(value) {
                    return lanes[self.lane];
                }
                let text = self.procedure.values.text(*value);
                self.values[value.index()].unwrap_or_else(|| panic!("`{text}` has no value"))
            }
        }
    }
}
