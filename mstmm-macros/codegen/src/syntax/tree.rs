//! The description as written: every part keeps the tokens that a message can point at.

pub use crate::diag::Extent;

use proc_macro2::{Ident, Span, TokenStream};
use std::ops::Range;

/// A chain as written.
#[derive(Debug)]
pub struct ChainDef {
    /// Doc comments and attributes in front.
    pub attributes: Vec<syn::Attribute>,
    /// Visibility of the generated types.
    pub visibility: syn::Visibility,
    /// In how many directions it moves; nothing if the word for that is unknown.
    pub dimension: Option<DimensionWord>,
    /// The chain's name.
    pub name: Ident,
    /// `gravity = …;` and `method = …;`
    pub settings: Vec<Field>,
    /// `param name = …;` and `param name[times] = …;`
    pub parameters: Vec<ParameterDef>,
    /// `body … { … }`, `hinge … { … }`, `load … { … }` and `spring … { … }`
    pub blocks: Vec<Block>,
    /// The route; missing if there is none.
    pub route: Option<Route>,
    /// Whether every item could be read. If not, nothing is missed on its account.
    pub whole: bool,
}

/// Which word stands before `chain`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DimensionWord {
    /// `space`, or none
    Space,
    /// `plane`
    Plane,
    /// `line`
    Line,
}

/// `name = value;` or `name[times] = value;`
#[derive(Debug)]
pub struct ParameterDef {
    /// Name and value.
    pub field: Field,
    /// How many there are, if it is one for every time of a repeated part.
    pub times: Option<usize>,
}

/// `name = value;`
#[derive(Debug)]
pub struct Field {
    /// What is given.
    pub name: Ident,
    /// Its value; missing where it could not be read, which is reported already.
    pub value: Option<Written>,
}

/// Which word a block begins with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockWord {
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
pub struct Block {
    /// What it speaks of.
    pub word: BlockWord,
    /// Where that word stands.
    pub at: Span,
    /// Whom it speaks of, at least one.
    pub names: Vec<Ident>,
    /// What it says.
    pub fields: Vec<Field>,
    /// `point name = …;`
    pub points: Vec<Field>,
    /// Whether every field has a name. If not, none is missed on its account.
    pub whole: bool,
    /// Whether it stands behind the route.
    pub after_route: bool,
}

/// Stops joined by arrows.
#[derive(Debug)]
pub struct Route {
    /// In the order written; those that are repeated stand here once.
    pub stops: Vec<Stop>,
    /// The parts of it that are repeated, in the order written.
    pub repeats: Vec<Repeat>,
    /// Whether all of it could be read. If not, nothing is missed on its account.
    pub whole: bool,
    /// Routes that are written after the first one, an error. Their stops are here too, so that the
    /// names on them are known.
    pub further: Vec<Further>,
}

impl Route {
    /// Adds a route that is written after this one and begins at this token.
    pub fn add(&mut self, at: Span, other: Route) {
        let start = self.stops.len();
        let moved = |stops: Range<usize>| start + stops.start..start + stops.end;
        self.further.push(Further { at, start });
        self.stops.extend(other.stops);
        let repeats = other.repeats.into_iter();
        self.repeats.extend(repeats.map(|repeat| Repeat { stops: moved(repeat.stops), ..repeat }));
        // The two may be parts of one.
        self.whole = false;
    }

    /// How many stops the first route has.
    pub fn first_end(&self) -> usize {
        self.further.first().map_or(self.stops.len(), |further| further.start)
    }
}

/// A route that is written after the first one.
#[derive(Debug)]
pub struct Further {
    /// Its first token.
    pub at: Span,
    /// Its first stop among those of all routes.
    pub start: usize,
}

/// `repeat count { stop -> … }`
#[derive(Debug)]
pub struct Repeat {
    /// Where the word stands.
    pub at: Span,
    /// How many times its stops stand in a row, at least once; missing where it could not be read.
    pub count: Option<usize>,
    /// Its stops, at least one, among those of the route.
    pub stops: Range<usize>,
}

impl Repeat {
    /// How one is written, for messages.
    pub const EXAMPLE: &str = "write it as in `repeat 100 { pin joint -> Rod rod }`";
}

/// A stop of the route.
#[derive(Debug)]
pub enum Stop {
    /// `ground [at position] [turned …]`
    Ground {
        /// The word itself.
        at: Span,
        /// Where the frame on the ground sits.
        position: Option<Box<Written>>,
        /// How the frame on the ground is turned.
        turned: Option<Box<Turn>>,
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
        arguments: Option<Arguments>,
        /// The name.
        name: Option<Ident>,
        /// Where a place on it is written, as in `crank.lug` or `crank at lug`, an error.
        place: Option<Span>,
        /// Whether it follows on an error, so that no word of it is judged.
        doubtful: bool,
    },
}

