//! Names.

use proc_macro2::Ident;
use std::collections::{HashMap, HashSet};
use syn::ext::IdentExt;

use crate::diag::Diagnostics;
use crate::model::Request;
use crate::model::lower::{
    BodyType, Draft, INPUTS, ITEM_WORDS, ItemName, KINDS, NUMBER_WORDS, PARAMETERS, RESERVED_NAMES,
    ROUTE_WORDS, RouteItem, is_keyword_of_rust,
};
use crate::syntax::{BlockSyntax, FUNCTIONS};

/// A name of a hinge, a body, a moving end, a parameter, a load, a spring or an instance of a part.
struct UsedName {
    name: ItemName,
    /// Whether it was made from the name of the type.
    made: bool,
    /// The prefixes and suffixes of its further methods.
    also: &'static [(&'static str, &'static str)],
    /// The index of its item.
    item: Option<usize>,
}

fn names(draft: &Draft) -> Vec<UsedName> {
    let plain = |name: ItemName| UsedName { name, made: false, also: &[], item: None };
    let chain = &draft.written.scopes[0];
    let parameters = draft.def.parameters.iter();
    let parameters = parameters.map(|def| plain(chain.item_name(&def.field.name)));
    let items = draft.items.iter().enumerate().filter_map(|(index, item)| {
        let made = matches!(item, RouteItem::Body { named: false, .. });
        let repeated = draft.written.items[index].repeat.is_some() && item.is_hinge();
        let also = if repeated { REPEATED } else { CHANGED };
        Some(UsedName { name: item.name()?.clone(), made, also, item: Some(index) })
    });
    let instances = draft.written.scopes.iter().filter_map(|scope| {
        let name = scope.name.clone()?;
        Some(UsedName { made: !scope.is_named, ..plain(name) })
    });
    let acting = acting(draft).map(|name| plain(name.clone()));
    parameters.chain(items).chain(instances).chain(acting).collect()
}

/// Returns the end of the message for an item with the name of an earlier one: it may be meant to
/// close a loop.
fn twice(draft: &Draft, name: &UsedName) -> &'static str {
    let Some(index) = name.item else { return "" };
    if name.made {
        return "; write a name after the type";
    }
    let before = &draft.items[..index];
    let is_same =
        |other: &RouteItem| other.name().is_some_and(|other| other.path == name.name.path);
    match &draft.items[index] {
        RouteItem::Body { word, .. }
            // A hinge back to the same body is no loop.
            if before.iter().rev().skip(2).any(|other| {
                is_same(other) && matches!(other, RouteItem::Body { word: same, .. } if same == word)
            }) =>
        {
            "; a loop can close only at the ground or at a moving end"
        }
        RouteItem::Moving { .. } if before.first().is_some_and(is_same) => {
            "; give this end another name, and both ends the same motion"
        }
        _ => "",
    }
}

/// The methods that change a state.
const CHANGED: &[(&str, &str)] = &[("", "_mut")];
/// Those of a repeated hinge.
const REPEATED: &[(&str, &str)] = &[("", "_mut"), ("set_each_", "")];
/// The ends of the names of a body's Jacobians.
const JACOBIANS: [&str; 2] = ["_jacobian", "_jacobian_into"];

impl UsedName {
    /// Returns the names of its further methods.
    fn methods(&self) -> impl Iterator<Item = String> {
        self.also.iter().map(|(start, end)| format!("{start}{}{end}", self.name.joined))
    }
}

/// The names of loads and springs.
fn acting<'a>(draft: &'a Draft) -> impl Iterator<Item = &'a ItemName> {
    let springs = draft.springs.iter().map(|spring| &spring.name);
    draft.loads.iter().map(|load| &load.name).chain(springs)
}

