//! What the lowering knows of the chain around the place at which it works.

use proc_macro2::{Ident, TokenStream};
use std::collections::HashSet;

use super::dimension::PhysicalDimension;
use crate::diag::{Diagnostics, did_you_mean};
use crate::ids::IdVec;
use crate::model::condition::Requirement;
use crate::model::{self, ParameterId, Symbol, Value};
use crate::syntax::{ExprSyntax, FieldSyntax, SpanRange, ValueSyntax};

/// The state of the lowering: names, constants and diagnostics.
pub(super) struct Context<'a> {
    /// In how many directions the chain moves.
    pub space: model::Dimension,
    /// The parameters that may be used, in the order of [`Symbol::Parameter`].
    pub parameters: IdVec<ParameterId, KnownParameter<'a>>,
    /// The parameters that may not be used yet.
    pub later_parameters: Vec<&'a Ident>,
    /// The parameters of all parts.
    pub part_parameters: Vec<&'a Ident>,
    /// The Rust paths seen so far, in the order of [`Symbol::Constant`].
    pub constants: Vec<TokenStream>,
    /// The diagnostics of all phases.
    pub diagnostics: &'a mut Diagnostics,
    /// Whether every item was readable. If not, an unknown name may be defined in a lost item.
    pub complete: bool,
    /// Requirements on values that are not known.
    pub requirements: Vec<Requirement>,
    /// The squared lengths of quaternions, each once, as far as they are not known.
    pub quaternions: Vec<Value>,
    /// Whether the field that is read may be `input`.
    pub may_be_input: bool,
    /// Fields that have been read.
    read: HashSet<*const FieldSyntax>,
    /// Fields with a reported error: several hinges may share a field.
    faulty: HashSet<*const FieldSyntax>,
}

/// A parameter that may be used.
pub(super) struct KnownParameter<'a> {
    /// Its name.
    pub name: &'a Ident,
    /// Its dimension, as far as it is known.
    pub measure: Measure,
    /// Its default in SI units, if it is known.
    pub default: Option<f64>,
    /// The default as written, if it could be read.
    pub default_expr: Option<&'a ExprSyntax>,
    /// Whether a value that was read depends on it.
    pub is_used: bool,
}

/// What a number measures, as far as it is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Measure {
    /// A literal zero, which fits any dimension.
    Zero,
    /// A number without a unit: it is in the SI unit of the expected quantity.
    Plain,
    /// A Rust constant, which may have any dimension.
    Open,
    /// A dimension.
    Of(PhysicalDimension),
}

/// A value with its span.
#[derive(Clone, Debug)]
pub(crate) struct Spanned<T> {
    /// The value.
    pub value: T,
    /// Where it stands.
    pub at: SpanRange,
}

impl<'a> Context<'a> {
    /// Creates an empty context.
    pub fn new(space: model::Dimension, complete: bool, diagnostics: &'a mut Diagnostics) -> Self {
        Context {
            space,
            parameters: IdVec::new(),
            later_parameters: Vec::new(),
            part_parameters: Vec::new(),
            constants: Vec::new(),
            diagnostics,
            complete,
            requirements: Vec::new(),
            quaternions: Vec::new(),
            may_be_input: false,
            read: HashSet::new(),
            faulty: HashSet::new(),
        }
    }

    /// Reports an error that covers `at` and returns `None`.
    pub fn refuse<T>(
        &mut self,
        at: impl Into<SpanRange>,
        message: impl std::fmt::Display,
    ) -> Option<T> {
        self.diagnostics.error_over(at, message);
        None
    }

    /// Returns `; did you mean …?` if one of these names is close to the word. If further errors
    /// are only counted, the search is skipped: a long chain has many names.
    pub fn hint(&self, word: &Ident, names: impl IntoIterator<Item = impl ToString>) -> String {
        if self.diagnostics.is_full() {
            return String::new();
        }
        let names: Vec<String> = names.into_iter().map(|name| name.to_string()).collect();
        did_you_mean(&word.to_string(), names.iter().map(String::as_str))
    }

    /// Returns ` of a plane chain` or ` of a line chain` for messages, and nothing for a chain in
    /// space.
    pub fn of_chain(&self) -> &'static str {
        match self.space {
            model::Dimension::Space => "",
            model::Dimension::Plane => " of a plane chain",
            model::Dimension::Line => " of a line chain",
        }
    }

    /// Reads the value of a field. An error in it is reported once, even if several hinges share
    /// the field.
    pub fn field<T>(
        &mut self,
        field: &FieldSyntax,
        read: impl FnOnce(&mut Self, &ValueSyntax) -> Option<T>,
    ) -> Option<Spanned<T>> {
        let syntax = field.value.as_ref()?;
        if self.faulty.contains(&std::ptr::from_ref(field)) {
            return None;
        }
        let requirements = self.requirements.len();
        let value = read(self, syntax);
        self.may_be_input = false;
        if self.read.contains(&std::ptr::from_ref(field)) {
            self.requirements.truncate(requirements);
        }
        self.read.insert(field);
        if value.is_none() {
            self.faulty.insert(field);
        }
        value.map(|value| Spanned { value, at: syntax.extent() })
    }

    /// Returns the message for `input` in a number.
    pub fn not_input(&self) -> &'static str {
        if !self.later_parameters.is_empty() {
            return "the default of a parameter cannot be `input`: write a number, which a program can change";
        }
        match self.may_be_input {
            true => "`input` cannot be part of a formula: write it as the whole value of a field",
            false => {
                "this value cannot be `input`: write a number, or a `param` that a program can change"
            }
        }
    }

    /// Returns the value of a Rust path; equal paths are the same constant.
    pub fn constant(&mut self, path: TokenStream) -> Value {
        let text = path.to_string();
        let index = self.constants.iter().position(|other| other.to_string() == text);
        let index = index.unwrap_or_else(|| {
            self.constants.push(path);
            self.constants.len() - 1
        });
        Value::Symbol(Symbol::Constant(index))
    }
}
