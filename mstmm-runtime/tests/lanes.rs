//! The traits leave room for numbers that have no order: two lanes of `f64` go through all
//! integrators and the paper's matrices.

mod common;

use core::ops::{Add, AddAssign, BitAnd, BitOr, Mul, MulAssign, Neg, Not, Sub, SubAssign};

use common::{Pendulum, State};
use mstmm_runtime::nalgebra::Vector2;
use mstmm_runtime::paper::chain::{self, InputEnd, OutputEnd};
use mstmm_runtime::paper::plane;
use mstmm_runtime::{
    Chain, ChainState, Dopri5, LinearlyImplicitEuler, Mask, Newmark, Rk4, Scalar, SemiImplicitEuler,
};

#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Pair(f64, f64);

#[derive(Clone, Copy, Debug)]
struct PairMask(bool, bool);

macro_rules! lanewise {
    ($type:ident: $($trait:ident $method:ident),*) => {
        $(impl $trait for $type {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                $type(self.0.$method(other.0), self.1.$method(other.1))
            }
        })*
    };
}

lanewise!(Pair: Add add, Sub sub, Mul mul);
lanewise!(PairMask: BitAnd bitand, BitOr bitor);

macro_rules! lanewise_assign {
    ($($trait:ident $method:ident),*) => {
        $(impl $trait for Pair {
            fn $method(&mut self, other: Self) {
                self.0.$method(other.0);
                self.1.$method(other.1);
            }
        })*
    };
}

lanewise_assign!(AddAssign add_assign, SubAssign sub_assign, MulAssign mul_assign);

impl Neg for Pair {
    type Output = Self;
    fn neg(self) -> Self {
        Pair(-self.0, -self.1)
    }
}

impl Not for PairMask {
    type Output = Self;
    fn not(self) -> Self {
        PairMask(!self.0, !self.1)
    }
}

impl Mask for PairMask {
    fn splat(value: bool) -> Self {
        PairMask(value, value)
    }

    fn all(self) -> bool {
        self.0 && self.1
    }
}

impl Scalar for Pair {
    type Mask = PairMask;
    type Real = f64;
    type Columns = Self;
    type Pack = Self;
    const LANES: usize = 2;

    fn constant(value: f64) -> Self {
        Pair(value, value)
    }

    fn epsilon() -> Self {
        Pair(f64::EPSILON, f64::EPSILON)
    }

    // Lane by lane, since numbers may be fused.
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        let lane = |a: f64, b: f64, c: f64| Scalar::mul_add(a, b, c);
        Pair(lane(self.0, factor.0, addend.0), lane(self.1, factor.1, addend.1))
    }

    fn mul_sub(self, factor: Self, subtrahend: Self) -> Self {
        Scalar::mul_add(self, factor, -subtrahend)
    }

    fn mul_neg_add(self, factor: Self, addend: Self) -> Self {
        Scalar::mul_add(-self, factor, addend)
    }

    fn recip(self) -> Self {
        Pair(self.0.recip(), self.1.recip())
    }

    fn sqrt(self) -> Self {
        Pair(self.0.sqrt(), self.1.sqrt())
    }

    fn copysign(self, sign: Self) -> Self {
        Pair(self.0.copysign(sign.0), self.1.copysign(sign.1))
    }

    fn abs(self) -> Self {
        Pair(self.0.abs(), self.1.abs())
    }

    fn sin_cos<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let (first_sine, first_cosine) = <f64 as Scalar>::sin_cos(angles.map(|x| x.0));
        let (second_sine, second_cosine) = <f64 as Scalar>::sin_cos(angles.map(|x| x.1));
        let sines = core::array::from_fn(|i| Pair(first_sine[i], second_sine[i]));
        (sines, core::array::from_fn(|i| Pair(first_cosine[i], second_cosine[i])))
    }

    fn atan2(self, x: Self) -> Self {
        Pair(Scalar::atan2(self.0, x.0), Scalar::atan2(self.1, x.1))
    }

    fn simd_gt(self, other: Self) -> PairMask {
        PairMask(self.0 > other.0, self.1 > other.1)
    }

    fn is_finite(self) -> PairMask {
        PairMask(self.0.is_finite(), self.1.is_finite())
    }

    fn select(mask: PairMask, yes: Self, no: Self) -> Self {
        Pair(if mask.0 { yes.0 } else { no.0 }, if mask.1 { yes.1 } else { no.1 })
    }

    fn max_lane(self) -> f64 {
        // `max` would drop a NaN.
        if self.0 >= self.1 || self.0.is_nan() { self.0 } else { self.1 }
    }

    fn splat(value: f64) -> Self {
        Pair(value, value)
    }
}

fn lane<const Q: usize, const V: usize>(
    state: &State<Pair, Q, V>,
    which: fn(Pair) -> f64,
) -> State<f64, Q, V> {
    State { q: state.q.map(which), v: state.v.map(which), t: which(state.t) }
}

