//! The screw hinge: a turn about an axis fixed in both elements, and with it a shift along that
//! axis.

/// Angle and rate of a screw hinge, copied from a state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ScrewState<T> {
    angle: T,
    rate: T,
}

impl<T: Copy> ScrewState<T> {
    /// Puts the view together.
    #[inline]
    pub fn new(angle: T, rate: T) -> Self {
        Self { angle, rate }
    }

    /// The angle in rad by which the outboard frame is turned against the inboard one, right-handed
    /// about the axis. It is not wrapped: times the pitch it is the shift along the axis.
    #[inline]
    pub fn angle(&self) -> T {
        self.angle
    }

    /// The angle's rate in rad/s.
    #[inline]
    pub fn rate(&self) -> T {
        self.rate
    }

    /// What [`new`](Self::new) was given.
    #[doc(hidden)]
    #[inline]
    pub fn into_groups(self) -> (T, T) {
        (self.angle, self.rate)
    }
}

/// Angle and rate of a screw hinge, to be changed in a state.
#[derive(Debug)]
pub struct ScrewStateMut<'a, T> {
    angle: &'a mut T,
    rate: &'a mut T,
}

impl<'a, T> ScrewStateMut<'a, T> {
    /// Puts the view together; generated code does.
    #[inline]
    pub fn new(angle: &'a mut T, rate: &'a mut T) -> Self {
        Self { angle, rate }
    }

    /// Sets the angle in rad; times the pitch it is the shift along the axis.
    #[inline]
    pub fn set_angle(&mut self, angle: T) -> &mut Self {
        *self.angle = angle;
        self
    }

    /// Sets the angle's rate in rad/s.
    #[inline]
    pub fn set_rate(&mut self, rate: T) -> &mut Self {
        *self.rate = rate;
        self
    }
}
