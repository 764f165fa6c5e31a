//! Tokens that the generated items have unchanged.

use proc_macro2::{Ident, TokenStream};

/// Tokens that the compiler passes to the generated code unread.
#[derive(Debug)]
pub struct Passthrough {
    /// Visibility of the generated types.
    pub visibility: syn::Visibility,
    /// Attributes of the chain, including its doc comments.
    pub attributes: Vec<syn::Attribute>,
    /// The Rust paths of constants, in the order of [`crate::model::Symbol::Constant`].
    pub constants: Vec<TokenStream>,
    /// The instances of parts, in the order of the text.
    pub instances: Vec<PartInstance>,
    /// Uses of names.
    pub references: References,
}

/// An instance of a part.
#[derive(Debug)]
pub struct PartInstance {
    /// Its path: `rex.lf`.
    pub path: String,
    /// The name of the part.
    pub part: Ident,
    /// The doc comments of the part.
    pub docs: Vec<syn::Attribute>,
}

/// Uses of names that an editor can follow to their definitions.
#[derive(Debug, Default)]
pub struct References {
    /// Names of hinges and bodies in blocks after the route.
    pub elements: Vec<Ident>,
    /// The names of body types in their own blocks.
    pub types: Vec<Ident>,
    /// The same on the route.
    pub uses_of_types: Vec<Ident>,
    /// Parameters in numbers.
    pub parameters: Vec<Ident>,
    /// Kinds of hinges, fields and units, each as often as it is written.
    pub keywords: Vec<KeywordUses>,
}

/// The uses of a group of keywords.
#[derive(Debug)]
pub struct KeywordUses {
    /// The group.
    pub group: KeywordGroup,
    /// The keywords, at least one.
    pub words: Vec<Ident>,
}

/// A group of keywords: a module of `mstmm::keywords`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KeywordGroup {
    /// Kinds of hinges.
    Kinds,
    /// Settings of a chain.
    Settings,
    /// Words of the setting `answers`.
    Answers,
    /// Fields of body types.
    Body,
    /// Fields of hinges.
    Hinge,
    /// Symbols of units.
    Units,
    /// Fields of the start of a floating base.
    Base,
    /// Fields of loads.
    Load,
    /// Fields of springs.
    Spring,
}

impl KeywordGroup {
    /// All groups.
    pub const ALL: [KeywordGroup; 9] = [
        KeywordGroup::Kinds,
        KeywordGroup::Settings,
        KeywordGroup::Answers,
        KeywordGroup::Body,
        KeywordGroup::Hinge,
        KeywordGroup::Units,
        KeywordGroup::Base,
        KeywordGroup::Load,
        KeywordGroup::Spring,
    ];

    /// Returns the name of its module.
    pub fn module(self) -> &'static str {
        match self {
            KeywordGroup::Kinds => "kinds",
            KeywordGroup::Settings => "settings",
            KeywordGroup::Answers => "answers",
            KeywordGroup::Body => "body",
            KeywordGroup::Hinge => "hinge",
            KeywordGroup::Units => "units",
            KeywordGroup::Base => "base",
            KeywordGroup::Load => "load",
            KeywordGroup::Spring => "spring",
        }
    }

    /// Returns whether no other such group has the same names.
    pub fn has_unique_names(self) -> bool {
        !matches!(self, KeywordGroup::Base | KeywordGroup::Load | KeywordGroup::Spring)
    }
}
