//! The sets of values that sweeps carry: scalars, lists, and the types of spatial algebra.

use super::sweep::Flatten;
use crate::math::{Mat3, Motion, Scalar, SpatialInertia, Sym3, Vec3, Wrench};

impl<S: Scalar> Flatten<S> for S {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        replace(self)
    }
}

impl<S, B: Flatten<S>> Flatten<S> for Vec<B> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        self.into_iter().map(|part| part.visit(replace)).collect()
    }
}

impl<S, B: Flatten<S>> Flatten<S> for Option<B> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        self.map(|inner| inner.visit(replace))
    }
}

impl<S, A: Flatten<S>, B: Flatten<S>> Flatten<S> for (A, B) {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        (self.0.visit(replace), self.1.visit(replace))
    }
}

impl<S: Scalar> Flatten<S> for Vec3<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        Vec3(self.0.map(replace))
    }
}

impl<S: Scalar> Flatten<S> for Mat3<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        Mat3(self.0.map(|row| row.map(&mut *replace)))
    }
}

impl<S: Scalar> Flatten<S> for Sym3<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        Sym3(self.0.map(replace))
    }
}

impl<S: Scalar> Flatten<S> for Motion<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let linear = self.linear.visit(replace);
        Motion { linear, angular: self.angular.visit(replace) }
    }
}

impl<S: Scalar> Flatten<S> for Wrench<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let force = self.force.visit(replace);
        Wrench { force, moment: self.moment.visit(replace) }
    }
}

impl<S: Scalar> Flatten<S> for SpatialInertia<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let linear = self.linear.visit(replace);
        let coupling = self.coupling.visit(replace);
        SpatialInertia { linear, coupling, angular: self.angular.visit(replace) }
    }
}
