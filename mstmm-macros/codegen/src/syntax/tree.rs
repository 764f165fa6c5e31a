//! The syntax tree: every node keeps the spans that messages point at.

pub use crate::diag::SpanRange;

use proc_macro2::{Ident, Span, TokenStream};
use std::ops::Range;

/// A chain as written.
#[derive(Debug)]
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
    /// `body … { … }`, `hinge … { … }`, `load … { … }` and `spring … { … }`
    pub blocks: Vec<BlockSyntax>,
    /// The route; missing if there is none.
    pub route: Option<RouteSyntax>,
    /// Whether every item was readable. If not, nothing is reported as missing.
    pub complete: bool,
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
#[derive(Debug)]
pub struct ParameterSyntax {
    /// Name and value.
    pub field: FieldSyntax,
    /// The number of values, if there is one for each repetition of a part.
    pub repetitions: Option<usize>,
}

/// `name = value;`
#[derive(Debug)]
pub struct FieldSyntax {
    /// What is given.
    pub name: Ident,
    /// Its value; `None` if it was not readable, which is reported already.
    pub value: Option<ValueSyntax>,
}

/// The keyword of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockKeyword {
    /// `body`
    Body,
    /// `hinge`
    Hinge,
    /// `load`
    Load,
    /// `spring`
    Spring,
}

/// `body name { … }`, `hinge name, … { … }`, `load name { … }` or `spring name { … }`
#[derive(Debug)]
pub struct BlockSyntax {
    /// Its keyword.
    pub word: BlockKeyword,
    /// The span of the keyword.
    pub at: Span,
    /// The names that it describes, at least one.
    pub names: Vec<Ident>,
    /// Its fields.
    pub fields: Vec<FieldSyntax>,
    /// `point name = …;`
    pub points: Vec<FieldSyntax>,
    /// Whether every field has a name. If not, no field is reported as missing.
    pub complete: bool,
    /// Whether it follows the route.
    pub after_route: bool,
}

/// Route items joined by arrows.
#[derive(Debug)]
pub struct RouteSyntax {
    /// The items in the order written; repeated ones are here once.
    pub items: Vec<RouteItemSyntax>,
    /// The repeated parts in the order written.
    pub repeats: Vec<RepeatSyntax>,
    /// Whether all of it was readable. If not, nothing is reported as missing.
    pub complete: bool,
    /// Further routes, which are an error. Their items are in `items` too, so that their names are
    /// known.
    pub further: Vec<FurtherRoute>,
}

impl RouteSyntax {
    /// Adds a further route that begins at this token.
    pub fn add(&mut self, at: Span, other: RouteSyntax) {
        let start = self.items.len();
        let moved = |items: Range<usize>| start + items.start..start + items.end;
        self.further.push(FurtherRoute { at, start });
        self.items.extend(other.items);
        let repeats = other.repeats.into_iter();
        self.repeats
            .extend(repeats.map(|repeat| RepeatSyntax { items: moved(repeat.items), ..repeat }));
        // Both may be parts of one route.
        self.complete = false;
    }

    /// Returns the number of items of the first route.
    pub fn first_end(&self) -> usize {
        self.further.first().map_or(self.items.len(), |further| further.start)
    }
}

/// A further route.
#[derive(Debug)]
pub struct FurtherRoute {
    /// Its first token.
    pub at: Span,
    /// The index of its first item among those of all routes.
    pub start: usize,
}

/// `repeat count { item -> … }`
#[derive(Debug)]
pub struct RepeatSyntax {
    /// The span of the keyword.
    pub at: Span,
    /// The number of repetitions, at least one; `None` if it was not readable.
    pub count: Option<usize>,
    /// The indices of its items, at least one, among those of the route.
    pub items: Range<usize>,
}

impl RepeatSyntax {
    /// An example for messages.
    pub const EXAMPLE: &str = "write it as in `repeat 100 { pin joint -> Rod rod }`";
}

