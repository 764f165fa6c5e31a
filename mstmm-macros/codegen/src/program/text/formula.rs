//! Formulas as text, with brackets where they are needed.

use crate::program::{Operand, Operation};

/// A formula as text.
#[derive(Clone, Debug)]
pub struct Formula {
    /// The text.
    pub text: String,
    binding: Binding,
}

/// How closely a formula holds together, the loosest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Minus,
    Atom,
}

impl Formula {
    /// A name or a call.
    pub fn atom(text: String) -> Self {
        Formula { text, binding: Binding::Atom }
    }

    /// A known number.
    pub fn number(value: f64) -> Self {
        let binding = if value.is_sign_negative() { Binding::Minus } else { Binding::Atom };
        Formula { text: format!("{value:?}"), binding }
    }

    /// A function of these arguments.
    pub fn call(function: &str, arguments: &[&str]) -> Self {
        Formula::atom(format!("{function}({})", arguments.join(", ")))
    }

    /// The negative.
    pub fn negated(&self) -> Self {
        Formula { text: format!("-{}", self.within(Binding::Atom)), binding: Binding::Minus }
    }

    /// What an operation computes, of operands that are written so.
    pub fn of(operation: &Operation, operand: &impl Fn(&Operand) -> Formula) -> Self {
        let call = |function: &str, operands: &[&Operand]| {
            let arguments: Vec<Formula> = operands.iter().map(|one| operand(one)).collect();
            let texts: Vec<&str> = arguments.iter().map(|one| &one.text[..]).collect();
            Formula::call(function, &texts)
        };
        match operation {
            Operation::Sum(a, b) => operand(a).plus(&operand(b)),
            Operation::Difference(a, b) => operand(a).minus(&operand(b)),
            Operation::Product(a, b) => operand(a).times(&operand(b)),
            Operation::MulAdd(a, b, c) => {
                // Which of two products joins the sum is decided by when their factors are ready.
                let (product, other) = (operand(a).times(&operand(b)), operand(c));
                match other.binding == Binding::Product && product.text < other.text {
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
        self.joined("+", other, Binding::Sum, Binding::Product)
    }

    fn minus(&self, other: &Formula) -> Formula {
        self.joined("-", other, Binding::Sum, Binding::Product)
    }

    fn times(&self, other: &Formula) -> Formula {
        self.joined("*", other, Binding::Product, Binding::Minus)
    }

    fn joined(&self, sign: &str, other: &Formula, binding: Binding, right: Binding) -> Formula {
        let text = format!("{} {sign} {}", self.within(binding), other.within(right));
        Formula { text, binding }
    }

    /// The text where what holds together less closely than `least` needs brackets.
    fn within(&self, least: Binding) -> String {
        if self.binding < least { format!("({})", self.text) } else { self.text.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::Formula;

    #[test]
    fn brackets_stand_where_they_are_needed() {
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
