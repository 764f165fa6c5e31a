//! The screw hinge: a rotation about an axis fixed in both elements, coupled with a translation along the axis.

/// Angle and rate of a screw hinge, read from a state.
#[doc(alias("helical", "ScrewJoint"))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ScrewState<T> {
    angle: T,
    rate: T,
}

impl<T: Copy> ScrewState<T> {
    /// Makes the view from its values.
    #[inline]
    pub fn new(angle: T, rate: T) -> Self {
        Self { angle, rate }
    }

    /// Returns the angle in rad from the inboard to the outboard frame, right-handed about the axis.
    ///
    /// It is not wrapped. The translation along the axis is the angle times the pitch.
    #[inline]
    pub fn angle(&self) -> T {
        self.angle
    }

    /// Returns the rate of the angle in rad/s.
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

/// Angle and rate of a screw hinge, for writing to a state.
#[derive(Debug)]
pub struct ScrewStateMut<'a, T> {
    angle: &'a mut T,
    rate: &'a mut T,
}

impl<'a, T> ScrewStateMut<'a, T> {
    /// Makes the view from references into a state; for generated code.
    #[inline]
    pub fn new(angle: &'a mut T, rate: &'a mut T) -> Self {
        Self { angle, rate }
    }

    /// Sets the angle in rad. The translation along the axis is the angle times the pitch.
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
