//! What a solution says of hinges.

use core::marker::PhantomData;

use crate::{ConnectionPoint, Point};

/// What a solution says of one hinge. `V` is a number for a hinge with one coordinate, a vector for
/// others; `P` is the kind of connection point, [`Point`] in space.
#[derive(Clone, Copy, Debug)]
pub struct HingeResult<T, V, P = Point<T>> {
    acceleration: V,
    effort: V,
    input: P,
    output: P,
    number: PhantomData<T>,
}

impl<T, V: Copy, P: ConnectionPoint<Scalar = T> + Copy> HingeResult<T, V, P> {
    /// Puts the result together; generated code does.
    #[inline]
    pub fn new(acceleration: V, effort: V, input: P, output: P) -> Self {
        Self { acceleration, effort, input, output, number: PhantomData }
    }

    /// The time derivative of the hinge's rates, in the frame of the rates: rad/s² and m/s².
    #[inline]
    pub fn acceleration(&self) -> V {
        self.acceleration
    }

    /// The torque (N·m) or force (N) of the hinge's motor along its free directions, positive where
    /// it drives the rates up; of a hinge that moves as prescribed, what its drive must supply.
    #[inline]
    pub fn effort(&self) -> V {
        self.effort
    }

    /// The hinge's input end, on the inboard side.
    #[inline]
    pub fn input(&self) -> P {
        self.input
    }

    /// The hinge's output end, on the outboard side.
    #[inline]
    pub fn output(&self) -> P {
        self.output
    }
}