/// Reports names that are Rust keywords: names become methods and types.
pub(super) fn names_are_identifiers(draft: &Draft, diagnostics: &mut Diagnostics) {
    let types = || draft.types.all.iter().map(|body| body.name);
    let refused_types: HashSet<String> = types().map(|name| name.unraw().to_string()).collect();
    let mut names = names(draft);
    // If the name is made from the type, the type is reported.
    names.retain(|name| !name.made || !refused_types.contains(&name.name.joined.to_string()));
    let points = draft.types.all.iter().flat_map(|body| &body.points).map(|point| point.name);
    let names = names.iter().map(|name| (name.name.own(), &name.name.joined));
    let of_parts =
        draft.def.parts.iter().flat_map(|part| [&part.name].into_iter().chain(&part.parameters));
    let plain = types().chain(points).chain(of_parts).chain([&draft.def.name]);
    let plain: Vec<(String, &Ident)> = plain.map(|name| (name.to_string(), name)).collect();
    let plain = plain.iter().map(|(text, name)| (&**text, *name));
    for (own, name) in names.chain(plain) {
        let text = name.to_string();
        let message = match own.strip_prefix("r#") {
            Some(plain) if !is_keyword_of_rust(plain) => {
                format!("write this name without `r#`: `{plain}`")
            }
            None if own != "_" && !is_keyword_of_rust(&text) => continue,
            _ => format!("`{own}` is a keyword of Rust and cannot be a name"),
        };
        diagnostics.name(name, message);
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

/// Reports names of hinges, bodies, parameters, loads, springs and parts that are used twice. A hinge or
/// body `x` also has the method `x_mut`, a repeated hinge `set_each_x`, and a body of a chain with Jacobians `x_jacobian`.
pub(super) fn names_are_used_once(draft: &Draft, diagnostics: &mut Diagnostics) {
    let names = names(draft);
    // The owner of each method.
    let mut owners: HashMap<String, &ItemName> = HashMap::new();
    for used in &names {
        let name = &used.name;
        let methods: Vec<String> =
            [name.joined.to_string()].into_iter().chain(used.methods()).collect();
        let shared = methods.iter().find_map(|method| Some((method, *owners.get(method)?)));
        if let Some((method, other)) = shared {
            let message = if other.path == name.path {
                let own = name.own();
                let part = part_of(draft, used)
                    .map_or_else(String::new, |part| format!(" in part `{part}`"));
                format!("the name `{own}` is used twice{part}{}", twice(draft, used))
            } else {
                format!("`{name}` and `{other}` both make the method `{method}`: rename one")
            };
            diagnostics.name(&name.joined, message);
        }
        for method in methods {
            owners.entry(method).or_insert(name);
        }
    }
    setters_are_no_jacobians(draft, diagnostics);
}

/// Reports bodies whose Jacobian has the name of a setter: with the word `jacobian`, a body `x` has the methods `x_jacobian`
/// and `x_jacobian_into` of the chain, and a parameter `x` has `set_x`.
fn setters_are_no_jacobians(draft: &Draft, diagnostics: &mut Diagnostics) {
    if draft.settings.requests.iter().all(|request| request.value != Request::Jacobian) {
        return;
    }
    let parameters = draft.def.parameters.iter().map(|def| &def.field.name);
    let setters: HashMap<String, &Ident> =
        parameters.map(|name| (format!("set_{name}"), name)).collect();
    let bodies = draft.items.iter().filter(|item| matches!(item, RouteItem::Body { .. }));
    for name in bodies.filter_map(RouteItem::name) {
        for method in JACOBIANS.map(|end| format!("{}{end}", name.joined)) {
            if let Some(other) = setters.get(&method) {
                let message =
                    format!("`{name}` and `{other}` both make the method `{method}`: rename one");
                diagnostics.name(&name.joined, message);
            }
        }
    }
}

/// Returns the part in which an item is written.
fn part_of<'d>(draft: &'d Draft, used: &UsedName) -> Option<&'d Ident> {
    let scope = draft.written.items[used.item?].scope;
    draft.written.scopes[scope].part.map(|part| &part.name)
}

/// Reports names that equal an input of a load or a spring: a load `x` has the inputs `x_force` and `x_torque`, a spring
/// `x` with an actuator the input `x_force`.
pub(super) fn input_names_are_unique(draft: &Draft, diagnostics: &mut Diagnostics) {
    let names = names(draft);
    let mut by_name: HashMap<String, &ItemName> = HashMap::new();
    for used in &names {
        by_name.entry(used.name.joined.to_string()).or_insert(&used.name);
    }
    let loads = draft.loads.iter().map(|load| ("load", &load.name, &["force", "torque"][..]));
    let actuated = draft.springs.iter().filter(|spring| spring.has_input());
    let springs = actuated.map(|spring| ("spring", &spring.name, &["force"][..]));
    for (word, owner, inputs) in loads.chain(springs) {
        for input in inputs.iter().map(|input| format!("{}_{input}", owner.joined)) {
            if let Some(other) = by_name.get(&input) {
                let message = format!(
                    "`{input}` is reserved for an input of {word} `{owner}`: choose another name"
                );
                diagnostics.name(&other.joined, message);
            }
        }
    }
}

/// Reports names of hinges, bodies and parameters that are methods of every chain or state.
pub(super) fn names_are_not_reserved(draft: &Draft, diagnostics: &mut Diagnostics) {
    let mut refuse = |name: &Ident| {
        let message = format!("`{name}` is reserved for the generated types and cannot be a name");
        diagnostics.name(name, message);
    };
    let parameters = draft.def.parameters.iter().map(|def| &def.field.name);
    parameters.filter(|name| PARAMETERS.iter().any(|known| name == known)).for_each(&mut refuse);
    for used in names(draft) {
        let mut methods = used.methods().chain([used.name.joined.to_string()]);
        if methods.any(|method| RESERVED_NAMES.contains(&&*method)) {
            refuse(&used.name.joined);
        }
    }
    for used in names(draft) {
        let text = used.name.joined.to_string();
        if INPUTS.contains(&&*text) {
            let message = format!("`{text}` is an input of chains and cannot be a name");
            diagnostics.name(&used.name.joined, message);
        }
    }
}

