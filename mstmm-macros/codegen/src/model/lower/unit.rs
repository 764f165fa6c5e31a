//! Units: their symbols, their prefixes and what they measure.

use std::f64::consts::PI;

use super::dimension::Dimension;
use crate::diag::nearest;
use crate::model::Value;
use crate::syntax::{Unit, UnitFactor};

/// A unit in terms of SI: `above · 10^tens / below`. Parts and powers of ten are kept apart because
/// then `48 mm` is 48/1000, which rounds once and so to the same number as `0.048`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scale {
    above: f64,
    below: f64,
    tens: i32,
}

/// A row of the table of units.
struct Symbol {
    symbol: &'static str,
    scale: Scale,
    takes_prefix: bool,
    dimension: Dimension,
}

const fn unit(symbol: &'static str, tens: i32, powers: [i32; 4]) -> Symbol {
    let [length, mass, time, angle] = powers;
    let scale = Scale { above: 1.0, below: 1.0, tens };
    let dimension = Dimension { length, mass, time, angle };
    Symbol { symbol, scale, takes_prefix: true, dimension }
}

const fn fixed(symbol: &'static str, above: f64, below: f64, powers: [i32; 4]) -> Symbol {
    let unit = unit(symbol, 0, powers);
    Symbol { scale: Scale { above, below, tens: 0 }, takes_prefix: false, ..unit }
}

/// Powers of metre, kilogram, second, radian.
const SYMBOLS: &[Symbol] = &[
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

/// Prefixes, the more usual ones first; both signs for micro that keyboards have.
const PREFIXES: &[(&str, i32)] = &[
    ("k", 3),
    ("m", -3),
    ("c", -2),
    ("M", 6),
    ("u", -6),
    ("\u{b5}", -6),
    ("\u{3bc}", -6),
    ("n", -9),
    ("d", -1),
];

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

/// The scale and the dimension of a unit, or the part of it that is not known.
pub(super) fn resolve(unit: &Unit) -> Result<(Scale, Dimension), &UnitFactor> {
    let one = Scale { above: 1.0, below: 1.0, tens: 0 };
    unit.factors.iter().try_fold((one, Dimension::default()), |(scale, dimension), factor| {
        let (each, measures) = find(&factor.symbol).ok_or(factor)?;
        Ok((scale.times(each, factor.power), dimension.times(measures, factor.power)))
    })
}

fn find(symbol: &str) -> Option<(Scale, Dimension)> {
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

/// What an unknown unit was meant to be, as the end of a message.
pub(super) fn hint(symbol: &str) -> String {
    let halves = symbol.char_indices().skip(1).map(|(at, _)| symbol.split_at(at));
    if let Some((a, b)) = halves.into_iter().find(|&(a, b)| find(a).is_some() && find(b).is_some())
    {
        return format!("; units multiply with `*`: `{a}*{b}`");
    }
    let names = || SYMBOLS.iter().map(|unit| unit.symbol);
    let prefixed = PREFIXES.iter().flat_map(|(prefix, _)| {
        SYMBOLS.iter().filter(|unit| unit.takes_prefix).map(move |unit| [*prefix, unit.symbol])
    });
    let known: Vec<String> =
        names().map(str::to_owned).chain(prefixed.map(|parts| parts.concat())).collect();
    nearest(symbol, known.iter().map(String::as_str))
        .map_or_else(String::new, |near| format!("; did you mean `{near}`?"))
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
        assert_eq!(hint("x"), "");
    }
}
