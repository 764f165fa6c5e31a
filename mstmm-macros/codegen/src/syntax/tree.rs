//! The syntax tree of blocks and values: every node keeps the spans that messages point at.

pub use crate::diag::SpanRange;

use proc_macro2::{Ident, Span, TokenStream};
use std::fmt;
use std::rc::Rc;

/// `name = value;`
#[derive(Clone, Debug)]
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
#[derive(Clone, Debug)]
pub struct BlockSyntax {
    /// Its keyword.
    pub word: BlockKeyword,
    /// The span of the keyword.
    pub at: Span,
    /// The paths of what it describes, at least one.
    pub names: Vec<PathSyntax>,
    /// Its fields.
    pub fields: Vec<FieldSyntax>,
    /// `point name = …;`
    pub points: Vec<FieldSyntax>,
    /// Whether every field has a name. If not, no field is reported as missing.
    pub complete: bool,
    /// Whether it follows the first route; in a part, whether it is no body type.
    pub after_route: bool,
    /// The number of routes before it.
    pub routes_before: usize,
}

/// The arguments of a hinge.
#[derive(Clone, Debug)]
pub struct ArgumentsSyntax {
    /// Separated by commas.
    pub values: Vec<ValueSyntax>,
    /// The parentheses and their content.
    pub extent: SpanRange,
}

/// A value: anything that may follow `=`.
#[derive(Clone, Debug)]
pub enum ValueSyntax {
    /// A number, with or without a unit, or a single word.
    Number(ExprSyntax),
    /// `[a, b, c] unit`
    Vector(ListSyntax),
    /// `[a, b, c] unit turned orientation`, or with a number or a form in place of the vector
    Turned(Box<ValueSyntax>, OrientationSyntax),
    /// `word(a, b, …) unit about word`
    Form(FormSyntax),
    /// `a unit about word`
    About(ExprSyntax, Ident),
    /// A path of several names, such as `body.point`
    Path(PathSyntax),
    /// `shape`, or `[shape, …]`
    Shapes(ShapesSyntax),
    /// `body at point`, an error: the body, and the span of all.
    PlaceOn(Ident, SpanRange),
}

/// The orientation after `turned`.
#[derive(Clone, Debug)]
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
            ValueSyntax::Path(path) => path.extent(),
            ValueSyntax::Shapes(list) => list.extent,
            ValueSyntax::PlaceOn(_, extent) => *extent,
        }
    }

    /// Describes the value for messages.
    pub fn described(&self) -> String {
        match self {
            ValueSyntax::Number(ExprSyntax {
                kind: ExprKind::Name(word) | ExprKind::Argument(word, _),
                ..
            }) => format!("`{word}`"),
            ValueSyntax::Number(ExprSyntax { kind: ExprKind::Parenthesized(inner), .. }) => {
                match &inner.kind {
                    ExprKind::Name(word) => format!("`({word})`"),
                    _ => "a number".into(),
                }
            }
            ValueSyntax::Number(_) => "a number".into(),
            ValueSyntax::Vector(_) => "a vector".into(),
            ValueSyntax::Turned(..) => "a rotated frame".into(),
            ValueSyntax::Form(form) => format!("`{}(…)`", form.word),
            ValueSyntax::About(..) => "a number about a point".into(),
            ValueSyntax::Path(path) => format!("`{path}`"),
            ValueSyntax::Shapes(_) => "a shape".into(),
            ValueSyntax::PlaceOn(body, _) => format!("a point of `{body}`"),
        }
    }
}

/// Names joined by points: instances of parts, then a body or a hinge, then a place of a body.
#[derive(Clone, Debug)]
pub struct PathSyntax {
    /// The span of `last`, if it is a place of the previous repetition.
    pub last: Option<Span>,
    /// The names, at least one.
    pub names: Vec<Ident>,
}

impl PathSyntax {
    /// Returns the path of a single name.
    pub fn name(name: Ident) -> Self {
        PathSyntax { last: None, names: vec![name] }
    }

    /// Returns the last name.
    pub fn end(&self) -> &Ident {
        self.names.last().unwrap_or_else(|| bug!("a path has no names"))
    }

    /// From the first to the last name.
    pub fn extent(&self) -> SpanRange {
        let names = SpanRange::token(self.names[0].span()).to(SpanRange::token(self.end().span()));
        self.last.map_or(names, |last| SpanRange::token(last).to(names))
    }
}

impl fmt::Display for PathSyntax {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        if self.last.is_some() {
            f.write_str("last.")?;
        }
        for (index, name) in self.names.iter().enumerate() {
            let point = if index > 0 { "." } else { "" };
            write!(f, "{point}{name}")?;
        }
        Ok(())
    }
}

/// Numbers with a common unit: `a, b, c` in brackets or parentheses, and the unit after them.
#[derive(Clone, Debug)]
pub struct ListSyntax {
    /// The numbers between the brackets.
    pub entries: Vec<ExprSyntax>,
    /// The unit after the brackets.
    pub unit: Option<UnitSyntax>,
    /// The brackets and their content, without the unit.
    pub extent: SpanRange,
}

/// `word(a, b, …) unit about word`, such as `rpy(0, 0, 90) deg`.
#[derive(Clone, Debug)]
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

/// The shapes of a body.
#[derive(Clone, Debug)]
pub struct ShapesSyntax {
    /// The shapes, at least one.
    pub shapes: Vec<ShapeSyntax>,
    /// From the first to the last token.
    pub extent: SpanRange,
}

/// `word(arguments) at [x, y, z] turned orientation`
#[derive(Clone, Debug)]
pub struct ShapeSyntax {
    /// The kind.
    pub word: Ident,
    /// The arguments, each with its name if it has one.
    pub arguments: Vec<(Option<Ident>, ShapeArgument)>,
    /// The parentheses around the arguments.
    pub parentheses: SpanRange,
    /// The position after `at`.
    pub position: Option<ValueSyntax>,
    /// The orientation after `turned`.
    pub orientation: Option<OrientationSyntax>,
    /// From the first to the last token.
    pub extent: SpanRange,
}

/// An argument of a shape.
#[derive(Clone, Debug)]
pub enum ShapeArgument {
    /// A number or a vector.
    Value(ValueSyntax),
    /// Text in quotes, without them.
    Text(String, SpanRange),
}

/// A number as written.
#[derive(Clone, Debug)]
pub struct ExprSyntax {
    /// What it is.
    pub kind: ExprKind,
    /// From the first to the last token.
    pub extent: SpanRange,
}

/// What a number is made of.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// A literal.
    Number(f64),
    /// A single identifier.
    Name(Ident),
    /// `(a)`: a name in parentheses, which is no keyword.
    Parenthesized(Box<ExprSyntax>),
    /// A parameter of a part, which is written out: its name and its argument.
    Argument(Ident, Rc<ExprSyntax>),
    /// A number with an error that is reported.
    Lost,
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
#[derive(Clone, Debug)]
pub struct TermSyntax {
    /// Whether it is subtracted.
    pub negative: bool,
    /// The term.
    pub expr: ExprSyntax,
}

/// A factor of a product.
#[derive(Clone, Debug)]
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
