//! The order of a program: under each heading, what its live values need, in the order in which
//! the equations wrote it down.

use super::Live;
use crate::expr::{Edge, Graph, Node, NodeId, Stage};
use crate::program::{Operand, Operation, Program, Section, Slot, Statement};
use std::collections::{BTreeMap, HashMap, HashSet};

/// Named values under a heading.
#[derive(Clone, Debug)]
pub struct Heading {
    /// What is computed.
    pub title: String,
    /// Where the equations are from.
    pub source: String,
    /// Names and values.
    pub values: Vec<(String, Edge)>,
}

/// The values that all programs of a chain share because they are known since setup.
#[derive(Clone, Debug, Default)]
pub struct Setup {
    nodes: Vec<NodeId>,
    names: Vec<String>,
    index: HashMap<NodeId, usize>,
}

impl Setup {
    /// The values in the order of their slots.
    pub fn values(&self) -> impl Iterator<Item = (&str, Edge)> {
        self.names.iter().map(String::as_str).zip(self.nodes.iter().map(|&node| Edge::to(node)))
    }

    /// The slot of `node`, a new one under `name` if it has none yet.
    pub fn slot(&mut self, node: NodeId, name: impl FnOnce(usize) -> String) -> usize {
        *self.index.entry(node).or_insert_with(|| {
            self.nodes.push(node);
            self.names.push(name(self.names.len()));
            self.names.len() - 1
        })
    }

    /// The name of a slot.
    pub fn name(&self, slot: usize) -> &str {
        &self.names[slot]
    }
}

/// Orders what `outputs` need, with `symbols` as the names of the unknowns. A program of stage
/// [`Stage::State`] reads what is known since setup from `setup`'s slots; a program of stage
/// [`Stage::Setup`] computes it.
pub fn schedule(
    graph: &Graph,
    symbols: &[String],
    stage: Stage,
    headings: &[Heading],
    outputs: &[Vec<Edge>],
    setup: &mut Setup,
) -> Program {
    let live = Live::of(graph, outputs.iter().flatten().copied());
    let mut scheduler = Scheduler::new(graph, symbols, stage, live, setup);
    for (name, edge) in headings.iter().flat_map(|heading| &heading.values) {
        scheduler.christen(name, *edge);
    }
    for heading in headings {
        scheduler.open(&heading.title, &heading.source);
        for (_, edge) in &heading.values {
            if scheduler.live.has(edge.node()) {
                scheduler.require(edge.node());
            }
        }
    }
    scheduler.open("Results", "");
    for edge in outputs.iter().flatten() {
        scheduler.require(edge.node());
    }
    let outputs = outputs
        .iter()
        .map(|group| group.iter().map(|&edge| scheduler.operand(edge)).collect())
        .collect();
    scheduler.finish(outputs)
}

struct Scheduler<'a> {
    graph: &'a Graph,
    symbols: &'a [String],
    stage: Stage,
    setup: &'a mut Setup,
    live: Live,
    /// Angles by how many sines and cosines deep they lie.
    angles: BTreeMap<u32, Vec<NodeId>>,
    depths: Vec<u32>,
    names: HashMap<NodeId, String>,
    taken: HashSet<String>,
    done: Vec<bool>,
    program: Program,
    temporaries: usize,
}

impl<'a> Scheduler<'a> {
    fn new(
        graph: &'a Graph,
        symbols: &'a [String],
        stage: Stage,
        live: Live,
        setup: &'a mut Setup,
    ) -> Self {
        let (angles, depths) = angles(graph, &live, stage);
        Scheduler {
            graph,
            symbols,
            stage,
            setup,
            live,
            angles,
            depths,
            names: HashMap::new(),
            taken: symbols.iter().cloned().collect(),
            done: vec![false; graph.len()],
            program: Program {
                symbols: Vec::new(),
                slots: Vec::new(),
                sections: Vec::new(),
                outputs: Vec::new(),
            },
            temporaries: 0,
        }
    }

    /// Gives a node its first name.
    fn christen(&mut self, name: &str, edge: Edge) {
        let node = edge.node();
        let computed = !matches!(self.graph.node(node), Node::Number(_) | Node::Symbol(_));
        if computed && self.live.has(node) && !self.names.contains_key(&node) {
            let sign = if edge.is_negative() { "minus_" } else { "" };
            let name = self.fresh(format!("{sign}{name}"));
            self.names.insert(node, name);
        }
    }

    fn fresh(&mut self, wanted: String) -> String {
        let mut name = wanted.clone();
        let mut number = 2;
        while !self.taken.insert(name.clone()) {
            name = format!("{wanted}_{number}");
            number += 1;
        }
        name
    }

    fn open(&mut self, title: &str, source: &str) {
        self.program.sections.push(Section {
            title: title.to_owned(),
            source: source.to_owned(),
            statements: Vec::new(),
        });
    }

    fn state(&mut self, statement: Statement) {
        if let Some(section) = self.program.sections.last_mut() {
            section.statements.push(statement);
        }
    }

    /// Whether a node is read from a slot.
    fn is_slot(&self, node: NodeId) -> bool {
        self.stage == Stage::State && self.graph.stage(node) == Stage::Setup
    }

