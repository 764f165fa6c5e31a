//! The description as written: every part keeps the tokens that a message can point at.

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
    /// In how many directions it moves; nothing if the word for that is unknown.
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
    /// Whether every item could be read. If not, nothing is missed on its account.
    pub complete: bool,
}

/// Which word stands before `chain`.
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
    /// How many there are, if it is one for every time of a repeated part.
    pub repetitions: Option<usize>,
}

/// `name = value;`
#[derive(Debug)]
pub struct FieldSyntax {
    /// What is given.
    pub name: Ident,
    /// Its value; missing where it could not be read, which is reported already.
    pub value: Option<ValueSyntax>,
}

/// Which word a block begins with.
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
    /// What it speaks of.
    pub word: BlockKeyword,
    /// Where that word stands.
    pub at: Span,
    /// Whom it speaks of, at least one.
    pub names: Vec<Ident>,
    /// What it says.
    pub fields: Vec<FieldSyntax>,
    /// `point name = …;`
    pub points: Vec<FieldSyntax>,
    /// Whether every field has a name. If not, none is missed on its account.
    pub complete: bool,
    /// Whether it stands behind the route.
    pub after_route: bool,
}

/// Stops joined by arrows.
#[derive(Debug)]
pub struct RouteSyntax {
    /// In the order written; those that are repeated stand here once.
    pub items: Vec<RouteItemSyntax>,
    /// The parts of it that are repeated, in the order written.
    pub repeats: Vec<RepeatSyntax>,
    /// Whether all of it could be read. If not, nothing is missed on its account.
    pub complete: bool,
    /// Routes that are written after the first one, an error. Their stops are here too, so that the
    /// names on them are known.
    pub further: Vec<FurtherRoute>,
}

impl RouteSyntax {
    /// Adds a route that is written after this one and begins at this token.
    pub fn add(&mut self, at: Span, other: RouteSyntax) {
        let start = self.items.len();
        let moved = |items: Range<usize>| start + items.start..start + items.end;
        self.further.push(FurtherRoute { at, start });
        self.items.extend(other.items);
        let repeats = other.repeats.into_iter();
        self.repeats
            .extend(repeats.map(|repeat| RepeatSyntax { items: moved(repeat.items), ..repeat }));
        // The two may be parts of one.
        self.complete = false;
    }

    /// How many stops the first route has.
    pub fn first_end(&self) -> usize {
        self.further.first().map_or(self.items.len(), |further| further.start)
    }
}

/// A route that is written after the first one.
#[derive(Debug)]
pub struct FurtherRoute {
    /// Its first token.
    pub at: Span,
    /// Its first stop among those of all routes.
    pub start: usize,
}

/// `repeat count { item -> … }`
#[derive(Debug)]
pub struct RepeatSyntax {
    /// Where the word stands.
    pub at: Span,
    /// How many times its stops stand in a row, at least once; missing where it could not be read.
    pub count: Option<usize>,
    /// Its stops, at least one, among those of the route.
    pub items: Range<usize>,
}

impl RepeatSyntax {
    /// How one is written, for messages.
    pub const EXAMPLE: &str = "write it as in `repeat 100 { pin joint -> Rod rod }`";
}

/// A stop of the route.
#[derive(Debug)]
pub enum RouteItemSyntax {
    /// `ground [at position] [turned …]`
    Ground {
        /// The word itself.
        at: Span,
        /// Where the frame on the ground sits.
        position: Option<Box<ValueSyntax>>,
        /// How the frame on the ground is turned.
        turned: Option<Box<OrientationSyntax>>,
    },
    /// `moving name`
    Moving {
        /// The word itself.
        at: Span,
        /// The name.
        name: Option<Ident>,
    },
    /// A hinge of which only the name could be read, which is reported.
    Unread {
        /// The name.
        name: Option<Ident>,
    },
    /// `kind(arguments) name` or `Type name`
    Element {
        /// The kind of a hinge or the type of a body.
        word: Ident,
        /// What stands in parentheses behind the word.
        arguments: Option<ArgumentsSyntax>,
        /// The name.
        name: Option<Ident>,
        /// Where a place on it is written, as in `crank.lug` or `crank at lug`, an error.
        place: Option<Span>,
        /// Whether it follows on an error, so that no word of it is judged.
        after_error: bool,
    },
}

