//! Units: their symbols, prefixes and dimensions.

use std::f64::consts::PI;

use super::dimension::{ACCELERATION, PhysicalDimension, Quantity, RATE};
use crate::model::Value;
use crate::syntax::{ExprKind, ExprSyntax, FactorSyntax, UnitFactorSyntax, UnitSyntax};

/// The scale of a unit in SI: `above · 10^tens / below`. Numerator, denominator and power of ten are
/// separate so that `48 mm` is 48/1000, which rounds once and equals `0.048`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scale {
    above: f64,
    below: f64,
    tens: i32,
}

/// A row of the table of units.
struct UnitSymbol {
    symbol: &'static str,
    scale: Scale,
    takes_prefix: bool,
    dimension: PhysicalDimension,
}

const fn unit(symbol: &'static str, tens: i32, powers: [i32; 4]) -> UnitSymbol {
    let [length, mass, time, angle] = powers;
    let scale = Scale { above: 1.0, below: 1.0, tens };
    let dimension = PhysicalDimension { length, mass, time, angle };
    UnitSymbol { symbol, scale, takes_prefix: true, dimension }
}

const fn fixed(symbol: &'static str, above: f64, below: f64, powers: [i32; 4]) -> UnitSymbol {
    let unit = unit(symbol, 0, powers);
    UnitSymbol { scale: Scale { above, below, tens: 0 }, takes_prefix: false, ..unit }
}

/// Powers of metre, kilogram, second, radian.
const SYMBOLS: &[UnitSymbol] = &[
    unit("m", 0, [1, 0, 0, 0]),
    unit("g", -3, [0, 1, 0, 0]),
    unit("s", 0, [0, 0, 1, 0]),
    unit("N", 0, [1, 1, -2, 0]),
    unit("J", 0, [2, 1, -2, 0]),
    unit("W", 0, [2, 1, -3, 0]),
    unit("Pa", 0, [-1, 1, -2, 0]),
    unit("Hz", 0, [0, 0, -1, 0]),
    unit("rad", 0, [0, 0, 0, 1]),
    fixed("deg", PI, 180.0, [0, 0, 0, 1]),
    fixed("rev", 2.0 * PI, 1.0, [0, 0, 0, 1]),
    fixed("rpm", 2.0 * PI, 60.0, [0, 0, -1, 1]),
    fixed("min", 60.0, 1.0, [0, 0, 1, 0]),
    fixed("h", 3600.0, 1.0, [0, 0, 1, 0]),
    fixed("t", 1000.0, 1.0, [0, 1, 0, 0]),
];

/// Prefixes, common ones first. Rust warns about the sign for micro in identifiers, so it is `u`.
const PREFIXES: &[(&str, i32)] =
    &[("k", 3), ("m", -3), ("c", -2), ("M", 6), ("u", -6), ("n", -9), ("d", -1)];

impl Scale {
    /// `value` in SI units.
    pub fn apply(self, value: Value) -> Value {
        let Scale { above, below, tens } = self;
        let power = 10_f64.powi(tens.abs());
        let (above, below) = if tens < 0 { (above, below * power) } else { (above * power, below) };
        value.times(Value::number(above)).over(Value::number(below))
    }

    fn times(self, other: Scale, power: i32) -> Scale {
        let (above, below) =
            if power < 0 { (other.below, other.above) } else { (other.above, other.below) };
        Scale {
            above: self.above * above.powi(power.abs()),
            below: self.below * below.powi(power.abs()),
            tens: self.tens + power * other.tens,
        }
    }
}

/// Returns the scale and the dimension of a unit, or the factor that is unknown.
pub(super) fn resolve(unit: &UnitSyntax) -> Result<(Scale, PhysicalDimension), &UnitFactorSyntax> {
    let si = Scale { above: 1.0, below: 1.0, tens: 0 };
    unit.factors.iter().try_fold(
        (si, PhysicalDimension::default()),
        |(scale, dimension), factor| {
            let (factor_scale, measures) = find(&factor.symbol).ok_or(factor)?;
            Ok((scale.times(factor_scale, factor.power), dimension.times(measures, factor.power)))
        },
    )
}

