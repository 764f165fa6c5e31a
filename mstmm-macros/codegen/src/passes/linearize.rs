//! Orders a function: under each heading the live values that its named values need, in the order in which the equations
//! created them.

use super::angles::{Angles, angles};
use super::node_values::NodeValues;
use super::owners::Owners;
use super::select_fma::fused;
use super::{Live, LoopId, Region, Regions, SetupSlots};
use crate::expr::{Edge, Graph, Node, NodeId, Stage};
use crate::function::{Function, Heading, NamedPivot};
use crate::ids::{IdVec, SymbolId, copies};
use crate::program::{Block, BlockId, Program, Section, Slot, Statement, ValueId, ValueNames};
use std::collections::HashMap;

/// Returns the program of a function. A function of stage [`Stage::State`] reads values that are known since setup from
/// slots, which are added to `setup`; a function of stage [`Stage::Setup`] computes them.
pub fn linearize(function: &Function, setup: &mut SetupSlots) -> Program {
    let live = Live::of(function.graph, function.roots());
    let regions = Regions::of(function, &live);
    let mut linearizer = Linearizer::new(function, (live, &regions), setup);
    linearizer.name_carries();
    for (name, edge) in function.headings.iter().flat_map(|heading| &heading.values) {
        linearizer.name_node(name, *edge);
    }
    linearizer.linearize_straight(0);
    for id in regions.loops.ids() {
        linearizer.linearize_loop(id);
        linearizer.linearize_straight(id.index() + 1);
    }
    linearizer.finish()
}

/// The program of a function under construction.
pub(super) struct Linearizer<'a> {
    pub(super) function: &'a Function<'a>,
    pub(super) graph: &'a Graph,
    pub(super) setup: &'a mut SetupSlots,
    pub(super) live: Live,
    pub(super) regions: &'a Regions,
    /// The angles by nesting depth of sines and cosines, and by region.
    pub(super) angles: Angles,
    pub(super) depths: Vec<u32>,
    /// The products that are fused with their sum.
    pub(super) fused: Vec<bool>,
    /// The values of nodes.
    pub(super) names: NodeValues,
    /// The slots of repeated parts, which loops read.
    pub(super) slots: HashMap<NodeId, Slot>,
    /// The blocks of the finished loops.
    pub(super) blocks: HashMap<LoopId, BlockId>,
    /// Whether a node has been computed.
    pub(super) done: Vec<bool>,
    /// The last request that reached a node.
    reached_by: Vec<u32>,
    requests: u32,
    sections: Vec<Section>,
    owners: Owners,
    /// The current section.
    current: usize,
    /// The sections in which nodes have been computed.
    section_of: Vec<Option<usize>>,
    pub(super) program: Program,
    pub(super) temporaries: usize,
}

