//! The rules of the model, one function each. They are checked after everything readable has been
//! read.

mod alternate;
mod body;
mod compound;
mod hinge;
mod inertia;
mod load;
mod name;
mod number;
mod passive;
mod repeat;
mod request;
mod route;
mod tree;

use super::condition::{Requirement, judge};
use super::lower::Draft;
use crate::diag::Diagnostics;

/// A rule on values: returns the requirements on them.
type NumberRule = fn(&Draft) -> Vec<Requirement>;

/// All rules on values.
const NUMBER_RULES: &[NumberRule] = &[
    number::numbers_are_finite,
    number::roots_have_derivatives,
    body::masses_are_positive,
    inertia::moments_are_not_negative,
    inertia::inertias_are_physical,
    hinge::axes_have_a_direction,
    hinge::successive_axes_are_not_parallel,
    hinge::elastic_pitches_are_less_than_a_right_angle,
    passive::passive_values_are_not_negative,
    passive::speeds_and_limits_are_positive,
    passive::limits_are_in_order,
    load::spring_values_are_not_negative,
];

/// A rule: reports where a chain breaks it. It is silent if a part is missing because of another
/// error.
type ModelRule = fn(&Draft, &mut Diagnostics);

/// All rules.
const RULES: &[ModelRule] = &[
    name::names_are_identifiers,
    name::chain_names_are_not_the_scalar_type,
    name::names_are_used_once,
    name::input_names_are_unique,
    name::names_are_not_reserved,
    name::names_are_not_keywords,
    name::types_are_described_once,
    name::result_types_are_unique,
    name::body_types_are_not_keywords,
    name::parts_are_not_keywords_or_types,
    name::parameters_are_not_keywords,
    route::there_is_a_route_with_a_body,
    tree::further_routes_begin_at_places,
    route::ground_is_at_the_ends,
    alternate::hinges_and_bodies_alternate,
    route::hinges_connect_two_sides,
    route::closed_chains_can_move,
    request::requests_fit_closed_chains,
    tree::transfer_is_for_chains,
    repeat::repeats_follow_something,
    repeat::repeats_begin_with_a_hinge_and_end_with_a_body,
    repeat::repeats_contain_no_ends,
    repeat::repeats_follow_the_held_end,
    body::types_and_parts_are_used,
    body::fields_are_given,
    body::points_are_named_once,
    hinge::prescribed_motions_exclude_other_drives,
    passive::friction_and_limits_are_complete,
    passive::rest_positions_have_springs,
    load::loads_are_complete,
    load::springs_are_complete,
];

/// Checks all rules. Returns the requirements that depend on Rust constants, for `const`
/// assertions.
pub(super) fn check(draft: &Draft, diagnostics: &mut Diagnostics) -> Vec<Requirement> {
    for rule in RULES {
        rule(draft, diagnostics);
    }
    let requirements = NUMBER_RULES.iter().flat_map(|rule| rule(draft)).collect();
    judge(requirements, &draft.defaults(), diagnostics)
}
