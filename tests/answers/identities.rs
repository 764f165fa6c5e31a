//! Identities between the answers, in both precisions.

use super::asked::{Asked, Direction};
use super::chains::{Arm, Branched, Raft, Slides, Train};
use crate::numbers::Lanes;
use crate::sample::{Case, each};
use mstmm::{ChainState, Scalar};
use mstmm_reference::Random;

/// Random cases of each chain.
const SEEDS: u64 = 40;

/// Efforts are sums of at most some hundred terms: the tolerance in units in the last place of the largest.
const SUMS: f64 = 300.0;

/// A solution loses as many digits as the condition number of the mass matrix has: at most about four.
const SOLVED: f64 = 1e5;

/// Returns the numbers as `f64`.
fn plain<T: Lanes>(values: &[T]) -> Vec<f64> {
    values.iter().map(|value| value.lane(0).into()).collect()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn sum<T: Scalar>(a: &[T], b: &[T]) -> Vec<T> {
    a.iter().zip(b).map(|(&a, &b)| a + b).collect()
}

/// A case with random vectors.
struct Tried<C: Asked> {
    seed: u64,
    case: Case<C>,
    x: Vec<C::Scalar>,
    y: Vec<C::Scalar>,
}

impl<C: Asked<Scalar: Lanes>> Tried<C> {
    /// Checks that two vectors differ by at most so many units in the last place of `scale`.
    #[track_caller]
    fn check(&self, what: &str, (a, b): (&[C::Scalar], &[C::Scalar]), scale: f64, units: f64) {
        let (a, b) = (plain(a), plain(b));
        assert_eq!(a.len(), b.len());
        let epsilon: f64 = plain(&[C::Scalar::epsilon()])[0];
        for (a, b) in a.iter().zip(&b) {
            let off = (a - b).abs() / (scale * epsilon);
            let is_close = off <= units;
            assert!(is_close, "seed {}: {what}, {a} and {b}, {off:.0} units", self.seed);
        }
    }

    fn efforts(&self) {
        let Case { chain, state, inputs, .. } = &self.case;
        let zero = vec![C::Scalar::default(); self.x.len()];
        let (bias, inverse) = (chain.bias(state, inputs), chain.inverse(state, &self.x, inputs));
        let product = chain.mass_times(state, inputs, &self.x);
        let scale = largest(&plain(&bias)).max(largest(&plain(&inverse)));
        self.check("bias = ID(0)", (&bias, &chain.inverse(state, &zero, inputs)), scale, SUMS);
        self.check("M a + bias = ID(a)", (&sum(&product, &bias), &inverse), scale, SUMS);
        let mut rest = state.clone();
        rest.rates_mut().fill(C::Scalar::default());
        let gravity = chain.gravity(state, inputs);
        self.check("gravity", (&gravity, &chain.gravity(&rest, inputs)), scale, 0.0);
    }

    /// Sets the motors and nothing else. All of them are random numbers before.
    fn motors(&self)
    where
        C::Inputs: PartialEq + std::fmt::Debug + Clone,
    {
        let before = C::efforts(&self.case.inputs);
        let is_motor = |effort: &C::Scalar| plain(&[*effort])[0] != 0.0;
        let zero = C::Scalar::default();
        let wanted = self.x.iter().zip(&before).map(|(&x, it)| if is_motor(it) { x } else { zero });
        let mut inputs = self.case.inputs.clone();
        C::set_efforts(&mut inputs, &self.x);
        assert_eq!(plain(&C::efforts(&inputs)), plain(&wanted.collect::<Vec<_>>()));
        C::set_efforts(&mut inputs, &before);
        assert_eq!(inputs, self.case.inputs);
    }

    fn products(&self) {
        let Case { chain, state, inputs, .. } = &self.case;
        let (x, y) = (&self.x, &self.y);
        let masses = [x, y].map(|it| chain.mass_times(state, inputs, it));
        let solved = [x, y].map(|it| chain.inverse_mass_times(state, inputs, it));
        for ([one, two], what) in [(&masses, "yᵀ M x"), (&solved, "yᵀ M⁻¹ x")] {
            let (one, two) = (plain(one), plain(two));
            let (a, b) = (dot(&plain(y), &one), dot(&plain(x), &two));
            let scale = largest(&one).max(largest(&two));
            let epsilon: f64 = plain(&[C::Scalar::epsilon()])[0];
            let off = (a - b).abs() / (scale * epsilon);
            assert!(off <= SOLVED, "seed {}: {what}, {off:.0} units", self.seed);
        }
        let back = chain.inverse_mass_times(state, inputs, &masses[0]);
        self.check("M⁻¹ M x = x", (&back, x), 1.0, SOLVED);
        assert!(dot(&plain(x), &plain(&masses[0])) > 0.0, "seed {}: M is not positive", self.seed);
        assert!(dot(&plain(x), &plain(&solved[0])) > 0.0, "seed {}: M⁻¹", self.seed);
    }

    fn forward(&self) {
        let Case { chain, state, inputs, .. } = &self.case;
        let (accelerations, motors) = (chain.forward(state, inputs), C::efforts(inputs));
        let scale = largest(&plain(&accelerations)).max(1.0);
        let efforts = chain.inverse(state, &accelerations, inputs);
        let stiff = largest(&plain(&chain.mass_times(state, inputs, &accelerations))).max(scale);
        self.check("ID(FD(τ)) = τ", (&efforts, &motors), stiff, SOLVED);
        let bias: Vec<_> = chain.bias(state, inputs).iter().map(|&effort| -effort).collect();
        let solved = chain.inverse_mass_times(state, inputs, &sum(&motors, &bias));
        self.check("M⁻¹ (τ − bias)", (&solved, &accelerations), scale, SOLVED);
        let none = || vec![C::Scalar::default(); self.x.len()];
        let still = Direction { coordinates: none(), rates: none() };
        let [pushed, change] = chain.push(state, inputs, &still);
        self.check("accelerations of push", (&pushed, &accelerations), scale, SOLVED);
        self.check("no change", (&change, &none()), 1.0, 0.0);
    }
}

fn check<C>()
where
    C: Asked<Scalar: Lanes + Scalar<Real = <C as mstmm::Chain>::Scalar>>,
    C::Inputs: PartialEq + std::fmt::Debug + Clone,
{
    for seed in 0..SEEDS {
        let case = each::<C>(seed, 1, 0.01).swap_remove(0);
        let mut random = Random::new(1_000_000 + seed);
        let count = case.state.rates().len();
        let [x, y] = [(); 2]
            .map(|()| (0..count).map(|_| C::Scalar::constant(random.between(-1.0, 1.0))).collect());
        let tried = Tried { seed, case, x, y };
        tried.efforts();
        tried.motors();
        tried.products();
        tried.forward();
    }
}

macro_rules! chains {
    ($($test:ident: $name:ident;)*) => { $(
        #[test]
        fn $test() {
            check::<$name<f64>>();
            check::<$name<f32>>();
        }
    )* };
}

chains! {
    pins: Arm;
    all_hinges_and_prescribed_motions: Slides;
    a_tree_with_parts_and_repetitions: Branched;
    a_floating_chain_in_a_plane: Raft;
    a_line: Train;
}
