//! Numbers of a model: exact ones fold, those known only at run time stay formulas.

use super::ParameterId;

/// A number that the compiler does not know.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Symbol {
    /// A parameter of the chain.
    Parameter(ParameterId),
    /// A Rust path, evaluated when the chain is made.
    Constant(usize),
}

/// A number: known, or a formula of symbols.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A known number.
    Number(f64),
    /// A number that the compiler does not know.
    Symbol(Symbol),
    /// `a + b`
    Sum(Box<Value>, Box<Value>),
    /// `a b`
    Product(Box<Value>, Box<Value>),
    /// `a / b`
    Quotient(Box<Value>, Box<Value>),
    /// `√a`
    Sqrt(Box<Value>),
    /// `sin a`, `a` in rad
    Sin(Box<Value>),
    /// `cos a`, `a` in rad
    Cos(Box<Value>),
}

use Value::{Number, Product, Quotient, Sum};

impl Value {
    /// A known number.
    pub fn number(value: f64) -> Self {
        Number(value)
    }

    /// The number, if it is known.
    pub fn known(&self) -> Option<f64> {
        match self {
            Number(value) => Some(*value),
            _ => None,
        }
    }

    /// Whether it is known to be zero.
    pub fn is_zero(&self) -> bool {
        self.known() == Some(0.0)
    }

    /// `self + other`
    pub fn plus(self, other: Value) -> Value {
        match (self, other) {
            (Number(a), Number(b)) => Number(a + b),
            (a, b) if b.is_zero() => a,
            (a, b) if a.is_zero() => b,
            (a, b) => Sum(a.into(), b.into()),
        }
    }

    /// `self − other`
    pub fn minus(self, other: Value) -> Value {
        self.plus(other.negated())
    }

    /// `−self`
    pub fn negated(self) -> Value {
        // `0 − a`, not `−1 · a`: a negated zero stays a plain zero.
        match self {
            Number(a) => Number(0.0 - a),
            a => Product(Number(-1.0).into(), a.into()),
        }
    }

    /// `self · other`
    pub fn times(self, other: Value) -> Value {
        match (self, other) {
            (Number(a), Number(b)) => Number(a * b),
            (a, b) if a.is_zero() || b.is_zero() => Number(0.0),
            (Number(1.0), a) | (a, Number(1.0)) => a,
            (a, b) => Product(a.into(), b.into()),
        }
    }

    /// `self / other`
    pub fn over(self, other: Value) -> Value {
        match (self, other) {
            (Number(a), Number(b)) => Number(a / b),
            (a, Number(1.0)) => a,
            (a, b) => Quotient(a.into(), b.into()),
        }
    }

    /// `√self`
    pub fn sqrt(self) -> Value {
        match self {
            Number(a) => Number(a.sqrt()),
            a => Value::Sqrt(a.into()),
        }
    }

    /// `sin self`, exactly 0 or ±1 at multiples of a right angle.
    pub fn sin(self) -> Value {
        match self {
            Number(a) => Number(sin_cos(a).0),
            a => Value::Sin(a.into()),
        }
    }

    /// `cos self`, exactly 0 or ±1 at multiples of a right angle.
    pub fn cos(self) -> Value {
        match self {
            Number(a) => Number(sin_cos(a).1),
            a => Value::Cos(a.into()),
        }
    }

    /// Whether it contains a parameter.
    pub fn uses(&self, parameter: ParameterId) -> bool {
        match self {
            Number(_) => false,
            Value::Symbol(symbol) => *symbol == Symbol::Parameter(parameter),
            Sum(a, b) | Product(a, b) | Quotient(a, b) => a.uses(parameter) || b.uses(parameter),
            Value::Sqrt(a) | Value::Sin(a) | Value::Cos(a) => a.uses(parameter),
        }
    }

    /// Whether it contains any parameter.
    pub fn changes(&self) -> bool {
        match self {
            Number(_) | Value::Symbol(Symbol::Constant(_)) => false,
            Value::Symbol(Symbol::Parameter(_)) => true,
            Sum(a, b) | Product(a, b) | Quotient(a, b) => a.changes() || b.changes(),
            Value::Sqrt(a) | Value::Sin(a) | Value::Cos(a) => a.changes(),
        }
    }

    /// The number of its numbers, symbols and operations.
    pub fn size(&self) -> usize {
        match self {
            Number(_) | Value::Symbol(_) => 1,
            Sum(a, b) | Product(a, b) | Quotient(a, b) => 1 + a.size() + b.size(),
            Value::Sqrt(a) | Value::Sin(a) | Value::Cos(a) => 1 + a.size(),
        }
    }

    /// The number with the parameters at `values`, if that makes it known.
    pub fn at(&self, values: &[Option<f64>]) -> Option<f64> {
        match self {
            Number(value) => Some(*value),
            Value::Symbol(Symbol::Parameter(id)) => values[id.index()],
            Value::Symbol(Symbol::Constant(_)) => None,
            Sum(a, b) => Some(a.at(values)? + b.at(values)?),
            Product(a, b) => Some(a.at(values)? * b.at(values)?),
            Quotient(a, b) => Some(a.at(values)? / b.at(values)?),
            Value::Sqrt(a) => Some(a.at(values)?.sqrt()),
            Value::Sin(a) => Some(sin_cos(a.at(values)?).0),
            Value::Cos(a) => Some(sin_cos(a.at(values)?).1),
        }
    }
}

/// Sine and cosine that take an angle within rounding of a right angle for the right angle, so
/// that `90 deg` and `PI/2` leave exact zeros in a rotation matrix.
fn sin_cos(angle: f64) -> (f64, f64) {
    let quarters = angle / std::f64::consts::FRAC_PI_2;
    let nearest = quarters.round();
    if (quarters - nearest).abs() > 4.0 * f64::EPSILON * nearest.abs().max(1.0) {
        return angle.sin_cos();
    }
    match nearest.rem_euclid(4.0) as u8 {
        0 => (0.0, 1.0),
        1 => (1.0, 0.0),
        2 => (0.0, -1.0),
        _ => (-1.0, 0.0),
    }
}

#[cfg(test)]
mod tests {
    use super::Value;

    #[test]
    fn right_angles_are_exact_and_small_angles_are_kept() {
        let cos = |degrees: f64| Value::number(degrees.to_radians()).cos().known();
        assert_eq!(cos(90.0), Some(0.0));
        assert_eq!(cos(-270.0), Some(0.0));
        assert_eq!(cos(180.0), Some(-1.0));
        assert_eq!(Value::number(1e-9).sin().known(), Some(1e-9_f64.sin()));
        assert_eq!(Value::number(1e-18).sin().known(), Some(0.0));
    }
}
