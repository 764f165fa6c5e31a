//! Rewrites a procedure of which some values are negated.

use super::negations::TermSign;
use crate::program::{
    Operand, Operation, PivotValue, Section, Statement, Step, ValueId, ValueNames, Witness,
};

/// Rewrites steps of which some values are negated.
pub(super) fn steps(steps: &mut [Step], negated: &[bool]) {
    steps.iter_mut().for_each(|it| step(it, negated));
}

fn step(step: &mut Step, negated: &[bool]) {
    match step {
        // Values that are tested are loaded, and those keep their signs.
        Step::CheckArguments(_) | Step::TestBounds(_) | Step::Load { .. } => {}
        Step::Compute(Section { statements, .. }) => {
            statements.iter_mut().for_each(|it| statement(it, negated));
        }
        Step::Store { values, .. } => {
            values.iter_mut().flatten().for_each(|it| operand(it, negated));
        }
        Step::Loop(loop_) => {
            let carries = loop_.carries.iter_mut();
            carries.for_each(|carry| {
                operand(&mut carry.init, negated);
                operand(&mut carry.next, negated);
            });
            steps(&mut loop_.body, negated);
        }
        Step::CheckPivot { value, scale, .. } => {
            operand(value, negated);
            operand(scale, negated);
        }
        Step::CheckResults(check) => {
            for test in &mut check.pivots {
                if let PivotValue::Once(value, scale) = &mut test.pivot {
                    operand(value, negated);
                    operand(scale, negated);
                }
            }
            for witness in &mut check.finite {
                if let Witness::Value(operand) = witness {
                    *operand = absolute(*operand);
                }
            }
        }
    }
}

fn statement(statement: &mut Statement, negated: &[bool]) {
    let is_negated = |value: ValueId| negated[value.index()];
    match statement {
        Statement::Let(value, operation) => {
            let reads = |operand: Option<&Operand>| {
                operand.and_then(Operand::value).is_some_and(is_negated)
            };
            let [a, b, c] = operation.operands();
            if is_negated(*value) || reads(a) || reads(b) || reads(c) {
                *operation = rewritten(operation, is_negated(*value), negated);
            }
        }
        Statement::Lane { value, pack, negative, .. } => {
            *negative ^= is_negated(*value) ^ is_negated(*pack);
        }
        Statement::SinCos { angles: operands, .. } | Statement::Pack { values: operands, .. } => {
            operands.iter_mut().for_each(|it| operand(it, negated));
        }
    }
}

/// Rewrites an operand that reads values of which some are negated.
fn operand(operand: &mut Operand, negated: &[bool]) {
    if operand.value().is_some_and(|value| negated[value.index()]) {
        *operand = with_sign(TermSign::of(operand).is_minus(negated), absolute(*operand));
    }
}

/// Returns an operand without its sign.
fn absolute(operand: Operand) -> Operand {
    match operand {
        Operand::Minus(value) => Operand::Value(value),
        Operand::Number(_) | Operand::Value(_) => operand,
    }
}

/// Returns an operand, or its negative if `minus`.
fn with_sign(minus: bool, operand: Operand) -> Operand {
    match (minus, operand) {
        (false, operand) => operand,
        (true, Operand::Number(number)) => Operand::Number(-number),
        (true, Operand::Value(value)) => Operand::Minus(value),
        (true, Operand::Minus(value)) => Operand::Value(value),
    }
}

/// Returns an operation on values of which some are negated; of its result, the negative if `minus`.
fn rewritten(operation: &Operation, minus: bool, negated: &[bool]) -> Operation {
    let of = |operand: &Operand| (TermSign::of(operand).is_minus(negated), absolute(*operand));
    let signed = |operand: &Operand| {
        let (sign, operand) = of(operand);
        with_sign(sign, operand)
    };
    let term = |minus_term: bool, operand: &Operand| {
        let (sign, operand) = of(operand);
        (sign ^ minus_term ^ minus, operand)
    };
    let product = |minus_term: bool, a: &Operand, b: &Operand| {
        let ((sign_a, a), (sign_b, b)) = (of(a), of(b));
        (sign_a ^ sign_b ^ minus_term ^ minus, a, b)
    };
    match operation {
        Operation::Sum(a, b) => sum(term(false, a), term(false, b)),
        Operation::Difference(a, b) => sum(term(false, a), term(true, b)),
        Operation::MulAdd(a, b, c) => fused(product(false, a, b), term(false, c)),
        Operation::MulSub(a, b, c) => fused(product(false, a, b), term(true, c)),
        Operation::MulNegAdd(a, b, c) => fused(product(true, a, b), term(false, c)),
        Operation::Product(a, b) => match product(false, a, b) {
            (sign, a, b @ Operand::Number(_)) => Operation::Product(a, with_sign(sign, b)),
            (sign, a, b) => Operation::Product(with_sign(sign, a), b),
        },
        Operation::Recip(a) => {
            let (sign, a) = term(false, a);
            Operation::Recip(with_sign(sign, a))
        }
        Operation::Sqrt(a) => Operation::Sqrt(signed(a)),
        Operation::CopySign(a, b) => Operation::CopySign(signed(a), signed(b)),
        Operation::Atan2(a, b) => Operation::Atan2(signed(a), signed(b)),
        Operation::RecipAbove(a, b) => Operation::RecipAbove(signed(a), signed(b)),
    }
}

/// Returns `±a ± b`.
fn sum((minus_a, a): (bool, Operand), (minus_b, b): (bool, Operand)) -> Operation {
    match (minus_a, minus_b) {
        (false, false) => Operation::Sum(a, b),
        (false, true) => Operation::Difference(a, b),
        (true, false) => Operation::Difference(b, a),
        (true, true) if b.is_known() => Operation::Difference(with_sign(true, b), a),
        (true, true) => Operation::Difference(with_sign(true, a), b),
    }
}

/// Returns `±a b ± c`.
fn fused((minus, a, b): (bool, Operand, Operand), (minus_c, c): (bool, Operand)) -> Operation {
    match (minus, minus_c) {
        (false, false) => Operation::MulAdd(a, b, c),
        (false, true) => Operation::MulSub(a, b, c),
        (true, false) => Operation::MulNegAdd(a, b, c),
        (true, true) if a.is_known() => Operation::MulSub(with_sign(true, a), b, c),
        (true, true) if b.is_known() => Operation::MulSub(a, with_sign(true, b), c),
        (true, true) => Operation::MulNegAdd(a, b, with_sign(true, c)),
    }
}

/// Gives negated values the names of their negatives.
pub(super) fn names(names: &mut ValueNames, negated: &[bool]) {
    let negated = (0..negated.len()).filter(|&value| negated[value]).map(ValueId);
    for value in negated {
        if !names.is_numbered(value) {
            let name = names.text(value);
            let wanted = name.strip_prefix("minus_").map_or(format!("minus_{name}"), str::to_owned);
            names.rename(value, wanted);
        }
    }
}
