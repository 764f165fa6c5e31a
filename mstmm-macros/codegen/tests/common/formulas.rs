//! Random functions with loops, and their direct evaluation.

use super::interpreter::{Failed, Judge};
use mstmm_codegen::expr::{Edge, Expr, Graph, Node, NodeId, Stage};
use mstmm_codegen::function::{Carry, Function, Loop, NamedPivot, Output, Unknowns, Written};
use mstmm_codegen::ids::{ParameterId, RepeatId, SymbolId};
use mstmm_codegen::math::Scalar;
use mstmm_codegen::program::{Argument, ArrayLayout, Given, OutputId};
use mstmm_reference::Random;
use std::cell::RefCell;
use std::collections::HashMap;

/// The output of random functions, which must be finite.
pub const NUMBERS: OutputId = OutputId::new("numbers");

/// The repetitions of two parts; one has a single repetition.
const REPETITIONS: [usize; 2] = [3, 1];

/// Returns unknowns: parameters and coordinates, of repeated parts and outside of them.
pub fn unknowns(looped: bool) -> Unknowns {
    let mut unknowns = Unknowns::new(REPETITIONS.to_vec().into());
    let part = |part: usize| Some((RepeatId(part), REPETITIONS[part]));
    let names = |letter: &str, count: usize| (0..count).map(|k| format!("{letter}{k}")).collect();
    let shared = [("p", Argument::Parameter(ParameterId(0)), ArrayLayout::once(1))];
    let of_part = ("r", Argument::Parameter(ParameterId(1)), ArrayLayout::of([(1, part(0))]));
    let segments = [(2, None), (2, part(0)), (1, part(1)), (1, None)];
    let of_all = ("x", Argument::Coordinates, ArrayLayout::of(segments));
    let once = ("x", Argument::Coordinates, ArrayLayout::once(4));
    let factor = ArrayLayout::of([(1, None), (1, part(0)), (1, part(1))]);
    let factor = ("y", Argument::Given(Given::Vector), factor);
    let all = if looped { vec![of_part, of_all, factor] } else { vec![once] };
    for (letter, argument, layout) in shared.into_iter().chain(all) {
        let count = layout.entries();
        unknowns.add(argument, layout, names(letter, count));
    }
    unknowns
}

/// Returns random values of unknowns.
pub fn random_values(random: &mut Random, unknowns: &Unknowns) -> HashMap<Argument, Vec<f64>> {
    let values = |layout: &ArrayLayout, random: &mut Random| {
        (0..layout.total).map(|_| random.between(-2.0, 2.0)).collect()
    };
    unknowns.arguments().map(|(argument, layout)| (argument, values(layout, random))).collect()
}

