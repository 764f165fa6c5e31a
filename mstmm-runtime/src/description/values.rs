//! The values of inputs as a slice.

use core::slice;

use crate::origin::is_not_finite;
use crate::{
    BallState, CylindricalState, ElasticState, FloatingState, GimbalState, HingeMotion, PinState,
    PlanarState, PlaneElasticState, Scalar, ScrewState, SliderState, UniversalState,
};

/// Copies the scalars of inputs from or to a slice, in the order of the calls.
#[derive(Debug)]
pub enum Values<'a, T> {
    /// To the inputs.
    From(slice::Iter<'a, T>),
    /// From the inputs.
    To(slice::IterMut<'a, T>),
    /// To nowhere: finds the first value that is not finite.
    Find(&'a mut Search),
}

/// The search for a value that is not finite.
#[derive(Debug, Default)]
pub struct Search {
    /// The number of values read.
    read: usize,
    /// The index of the first value that is not finite.
    pub(super) found: Option<usize>,
}

impl<T: Scalar> Values<'_, T> {
    /// Copies all scalars of an input.
    pub fn once(&mut self, input: &mut impl Scalars<T>) {
        input.each(&mut |scalar| self.copy(scalar));
    }

    /// Copies all scalars of an input in one repetition.
    pub fn at(&mut self, inputs: &mut [impl Scalars<T>], repetition: usize) {
        if let Some(input) = inputs.get_mut(repetition) {
            self.once(input);
        }
    }

    fn copy(&mut self, scalar: &mut T) {
        match self {
            Values::From(values) => {
                if let Some(value) = values.next() {
                    *scalar = *value;
                }
            }
            Values::To(places) => {
                if let Some(place) = places.next() {
                    *place = *scalar;
                }
            }
            Values::Find(search) => {
                if search.found.is_none() && is_not_finite(scalar) {
                    search.found = Some(search.read);
                }
                search.read += 1;
            }
        }
    }
}

/// The scalars of an input.
pub trait Scalars<T> {
    /// Calls a function for each scalar, in the order of coordinates, rates and accelerations.
    fn each(&mut self, change: &mut impl FnMut(&mut T));
}

impl<T: Scalar> Scalars<T> for T {
    fn each(&mut self, change: &mut impl FnMut(&mut T)) {
        change(self);
    }
}

impl<T: Scalar, const N: usize> Scalars<T> for [T; N] {
    fn each(&mut self, change: &mut impl FnMut(&mut T)) {
        self.iter_mut().for_each(change);
    }
}

impl<T: Scalar, const N: usize> Scalars<T> for nalgebra::SVector<T, N> {
    fn each(&mut self, change: &mut impl FnMut(&mut T)) {
        self.as_mut_slice().iter_mut().for_each(change);
    }
}

impl<T: Scalar, S: Scalars<T>, A: Scalars<T>> Scalars<T> for HingeMotion<S, A> {
    fn each(&mut self, change: &mut impl FnMut(&mut T)) {
        self.state.each(change);
        self.acceleration.each(change);
    }
}

/// Implements the trait for views, each with its groups.
macro_rules! views {
    ($($view:ident($($group:ident),*);)*) => { $(
        impl<T: Scalar> Scalars<T> for $view<T> {
            fn each(&mut self, change: &mut impl FnMut(&mut T)) {
                let ($(mut $group,)*) = self.into_groups();
                $($group.each(change);)*
                *self = Self::new($($group),*);
            }
        }
    )* };
}

views! {
    BallState(orientation, rate);
    CylindricalState(position, angle, velocity, rate);
    ElasticState(displacement, angles, velocity, rate);
    FloatingState(position, orientation, velocity, rate);
    GimbalState(angles, rates);
    PinState(angle, rate);
    PlanarState(position, angle, velocity, rate);
    PlaneElasticState(displacement, angle, velocity, rate);
    ScrewState(angle, rate);
    SliderState(position, velocity);
    UniversalState(angles, rates);
}
