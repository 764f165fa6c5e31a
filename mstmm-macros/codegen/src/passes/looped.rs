//! Loops of a schedule: what each computes for every time of a repeated part, what it reads of earlier
//! ones, and what it leaves.

use super::schedule::Scheduler;
use super::{Heading, Home, Turn};
use crate::expr::{Edge, NodeId};
use crate::program::{Block, Carried, Loop, Name};

impl Scheduler<'_> {
    /// A loop.
    pub(super) fn turn(&mut self, number: usize, headings: &[Heading], outputs: &[Vec<Edge>]) {
        let home = Home::Turn(number);
        self.state_all(home, headings, self.live.nodes().to_vec());
        let turn = &self.turns.all[number];
        let own = |edge: &Edge| self.live.has(edge.node()) && self.turns.home(edge.node()) == home;
        let places = outputs.iter().enumerate().flat_map(|(group, edges)| {
            edges.iter().enumerate().map(move |(place, edge)| (group, place, *edge))
        });
        let results: Vec<(usize, usize, Edge)> = places.filter(|(_, _, edge)| own(edge)).collect();
        let sections = self.take_sections();
        // What it computes may be for later loops alone.
        if results.is_empty() && turn.carries.is_empty() && sections.is_empty() {
            return;
        }
        let read = self.read_by(home, turn);
        let mut loads: Vec<(usize, Vec<Name>)> = Vec::new();
        let (mut symbols, mut slots) = (Vec::new(), Vec::new());
        for node in read {
            if self.is_slot(node) {
                slots.extend(self.slots.get(&node).cloned());
                continue;
            }
            match (self.graph.symbol_number(node), self.turns.home(node)) {
                (Some(symbol), Home::Turn(_)) if !self.carried.contains_key(&symbol) => {
                    symbols.push(symbol);
                }
                (_, Home::Turn(from)) if from != number => {
                    self.load(node, self.blocks[&from], &mut loads);
                }
                _ => {}
            }
        }
        symbols.sort_unstable();
        symbols.dedup();
        let carries = turn.carries.iter().map(|carry| Carried {
            name: self.carried[&carry.leaving],
            entering: self.carried[&carry.entering],
            first: self.operand(carry.first),
            next: self.operand(carry.next),
        });
        let carries = carries.collect();
        let outputs =
            results.into_iter().map(|(group, place, edge)| (group, place, self.operand(edge)));
        let outputs = outputs.collect();
        let (repeat, inwards) = (turn.repeat, turn.inwards);
        let stores = Vec::new();
        self.blocks.insert(number, self.program.blocks.len());
        self.program.blocks.push(Block::Loop(Loop {
            repeat,
            inwards,
            carries,
            symbols,
            slots,
            loads,
            stores,
            sections,
            outputs,
        }));
    }

    /// What a loop reads: operands of what it computes, of what it hands on, and of its results.
    fn read_by(&self, home: Home, turn: &Turn) -> Vec<NodeId> {
        let own = self.live.nodes().iter().filter(|&&node| self.turns.home(node) == home);
        let mut read: Vec<NodeId> = Vec::new();
        for &node in own {
            read.push(node);
            if !self.is_slot(node) {
                read.extend(self.graph.node(node).operands().map(Edge::node));
            }
        }
        read.extend(turn.carries.iter().map(|carry| carry.next.node()));
        read.sort_unstable();
        read.dedup();
        read
    }

    /// Lets a loop read what an earlier one has computed at the same time.
    fn load(&mut self, node: NodeId, from: usize, loads: &mut Vec<(usize, Vec<Name>)>) {
        let carried = self.graph.symbol_number(node).and_then(|symbol| self.carried.get(&symbol));
        let Some(name) = self.names.get(node).or(carried.copied()) else { return };
        if let Some(Block::Loop(earlier)) = self.program.blocks.get_mut(from)
            && !earlier.stores.contains(&name)
        {
            earlier.stores.push(name);
        }
        match loads.iter_mut().find(|(block, _)| *block == from) {
            Some((_, names)) => names.push(name),
            None => loads.push((from, vec![name])),
        }
    }
}
