//! A function of a chain: edges into the chain's graph, with the loops, outputs and names that they belong to. Passes map
//! a function to a function.

mod adjoint;
mod dependence;
mod share_carries;
mod substitute;
mod tracer;
mod unknowns;

pub use adjoint::gradient;
pub use dependence::{Dependence, SymbolDependences};
pub use share_carries::share_carries;
pub use substitute::substitute;
pub use tracer::LoopTracer;
pub use unknowns::{Unknown, Unknowns};

use crate::expr::{Edge, Graph, Stage};
use crate::ids::{RepeatId, SymbolId};
use crate::program::{ArrayLayout, OutputId};
use std::ops::Range;
use std::rc::Rc;

/// A function to be compiled.
#[derive(Clone, Debug)]
pub struct Function<'g> {
    /// The graph of its formulas.
    pub graph: &'g Graph,
    /// The unknowns that the formulas may depend on, in addition to loop-carried values.
    pub unknowns: &'g Unknowns,
    /// The stage at which it is evaluated; values that are known earlier are read from slots.
    pub stage: Stage,
    /// The headings with the values that they name, in the order of the equations.
    pub headings: Vec<Heading>,
    /// The loops over repeated parts, in the order in which they run.
    pub loops: Vec<Loop>,
    /// The number of loops that run before it reads the factor of a product.
    pub loops_before_factor: usize,
    /// The arrays that it returns.
    pub outputs: Vec<Output>,
    /// The divisors that may vanish.
    pub pivots: Vec<NamedPivot>,
}

/// Named values under a heading.
#[derive(Clone, Debug)]
pub struct Heading {
    /// The prefix of the names of unnamed values under it.
    pub prefix: Rc<str>,
    /// The title: what is computed.
    pub title: Rc<str>,
    /// The source of the equations.
    pub source: Rc<str>,
    /// The names, each with its value.
    pub values: Vec<(String, Edge)>,
}

/// A loop over a repeated part.
#[derive(Clone, Debug)]
pub struct Loop {
    /// The repeated part.
    pub repeat: RepeatId,
    /// Whether it runs from the last repetition to the first.
    pub inward: bool,
    /// The values that it carries from one repetition to the next.
    pub carries: Vec<Carry>,
}

/// A loop-carried value.
#[derive(Clone, Copy, Debug)]
pub struct Carry {
    /// The value at the start of the first repetition.
    pub init: Edge,
    /// The value at the end of a repetition.
    pub next: Edge,
    /// The unknown for the value at the start of a repetition.
    pub phi: SymbolId,
    /// The unknown for the value after the last repetition.
    pub exit: SymbolId,
}

/// An array that a function returns.
#[derive(Clone, Debug)]
pub struct Output {
    /// Its id.
    pub id: OutputId,
    /// The layout of the array.
    pub layout: ArrayLayout,
    /// Its entries; an entry of a repeated part is the formula for all repetitions.
    pub values: Vec<Edge>,
    /// When its entries are written.
    pub written: Written,
}

/// When the entries of an output are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Written {
    /// All together at the end.
    Together,
    /// Each as soon as it is known.
    ByEntry,
    /// Each as soon as it is known. Entries that are the same in every state are written when the array is created; no
    /// other function may write it.
    ByEntryOnceIfConstant,
}

/// A divisor that may vanish, with its hinge.
#[derive(Clone, Debug)]
pub struct NamedPivot {
    /// The name of the hinge that it belongs to.
    pub hinge: String,
    /// The divisor.
    pub value: Edge,
    /// The scale of its rounding error, which is a few units in the last place of this value.
    pub scale: Edge,
}

impl Function<'_> {
    /// Iterates over the entries of all outputs, in order.
    pub fn results(&self) -> impl Iterator<Item = Edge> + '_ {
        self.outputs.iter().flat_map(|output| output.values.iter().copied())
    }

    /// Returns the range of an output's entries among the [`results`](Self::results).
    pub fn entries_of(&self, id: OutputId) -> Range<usize> {
        let mut start = 0;
        for output in &self.outputs {
            if output.id == id {
                return start..start + output.values.len();
            }
            start += output.values.len();
        }
        bug!("a function has no output `{}`", id.name)
    }

    /// Iterates over what the function returns or tests: results, pivots and their scales.
    pub fn ends(&self) -> impl Iterator<Item = Edge> + '_ {
        let pivots = self.pivots.iter().flat_map(|pivot| [pivot.value, pivot.scale]);
        self.results().chain(pivots)
    }

    /// Iterates over all roots: the ends and the loop-carried values. Passes must take the roots from here.
    pub fn roots(&self) -> impl Iterator<Item = Edge> + '_ {
        let carries = self.loops.iter().flat_map(|loop_| &loop_.carries);
        self.ends().chain(carries.flat_map(|carry| [carry.init, carry.next]))
    }

    /// Replaces every edge by its image. A named value without an image is dropped; a root must have one.
    pub fn map(mut self, image: impl Fn(Edge) -> Option<Edge>) -> Self {
        let root = |edge: Edge| match image(edge) {
            Some(image) => image,
            None => bug!("a root of a function has no image"),
        };
        for heading in &mut self.headings {
            let values = std::mem::take(&mut heading.values);
            let images = values.into_iter().filter_map(|(name, edge)| Some((name, image(edge)?)));
            heading.values = images.collect();
        }
        for carry in self.loops.iter_mut().flat_map(|loop_| &mut loop_.carries) {
            (carry.init, carry.next) = (root(carry.init), root(carry.next));
        }
        for output in &mut self.outputs {
            output.values.iter_mut().for_each(|edge| *edge = root(*edge));
        }
        for pivot in &mut self.pivots {
            (pivot.value, pivot.scale) = (root(pivot.value), root(pivot.scale));
        }
        self
    }
}
