//! Lowers a program to a procedure: adds loads, tests and stores.

use super::SetupSlots;
use super::bounds::bounds;
use crate::function::{Function, Output, Written};
use crate::ids::{IdVec, RepeatId, SymbolId};
use crate::program::{
    Argument, Array, ArrayId, ArrayLayout, ArrayRole, ArraySlice, Block, BlockId, CheckId, Failure,
    Finiteness, ForLoop, LoopBlock, Operand, OutputId, PivotTest, PivotValue, Procedure, Program,
    Repetition, ResultCheck, Segment, Slot, Step, ValueId, Witness,
};

/// The tests of a function.
#[derive(Clone, Copy, Debug)]
pub struct Checks {
    /// The outputs that must be finite, together with all values that they depend on.
    pub finite: &'static [OutputId],
    /// The contents of the results after a failure.
    pub failure: Failure,
    /// Whether all coordinates, rates and inputs are tested, also those that the function does not read.
    pub unread: bool,
}

/// Adds loads, tests and stores to the program of a function. `setup` has the slots of all functions.
pub fn lower(
    program: Program,
    function: &Function,
    checks: Option<Checks>,
    setup: &SetupSlots,
) -> Procedure {
    let mut lowering = Lowering {
        program: &program,
        looped: program.loops().next().is_some(),
        function,
        setup,
        arrays: IdVec::new(),
        checks: vec![None; function.pivots.len()],
        check_count: 0,
    };
    lowering.number_checks();
    let mut body = Vec::new();
    let finiteness = checks.map(|checks| {
        let entries = checks.finite.iter().map(|&id| function.entries_of(id));
        program.finiteness(&entries.collect::<Vec<_>>())
    });
    if let (Some(checks), Some(finiteness)) = (checks, &finiteness) {
        body.extend(lowering.check_arguments(checks, finiteness));
    }
    body.extend(lowering.loads(None, &program.unknowns, &program.slots));
    let bounds = checks.zip(finiteness.as_ref()).and_then(|(checks, finiteness)| {
        bounds(&program, function, (checks.finite, checks.failure), finiteness)
    });
    let is_bounded = bounds.is_some();
    body.extend(bounds.map(Step::TestBounds));
    for (number, block) in program.blocks.enumerate() {
        match block {
            Block::Once(sections) => body.extend(sections.iter().cloned().map(Step::Compute)),
            Block::Loop(loop_) => {
                let loop_ = lowering.lower_loop(number, loop_);
                body.push(Step::Loop(loop_));
            }
        }
    }
    let stores = lowering.stores(checks.map(|checks| checks.failure));
    let finish = checks
        .zip(finiteness)
        .map(|(checks, finiteness)| lowering.check_results(checks, &finiteness, is_bounded));
    // A result array is checked as a whole after it has been written.
    if lowering.looped || is_bounded {
        body.extend(stores.into_iter().chain(finish));
    } else {
        body.extend(finish.into_iter().chain(stores));
    }
    let (arrays, checked) = (lowering.arrays, lowering.check_count);
    let failure = checks.map_or(Failure::Untouched, |checks| checks.failure);
    Procedure { values: program.names, arrays, checks: checked, failure, body }
}

struct Lowering<'a> {
    program: &'a Program,
    /// Whether the program has loops.
    looped: bool,
    function: &'a Function<'a>,
    setup: &'a SetupSlots,
    arrays: IdVec<ArrayId, Array>,
    /// The tests of pivots in loops, by the pivot's index.
    checks: Vec<Option<CheckId>>,
    check_count: usize,
}

