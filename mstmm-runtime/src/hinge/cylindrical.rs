//! The cylindrical hinge: a translation along an axis fixed in both elements, and a rotation about it.

/// Position, angle and their rates of a cylindrical hinge, read from a state.
#[doc(alias("cylindrical joint"))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CylindricalState<T> {
    position: T,
    angle: T,
    velocity: T,
    rate: T,
}

impl<T: Copy> CylindricalState<T> {
    /// Makes the view from its values.
    #[inline]
    pub fn new(position: T, angle: T, velocity: T, rate: T) -> Self {
        Self { position, angle, velocity, rate }
    }

    /// Returns the position in m of the outboard origin along the axis, from the inboard
    /// origin.
    #[inline]
    pub fn position(&self) -> T {
        self.position
    }

    /// Returns the angle in rad from the inboard to the outboard frame, right-handed about the axis.
    ///
    /// It is not wrapped.
    #[inline]
    pub fn angle(&self) -> T {
        self.angle
    }

    /// Returns the rate of the position in m/s.
    #[inline]
    pub fn velocity(&self) -> T {
        self.velocity
    }

    /// Returns the rate of the angle in rad/s.
    #[inline]
    pub fn rate(&self) -> T {
        self.rate
    }

    /// Returns the arguments of [`new`](Self::new).
    #[doc(hidden)]
    #[inline]
    pub fn into_groups(self) -> (T, T, T, T) {
        (self.position, self.angle, self.velocity, self.rate)
    }
}

/// Position, angle and their rates of a cylindrical hinge, for writing to a state.
#[derive(Debug)]
pub struct CylindricalStateMut<'a, T> {
    position: &'a mut T,
    angle: &'a mut T,
    velocity: &'a mut T,
    rate: &'a mut T,
}

impl<'a, T> CylindricalStateMut<'a, T> {
    /// Makes the view from references into a state; for generated code.
    #[inline]
    pub fn new(
        position: &'a mut T,
        angle: &'a mut T,
        velocity: &'a mut T,
        rate: &'a mut T,
    ) -> Self {
        Self { position, angle, velocity, rate }
    }

    /// Sets the position in m of the outboard origin along the axis, from the inboard
    /// origin.
    #[inline]
    pub fn set_position(&mut self, position: T) -> &mut Self {
        *self.position = position;
        self
    }

    /// Sets the angle in rad.
    #[inline]
    pub fn set_angle(&mut self, angle: T) -> &mut Self {
        *self.angle = angle;
        self
    }

    /// Sets the rate of the position in m/s.
    #[inline]
    pub fn set_velocity(&mut self, velocity: T) -> &mut Self {
        *self.velocity = velocity;
        self
    }

    /// Sets the rate of the angle in rad/s.
    #[inline]
    pub fn set_rate(&mut self, rate: T) -> &mut Self {
        *self.rate = rate;
        self
    }
}
