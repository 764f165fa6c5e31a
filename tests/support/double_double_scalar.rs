//! [`DoubleDouble`] as a scalar of generated code.

#[path = "double_double.rs"]
mod numbers;

pub use numbers::DoubleDouble;

use mstmm::Scalar;

impl Scalar for DoubleDouble {
    type Mask = bool;
    type Real = Self;
    type Columns = Self;
    type Pack = Self;

    fn constant(value: f64) -> Self {
        Self::new(value)
    }

    fn epsilon() -> Self {
        Self::EPSILON
    }

    fn recip(self) -> Self {
        DoubleDouble::recip(self)
    }

    fn sqrt(self) -> Self {
        DoubleDouble::sqrt(self)
    }

    fn copysign(self, sign: Self) -> Self {
        DoubleDouble::copysign(self, sign)
    }

    fn abs(self) -> Self {
        DoubleDouble::copysign(self, Self::new(1.0))
    }

    fn sin_cos<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let both = angles.map(DoubleDouble::sin_cos);
        (both.map(|(sine, _)| sine), both.map(|(_, cosine)| cosine))
    }

    fn atan2(self, x: Self) -> Self {
        DoubleDouble::atan2(self, x)
    }

    fn simd_gt(self, other: Self) -> bool {
        self > other
    }

    fn is_finite(self) -> bool {
        self.is_finite()
    }

    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    fn max_lane(self) -> Self {
        self
    }

    fn splat(value: Self) -> Self {
        value
    }
}

#[test]
fn identities_hold_to_thirty_digits() {
    for angle in [0.1, 1.0, -2.5, 3.1, 1e-9] {
        let number = DoubleDouble::new(angle);
        let (sine, cosine) = number.sin_cos();
        let one = sine * sine + cosine * cosine - DoubleDouble::new(1.0);
        assert!(one.high.abs() < 1e-29, "{one:?}");
        assert!((sine.high - angle.sin()).abs() <= 1.2e-16 * angle.abs().max(1.0));
        let back = sine.atan2(cosine) - number;
        assert!(back.high.abs() < 1e-29, "{back:?}");
        let square = DoubleDouble::new(angle.abs() + 0.3);
        let root = square.sqrt();
        assert!((root * root - square).high.abs() < 1e-30);
        assert!((root * root.recip() - DoubleDouble::new(1.0)).high.abs() < 1e-30);
        assert!(number > number - DoubleDouble::EPSILON);
    }
}
