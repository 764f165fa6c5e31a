//! Results at bodies.

use core::marker::PhantomData;

use crate::{BodyPoint, ConnectionPoint, Point};

/// The results at one body: its input, its output and its centre of mass.
///
/// `P` is the type of connection points, [`Point`] in space. `W` lists the optional points that the description of
/// the body has. Named points are methods of a type generated for the body, which dereferences to this type.
#[doc(alias("link", "frame", "site"))]
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
    /// Makes the result from the connection points and the centre of mass in m, body frame; for generated code.
    #[inline]
    pub fn new(input: P, output: P, com: P::Vector) -> Self {
        Self { input, output, com, written: PhantomData }
    }

    /// Returns the input of the body. There [`force`](Point::force) acts on the body, and minus
    /// [`moment`](Point::moment).
    #[inline]
    pub fn input(&self) -> P {
        self.input
    }

    /// Returns the output of the body. There minus [`force`](Point::force) acts on the body, and
    /// [`moment`](Point::moment).
    ///
    /// It exists only if the description of the body has an `output`.
    #[inline]
    pub fn output(&self) -> P
    where
        W: HasOutput,
    {
        self.output
    }

    /// Returns the motion of the centre of mass.
    ///
    /// In a line chain it exists only if the description of the body has a `com`.
    #[doc(alias("centre of mass", "center of mass", "CoM", "xipos"))]
    #[inline]
    pub fn com(&self) -> BodyPoint<P>
    where
        W: HasCom,
    {
        BodyPoint::new(self.input, self.com)
    }
}

/// The optional points that the description of a body has.
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
