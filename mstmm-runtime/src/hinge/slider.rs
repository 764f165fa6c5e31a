//! The slider hinge: one shift along an axis fixed in both elements.

/// Position and velocity of a slider hinge, copied from a state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SliderState<T> {
    position: T,
    velocity: T,
}

impl<T: Copy> SliderState<T> {
    /// Puts the view together.
    #[inline]
    pub fn new(position: T, velocity: T) -> Self {
        Self { position, velocity }
    }

    /// The position in m of the outboard frame's origin along the axis, from the inboard frame's
    /// origin.
    #[inline]
    pub fn position(&self) -> T {
        self.position
    }

    /// The position's rate in m/s.
    #[inline]
    pub fn velocity(&self) -> T {
        self.velocity
    }

    /// What [`new`](Self::new) was given.
    #[doc(hidden)]
    #[inline]
    pub fn into_groups(self) -> (T, T) {
        (self.position, self.velocity)
    }
}

/// Position and velocity of a slider hinge, to be changed in a state.
#[derive(Debug)]
pub struct SliderStateMut<'a, T> {
    position: &'a mut T,
    velocity: &'a mut T,
}

impl<'a, T> SliderStateMut<'a, T> {
    /// Puts the view together; generated code does.
    #[inline]
    pub fn new(position: &'a mut T, velocity: &'a mut T) -> Self {
        Self { position, velocity }
    }

    /// Sets the position in m of the outboard frame's origin along the axis, from the inboard
    /// frame's origin.
    #[inline]
    pub fn set_position(&mut self, position: T) -> &mut Self {
        *self.position = position;
        self
    }

    /// Sets the position's rate in m/s.
    #[inline]
    pub fn set_velocity(&mut self, velocity: T) -> &mut Self {
        *self.velocity = velocity;
        self
    }
}
