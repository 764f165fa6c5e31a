//! The negations that an operation costs.
//!
//! `−ab − c` is one instruction where products are fused with sums, and costs a negation elsewhere. It counts half as much as
//! a negation that always costs an instruction.

use crate::program::{Operand, Operation};

/// The cost of a negation.
pub(super) const NEGATION: i32 = 2;

/// The cost of a negation that a fused product includes.
const FUSED_NEGATION: i32 = 1;

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

/// Returns the cost of the negations of an operation, whose result is negated if `minus`.
pub(super) fn negations(operation: &Operation, minus: bool, negated: &[bool]) -> i32 {
    let of = |operand: &Operand| is_minus(operand, negated);
    let both_minus = |[first, second]: [bool; 2]| first != minus && second != minus;
    let sum = |terms: [bool; 2], operands: [&Operand; 2]| {
        NEGATION * i32::from(both_minus(terms) && !operands.into_iter().any(is_number))
    };
    let fused = |terms: [bool; 2], operands: [&Operand; 3]| {
        FUSED_NEGATION * i32::from(both_minus(terms) && !operands.into_iter().any(is_number))
    };
    match operation {
        Operation::Sum(a, b) => sum([of(a), of(b)], [a, b]),
        Operation::Difference(a, b) => sum([of(a), !of(b)], [a, b]),
        Operation::MulAdd(a, b, c) => fused([of(a) ^ of(b), of(c)], [a, b, c]),
        Operation::MulSub(a, b, c) => fused([of(a) ^ of(b), !of(c)], [a, b, c]),
        Operation::MulNegAdd(a, b, c) => fused([!(of(a) ^ of(b)), of(c)], [a, b, c]),
        Operation::Product(a, b) => {
            NEGATION * i32::from(of(a) ^ of(b) ^ minus && !is_number(a) && !is_number(b))
        }
        Operation::Recip(a) => NEGATION * i32::from(of(a) ^ minus),
        Operation::Sqrt(_)
        | Operation::CopySign(..)
        | Operation::Atan2(..)
        | Operation::RecipAbove(..) => {
            let operands = operation.operands().into_iter().flatten();
            operands.map(|operand| NEGATION * i32::from(of(operand))).sum()
        }
    }
}
