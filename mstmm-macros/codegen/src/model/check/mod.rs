//! What can be wrong with a chain whose every part could be read: one function for each rule.

mod body;
mod hinge;
mod inertia;
mod load;
mod name;
mod passive;
mod repeat;
mod route;

pub(super) use name::can_be_a_name;

use super::lower::Draft;
use crate::diag::Diagnostics;

/// A rule: it reports where a chain breaks it. It says nothing where a part is missing on account
/// of another mistake.
type Rule = fn(&Draft, &mut Diagnostics);

/// All rules.
const RULES: &[Rule] = &[
    name::names_are_identifiers,
    name::chains_are_not_called_like_their_numbers,
    name::names_are_used_once,
    name::inputs_of_loads_have_a_name_of_their_own,
    name::names_are_not_reserved,
    name::types_are_described_once,
    name::types_are_not_words_of_the_language,
    name::parameters_are_not_words_of_the_language,
    route::there_is_a_route_with_a_body,
    route::ground_is_at_the_ends,
    route::hinges_and_bodies_alternate,
    route::hinges_join_something_on_both_sides,
    route::closed_chains_can_move,
    repeat::repeats_follow_something,
    repeat::repeats_begin_with_a_hinge_and_end_with_a_body,
    repeat::repeats_hold_no_ends,
    repeat::repeats_follow_the_held_end,
    body::types_are_used,
    body::fields_are_given,
    body::points_are_named_once,
    body::masses_are_positive,
    inertia::moments_are_not_negative,
    inertia::inertias_are_those_of_real_bodies,
    hinge::axes_have_a_direction,
    hinge::universal_axes_are_not_parallel,
    hinge::pitches_are_finite,
    hinge::elastic_pitches_are_less_than_a_right_angle,
    hinge::motions_are_given_alone,
    passive::friction_and_limits_are_complete,
    passive::passive_numbers_are_not_negative,
    passive::speeds_and_limits_are_positive,
    passive::limits_are_in_order,
    load::loads_are_complete,
    load::springs_are_complete,
    load::spring_numbers_are_not_negative,
];

/// Tries all rules.
pub(super) fn check(draft: &Draft, diagnostics: &mut Diagnostics) {
    for rule in RULES {
        rule(draft, diagnostics);
    }
}

/// A verdict on a number; where parameters decide, with what their defaults make of it.
fn verdict(message: &str, known: bool, at_start: f64) -> String {
    if known {
        return message.to_owned();
    }
    format!("{message}; with its parameters' defaults it is {at_start}")
}
