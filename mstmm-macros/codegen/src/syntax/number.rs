//! Numbers: sums of products, each of which may end with a unit.

use proc_macro2::{Delimiter, Ident, Span, TokenStream};
use syn::{Error, Lit, Result};

use super::cursor::Cursor;
use super::tree::{ExprKind, ExprSyntax, FactorSyntax, SpanRange, TermSyntax, UnitSyntax};
use super::unit;

/// The maximum number of terms in a sum or of factors in a product: formulas are traversed by
/// recursion.
const MOST_PARTS: usize = 256;

/// The maximum length of a literal: an `f64` cannot hold more digits, and long literals are slow to
/// parse.
const LONGEST_LITERAL: usize = 100;

/// The largest count of a `repeat`.
const MOST_TIMES: usize = 10_000_000;

/// The message for numbers before or after a vector.
pub(super) const INSIDE: &str = "write signs and factors inside the brackets";

/// The message for values in other brackets.
pub(super) const SQUARE: &str = "write several values in square brackets: `[…, …]`";

/// The keywords of forms.
pub const FORMS: &[&str] = &["rpy", "quaternion", "diag", "tensor", "matrix"];

/// The functions of numbers.
pub const FUNCTIONS: &[&str] = &["sqrt", "sin", "cos"];

/// `a + b - c`
pub(super) fn number(input: &mut Cursor) -> Result<ExprSyntax> {
    input.check_depth()?;
    let first = product(input)?;
    let start = first.extent;
    if !is_sign_next(input) {
        return Ok(first);
    }
    let mut terms = vec![TermSyntax { negative: false, expr: first }];
    while is_sign_next(input) {
        let negative = input.peek_punct('-');
        input.any();
        terms.push(TermSyntax { negative, expr: product(input)? });
        check_length(terms.len(), input)?;
    }
    Ok(ExprSyntax { kind: ExprKind::Sum(terms), extent: start.to(input.last()) })
}

/// Returns whether an operator is next.
pub(super) fn is_operator_next(input: &Cursor) -> bool {
    ['*', '/', '^'].iter().any(|&sign| input.peek_punct(sign)) || is_sign_next(input)
}

/// Returns whether a sign is next. `->` is an arrow of the route, never a minus.
fn is_sign_next(input: &Cursor) -> bool {
    input.peek_punct('+') || (input.peek_punct('-') && !input.peek_pair('-', '>'))
}

/// `a * b / c unit`
fn product(input: &mut Cursor) -> Result<ExprSyntax> {
    let mut factors = Vec::new();
    let mut divides = false;
    let start = SpanRange::token(input.next_span());
    let unit = loop {
        let (expr, suffix) = factor(input)?;
        factors.push(FactorSyntax { divides, expr });
        check_length(factors.len(), input)?;
        let unit = match suffix {
            Some((symbol, at)) => Some(unit::beginning_with(input, symbol, at)?),
            None => unit::optional(input)?,
        };
        if unit.is_none() && input.peek_pair('*', '*') {
            return Err(Error::new(input.next_span(), unit::POWERS));
        }
        if unit.is_some() || !(input.peek_punct('*') || input.peek_punct('/')) {
            break unit;
        }
        divides = input.peek_punct('/');
        input.any();
    };
    let extent = start.to(input.last());
    let product = match factors.pop() {
        Some(only) if factors.is_empty() => only.expr,
        last => {
            factors.extend(last);
            let extent = factors_extent(start, &factors);
            ExprSyntax { kind: ExprKind::Product(factors), extent }
        }
    };
    let Some(unit) = unit else { return Ok(product) };
    check_closed(input, &unit)?;
    Ok(ExprSyntax { kind: ExprKind::Quantity(product.into(), unit), extent })
}

fn factors_extent(start: SpanRange, factors: &[FactorSyntax]) -> SpanRange {
    factors.last().map_or(start, |last| start.to(last.expr.extent))
}

/// Reports a factor after a unit: in `2 kg * 3` the unit would seem to be multiplied.
fn check_closed(input: &Cursor, unit: &UnitSyntax) -> Result<()> {
    if input.peek_pair('*', '*') {
        return Err(Error::new(input.next_span(), unit::POWERS));
    }
    let sign = match (input.peek_punct('*'), input.peek_punct('/')) {
        (true, _) => '*',
        (_, true) => '/',
        _ => return Ok(()),
    };
    let unit = unit.text();
    Err(Error::new(
        input.next_span(),
        format!("a unit ends a product: write `(… {unit}) {sign} …` to continue it"),
    ))
}

/// A unit directly after the digits, as in `0.5kg`.
type Suffix = Option<(String, Span)>;