impl Lowering<'_> {
    /// Assigns ids to the tests of pivots in loops.
    fn number_checks(&mut self) {
        for loop_ in self.program.loops() {
            for (pivot, ..) in &loop_.pivots {
                self.checks[*pivot] = Some(CheckId(self.check_count));
                self.check_count += 1;
            }
        }
    }

    /// Returns the array with a role, which is added if it is missing.
    fn array(&mut self, role: ArrayRole, layout: impl FnOnce() -> ArrayLayout) -> ArrayId {
        let known = self.arrays.position(|array| array.role == role);
        known.unwrap_or_else(|| self.arrays.push(Array::new(role, layout())))
    }

    fn argument(&mut self, argument: Argument) -> ArrayId {
        let (unknowns, setup) = (self.function.unknowns, self.setup);
        self.array(ArrayRole::Argument(argument), || match argument {
            Argument::Time => ArrayLayout::once(1),
            Argument::Slots(part) => {
                let count = setup.count(part);
                match part {
                    None => ArrayLayout::once(count),
                    Some(part) => ArrayLayout::each(count, part, unknowns.repetitions(part)),
                }
            }
            _ => unknowns.layout(argument),
        })
    }

    /// Loads unknowns and slots, outside of loops or in a repetition of a part.
    fn loads(
        &mut self,
        part: Option<RepeatId>,
        unknowns: &[(SymbolId, ValueId)],
        slots: &[Slot],
    ) -> Vec<Step> {
        let mut steps = Vec::new();
        if !slots.is_empty() {
            let array = self.argument(Argument::Slots(part));
            let values = slots.iter().map(|slot| (slot.index, slot.value));
            steps.extend(self.load(array, part, &values.collect::<Vec<_>>()));
        }
        let all = self.function.unknowns;
        for (argument, _) in all.arguments() {
            let own = all.of(argument);
            let read = unknowns.iter().filter(|(symbol, _)| own.contains(*symbol));
            let values: Vec<(usize, ValueId)> = read
                .map(|&(symbol, value)| (symbol.index() - own.first().index(), value))
                .collect();
            if !values.is_empty() {
                let array = self.argument(argument);
                steps.extend(self.load(array, part, &values));
            }
        }
        steps
    }

    /// Loads entries of an array into values.
    fn load(
        &self,
        array: ArrayId,
        part: Option<RepeatId>,
        values: &[(usize, ValueId)],
    ) -> Vec<Step> {
        let repetition = if part.is_some() { Repetition::Current } else { Repetition::Only };
        let load = |(segment, into)| Step::Load {
            from: ArraySlice { array, segment, first: 0, repetition },
            into,
        };
        by_segment(&self.arrays[array].layout, values).map(load).collect()
    }

    /// Lowers a loop.
    fn lower_loop(&mut self, block: BlockId, loop_: &LoopBlock) -> ForLoop {
        let repetitions = self.function.unknowns.repetitions(loop_.repeat);
        let mut body = self.loads(Some(loop_.repeat), &loop_.unknowns, &loop_.slots);
        for (from, values) in &loop_.loads {
            let Block::Loop(earlier) = &self.program.blocks[*from] else {
                bug!("a loop loads values of a block that is no loop")
            };
            let wanted = |value: &ValueId| values.contains(value).then_some(*value);
            let from = self.local(*from, earlier);
            let into = earlier.stores.iter().map(wanted).collect();
            body.push(Step::Load { from, into });
        }
        body.extend(loop_.sections.iter().cloned().map(Step::Compute));
        if !loop_.stores.is_empty() {
            let to = self.local(block, loop_);
            let values = loop_.stores.iter().map(|&value| Some(Operand::Value(value))).collect();
            body.push(Step::Store { to, values });
        }
        for output in &self.function.outputs {
            body.extend(self.store_of_loop(output, loop_));
        }
        for (pivot, value, scale) in &loop_.pivots {
            let Some(check) = self.checks[*pivot] else { bug!("a pivot of a loop has no test") };
            let (value, scale) = (*value, *scale);
            body.push(Step::CheckPivot { check, value, scale });
        }
        let (repeat, inward, carries) = (loop_.repeat, loop_.inward, loop_.carries.clone());
        ForLoop { repeat, repetitions, inward, carries, body }
    }

    /// Returns the slice of the array in which a loop stores values for later loops.
    fn local(&mut self, block: BlockId, loop_: &LoopBlock) -> ArraySlice {
        let repetitions = self.function.unknowns.repetitions(loop_.repeat);
        let layout = || ArrayLayout::each(loop_.stores.len(), loop_.repeat, repetitions);
        let array = self.array(ArrayRole::Local(block), layout);
        ArraySlice { array, segment: 0, first: 0, repetition: Repetition::Current }
    }

    fn result(&mut self, output: &Output) -> ArrayId {
        self.array(ArrayRole::Result(output.id), || output.layout.clone())
    }

    /// Stores the entries of an output that a loop computes.
    fn store_of_loop(&mut self, output: &Output, loop_: &LoopBlock) -> Vec<Step> {
        let numbers = self.function.entries_of(output.id);
        let own = loop_.results.iter().filter(|(number, _)| numbers.contains(number));
        let values: Vec<(usize, Operand)> =
            own.map(|(number, value)| (number - numbers.start, *value)).collect();
        if values.is_empty() {
            return Vec::new();
        }
        let array = self.result(output);
        let store = |(segment, values)| Step::Store {
            to: ArraySlice { array, segment, first: 0, repetition: Repetition::Current },
            values,
        };
        by_segment(&output.layout, &values).map(store).collect()
    }

    /// Stores the results that no loop computes.
    fn stores(&mut self, failure: Option<Failure>) -> Vec<Step> {
        let mut steps = Vec::new();
        for output in &self.function.outputs {
            let array = self.result(output);
            let results = &self.program.results[self.function.entries_of(output.id)];
            let is_early = failure.is_some_and(Failure::allows_early_stores);
            let by_entry = output.written != Written::Together && is_early && !self.looped;
            let constants_once = output.written == Written::ByEntryOnceIfConstant;
            for (number, segment) in output.layout.segments.iter().enumerate() {
                let entries = &results[segment.entries()];
                let repetition =
                    if segment.repeat.is_some() { Repetition::All } else { Repetition::Only };
                let kept = by_entry && segment.repeat.is_none();
                let slice = |first: usize| ArraySlice { array, segment: number, first, repetition };
                if !kept {
                    if entries.iter().any(Option::is_some) {
                        steps.push(Step::Store { to: slice(0), values: entries.to_vec() });
                    }
                    continue;
                }
                for (first, value) in entries.iter().enumerate() {
                    match value {
                        Some(Operand::Number(known)) if constants_once => {
                            self.arrays[array].initial.push((segment.offset + first, *known));
                        }
                        Some(_) => {
                            let values = vec![*value];
                            steps.push(Step::Store { to: slice(first), values });
                        }
                        None => bug!("a result is missing"),
                    }
                }
            }
        }
        steps
    }

    /// Returns whether an argument has entries of repeated parts. Such an array is tested as a whole.
    fn has_repeated(&self, argument: Argument) -> bool {
        let mut arguments = self.function.unknowns.arguments();
        let layout = arguments.find(|(other, _)| *other == argument).map(|(_, layout)| layout);
        layout.is_some_and(|it| it.segments.iter().any(|segment| segment.repeat.is_some()))
    }

    /// Returns whether the program reads an argument.
    fn is_read(&self, argument: Argument) -> bool {
        self.function.unknowns.of(argument).into_iter().any(|symbol| self.reads(symbol))
    }

    fn reads(&self, symbol: SymbolId) -> bool {
        let of_loops = self.program.loops().flat_map(|loop_| &loop_.unknowns);
        self.program.unknowns.iter().chain(of_loops).any(|(read, _)| *read == symbol)
    }

    /// Tests the inputs and the caller's vectors that no result covers, and also the coordinates and rates if there are loops or repeated parts.
    fn check_arguments(&mut self, checks: Checks, finiteness: &Finiteness) -> Option<Step> {
        let unknowns = self.function.unknowns;
        let arguments: Vec<Argument> = unknowns.arguments().map(|(argument, _)| argument).collect();
        let is_tested = |argument: &Argument| match argument {
            Argument::Input(_) => checks.unread || self.is_read(*argument),
            Argument::Coordinates | Argument::Rates => self.looped || self.has_repeated(*argument),
            Argument::Given(_) => self.is_read(*argument),
            _ => false,
        };
        let is_uncovered = |argument: &Argument| {
            let mut symbols = unknowns.of(*argument).into_iter();
            symbols.any(|symbol| !finiteness.covered.contains(&symbol))
        };
        let uncovered = arguments.into_iter().filter(is_tested).filter(is_uncovered);
        let arrays: Vec<ArrayId> =
            uncovered.collect::<Vec<_>>().into_iter().map(|it| self.argument(it)).collect();
        (!arrays.is_empty()).then_some(Step::CheckArguments(arrays))
    }

    /// Returns the check of the results: the pivots, the time, the arguments that no result covers, and the results that
    /// no other result covers.
    fn check_results(&mut self, checks: Checks, finiteness: &Finiteness, is_bounded: bool) -> Step {
        let mut unless_bounded = Vec::new();
        let mut finite = vec![Witness::Entry(self.argument(Argument::Time), 0)];
        if self.looped {
            finite.extend(self.results_of_loops(checks.finite));
        } else {
            let state = [Argument::Coordinates, Argument::Rates];
            for argument in state {
                let is_there = self.function.unknowns.has(argument);
                if !is_there || self.has_repeated(argument) {
                    continue;
                }
                let symbols = self.function.unknowns.of(argument).into_iter().enumerate();
                let is_tested = |symbol: &SymbolId| {
                    let is_tested = checks.unread || self.reads(*symbol);
                    is_tested && !finiteness.covered.contains(symbol)
                };
                let tested: Vec<usize> = symbols
                    .filter(|(_, symbol)| is_tested(symbol))
                    .map(|(entry, _)| entry)
                    .collect();
                for entry in tested {
                    finite.push(Witness::Entry(self.argument(argument), entry));
                }
            }
            if is_bounded {
                for &id in checks.finite {
                    let found = self.arrays.position(|array| array.role == ArrayRole::Result(id));
                    unless_bounded.push(found.unwrap_or_else(|| bug!("a result is not stored")));
                }
            } else {
                let witnesses = finiteness.witnesses.iter();
                finite.extend(witnesses.map(|&value| Witness::Value(*value)));
            }
        }
        let pivots = self.function.pivots.iter().enumerate().map(|(number, pivot)| {
            let found = match (&self.program.pivots[number], self.checks[number]) {
                (Some((value, scale)), _) => PivotValue::Once(*value, *scale),
                (None, Some(check)) => PivotValue::Repeated(check),
                (None, None) => bug!("a pivot is not tested"),
            };
            PivotTest { hinge: pivot.hinge.clone(), pivot: found }
        });
        Step::CheckResults(ResultCheck { pivots: pivots.collect(), finite, unless_bounded })
    }

    /// Returns the results of a program with loops that must be finite: values, and arrays with entries of repeated parts.
    fn results_of_loops(&self, ids: &[OutputId]) -> Vec<Witness> {
        let witnesses = ids.iter().flat_map(|&id| {
            let role = ArrayRole::Result(id);
            let array = self.arrays.position(|array| array.role == role);
            let is_repeated = |id: &ArrayId| {
                self.arrays[*id].layout.segments.iter().any(|segment| segment.repeat.is_some())
            };
            match array.filter(is_repeated) {
                Some(array) => vec![Witness::Array(array)],
                None => {
                    let values = &self.program.results[self.function.entries_of(id)];
                    values.iter().flatten().cloned().map(Witness::Value).collect()
                }
            }
        });
        witnesses.collect()
    }
}

/// Groups entries of an array by segment. Returns the segments with any entries, each with one value per entry of the
/// segment, or none.
fn by_segment<'a, T: Clone>(
    layout: &'a ArrayLayout,
    entries: &'a [(usize, T)],
) -> impl Iterator<Item = (usize, Vec<Option<T>>)> + 'a {
    let of_segment = |(number, segment): (usize, &Segment)| {
        let mut places = vec![None; segment.count];
        for (entry, value) in entries.iter().filter(|(it, _)| segment.entries().contains(it)) {
            places[entry - segment.first] = Some(value.clone());
        }
        places.iter().any(Option::is_some).then_some((number, places))
    };
    layout.segments.iter().enumerate().filter_map(of_segment)
}