    /// States everything that `node` needs and that has not been stated yet.
    fn require(&mut self, node: NodeId) {
        let mut needed = Vec::new();
        let mut open = vec![node];
        let mut seen = HashSet::new();
        while let Some(id) = open.pop() {
            if !self.done[id as usize] && seen.insert(id) {
                needed.push(id);
                if !self.is_slot(id) {
                    open.extend(self.graph.node(id).operands().map(Edge::node));
                }
            }
        }
        // Operands have smaller numbers than their users.
        needed.sort_unstable();
        for id in needed {
            // A group of angles may have stated some of them meanwhile.
            if !std::mem::replace(&mut self.done[id as usize], true) {
                self.compute(id);
            }
        }
    }

    fn compute(&mut self, id: NodeId) {
        if self.is_slot(id) {
            return self.read_slot(id);
        }
        let operation = match self.graph.node(id) {
            Node::Number(_) => return,
            Node::Symbol(number) => return self.program.symbols.push(number),
            Node::Sin(_) | Node::Cos(_) => return self.compute_angles(self.depths[id as usize]),
            Node::Sum(a, b) => self.sum(a, b),
            Node::Product(a, b) => Operation::Product(self.operand(a), self.operand(b)),
            Node::Recip(a) => Operation::Recip(self.operand(a)),
            Node::Sqrt(a) => Operation::Sqrt(self.operand(a)),
            Node::CopySign(a, b) => Operation::CopySign(self.operand(a), self.operand(b)),
        };
        let name = self.name(id);
        self.state(Statement::Let(name, operation));
    }

    fn read_slot(&mut self, id: NodeId) {
        let graph = self.graph;
        let given = self.names.get(&id).cloned();
        let symbols = self.symbols;
        let index = self.setup.slot(id, |number| match graph.node(id) {
            Node::Symbol(symbol) => symbols[symbol as usize].clone(),
            _ => given.unwrap_or_else(|| format!("p{number}")),
        });
        let name = self.fresh(format!("known_{}", self.setup.name(index)));
        self.names.insert(id, name.clone());
        self.program.slots.push(Slot { index, name });
    }

    /// `a + b` with the sign of `b` in the operation.
    fn sum(&self, a: Edge, b: Edge) -> Operation {
        if b.is_negative() {
            Operation::Difference(self.operand(a), self.operand(b.negated()))
        } else {
            Operation::Sum(self.operand(a), self.operand(b))
        }
    }

    /// Sines and cosines of all angles of one depth, side by side.
    fn compute_angles(&mut self, depth: u32) {
        let Some(angles) = self.angles.remove(&depth) else { return };
        for &angle in &angles {
            self.require(angle);
        }
        let (mut sines, mut cosines, mut operands) = (Vec::new(), Vec::new(), Vec::new());
        for &angle in &angles {
            let graph = self.graph;
            let number = sines.len();
            for (names, prefix, node) in [
                (&mut sines, "sin", graph.find(Node::Sin(Edge::to(angle)))),
                (&mut cosines, "cos", graph.find(Node::Cos(Edge::to(angle)))),
            ] {
                names.push(match node.filter(|&node| self.live.has(node)) {
                    Some(node) => {
                        self.done[node as usize] = true;
                        let name = match graph.node(angle) {
                            Node::Symbol(symbol) => {
                                format!("{prefix}_{}", self.symbols[symbol as usize])
                            }
                            _ => format!("{prefix}_{number}"),
                        };
                        let name = self.fresh(name);
                        self.names.insert(node, name.clone());
                        Some(name)
                    }
                    None => None,
                });
            }
            operands.push(self.operand(Edge::to(angle)));
        }
        self.state(Statement::SinCos { sines, cosines, angles: operands });
    }

    fn name(&mut self, id: NodeId) -> String {
        if let Some(name) = self.names.get(&id) {
            return name.clone();
        }
        let name = self.fresh(format!("t{}", self.temporaries));
        self.temporaries += 1;
        self.names.insert(id, name.clone());
        name
    }

    fn operand(&self, edge: Edge) -> Operand {
        let node = edge.node();
        let plain = match self.graph.node(node) {
            Node::Number(bits) => {
                let value = f64::from_bits(bits);
                return Operand::Number(if edge.is_negative() { 0.0 - value } else { value });
            }
            Node::Symbol(number) if !self.is_slot(node) => Operand::Symbol(number),
            _ => Operand::Named(self.names.get(&node).cloned().unwrap_or_default()),
        };
        if edge.is_negative() { Operand::Minus(Box::new(plain)) } else { plain }
    }

    fn finish(mut self, outputs: Vec<Vec<Operand>>) -> Program {
        self.program.sections.retain(|section| !section.statements.is_empty());
        self.program.symbols.sort_unstable();
        self.program.outputs = outputs;
        self.program
    }
}

/// The live angles by depth, and every live node's depth: how many sines and cosines are nested.
fn angles(graph: &Graph, live: &Live, stage: Stage) -> (BTreeMap<u32, Vec<NodeId>>, Vec<u32>) {
    let mut depths = vec![0; graph.len()];
    let mut angles: BTreeMap<u32, Vec<NodeId>> = BTreeMap::new();
    for id in (0..depths.len()).filter(|&id| live.has(id as NodeId)) {
        let node = graph.node(id as NodeId);
        if stage == Stage::State && graph.stage(id as NodeId) < Stage::State {
            continue;
        }
        let below = node.operands().map(|edge| depths[edge.node() as usize]).max().unwrap_or(0);
        depths[id] = below;
        if let Node::Sin(angle) | Node::Cos(angle) = node {
            depths[id] = below + 1;
            let group = angles.entry(depths[id]).or_default();
            if !group.contains(&angle.node()) {
                group.push(angle.node());
            }
        }
    }
    (angles, depths)
}
