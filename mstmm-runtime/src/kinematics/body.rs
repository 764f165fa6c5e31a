//! The kinematics of a body.

use core::marker::PhantomData;

use super::point::{BodyMotion, PointKinematics};
use crate::{HasCom, HasOutput, OptionalPoints};

/// The kinematics of one body: its input, its output, its centre of mass and any other point.
///
/// `M` is the motion of the body, `N` the number of free rates, and `C` holds the columns of the Jacobian if the chain
/// computes them. `W` lists the optional points that the description of the body has. Named points are methods of a type
/// generated for the body, which dereferences to this type.
#[doc(alias("link", "frame", "site"))]
#[derive(Clone, Copy, Debug)]
pub struct BodyKinematics<M: BodyMotion, const N: usize, C, W = OptionalPoints<true, true>> {
    motion: M,
    output: (M::Vector, M::Rotation),
    com: M::Vector,
    columns: C,
    written: PhantomData<W>,
}

impl<M: BodyMotion, const N: usize, C: Copy, W> BodyKinematics<M, N, C, W> {
    /// Makes the kinematics of a body from its motion, its output and its centre of mass in the body frame, and the
    /// columns of all rates.
    #[doc(hidden)]
    #[inline]
    pub fn new(motion: M, output: (M::Vector, M::Rotation), com: M::Vector, columns: C) -> Self {
        Self { motion, output, com, columns, written: PhantomData }
    }

    /// Returns the input of the body, the origin of its frame.
    #[inline]
    pub fn input(&self) -> PointKinematics<M, N, C> {
        PointKinematics::new(self.motion, M::input(), self.columns)
    }

    /// Returns the output of the body, with the frame there.
    ///
    /// It exists only if the description of the body has an `output`.
    #[inline]
    pub fn output(&self) -> PointKinematics<M, N, C>
    where
        W: HasOutput,
    {
        PointKinematics::new(self.motion, self.output, self.columns)
    }

    /// Returns the centre of mass, with axes along those of the body.
    ///
    /// In a line chain it exists only if the description of the body has a `com`.
    #[doc(alias("centre of mass", "center of mass", "CoM", "xipos", "mj_jacBodyCom"))]
    #[inline]
    pub fn com(&self) -> PointKinematics<M, N, C>
    where
        W: HasCom,
    {
        self.at(self.com)
    }

    /// Returns the point at `place`, in m from the input in the body frame, with axes along those of the body.
    #[doc(alias("mj_jac", "mj_local2Global", "getFrameJacobian", "CalcPointsVelocities"))]
    #[doc(alias("CalcPointsPositions"))]
    #[inline]
    pub fn at(&self, place: M::Vector) -> PointKinematics<M, N, C> {
        let (_, rotation) = M::input();
        PointKinematics::new(self.motion, (place, rotation), self.columns)
    }

    /// Returns the point at `place` with a rotated frame.
    #[doc(hidden)]
    #[inline]
    pub fn frame(&self, frame: (M::Vector, M::Rotation)) -> PointKinematics<M, N, C> {
        PointKinematics::new(self.motion, frame, self.columns)
    }
}