/// Returns a random function with up to five loops, and with pivots of which some vanish.
pub fn random_function<'g>(
    random: &mut Random,
    graph: &'g Graph,
    unknowns: &'g Unknowns,
) -> Function<'g> {
    // The values that are known in a repetition of each part, and those that are known outside of loops.
    let mut own: [Vec<Expr>; 2] = [Vec::new(), Vec::new()];
    let mut once: Vec<Expr> = Vec::new();
    for (number, unknown) in unknowns.iter().enumerate() {
        let is_known = matches!(unknown.argument, Argument::Parameter(_));
        let stage = if is_known { Stage::Setup } else { Stage::State };
        let symbol = graph.symbol(SymbolId(number), stage);
        match unknown.repeat {
            Some(part) => own[part.index()].push(symbol),
            None => once.push(symbol),
        }
    }
    let mut loops = Vec::new();
    let mut next_symbol = unknowns.count();
    let looped = own.iter().any(|own| !own.is_empty());
    for _ in 0..if looped { random.below(6) } else { 0 } {
        let part = random.below(2);
        let count = 1 + random.below(3);
        let symbol = |symbol: SymbolId| graph.symbol(symbol, Stage::State);
        let phis: Vec<SymbolId> = (0..count).map(|k| SymbolId(next_symbol + 2 * k)).collect();
        next_symbol += 2 * count;
        let inits: Vec<Expr> = phis.iter().map(|_| formula(random, &once, 2)).collect();
        own[part].extend(phis.iter().map(|&phi| symbol(phi)));
        let known = [&once[..], &own[part]].concat();
        let carry = |(&phi, init): (&SymbolId, Expr)| {
            // The carried value must stay bounded.
            let next = formula(random, &known, 3).sin_cos().0 + symbol(phi) * Expr::number(0.5);
            let (init, next) = (graph.edge(init), graph.edge(next));
            Carry { init, next, phi, exit: exit_of(phi) }
        };
        let carries = phis.iter().zip(inits).map(carry).collect();
        once.extend(phis.iter().map(|&phi| symbol(exit_of(phi))));
        loops.push(Loop { repeat: RepeatId(part), inward: random.chance(0.5), carries });
    }
    let known = [0, 1].map(|part| [&once[..], &own[part]].concat());
    let pick = |random: &mut Random| match random.below(3) {
        part @ (0 | 1) if looped => part,
        _ => 2,
    };
    let of = |random: &mut Random, part: usize, depth| match known.get(part) {
        Some(known) if looped => formula(random, known, depth),
        _ => formula(random, &once, depth),
    };
    let (mut items, mut values) = (Vec::new(), Vec::new());
    for _ in 0..2 + random.below(4) {
        let part = pick(random);
        items.push((1, (part < 2).then(|| (RepeatId(part), REPETITIONS[part]))));
        values.push(graph.edge(of(random, part, 4)));
    }
    let output =
        Output { id: NUMBERS, layout: ArrayLayout::of(items), values, written: Written::Together };
    let count = random.below(4);
    let pivot = |number: usize| {
        let part = pick(random);
        // Value and scale may be in different regions.
        let other = if random.chance(0.5) { 2 } else { part };
        let (a, b) = (of(random, part, 2), of(random, other, 2));
        let positive = a * a + Expr::number(1e-3);
        let value = if random.chance(0.9) { positive } else { a };
        let scale = b * b + Expr::number(1.0);
        let [value, scale] = [value, scale].map(|expr| graph.edge(expr));
        NamedPivot { hinge: format!("hinge{number}"), value, scale }
    };
    let pivots = (0..count).map(pivot).collect();
    let (stage, headings, outputs) = (Stage::State, Vec::new(), vec![output]);
    Function { graph, unknowns, stage, headings, loops, loops_before_factor: 0, outputs, pivots }
}

/// Returns the exit symbol of a carry with this phi.
fn exit_of(phi: SymbolId) -> SymbolId {
    SymbolId(phi.index() + 1)
}

/// Returns a random formula, with every kind of node.
pub fn formula<'g>(random: &mut Random, unknowns: &[Expr<'g>], depth: usize) -> Expr<'g> {
    if depth == 0 || random.chance(0.1) {
        return if random.chance(0.2) {
            Expr::number(*random.choose(&[0.0, 1.0, -1.0, 2.0, -0.5]))
        } else {
            *random.choose(unknowns)
        };
    }
    let a = formula(random, unknowns, depth - 1);
    let b = formula(random, unknowns, depth - 1);
    let positive = Expr::number(1.0) + a * a;
    match random.below(12) {
        0 | 1 => a + b,
        2 | 3 => a - b,
        4 | 5 => a * b,
        6 => a * b + a * formula(random, unknowns, depth - 1),
        7 => positive.recip(),
        8 => positive.sqrt().copysign(b + Expr::number(0.3)),
        9 => a.atan2(positive),
        10 => positive.recip_above(b * b),
        _ => (a + b).sin_cos().0 * b.sin_cos().1,
    }
}

/// Evaluates a function directly from its formulas; returns its results or the reason of a failure.
pub fn evaluated<S: Judge>(
    function: &Function,
    values: &HashMap<Argument, Vec<S>>,
) -> Result<Vec<S>, Failed> {
    let (phis, exits, known) = (HashMap::new(), HashMap::new(), RefCell::default());
    let mut direct = Direct { function, values, phis, exits, known };
    for one in &function.loops {
        direct.one_loop(one);
    }
    for pivot in &function.pivots {
        let part = [pivot.value, pivot.scale].into_iter().find_map(|edge| direct.part(edge));
        for repetition in 0..direct.repetitions(part) {
            let value = direct.value(pivot.value, repetition);
            if value.is_lost(direct.value(pivot.scale, repetition)) {
                return Err(Failed::Singular(pivot.hinge.clone()));
            }
        }
    }
    let output = &function.outputs[0];
    let mut results = Vec::new();
    for segment in &output.layout.segments {
        for repetition in 0..segment.repetitions {
            let entries = output.values[segment.entries()].iter();
            results.extend(entries.map(|&edge| direct.value(edge, repetition)));
        }
    }
    if results.iter().all(|x| x.is_finite()) { Ok(results) } else { Err(Failed::NotFinite) }
}

