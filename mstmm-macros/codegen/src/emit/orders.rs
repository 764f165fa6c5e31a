//! The docs of the order of coordinates, rates and connection points.

use super::EmitContext;
use crate::program::ArrayLayout;
use std::ops::Range;

/// Returns the order of the coordinates and rates, with the indices of every hinge.
pub fn of_state(cx: &EmitContext) -> Vec<String> {
    let order = if is_chain(cx) { "route" } else { "text" };
    let mut lines: Vec<String> = vec![
        format!(
            " The entries of all hinges are in the order of the {order}. The floating base comes first, if there"
        ),
        " is one. Hinges with a prescribed motion have no entries.".into(),
    ];
    if !cx.chain.repeats.is_empty() {
        lines.extend([
            " A repeated part is in the order of its repetitions: all its hinges of the first repetition in".into(),
            format!(" the order of the {order}, then all of the second, and so on."),
        ]);
    }
    let (q, v) = (cx.coordinates(), cx.rates());
    let rows: Vec<String> = cx
        .chain
        .hinges
        .ids()
        .into_iter()
        .filter_map(|hinge| {
            let name = &cx.chain.hinges[hinge].path;
            let repeat = cx.chain.repeat_of_hinge(hinge);
            let times = repeat.map_or(String::new(), |repeat| {
                format!(", repetition k of {}", cx.chain.repeats[repeat].count)
            });
            let [in_q, in_v] = [(&q, &cx.layout.q[hinge]), (&v, &cx.layout.v[hinge])]
                .map(|(layout, range)| indices(layout, range));
            Some(format!(" | `{name}`{times} | {} | {} |", in_q?, in_v?))
        })
        .collect();
    if !rows.is_empty() {
        let k = if cx.chain.repeats.is_empty() { "" } else { ", with k from zero" };
        lines.push(String::new());
        lines.push(format!(" | hinge | indices in `q`{k} | indices in `v` |"));
        lines.push(" |---|---|---|".into());
        lines.extend(rows);
    }
    lines
}

/// Returns the indices of a hinge's entries in an array.
fn indices(layout: &ArrayLayout, range: &Range<usize>) -> Option<String> {
    if range.is_empty() {
        return None;
    }
    let segment = layout.segment_of(range.start);
    let first = segment.offset + range.start - segment.first;
    let last = first + range.len() - 1;
    let indices = if first == last { first.to_string() } else { format!("{first} to {last}") };
    Some(match (segment.repeat, segment.count) {
        (None, _) => indices,
        (Some(_), 1) => format!("{indices} (+ k)"),
        (Some(_), stride) => format!("{indices} (+ {stride} k)"),
    })
}

/// Returns the order of the connection points.
pub fn of_points(cx: &EmitContext) -> Vec<String> {
    let mut lines: Vec<String> = vec![];
    if is_chain(cx) {
        lines.extend([
            " Returns all connection points in the order of the route: the input of the first element, then the".into(),
            " output of every element, which is the input of the next element.".into(),
        ]);
    } else {
        lines.extend([
            " Returns all connection points in the order of the text: of each element its input, if no earlier element".into(),
            " has this point, and its output; after the output of a body those of its named points that hinges leave.".into(),
            " A hinge that leaves a place with other hinges, or the input of a body, has a separate input.".into(),
        ]);
    }
    if !cx.chain.repeats.is_empty() {
        lines.extend([
            " A repeated part is in the order of its repetitions: the outputs of all its elements of the first".into(),
            " repetition, then those of the second, and so on.".into(),
        ]);
    }
    lines
}

/// Returns whether each point but the first is the output of the next element.
fn is_chain(cx: &EmitContext) -> bool {
    let outputs = cx.compiled.point_storage.of.elements.iter().map(|ends| ends.output.index());
    outputs.eq(1..cx.compiled.point_storage.of.points.len())
}