fn find(symbol: &str) -> Option<(Scale, PhysicalDimension)> {
    let exact = |name: &str| SYMBOLS.iter().find(|unit| unit.symbol == name);
    if let Some(unit) = exact(symbol) {
        return Some((unit.scale, unit.dimension));
    }
    PREFIXES.iter().find_map(|&(prefix, tens)| {
        let unit = exact(symbol.strip_prefix(prefix)?).filter(|unit| unit.takes_prefix)?;
        Some((Scale { tens: unit.scale.tens + tens, ..unit.scale }, unit.dimension))
    })
}

/// Whether this is the symbol of a unit, with a prefix or without.
pub(super) fn is_symbol(symbol: &str) -> bool {
    find(symbol).is_some()
}

/// Returns the unit that a product of names is, if it is one.
pub(super) fn of_names(factors: &[FactorSyntax]) -> Option<String> {
    factors.iter().try_fold(String::new(), |unit, factor| {
        let ExprKind::Name(name) = &factor.expr.kind else { return None };
        let sign = match factor.divides {
            _ if unit.is_empty() => "",
            true => "/",
            false => "*",
        };
        let symbol = name.to_string();
        is_symbol(&symbol).then(|| unit + sign + &symbol)
    })
}

/// Returns whether a number before a unit is a product with the word `PI`.
pub(super) fn is_multiple_of_pi(expr: &ExprSyntax) -> bool {
    match &expr.kind {
        ExprKind::Name(name) => name == "PI",
        ExprKind::Product(factors) => factors.iter().any(|it| is_multiple_of_pi(&it.expr)),
        ExprKind::Negated(inner) | ExprKind::Parenthesized(inner) => is_multiple_of_pi(inner),
        _ => false,
    }
}

/// Returns all symbols, with prefixes and without.
pub(super) fn symbols() -> Vec<String> {
    let plain = SYMBOLS.iter().map(|unit| unit.symbol.to_owned());
    let prefixed = SYMBOLS
        .iter()
        .filter(|unit| unit.takes_prefix)
        .flat_map(|unit| PREFIXES.iter().map(|(prefix, _)| format!("{prefix}{}", unit.symbol)));
    plain.chain(prefixed).collect()
}

/// Names of units and their symbols.
const NAMES: &[(&str, &str)] = &[
    ("metre", "m"),
    ("meter", "m"),
    ("gram", "g"),
    ("kilogram", "kg"),
    ("kilo", "kg"),
    ("kgs", "kg"),
    ("tonne", "t"),
    ("sec", "s"),
    ("second", "s"),
    ("minute", "min"),
    ("hour", "h"),
    ("hr", "h"),
    ("newton", "N"),
    ("nm", "N*m"),
    ("ns", "N*s"),
    ("newtonmeter", "N*m"),
    ("newtonmetre", "N*m"),
    ("joule", "J"),
    ("watt", "W"),
    ("pascal", "Pa"),
    ("hertz", "Hz"),
    ("degree", "deg"),
    ("radian", "rad"),
    ("turn", "rev"),
    ("revolution", "rev"),
];

/// Names of prefixes and their symbols.
const PREFIX_NAMES: &[(&str, &str)] = &[
    ("kilo", "k"),
    ("milli", "m"),
    ("centi", "c"),
    ("mega", "M"),
    ("micro", "u"),
    ("nano", "n"),
    ("deci", "d"),
];

/// Symbols that are often written together without `*`.
const RUN_TOGETHER: &[&str] = &["N", "kN", "MN", "mN", "J", "W", "Pa"];
/// The dot between the units of a product in typeset text.
const DOT: char = '\u{b7}';

