//! The order of a program: under each heading, what its live values need, in the order in which
//! the equations wrote it down.

use super::angles::{Angles, angles};
use super::fuse::fused;
use super::names::NodeNames;
use super::owners::Owners;
use super::{Home, Live, Setup, Turn, Turns};
use crate::expr::{Edge, Graph, Node, NodeId, Stage};
use crate::ids::RepeatId;
use crate::program::{Block, Name, Names, Operand, Program, Section, Slot, Statement};
use std::collections::{HashMap, HashSet};

/// Named values under a heading.
#[derive(Clone, Debug)]
pub struct Heading {
    /// What names of values begin with that have none of their own.
    pub prefix: String,
    /// What is computed.
    pub title: String,
    /// Where the equations are from.
    pub source: String,
    /// Names and values.
    pub values: Vec<(String, Edge)>,
}

/// The unknowns of a program.
#[derive(Clone, Copy, Debug)]
pub struct Unknowns<'a> {
    /// Their names by number; behind them come those that loops carry.
    pub names: &'a [String],
    /// Which of them belong to which repeated part.
    pub parts: &'a [Option<RepeatId>],
    /// Loops over repeated parts, in their order, with what they carry.
    pub turns: &'a [Turn],
}

/// Orders what `outputs` need. A program of stage [`Stage::State`] reads what is known since setup
/// from `setup`'s slots; a program of stage [`Stage::Setup`] computes it.
pub fn schedule(
    graph: &Graph,
    unknowns: &Unknowns,
    stage: Stage,
    headings: &[Heading],
    outputs: &[Vec<Edge>],
    setup: &mut Setup,
) -> Program {
    let carried = unknowns.turns.iter().flat_map(|turn| &turn.carries);
    let carried: Vec<Edge> = carried.flat_map(|carry| [carry.first, carry.next]).collect();
    let live = Live::of(graph, outputs.iter().flatten().copied().chain(carried));
    let turns = Turns::of(graph, &live, unknowns.turns.to_vec(), unknowns.parts);
    let owners = Owners::of(graph, headings, unknowns.turns);
    let mut scheduler = Scheduler::new(graph, unknowns.names, stage, (live, &turns), owners, setup);
    scheduler.name_carries();
    for (name, edge) in headings.iter().flat_map(|heading| &heading.values) {
        scheduler.christen(name, *edge);
    }
    for done in 0..=turns.all.len() {
        scheduler.once(done, headings, outputs);
        if done < turns.all.len() {
            scheduler.turn(done, headings, outputs);
        }
    }
    scheduler.finish(outputs)
}

pub(super) struct Scheduler<'a> {
    pub(super) graph: &'a Graph,
    pub(super) symbols: &'a [String],
    stage: Stage,
    pub(super) setup: &'a mut Setup,
    pub(super) live: Live,
    pub(super) turns: &'a Turns,
    /// Angles by how many sines and cosines deep they lie, and by where they are computed.
    pub(super) angles: Angles,
    pub(super) depths: Vec<u32>,
    /// Products that are computed with their sums.
    pub(super) fused: Vec<bool>,
    /// Which values nodes are.
    pub(super) names: NodeNames,
    /// What loops carry, by the number of the unknown.
    pub(super) carried: HashMap<u32, Name>,
    /// Slots of repeated parts, which their loops read.
    pub(super) slots: HashMap<NodeId, Slot>,
    /// The blocks of the loops that are done.
    pub(super) blocks: HashMap<usize, usize>,
    taken: HashSet<String>,
    /// What has been stated.
    pub(super) done: Vec<bool>,
    /// For which request every node was last found to be needed.
    found: Vec<u32>,
    requests: u32,
    owners: Owners,
    sections: Vec<Section>,
    /// The section that is being written.
    current: usize,
    /// In which section nodes have been stated.
    places: Vec<Option<usize>>,
    pub(super) program: Program,
    pub(super) temporaries: usize,
}

