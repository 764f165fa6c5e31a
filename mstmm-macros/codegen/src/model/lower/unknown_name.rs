//! Unknown names in numbers.

use proc_macro2::Ident;

use super::context::Context;
use super::words::{can_name_parameter, is_keyword_of_rust};
use crate::diag::nearest;
use crate::syntax::FUNCTIONS;

/// Functions whose names are close to those of other functions.
const OTHER_FUNCTIONS: &[&str] = &["asin", "acos", "sinh", "cosh", "cot", "sign"];

impl Context<'_> {
    /// Reports an unknown name in a number.
    pub fn unknown_name<T>(&mut self, name: &Ident) -> Option<T> {
        let text = name.to_string();
        let message = if is_keyword_of_rust(&text) {
            format!("expected a number, found `{text}`")
        } else if self.complete {
            let names = self.parameters.iter().map(|other| other.name.to_string());
            let hint = match self.hint(name, names.chain(["PI".to_owned()])) {
                none if none.is_empty() => definition(&text),
                near => near,
            };
            format!("unknown name `{text}`{hint}")
        } else {
            return None;
        };
        let parameters = self.parameters.iter().map(|other| other.name);
        self.diagnostics.unknown(name, message, parameters);
        None
    }

    /// Reports a word before parentheses that is no function.
    pub fn unknown_function<T>(&mut self, function: &Ident) -> Option<T> {
        let word = function.to_string();
        let near = nearest(&word, FUNCTIONS.iter().copied());
        let hint = match near.filter(|_| !OTHER_FUNCTIONS.contains(&&*word)) {
            Some(near) => format!("did you mean `{near}`?"),
            None => "there are `sqrt`, `sin` and `cos`".into(),
        };
        self.refuse(function, format!("unknown function `{function}`; {hint}"))
    }
}

/// Returns the end of the message for an unknown name: how it is defined, if it can be.
fn definition(name: &str) -> String {
    if FUNCTIONS.contains(&name) {
        return format!("; write the argument of the function: `{name}(…)`");
    }
    if !can_name_parameter(name) {
        return String::new();
    }
    format!(
        "; for a parameter write `param {name} = …`; a Rust constant begins with a capital letter"
    )
}
