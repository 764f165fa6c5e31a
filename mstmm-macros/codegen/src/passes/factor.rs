//! `a b + a c = a (b + c)` where neither product is used elsewhere: one multiplication less.

use super::Live;
use crate::expr::{Edge, Expr, Graph, Node, NodeId};
use crate::math::Scalar;

/// Rewrites everything that `results` need; returns where each live node has gone, by its number.
pub fn factor(graph: &Graph, results: &[Edge]) -> Vec<Option<Edge>> {
    let live = Live::of(graph, results.iter().copied());
    let mut image: Vec<Option<Edge>> = vec![None; graph.len()];
    for id in 0..image.len() as NodeId {
        if live.has(id) {
            let expr = rewritten(graph, &live, &image, id);
            image[id as usize] = Some(graph.edge(expr));
        }
    }
    image
}

fn rewritten<'g>(graph: &'g Graph, live: &Live, image: &[Option<Edge>], id: NodeId) -> Expr<'g> {
    let node = graph.node(id);
    let go = |edge: Edge| {
        let image = image[edge.node() as usize].unwrap_or(edge.plain());
        let expr = graph.expr(image);
        if edge.is_negative() { -expr } else { expr }
    };
    match node {
        Node::Number(_) | Node::Symbol(_) => graph.expr(Edge::to(id)),
        Node::Sum(a, b) => match shared_factor(graph, live, a, b) {
            Some((factor, rest_a, rest_b)) => {
                let rest_b = if b.is_negative() { -go(rest_b) } else { go(rest_b) };
                go(factor) * (go(rest_a) + rest_b)
            }
            None => go(a) + go(b),
        },
        Node::Product(a, b) => go(a) * go(b),
        Node::Recip(a) => go(a).recip(),
        Node::Sqrt(a) => go(a).sqrt(),
        Node::Sin(a) => go(a).sin_cos().0,
        Node::Cos(a) => go(a).sin_cos().1,
        Node::CopySign(a, b) => go(a).copysign(go(b)),
        Node::Atan2(a, b) => go(a).atan2(go(b)),
        Node::RecipAbove(a, b) => go(a).recip_above(go(b)),
    }
}

/// The factor common to two products that nothing else uses, and what is left of each.
fn shared_factor(graph: &Graph, live: &Live, a: Edge, b: Edge) -> Option<(Edge, Edge, Edge)> {
    let product = |edge: Edge| match graph.node(edge.node()) {
        Node::Product(x, y) if live.uses(edge.node()) == 1 => Some([(x, y), (y, x)]),
        _ => None,
    };
    let (a, b) = (product(a)?, product(b)?);
    a.into_iter()
        .flat_map(|(factor, rest)| b.map(|(other, other_rest)| (factor, rest, other, other_rest)))
        .find(|(factor, _, other, _)| factor == other)
        .map(|(factor, rest, _, other_rest)| (factor, rest, other_rest))
}