impl<'a> Scheduler<'a> {
    fn new(
        graph: &'a Graph,
        symbols: &'a [String],
        stage: Stage,
        (live, turns): (Live, &'a Turns),
        owners: Owners,
        setup: &'a mut Setup,
    ) -> Self {
        let (angles, depths) = angles(graph, &live, turns, stage);
        let fused = fused(graph, &live, turns, stage);
        Scheduler {
            graph,
            symbols,
            stage,
            setup,
            live,
            turns,
            angles,
            depths,
            fused,
            names: NodeNames::new(graph.len()),
            carried: HashMap::new(),
            blocks: HashMap::new(),
            slots: HashMap::new(),
            taken: symbols.iter().cloned().collect(),
            done: vec![false; graph.len()],
            found: vec![0; graph.len()],
            requests: 0,
            program: Program {
                names: Names::default(),
                symbols: Vec::new(),
                slots: Vec::new(),
                blocks: Vec::new(),
                outputs: Vec::new(),
            },
            owners,
            sections: Vec::new(),
            current: 0,
            places: vec![None; graph.len()],
            temporaries: 0,
        }
    }

    /// Gives a node its first name.
    fn christen(&mut self, name: &str, edge: Edge) {
        let node = edge.node();
        let computed = !matches!(self.graph.node(node), Node::Number(_) | Node::Symbol(_));
        if computed && self.live.has(node) && self.names.get(node).is_none() {
            let sign = if edge.is_negative() { "minus_" } else { "" };
            let name = self.fresh(format!("{sign}{name}"));
            self.names.insert(node, name);
        }
    }

    /// A new value, called so if nothing else is.
    pub(super) fn fresh(&mut self, wanted: String) -> Name {
        let text = self.free(wanted);
        self.program.names.add(text)
    }

    /// The same of a value whose name says nothing but a number.
    pub(super) fn numbered(&mut self, wanted: String) -> Name {
        let text = self.free(wanted);
        self.program.names.add_numbered(text)
    }

    /// A name that no other value has.
    fn free(&mut self, wanted: String) -> String {
        if self.taken.insert(wanted.clone()) {
            return wanted;
        }
        let numbered = (2..).map(|number| format!("{wanted}_{number}"));
        let mut free = numbered.filter(|name| self.taken.insert(name.clone()));
        free.next().unwrap_or_default()
    }

    /// Names what loops carry.
    fn name_carries(&mut self) {
        for (number, turn) in self.turns.all.iter().enumerate() {
            for (place, carry) in turn.carries.iter().enumerate() {
                let name = self.numbered(format!("carry{number}_{place}"));
                let entering = self.numbered(format!("carry{number}_{place}_before"));
                self.carried.insert(carry.entering, entering);
                self.carried.insert(carry.leaving, name);
            }
        }
    }

    /// Whether a node is computed at `home`.
    fn belongs(&self, node: NodeId, home: Home) -> bool {
        let is_known = self.is_slot(node) && matches!(self.turns.home(node), Home::Once(_));
        self.live.has(node) && (is_known || self.turns.home(node) == home)
    }

    /// States what lives at `home`, each value under the first heading that needs it; then what no heading needs
    /// in the same repetition.
    pub(super) fn state_all(&mut self, home: Home, headings: &[Heading], rest: Vec<NodeId>) {
        let mut early = vec![Vec::new(); headings.len()];
        for &node in &rest {
            if let Some(number) = self.owners.own(node) {
                early[number].push(node);
            }
        }
        for (heading, early) in headings.iter().zip(early) {
            self.open(&heading.prefix, &heading.title, &heading.source);
            let values = heading.values.iter().map(|(_, edge)| edge.node());
            for node in values.chain(early) {
                if self.belongs(node, home) {
                    self.require(node);
                }
            }
        }
        self.open("result", "Results", "");
        for node in rest {
            if self.belongs(node, home) && !self.done[node as usize] {
                self.current = self.place_of(node, home).unwrap_or(headings.len());
                self.require(node);
            }
        }
    }

    /// The section of a value that no heading needs in the same repetition: the last one that it reads, or else
    /// the first one that needs it in another repetition. All that it reads must have been stated; angles beside
    /// it in one statement may not be, and then there is none.
    fn place_of(&self, node: NodeId, home: Home) -> Option<usize> {
        if self.turns.all.is_empty() {
            return None;
        }
        let beside = match self.graph.node(node) {
            Node::Sin(_) | Node::Cos(_) => self.angles.get(&(self.depths[node as usize], home)),
            _ => None,
        };
        let beside = || beside.into_iter().flatten().copied();
        if beside().any(|angle| self.belongs(angle, home) && !self.done[angle as usize]) {
            return None;
        }
        let read = self.graph.node(node).operands().map(Edge::node).chain(beside());
        let here = read.filter(|&id| !self.is_slot(id) && self.turns.home(id) == home);
        here.filter_map(|id| self.places[id as usize]).max().or(self.owners.any(node))
    }

    /// What is computed once, when so many loops are done.
    fn once(&mut self, done: usize, headings: &[Heading], outputs: &[Vec<Edge>]) {
        let home = Home::Once(done);
        // Without loops only the results are needed; what loops read may be anywhere.
        let rest: Vec<NodeId> = if self.turns.all.is_empty() {
            outputs.iter().flatten().map(|edge| edge.node()).collect()
        } else {
            self.live.nodes().to_vec()
        };
        self.state_all(home, headings, rest);
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

    fn open(&mut self, prefix: &str, title: &str, source: &str) {
        self.current = self.sections.len();
        self.sections.push(Section {
            prefix: prefix.to_owned(),
            title: title.to_owned(),
            source: source.to_owned(),
            statements: Vec::new(),
        });
    }

    /// What names of values begin with in the section that is open.
    pub(super) fn prefix(&self) -> &str {
        self.sections.get(self.current).map_or("result", |section| &section.prefix)
    }

    pub(super) fn state(&mut self, statement: Statement) {
        if let Some(section) = self.sections.get_mut(self.current) {
            section.statements.push(statement);
        }
    }

    /// Whether a node is read from a slot.
    pub(super) fn is_slot(&self, node: NodeId) -> bool {
        self.stage == Stage::State && self.graph.stage(node) == Stage::Setup
    }

    /// States everything that `node` needs and that has not been stated yet.
    pub(super) fn require(&mut self, node: NodeId) {
        if self.done[node as usize] {
            return;
        }
        self.requests += 1;
        let mut needed = Vec::new();
        let mut open = vec![node];
        while let Some(id) = open.pop() {
            let found = &mut self.found[id as usize];
            if self.done[id as usize] || *found == self.requests {
                continue;
            }
            *found = self.requests;
            needed.push(id);
            if !self.is_slot(id) {
                for operand in self.graph.node(id).operands() {
                    open.push(operand.node());
                }
            }
        }
        // Operands have smaller numbers than their users.
        needed.sort_unstable();
        for id in needed {
            // A group of angles may have stated some of them meanwhile.
            if !self.done[id as usize] {
                self.mark(id);
                self.compute(id);
            }
        }
    }

    /// Notes that a node is stated in the section that is being written.
    pub(super) fn mark(&mut self, node: NodeId) {
        self.done[node as usize] = true;
        if self.graph.symbol_number(node).is_none() {
            self.places[node as usize] = Some(self.current);
        }
    }

    fn finish(mut self, outputs: &[Vec<Edge>]) -> Program {
        let output = |edge: &Edge| match self.turns.home(edge.node()) {
            Home::Turn(_) => Operand::Repeated,
            _ => self.operand(*edge),
        };
        let outputs = outputs.iter().map(|group| group.iter().map(output).collect()).collect();
        self.program.symbols.sort_unstable();
        self.program.outputs = outputs;
        self.program
    }
}