/// An item of the route.
#[derive(Debug)]
pub enum RouteItemSyntax {
    /// `ground [at position] [turned …]`
    Ground {
        /// The span of the keyword.
        at: Span,
        /// The position of the frame on the ground.
        position: Option<Box<ValueSyntax>>,
        /// The orientation of the frame on the ground.
        turned: Option<Box<OrientationSyntax>>,
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
    /// `kind(arguments) name` or `Type name`
    Element {
        /// The kind of a hinge or the type of a body.
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

/// The arguments of a hinge.
#[derive(Debug)]
pub struct ArgumentsSyntax {
    /// Separated by commas.
    pub values: Vec<ValueSyntax>,
    /// The parentheses and their content.
    pub extent: SpanRange,
}

/// A value: anything that may follow `=`.
#[derive(Debug)]
pub enum ValueSyntax {
    /// A number, with or without a unit, or a single word.
    Number(ExprSyntax),
    /// `[a, b, c] unit`
    Vector(ListSyntax),
    /// `[a, b, c] unit turned orientation`, or with a number in place of the vector
    Turned(Box<ValueSyntax>, OrientationSyntax),
    /// `word(a, b, …) unit about word`
    Form(FormSyntax),
    /// `a unit about word`
    About(ExprSyntax, Ident),
    /// `body.point` or `body at point`, an error: the body, and the span of all.
    PlaceOn(Ident, SpanRange),
}

/// The orientation after `turned`.
#[derive(Debug)]
pub enum OrientationSyntax {
    /// The angle of a rotation about an axis that is known.
    Angle(ExprSyntax),
    /// `word(a, b, …) unit`
    Form(FormSyntax),
}

impl OrientationSyntax {
    /// From the first to the last token.
    pub fn extent(&self) -> SpanRange {
        match self {
            OrientationSyntax::Angle(angle) => angle.extent,
            OrientationSyntax::Form(form) => form.extent(),
        }
    }
}

impl ValueSyntax {
    /// From the first to the last token.
    pub fn extent(&self) -> SpanRange {
        match self {
            ValueSyntax::Number(expr) => expr.extent,
            ValueSyntax::Vector(list) => list.extent,
            ValueSyntax::Turned(position, orientation) => {
                position.extent().to(orientation.extent())
            }
            ValueSyntax::Form(form) => form.extent(),
            ValueSyntax::About(expr, point) => expr.extent.to(SpanRange::token(point.span())),
            ValueSyntax::PlaceOn(_, extent) => *extent,
        }
    }

    /// Describes the value for messages.
    pub fn described(&self) -> String {
        match self {
            ValueSyntax::Number(ExprSyntax { kind: ExprKind::Name(word), .. }) => {
                format!("`{word}`")
            }
            ValueSyntax::Number(_) => "a number".into(),
            ValueSyntax::Vector(_) => "a vector".into(),
            ValueSyntax::Turned(..) => "a rotated frame".into(),
            ValueSyntax::Form(form) => format!("`{}(…)`", form.word),
            ValueSyntax::About(..) => "a number about a point".into(),
            ValueSyntax::PlaceOn(body, _) => format!("a point of `{body}`"),
        }
    }
}

/// Numbers with a common unit: `a, b, c` in brackets or parentheses, and the unit after them.
#[derive(Debug)]
pub struct ListSyntax {
    /// The numbers between the brackets.
    pub entries: Vec<ExprSyntax>,
    /// The unit after the brackets.
    pub unit: Option<UnitSyntax>,
    /// The brackets and their content, without the unit.
    pub extent: SpanRange,
}

/// `word(a, b, …) unit about word`, such as `rpy(0, 0, 90) deg`.
#[derive(Debug)]
pub struct FormSyntax {
    /// The keyword before the parentheses.
    pub word: Ident,
    /// The numbers in the parentheses and the unit after them.
    pub list: ListSyntax,
    /// The point after `about`.
    pub about: Option<Ident>,
}

impl FormSyntax {
    /// From the word to the closing parenthesis.
    pub fn extent(&self) -> SpanRange {
        SpanRange::token(self.word.span()).to(self.list.extent)
    }
}

/// A number as written.
#[derive(Debug)]
pub struct ExprSyntax {
    /// What it is.
    pub kind: ExprKind,
    /// From the first to the last token.
    pub extent: SpanRange,
}

/// What a number is made of.
#[derive(Debug)]
pub enum ExprKind {
    /// A literal.
    Number(f64),
    /// A single identifier.
    Name(Ident),
    /// A Rust path of several segments, unread.
    Path(TokenStream),
    /// `-a`
    Negated(Box<ExprSyntax>),
    /// `a + b - c`
    Sum(Vec<TermSyntax>),
    /// `a * b / c`
    Product(Vec<FactorSyntax>),
    /// `a ^ 2`
    Power(Box<ExprSyntax>, i32),
    /// `a kg`: a product and the unit at its end.
    Quantity(Box<ExprSyntax>, UnitSyntax),
    /// `sqrt(a)`
    Call(Ident, Vec<ExprSyntax>),
}

/// A term of a sum.
#[derive(Debug)]
pub struct TermSyntax {
    /// Whether it is subtracted.
    pub negative: bool,
    /// The term.
    pub expr: ExprSyntax,
}

/// A factor of a product.
#[derive(Debug)]
pub struct FactorSyntax {
    /// Whether it divides.
    pub divides: bool,
    /// The factor.
    pub expr: ExprSyntax,
}

/// A unit as written: `kg*m^2`.
#[derive(Clone, Debug)]
pub struct UnitSyntax {
    /// Its parts, at least one.
    pub factors: Vec<UnitFactorSyntax>,
    /// Parentheses in it, which are an error.
    pub parentheses: Option<SpanRange>,
    /// From the first to the last token.
    pub extent: SpanRange,
}

/// A part of a unit.
#[derive(Clone, Debug)]
pub struct UnitFactorSyntax {
    /// The symbol of the unit with its prefix.
    pub symbol: String,
    /// Where it stands.
    pub at: Span,
    /// Its power, negative after `/`.
    pub power: i32,
}
