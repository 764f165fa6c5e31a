//! Results at springs.

/// The state of one spring with its damper and its actuator: length, tension and force.
///
/// `V` is a vector with the components of the chain's dimension, in a line chain a scalar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpringResult<T, V> {
    length: T,
    length_rate: T,
    tension: T,
    force: V,
}

impl<T: Copy, V: Copy> SpringResult<T, V> {
    /// Makes the result; for generated code.
    #[inline]
    pub fn new(length: T, length_rate: T, tension: T, force: V) -> Self {
        Self { length, length_rate, tension, force }
    }

    /// Returns the length in m: the distance of the ends, at least 10⁻¹⁵ m.
    #[doc(alias("ten_length", "tendonpos"))]
    #[inline]
    pub fn length(&self) -> T {
        self.length
    }

    /// Returns the rate of the length in m/s, positive if the ends move apart.
    ///
    /// It is zero if the length is zero.
    #[doc(alias("ten_velocity", "tendonvel"))]
    #[inline]
    pub fn length_rate(&self) -> T {
        self.length_rate
    }

    /// Returns the tension k (l − l₀) + c l̇ − f in N, positive if the spring pulls its ends together.
    ///
    /// f is the `force` of the actuator, which pushes the ends apart.
    #[inline]
    pub fn tension(&self) -> T {
        self.tension
    }

    /// Returns the force in N on the body of the end `on`, inertial frame.
    ///
    /// Its opposite acts on the body of the end `to` or on the ground. The force is zero if the length is zero.
    #[inline]
    pub fn force(&self) -> V {
        self.force
    }
}
