//! The cylindrical hinge: a shift along an axis fixed in both elements, and a turn about it.

/// Position, angle and their rates of a cylindrical hinge, copied from a state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CylindricalState<T> {
    position: T,
    angle: T,
    velocity: T,
    rate: T,
}

impl<T: Copy> CylindricalState<T> {
    /// Puts the view together.
    #[inline]
    pub fn new(position: T, angle: T, velocity: T, rate: T) -> Self {
        Self { position, angle, velocity, rate }
    }

    /// The position in m of the outboard frame's origin along the axis, from the inboard frame's
    /// origin.
    #[inline]
    pub fn position(&self) -> T {
        self.position
    }

    /// The angle in rad by which the outboard frame is turned against the inboard one, right-handed
    /// about the axis. It is not wrapped.
    #[inline]
    pub fn angle(&self) -> T {
        self.angle
    }

    /// The position's rate in m/s.
    #[inline]
    pub fn velocity(&self) -> T {
        self.velocity
    }

    /// The angle's rate in rad/s.
    #[inline]
    pub fn rate(&self) -> T {
        self.rate
    }

    /// What [`new`](Self::new) was given.
    #[doc(hidden)]
    #[inline]
    pub fn into_groups(self) -> (T, T, T, T) {
        (self.position, self.angle, self.velocity, self.rate)
    }
}

/// Position, angle and their rates of a cylindrical hinge, to be changed in a state.
#[derive(Debug)]
pub struct CylindricalStateMut<'a, T> {
    position: &'a mut T,
    angle: &'a mut T,
    velocity: &'a mut T,
    rate: &'a mut T,
}

impl<'a, T> CylindricalStateMut<'a, T> {
    /// Puts the view together; generated code does.
    #[inline]
    pub fn new(
        position: &'a mut T,
        angle: &'a mut T,
        velocity: &'a mut T,
        rate: &'a mut T,
    ) -> Self {
        Self { position, angle, velocity, rate }
    }

    /// Sets the position in m of the outboard frame's origin along the axis, from the inboard
    /// frame's origin.
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

    /// Sets the position's rate in m/s.
    #[inline]
    pub fn set_velocity(&mut self, velocity: T) -> &mut Self {
        *self.velocity = velocity;
        self
    }

    /// Sets the angle's rate in rad/s.
    #[inline]
    pub fn set_rate(&mut self, rate: T) -> &mut Self {
        *self.rate = rate;
        self
    }
}
