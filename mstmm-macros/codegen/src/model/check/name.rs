//! Names.

use proc_macro2::Ident;
use std::collections::HashMap;
use syn::ext::IdentExt;

use super::route::repeat_around;
use crate::diag::Diagnostics;
use crate::model::lower::{Draft, KINDS, RouteItem};
use crate::syntax::FUNCTIONS;

/// Methods of the generated types, which are no names for hinges, bodies or parameters.
const RESERVED: &[&str] = &[
    "q",
    "q_mut",
    "v",
    "v_mut",
    "t",
    "time",
    "set_time",
    "clone",
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
];

/// Fields that the inputs of a chain may have.
const INPUTS: &[&str] = &["gravity"];

/// Keywords that are no names for body types, in addition to the kinds of hinges.
const ROUTE_WORDS: &[&str] = &["moving", "repeat", "at", "turned"];

/// Keywords that are no names for parameters, in addition to the functions.
const NUMBER_WORDS: &[&str] = &["PI", "input", "riccati", "transfer"];

/// Keywords of items, which are no names for anything.
const ITEM_WORDS: &[&str] = &["body", "hinge", "param", "ground"];

/// Keywords of newer editions of Rust, which the parser accepts as names.
const LATER_KEYWORDS: &[&str] = &["gen"];

/// A name of a hinge, a body, a moving end, a parameter, a load or a spring.
struct UsedName<'a> {
    ident: &'a Ident,
    /// Whether it was made from the name of the type.
    made: bool,
    /// The prefixes and suffixes of its further methods.
    also: &'static [(&'static str, &'static str)],
    /// The end of the message if the name is used already.
    twice: &'static str,
}

fn names<'a>(draft: &'a Draft) -> Vec<UsedName<'a>> {
    let parameters = draft.def.parameters.iter();
    let plain = |ident| UsedName { ident, made: false, also: &[], twice: "" };
    let parameters = parameters.map(|def| plain(&def.field.name));
    let items = draft.items.iter().enumerate().filter_map(|(index, item)| {
        let made = matches!(item, RouteItem::Body { named: false, .. });
        let repeated =
            repeat_around(draft, index).is_some() && matches!(item, RouteItem::Hinge { .. });
        let also = if repeated { REPEATED } else { CHANGED };
        let twice = if made { "; write a name after the type" } else { twice(draft, index) };
        Some(UsedName { ident: item.name()?, made, also, twice })
    });
    let acting = acting(draft).map(plain);
    parameters.chain(items).chain(acting).collect()
}

/// Returns the end of the message for an item with the name of an earlier one: it may be meant to
/// close a loop.
fn twice(draft: &Draft, index: usize) -> &'static str {
    let (before, after) = draft.items.split_at(index);
    let is_same = |other: &RouteItem| other.name() == after.first().and_then(RouteItem::name);
    match after {
        [RouteItem::Body { word, .. }]
            // A hinge back to the same body is no loop.
            if before.iter().rev().skip(2).any(|other| {
                is_same(other) && matches!(other, RouteItem::Body { word: same, .. } if same == word)
            }) =>
        {
            "; a loop can close only at the ground or at a moving end"
        }
        [RouteItem::Moving { .. }] if before.first().is_some_and(is_same) => {
            "; give this end another name, and both ends the same motion"
        }
        _ => "",
    }
}

/// The methods that change a state.
const CHANGED: &[(&str, &str)] = &[("", "_mut")];
/// Those of a repeated hinge.
const REPEATED: &[(&str, &str)] = &[("", "_mut"), ("set_each_", "")];

impl UsedName<'_> {
    /// Returns the names of its further methods.
    fn methods(&self) -> impl Iterator<Item = String> {
        self.also.iter().map(|(start, end)| format!("{start}{}{end}", self.ident))
    }
}

/// The names of loads and springs.
fn acting<'a>(draft: &'a Draft) -> impl Iterator<Item = &'a Ident> {
    let springs = draft.springs.iter().map(|spring| spring.name);
    draft.loads.iter().map(|load| load.name).chain(springs)
}

/// Reports names that are Rust keywords: names become methods and types.
pub(super) fn names_are_identifiers(draft: &Draft, diagnostics: &mut Diagnostics) {
    let types = draft.types.iter().map(|body| body.name);
    let mut names = names(draft);
    // If the name is made from the type, the type is reported.
    names.retain(|name| !name.made || types.clone().all(|of_type| of_type.unraw() != *name.ident));
    let points = draft.types.iter().flat_map(|body| &body.points).map(|point| point.name);
    let idents = names.iter().map(|name| name.ident).chain(types).chain(points);
    let idents = idents.chain([&draft.def.name]);
    for name in idents {
        let text = name.to_string();
        let keyword = syn::parse_str::<Ident>(&text).is_err() || LATER_KEYWORDS.contains(&&*text);
        if text.starts_with("r#") || keyword {
            let message = format!("`{text}` is a keyword of Rust and cannot be a name");
            diagnostics.name(name, message);
        }
    }
}

