//! The negations that an operation costs.

use crate::program::{Operand, Operation};

/// Returns whether an operation can compute the negative of its result from the negatives of operands.
pub(super) fn takes_signs(operation: &Operation) -> bool {
    match operation {
        Operation::Sum(..)
        | Operation::Difference(..)
        | Operation::Product(..)
        | Operation::MulAdd(..)
        | Operation::MulSub(..)
        | Operation::MulNegAdd(..)
        | Operation::Recip(_) => true,
        Operation::Sqrt(_)
        | Operation::CopySign(..)
        | Operation::Atan2(..)
        | Operation::RecipAbove(..) => false,
    }
}

/// Returns whether an operand is the negative of what is computed.
pub(super) fn is_minus(operand: &Operand, negated: &[bool]) -> bool {
    match operand {
        Operand::Number(_) => false,
        Operand::Value(value) => negated[value.index()],
        Operand::Minus(inner) => !is_minus(inner, negated),
    }
}

/// Returns whether an operand is a number, whose sign costs nothing.
pub(super) fn is_number(operand: &Operand) -> bool {
    operand.is_known()
}

/// Returns the number of negations of an operation, whose result is negated if `minus`.
pub(super) fn negations(operation: &Operation, minus: bool, negated: &[bool]) -> i32 {
    let of = |operand: &Operand| is_minus(operand, negated);
    let sum = |[first, second]: [bool; 2], has_number: bool| {
        i32::from(first != minus && second != minus && !has_number)
    };
    match operation {
        Operation::Sum(a, b) => sum([of(a), of(b)], is_number(a) || is_number(b)),
        Operation::Difference(a, b) => sum([of(a), !of(b)], is_number(a) || is_number(b)),
        Operation::MulAdd(a, b, c) => {
            sum([of(a) ^ of(b), of(c)], [a, b, c].into_iter().any(is_number))
        }
        Operation::MulSub(a, b, c) => {
            sum([of(a) ^ of(b), !of(c)], [a, b, c].into_iter().any(is_number))
        }
        Operation::MulNegAdd(a, b, c) => {
            sum([!(of(a) ^ of(b)), of(c)], [a, b, c].into_iter().any(is_number))
        }
        Operation::Product(a, b) => {
            i32::from(of(a) ^ of(b) ^ minus && !is_number(a) && !is_number(b))
        }
        Operation::Recip(a) => i32::from(of(a) ^ minus),
        Operation::Sqrt(_)
        | Operation::CopySign(..)
        | Operation::Atan2(..)
        | Operation::RecipAbove(..) => {
            operation.operands().into_iter().flatten().map(|operand| i32::from(of(operand))).sum()
        }
    }
}
