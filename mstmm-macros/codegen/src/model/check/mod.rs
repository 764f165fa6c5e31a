//! What can be wrong with a chain whose every part could be read: one function for each rule.

mod body;
mod hinge;
mod inertia;
mod name;
mod route;

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
    name::names_are_not_reserved,
    name::types_are_described_once,
    name::types_are_not_words_of_the_language,
    name::parameters_are_not_words_of_the_language,
    route::there_is_a_route_with_a_body,
    route::ground_is_at_the_ends,
    route::hinges_and_bodies_alternate,
    route::hinges_join_something_on_both_sides,
    route::one_end_at_most_is_held,
    body::types_are_used,
    body::fields_are_given,
    body::masses_are_positive,
    inertia::moments_are_not_negative,
    inertia::inertias_are_those_of_real_bodies,
    hinge::axes_have_a_direction,
];

/// Tries all rules.
pub(super) fn check(draft: &Draft, diagnostics: &mut Diagnostics) {
    for rule in RULES {
        rule(draft, diagnostics);
    }
}
