//! Numbers with their first two derivatives with respect to time.

use super::Real;
use std::ops::{Add, Mul, Neg, Sub};

/// A number that depends on time: its value and its first two derivatives.
#[derive(Clone, Copy, Debug)]
pub(super) struct Jet {
    pub(super) value: Real,
    pub(super) rate: Real,
    pub(super) second: Real,
    /// Whether both derivatives are zero, which saves most of a product.
    is_constant: bool,
}

impl Jet {
    pub(super) fn new(value: Real, rate: Real, second: Real) -> Jet {
        let is_constant = rate.high == 0.0 && second.high == 0.0;
        Jet { value, rate, second, is_constant }
    }

    pub(super) fn constant(value: Real) -> Jet {
        Jet { value, rate: Real::new(0.0), second: Real::new(0.0), is_constant: true }
    }

    /// Returns the sine and the cosine.
    pub(super) fn sin_cos(self) -> (Jet, Jet) {
        let (sine, cosine) = self.value.sin_cos();
        let square = self.rate * self.rate;
        (
            Jet::new(sine, cosine * self.rate, cosine * self.second - sine * square),
            Jet::new(cosine, -(sine * self.rate), -(sine * self.second) - cosine * square),
        )
    }
}

impl Add for Jet {
    type Output = Jet;
    fn add(self, other: Jet) -> Jet {
        if self.is_constant && other.is_constant {
            return Jet::constant(self.value + other.value);
        }
        let (rate, second) = (self.rate + other.rate, self.second + other.second);
        Jet::new(self.value + other.value, rate, second)
    }
}

impl Neg for Jet {
    type Output = Jet;
    fn neg(self) -> Jet {
        Jet { value: -self.value, rate: -self.rate, second: -self.second, ..self }
    }
}

impl Sub for Jet {
    type Output = Jet;
    fn sub(self, other: Jet) -> Jet {
        self + -other
    }
}

impl Mul for Jet {
    type Output = Jet;
    fn mul(self, other: Jet) -> Jet {
        let (a, b) = (self, other);
        let value = a.value * b.value;
        match (a.is_constant, b.is_constant) {
            (true, true) => Jet::constant(value),
            (true, false) => Jet::new(value, a.value * b.rate, a.value * b.second),
            (false, true) => Jet::new(value, a.rate * b.value, a.second * b.value),
            (false, false) => {
                let both = a.rate * b.rate;
                let second = a.second * b.value + a.value * b.second + both + both;
                Jet::new(value, a.rate * b.value + a.value * b.rate, second)
            }
        }
    }
}
