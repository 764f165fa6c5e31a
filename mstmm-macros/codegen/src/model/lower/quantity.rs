//! Units of numbers: their scale, and messages for units that are wrong.

use super::context::{Context, Measure};
use super::dimension::PhysicalDimension;
use super::number::Measured;
use super::unit::{self, Scale};
use crate::syntax::UnitSyntax;

impl Measured<'_> {
    /// Returns whether it has a unit of a dimension.
    pub fn has_unit(&self) -> bool {
        matches!(self.measure, Measure::Of(dimension) if dimension != PhysicalDimension::default())
    }
}

impl Context<'_> {
    /// Reports a second unit.
    pub fn expect_no_unit(&mut self, number: &Measured) -> Option<()> {
        match number.measure {
            Measure::Of(dimension) if number.has_unit() => self.refuse(
                number.at,
                format!(
                    "this expression is {} already: attach the unit to the plain numbers instead",
                    dimension.name()
                ),
            ),
            _ => Some(()),
        }
    }

    /// Returns the scale and the dimension of a unit.
    pub fn unit(&mut self, unit: &UnitSyntax) -> Option<(Scale, PhysicalDimension)> {
        let unknown = match (unit::resolve(unit), unit.parentheses) {
            (Ok(resolved), None) => return Some(resolved),
            (Ok(_), Some(parentheses)) => {
                let message = format!("write the unit without parentheses: `{}`", unit.text());
                return self.refuse(parentheses, message);
            }
            (Err(unknown), _) => unknown,
        };
        let symbol = &unknown.symbol;
        let is_name = self.parameters.iter().any(|other| other.name == symbol)
            || self
                .later_parameters
                .iter()
                .chain(&self.part_parameters)
                .any(|name| *name == symbol)
            || symbol == "PI";
        let hint = unit::hint(symbol);
        let looks_like_constant = symbol.len() > 1 && !symbol.contains(char::is_lowercase);
        let is_first = unit.factors.first().is_some_and(|first| std::ptr::eq(first, unknown));
        let message = if is_name || (hint.is_empty() && looks_like_constant) {
            match (is_first, unknown.power < 0) {
                (true, false) => unknown.not_a_unit(),
                (_, true) => {
                    format!("a unit ends a product: write `(2 m) / {symbol}`, not `2 m / {symbol}`")
                }
                _ => {
                    format!("a unit ends a product: write `(2 m) * {symbol}`, not `2 m * {symbol}`")
                }
            }
        } else {
            format!("unknown unit `{symbol}`{hint}")
        };
        self.diagnostics.error(unknown.at, message);
        None
    }
}