/// `-a ^ 2`
fn factor(input: &mut Cursor) -> Result<(ExprSyntax, Suffix)> {
    let start = SpanRange::token(input.next_span());
    let mut negative = false;
    // A loop instead of recursion: any number of signs may be written.
    while input.punct('-').is_some() {
        negative = !negative;
    }
    let (mut expr, suffix) = primary(input)?;
    if suffix.is_none() && input.punct('^').is_some() {
        let power = unit::exponent(input)?;
        let extent = expr.extent.to(input.last());
        expr = ExprSyntax { kind: ExprKind::Power(expr.into(), power), extent };
    }
    let extent = start.to(expr.extent);
    expr = match negative {
        true => ExprSyntax { kind: ExprKind::Negated(expr.into()), extent },
        false => ExprSyntax { extent, ..expr },
    };
    Ok((expr, suffix))
}

fn primary(input: &mut Cursor) -> Result<(ExprSyntax, Suffix)> {
    // `macro_rules!` passes an expression in a group without delimiters.
    for delimiter in [Delimiter::None, Delimiter::Parenthesis] {
        if let Some((mut inside, extent)) = input.group(delimiter) {
            let expr = number(&mut inside)?;
            if inside.peek_punct(',') {
                let message = match expr.kind {
                    ExprKind::Name(_) => SQUARE,
                    _ => "write vectors as `[x, y, z]`",
                };
                return Err(Error::new(extent.first, message));
            }
            inside.check_empty("an operator or `)`")?;
            let kind = match (expr.kind, delimiter) {
                (kind @ ExprKind::Name(_), Delimiter::Parenthesis) => {
                    ExprKind::Parenthesized(ExprSyntax { kind, extent: expr.extent }.into())
                }
                (kind, _) => kind,
            };
            return Ok((ExprSyntax { kind, extent }, None));
        }
    }
    if let Some(literal) = input.literal() {
        return value(literal);
    }
    if input.peek_pair(':', ':') {
        return path(input).map(|path| (path, None));
    }
    if input.peek_group(Delimiter::Bracket) {
        return Err(Error::new(input.next_span(), INSIDE));
    }
    let mut ahead = *input;
    if ahead.punct('.').is_some() && ahead.literal().is_some() {
        return Err(Error::new(input.next_span(), "write a digit before the point, as in `0.5`"));
    }
    let Some(name) = input.peek_ident() else { return Err(input.unexpected("a number")) };
    let mut ahead = *input;
    ahead.ident();
    if is_keyword(&name) && !ahead.peek_pair(':', ':') && !is_end(&ahead) {
        return Err(input.unexpected("a number"));
    }
    let expr = if ahead.peek_pair(':', ':') {
        path(input)?
    } else if let Some((inside, parentheses)) = ahead.group(Delimiter::Parenthesis) {
        if FORMS.iter().any(|form| name == form) {
            return Err(Error::new(name.span(), INSIDE));
        }
        *input = ahead;
        let extent = SpanRange::token(name.span()).to(parentheses);
        ExprSyntax { kind: ExprKind::Call(name, list(inside)?), extent }
    } else {
        *input = ahead;
        ExprSyntax { extent: SpanRange::token(name.span()), kind: ExprKind::Name(name) }
    };
    no_index(input, Some(&expr.kind))?;
    Ok((expr, None))
}

/// Reports an index after a number, or after a path of names.
pub(super) fn no_index(input: &Cursor, number: Option<&ExprKind>) -> Result<()> {
    let mut ahead = *input;
    let Some((mut inside, _)) = ahead.group(Delimiter::Bracket) else { return Ok(()) };
    if inside.any().is_none() || !inside.is_empty() {
        return Ok(());
    }
    let is_constant = match number {
        Some(ExprKind::Name(name)) if FUNCTIONS.iter().any(|function| name == function) => {
            return Err(input.unexpected("`(`"));
        }
        Some(ExprKind::Name(name)) => name.to_string().starts_with(char::is_uppercase),
        Some(_) => true,
        None => false,
    };
    let message = match is_constant {
        true => "a number uses constants of type `f64`: write a separate `const` for this entry",
        false => {
            "remove the index: in a `repeat` a name means the same repetition, and after it a repeated body is the last one"
        }
    };
    Err(Error::new(input.next_span(), message))
}

/// All numbers in a group, separated by commas.
pub(super) fn list(mut inside: Cursor) -> Result<Vec<ExprSyntax>> {
    let mut entries = Vec::new();
    while !inside.is_empty() {
        if inside.peek_group(Delimiter::Bracket) {
            let message = "write all numbers in one list, without brackets inside it";
            return Err(Error::new(inside.next_span(), message));
        }
        entries.push(number(&mut inside)?);
        if inside.punct(',').is_none() {
            inside.check_empty("`,`")?;
        }
    }
    Ok(entries)
}