fn two_pendulums() -> State<Pair, 1, 1> {
    State { q: [Pair(0.1, 2.9)], v: [Pair(0.0, 3.0)], t: Pair(0.0, 0.0) }
}

/// Steps one by one, and then a longer way to an end time.
macro_rules! lanes_give_the_bits_of_single_runs {
    ($($test:ident: $method:ident;)*) => {
        $(#[test]
        fn $test() {
            let (chain, mut both) = (Pendulum::<Pair>::new(), two_pendulums());
            let mut method = $method::new(Pair::constant(0.01));
            for _ in 0..200 {
                method.step(&chain, &mut both, |_, _| Pair::default()).unwrap();
            }
            method.advance_to(&chain, &mut both, 2.555, |_, _| Pair::default()).unwrap();
            for (which, mut single) in [
                ((|x| x.0) as fn(Pair) -> f64, Pendulum::at(0.1, 0.0)),
                ((|x| x.1) as fn(Pair) -> f64, Pendulum::at(2.9, 3.0)),
            ] {
                let mut method = $method::new(0.01);
                for _ in 0..200 {
                    method.step(&Pendulum::new(), &mut single, |_, _| 0.0).unwrap();
                }
                method.advance_to(&Pendulum::new(), &mut single, 2.555, |_, _| 0.0).unwrap();
                assert_eq!(lane(&both, which), single);
            }
        })*
    };
}

lanes_give_the_bits_of_single_runs! {
    rk4_in_lanes: Rk4;
    newmark_in_lanes: Newmark;
    semi_implicit_euler_in_lanes: SemiImplicitEuler;
    linearly_implicit_euler_in_lanes: LinearlyImplicitEuler;
}

#[test]
fn angles_in_lanes() {
    let angle = Scalar::atan2(Pair(1.0, -2.0), Pair(3.0, -4.0));
    assert_eq!(angle, Pair(<f64 as Scalar>::atan2(1.0, 3.0), <f64 as Scalar>::atan2(-2.0, -4.0)));
}

#[test]
fn the_worst_lane_decides_the_step() {
    let (chain, mut both) = (Pendulum::<Pair>::new(), two_pendulums());
    let mut integrator = Dopri5::new(1e-9, 1e-9);
    integrator.advance_to(&chain, &mut both, 5.0, |_, _| Pair::default()).unwrap();
    assert_eq!(both.time(), Pair(5.0, 5.0));

    let steps = |start: State<f64, 1, 1>| {
        let (mut state, mut integrator) = (start, Dopri5::new(1e-9, 1e-9));
        integrator.advance_to(&Pendulum::new(), &mut state, 5.0, |_, _| 0.0).unwrap();
        (integrator.statistics().accepted, state)
    };
    let ((_, easy), (hard_steps, hard)) =
        (steps(Pendulum::at(0.1, 0.0)), steps(Pendulum::at(2.9, 3.0)));
    let taken = integrator.statistics().accepted;
    assert!(taken.abs_diff(hard_steps) <= hard_steps / 10, "{taken} {hard_steps}");
    assert!((both.q[0].0 - easy.q[0]).abs() < 1e-7 && (both.q[0].1 - hard.q[0]).abs() < 1e-7);
}

#[test]
fn one_lane_that_is_not_finite_stops_both() {
    let (chain, mut both) = (Pendulum::<Pair>::new(), two_pendulums());
    let mut rate = <Pendulum<Pair> as Chain>::State::default();
    both.v[0].1 = f64::NAN;
    assert!(chain.derivative_into(&both, &Pair::default(), &mut rate).is_err());
    assert!(Rk4::new(Pair::constant(0.1)).step(&chain, &mut both, |_, _| Pair::default()).is_err());
}

/// z at the free end of two rods on pins at the given angles, by the paper's matrices.
fn end_of_two_rods<T: Scalar>(angles: [T; 2]) -> [T; 7] {
    let number = T::constant;
    let rod = plane::Body {
        mass: number(1.0),
        com: Vector2::new(number(0.5), number(0.0)),
        output: Vector2::new(number(1.0), number(0.0)),
        inertia: number(1.0 / 3.0),
    };
    let [upper, lower] = angles.map(|angle| {
        rod.transfer_matrix(&plane::Acting {
            angle,
            angular_velocity: number(1.5),
            force: Vector2::new(number(0.0), number(-9.8)),
            moment: number(0.1),
        })
    });
    let elements = [plane::pin(&upper), upper, plane::pin(&lower), lower];
    let (input, output) = (InputEnd::entries([4, 5]), OutputEnd::entries([3, 4, 5]));
    chain::solve(&elements, &input, &output).outputs[3].into()
}

#[test]
fn the_papers_matrices_take_lanes() {
    let both = end_of_two_rods([Pair(0.3, -1.2), Pair(0.8, 2.0)]);
    let (one, other) = (end_of_two_rods([0.3, 0.8]), end_of_two_rods([-1.2, 2.0]));
    assert_eq!(both.map(|pair| pair.0), one);
    assert_eq!(both.map(|pair| pair.1), other);
}