impl<'a> Linearizer<'a> {
    fn new(
        function: &'a Function<'a>,
        (live, regions): (Live, &'a Regions),
        setup: &'a mut SetupSlots,
    ) -> Self {
        let graph = function.graph;
        let (angles, depths) = angles(graph, &live, regions, function.stage);
        let fused = fused(graph, &live, regions, function.stage);
        let mut names = ValueNames::default();
        names.reserve(function.unknowns.iter().map(|unknown| unknown.name.clone()));
        Linearizer {
            function,
            graph,
            setup,
            live,
            regions,
            angles,
            depths,
            fused,
            names: NodeValues::new(graph.len()),
            blocks: HashMap::new(),
            slots: HashMap::new(),
            done: vec![false; graph.len()],
            reached_by: vec![0; graph.len()],
            requests: 0,
            program: Program {
                names,
                unknowns: Vec::new(),
                slots: Vec::new(),
                blocks: IdVec::new(),
                results: Vec::new(),
                pivots: Vec::new(),
            },
            sections: Vec::new(),
            owners: Owners::of(function),
            current: 0,
            section_of: copies(None, graph.len()),
            temporaries: 0,
        }
    }

    /// Names a node, if it is computed here and has no name yet.
    fn name_node(&mut self, name: &str, edge: Edge) {
        let node = edge.node();
        let computed = !matches!(self.graph.node(node), Node::Number(_) | Node::Symbol(_));
        if computed && self.live.has(node) && self.names.get(node).is_none() {
            let sign = if edge.is_negative() { "minus_" } else { "" };
            let name = self.program.names.fresh(format!("{sign}{name}"));
            self.names.insert(node, name);
        }
    }

    /// Names the loop-carried values.
    fn name_carries(&mut self) {
        for (number, loop_) in self.regions.loops.iter().enumerate() {
            for (place, carry) in loop_.carries.iter().enumerate() {
                let exit = self.program.names.numbered(format!("carry{number}_{place}"));
                let phi = self.program.names.numbered(format!("carry{number}_{place}_before"));
                for (symbol, value) in [(carry.phi, phi), (carry.exit, exit)] {
                    if let Some(node) = self.graph.find(Node::Symbol(symbol)) {
                        self.names.insert(node, value);
                    }
                }
            }
        }
    }

    /// Returns the value of a loop-carried symbol.
    pub(super) fn carried(&self, symbol: SymbolId) -> ValueId {
        match self.graph.find(Node::Symbol(symbol)) {
            Some(node) => self.value(node),
            None => bug!("a loop carries a symbol that is not in the graph"),
        }
    }

    /// Returns whether a node is live and computed in `region`.
    fn belongs(&self, node: NodeId, region: Region) -> bool {
        let is_known =
            self.is_slot(node) && matches!(self.regions.region(node), Region::AfterLoops(_));
        self.live.has(node) && (is_known || self.regions.region(node) == region)
    }

    /// Computes the values of `region`, each under the first heading that needs it, then the values that no heading needs in
    /// the same repetition.
    pub(super) fn linearize_region(&mut self, region: Region, rest: Vec<NodeId>) {
        let headings = &self.function.headings;
        let mut early = vec![Vec::new(); headings.len()];
        for &node in &rest {
            if let Some(number) = self.owners.same(node) {
                early[number].push(node);
            }
        }
        for (heading, early) in headings.iter().zip(early) {
            self.open(heading);
            let values = heading.values.iter().map(|(_, edge)| edge.node());
            for node in values.chain(early) {
                if self.belongs(node, region) {
                    self.require(node);
                }
            }
        }
        let (prefix, title) = ("result".into(), "Results".into());
        self.open(&Heading { prefix, title, source: "".into(), values: Vec::new() });
        for node in rest {
            if self.belongs(node, region) && !self.done[node as usize] {
                self.current = self.section_for(node, region).unwrap_or(headings.len());
                self.require(node);
            }
        }
    }

    /// Returns the section of a value that no heading needs in the same repetition: the last section that it reads, or else
    /// the first that needs it in another repetition. Its operands must have been computed; if an angle of the same
    /// `SinCos` statement has not been computed, there is no section.
    fn section_for(&self, node: NodeId, region: Region) -> Option<usize> {
        if self.regions.loops.is_empty() {
            return None;
        }
        let partners = match self.graph.node(node) {
            Node::Sin(_) | Node::Cos(_) => self.angles.get(&(self.depths[node as usize], region)),
            _ => None,
        };
        let partners = || partners.into_iter().flatten().copied();
        if partners().any(|angle| self.belongs(angle, region) && !self.done[angle as usize]) {
            return None;
        }
        let read = self.graph.node(node).operands().map(Edge::node).chain(partners());
        let here = read.filter(|&id| !self.is_slot(id) && self.regions.region(id) == region);
        here.filter_map(|id| self.section_of[id as usize]).max().or(self.owners.any(node))
    }

    /// Computes what runs outside of loops after this number of loops.
    fn linearize_straight(&mut self, done: usize) {
        // Without loops the ends reach every node that is needed; values that loops read may be any node.
        let rest: Vec<NodeId> = if self.regions.loops.is_empty() {
            self.function.ends().map(|edge| edge.node()).collect()
        } else {
            self.live.nodes().to_vec()
        };
        self.linearize_region(Region::AfterLoops(done), rest);
        let sections = self.take_sections();
        if !sections.is_empty() {
            self.program.blocks.push(Block::Once(sections));
        }
    }

    pub(super) fn take_sections(&mut self) -> Vec<Section> {
        let mut sections = std::mem::take(&mut self.sections);
        sections.retain(|section| !section.statements.is_empty());
        sections
    }

    fn open(&mut self, heading: &Heading) {
        self.current = self.sections.len();
        self.sections.push(Section {
            prefix: heading.prefix.clone(),
            title: heading.title.clone(),
            source: heading.source.clone(),
            statements: Vec::new(),
        });
    }

    /// Returns the prefix of names in the current section.
    pub(super) fn prefix(&self) -> &str {
        self.sections.get(self.current).map_or("result", |section| &section.prefix)
    }

    pub(super) fn push(&mut self, statement: Statement) {
        match self.sections.get_mut(self.current) {
            Some(section) => section.statements.push(statement),
            None => bug!("a statement belongs to no section"),
        }
    }

    /// Returns whether a node is read from a slot.
    pub(super) fn is_slot(&self, node: NodeId) -> bool {
        self.function.stage == Stage::State && self.graph.stage(node) == Stage::Setup
    }

    /// Computes a node with all nodes that it needs and that have not been computed.
    pub(super) fn require(&mut self, node: NodeId) {
        if self.done[node as usize] {
            return;
        }
        for id in self.needed_for(node) {
            // A `SinCos` statement may have computed some of them meanwhile.
            if !self.done[id as usize] {
                self.mark(id);
                self.compute(id);
            }
        }
    }

    /// Returns the nodes that a node needs and that have not been computed, operands before their users, the node last.
    fn needed_for(&mut self, node: NodeId) -> Vec<NodeId> {
        self.requests += 1;
        let nodes = self.graph.nodes();
        let mut needed = Vec::new();
        let mut open = vec![node];
        while let Some(id) = open.pop() {
            let reached_by = &mut self.reached_by[id as usize];
            if self.done[id as usize] || *reached_by == self.requests {
                continue;
            }
            *reached_by = self.requests;
            needed.push(id);
            if !self.is_slot(id) {
                for operand in nodes[id as usize].operands() {
                    open.push(operand.node());
                }
            }
        }
        // Operands have smaller ids than their users.
        needed.sort_unstable();
        needed
    }

    /// Records that a node is computed in the current section.
    pub(super) fn mark(&mut self, node: NodeId) {
        self.done[node as usize] = true;
        if self.graph.symbol_of(node).is_none() {
            self.section_of[node as usize] = Some(self.current);
        }
    }

    fn finish(mut self) -> Program {
        let function = self.function;
        let result = |edge: Edge| match self.regions.region(edge.node()) {
            Region::Loop(_) => None,
            Region::AfterLoops(_) => Some(self.operand(edge)),
        };
        let results = function.results().map(result).collect();
        let pivot = |pivot: &NamedPivot| match self
            .regions
            .common(pivot.value.node(), pivot.scale.node())
        {
            Region::Loop(_) => None,
            Region::AfterLoops(_) => Some((self.operand(pivot.value), self.operand(pivot.scale))),
        };
        let pivots = function.pivots.iter().map(pivot).collect();
        self.program.unknowns.sort_unstable();
        (self.program.results, self.program.pivots) = (results, pivots);
        self.program
    }
}