/// Reports chains with the name `T`, the scalar type of the generated types.
pub(super) fn chain_names_are_not_the_scalar_type(draft: &Draft, diagnostics: &mut Diagnostics) {
    let name = &draft.def.name;
    if name == "T" {
        let message = "`T` is the scalar type of a chain and cannot be its name";
        diagnostics.name(name, message);
    }
}

/// Reports names of hinges, bodies, parameters, loads and springs that are used twice. A hinge or
/// body `x` also has the method `x_mut`, and a repeated hinge `set_each_x`.
pub(super) fn names_are_used_once(draft: &Draft, diagnostics: &mut Diagnostics) {
    let names = names(draft);
    // The owner of each method.
    let mut owners: HashMap<String, &Ident> = HashMap::new();
    for name in &names {
        let text = name.ident.to_string();
        let methods: Vec<String> = [text.clone()].into_iter().chain(name.methods()).collect();
        let shared = methods.iter().find_map(|method| Some((method, *owners.get(method)?)));
        if let Some((method, other)) = shared {
            let message = match other == name.ident {
                true => format!("the name `{text}` is used twice{}", name.twice),
                false => format!("`{text}` and `{other}` both have a method `{method}`"),
            };
            diagnostics.name(name.ident, message);
        }
        for method in methods {
            owners.entry(method).or_insert(name.ident);
        }
    }
}

/// Reports names that equal an input of a load: a load `x` has the inputs `x_force` and `x_torque`.
pub(super) fn load_inputs_have_unique_names(draft: &Draft, diagnostics: &mut Diagnostics) {
    let names = names(draft);
    for load in draft.loads.iter().map(|load| load.name) {
        for input in [format!("{load}_force"), format!("{load}_torque")] {
            if let Some(other) = names.iter().find(|other| other.ident == &input) {
                let message = format!(
                    "`{input}` is reserved for an input of load `{load}`: \
                                       choose another name"
                );
                diagnostics.name(other.ident, message);
            }
        }
    }
}

/// Reports names of hinges, bodies and parameters that are methods of every chain.
pub(super) fn names_are_not_reserved(draft: &Draft, diagnostics: &mut Diagnostics) {
    for name in names(draft) {
        let text = name.ident.to_string();
        let mut methods = name.methods().chain([text.clone()]);
        if methods.any(|method| RESERVED.contains(&&*method)) {
            let message =
                format!("`{text}` is reserved for the generated types and cannot be a name");
            diagnostics.name(name.ident, message);
        }
        if INPUTS.contains(&&*text) {
            let message = format!("`{text}` is an input of chains and cannot be a name");
            diagnostics.name(name.ident, message);
        }
    }
}

/// Reports names that are keywords of items.
pub(super) fn names_are_not_keywords(draft: &Draft, diagnostics: &mut Diagnostics) {
    let names = names(draft);
    let names = names.iter().filter(|name| !name.made).map(|name| name.ident);
    refuse_words(names, ITEM_WORDS, diagnostics);
}

/// Reports body types with several blocks.
pub(super) fn types_are_described_once(draft: &Draft, diagnostics: &mut Diagnostics) {
    for (index, body) in draft.types.iter().enumerate() {
        if draft.types[..index].iter().any(|other| other.name == body.name) {
            let message = format!("body type `{}` is described twice", body.name);
            diagnostics.name(body.name, message);
        }
    }
}

/// Reports body types with the name of a keyword of the route.
pub(super) fn body_types_are_not_keywords(draft: &Draft, diagnostics: &mut Diagnostics) {
    let kinds = KINDS.iter().map(|kind| kind.word);
    let words: Vec<_> = kinds.chain(ROUTE_WORDS.iter().chain(ITEM_WORDS).copied()).collect();
    let names = draft.types.iter().map(|body| body.name);
    refuse_words(names, &words, diagnostics);
}

/// Reports parameters with the name of a keyword for a number.
pub(super) fn parameters_are_not_keywords(draft: &Draft, diagnostics: &mut Diagnostics) {
    let words: Vec<_> = NUMBER_WORDS.iter().chain(FUNCTIONS).copied().collect();
    let names = draft.def.parameters.iter().map(|def| &def.field.name);
    refuse_words(names, &words, diagnostics);
}

fn refuse_words<'a>(
    names: impl Iterator<Item = &'a Ident>,
    words: &[&str],
    diagnostics: &mut Diagnostics,
) {
    for name in names.filter(|name| words.iter().any(|word| name == word)) {
        diagnostics.name(
            name,
            format!(
                "`{name}` is a keyword of this language and cannot be a \
                                        name"
            ),
        );
    }
}
