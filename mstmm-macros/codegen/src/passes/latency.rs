//! Latencies of operations in cycles, approximately those of desktop processors of the 2020s in double precision. Only
//! their ratios matter.

use crate::expr::Node;
use crate::program::{Operation, Statement};

pub(super) const ADDITION: u32 = 3;
/// The latency of a product, also if it is fused with an addition.
pub(super) const MULTIPLICATION: u32 = 4;
const DIVISION: u32 = 14;
/// The latency of a division for the order of statements, longer than that of a processor. On Zen 4, 19 instead of 14 saves 3 %
/// of the accelerations of seven crossed pins, 4 % of all their results, and 1 % of the wrenches of the Panda.
const DIVISION_IN_ORDER: u32 = 19;
const ROOT: u32 = 19;
/// The latency of a group of sines and cosines, and of an arctangent.
const ANGLE: u32 = 60;

/// Returns the latency of a node that is computed in a separate operation.
pub(super) fn of_node(node: &Node) -> u32 {
    match node {
        Node::Number(_) | Node::Symbol(_) => 0,
        Node::Sum(..) | Node::CopySign(..) => ADDITION,
        Node::Product(..) => MULTIPLICATION,
        Node::Recip(_) | Node::RecipAbove(..) => DIVISION,
        Node::Sqrt(_) => ROOT,
        Node::Sin(_) | Node::Cos(_) | Node::Atan2(..) => ANGLE,
    }
}

/// Returns the latency of a statement.
pub(super) fn of_statement(statement: &Statement) -> u32 {
    match statement {
        Statement::SinCos { .. } => ANGLE,
        Statement::Pack { .. } | Statement::Lane { .. } => ADDITION,
        Statement::Let(_, operation) => match operation {
            Operation::Sum(..) | Operation::Difference(..) | Operation::CopySign(..) => ADDITION,
            Operation::Product(..)
            | Operation::MulAdd(..)
            | Operation::MulSub(..)
            | Operation::MulNegAdd(..) => MULTIPLICATION,
            Operation::Recip(_) | Operation::RecipAbove(..) => DIVISION_IN_ORDER,
            Operation::Sqrt(_) => ROOT,
            Operation::Atan2(..) => ANGLE,
        },
    }
}
