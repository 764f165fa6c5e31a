//! A function as a value: edges into the graph of a chain, and what gives them a meaning. The passes that simplify and
//! arrange it map a function to a function.

mod tracer;
mod unknowns;

pub use tracer::LoopTracer;
pub use unknowns::{Unknown, Unknowns};

use crate::expr::{Edge, Graph, Stage};
use crate::ids::RepeatId;
use crate::program::{ArrayLayout, OutputId};
use std::ops::Range;

/// What is to be computed.
#[derive(Clone, Debug)]
pub struct Function<'g> {
    /// The formulas.
    pub graph: &'g Graph,
    /// What they may depend on, besides what loops carry.
    pub unknowns: &'g Unknowns,
    /// When it is computed. What is known earlier is read from a slot.
    pub stage: Stage,
    /// Headings with the values that they name, in the order of the equations.
    pub headings: Vec<Heading>,
    /// Loops over repeated parts, in the order in which they run.
    pub loops: Vec<Loop>,
    /// What it returns.
    pub outputs: Vec<Output>,
    /// Numbers that it divides by and that may vanish.
    pub pivots: Vec<NamedPivot>,
}

/// Named values under a heading.
#[derive(Clone, Debug)]
pub struct Heading {
    /// What names within it begin with.
    pub prefix: String,
    /// What is computed.
    pub title: String,
    /// Where the equations are from.
    pub source: String,
    /// Names and values.
    pub values: Vec<(String, Edge)>,
}

/// A loop over a repeated part.
#[derive(Clone, Debug)]
pub struct Loop {
    /// Which part.
    pub repeat: RepeatId,
    /// Whether it goes from the last repetition to the first.
    pub inward: bool,
    /// What it carries.
    pub carries: Vec<Carry>,
}

/// A number that a loop carries from one repetition to the next.
#[derive(Clone, Copy, Debug)]
pub struct Carry {
    /// What the first repetition begins with.
    pub init: Edge,
    /// What any repetition hands on.
    pub next: Edge,
    /// Number of the unknown that any repetition begins with.
    pub phi: u32,
    /// Number of the unknown that the last repetition leaves.
    pub exit: u32,
}

/// An array that a function returns.
#[derive(Clone, Debug)]
pub struct Output {
    /// Which one.
    pub id: OutputId,
    /// Where its numbers lie.
    pub layout: ArrayLayout,
    /// Its entries; those of a repeated part stand for all repetitions.
    pub values: Vec<Edge>,
    /// Whether entries are written one by one, as soon as they are known, and those that are the same in every
    /// state where the array is made.
    pub by_entry: bool,
}

/// A number that is divided by and that may vanish.
#[derive(Clone, Debug)]
pub struct NamedPivot {
    /// Name of the hinge that it belongs to.
    pub hinge: String,
    /// The number.
    pub value: Edge,
    /// What it is measured by: rounding leaves a few units in the last place of this number.
    pub scale: Edge,
}

impl Function<'_> {
    /// All that is returned: the numbers of all outputs in their order.
    pub fn results(&self) -> impl Iterator<Item = Edge> + '_ {
        self.outputs.iter().flat_map(|output| output.values.iter().copied())
    }

    /// The numbers of an output among [`results`](Self::results).
    pub fn numbers_of(&self, id: OutputId) -> Range<usize> {
        let mut start = 0;
        for output in &self.outputs {
            if output.id == id {
                return start..start + output.values.len();
            }
            start += output.values.len();
        }
        bug!("a function has no output `{}`", id.name)
    }

    /// What is needed in the end: results, pivots and what they are measured by.
    pub fn ends(&self) -> impl Iterator<Item = Edge> + '_ {
        let pivots = self.pivots.iter().flat_map(|pivot| [pivot.value, pivot.scale]);
        self.results().chain(pivots)
    }

    /// All that has to be computed: the ends, and what loops carry. Nothing else may list roots.
    pub fn roots(&self) -> impl Iterator<Item = Edge> + '_ {
        let carries = self.loops.iter().flat_map(|one| &one.carries);
        self.ends().chain(carries.flat_map(|carry| [carry.init, carry.next]))
    }

    /// The same function with other edges: those that a section names are dropped where there is none.
    pub fn map(mut self, image: impl Fn(Edge) -> Option<Edge>) -> Self {
        let root = |edge: Edge| match image(edge) {
            Some(image) => image,
            None => bug!("a root of a function has no image"),
        };
        for heading in &mut self.headings {
            let values = std::mem::take(&mut heading.values);
            let moved = values.into_iter().filter_map(|(name, edge)| Some((name, image(edge)?)));
            heading.values = moved.collect();
        }
        for carry in self.loops.iter_mut().flat_map(|one| &mut one.carries) {
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
