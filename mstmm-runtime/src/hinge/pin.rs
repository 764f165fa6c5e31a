//! The pin (revolute) hinge: a rotation about an axis fixed in both elements.

/// Angle and rate of a pin hinge, read from a state.
#[doc(alias("revolute", "hinge joint", "JointModelRX", "RevoluteJoint"))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PinState<T> {
    angle: T,
    rate: T,
}

impl<T: Copy> PinState<T> {
    /// Makes the view from its values.
    #[inline]
    pub fn new(angle: T, rate: T) -> Self {
        Self { angle, rate }
    }

    /// Returns the angle in rad from the inboard to the outboard frame, right-handed about the axis.
    ///
    /// It is not wrapped.
    #[doc(alias("jointpos", "get_angle"))]
    #[inline]
    pub fn angle(&self) -> T {
        self.angle
    }

    /// Returns the rate of the angle in rad/s.
    #[doc(alias("jointvel", "get_angular_rate"))]
    #[inline]
    pub fn rate(&self) -> T {
        self.rate
    }

    /// Returns the arguments of [`new`](Self::new).
    #[doc(hidden)]
    #[inline]
    pub fn into_groups(self) -> (T, T) {
        (self.angle, self.rate)
    }
}

/// Angle and rate of a pin hinge, for writing to a state.
#[derive(Debug)]
pub struct PinStateMut<'a, T> {
    angle: &'a mut T,
    rate: &'a mut T,
}

impl<'a, T> PinStateMut<'a, T> {
    /// Makes the view from references into a state; for generated code.
    #[inline]
    pub fn new(angle: &'a mut T, rate: &'a mut T) -> Self {
        Self { angle, rate }
    }

    /// Sets the angle in rad.
    #[inline]
    pub fn set_angle(&mut self, angle: T) -> &mut Self {
        *self.angle = angle;
        self
    }

    /// Sets the rate of the angle in rad/s.
    #[inline]
    pub fn set_rate(&mut self, rate: T) -> &mut Self {
        *self.rate = rate;
        self
    }
}
