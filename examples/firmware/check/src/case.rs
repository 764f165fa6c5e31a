//! What is stepped: two chains, each in single and in double precision.

use std::fmt;

use models::{Arm, BallPendulum, Model};

/// A chain in a precision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    chain: Chain,
    pub precision: Precision,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Chain {
    Ball,
    Arm,
}

/// What numbers a chain is computed with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Precision {
    Single,
    Double,
}

/// What the budgets of a step allow.
pub struct Budget {
    pub instructions: u32,
    /// In bytes.
    pub stack: u32,
    /// Code with all that a step calls, in bytes, where there is a limit.
    pub code: Option<u64>,
}

/// Something to be done with the type that a case stands for.
pub trait Visitor {
    type Result;
    fn visit<M: Model>(self) -> Self::Result;
}

impl Case {
    pub const ALL: [Self; 4] = [
        Self { chain: Chain::Ball, precision: Precision::Single },
        Self { chain: Chain::Ball, precision: Precision::Double },
        Self { chain: Chain::Arm, precision: Precision::Single },
        Self { chain: Chain::Arm, precision: Precision::Double },
    ];

    /// Of the image.
    pub fn name(self) -> &'static str {
        match (self.chain, self.precision) {
            (Chain::Ball, Precision::Single) => "ball_f32",
            (Chain::Ball, Precision::Double) => "ball_f64",
            (Chain::Arm, Precision::Single) => "arm_f32",
            (Chain::Arm, Precision::Double) => "arm_f64",
        }
    }

    /// The case of an image.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|case| case.name() == name)
    }

    /// What a step may take on a processor that computes in this precision.
    pub fn budget(self) -> Option<Budget> {
        match (self.chain, self.precision) {
            (Chain::Ball, Precision::Single) => {
                Some(Budget { instructions: 12_000, stack: 1024, code: Some(16 * 1024) })
            }
            (Chain::Arm, Precision::Single) => {
                Some(Budget { instructions: 30_000, stack: 2048, code: None })
            }
            (_, Precision::Double) => None,
        }
    }

    /// Does something with its type.
    pub fn visit<V: Visitor>(self, visitor: V) -> V::Result {
        match (self.chain, self.precision) {
            (Chain::Ball, Precision::Single) => visitor.visit::<BallPendulum<f32>>(),
            (Chain::Ball, Precision::Double) => visitor.visit::<BallPendulum<f64>>(),
            (Chain::Arm, Precision::Single) => visitor.visit::<Arm<f32>>(),
            (Chain::Arm, Precision::Double) => visitor.visit::<Arm<f64>>(),
        }
    }
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
