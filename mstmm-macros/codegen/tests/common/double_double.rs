//! [`DoubleDouble`] as a scalar of the compiler's equations.

#[path = "../../../../tests/support/double_double.rs"]
mod numbers;

pub use numbers::DoubleDouble;

use mstmm_codegen::math::Scalar;

impl Scalar for DoubleDouble {
    fn number(value: f64) -> Self {
        Self::new(value)
    }

    fn recip(self) -> Self {
        DoubleDouble::recip(self)
    }

    fn sqrt(self) -> Self {
        DoubleDouble::sqrt(self)
    }

    fn sin_cos(self) -> (Self, Self) {
        DoubleDouble::sin_cos(self)
    }

    fn copysign(self, sign: Self) -> Self {
        DoubleDouble::copysign(self, sign)
    }

    fn atan2(self, x: Self) -> Self {
        DoubleDouble::atan2(self, x)
    }

    fn recip_above(self, scale: Self) -> Self {
        let vanishes = self.high <= 1e-24 * scale.high;
        if vanishes { Self::new(0.0) } else { self.recip() }
    }

    fn vanishes(self) -> bool {
        false
    }
}
