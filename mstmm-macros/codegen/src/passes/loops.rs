//! Linearizes the loops of a function: what each computes in every repetition, what it loads from earlier loops, and what
//! it stores for later ones.

use super::linearize::Linearizer;
use super::{LoopId, Region};
use crate::expr::{Edge, NodeId};
use crate::function;
use crate::ids::SymbolId;
use crate::program::{Block, BlockId, CarriedValue, LoopBlock, Slot, ValueId};

/// What a loop reads in each repetition.
struct LoopReads {
    unknowns: Vec<(SymbolId, ValueId)>,
    slots: Vec<Slot>,
    /// The values of earlier loops, by the block of the loop.
    loads: Vec<(BlockId, Vec<ValueId>)>,
}

impl<'a> Linearizer<'a> {
    /// Adds a loop to the program, unless it computes nothing.
    pub(super) fn linearize_loop(&mut self, id: LoopId) {
        let region = Region::Loop(id);
        self.linearize_region(region, self.live.nodes().to_vec());
        let loop_ = &self.regions.loops[id];
        let own = |edge: &Edge| self.regions.region(edge.node()) == region;
        let results: Vec<(usize, Edge)> =
            self.function.results().enumerate().filter(|(_, edge)| own(edge)).collect();
        let pivots = self.pivots_in(region);
        let sections = self.take_sections();
        // A loop may compute values that only later loops read.
        if results.is_empty()
            && pivots.is_empty()
            && loop_.carries.is_empty()
            && sections.is_empty()
        {
            return;
        }
        let nodes = self.read_by(region, loop_, &pivots);
        let LoopReads { unknowns, slots, loads } = self.by_source(id, nodes);
        let carries = loop_.carries.iter().map(|carry| CarriedValue {
            exit: self.carried(carry.exit),
            phi: self.carried(carry.phi),
            init: self.operand(carry.init),
            next: self.operand(carry.next),
        });
        let carries = carries.collect();
        let results = results.into_iter().map(|(number, edge)| (number, self.operand(edge)));
        let results = results.collect();
        let pivots = pivots
            .into_iter()
            .map(|(number, pivot)| (number, self.operand(pivot.value), self.operand(pivot.scale)));
        let pivots = pivots.collect();
        let (repeat, inward, stores) = (loop_.repeat, loop_.inward, Vec::new());
        let block = self.program.blocks.push(Block::Loop(LoopBlock {
            repeat,
            inward,
            carries,
            unknowns,
            slots,
            loads,
            stores,
            sections,
            results,
            pivots,
        }));
        self.blocks.insert(id, block);
    }

    /// Returns the pivots that are tested in a region, with their indices.
    fn pivots_in(&self, region: Region) -> Vec<(usize, &'a function::NamedPivot)> {
        let is_there = |pivot: &function::NamedPivot| {
            self.regions.common(pivot.value.node(), pivot.scale.node()) == region
        };
        self.function.pivots.iter().enumerate().filter(|(_, pivot)| is_there(pivot)).collect()
    }

    /// Returns the nodes that a loop reads: operands of its values, carries, results and pivots.
    fn read_by(
        &self,
        region: Region,
        loop_: &function::Loop,
        pivots: &[(usize, &function::NamedPivot)],
    ) -> Vec<NodeId> {
        let own = self.live.nodes().iter().filter(|&&node| self.regions.region(node) == region);
        let mut read: Vec<NodeId> = Vec::new();
        for &node in own {
            read.push(node);
            if !self.is_slot(node) {
                read.extend(self.graph.node(node).operands().map(Edge::node));
            }
        }
        read.extend(loop_.carries.iter().map(|carry| carry.next.node()));
        let tested = pivots.iter().flat_map(|(_, pivot)| [pivot.value, pivot.scale]);
        read.extend(tested.map(Edge::node));
        read.sort_unstable();
        read.dedup();
        read
    }

    /// Groups the nodes that a loop reads by their source. Earlier loops store the values that they have computed.
    fn by_source(&mut self, id: LoopId, nodes: Vec<NodeId>) -> LoopReads {
        let mut loads: Vec<(BlockId, Vec<ValueId>)> = Vec::new();
        let (mut unknowns, mut slots) = (Vec::new(), Vec::new());
        for node in nodes {
            if self.is_slot(node) {
                slots.extend(self.slots.get(&node).cloned());
                continue;
            }
            let symbol = self.graph.symbol_of(node);
            let unknown = symbol.filter(|&symbol| self.function.unknowns.get(symbol).is_some());
            match (unknown, self.regions.region(node)) {
                (Some(unknown), Region::Loop(_)) => unknowns.push((unknown, self.value(node))),
                (None, Region::Loop(from)) if from != id => {
                    self.load(node, self.blocks[&from], &mut loads);
                }
                _ => {}
            }
        }
        unknowns.sort_unstable();
        LoopReads { unknowns, slots, loads }
    }

    /// Loads a value that an earlier loop has computed in the same repetition.
    fn load(&mut self, node: NodeId, from: BlockId, loads: &mut Vec<(BlockId, Vec<ValueId>)>) {
        let value = self.value(node);
        let Block::Loop(earlier) = &mut self.program.blocks[from] else {
            bug!("a loop loads a value that no loop has stored")
        };
        if !earlier.stores.contains(&value) {
            earlier.stores.push(value);
        }
        match loads.iter_mut().find(|(block, _)| *block == from) {
            Some((_, values)) => values.push(value),
            None => loads.push((from, vec![value])),
        }
    }
}
