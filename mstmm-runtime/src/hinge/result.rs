//! Results at hinges.

use core::marker::PhantomData;

use crate::{ConnectionPoint, Point};

/// The results at one hinge: acceleration, effort and both connection points.
///
/// `V` is a scalar for a hinge with one rate, else a vector. `P` is the type of connection points, [`Point`] in space.
#[doc(alias = "joint")]
#[derive(Clone, Copy, Debug)]
pub struct HingeResult<T, V, P = Point<T>> {
    acceleration: V,
    effort: V,
    input: P,
    output: P,
    number: PhantomData<T>,
}

impl<T, V: Copy, P: ConnectionPoint<Scalar = T> + Copy> HingeResult<T, V, P> {
    /// Makes the result; for generated code.
    #[inline]
    pub fn new(acceleration: V, effort: V, input: P, output: P) -> Self {
        Self { acceleration, effort, input, output, number: PhantomData }
    }

    /// Returns the time derivative of the rates of the hinge, in the frame of the rates: rad/s² and m/s².
    #[doc(alias("qdd", "qacc", "vdot"))]
    #[inline]
    pub fn acceleration(&self) -> V {
        self.acceleration
    }

    /// Returns the torque (N·m) or force (N) of the motor along the degrees of freedom, positive if it increases the rates.
    ///
    /// For a hinge with a prescribed motion it is the effort that its drive must supply.
    #[doc(alias("joint torque", "tau", "qfrc_actuator", "generalized force"))]
    #[inline]
    pub fn effort(&self) -> V {
        self.effort
    }

    /// Returns the input of the hinge, on the inboard side.
    #[inline]
    pub fn input(&self) -> P {
        self.input
    }

    /// Returns the output of the hinge, on the outboard side.
    #[inline]
    pub fn output(&self) -> P {
        self.output
    }
}

/// Results at places with one force and one moment: points, not hinges.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "forces and moments belong to the points of a hinge",
    label = "write `input().force()`, `input().moment()` or `effort()`",
    note = "`input()` and `output()` of a hinge have `force()` and `moment()`; `effort()` is what its motor supplies"
)]
pub trait WithOneForce {}

/// Methods that hinges do not have: rustc reports where the values are.
#[doc(hidden)]
impl<T, V, P> HingeResult<T, V, P> {
    pub fn force(&self)
    where
        Self: WithOneForce,
    {
    }

    pub fn moment(&self)
    where
        Self: WithOneForce,
    {
    }

    pub fn torque(&self)
    where
        Self: WithOneForce,
    {
    }
}
