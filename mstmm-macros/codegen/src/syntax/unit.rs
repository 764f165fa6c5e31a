//! Units have a separate grammar: `kg*m^2`, and `m/s^2` is m/(s²).

use proc_macro2::{Delimiter, Span};
use syn::{Error, Result};

use super::cursor::Cursor;
use super::lookahead;
use super::tree::{SpanRange, UnitFactorSyntax, UnitSyntax};

/// Words that may follow a number and are no units.
const NOT_UNITS: &[&str] = &["about", "turned", "at", "point"];

/// The message for powers as other languages write them.
pub(super) const POWERS: &str = "write powers with `^`";

/// The maximum power; larger ones are typing errors.
const HIGHEST_POWER: i32 = 9;

/// Parses a unit, if one is next.
pub(super) fn optional(input: &mut Cursor) -> Result<Option<UnitSyntax>> {
    if let Some(unit) = in_parentheses(input) {
        return Ok(Some(unit));
    }
    if !is_next(input) {
        return Ok(None);
    }
    let (symbol, at) = symbol(input)?;
    beginning_with(input, symbol, at).map(Some)
}

/// Parses the rest of a unit after its first symbol.
pub(super) fn beginning_with(input: &mut Cursor, symbol: String, at: Span) -> Result<UnitSyntax> {
    let mut factors = vec![UnitFactorSyntax { symbol, at, power: power(input)? }];
    let mut parentheses = None;
    while let Some(sign) = sign_before_unit(input) {
        if let Some(inner) = in_parentheses(input) {
            let power = sign * power(input)?;
            let inner_factors = inner.factors.into_iter();
            factors.extend(inner_factors.map(|f| UnitFactorSyntax { power: f.power * power, ..f }));
            parentheses = parentheses.or(inner.parentheses);
            continue;
        }
        let (symbol, at) = self::symbol(input)?;
        factors.push(UnitFactorSyntax { symbol, at, power: sign * power(input)? });
    }
    let unit = UnitSyntax { factors, parentheses, extent: SpanRange::token(at).to(input.last()) };
    check_single(input, &unit)?;
    Ok(unit)
}

/// Parses a unit in parentheses, which is an error.
fn in_parentheses(input: &mut Cursor) -> Option<UnitSyntax> {
    let mut ahead = *input;
    let (mut inside, extent) = ahead.group(Delimiter::Parenthesis)?;
    let unit = optional(&mut inside).ok()??;
    if !inside.is_empty() {
        return None;
    }
    *input = ahead;
    Some(UnitSyntax { parentheses: Some(extent), extent, ..unit })
}

/// Reports a second unit after a unit, or after a point. A longer word with a capital is the next item of a route.
fn check_single(input: &Cursor, unit: &UnitSyntax) -> Result<()> {
    let mut ahead = *input;
    ahead.punct('.');
    let Some(next) = ahead.peek_ident().filter(|_| is_next(&ahead)) else { return Ok(()) };
    let text = next.to_string();
    if text.starts_with(char::is_uppercase) && text.len() > 2 {
        return Ok(());
    }
    if unit.factors[0].symbol == "PI" {
        return Err(Error::new(unit.factors[0].at, unit.factors[0].not_a_unit()));
    }
    let message = format!("units multiply with `*`: `{}*{text}`", unit.text());
    Err(Error::new(next.span(), message))
}

impl UnitFactorSyntax {
    /// Returns the message for a factor of a number that was read as a unit.
    pub fn not_a_unit(&self) -> String {
        let symbol = &self.symbol;
        format!("`{symbol}` is not a unit: write `*` before it, as in `2 * {symbol}`")
    }
}

impl UnitSyntax {
    /// Returns the unit as text, with its divisors at the end.
    pub fn text(&self) -> String {
        let mut text = String::new();
        let (below, above): (Vec<_>, Vec<_>) = self.factors.iter().partition(|f| f.power < 0);
        for UnitFactorSyntax { symbol, power, .. } in above.into_iter().chain(below) {
            let sign = match (text.is_empty(), *power < 0) {
                (true, false) => "",
                (true, true) => "1/",
                (false, false) => "*",
                (false, true) => "/",
            };
            let power = match power.unsigned_abs() {
                1 => String::new(),
                power => format!("^{power}"),
            };
            text += &format!("{sign}{symbol}{power}");
        }
        text
    }
}

/// Reads `*` or `/` if a unit follows: 1 or −1.
fn sign_before_unit(input: &mut Cursor) -> Option<i32> {
    let mut ahead = *input;
    let sign = if ahead.punct('*').is_some() {
        1
    } else {
        ahead.punct('/')?;
        -1
    };
    let mut after = ahead;
    if !is_next(&ahead) && in_parentheses(&mut after).is_none() {
        return None;
    }
    *input = ahead;
    Some(sign)
}

/// Returns whether the next word is in the place of a unit, known or not: it is no field, path,
/// call or misspelt keyword.
fn is_next(input: &Cursor) -> bool {
    let mut ahead = *input;
    !lookahead::begins_item(input)
        && ahead.ident().is_some_and(|word| NOT_UNITS.iter().all(|other| word != other))
        && lookahead::meant_after_value(input).is_none()
        && !ahead.peek_punct('=')
        && !ahead.peek_pair(':', ':')
        && !ahead.peek_group(Delimiter::Parenthesis)
}

fn symbol(input: &mut Cursor) -> Result<(String, Span)> {
    let symbol = input.ident().ok_or_else(|| input.unexpected("a unit"))?;
    Ok((symbol.to_string(), symbol.span()))
}

fn power(input: &mut Cursor) -> Result<i32> {
    if input.punct('^').is_some() {
        return exponent(input);
    }
    let mut ahead = *input;
    if ahead.pair('*', '*').is_some() && exponent(&mut ahead).is_ok() {
        return Err(Error::new(input.next_span(), POWERS));
    }
    Ok(1)
}

/// Parses the whole number after `^`.
pub(super) fn exponent(input: &mut Cursor) -> Result<i32> {
    // `macro_rules!` passes a negative number in a group without delimiters.
    if let Some((mut inside, _)) = input.group(Delimiter::None) {
        inside.check_depth()?;
        let power = exponent(&mut inside)?;
        return inside.check_empty("`;`").map(|()| power);
    }
    let sign = if input.punct('-').is_some() { -1 } else { 1 };
    let literal = input.literal().ok_or_else(|| input.unexpected("a whole number"))?;
    let at = literal.span();
    match literal.to_string().parse::<i32>() {
        Ok(power) if power <= HIGHEST_POWER => Ok(sign * power),
        _ => Err(Error::new(at, format!("expected a whole power up to {HIGHEST_POWER}"))),
    }
}
