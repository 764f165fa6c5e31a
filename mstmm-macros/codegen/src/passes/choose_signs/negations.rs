//! The negations that an operation costs.

use crate::program::{Operand, Operation, ValueId};

/// The sign of a product of values, times −1 if `minus`.
#[derive(Clone, Copy)]
pub(super) struct TermSign {
    minus: bool,
    values: [Option<ValueId>; 3],
}

impl TermSign {
    const MINUS: TermSign = TermSign { minus: true, values: [None; 3] };

    /// Returns the sign of an operand.
    pub(super) fn of(operand: &Operand) -> TermSign {
        TermSign { minus: operand.is_negated(), values: [operand.value(), None, None] }
    }

    /// Returns whether it is minus if some values are negated.
    pub(super) fn is_minus(&self, negated: &[bool]) -> bool {
        let of = |value: Option<ValueId>| match value {
            Some(value) => negated[value.index()],
            None => false,
        };
        let [a, b, c] = self.values;
        self.minus ^ of(a) ^ of(b) ^ of(c)
    }
}

/// A place that needs a negation while both signs are minus.
pub(super) struct Place([TermSign; 2]);

impl Place {
    /// Returns the place that needs a negation while a sign is minus.
    pub(super) fn of(sign: TermSign) -> Place {
        Place([sign, TermSign::MINUS])
    }

    /// Returns the place where a value is read from a lane of a pack, or its negative.
    pub(super) fn of_lane(value: ValueId, pack: ValueId, negative: bool) -> Place {
        Place::of(TermSign { minus: negative, values: [Some(value), Some(pack), None] })
    }

    /// Returns the places that an operation with its result consists of.
    pub(super) fn of_operation(value: ValueId, operation: &Operation) -> [Option<Place>; 2] {
        // A term is negated if its sign, times that of the result, is minus.
        let term = |minus: bool, a: &Operand| TermSign {
            minus: minus ^ a.is_negated(),
            values: [a.value(), Some(value), None],
        };
        let product = |minus: bool, a: &Operand, b: &Operand| TermSign {
            minus: minus ^ a.is_negated() ^ b.is_negated(),
            values: [a.value(), b.value(), Some(value)],
        };
        let place = match operation {
            Operation::Sum(a, b) => Place([term(false, a), term(false, b)]),
            Operation::Difference(a, b) => Place([term(false, a), term(true, b)]),
            Operation::MulAdd(a, b, c) => Place([product(false, a, b), term(false, c)]),
            Operation::MulSub(a, b, c) => Place([product(false, a, b), term(true, c)]),
            Operation::MulNegAdd(a, b, c) => Place([product(true, a, b), term(false, c)]),
            Operation::Product(a, b) => Place::of(product(false, a, b)),
            Operation::Recip(a) => return [Some(Place::of(term(false, a))), None],
            Operation::Sqrt(_)
            | Operation::CopySign(..)
            | Operation::Atan2(..)
            | Operation::RecipAbove(..) => {
                let [a, b, _] = operation.operands();
                return [a, b]
                    .map(|operand| operand.map(|operand| Place::of(TermSign::of(operand))));
            }
        };
        // The sign of a number costs nothing.
        let has_number = operation.operands().into_iter().flatten().any(Operand::is_known);
        [(!has_number).then_some(place), None]
    }

    /// Returns whether it needs a negation if some values are negated.
    pub(super) fn needs_negation(&self, negated: &[bool]) -> bool {
        let [a, b] = &self.0;
        a.is_minus(negated) && b.is_minus(negated)
    }

    /// Returns the values whose signs matter.
    pub(super) fn values(&self) -> [Option<ValueId>; 6] {
        let [[a, b, c], [d, e, f]] = [self.0[0].values, self.0[1].values];
        [a, b, c, d, e, f]
    }
}

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
