//! Numbers that carry a derivative: exact rates of change without a step to choose.

use mstmm::{Chain, ChainState, GeneratedChain, Scalar};
use std::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// `value + rate ε` with ε² = 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dual {
    pub value: f64,
    pub rate: f64,
}

impl Dual {
    pub fn new(value: f64, rate: f64) -> Self {
        Self { value, rate }
    }
}

impl Add for Dual {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.rate + other.rate)
    }
}

impl Sub for Dual {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.value - other.value, self.rate - other.rate)
    }
}

impl Mul for Dual {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.value * other.value, self.rate * other.value + self.value * other.rate)
    }
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.value, -self.rate)
    }
}

impl AddAssign for Dual {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Dual {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl MulAssign for Dual {
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl Scalar for Dual {
    type Mask = bool;
    type Real = f64;

    fn constant(value: f64) -> Self {
        Self::new(value, 0.0)
    }
    fn epsilon() -> Self {
        Self::constant(f64::EPSILON)
    }
    fn recip(self) -> Self {
        let inverse = 1.0 / self.value;
        Self::new(inverse, -self.rate * inverse * inverse)
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        Self::new(root, self.rate / (root + root))
    }
    fn copysign(self, sign: Self) -> Self {
        if self.value.is_sign_negative() == sign.value.is_sign_negative() { self } else { -self }
    }
    fn abs(self) -> Self {
        self.copysign(Self::constant(1.0))
    }
    fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        let rate = (x.value * self.rate - self.value * x.rate) / square;
        Self::new(Scalar::atan2(self.value, x.value), rate)
    }
    fn sin_cos<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let (sines, cosines) = <f64 as Scalar>::sin_cos(angles.map(|angle| angle.value));
        let sine = |k: usize| Self::new(sines[k], cosines[k] * angles[k].rate);
        let cosine = |k: usize| Self::new(cosines[k], -(sines[k] * angles[k].rate));
        (std::array::from_fn(sine), std::array::from_fn(cosine))
    }
    fn simd_gt(self, other: Self) -> bool {
        self.value > other.value
    }
    fn is_finite(self) -> bool {
        self.value.is_finite() && self.rate.is_finite()
    }
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
    fn max_lane(self) -> f64 {
        self.value
    }
    fn splat(value: f64) -> Self {
        Self::constant(value)
    }
}

/// The rate of a chain's total energy, exact, with the state moving as the chain says. `C` and `D`
/// are the same chain.
pub fn energy_rate<C, D>(chain: &C, same: &D, state: &C::State, inputs: &C::Inputs) -> f64
where
    C: GeneratedChain<Scalar = f64>,
    D: GeneratedChain<Scalar = Dual>,
{
    same.energy(&moving(chain, same, state, inputs)).total().rate
}

/// The state as it moves.
pub fn moving<C, D>(chain: &C, same: &D, state: &C::State, inputs: &C::Inputs) -> D::State
where
    C: GeneratedChain<Scalar = f64>,
    D: GeneratedChain<Scalar = Dual>,
{
    let mut rate = chain.initial_state();
    Chain::derivative_into(chain, state, inputs, &mut rate).expect("a regular chain");
    let mut moving = same.initial_state();
    let join = |to: &mut [Dual], values: &[f64], rates: &[f64]| {
        for (to, (&value, &rate)) in to.iter_mut().zip(values.iter().zip(rates)) {
            *to = Dual::new(value, rate);
        }
    };
    join(moving.coordinates_mut(), state.coordinates(), rate.coordinates());
    join(moving.rates_mut(), state.rates(), rate.rates());
    moving
}
