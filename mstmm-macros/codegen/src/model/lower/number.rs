//! Numbers: their values in SI units and their dimensions.

use proc_macro2::Ident;

use super::context::{Context, Measure};
use super::dimension::{ANGLE, COMPONENT, LENGTH, PITCH, PhysicalDimension, Quantity};
use super::unit::{self, misread_symbol};
use crate::model::condition::{Bound, Condition};
use crate::model::{Symbol, Value};
use crate::syntax::{
    ExprKind, ExprSyntax, FUNCTIONS, FactorSyntax, SpanRange, TermSyntax, UnitSyntax,
};

/// The maximum size of a formula: powers of powers multiply it.
const LARGEST_FORMULA: usize = 1000;

const NOT_FINITE: &str = "this is not a finite number";

/// A number with its dimension.
pub(super) struct Measured<'e> {
    /// In SI units.
    pub value: Value,
    /// Its dimension, as far as it is known.
    pub measure: Measure,
    /// The unit that determines its dimension, if there is exactly one.
    pub unit: Option<&'e UnitSyntax>,
    /// The span for messages about its dimension.
    pub at: SpanRange,
}

impl<'e> Measured<'e> {
    fn new(value: Value, measure: Measure, expr: &ExprSyntax) -> Self {
        Measured { value, measure, unit: None, at: expr.extent }
    }

    fn map(self, value: impl FnOnce(Value) -> Value) -> Measured<'e> {
        Measured { value: value(self.value), ..self }
    }
}

