//! Where sweeps cross into repeated parts and out of them.
//!
//! On plain numbers nothing happens there: such a chain is written out. The compiler runs a repeated
//! part once, for all times: what a sweep carries into it is replaced by unknowns that stand for
//! what any time hands to the next one, and what it carries out by unknowns for what the last leaves.

use crate::math::Scalar;
use crate::model::{Layout, LinkId, RepeatId, Seam};
use std::fmt::Debug;

/// Replaces what sweeps carry over seams.
pub trait Weave<S>: Debug {
    /// What any time begins with, for what the first one does.
    fn enter(&self, repeat: RepeatId, inwards: bool, first: &[S]) -> Vec<S>;
    /// What the last time ends with, for what any one does.
    fn leave(&self, repeat: RepeatId, any: &[S]) -> Vec<S>;
}

/// The seams of a chain, and what happens there.
#[derive(Clone, Copy, Debug)]
pub struct Passage<'a, S> {
    layout: &'a Layout,
    weave: Option<&'a dyn Weave<S>>,
}

impl<'a, S: Scalar> Passage<'a, S> {
    /// Nothing happens at the seams of `layout`.
    pub fn plain(layout: &'a Layout) -> Self {
        Passage { layout, weave: None }
    }

    /// `weave` sees what is carried over the seams of `layout`.
    pub fn woven(layout: &'a Layout, weave: &'a dyn Weave<S>) -> Self {
        Passage { layout, weave: Some(weave) }
    }

    /// Whether a link's hinge is where a repeated part begins or ends.
    pub fn is_seam(&self, link: usize) -> bool {
        self.layout.links[LinkId(link)].seam.is_some()
    }

    /// Whether a link's hinge belongs to a repeated part that is run once for all times.
    pub fn is_repeated(&self, link: usize) -> bool {
        self.weave.is_some() && self.layout.links[LinkId(link)].repeated
    }

    /// What an outward sweep goes on with behind a link.
    pub fn outwards<B: Bundle<S>>(&self, link: usize, carried: B) -> B {
        self.cross(link, false, carried)
    }

    /// What an inward sweep goes on with at a link.
    pub fn inwards<B: Bundle<S>>(&self, link: usize, carried: B) -> B {
        self.cross(link, true, carried)
    }

    fn cross<B: Bundle<S>>(&self, link: usize, inwards: bool, carried: B) -> B {
        let (Some(Seam { repeat, at_end }), Some(weave)) =
            (self.layout.links[LinkId(link)].seam, self.weave)
        else {
            return carried;
        };
        let mut numbers = Vec::new();
        carried.clone().visit(&mut |number| {
            numbers.push(number);
            number
        });
        let replaced = if at_end == inwards {
            weave.enter(repeat, inwards, &numbers)
        } else {
            weave.leave(repeat, &numbers)
        };
        let mut replaced = replaced.into_iter();
        carried.visit(&mut |number| replaced.next().unwrap_or(number))
    }
}

/// Numbers that a sweep carries together.
pub trait Bundle<S>: Clone {
    /// The same with every number replaced, always in the same order.
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self;
}

impl<S: Scalar> Bundle<S> for S {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        replace(self)
    }
}

impl<S, B: Bundle<S>> Bundle<S> for Vec<B> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        self.into_iter().map(|part| part.visit(replace)).collect()
    }
}

impl<S, A: Bundle<S>, B: Bundle<S>> Bundle<S> for (A, B) {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        (self.0.visit(replace), self.1.visit(replace))
    }
}

mod math {
    use super::{Bundle, Scalar};
    use crate::math::{Mat3, Motion, SpatialInertia, Sym3, Vec3, Wrench};

    impl<S: Scalar> Bundle<S> for Vec3<S> {
        fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
            Vec3(self.0.map(replace))
        }
    }

    impl<S: Scalar> Bundle<S> for Mat3<S> {
        fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
            Mat3(self.0.map(|row| row.map(&mut *replace)))
        }
    }

    impl<S: Scalar> Bundle<S> for Sym3<S> {
        fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
            Sym3(self.0.map(replace))
        }
    }

    impl<S: Scalar> Bundle<S> for Motion<S> {
        fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
            let linear = self.linear.visit(replace);
            Motion { linear, angular: self.angular.visit(replace) }
        }
    }

    impl<S: Scalar> Bundle<S> for Wrench<S> {
        fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
            let force = self.force.visit(replace);
            Wrench { force, moment: self.moment.visit(replace) }
        }
    }

    impl<S: Scalar> Bundle<S> for SpatialInertia<S> {
        fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
            let linear = self.linear.visit(replace);
            let coupling = self.coupling.visit(replace);
            SpatialInertia { linear, coupling, angular: self.angular.visit(replace) }
        }
    }
}
