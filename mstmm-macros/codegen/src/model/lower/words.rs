//! Words that cannot be names.

use proc_macro2::Ident;

use crate::syntax::FUNCTIONS;

/// Methods of the generated types, which are no names for hinges, bodies or parameters.
pub const RESERVED: &[&str] = &[
    "q",
    "q_mut",
    "v",
    "v_mut",
    "t",
    "time",
    "set_time",
    "coordinates",
    "coordinates_mut",
    "rates",
    "rates_mut",
    "zero_position",
    "clone",
    "into",
    "try_into",
    "default",
    "new",
    "initial_state",
    "no_inputs",
    "workspace",
    "solve_into",
    "accelerations",
    "accelerations_into",
    "kinetic_energy",
    "potential_energy",
    "energy",
    "parameters",
    "derivative_into",
    "implicit_derivative_into",
    "configuration_rate_into",
    "normalize",
    "points",
    "closure",
    "assemble",
    "point_",
    "vector_",
    "PLACES_",
    "RUNS_",
];

/// Names of parameters whose setters would hide other methods: every chain has `set_parameter`.
pub(crate) const PARAMETERS: &[&str] = &["parameter"];

/// Fields that the inputs of a chain may have.
pub(crate) const INPUTS: &[&str] = &["gravity"];

/// Keywords that are no names for body types, in addition to the kinds of hinges.
pub(crate) const ROUTE_WORDS: &[&str] = &["moving", "repeat", "at", "turned"];

/// Keywords that are no names for parameters, in addition to the functions.
pub(crate) const NUMBER_WORDS: &[&str] = &["PI", "input", "riccati", "transfer"];

/// Keywords of items, which are no names for anything.
pub(crate) const ITEM_WORDS: &[&str] = &["body", "hinge", "param", "ground"];

/// Keywords of newer editions of Rust, which the parser accepts as names.
pub(crate) const LATER_KEYWORDS: &[&str] = &["gen"];

/// Returns whether a word is a keyword of Rust.
pub(crate) fn is_keyword_of_rust(word: &str) -> bool {
    syn::parse_str::<Ident>(word).is_err() || LATER_KEYWORDS.contains(&word)
}

/// Returns whether a parameter of the chain may have this name.
pub(crate) fn can_name_parameter(word: &str) -> bool {
    let refused = [RESERVED, PARAMETERS, INPUTS, NUMBER_WORDS, ITEM_WORDS, FUNCTIONS];
    !is_keyword_of_rust(word) && refused.iter().all(|words| !words.contains(&word))
}
