//! Results at bodies.

use core::marker::PhantomData;

use crate::{BodyPoint, ConnectionPoint, Point};

/// The results at one body: its input, its output and its centre of mass.
///
/// `P` is the type of connection points, [`Point`] in space. `W` says which points the description of
/// the body has. Named points are methods of a type that is generated for the body, which dereferences
/// to this one.
#[derive(Clone, Copy, Debug)]
pub struct BodyResult<T, P: ConnectionPoint = Point<T>, W = OptionalPoints<true, true>> {
    input: P,
    output: P,
    com: P::Vector,
    written: PhantomData<(T, W)>,
}

impl<T, P, W> BodyResult<T, P, W>
where
    P: ConnectionPoint<Scalar = T, Vector: Copy> + Copy,
{
    /// Makes the result from the connection points and the centre of mass in the body frame, m;
    /// generated code calls this.
    #[inline]
    pub fn new(input: P, output: P, com: P::Vector) -> Self {
        Self { input, output, com, written: PhantomData }
    }

    /// Returns the body's input end. The force on the body there is +q, the torque −m.
    #[inline]
    pub fn input(&self) -> P {
        self.input
    }

    /// Returns the body's output end. The force on the body there is −q, the torque +m.
    ///
    /// It exists only where the description of the body has an `output`.
    #[inline]
    pub fn output(&self) -> P
    where
        W: HasOutput,
    {
        self.output
    }

    /// Returns the motion of the centre of mass.
    ///
    /// In a line chain it exists only where the description of the body has a `com`.
    #[inline]
    pub fn com(&self) -> BodyPoint<P>
    where
        W: HasCom,
    {
        BodyPoint::new(self.input, self.com)
    }
}

/// Which points the description of a body has, of those that it may omit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OptionalPoints<const OUTPUT: bool, const COM: bool>;

/// Bodies with an output in their description.
#[diagnostic::on_unimplemented(
    message = "the description of this body has no `output`",
    label = "needs an output",
    note = "add `output = …;` to the body's description, or read `input()`, `com()` or a named point"
)]
pub trait HasOutput {}

impl<const COM: bool> HasOutput for OptionalPoints<true, COM> {}

/// Bodies with a centre of mass in their description.
#[diagnostic::on_unimplemented(
    message = "the description of this body has no `com`",
    label = "needs a centre of mass",
    note = "add `com = …;` to the body's description, or read `input()` or a named point"
)]
pub trait HasCom {}

impl<const OUTPUT: bool> HasCom for OptionalPoints<OUTPUT, true> {}