/// What stands in parentheses behind the kind of a hinge.
#[derive(Debug)]
pub struct Arguments {
    /// Separated by commas.
    pub values: Vec<Written>,
    /// The parentheses and all in them.
    pub extent: Extent,
}

/// Anything that can stand behind `=`.
#[derive(Debug)]
pub enum Written {
    /// A number, with or without a unit, or a single word.
    Number(Expr),
    /// `[a, b, c] unit`
    Vector(List),
    /// `[a, b, c] unit turned orientation`, or with a number in place of the vector
    Turned(Box<Written>, Turn),
    /// `word(a, b, …) unit about word`
    Form(Form),
    /// `a unit about word`
    About(Expr, Ident),
    /// `body.point` or `body at point`, an error: the body, and all of it.
    PlaceOn(Ident, Extent),
}

/// What stands behind `turned`.
#[derive(Debug)]
pub enum Turn {
    /// The angle of a turn about an axis that needs not be named.
    Angle(Expr),
    /// `word(a, b, …) unit`
    Form(Form),
}

impl Turn {
    /// From the first to the last token.
    pub fn extent(&self) -> Extent {
        match self {
            Turn::Angle(angle) => angle.extent,
            Turn::Form(form) => form.extent(),
        }
    }
}

impl Written {
    /// From the first to the last token.
    pub fn extent(&self) -> Extent {
        match self {
            Written::Number(expr) => expr.extent,
            Written::Vector(list) => list.extent,
            Written::Turned(position, turn) => position.extent().to(turn.extent()),
            Written::Form(form) => form.extent(),
            Written::About(expr, point) => expr.extent.to(Extent::token(point.span())),
            Written::PlaceOn(_, extent) => *extent,
        }
    }

    /// What it is, for messages.
    pub fn described(&self) -> String {
        match self {
            Written::Number(Expr { kind: ExprKind::Name(word), .. }) => format!("`{word}`"),
            Written::Number(_) => "a number".into(),
            Written::Vector(_) => "a vector".into(),
            Written::Turned(..) => "a turned frame".into(),
            Written::Form(form) => format!("`{}(…)`", form.word),
            Written::About(..) => "a number about a point".into(),
            Written::PlaceOn(body, _) => format!("a point of `{body}`"),
        }
    }
}

/// Numbers with a common unit: `a, b, c` in brackets or parentheses, and the unit behind.
#[derive(Debug)]
pub struct List {
    /// Between the brackets.
    pub entries: Vec<Expr>,
    /// Behind the brackets.
    pub unit: Option<Unit>,
    /// The brackets with all in them, without the unit.
    pub extent: Extent,
}

/// `word(a, b, …) unit about word`, such as `rpy(0, 0, 90) deg`.
#[derive(Debug)]
pub struct Form {
    /// In front of the parentheses.
    pub word: Ident,
    /// In the parentheses, with the unit behind them.
    pub list: List,
    /// Behind `about`.
    pub about: Option<Ident>,
}

impl Form {
    /// From the word to the closing parenthesis.
    pub fn extent(&self) -> Extent {
        Extent::token(self.word.span()).to(self.list.extent)
    }
}

/// A number as written.
#[derive(Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// From the first to the last token.
    pub extent: Extent,
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
    Negated(Box<Expr>),
    /// `a + b - c`
    Sum(Vec<Term>),
    /// `a * b / c`
    Product(Vec<Factor>),
    /// `a ^ 2`
    Power(Box<Expr>, i32),
    /// `a kg`: a product and the unit that closes it.
    Quantity(Box<Expr>, Unit),
    /// `sqrt(a)`
    Call(Ident, Vec<Expr>),
}

/// A term of a sum.
#[derive(Debug)]
pub struct Term {
    /// Whether it is taken away.
    pub negative: bool,
    /// The term.
    pub expr: Expr,
}

/// A factor of a product.
#[derive(Debug)]
pub struct Factor {
    /// Whether it divides.
    pub divides: bool,
    /// The factor.
    pub expr: Expr,
}

/// A unit as written: `kg*m^2`.
#[derive(Clone, Debug)]
pub struct Unit {
    /// Its parts, at least one.
    pub factors: Vec<UnitFactor>,
    /// Parentheses in it, a mistake.
    pub parentheses: Option<Extent>,
    /// From the first to the last token.
    pub extent: Extent,
}

/// A part of a unit.
#[derive(Clone, Debug)]
pub struct UnitFactor {
    /// The symbol of the unit with its prefix.
    pub symbol: String,
    /// Where it stands.
    pub at: Span,
    /// Its power, negative behind `/`.
    pub power: i32,
}
