//! What the generated docs state of the order of coordinates, rates and connection points.

use super::Plan;
use crate::program::ArrayLayout;
use std::ops::Range;

/// The order of the coordinates and rates, with the place of every hinge.
pub fn of_state(plan: &Plan) -> Vec<String> {
    let mut lines: Vec<String> = vec![
        " The hinges lie one after the other in the order of the route. A body that floats comes"
            .into(),
        " first; a hinge whose motion is prescribed has no place.".into(),
    ];
    if !plan.chain.repeats.is_empty() {
        lines.extend([
            " A repeated part lies repetition by repetition: all its hinges in the order of the route".into(),
            " for the first repetition, then all of them for the second, and so on.".into(),
        ]);
    }
    let (q, v) = (plan.coordinates(), plan.rates());
    let rows: Vec<String> = plan
        .chain
        .hinges
        .ids()
        .into_iter()
        .filter_map(|hinge| {
            let name = &plan.chain.hinges[hinge].name;
            let repeat = plan.chain.repeat_of_hinge(hinge);
            let times = repeat.map_or(String::new(), |repeat| {
                format!(", repetition k of {}", plan.chain.repeats[repeat].count)
            });
            let [in_q, in_v] = [(&q, &plan.layout.q[hinge]), (&v, &plan.layout.v[hinge])]
                .map(|(spread, range)| places(spread, range));
            Some(format!(" | `{name}`{times} | {} | {} |", in_q?, in_v?))
        })
        .collect();
    if !rows.is_empty() {
        let k = if plan.chain.repeats.is_empty() { "" } else { ", with k from zero" };
        lines.push(String::new());
        lines.push(format!(" | of | places in `q`{k} | places in `v` |"));
        lines.push(" |---|---|---|".into());
        lines.extend(rows);
    }
    lines
}

/// The places of a hinge's numbers in an array.
fn places(spread: &ArrayLayout, range: &Range<usize>) -> Option<String> {
    if range.is_empty() {
        return None;
    }
    let piece = spread.segment_of(range.start);
    let first = piece.place + range.start - piece.first;
    let last = first + range.len() - 1;
    let places = if first == last { first.to_string() } else { format!("{first} to {last}") };
    Some(match (piece.repeat, piece.count) {
        (None, _) => places,
        (Some(_), 1) => format!("{places} (+ k)"),
        (Some(_), stride) => format!("{places} (+ {stride} k)"),
    })
}

/// The order of the connection points.
pub fn of_points(plan: &Plan) -> Vec<String> {
    let mut lines = vec![
        " All connection points in the order of the route: the input of the first element, then the".into(),
        " output of every element, which is the input of the next one.".into(),
    ];
    if !plan.chain.repeats.is_empty() {
        lines.extend([
            " Those of a repeated part come repetition by repetition: the outputs of all its elements".into(),
            " for the first repetition, then those for the second, and so on.".into(),
        ]);
    }
    lines
}
