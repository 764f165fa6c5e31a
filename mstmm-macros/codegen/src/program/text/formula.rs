//! Formulas as text, with parentheses only where they are needed.

use crate::program::{Operand, Operation};

/// A formula as text.
#[derive(Clone, Debug)]
pub struct Formula {
    /// The text.
    pub text: String,
    precedence: Precedence,
}

/// The precedence of a formula's outermost operation, the lowest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Precedence {
    Sum,
    Product,
    Minus,
    Atom,
}

impl Formula {
    /// Returns a name or a call.
    pub fn atom(text: String) -> Self {
        Formula { text, precedence: Precedence::Atom }
    }

    /// Returns a known number.
    pub fn number(value: f64) -> Self {
        let precedence =
            if value.is_sign_negative() { Precedence::Minus } else { Precedence::Atom };
        Formula { text: format!("{value:?}"), precedence }
    }

    /// Returns the call of a function.
    pub fn call(function: &str, arguments: &[&str]) -> Self {
        Formula::atom(format!("{function}({})", arguments.join(", ")))
    }

    /// Returns the negative.
    pub fn negated(&self) -> Self {
        Formula {
            text: format!("-{}", self.within(Precedence::Atom)),
            precedence: Precedence::Minus,
        }
    }

    /// Returns the formula of an operation; `operand` returns the formula of an operand.
    pub fn of(operation: &Operation, operand: &impl Fn(&Operand) -> Formula) -> Self {
        let call = |function: &str, operands: &[&Operand]| {
            let arguments: Vec<Formula> = operands.iter().map(|it| operand(it)).collect();
            let texts: Vec<&str> = arguments.iter().map(|it| &it.text[..]).collect();
            Formula::call(function, &texts)
        };
        match operation {
            Operation::Sum(a, b) => operand(a).plus(&operand(b)),
            Operation::Difference(a, b) => operand(a).minus(&operand(b)),
            Operation::Product(a, b) => operand(a).times(&operand(b)),
            Operation::MulAdd(a, b, c) => {
                // If both terms are products, the ready times of their factors decide which is fused; the text orders them.
                let (product, other) = (operand(a).times(&operand(b)), operand(c));
                match other.precedence == Precedence::Product && product.text < other.text {
                    true => product.plus(&other),
                    false => other.plus(&product),
                }
            }
            Operation::MulSub(a, b, c) => operand(a).times(&operand(b)).minus(&operand(c)),
            Operation::MulNegAdd(a, b, c) => operand(c).minus(&operand(a).times(&operand(b))),
            Operation::Recip(a) => call("recip", &[a]),
            Operation::Sqrt(a) => call("sqrt", &[a]),
            Operation::CopySign(a, b) => call("copysign", &[a, b]),
            Operation::Atan2(a, b) => call("atan2", &[a, b]),
            Operation::RecipAbove(a, b) => call("recip_above", &[a, b]),
        }
    }

    fn plus(&self, other: &Formula) -> Formula {
        self.joined("+", other, Precedence::Sum, Precedence::Product)
    }

    fn minus(&self, other: &Formula) -> Formula {
        self.joined("-", other, Precedence::Sum, Precedence::Product)
    }

    fn times(&self, other: &Formula) -> Formula {
        self.joined("*", other, Precedence::Product, Precedence::Minus)
    }

    fn joined(
        &self,
        sign: &str,
        other: &Formula,
        precedence: Precedence,
        right: Precedence,
    ) -> Formula {
        let text = format!("{} {sign} {}", self.within(precedence), other.within(right));
        Formula { text, precedence }
    }

    /// Returns the text, in parentheses if its precedence is lower than `least`.
    fn within(&self, least: Precedence) -> String {
        if self.precedence < least { format!("({})", self.text) } else { self.text.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::Formula;

    #[test]
    fn parentheses_are_written_where_they_are_needed() {
        let [a, b, c] = ["a", "b", "c"].map(|name| Formula::atom(name.to_owned()));
        assert_eq!(a.plus(&b).plus(&c).text, "a + b + c");
        assert_eq!(a.minus(&b.minus(&c)).text, "a - (b - c)");
        assert_eq!(a.plus(&b).times(&c.negated()).text, "(a + b) * -c");
        assert_eq!(a.times(&b.times(&c)).text, "a * (b * c)");
        assert_eq!(a.times(&b).minus(&c.times(&c)).text, "a * b - c * c");
        assert_eq!(a.times(&b).negated().text, "-(a * b)");
        assert_eq!(Formula::number(-0.5).times(&a).text, "-0.5 * a");
    }
}
