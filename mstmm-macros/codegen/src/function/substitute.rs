//! Replaces symbols of a function by formulas.

use super::Function;
use crate::expr::{Edge, Expr, Graph, NodeId};
use crate::ids::SymbolId;
use std::collections::HashMap;

/// Replaces symbols of a function by formulas, in its results and in the values that its loops carry. Values that loops
/// carry and that are then the same known number in every repetition are folded.
///
/// A formula for a symbol must be known where the symbol is read: the loops that it depends on must run earlier. The
/// symbols in it are not replaced.
pub fn substitute<'g>(
    function: Function<'g>,
    formulas: &HashMap<SymbolId, Expr<'g>>,
) -> Function<'g> {
    let images = FormulaImages::new(function.graph, formulas.clone());
    fold_known_carries(images.apply(function))
}

/// Replaces values that loops carry by the number that they are in every repetition, if it is known.
fn fold_known_carries(mut function: Function) -> Function {
    let mut changing: Vec<Vec<bool>> =
        function.loops.iter().map(|loop_| vec![false; loop_.carries.len()]).collect();
    let images = loop {
        let mut images = FormulaImages::new(function.graph, HashMap::new());
        if images.follow_loops(&function, &mut changing) {
            break images;
        }
    };
    for (loop_, changing) in function.loops.iter_mut().zip(&changing) {
        let mut changing = changing.iter();
        loop_.carries.retain(|_| changing.next() == Some(&true));
    }
    function.loops.retain(|loop_| !loop_.carries.is_empty());
    images.apply(function)
}

/// The formulas for symbols, and the images of nodes.
pub(super) struct FormulaImages<'g> {
    graph: &'g Graph,
    formulas: HashMap<SymbolId, Expr<'g>>,
    nodes: Vec<Option<Expr<'g>>>,
}

impl<'g> FormulaImages<'g> {
    pub(super) fn new(graph: &'g Graph, formulas: HashMap<SymbolId, Expr<'g>>) -> Self {
        FormulaImages { graph, formulas, nodes: vec![None; graph.len()] }
    }

    /// Replaces all roots of a function by their images.
    pub(super) fn apply(mut self, function: Function<'g>) -> Function<'g> {
        let roots: Vec<Edge> = function.roots().collect();
        roots.into_iter().for_each(|edge| _ = self.of(edge));
        function.map(|edge| self.known(edge))
    }

    /// Finds the images of all values that loops carry. Values that are not marked as changing are assumed to be the same in
    /// every repetition if they are known numbers at the start. Returns whether this is right; marks them otherwise.
    fn follow_loops(&mut self, function: &Function<'g>, changing: &mut [Vec<bool>]) -> bool {
        let mut is_right = true;
        for (loop_, changing) in function.loops.iter().zip(changing) {
            for (carry, changes) in loop_.carries.iter().zip(changing.iter_mut()) {
                let init = self.of(carry.init);
                *changes |= init.known().is_none();
                if !*changes {
                    self.formulas.extend([(carry.phi, init), (carry.exit, init)]);
                }
            }
            for (carry, changes) in loop_.carries.iter().zip(changing.iter_mut()) {
                let next = self.of(carry.next);
                if !*changes && !next.is(&self.of(carry.init)) {
                    (*changes, is_right) = (true, false);
                }
            }
        }
        is_right
    }

    /// Returns the image of an edge, whose operands are followed before it.
    pub(super) fn of(&mut self, edge: Edge) -> Expr<'g> {
        let mut open = vec![edge.node()];
        let mut needed: Vec<NodeId> = Vec::new();
        while let Some(id) = open.pop() {
            let is_new = self.nodes[id as usize].is_none();
            if is_new {
                // Marks the node as found, until its image replaces it.
                self.nodes[id as usize] = Some(self.graph.expr(Edge::to(id)));
                needed.push(id);
                open.extend(self.graph.node(id).operands().map(Edge::node));
            }
        }
        // Operands have smaller indices.
        needed.sort_unstable();
        for id in needed {
            let formula = self.graph.symbol_of(id).and_then(|symbol| self.formulas.get(&symbol));
            let image = match formula {
                Some(formula) => *formula,
                None => self.graph.with_operands(id, |operand| self.found(operand)),
            };
            self.nodes[id as usize] = Some(image);
        }
        self.found(edge)
    }

    /// Returns the image of an edge that has been followed.
    fn found(&self, edge: Edge) -> Expr<'g> {
        match self.nodes[edge.node() as usize] {
            Some(image) if edge.is_negative() => -image,
            Some(image) => image,
            None => bug!("a formula is replaced before its operands"),
        }
    }

    /// Returns the image of an edge, if it has been followed.
    fn known(&self, edge: Edge) -> Option<Edge> {
        self.nodes.get(edge.node() as usize)?.map(|_| self.graph.edge(self.found(edge)))
    }
}