/// Returns the end of a message: what an unknown unit probably means.
pub(super) fn hint(symbol: &str) -> String {
    if symbol.starts_with(['\u{b5}', '\u{3bc}']) {
        return format!("; write `u{}`", symbol.chars().skip(1).collect::<String>());
    }
    let plain = symbol.trim_end_matches(|letter: char| letter.is_ascii_digit());
    if plain != symbol && find(plain).is_some() {
        return format!("; write `{plain}^{}`", &symbol[plain.len()..]);
    }
    if let Some(product) = separated(symbol).or_else(|| product(symbol)) {
        return format!("; units multiply with `*`: `{product}`");
    }
    meant(symbol)
}

/// Returns a product with `*` for a product with the dot of typeset text, which Rust reads as a
/// letter: `N*m` for `N·m`.
fn separated(symbol: &str) -> Option<String> {
    let is_known = |part: &str| find(part).is_some();
    (symbol.contains(DOT) && symbol.split(DOT).all(is_known)).then(|| symbol.replace(DOT, "*"))
}

/// Returns the product that is written without `*`: `N*m*s` for `Nms`, `kg*m^2` for `kgm2`.
fn product(symbol: &str) -> Option<String> {
    symbol.char_indices().skip(1).find_map(|(at, _)| {
        let (first, rest) = symbol.split_at(at);
        let plain = rest.trim_end_matches(|letter: char| letter.is_ascii_digit());
        let power = match &rest[plain.len()..] {
            "" => String::new(),
            power => format!("^{power}"),
        };
        let is_usual = RUN_TOGETHER.contains(&first) || (first, plain) == ("kg", "m");
        find(plain).filter(|_| is_usual)?;
        // A torque times seconds is more usual than a force times milliseconds.
        let rest = if plain == "ms" && first.ends_with('N') { "m*s" } else { plain };
        Some(format!("{first}*{rest}{power}"))
    })
}

/// Returns the end of a message: the symbols that a word may be a misspelling of. A word that differs from two
/// symbols by the case of its letters, such as `MM`, may be of either size.
fn meant(symbol: &str) -> String {
    let word = symbol.to_lowercase();
    let singular = word.strip_suffix('s').unwrap_or(&word);
    if let Some(symbol) = named(&word).or_else(|| named(singular)) {
        return format!("; did you mean `{symbol}`?");
    }
    let symbols = symbols();
    let meant: Vec<&str> =
        symbols.iter().map(String::as_str).filter(|known| is_misspelling(symbol, known)).collect();
    match &meant[..] {
        [] => String::new(),
        [only] => format!("; did you mean `{only}`?"),
        several => format!("; units are case-sensitive: `{}`", several.join("`, `")),
    }
}

/// Returns whether a word is a symbol with the other case, with neighbouring letters exchanged, with a letter
/// twice, or in the plural. Another or a missing letter may be another unit: `dam` is no `dm`.
fn is_misspelling(word: &str, symbol: &str) -> bool {
    if word.to_lowercase() == symbol.to_lowercase() {
        return true;
    }
    // Short symbols are all similar. A prefix before a unit that takes none is no letter twice: `ddeg`.
    if word.chars().count() <= 2 || is_prefixed(word) {
        return false;
    }
    let letters: Vec<char> = word.chars().collect();
    let meant: Vec<char> = symbol.chars().collect();
    (1..letters.len()).any(|at| {
        let (mut exchanged, mut once) = (letters.clone(), letters.clone());
        exchanged.swap(at - 1, at);
        once.remove(at);
        exchanged == meant || (letters[at - 1] == letters[at] && once == meant)
    }) || (meant.len() > 2 && letters.strip_suffix(&['s']) == Some(&meant[..]))
}

/// Returns whether a word is a unit behind a prefix.
fn is_prefixed(word: &str) -> bool {
    PREFIXES
        .iter()
        .filter_map(|(prefix, _)| word.strip_prefix(prefix))
        .any(|unit| SYMBOLS.iter().any(|known| known.symbol == unit && !known.takes_prefix))
}