/// Parses a count. A token that is no number is the outer error; a number that is out of range is
/// the inner one.
pub(super) fn count(expected: &str, input: &mut Cursor) -> Result<Result<usize>> {
    let Some(literal) = input.clone().literal() else { return Err(no_count(expected, input)) };
    input.any();
    let count = literal.to_string().replace('_', "").parse::<usize>();
    let known = count.ok().filter(|count| (1..=MOST_TIMES).contains(count));
    Ok(known.ok_or_else(|| {
        let message = format!("expected {expected} from 1 to {MOST_TIMES}");
        Error::new(literal.span(), message)
    }))
}

/// Returns the error for a token that is no count.
fn no_count(expected: &str, input: &Cursor) -> Error {
    let Some(name) = input.peek_ident() else { return input.unexpected(expected) };
    let message =
        format!("write {expected} in digits: the macro cannot read the value of `{name}`");
    Error::new(name.span(), message)
}

fn value(literal: proc_macro2::Literal) -> Result<(ExprSyntax, Suffix)> {
    let at = literal.span();
    if literal.to_string().len() > LONGEST_LITERAL {
        let message = format!("a number has no more than {LONGEST_LITERAL} digits");
        return Err(Error::new(at, message));
    }
    let (digits, suffix) = match Lit::new(literal) {
        Lit::Int(int) => (int.base10_digits().to_owned(), int.suffix().to_owned()),
        Lit::Float(float) => (float.base10_digits().to_owned(), float.suffix().to_owned()),
        Lit::Str(_) => return Err(Error::new(at, "write it without quotes")),
        _ => return Err(Error::new(at, "expected a number")),
    };
    let value = digits.parse().map_err(|_| Error::new(at, "expected a number"))?;
    if is_malformed(&suffix) {
        let message = "this is not a number: a number is written as `15`, `1.5` or `1.5e-3`, and then its unit";
        return Err(Error::new(at, message));
    }
    if is_number_type(&suffix) {
        return Err(Error::new(at, "a number has no type suffix here: remove the suffix"));
    }
    let expr = ExprSyntax { kind: ExprKind::Number(value), extent: SpanRange::token(at) };
    Ok((expr, (!suffix.is_empty()).then_some((suffix, at))))
}

/// Returns whether a number can end here: a keyword of Rust before it may be the name of a parameter, which is reported
/// where it is declared.
fn is_end(input: &Cursor) -> bool {
    let ends = input.is_empty() || input.peek_punct(';') || input.peek_punct(',');
    ends || is_operator_next(input)
}

/// `Self` has a separate message.
fn is_keyword(word: &Ident) -> bool {
    word != "Self" && syn::parse_str::<Ident>(&word.to_string()).is_err()
}

/// Returns whether a word may be in a path; Rust checks where `crate` is allowed.
fn can_be_in_path(word: &Ident) -> bool {
    !is_keyword(word) || ["crate", "self", "super"].iter().any(|known| word == known)
}

/// Returns whether the letters after digits are part of a number with an error: an exponent without digits, or a product.
fn is_malformed(suffix: &str) -> bool {
    let rest = suffix.strip_prefix(['e', 'E', 'x', 'X']);
    rest.is_some_and(|rest| rest.bytes().all(|digit| digit.is_ascii_digit()))
}

fn is_number_type(suffix: &str) -> bool {
    suffix.strip_prefix(['f', 'i', 'u']).is_some_and(|bits| {
        bits == "size" || (!bits.is_empty() && bits.bytes().all(|digit| digit.is_ascii_digit()))
    })
}

/// `consts::MASS`: kept unread.
fn path(input: &mut Cursor) -> Result<ExprSyntax> {
    let mut tokens = TokenStream::new();
    let start = SpanRange::token(input.next_span());
    if let Some(first) = input.peek_ident().filter(|first| first == "Self") {
        return Err(Error::new(
            first.span(),
            "`Self` is not known here: write the name of the type",
        ));
    }
    loop {
        if input.peek_pair(':', ':') {
            tokens.extend(input.any());
            tokens.extend(input.any());
        }
        let segment = input.peek_ident().filter(can_be_in_path);
        let segment = segment.ok_or_else(|| input.unexpected("a name"))?;
        input.ident();
        tokens.extend([proc_macro2::TokenTree::Ident(segment)]);
        if !input.peek_pair(':', ':') {
            break;
        }
    }
    if input.peek_group(Delimiter::Parenthesis) {
        let message = "Rust functions cannot be called here: write a `const` instead";
        return Err(Error::new(input.next_span(), message));
    }
    Ok(ExprSyntax { kind: ExprKind::Path(tokens), extent: start.to(input.last()) })
}

fn check_length(parts: usize, input: &Cursor) -> Result<()> {
    if parts <= MOST_PARTS {
        return Ok(());
    }
    let message = format!(
        "more than {MOST_PARTS} terms or factors in one formula: write a part \
                           of it as a Rust `const`"
    );
    Err(Error::new(input.last().first, message))
}
