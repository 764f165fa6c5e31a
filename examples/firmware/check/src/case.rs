//! The cases: chains and controllers, each in single and in double precision.

use std::fmt;

use models::{
    Arm, BallPendulum, CartPole, ComputedTorque, InverseDynamics, LinearArm, Model, Satellite,
};

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
    Satellite,
    InverseDynamics,
    ComputedTorque,
    LinearArm,
    CartPole,
}

/// The precision of a chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Precision {
    Single,
    Double,
}

impl Precision {
    /// Returns the number with these bits.
    pub fn number(self, bits: u64) -> f64 {
        match self {
            Self::Single => f32::from_bits(bits as u32).into(),
            Self::Double => f64::from_bits(bits),
        }
    }

    /// Returns the largest relative error of a rounding.
    pub fn rounding(self) -> f64 {
        match self {
            Self::Single => f64::from(f32::EPSILON) / 2.0,
            Self::Double => f64::EPSILON / 2.0,
        }
    }
}

/// The budgets of a step.
pub struct Budget {
    pub instructions: u32,
    /// The largest stack depth in bytes.
    pub stack: u32,
    /// The largest size of a step's code with everything that it calls, in bytes, if limited.
    pub code: Option<u64>,
}

/// A function of the type of a case.
pub trait Visitor {
    type Result;
    fn visit<M: Model>(self) -> Self::Result;
}

impl Case {
    pub const ALL: [Self; 14] = [
        Self { chain: Chain::Ball, precision: Precision::Single },
        Self { chain: Chain::Ball, precision: Precision::Double },
        Self { chain: Chain::Arm, precision: Precision::Single },
        Self { chain: Chain::Arm, precision: Precision::Double },
        Self { chain: Chain::Satellite, precision: Precision::Single },
        Self { chain: Chain::Satellite, precision: Precision::Double },
        Self { chain: Chain::InverseDynamics, precision: Precision::Single },
        Self { chain: Chain::InverseDynamics, precision: Precision::Double },
        Self { chain: Chain::ComputedTorque, precision: Precision::Single },
        Self { chain: Chain::ComputedTorque, precision: Precision::Double },
        Self { chain: Chain::LinearArm, precision: Precision::Single },
        Self { chain: Chain::LinearArm, precision: Precision::Double },
        Self { chain: Chain::CartPole, precision: Precision::Single },
        Self { chain: Chain::CartPole, precision: Precision::Double },
    ];

    /// Returns the name of the image.
    pub fn name(self) -> &'static str {
        match (self.chain, self.precision) {
            (Chain::Ball, Precision::Single) => "ball_f32",
            (Chain::Ball, Precision::Double) => "ball_f64",
            (Chain::Arm, Precision::Single) => "arm_f32",
            (Chain::Arm, Precision::Double) => "arm_f64",
            (Chain::Satellite, Precision::Single) => "satellite_f32",
            (Chain::Satellite, Precision::Double) => "satellite_f64",
            (Chain::InverseDynamics, Precision::Single) => "inverse_dynamics_f32",
            (Chain::ComputedTorque, Precision::Single) => "computed_torque_f32",
            (Chain::InverseDynamics, Precision::Double) => "inverse_dynamics_f64",
            (Chain::ComputedTorque, Precision::Double) => "computed_torque_f64",
            (Chain::LinearArm, Precision::Single) => "linear_arm_f32",
            (Chain::LinearArm, Precision::Double) => "linear_arm_f64",
            (Chain::CartPole, Precision::Single) => "cart_pole_f32",
            (Chain::CartPole, Precision::Double) => "cart_pole_f64",
        }
    }

    /// Returns whether the results are those of an estimate of the payload.
    pub fn estimates(self) -> bool {
        self.chain == Chain::ComputedTorque
    }

    /// Returns the case of an image.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|case| case.name() == name)
    }

    /// Returns the budget of a step on a processor with this precision in hardware.
    pub fn budget(self) -> Option<Budget> {
        match (self.chain, self.precision) {
            (Chain::Ball, Precision::Single) => {
                Some(Budget { instructions: 12_000, stack: 1024, code: Some(16 * 1024) })
            }
            (Chain::Arm, Precision::Single) => {
                Some(Budget { instructions: 30_000, stack: 2048, code: None })
            }
            (Chain::Satellite, Precision::Single) => {
                Some(Budget { instructions: 40_000, stack: 2048, code: None })
            }
            (Chain::InverseDynamics, Precision::Single) => {
                Some(Budget { instructions: 2_000, stack: 1024, code: None })
            }
            (Chain::ComputedTorque, Precision::Single) => {
                Some(Budget { instructions: 25_000, stack: 3072, code: None })
            }
            (Chain::LinearArm, Precision::Single) => {
                Some(Budget { instructions: 15_000, stack: 4608, code: None })
            }
            (Chain::CartPole, Precision::Single) => {
                Some(Budget { instructions: 100_000, stack: 2048, code: None })
            }
            (_, Precision::Double) => None,
        }
    }

    /// Calls a function with the type of the case.
    pub fn visit<V: Visitor>(self, visitor: V) -> V::Result {
        match (self.chain, self.precision) {
            (Chain::Ball, Precision::Single) => visitor.visit::<BallPendulum<f32>>(),
            (Chain::Ball, Precision::Double) => visitor.visit::<BallPendulum<f64>>(),
            (Chain::Arm, Precision::Single) => visitor.visit::<Arm<f32>>(),
            (Chain::Arm, Precision::Double) => visitor.visit::<Arm<f64>>(),
            (Chain::Satellite, Precision::Single) => visitor.visit::<Satellite<f32>>(),
            (Chain::Satellite, Precision::Double) => visitor.visit::<Satellite<f64>>(),
            (Chain::InverseDynamics, Precision::Single) => visitor.visit::<InverseDynamics<f32>>(),
            (Chain::ComputedTorque, Precision::Single) => visitor.visit::<ComputedTorque<f32>>(),
            (Chain::InverseDynamics, Precision::Double) => visitor.visit::<InverseDynamics<f64>>(),
            (Chain::ComputedTorque, Precision::Double) => visitor.visit::<ComputedTorque<f64>>(),
            (Chain::LinearArm, Precision::Single) => visitor.visit::<LinearArm<f32>>(),
            (Chain::LinearArm, Precision::Double) => visitor.visit::<LinearArm<f64>>(),
            (Chain::CartPole, Precision::Single) => visitor.visit::<CartPole<f32>>(),
            (Chain::CartPole, Precision::Double) => visitor.visit::<CartPole<f64>>(),
        }
    }
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
