//! Products with the derivatives of the accelerations of chains of up to a thousand bodies: their operations for each body,
//! and their accuracy.

use super::counted::{Counted, operations};
use crate::double_double::DoubleDouble;
use crate::{Pose, error, with_room};
use mstmm::description::Answer;
use mstmm::{Answers, Described, GeneratedChain, Scalar, mstmm_chain};
use mstmm_reference::Random;

macro_rules! chains {
    ($($name:ident of $count:literal { $($part:tt)* } { $($settings:tt)* })*) => { $(
        mstmm_chain! { chain $name {
            gravity = [0, -9.8, 0] m/s^2;
            answers = [push, pull];
            param load = 1 kg;
            body Cube {
                mass = load;
                com = [0.5, 0, 0] m;
                output = [1, 0, 0] m;
                inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
            }
            ground -> repeat $count { $($part)* };
            hinge $($settings)* { torque = input; damping = 0.1; }
        } }
    )* };
}

macro_rules! balls {
    ($($name:ident of $count:literal)*) => {
        chains! { $($name of $count { ball a -> Cube b } { a })* }
    };
}

macro_rules! pins {
    ($($name:ident of $count:literal)*) => {
        chains! { $($name of $count { pin(y) a -> Cube b -> pin(z) c -> Cube d } { a, c })* }
    };
}

balls! { Balls of 1000 Balls100 of 100 Balls10 of 10 }
pins! { Pins of 500 Pins50 of 50 Pins5 of 5 }

/// A generated chain with answers.
pub trait Asked: GeneratedChain + Answers {}

impl<C: GeneratedChain + Answers> Asked for C {}

/// Returns all values of an answer at given inputs.
pub fn answer<C: Asked>(
    chain: &C,
    (state, inputs): (&C::State, &C::Inputs),
    answer: Answer,
    given: &[C::Scalar],
) -> Vec<C::Scalar> {
    let mut result = vec![C::Scalar::default(); answer.len(C::DESCRIPTION, 0)];
    let found = chain.answer(answer, state, inputs, given, &mut result);
    found.expect("the chain has the answer").expect("a regular chain");
    result
}

/// Returns random numbers that all precisions have.
pub fn numbers(count: usize, seed: u64) -> Vec<f64> {
    let mut random = Random::new(seed);
    (0..count).map(|_| f64::from(random.between(-1.0, 1.0) as f32)).collect()
}

/// Returns an answer in a pose, with a random effort of every motor.
pub fn at_pose<C: Asked>(chain: &C, pose: &Pose, which: Answer, given: &[f64]) -> Vec<C::Scalar> {
    let constants =
        |values: &[f64]| values.iter().copied().map(C::Scalar::constant).collect::<Vec<_>>();
    let inputs = constants(&numbers(C::DESCRIPTION.inputs().len(), 5));
    let inputs = C::inputs_from_slice(&inputs).expect("all inputs");
    answer(chain, (&pose.of(chain), &inputs), which, &constants(given))
}

/// Returns the operations of the rate of a state, which contains the accelerations, and of both products.
fn costs<C: Asked<Scalar = Counted>>(chain: &C) -> [u64; 3] {
    let (state, inputs) = (chain.initial_state(), chain.no_inputs());
    let mut rate = state.clone();
    let product = |answer: Answer| {
        let given = vec![Counted::default(); answer.given(C::DESCRIPTION)];
        operations(|| _ = self::answer(chain, (&state, &inputs), answer, &given))
    };
    [
        operations(|| chain.derivative_into(&state, &inputs, &mut rate).expect("a regular chain")),
        product(Answer::Push),
        product(Answer::Pull),
    ]
}

/// Both products cost the same for each body, to the operation, and at most `limit` times the rate of the state. The lengths
/// are such that the ratio of their differences is ten.
macro_rules! linear {
    ($long:ident $middle:ident $short:ident $limit:literal) => {
        with_room(|| {
            let name = stringify!($long);
            let long = costs(&$long::<Counted>::new());
            let middle = costs(&$middle::<Counted>::new());
            let short = costs(&$short::<Counted>::new());
            let each = [0, 1, 2].map(|k| (middle[k] - short[k]) as f64 / 90.0);
            println!("{name}: {each:.1?} operations for each body, {short:?} for ten bodies");
            for (k, what) in ["rate of the state", "push", "pull"].into_iter().enumerate() {
                assert!(short[k] > 0 && middle[k] > short[k], "{name}, {what}: nothing is counted");
                assert_eq!(long[k] - middle[k], 10 * (middle[k] - short[k]), "{name}, {what}");
                for costs in [long, middle, short] {
                    let ratio = costs[k] as f64 / costs[0] as f64;
                    assert!(ratio <= $limit, "{name}, {what}: {ratio:.2} of {costs:?}");
                }
            }
        })
    };
}

#[test]
fn products_of_balls_cost_the_same_for_each_body() {
    linear!(Balls Balls100 Balls10 2.6);
}

#[test]
fn products_of_pins_cost_the_same_for_each_body() {
    linear!(Pins Pins50 Pins5 2.1);
}

/// The tolerance of J x, relative to its largest entry. A small motion changes the efforts that keep the accelerations.
/// These changes are 1e6 times those of a single body, since the levers and the number of bodies are a thousand times larger.
/// They cancel, except for those that accelerate neighbours. Their rounding errors of up to ten units in the last place remain.
const ALONG: f64 = 1e7 * f64::EPSILON;

/// Sums of some thousand such errors, whose signs are random, relative to the sum of the magnitudes of the terms.
const SUMMED: f64 = ALONG / 30.0;

/// `yᵀ (J x) = (Jᵀ y)ᵀ x` for a direction along all coordinates, rates, inputs and parameters, and J x against the same code
/// in twice the precision.
macro_rules! accurate {
    ($chain:ident) => {
        with_room(|| {
            let name = stringify!($chain);
            let (chain, exact) = ($chain::<f64>::new(), $chain::<DoubleDouble>::new());
            for seed in 0..3 {
                let pose = Pose::random(&chain, seed);
                let x = numbers(Answer::Push.given($chain::<f64>::DESCRIPTION), 100 + seed);
                let y = numbers(pose.v.len(), 200 + seed);
                let pushed = at_pose(&chain, &pose, Answer::Push, &x);
                let truth = at_pose(&exact, &pose, Answer::Push, &x);
                let truth: Vec<f64> = truth.iter().map(|entry| entry.high).collect();
                let (change, expected) = (&pushed[y.len()..], &truth[y.len()..]);
                let off = error(change, expected);
                let pulled = at_pose(&chain, &pose, Answer::Pull, &y);
                let gradient = &pulled[y.len()..];
                let ([one, first], [two, second]) = (sums(&y, change), sums(gradient, &x));
                let apart = (one - two).abs() / first.max(second);
                println!("{name}, seed {seed}: J x is off by {off:.1e}, products by {apart:.1e}");
                assert!(off < ALONG, "{name}, seed {seed}: J x is off by {off:e}");
                assert!(apart < SUMMED, "{name}, seed {seed}: {one} is not {two}");
            }
        })
    };
}

/// Returns the sum of products, and the sum of their magnitudes.
fn sums(a: &[f64], b: &[f64]) -> [f64; 2] {
    assert_eq!(a.len(), b.len());
    let products = || a.iter().zip(b).map(|(a, b)| a * b);
    [products().sum(), products().map(f64::abs).sum()]
}

#[test]
fn products_of_a_thousand_balls_are_accurate() {
    accurate!(Balls);
}

#[test]
fn products_of_a_thousand_pins_are_accurate() {
    accurate!(Pins);
}
