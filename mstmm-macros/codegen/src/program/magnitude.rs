//! Finds bounds of arguments below which all values of a program are finite.
//!
//! A matrix has many more entries than a state has coordinates and rates. If the arguments are moderate, products and sums of
//! them cannot overflow, and the entries need not be tested.

use super::{Operand, Operation, Program, Statement, ValueId};
use crate::ids::SymbolId;

/// Values whose magnitudes are tested together.
#[derive(Clone, Debug, PartialEq)]
pub struct ValueBound {
    /// The bound of the sum of their squares, and so of each square.
    pub square: f64,
    /// The values.
    pub values: Vec<Operand>,
}

/// The largest magnitude of a value. The largest `f32` is just below `2^128`; the difference is for rounding errors.
const LARGEST: f64 = (1_u128 << 120) as f64;

/// The largest angle in rad. In `f32` the sine of an angle is NaN from a little above on.
const LARGEST_ANGLE: f64 = (1_u64 << 21) as f64;

/// The exponents `e` of bounds `2^e` for arguments other than quaternions, from the best. A smaller bound would be exceeded by usual
/// arguments.
const EXPONENTS: [i32; 5] = [32, 24, 20, 16, 12];

/// The bound of the square of a quaternion's length, which is near one.
const QUATERNION: f64 = 2.0;

impl Program {
    /// Returns bounds for all unknowns and slots. If they hold, all values are finite. There are none for a program with
    /// divisions or square roots, and for one whose values grow too fast.
    ///
    /// `quaternion` returns the number of the quaternion that an unknown is a component of. The program must not have loops.
    pub fn bounds(
        &self,
        quaternion: impl Fn(SymbolId) -> Option<usize>,
    ) -> Option<Vec<ValueBound>> {
        let mut quaternions: Vec<(usize, Vec<ValueId>)> = Vec::new();
        let mut others: Vec<ValueId> = self.slots.iter().map(|slot| slot.value).collect();
        for &(symbol, value) in &self.unknowns {
            match (quaternion(symbol), quaternions.last_mut()) {
                (None, _) => others.push(value),
                (Some(number), Some((last, values))) if *last == number => values.push(value),
                (Some(number), _) => quaternions.push((number, vec![value])),
            }
        }
        let bound = |square, values: &[ValueId]| {
            let values = values.iter().copied().map(Operand::Value).collect();
            ValueBound { square, values }
        };
        let of_quaternions = quaternions.iter().map(|(_, values)| bound(QUATERNION, values));
        let of_quaternions: Vec<ValueBound> = of_quaternions.collect();
        let with_others = |exponent: i32| {
            let of_others = bound(2.0_f64.powi(2 * exponent), &others);
            let of_others = (!others.is_empty()).then_some(of_others);
            of_quaternions.iter().cloned().chain(of_others).collect::<Vec<_>>()
        };
        EXPONENTS.into_iter().map(with_others).find(|bounds| self.is_finite_within(bounds))
    }

    /// Returns whether all values are finite within bounds.
    fn is_finite_within(&self, bounds: &[ValueBound]) -> bool {
        let mut magnitudes = vec![0.0; self.names.count()];
        for ValueBound { square, values } in bounds {
            let values = values.iter().filter_map(Operand::value);
            values.for_each(|value| magnitudes[value.index()] = square.sqrt());
        }
        let statements = self.sections().flat_map(|section| &section.statements);
        for statement in statements {
            match statement {
                Statement::Let(value, operation) => {
                    let magnitude = magnitude(operation, &magnitudes);
                    if magnitude > LARGEST {
                        return false;
                    }
                    magnitudes[value.index()] = magnitude;
                }
                Statement::SinCos { sines, cosines, angles } => {
                    if angles.iter().any(|angle| of_operand(angle, &magnitudes) > LARGEST_ANGLE) {
                        return false;
                    }
                    let values = sines.iter().chain(cosines).flatten();
                    values.for_each(|value| magnitudes[value.index()] = 1.0);
                }
                Statement::Pack { .. } | Statement::Lane { .. } => bug!("a program has no packs"),
            }
        }
        true
    }
}

/// Returns a bound for the magnitude of the value of an operation; infinite for operations that may be undefined.
fn magnitude(operation: &Operation, magnitudes: &[f64]) -> f64 {
    let of = |operand: &Operand| of_operand(operand, magnitudes);
    match operation {
        Operation::Sum(a, b) | Operation::Difference(a, b) => of(a) + of(b),
        Operation::Product(a, b) => of(a) * of(b),
        Operation::MulAdd(a, b, c) | Operation::MulSub(a, b, c) | Operation::MulNegAdd(a, b, c) => {
            of(a) * of(b) + of(c)
        }
        Operation::CopySign(a, _) => of(a),
        Operation::Atan2(..) => 4.0,
        Operation::Recip(_) | Operation::Sqrt(_) | Operation::RecipAbove(..) => f64::INFINITY,
    }
}

