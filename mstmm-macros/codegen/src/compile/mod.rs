//! Compiles a model to procedures: traces the equations, simplifies the functions and orders their statements.

mod closure_jacobian;
mod compiler;
mod derivatives;
mod function_table;
mod inverse_dynamics;
mod kinematics;
pub mod layouts;
mod limbs;
mod mass_matrix;
mod momentum;
pub mod outputs;
mod pipeline;
mod point_storage;
mod pull;
mod push;
mod rate_paths;
mod regressor;
mod solution;
mod text;
mod unknowns;

pub use point_storage::{PointStorage, StoredFramedVector, StoredPoint, StoredVector};
pub use rate_paths::RatePaths;
pub use text::chain_text;

use crate::examine::Findings;
use crate::expr::Graph;
use crate::function::Unknowns;
use crate::model::{Answer, BodyId, Chain, Check, Layout, SolutionMethod};
use crate::passes::SetupSlots;
use crate::program::Procedure;
use compiler::ChainCompiler;
use function_table::{FUNCTIONS, FunctionSpec, OF_POINT, is_by_columns};

/// All functions of a chain.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// The unknowns that all functions read.
    pub unknowns: Unknowns,
    /// The method for the accelerations.
    pub method: SolutionMethod,
    /// The functions, in the order of [`Answer::ALL`].
    pub functions: Vec<CompiledFunction>,
    /// The Jacobians of points of bodies at free ends, each with its body.
    pub jacobians: Vec<(BodyId, Procedure)>,
    /// The function from parameters and constants to the slots of all functions and the values of [`Compiled::checks`].
    pub setup: CompiledFunction,
    /// The conditions on values that are known only at run time.
    pub checks: Vec<Check>,
    /// The storage of connection points in the workspace.
    pub point_storage: PointStorage,
}

/// A function of a chain.
#[derive(Clone, Debug)]
pub struct CompiledFunction {
    /// The answer that it computes; none for the setup.
    pub answer: Option<Answer>,
    /// Whether it is a product that a matrix is computed by, several columns at a time.
    pub by_columns: bool,
    /// Its procedure.
    pub procedure: Procedure,
    /// The same procedure with limbs of one shape side by side: by [`compile_packed`], if that saves operations.
    pub packed: Option<Procedure>,
}

impl Compiled {
    /// Returns the function for an answer, if the chain has it.
    pub fn find(&self, answer: Answer) -> Option<&CompiledFunction> {
        self.functions.iter().find(|function| function.answer == Some(answer))
    }

    /// Returns the function for an answer that every chain has.
    pub fn function(&self, answer: Answer) -> &CompiledFunction {
        match self.find(answer) {
            Some(function) => function,
            None => bug!("the chain has no {answer:?}"),
        }
    }
}

impl CompiledFunction {
    /// Returns its name.
    pub fn name(&self) -> &'static str {
        self.answer.map_or("setup", Answer::name)
    }
}

/// Compiles all functions of a chain.
pub fn compile(chain: &Chain, findings: &Findings, layout: &Layout) -> Compiled {
    compile_with(chain, findings, layout, false)
}

/// Compiles all functions of a chain, also in the form with limbs of one shape side by side.
pub fn compile_packed(chain: &Chain, findings: &Findings, layout: &Layout) -> Compiled {
    compile_with(chain, findings, layout, true)
}

fn compile_with(chain: &Chain, findings: &Findings, layout: &Layout, is_packed: bool) -> Compiled {
    specs(chain, findings, layout, |compiler, specs| {
        let mut setup = SetupSlots::default();
        let mut storage = PointStorage::default();
        let mut ordered = Vec::new();
        // The order of these calls matters: operands are ordered by the age of their nodes in the shared graph.
        for spec in specs {
            let traced = (spec.trace)(compiler);
            storage = traced.storage.unwrap_or(storage);
            let by_columns = is_by_columns(chain, layout, spec.answer);
            let function = pipeline::order(traced.function, by_columns, &mut setup);
            ordered.push((spec, by_columns, function));
        }
        let order_of = |body, setup: &mut SetupSlots| {
            pipeline::order(compiler.jacobian_of(body).function, false, setup)
        };
        let jacobians = compiler.end_bodies().into_iter();
        let jacobians: Vec<_> = jacobians.map(|body| (body, order_of(body, &mut setup))).collect();
        let checks = chain.checks();
        let of_setup = compiler.setup(&setup, &checks);
        let of_setup = pipeline::order(of_setup, false, &mut SetupSlots::default());
        let limbs = is_packed.then(|| limbs::limbs(chain, layout, &Layout::merged(chain)));
        // The regressor by rates is faster.
        let by_rates = ordered.iter().any(|(spec, ..)| spec.answer == Answer::RegressorMotions);
        let finish = |answer, by_columns, ordered, checks, limbs| {
            let (procedure, packed) = pipeline::finish(ordered, checks, &setup, limbs);
            CompiledFunction { answer, by_columns, procedure, packed }
        };
        let setup_function = finish(None, false, of_setup, None, None);
        let jacobian = |(body, ordered)| {
            let (procedure, _) = pipeline::finish(ordered, OF_POINT, &setup, None);
            (body, procedure)
        };
        let jacobians = jacobians.into_iter().map(jacobian);
        let functions = ordered.into_iter().map(|(spec, by_columns, ordered)| {
            let limbs = limbs.as_ref().filter(|_| !by_rates || spec.answer != Answer::Regressor);
            finish(Some(spec.answer), by_columns, ordered, spec.checks_for(chain), limbs)
        });
        Compiled {
            unknowns: compiler.unknowns().clone(),
            method: compiler.method(),
            functions: functions.collect(),
            jacobians: jacobians.collect(),
            setup: setup_function,
            checks,
            point_storage: storage,
        }
    })
}

/// Calls `read` with the compiler of a chain and the specs of the functions that the chain has.
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
