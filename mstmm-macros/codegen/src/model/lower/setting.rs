//! Settings of the whole chain: `gravity = …;` and `method = …;`.

use super::context::Context;
use super::dimension::ACCELERATION;
use super::fields::Fields;
use crate::diag::{did_you_mean, nearest};
use crate::model::{Method, Source};
use crate::syntax::{ChainDef, Written};

const SETTINGS: &[&str] = &["gravity", "method"];
const METHODS: &[(&str, Method)] = &[("riccati", Method::Riccati), ("transfer", Method::Transfer)];

/// Settings of the whole chain, as far as they could be read.
pub(crate) struct Settings {
    /// Acceleration of free fall.
    pub gravity: Option<Source>,
    /// How the accelerations are solved for.
    pub method: Option<Method>,
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
    Settings { gravity, method: method.map(|given| given.value) }
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
