//! A chain in either precision.

use mstmm::{ChainState, Energy, GeneratedChain, LinePoint, PlanePoint, Point, Scalar};

/// Single or double precision.
pub trait Number: Scalar<Real = Self, Mask = bool> + Into<f64> {}

impl Number for f32 {}
impl Number for f64 {}

/// A generated chain with access that its public traits do not provide; the command generates it.
pub trait Subject: GeneratedChain<Scalar: Number> + Default + 'static {
    /// Its connection points.
    type Point: Reading;

    /// Returns the inputs from all their numbers.
    fn inputs(given: &[f64]) -> Self::Inputs;

    /// The connection points among the results.
    fn points(at: &Self::Workspace) -> Vec<Self::Point>;

    /// The energy among the results.
    fn energy_at(at: &Self::Workspace) -> Energy<Self::Scalar>;
}

/// A connection point in any number of dimensions.
pub trait Reading {
    /// The position in m, in the directions that the chain has.
    fn position(&self) -> [f64; 3];
    /// The force in N.
    fn force(&self) -> [f64; 3];
    /// The moment in N m.
    fn moment(&self) -> [f64; 3];
}

impl<T: Number> Reading for Point<T> {
    fn position(&self) -> [f64; 3] {
        self.position().data.0[0].map(Into::into)
    }

    fn force(&self) -> [f64; 3] {
        self.force().data.0[0].map(Into::into)
    }

    fn moment(&self) -> [f64; 3] {
        self.moment().data.0[0].map(Into::into)
    }
}

impl<T: Number> Reading for PlanePoint<T> {
    fn position(&self) -> [f64; 3] {
        [self.position().x.into(), self.position().y.into(), 0.0]
    }

    fn force(&self) -> [f64; 3] {
        [self.force().x.into(), self.force().y.into(), 0.0]
    }

    fn moment(&self) -> [f64; 3] {
        [0.0, 0.0, self.moment().into()]
    }
}

impl<T: Number> Reading for LinePoint<T> {
    fn position(&self) -> [f64; 3] {
        [self.position().into(), 0.0, 0.0]
    }

    fn force(&self) -> [f64; 3] {
        [self.force().into(), 0.0, 0.0]
    }

    fn moment(&self) -> [f64; 3] {
        [0.0; 3]
    }
}

/// Writes the coordinates, rates and time of one state into another, rounded to its precision.
pub fn convert<A, B>(from: &A, to: &mut B)
where
    A: ChainState<Scalar: Number>,
    B: ChainState<Scalar: Number>,
{
    let write = |to: &mut [B::Scalar], from: &[A::Scalar]| {
        to.iter_mut().zip(from).for_each(|(to, &from)| *to = B::Scalar::constant(from.into()));
    };
    write(to.coordinates_mut(), from.coordinates());
    write(to.rates_mut(), from.rates());
    to.set_time(B::Scalar::constant(from.time().into()));
}

/// Returns a list in double precision.
pub fn doubles<T: Number>(numbers: &[T]) -> Vec<f64> {
    numbers.iter().map(|&number| number.into()).collect()
}