/// Reports names that are keywords of items. A body without a name has that of its type, `ground` for `Ground`.
pub(super) fn names_are_not_keywords(draft: &Draft, diagnostics: &mut Diagnostics) {
    for used in names(draft).iter().filter(|used| ITEM_WORDS.contains(&used.name.own())) {
        let (word, name) = (used.name.own(), &used.name.joined);
        if !used.made {
            refuse_word(word, name, diagnostics);
        } else if draft.types.all.iter().all(|body| body.name != word) {
            // If the type is the keyword, the type is reported.
            let message = format!(
                "this body has the name `{word}`, which is a keyword: write a name after the type"
            );
            diagnostics.name(name, message);
        }
    }
}

/// Reports body types with several blocks.
pub(super) fn types_are_described_once(draft: &Draft, diagnostics: &mut Diagnostics) {
    // Instances of a part have the same blocks.
    let mut described: HashMap<String, *const BlockSyntax> = HashMap::new();
    for body in &draft.types.all {
        let source = std::ptr::from_ref(body.source);
        let key = format!("{}.{}", body.part.map_or_else(String::new, Ident::to_string), body.name);
        if *described.entry(key).or_insert(source) != source {
            let message = format!("body type `{}` is described twice", body.name);
            diagnostics.name(body.name, message);
        }
    }
}

/// Reports types in parts whose results have the same name as those of another type.
pub(super) fn result_types_are_unique(draft: &Draft, diagnostics: &mut Diagnostics) {
    let mut owners: HashMap<String, &BodyType> = HashMap::new();
    for body in &draft.types.all {
        let name = &body.result_name;
        let other = *owners.entry(name.to_string()).or_insert(body);
        if other.part != body.part {
            let message = format!(
                "the results of this type have the name `{name}`, as those of another type: rename \
                 one of them, or its part"
            );
            diagnostics.error(body.name.span(), message);
        }
    }
}

/// Reports parts with the name of a keyword of a route or of a body type.
pub(super) fn parts_are_not_keywords_or_types(draft: &Draft, diagnostics: &mut Diagnostics) {
    let words: Vec<_> = type_keywords().collect();
    let number_words: Vec<_> = NUMBER_WORDS.iter().chain(FUNCTIONS).copied().collect();
    let types: HashSet<String> = draft.types.all.iter().map(|body| body.name.to_string()).collect();
    for part in &draft.def.parts {
        let name = &part.name;
        refuse_words([name].into_iter(), &words, diagnostics);
        if types.contains(&name.to_string()) {
            let message = format!("`{name}` is a part and a body type: rename one");
            diagnostics.name(name, message);
        }
        refuse_words(part.parameters.iter(), &number_words, diagnostics);
    }
}

/// Reports body types with the name of a keyword of the route.
pub(super) fn body_types_are_not_keywords(draft: &Draft, diagnostics: &mut Diagnostics) {
    let words: Vec<_> = type_keywords().collect();
    let names = draft.types.all.iter().map(|body| body.name);
    refuse_words(names, &words, diagnostics);
}

/// Reports parameters with the name of a keyword for a number.
pub(super) fn parameters_are_not_keywords(draft: &Draft, diagnostics: &mut Diagnostics) {
    let words: Vec<_> = NUMBER_WORDS.iter().chain(FUNCTIONS).copied().collect();
    let names = draft.def.parameters.iter().map(|def| &def.field.name);
    refuse_words(names, &words, diagnostics);
}

/// Returns the keywords that cannot be names of types and parts.
fn type_keywords() -> impl Iterator<Item = &'static str> {
    let kinds = KINDS.iter().map(|kind| kind.word);
    kinds.chain(ROUTE_WORDS.iter().chain(ITEM_WORDS).copied())
}

fn refuse_words<'a>(
    names: impl Iterator<Item = &'a Ident>,
    words: &[&str],
    diagnostics: &mut Diagnostics,
) {
    for name in names.filter(|name| words.iter().any(|word| name == word)) {
        refuse_word(&name.to_string(), name, diagnostics);
    }
}

fn refuse_word(word: &str, name: &Ident, diagnostics: &mut Diagnostics) {
    let message = format!("`{word}` is a keyword of this language and cannot be a name");
    diagnostics.name(name, message);
}
