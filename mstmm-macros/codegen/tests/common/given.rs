//! What functions of a chain are given.

use super::interpreter::{Arrays, Failed, Judge, run};
use mstmm_codegen::compile::{Compiled, outputs};
use mstmm_codegen::model::Answer;
use mstmm_codegen::program::{Argument, ArrayRole};

/// A chain with what its functions are given.
pub struct Given<'a, S> {
    pub compiled: &'a Compiled,
    pub arrays: Arrays<S>,
}

impl<'a, S: Judge> Given<'a, S> {
    /// `unknowns` are all of them in their order, for a chain without repeated parts; its setup has been run.
    pub fn new(compiled: &'a Compiled, unknowns: &[S]) -> Self {
        let mut arrays = Arrays::default();
        arrays.arguments.insert(Argument::Time, vec![S::zero()]);
        for (argument, _) in compiled.unknowns.arguments() {
            let range = compiled.unknowns.of(argument);
            arrays.arguments.insert(argument, unknowns[range].to_vec());
        }
        let mut given = Given { compiled, arrays };
        given.set_up();
        given
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

/// What the setup has derived, as what other functions are given.
pub fn slots<S: Judge>(compiled: &Compiled, arrays: &Arrays<S>) -> Vec<(Argument, Vec<S>)> {
    let ids = compiled.setup.procedure.arrays.iter().filter_map(|array| match array.role {
        ArrayRole::Result(id) if id == outputs::slots(id.part) => Some(id),
        _ => None,
    });
    ids.map(|id| (Argument::Slots(id.part), arrays.result(id))).collect()
}