struct Direct<'a, S> {
    function: &'a Function<'a>,
    values: &'a HashMap<Argument, Vec<S>>,
    /// The values of phis in all repetitions of a part.
    phis: HashMap<SymbolId, (RepeatId, Vec<S>)>,
    exits: HashMap<SymbolId, S>,
    /// The values of nodes in repetitions. A loop carries no symbol of another, so they are final.
    known: RefCell<HashMap<(NodeId, usize), S>>,
}

impl<S: Judge> Direct<'_, S> {
    fn repetitions(&self, part: Option<RepeatId>) -> usize {
        part.map_or(1, |part| self.function.unknowns.repetitions(part))
    }

    fn one_loop(&mut self, one: &Loop) {
        let count = self.repetitions(Some(one.repeat));
        let mut current: Vec<S> =
            one.carries.iter().map(|carry| self.value(carry.init, 0)).collect();
        for step in 0..count {
            let repetition = if one.inward { count - 1 - step } else { step };
            for (carry, value) in one.carries.iter().zip(&current) {
                let nothing = || (one.repeat, vec![S::number(f64::NAN); count]);
                self.phis.entry(carry.phi).or_insert_with(nothing).1[repetition] = *value;
            }
            let next = one.carries.iter().map(|carry| self.value(carry.next, repetition));
            current = next.collect();
        }
        self.exits.extend(one.carries.iter().zip(current).map(|(carry, x)| (carry.exit, x)));
    }

    /// Returns the part that a formula depends on.
    fn part(&self, edge: Edge) -> Option<RepeatId> {
        match self.function.graph.node(edge.node()) {
            Node::Symbol(symbol) => match self.function.unknowns.get(symbol) {
                Some(unknown) => unknown.repeat,
                None => self.phis.get(&symbol).map(|(part, _)| *part),
            },
            node => node.operands().find_map(|edge| self.part(edge)),
        }
    }

    fn value(&self, edge: Edge, repetition: usize) -> S {
        let key = (edge.node(), repetition);
        let known = self.known.borrow().get(&key).copied();
        let plain = known.unwrap_or_else(|| self.node(edge.node(), repetition));
        self.known.borrow_mut().insert(key, plain);
        if edge.is_negative() { -plain } else { plain }
    }

    fn node(&self, id: NodeId, repetition: usize) -> S {
        let go = |edge| self.value(edge, repetition);
        match self.function.graph.node(id) {
            Node::Number(bits) => S::number(f64::from_bits(bits)),
            Node::Symbol(symbol) => self.symbol(symbol, repetition),
            Node::Sum(a, b) => go(a) + go(b),
            Node::Product(a, b) => go(a) * go(b),
            Node::Recip(a) => go(a).recip(),
            Node::Sqrt(a) => go(a).sqrt(),
            Node::Sin(a) => go(a).sine_and_cosine().0,
            Node::Cos(a) => go(a).sine_and_cosine().1,
            Node::CopySign(a, b) => go(a).copysign(go(b)),
            Node::Atan2(a, b) => go(a).angle(go(b)),
            Node::RecipAbove(a, b) => go(a).recip_above(go(b)),
        }
    }

    fn symbol(&self, symbol: SymbolId, repetition: usize) -> S {
        let Some(unknown) = self.function.unknowns.get(symbol) else {
            let of_loop = self.phis.get(&symbol).map(|(_, values)| values[repetition]);
            return of_loop.unwrap_or_else(|| self.exits[&symbol]);
        };
        let layout = self.function.unknowns.layout(unknown.argument);
        let segment = layout.segment_of(unknown.entry);
        let time = if unknown.repeat.is_some() { repetition } else { 0 };
        let place = segment.offset + time * segment.count + unknown.entry - segment.first;
        self.values[&unknown.argument][place]
    }
}
