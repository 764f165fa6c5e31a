//! What the lowering knows of the chain around the place at which it works.

use proc_macro2::{Ident, TokenStream};
use quote::ToTokens;

use super::dimension::PhysicalDimension;
use crate::diag::{Diagnostics, did_you_mean};
use crate::model::condition::Requirement;
use crate::model::{self, Symbol, Value};
use crate::syntax::{ExprSyntax, FieldSyntax, SpanRange, ValueSyntax};

/// Names, constants and mistakes.
pub(super) struct Context<'a> {
    /// In how many directions the chain moves.
    pub space: model::Dimension,
    /// The parameters that may be used, in the order of [`Symbol::Parameter`].
    pub parameters: Vec<KnownParameter<'a>>,
    /// The parameters that may not be used yet.
    pub later_parameters: Vec<&'a Ident>,
    /// The Rust paths seen so far, in the order of [`Symbol::Constant`].
    pub constants: Vec<TokenStream>,
    /// The mistakes of all phases.
    pub diagnostics: &'a mut Diagnostics,
    /// Whether every item could be read. If not, an unknown name may have been in the lost one.
    pub complete: bool,
    /// What must hold of numbers that are not known.
    pub requirements: Vec<Requirement>,
    /// Fields that have been read.
    read: Vec<*const FieldSyntax>,
    /// Fields with a mistake that is reported: several hinges may share one.
    faulty: Vec<*const FieldSyntax>,
}

/// A parameter that may be used.
pub(super) struct KnownParameter<'a> {
    /// Its name.
    pub name: &'a Ident,
    /// What is known of its unit.
    pub measure: Measure,
    /// Its default in SI units, if it is known.
    pub default: Option<f64>,
    /// The default as written, if it could be read.
    pub written: Option<&'a ExprSyntax>,
}

/// What is known of a number's unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Measure {
    /// A literal zero, which fits anything.
    Zero,
    /// No unit: in SI units of whatever is expected.
    Plain,
    /// A Rust path, which may be anything.
    Open,
    /// A dimension.
    Of(PhysicalDimension),
}

/// Something read, and where it stands.
#[derive(Clone, Debug)]
pub(crate) struct Spanned<T> {
    /// What was read.
    pub value: T,
    /// Where it stands.
    pub at: SpanRange,
}

impl<'a> Context<'a> {
    /// Knows nothing yet.
    pub fn new(space: model::Dimension, complete: bool, diagnostics: &'a mut Diagnostics) -> Self {
        Context {
            space,
            parameters: Vec::new(),
            later_parameters: Vec::new(),
            constants: Vec::new(),
            diagnostics,
            complete,
            requirements: Vec::new(),
            read: Vec::new(),
            faulty: Vec::new(),
        }
    }

    /// Reports a mistake that covers `at`, in place of a result.
    pub fn refuse<T>(&mut self, at: impl ToTokens, message: impl std::fmt::Display) -> Option<T> {
        self.diagnostics.error_over(at, message);
        None
    }

    /// `; did you mean …?` where one of these names is close to the word. Where nobody will read it,
    /// none is looked for: a long chain has many names.
    pub fn hint(&self, word: &Ident, names: impl IntoIterator<Item = impl ToString>) -> String {
        if self.diagnostics.is_full() {
            return String::new();
        }
        let names: Vec<String> = names.into_iter().map(|name| name.to_string()).collect();
        did_you_mean(&word.to_string(), names.iter().map(String::as_str))
    }

    /// What the chain is, where that is worth a word: ` of a plane chain`.
    pub fn of_chain(&self) -> &'static str {
        match self.space {
            model::Dimension::Space => "",
            model::Dimension::Plane => " of a plane chain",
            model::Dimension::Line => " of a line chain",
        }
    }

    /// Reads the value of a field. A mistake in it is reported once, whoever shares the field.
    pub fn field<T>(
        &mut self,
        field: &FieldSyntax,
        read: impl FnOnce(&mut Self, &ValueSyntax) -> Option<T>,
    ) -> Option<Spanned<T>> {
        let written = field.value.as_ref()?;
        if self.faulty.contains(&std::ptr::from_ref(field)) {
            return None;
        }
        let requirements = self.requirements.len();
        let value = read(self, written);
        if self.read.contains(&std::ptr::from_ref(field)) {
            self.requirements.truncate(requirements);
        }
        self.read.push(field);
        if value.is_none() {
            self.faulty.push(field);
        }
        value.map(|value| Spanned { value, at: written.extent() })
    }

    /// The value of a Rust path; the same path is the same constant.
    pub fn constant(&mut self, path: TokenStream) -> Value {
        let text = path.to_string();
        let known = self.constants.iter().position(|other| other.to_string() == text);
        let index = known.unwrap_or_else(|| {
            self.constants.push(path);
            self.constants.len() - 1
        });
        Value::Symbol(Symbol::Constant(index))
    }
}
