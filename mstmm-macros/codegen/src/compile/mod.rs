//! From a model to its procedures: the equations written down, simplified and ordered.

mod compiler;
mod function_table;
pub mod layouts;
pub mod outputs;
mod pipeline;
mod point_storage;
mod text;
mod unknowns;

pub use point_storage::{PointStorage, StoredFramedVector, StoredPoint, StoredVector};
pub use text::chain_text;

use crate::examine::Findings;
use crate::expr::Graph;
use crate::function::Unknowns;
use crate::model::{Answer, Chain, Check, Layout, SolutionMethod};
use crate::passes::SetupSlots;
use crate::program::Procedure;
use compiler::ChainCompiler;
use function_table::{FUNCTIONS, FunctionSpec};

/// Everything that is computed for a chain.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// The unknowns that all functions read.
    pub unknowns: Unknowns,
    /// The method that the accelerations are solved with.
    pub method: SolutionMethod,
    /// The functions, in the order of [`Answer::ALL`].
    pub functions: Vec<CompiledFunction>,
    /// Parameters and constants to the slots of all functions, and to the numbers of [`Compiled::checks`].
    pub setup: CompiledFunction,
    /// Numbers that are known at run time only, and what they must be.
    pub checks: Vec<Check>,
    /// Where connection points have their numbers.
    pub point_storage: PointStorage,
}

/// A function of a chain.
#[derive(Clone, Debug)]
pub struct CompiledFunction {
    /// What it answers; the setup answers nothing.
    pub answer: Option<Answer>,
    /// Its procedure.
    pub procedure: Procedure,
}

impl Compiled {
    /// A function that the chain may lack.
    pub fn find(&self, answer: Answer) -> Option<&CompiledFunction> {
        self.functions.iter().find(|function| function.answer == Some(answer))
    }

    /// A function that every chain has.
    pub fn function(&self, answer: Answer) -> &CompiledFunction {
        match self.find(answer) {
            Some(function) => function,
            None => bug!("the chain has no {answer:?}"),
        }
    }
}

impl CompiledFunction {
    /// Its name.
    pub fn name(&self) -> &'static str {
        self.answer.map_or("setup", Answer::name)
    }
}

/// Writes down, simplifies and orders all equations of `chain`, of which `findings` are known.
pub fn compile(chain: &Chain, findings: &Findings, layout: &Layout) -> Compiled {
    specs(chain, findings, layout, |compiler, specs| {
        let mut setup = SetupSlots::default();
        let mut storage = PointStorage::default();
        let mut ordered = Vec::new();
        // One after the other: which nodes are there already decides the order of operands.
        for spec in specs {
            let traced = (spec.trace)(compiler);
            storage = traced.storage.unwrap_or(storage);
            ordered.push((spec, pipeline::order(traced.function, &mut setup)));
        }
        let checks = chain.checks();
        let of_setup = pipeline::order(compiler.setup(&setup, &checks), &mut SetupSlots::default());
        let finish = |answer, ordered, tests| CompiledFunction {
            answer,
            procedure: pipeline::finish(ordered, tests, &setup),
        };
        let setup_function = finish(None, of_setup, None);
        let functions = ordered.into_iter();
        let functions =
            functions.map(|(spec, ordered)| finish(Some(spec.answer), ordered, spec.checks));
        Compiled {
            unknowns: compiler.unknowns().clone(),
            method: compiler.method(),
            functions: functions.collect(),
            setup: setup_function,
            checks,
            point_storage: storage,
        }
    })
}

/// The specs of the functions that a chain has, for `read` to run on its equations.
fn specs<R>(
    chain: &Chain,
    findings: &Findings,
    layout: &Layout,
    read: impl FnOnce(&ChainCompiler, Vec<&'static FunctionSpec>) -> R,
) -> R {
    let unknowns = unknowns::unknowns(chain, layout, findings.closure_rank);
    let merged = Layout::merged(chain);
    let graph = Graph::default();
    let compiler = ChainCompiler::new((chain, findings), (layout, &merged), &unknowns, &graph);
    read(&compiler, FUNCTIONS.iter().filter(|spec| (spec.when)(chain, findings, layout)).collect())
}
