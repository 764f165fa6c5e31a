//! The identifiers of the expansion.

use crate::model::Chain;
use crate::program::{ValueId, ValueNames};
use proc_macro2::{Ident, Span};
use quote::format_ident;

/// The names of the generated types.
pub struct TypeNames {
    /// The chain.
    pub chain: Ident,
    /// The state: coordinates, rates, time.
    pub state: Ident,
    /// The inputs that the caller supplies at every step.
    pub inputs: Ident,
    /// The parameters: values that may change at run time.
    pub parameters: Ident,
    /// The workspace: the results.
    pub workspace: Ident,
    /// The kinematics of all bodies.
    pub kinematics: Ident,
    /// A variation of all arguments of forward dynamics.
    pub variation: Ident,
    /// The derivatives of inverse dynamics.
    pub derivatives: Ident,
    /// The accelerations and their derivatives.
    pub linearization: Ident,
}

impl TypeNames {
    /// Returns the names for a chain.
    pub fn of(chain: &Chain) -> Self {
        let named = |suffix: &str| format_ident!("{}{suffix}", chain.name);
        TypeNames {
            chain: chain.name.clone(),
            state: named("State"),
            inputs: named("Inputs"),
            parameters: named("Parameters"),
            workspace: named("Workspace"),
            kinematics: named("Kinematics"),
            variation: named("Variation"),
            derivatives: named("InverseDynamicsDerivatives"),
            linearization: named("Linearization"),
        }
    }
}

/// The variables of a program's values.
#[derive(Clone, Default)]
pub struct Variables(Vec<Ident>);

impl Variables {
    /// Returns the variables of values with these names.
    pub fn of(names: &ValueNames) -> Self {
        Variables(names.all().iter().map(|text| variable(text)).collect())
    }

    /// Returns the variable of a value.
    pub fn get(&self, value: ValueId) -> &Ident {
        &self.0[value.index()]
    }
}

/// Returns the variable of an unknown or a value.
///
/// It has the hygiene of `macro_rules`. It therefore differs from all variables of templates and of [`helper`], whatever
/// names the user has chosen.
pub fn variable(text: &str) -> Ident {
    Ident::new(&ended(text), Span::mixed_site())
}

/// Returns an auxiliary variable of the generated code.
pub fn helper(text: &str) -> Ident {
    Ident::new(&ended(text), Span::call_site())
}

/// Appends an underscore, as in all templates. If the user's code had a constant or a static of the same name, Rust would
/// take the variable for it.
fn ended(text: &str) -> String {
    let mut ended = String::with_capacity(text.len() + 1);
    ended.push_str(text);
    ended.push('_');
    ended
}

/// Returns `x_mut`, the name of the method that returns a mutable view of `x`.
pub fn accessor_mut(name: &Ident) -> Ident {
    let mut ident = format_ident!("{name}_mut");
    ident.set_span(name.span());
    ident
}
