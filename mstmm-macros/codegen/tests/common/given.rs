//! The arguments of a chain's functions.

use super::interpreter::{Arrays, Failed, Judge, run};
use mstmm_codegen::compile::{Compiled, outputs};
use mstmm_codegen::model::{Answer, Chain, InputKind, Layout};
use mstmm_codegen::program::{Argument, ArrayRole};

/// A compiled chain with the arguments of its functions.
pub struct Given<'a, S> {
    pub compiled: &'a Compiled,
    pub arrays: Arrays<S>,
}

impl<'a, S: Judge> Given<'a, S> {
    /// Sets all unknowns of a chain without repeated parts, in order, and runs the setup.
    pub fn new(compiled: &'a Compiled, unknowns: &[S]) -> Self {
        let mut arrays = Arrays::default();
        arrays.arguments.insert(Argument::Time, vec![S::zero()]);
        for (argument, _) in compiled.unknowns.arguments() {
            let range = compiled.unknowns.of(argument);
            arrays.arguments.insert(argument, unknowns[range.indices()].to_vec());
        }
        let mut given = Given { compiled, arrays };
        given.set_up();
        given
    }

    /// Sets all arguments to zero.
    pub fn zeros(compiled: &'a Compiled) -> Self {
        let mut arrays = Arrays::default();
        arrays.arguments.insert(Argument::Time, vec![S::zero()]);
        for (argument, layout) in compiled.unknowns.arguments() {
            arrays.arguments.insert(argument, vec![S::zero(); layout.total]);
        }
        let mut given = Given { compiled, arrays };
        given.set_up();
        given
    }

    /// Sets every value by its argument and index, and runs the setup.
    pub fn fill(&mut self, mut number: impl FnMut(Argument, usize) -> S) {
        for (argument, layout) in self.compiled.unknowns.arguments() {
            let values = (0..layout.total).map(|place| number(argument, place)).collect();
            self.arrays.arguments.insert(argument, values);
        }
        self.set_up();
    }

    /// Normalises the quaternions.
    pub fn normalize(&mut self) {
        let unit = self.run(Answer::Normalized).expect("it cannot fail");
        self.arrays.arguments.insert(Argument::Coordinates, unit.result(outputs::COORDINATES));
    }

    /// Sets the efforts of the motors of all hinges, in the order of `v`; every rate must have a motor.
    pub fn drive(&mut self, chain: &Chain, efforts: &[S]) {
        let layout = Layout::of(chain);
        let rates = self.compiled.unknowns.layout(Argument::Rates);
        for (input, it) in layout.inputs.enumerate() {
            let InputKind::Efforts(hinge) = it.what else { continue };
            let own = layout.v[hinge].clone();
            let segment = rates.segment_of(own.start);
            let first = segment.offset + own.start - segment.first;
            let repetitions = (0..segment.repetitions).map(|k| first + k * segment.count);
            let values = repetitions.flat_map(|at| efforts[at..at + own.len()].to_vec()).collect();
            self.arrays.arguments.insert(Argument::Input(input), values);
        }
    }

    /// Runs the setup.
    pub fn set_up(&mut self) {
        let mut arrays = self.arrays.clone();
        run(&self.compiled.setup.procedure, &mut arrays).expect("a setup cannot fail");
        self.arrays.arguments.extend(slots(self.compiled, &arrays));
    }

    /// Runs a function.
    pub fn run(&self, answer: Answer) -> Result<Arrays<S>, Failed> {
        let mut arrays = self.arrays.clone();
        run(&self.compiled.function(answer).procedure, &mut arrays).map(|()| arrays)
    }
}

/// Moves the slots that the setup has derived to the arguments.
pub fn slots<S: Judge>(compiled: &Compiled, arrays: &Arrays<S>) -> Vec<(Argument, Vec<S>)> {
    let ids = compiled.setup.procedure.arrays.iter().filter_map(|array| match array.role {
        ArrayRole::Result(id) if id == outputs::slots(id.part) => Some(id),
        _ => None,
    });
    ids.map(|id| (Argument::Slots(id.part), arrays.result(id))).collect()
}