/// What stands in parentheses behind the kind of a hinge.
#[derive(Debug)]
pub struct ArgumentsSyntax {
    /// Separated by commas.
    pub values: Vec<ValueSyntax>,
    /// The parentheses and all in them.
    pub extent: SpanRange,
}

/// Anything that can stand behind `=`.
#[derive(Debug)]
pub enum ValueSyntax {
    /// A number, with or without a unit, or a single word.
    Number(ExprSyntax),
    /// `[a, b, c] unit`
    Vector(ListSyntax),
    /// `[a, b, c] unit turned orientation`, or with a number in place of the vector
    Turned(Box<ValueSyntax>, OrientationSyntax),
    /// `word(a, b, …) unit about word`
    FormSyntax(FormSyntax),
    /// `a unit about word`
    About(ExprSyntax, Ident),
    /// `body.point` or `body at point`, an error: the body, and all of it.
    PlaceOn(Ident, SpanRange),
}

/// What stands behind `turned`.
#[derive(Debug)]
pub enum OrientationSyntax {
    /// The angle of a turn about an axis that needs not be named.
    Angle(ExprSyntax),
    /// `word(a, b, …) unit`
    FormSyntax(FormSyntax),
}

impl OrientationSyntax {
    /// From the first to the last token.
    pub fn extent(&self) -> SpanRange {
        match self {
            OrientationSyntax::Angle(angle) => angle.extent,
            OrientationSyntax::FormSyntax(form) => form.extent(),
        }
    }
}

impl ValueSyntax {
    /// From the first to the last token.
    pub fn extent(&self) -> SpanRange {
        match self {
            ValueSyntax::Number(expr) => expr.extent,
            ValueSyntax::Vector(list) => list.extent,
            ValueSyntax::Turned(position, turn) => position.extent().to(turn.extent()),
            ValueSyntax::FormSyntax(form) => form.extent(),
            ValueSyntax::About(expr, point) => expr.extent.to(SpanRange::token(point.span())),
            ValueSyntax::PlaceOn(_, extent) => *extent,
        }
    }

    /// What it is, for messages.
    pub fn described(&self) -> String {
        match self {
            ValueSyntax::Number(ExprSyntax { kind: ExprKind::Name(word), .. }) => {
                format!("`{word}`")
            }
            ValueSyntax::Number(_) => "a number".into(),
            ValueSyntax::Vector(_) => "a vector".into(),
            ValueSyntax::Turned(..) => "a rotated frame".into(),
            ValueSyntax::FormSyntax(form) => format!("`{}(…)`", form.word),
            ValueSyntax::About(..) => "a number about a point".into(),
            ValueSyntax::PlaceOn(body, _) => format!("a point of `{body}`"),
        }
    }
}

/// Numbers with a common unit: `a, b, c` in brackets or parentheses, and the unit behind.
#[derive(Debug)]
pub struct ListSyntax {
    /// Between the brackets.
    pub entries: Vec<ExprSyntax>,
    /// Behind the brackets.
    pub unit: Option<UnitSyntax>,
    /// The brackets with all in them, without the unit.
    pub extent: SpanRange,
}

/// `word(a, b, …) unit about word`, such as `rpy(0, 0, 90) deg`.
#[derive(Debug)]
pub struct FormSyntax {
    /// In front of the parentheses.
    pub word: Ident,
    /// In the parentheses, with the unit behind them.
    pub list: ListSyntax,
    /// Behind `about`.
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
    /// `a kg`: a product and the unit that closes it.
    Quantity(Box<ExprSyntax>, UnitSyntax),
    /// `sqrt(a)`
    Call(Ident, Vec<ExprSyntax>),
}

/// A term of a sum.
#[derive(Debug)]
pub struct TermSyntax {
    /// Whether it is taken away.
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
    /// Parentheses in it, a mistake.
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
    /// Its power, negative behind `/`.
    pub power: i32,
}
