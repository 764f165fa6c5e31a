//! The syntax tree of chains, parts and routes.

use super::tree::{
    ArgumentsSyntax, BlockSyntax, FieldSyntax, OrientationSyntax, PathSyntax, ValueSyntax,
};
use proc_macro2::{Ident, Span};

/// A chain as written.
#[derive(Clone, Debug)]
pub struct ChainSyntax {
    /// Doc comments and attributes in front.
    pub attributes: Vec<syn::Attribute>,
    /// Visibility of the generated types.
    pub visibility: syn::Visibility,
    /// The dimension; `None` if its keyword is unknown.
    pub dimension: Option<DimensionKeyword>,
    /// The chain's name.
    pub name: Ident,
    /// `gravity = …;` and `method = …;`
    pub settings: Vec<FieldSyntax>,
    /// `param name = …;` and `param name[times] = …;`
    pub parameters: Vec<ParameterSyntax>,
    /// `part … { … }`
    pub parts: Vec<PartSyntax>,
    /// Its routes and blocks.
    pub content: ContentSyntax,
}

/// The keyword before `chain`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DimensionKeyword {
    /// `space`, or none
    Space,
    /// `plane`
    Plane,
    /// `line`
    Line,
}

/// `name = value;` or `name[times] = value;`
#[derive(Clone, Debug)]
pub struct ParameterSyntax {
    /// Name and value.
    pub field: FieldSyntax,
    /// The number of values, if there is one for each repetition of a part.
    pub repetitions: Option<usize>,
}

/// The routes and the blocks of a chain or of a part.
#[derive(Clone, Debug)]
pub struct ContentSyntax {
    /// The routes in the order written.
    pub routes: Vec<RouteSyntax>,
    /// `body … { … }`, `hinge … { … }`, `load … { … }` and `spring … { … }`
    pub blocks: Vec<BlockSyntax>,
    /// Whether every item was readable. If not, nothing is reported as missing.
    pub complete: bool,
}

impl ContentSyntax {
    /// Contains nothing.
    pub fn empty() -> Self {
        ContentSyntax { routes: Vec::new(), blocks: Vec::new(), complete: true }
    }
}

/// `part Name(parameter, …) { … }`
#[derive(Clone, Debug)]
pub struct PartSyntax {
    /// Its doc comments.
    pub docs: Vec<syn::Attribute>,
    /// Its name.
    pub name: Ident,
    /// Its parameters.
    pub parameters: Vec<Ident>,
    /// Its routes and blocks.
    pub content: ContentSyntax,
    /// Whether it follows the first route of the chain.
    pub after_route: bool,
}

/// A route: steps joined by arrows.
#[derive(Clone, Debug)]
pub struct RouteSyntax {
    /// Its first token.
    pub at: Span,
    /// The place at which it begins, if it begins with a place.
    pub start: Option<PathSyntax>,
    /// Its steps, in the order written.
    pub steps: Vec<StepSyntax>,
    /// Whether all of it was readable. If not, nothing is reported as missing.
    pub complete: bool,
}

impl RouteSyntax {
    /// Returns a route without steps that begins at this token.
    pub fn at(at: Span) -> Self {
        RouteSyntax { at, start: None, steps: Vec::new(), complete: true }
    }

    /// Returns whether all of it and of the repeated parts on it was readable.
    pub fn is_complete(&self) -> bool {
        self.complete
            && self.repeats().all(|repeat| repeat.routes.iter().all(RouteSyntax::is_complete))
    }

    /// Returns the repeated parts.
    pub fn repeats(&self) -> impl Iterator<Item = &RepeatSyntax> {
        self.steps.iter().filter_map(|step| match step {
            StepSyntax::Repeat(repeat) => Some(repeat),
            StepSyntax::Item(_) => None,
        })
    }

    /// Returns all items, including those of repeated parts.
    pub fn items(&self) -> Vec<&RouteItemSyntax> {
        let mut items = Vec::new();
        for step in &self.steps {
            match step {
                StepSyntax::Item(item) => items.push(item),
                StepSyntax::Repeat(repeat) => {
                    items.extend(repeat.routes.iter().flat_map(RouteSyntax::items));
                }
            }
        }
        items
    }
}

/// A step of a route.
#[derive(Clone, Debug)]
pub enum StepSyntax {
    /// A hinge, a body, an end or a part.
    Item(RouteItemSyntax),
    /// A repeated part.
    Repeat(RepeatSyntax),
}

/// `repeat count from seed, … { route; … }`
#[derive(Clone, Debug)]
pub struct RepeatSyntax {
    /// The span of the keyword.
    pub at: Span,
    /// The number of repetitions, at least one; `None` if it was not readable.
    pub count: Option<usize>,
    /// What places of the previous repetition are in the first repetition.
    pub seeds: Vec<SeedSyntax>,
    /// Its routes: the first one continues the outer route, the others are branches.
    pub routes: Vec<RouteSyntax>,
}

impl RepeatSyntax {
    /// An example for messages.
    pub const EXAMPLE: &str = "write it as in `repeat 100 { pin joint -> Rod rod }`";
}

/// `body.place = body.place` after `from`
#[derive(Clone, Debug)]
pub struct SeedSyntax {
    /// A place in the repeated part.
    pub place: PathSyntax,
    /// What it is in the first repetition.
    pub first: PathSyntax,
}

/// An item of a route.
#[derive(Clone, Debug)]
pub enum RouteItemSyntax {
    /// `ground [at position] [turned …]`
    Ground {
        /// The span of the keyword.
        at: Span,
        /// The position of the frame on the ground.
        position: Option<Box<ValueSyntax>>,
        /// The orientation of the frame on the ground.
        turned: Option<Box<OrientationSyntax>>,
        /// A name after it, which is an error.
        name: Option<Ident>,
    },
    /// `moving name`
    Moving {
        /// The span of the keyword.
        at: Span,
        /// The name.
        name: Option<Ident>,
    },
    /// A hinge with an error that is reported; only its name is readable.
    Unread {
        /// The name.
        name: Option<Ident>,
    },
    /// `kind(arguments) name`, `Type name` or `Part(arguments) name`
    Element {
        /// The kind of a hinge, the type of a body or the name of a part.
        word: Ident,
        /// The arguments after the word.
        arguments: Option<ArgumentsSyntax>,
        /// The name.
        name: Option<Ident>,
        /// The span of a position on it, as in `crank.lug` or `crank at lug`, which is an error.
        place: Option<Span>,
        /// Whether it follows an error, so that its words are not checked.
        after_error: bool,
    },
}