impl Context<'_> {
    /// Reads a number of this quantity, in SI units.
    pub fn number(&mut self, expr: &ExprSyntax, expected: &Quantity) -> Option<Value> {
        let measured = match &expr.kind {
            ExprKind::Sum(terms) => self.sum(terms, expr, Some(expected))?,
            _ => self.measure(expr)?,
        };
        self.expect(&measured, expected)?;
        self.warn_of_degrees(&measured, expr, expected);
        self.finite(measured.value, expr.extent)
    }

    /// Reports a number of another dimension.
    pub fn expect(&mut self, found: &Measured, expected: &Quantity) -> Option<()> {
        match found.measure {
            Measure::Of(dimension) => self.expect_dimension(dimension, found, expected),
            _ => Some(()),
        }
    }

    fn expect_dimension(
        &mut self,
        dimension: PhysicalDimension,
        found: &Measured,
        expected: &Quantity,
    ) -> Option<()> {
        if let Some(message) = found.unit.and_then(|unit| misread_symbol(unit, expected)) {
            return self.refuse(found.at, message);
        }
        let is_pitch = expected.dimension == PITCH.dimension;
        if is_pitch && dimension == LENGTH.dimension {
            let message = "a pitch is a length per turn: write `5 mm/rev` or `5 mm/rad`";
            return self.refuse(found.at, message);
        }
        // The angle of a plain number and that of a pitch are part of what they are.
        let is_strict = is_pitch || expected.dimension == PhysicalDimension::default();
        if dimension == expected.dimension || (!is_strict && dimension.fits(expected.dimension)) {
            return Some(());
        }
        if expected.name == COMPONENT.name {
            let message = "the components of a quaternion have no unit; for angles write `rpy(…)`";
            return self.refuse(found.at, message);
        }
        let rotational = expected.rotational.filter(|(other, _)| dimension.fits(*other));
        let hint = rotational
            .map_or_else(String::new, |(_, field)| format!("; for the rotation write `{field}`"));
        self.refuse(
            found.at,
            format!("expected {}, found {}{hint}", expected.described(), dimension.name()),
        )
    }

    /// Reports values that are not finite, such as the root of a negative number.
    pub fn finite(&mut self, value: Value, at: SpanRange) -> Option<Value> {
        match value.known() {
            Some(number) if !number.is_finite() => self.refuse(at, NOT_FINITE),
            Some(_) => Some(value),
            None => {
                let condition = Condition::new(value.clone(), Bound::BeFinite, at, NOT_FINITE);
                self.requirements.push(vec![condition.shown("")]);
                Some(value)
            }
        }
    }

    /// Reads any number.
    pub fn measure<'e>(&mut self, expr: &'e ExprSyntax) -> Option<Measured<'e>> {
        match &expr.kind {
            ExprKind::Number(number) => {
                let measure = if *number == 0.0 { Measure::Zero } else { Measure::Plain };
                Some(Measured::new(Value::number(*number), measure, expr))
            }
            ExprKind::Name(name) => {
                let (value, measure) = self.name(name)?;
                Some(Measured::new(value, measure, expr))
            }
            ExprKind::Argument(_, argument) => {
                let measured = self.measure(argument)?;
                // The error is where the parameter is used.
                Some(Measured { at: expr.extent, unit: None, ..measured })
            }
            ExprKind::Parenthesized(inner) => {
                Some(Measured { at: expr.extent, ..self.measure(inner)? })
            }
            ExprKind::Lost => None,
            ExprKind::Path(path) => {
                let first = path.clone().into_iter().next();
                if first.is_some_and(|token| token.to_string() == "T") {
                    let message = "`T` is the scalar type of a chain here: name the constant by \
                                   another path";
                    return self.refuse(expr.extent, message);
                }
                let value = self.constant(path.clone());
                Some(Measured::new(value, Measure::Open, expr))
            }
            ExprKind::Negated(inner) => Some(self.measure(inner)?.map(Value::negated)),
            ExprKind::Sum(terms) => self.sum(terms, expr, None),
            ExprKind::Product(factors) => self.product(factors, expr),
            ExprKind::Power(base, power) => self.power(base, *power, expr),
            ExprKind::Quantity(product, unit) => self.quantity(product, unit),
            ExprKind::Call(function, arguments) => self.call(function, arguments, expr),
        }
    }

    fn name(&mut self, name: &Ident) -> Option<(Value, Measure)> {
        if let Some(index) = self.parameters.position(|other| other.name == name) {
            let parameter = &mut self.parameters[index];
            parameter.is_used = true;
            return Some((Value::Symbol(Symbol::Parameter(index)), parameter.measure));
        }
        if self.later_parameters.contains(&name) {
            return self.refuse(
                name,
                "the default of a parameter cannot use a parameter: write \
                                      numbers or Rust constants",
            );
        }
        if name == "PI" {
            return Some((Value::number(std::f64::consts::PI), Measure::Plain));
        }
        let text = name.to_string();
        if text == "Self" {
            return self.refuse(name, "`Self` is not known here: write the name of the type");
        }
        let is_constant = text.starts_with(char::is_uppercase);
        if is_constant && unit::is_symbol(&text) {
            let message = format!(
                "`{text}` is a unit: write it after a number; a Rust constant of this name is \
                 `self::{text}`"
            );
            return self.refuse(name, message);
        }
        if is_constant {
            return Some((self.constant(quote::ToTokens::to_token_stream(name)), Measure::Open));
        }
        if text == "input" {
            return self.refuse(name, self.not_input());
        }
        if unit::is_symbol(&text) {
            return self.refuse(name, format!("`{text}` is a unit: write it after a number"));
        }
        self.unknown_name(name)
    }

    fn sum<'e>(
        &mut self,
        terms: &'e [TermSyntax],
        expr: &'e ExprSyntax,
        expected: Option<&Quantity>,
    ) -> Option<Measured<'e>> {
        // All terms are read before returning, so that all errors in them are reported.
        let parts: Vec<_> = terms.iter().map(|term| self.measure(&term.expr)).collect();
        let parts: Vec<_> = parts.into_iter().collect::<Option<_>>()?;
        if let Some(expected) = expected {
            self.expect_terms(&parts, expected)?;
        }
        let measure = self.common_measure(&parts, "a sum")?;
        let value = terms.iter().zip(parts).fold(Value::number(0.0), |sum, (term, part)| {
            if term.negative { sum.minus(part.value) } else { sum.plus(part.value) }
        });
        Some(Measured::new(value, measure, expr))
    }

    /// Reports the terms of other dimensions, if some terms have the expected one.
    fn expect_terms(&mut self, terms: &[Measured], expected: &Quantity) -> Option<()> {
        let fits = |term: &Measured| match term.measure {
            Measure::Of(dimension) => dimension.fits(expected.dimension),
            _ => false,
        };
        if !terms.iter().any(fits) {
            return Some(());
        }
        let expected = terms.iter().map(|term| self.expect(term, expected));
        // All are tried.
        expected.fold(Some(()), Option::and)
    }

    /// Returns the common dimension of several numbers, all of which have a unit or none has.
    pub fn common_measure(&mut self, parts: &[Measured], together: &str) -> Option<Measure> {
        let dimension = parts.iter().find_map(|part| match part.measure {
            Measure::Of(dimension) => Some(dimension),
            _ => None,
        });
        let Some(dimension) = dimension else {
            let has = |measure| parts.iter().any(|part| part.measure == measure);
            let all_open_or_zero = !has(Measure::Plain) && has(Measure::Open);
            return Some(match (has(Measure::Plain), all_open_or_zero) {
                (true, _) => Measure::Plain,
                (_, true) => Measure::Open,
                _ => Measure::Zero,
            });
        };
        let mut all_fit = Some(Measure::Of(dimension));
        for part in parts {
            let message = match part.measure {
                Measure::Plain if !dimension.is_number() || dimension.angle != 0 => format!(
                    "this number has no unit, but is in {together} with {}: write its unit",
                    dimension.name()
                ),
                Measure::Of(other) if !other.fits(dimension) => {
                    format!("{} and {} cannot be in {together}", dimension.name(), other.name())
                }
                _ => continue,
            };
            all_fit = self.refuse(part.at, message);
        }
        all_fit
    }

    fn product<'e>(
        &mut self,
        factors: &'e [FactorSyntax],
        expr: &'e ExprSyntax,
    ) -> Option<Measured<'e>> {
        if let Some(unit) = unit::of_names(factors) {
            let message = format!("a value needs a number before its unit, such as `1 {unit}`");
            return self.refuse(expr.extent, message);
        }
        let parts: Vec<_> = factors.iter().map(|factor| self.measure(&factor.expr)).collect();
        let parts: Vec<_> = parts.into_iter().collect::<Option<_>>()?;
        let mut product = Measured::new(Value::number(1.0), Measure::Plain, expr);
        for (factor, part) in factors.iter().zip(parts) {
            if factor.divides && part.value.is_zero() {
                return self.refuse(factor.expr.extent, "division by zero");
            }
            let power = if factor.divides { -1 } else { 1 };
            product.measure = times(product.measure, part.measure, power);
            product.value = match factor.divides {
                true => product.value.over(part.value),
                false => product.value.times(part.value),
            };
        }
        Some(product)
    }

    fn power<'e>(
        &mut self,
        base: &'e ExprSyntax,
        power: i32,
        expr: &'e ExprSyntax,
    ) -> Option<Measured<'e>> {
        let base = self.measure(base)?;
        if power < 0 && base.value.is_zero() {
            return self.refuse(expr.extent, "division by zero");
        }
        if base.value.size() * power.unsigned_abs() as usize > LARGEST_FORMULA {
            let message = "this formula is too long: write a part of it as a Rust `const`";
            return self.refuse(expr.extent, message);
        }
        let one = Value::number(1.0);
        let value =
            (0..power.abs()).fold(one.clone(), |product, _| product.times(base.value.clone()));
        let measure = (0..power.abs())
            .fold(Measure::Plain, |product, _| times(product, base.measure, power.signum()));
        let value = if power < 0 { one.over(value) } else { value };
        Some(Measured::new(value, measure, expr))
    }

    fn quantity<'e>(
        &mut self,
        product: &'e ExprSyntax,
        unit: &'e UnitSyntax,
    ) -> Option<Measured<'e>> {
        if matches!(&product.kind, ExprKind::Name(word) if word == "input") {
            return self.refuse(unit.extent, "`input` has no unit: remove the unit");
        }
        if unit::is_multiple_of_pi(product)
            && unit.factors.iter().any(|factor| factor.symbol == "deg")
        {
            let message =
                "`PI` is an angle in radians: remove `deg`, or write the angle in degrees";
            return self.refuse(unit.extent, message);
        }
        let (number, unit_known) = (self.measure(product), self.unit(unit));
        let (number, (scale, dimension)) = (number?, unit_known?);
        self.expect_no_unit(&number)?;
        let value = scale.apply(number.value);
        Some(Measured { value, measure: Measure::Of(dimension), unit: Some(unit), at: unit.extent })
    }

    fn call<'e>(
        &mut self,
        function: &Ident,
        arguments: &'e [ExprSyntax],
        expr: &'e ExprSyntax,
    ) -> Option<Measured<'e>> {
        if FUNCTIONS.iter().all(|known| function != known) {
            return self.unknown_function(function);
        }
        let [argument_expr] = arguments else {
            return self.refuse(expr.extent, format!("`{function}` has one argument"));
        };
        let argument = self.measure(argument_expr)?;
        if function != "sqrt" {
            self.warn_of_degrees(&argument, argument_expr, ANGLE);
        }
        let measure = match argument.measure {
            Measure::Of(dimension) if function == "sqrt" => match dimension.root() {
                Some(root) => Measure::Of(root),
                None => {
                    let name = dimension.name();
                    return self.refuse(argument.at, format!("{name} has no square root"));
                }
            },
            Measure::Of(dimension) if !dimension.is_number() => {
                let name = dimension.name();
                return self.refuse(argument.at, format!("expected an angle, found {name}"));
            }
            Measure::Of(_) | Measure::Zero => Measure::Plain,
            unit_free => unit_free,
        };
        let value = argument.value;
        let value = match function.to_string().as_str() {
            "sqrt" => value.sqrt(),
            "sin" => value.sin(),
            _ => value.cos(),
        };
        Some(Measured::new(value, measure, expr))
    }
}

/// Returns the dimension of `first · second^power`.
fn times(first: Measure, second: Measure, power: i32) -> Measure {
    match (first, second) {
        (Measure::Open, _) | (_, Measure::Open) => Measure::Open,
        (Measure::Of(a), Measure::Of(b)) => Measure::Of(a.times(b, power)),
        (Measure::Of(a), _) => Measure::Of(a),
        (_, Measure::Of(b)) => Measure::Of(PhysicalDimension::default().times(b, power)),
        _ => Measure::Plain,
    }
}
