//! The slider (prismatic) hinge: a translation along an axis fixed in both elements.

/// Position and velocity of a slider hinge, read from a state.
#[doc(alias("prismatic", "slide joint", "PrismaticJoint"))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SliderState<T> {
    position: T,
    velocity: T,
}

impl<T: Copy> SliderState<T> {
    /// Makes the view from its values.
    #[inline]
    pub fn new(position: T, velocity: T) -> Self {
        Self { position, velocity }
    }

    /// Returns the position in m of the outboard origin along the axis, from the inboard
    /// origin.
    #[inline]
    pub fn position(&self) -> T {
        self.position
    }

    /// Returns the rate of the position in m/s.
    #[inline]
    pub fn velocity(&self) -> T {
        self.velocity
    }

    /// Returns the arguments of [`new`](Self::new).
    #[doc(hidden)]
    #[inline]
    pub fn into_groups(self) -> (T, T) {
        (self.position, self.velocity)
    }
}

/// Position and velocity of a slider hinge, for writing to a state.
#[derive(Debug)]
pub struct SliderStateMut<'a, T> {
    position: &'a mut T,
    velocity: &'a mut T,
}

impl<'a, T> SliderStateMut<'a, T> {
    /// Makes the view from references into a state; for generated code.
    #[inline]
    pub fn new(position: &'a mut T, velocity: &'a mut T) -> Self {
        Self { position, velocity }
    }

    /// Sets the position in m of the outboard origin along the axis, from the inboard
    /// origin.
    #[inline]
    pub fn set_position(&mut self, position: T) -> &mut Self {
        *self.position = position;
        self
    }

    /// Sets the rate of the position in m/s.
    #[inline]
    pub fn set_velocity(&mut self, velocity: T) -> &mut Self {
        *self.velocity = velocity;
        self
    }
}
