//! All identifiers of the expansion.

use crate::model::Chain;
use crate::program::{ValueId, ValueNames};
use proc_macro2::{Ident, Span};
use quote::format_ident;

/// TypeNames of the generated types.
pub struct TypeNames {
    /// The chain's own.
    pub chain: Ident,
    /// Coordinates, rates, time.
    pub state: Ident,
    /// What the caller gives at every step.
    pub inputs: Ident,
    /// Numbers that may change at run time.
    pub parameters: Ident,
    /// Where results are written.
    pub workspace: Ident,
}

impl TypeNames {
    /// The names of `chain`.
    pub fn of(chain: &Chain) -> Self {
        let named = |suffix: &str| format_ident!("{}{suffix}", chain.name);
        TypeNames {
            chain: chain.name.clone(),
            state: named("State"),
            inputs: named("Inputs"),
            parameters: named("Parameters"),
            workspace: named("Workspace"),
        }
    }
}

/// The variables that a program's values are.
#[derive(Default)]
pub struct Variables(Vec<Ident>);

impl Variables {
    /// Those of values with these names.
    pub fn of(names: &ValueNames) -> Self {
        Variables(names.all().iter().map(|text| variable(text)).collect())
    }

    /// That of a value.
    pub fn get(&self, value: ValueId) -> &Ident {
        &self.0[value.index()]
    }
}

/// The variable of an unknown or a value.
///
/// It has the hygiene of `macro_rules`, and so is none of those that templates write or [`helper`] makes,
/// whatever users call what it is named after.
pub fn variable(text: &str) -> Ident {
    Ident::new(&ended(text), Span::mixed_site())
}

/// A variable of the generated code's own.
pub fn helper(text: &str) -> Ident {
    Ident::new(&ended(text), Span::call_site())
}

/// A name with a low line at its end, as in all templates: where a constant or a static of the user had the
/// same name, Rust would take the variable for that one.
fn ended(text: &str) -> String {
    let mut ended = String::with_capacity(text.len() + 1);
    ended.push_str(text);
    ended.push('_');
    ended
}

/// The method that hands out `x` to be changed: `x_mut`.
pub fn accessor_mut(name: &Ident) -> Ident {
    let mut ident = format_ident!("{name}_mut");
    ident.set_span(name.span());
    ident
}
