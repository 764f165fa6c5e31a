//! Rewrites a procedure of which some values are negated.

use super::negations::{is_minus, is_number};
use crate::program::{
    Operand, Operation, PivotValue, Section, Statement, Step, ValueId, ValueNames, Witness,
};
use std::collections::HashSet;

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
                    *operand = absolute(operand);
                }
            }
        }
    }
}

fn statement(statement: &mut Statement, negated: &[bool]) {
    let is_negated = |value: ValueId| negated[value.index()];
    match statement {
        Statement::Let(value, operation) => {
            let values = operation.operands().into_iter().flatten().filter_map(Operand::value);
            if values.chain([*value]).any(is_negated) {
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
        *operand = with_sign(is_minus(operand, negated), absolute(operand));
    }
}

/// Returns an operand without its sign.
fn absolute(operand: &Operand) -> Operand {
    match operand {
        Operand::Minus(inner) => absolute(inner),
        Operand::Number(_) | Operand::Value(_) => operand.clone(),
    }
}

/// Returns an operand, or its negative if `minus`.
fn with_sign(minus: bool, operand: Operand) -> Operand {
    match (minus, operand) {
        (false, operand) => operand,
        (true, Operand::Number(number)) => Operand::Number(-number),
        (true, operand) => Operand::Minus(Box::new(operand)),
    }
}

/// Returns an operation on values of which some are negated; of its result, the negative if `minus`.
fn rewritten(operation: &Operation, minus: bool, negated: &[bool]) -> Operation {
    let of = |operand: &Operand| (is_minus(operand, negated), absolute(operand));
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
        (true, true) if is_number(&b) => Operation::Difference(with_sign(true, b), a),
        (true, true) => Operation::Difference(with_sign(true, a), b),
    }
}

/// Returns `±a b ± c`.
fn fused((minus, a, b): (bool, Operand, Operand), (minus_c, c): (bool, Operand)) -> Operation {
    match (minus, minus_c) {
        (false, false) => Operation::MulAdd(a, b, c),
        (false, true) => Operation::MulSub(a, b, c),
        (true, false) => Operation::MulNegAdd(a, b, c),
        (true, true) if is_number(&a) => Operation::MulSub(with_sign(true, a), b, c),
        (true, true) if is_number(&b) => Operation::MulSub(a, with_sign(true, b), c),
        (true, true) => Operation::MulNegAdd(a, b, with_sign(true, c)),
    }
}

/// Gives negated values the names of their negatives.
pub(super) fn names(names: &mut ValueNames, negated: &[bool]) {
    let mut taken: HashSet<String> = names.all().iter().cloned().collect();
    for value in (0..negated.len()).map(ValueId).filter(|value| negated[value.index()]) {
        if names.is_numbered(value) {
            continue;
        }
        let name = names.text(value);
        let wanted = name.strip_prefix("minus_").map_or(format!("minus_{name}"), str::to_owned);
        let numbered = (2..).map(|number| format!("{wanted}_{number}"));
        let mut free = std::iter::once(wanted.clone()).chain(numbered);
        if let Some(free) = free.find(|name| taken.insert(name.clone())) {
            names.rename(value, free);
        }
    }
}