/// Returns the symbol of a unit that is written out: `mm` for `millimeter`.
fn named(word: &str) -> Option<String> {
    let symbol_of = |word: &str| NAMES.iter().find(|(name, _)| *name == word);
    if let Some((_, symbol)) = symbol_of(word) {
        return Some((*symbol).to_owned());
    }
    PREFIX_NAMES.iter().find_map(|(name, prefix)| {
        let (_, symbol) = symbol_of(word.strip_prefix(name)?)?;
        let symbol = format!("{prefix}{symbol}");
        is_symbol(&symbol).then_some(symbol)
    })
}

/// Returns the message for a symbol with another usual meaning.
pub(super) fn misread_symbol(unit: &UnitSyntax, expected: &Quantity) -> Option<&'static str> {
    let is_gram = matches!(&unit.factors[..], [only] if only.symbol == "g" && only.power == 1);
    let in_hertz = unit.factors.iter().any(|factor| factor.symbol.ends_with("Hz"));
    if is_gram && expected.dimension == ACCELERATION.dimension {
        return Some("`g` is gram; standard gravity is 9.80665 m/s^2");
    }
    if in_hertz && expected.dimension == RATE.dimension {
        return Some("`Hz` is ambiguous for an angular velocity: write `rev/s` or `rad/s`");
    }
    None
}

#[cfg(test)]
mod tests {
    use super::{find, hint};
    use crate::model::Value;

    #[test]
    fn prefixed_units_round_as_decimals_do() {
        let si = |value: f64, symbol: &str| {
            find(symbol).and_then(|(scale, _)| scale.apply(Value::number(value)).known())
        };
        assert_eq!(si(48.0, "mm"), Some(0.048));
        assert_eq!(si(0.74, "kg"), Some(0.74));
        assert_eq!(si(250.0, "g"), Some(0.25));
        assert_eq!(si(3.0, "ms"), Some(0.003));
        assert_eq!(si(180.0, "deg"), Some(std::f64::consts::PI));
        assert_eq!(si(1.0, "min"), Some(60.0));
        assert_eq!(si(1.0, "kmin"), None);
    }

    #[test]
    fn unknown_units_are_guessed() {
        assert_eq!(hint("Nm"), "; units multiply with `*`: `N*m`");
        assert_eq!(hint("KG"), "; did you mean `kg`?");
        assert_eq!(hint("dge"), "; did you mean `deg`?");
        for unknown in ["x", "in", "ft", "hg", "lb", "kq"] {
            assert_eq!(hint(unknown), "");
        }
        // Units of another size.
        for other in [
            "mdeg", "ddeg", "krpm", "mmin", "dam", "hPa", "grad", "gon", "mkg", "kph", "mph", "ton",
        ] {
            assert_eq!(hint(other), "");
        }
        for (symbol, meant) in [
            ("kgs", "kg"),
            ("mmm", "mm"),
            ("kgg", "kg"),
            ("degrees", "deg"),
            ("tonne", "t"),
            ("meters", "m"),
            ("millimeter", "mm"),
            ("Kilometres", "km"),
            ("centimetre", "cm"),
            ("milliseconds", "ms"),
            ("kilonewton", "kN"),
            ("megapascal", "MPa"),
            ("micrograms", "ug"),
            ("newtonmeters", "N*m"),
        ] {
            assert_eq!(hint(symbol), format!("; did you mean `{meant}`?"));
        }
        assert_eq!(hint("MM"), "; units are case-sensitive: `mm`, `Mm`");
        assert_eq!(hint("kgm"), "; units multiply with `*`: `kg*m`");
        assert_eq!(hint("kgm2"), "; units multiply with `*`: `kg*m^2`");
        assert_eq!(hint("Nms"), "; units multiply with `*`: `N*m*s`");
        assert_eq!(hint("Nmm"), "; units multiply with `*`: `N*mm`");
        assert_eq!(hint("N\u{b7}m\u{b7}s"), "; units multiply with `*`: `N*m*s`");
        assert_eq!(hint("s2"), "; write `s^2`");
        assert_eq!(hint("\u{b5}m"), "; write `um`");
        assert_eq!(hint("\u{3bc}g"), "; write `ug`");
    }
}
