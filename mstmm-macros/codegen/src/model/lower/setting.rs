//! Settings of the whole chain: `gravity = …;`, `method = …;` and `results = …;`.

use super::context::Context;
use super::dimension::ACCELERATION;
use super::fields::Fields;
use crate::diag::{did_you_mean, nearest};
use crate::model::{Method, Results, Source};
use crate::syntax::{ChainDef, Expr, ExprKind, List, SETTINGS, Written};
use std::fmt::Display;

const METHODS: &[(&str, Method)] = &[("riccati", Method::Riccati), ("transfer", Method::Transfer)];
/// Where it is noted that a result is asked for.
type Place = fn(&mut Results) -> &mut bool;
const RESULTS: &[(&str, Place)] = &[
    ("poses", |results| &mut results.poses),
    ("velocities", |results| &mut results.velocities),
    ("z", |results| &mut results.z),
    ("energies", |results| &mut results.energies),
];

/// Settings of the whole chain, as far as they could be read.
pub(crate) struct Settings {
    /// Acceleration of free fall.
    pub gravity: Option<Source>,
    /// How the accelerations are solved for.
    pub method: Option<Method>,
    /// What the solution says: everything unless less is asked for.
    pub results: Results,
}

/// All settings.
pub(super) fn settings(def: &ChainDef, context: &mut Context) -> Settings {
    let mut given = Fields::default();
    let owner = format!("chain `{}`", def.name);
    for field in &def.settings {
        let name = field.name.to_string();
        if nearest(&name, SETTINGS.iter().copied()).is_none() {
            let message = format!("unknown setting `{name}`; a number is `param {name} = …`");
            context.diagnostics.error(field.name.span(), message);
            // The number may be used further on.
            context.whole = false;
            continue;
        }
        given.add(field, SETTINGS, &owner, context);
    }
    let gravity = context.source(given.get("gravity"), |context, written| {
        context.written_vector(written, ACCELERATION)
    });
    let method = given.get("method").and_then(|field| context.field(field, method));
    let results = given.get("results").and_then(|field| context.field(field, results));
    Settings {
        gravity,
        method: method.map(|given| given.value),
        results: results.map_or(Results::ALL, |given| given.value),
    }
}

fn method(context: &mut Context, written: &Written) -> Option<Method> {
    let word = written.word().map_or_else(String::new, ToString::to_string);
    let known = METHODS.iter().find(|(name, _)| *name == word).map(|&(_, method)| method);
    if known.is_none() {
        let hint = did_you_mean(&word, METHODS.iter().map(|(name, _)| *name));
        let found = written.described();
        let message = format!("expected `riccati` or `transfer`, found {found}{hint}");
        context.diagnostics.error_over(written.extent(), message);
    }
    known
}

/// One word, or several in brackets.
fn results(context: &mut Context, written: &Written) -> Option<Results> {
    let entries = match written {
        Written::Number(entry) => std::slice::from_ref(entry),
        Written::Vector(List { unit: Some(unit), .. }) => {
            return context.refuse(unit.extent, "words have no unit");
        }
        Written::Vector(List { entries, extent, .. }) if entries.is_empty() => {
            return context.refuse(*extent, no_result("nothing"));
        }
        Written::Vector(List { entries, .. }) => entries,
        _ => return context.refuse(written.extent(), no_result(written.described())),
    };
    let (mut results, mut right) = (Results::NONE, true);
    for entry in entries {
        right &= add_result(context, entry, &mut results).is_some();
    }
    right.then_some(results)
}

fn add_result(context: &mut Context, entry: &Expr, results: &mut Results) -> Option<()> {
    let ExprKind::Name(word) = &entry.kind else {
        return context.refuse(entry.extent, no_result("a number"));
    };
    let name = word.to_string();
    let Some((_, place)) = RESULTS.iter().find(|(known, _)| *known == name) else {
        let hint = did_you_mean(&name, RESULTS.iter().map(|(known, _)| *known));
        return context.refuse(word, no_result(format!("`{word}`{hint}")));
    };
    let given = place(results);
    if *given {
        return context.refuse(word, format!("`{word}` is given twice"));
    }
    *given = true;
    Some(())
}

fn no_result(found: impl Display) -> String {
    let known: Vec<String> = RESULTS.iter().map(|(word, _)| format!("`{word}`")).collect();
    format!("expected {} or several of them as in `[z, poses]`, found {found}", known.join(", "))
}