fn of_operand(operand: &Operand, magnitudes: &[f64]) -> f64 {
    match operand {
        Operand::Number(number) => number.abs(),
        Operand::Value(value) | Operand::Minus(value) => magnitudes[value.index()],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::{Block, Section, ValueNames};

    /// Returns a program of statements that define values from two unknowns, the first of its values.
    fn program(statements: impl Fn(&[ValueId]) -> Vec<Statement>) -> Program {
        let mut names = ValueNames::default();
        let values: Vec<ValueId> = (0..8).map(|k| names.add(format!("v{k}"))).collect();
        let section = Section { statements: statements(&values), ..Section::default() };
        Program {
            names,
            unknowns: vec![(SymbolId(0), values[0]), (SymbolId(1), values[1])],
            slots: Vec::new(),
            blocks: vec![Block::Once(vec![section])].into(),
            results: Vec::new(),
            pivots: Vec::new(),
        }
    }

    /// Returns the exponent of the bound of the second unknown, if the first is of a quaternion.
    fn exponent_of(statements: impl Fn(&[ValueId]) -> Vec<Statement>) -> Option<i32> {
        let quaternion = |symbol| (symbol == SymbolId(0)).then_some(0);
        let bounds = program(statements).bounds(quaternion)?;
        let squares: Vec<f64> = bounds.iter().map(|bound| bound.square).collect();
        let [2.0, square] = squares[..] else { panic!("{bounds:?}") };
        Some(square.log2() as i32 / 2)
    }

    /// Returns it for a program that computes the values of `operations` one after the other.
    fn exponent(operations: impl Fn(&[Operand]) -> Vec<Operation>) -> Option<i32> {
        exponent_of(|values| {
            let operands: Vec<Operand> = values.iter().copied().map(Operand::Value).collect();
            let defined = values[2..].iter().zip(operations(&operands));
            defined.map(|(value, operation)| Statement::Let(*value, operation)).collect()
        })
    }

    #[test]
    fn bounds_are_as_large_as_the_values_allow() {
        let square = |v: &[Operand]| Operation::Product(v[1], v[1]);
        let times = |v: &[Operand], k: usize| Operation::Product(v[k], v[1]);
        assert_eq!(exponent(|v| vec![square(v), times(v, 2)]), Some(32));
        // The fourth power is 2^128 at 2^32.
        assert_eq!(exponent(|v| vec![square(v), times(v, 2), times(v, 3)]), Some(24));
        let powers = |v: &[Operand]| {
            vec![square(v), times(v, 2), times(v, 3), times(v, 4), times(v, 5), times(v, 6)]
        };
        assert_eq!(exponent(powers), Some(16));
        let large = |v: &[Operand]| {
            let factor = Operand::Number(1e30);
            vec![Operation::MulAdd(v[1], v[1], factor), times(v, 2)]
        };
        assert_eq!(exponent(large), Some(20));
    }

    #[test]
    fn bounds_keep_angles_in_the_range_of_the_sine() {
        let sine = |values: &[ValueId]| {
            let angles = vec![Operand::Value(values[1])];
            let (sines, cosines) = (vec![Some(values[2])], vec![None]);
            vec![Statement::SinCos { sines, cosines, angles }]
        };
        assert_eq!(exponent_of(sine), Some(20));
        let of_four_times = |values: &[ValueId]| {
            let angle = Operand::Value(values[1]);
            let product = Operation::Product(Operand::Number(4.0), angle);
            let (sines, cosines) = (vec![Some(values[3])], vec![None]);
            let angles = vec![Operand::Value(values[2])];
            vec![Statement::Let(values[2], product), Statement::SinCos { sines, cosines, angles }]
        };
        assert_eq!(exponent_of(of_four_times), Some(16));
    }

    #[test]
    fn operations_that_may_be_undefined_have_no_bounds() {
        let of_first = |v: &[Operand]| v[0];
        assert_eq!(exponent(|v| vec![Operation::Recip(of_first(v))]), None);
        assert_eq!(exponent(|v| vec![Operation::Sqrt(of_first(v))]), None);
        assert_eq!(exponent(|v| vec![Operation::RecipAbove(of_first(v), of_first(v))]), None);
        let is_bounded = |v: &[Operand]| vec![Operation::Atan2(of_first(v), of_first(v))];
        assert_eq!(exponent(is_bounded), Some(32));
    }
}
