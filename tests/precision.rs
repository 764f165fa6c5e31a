//! Thirty hinges through the macro: accuracy does not fall with length, in either method and
//! either precision. A plain product of so many transfer matrices has no correct digit left.
//!
//! The two methods eliminate different unknowns in opposite directions, and the independent solver
//! factorises one dense system of 330 or 360 unknowns. Their rounding errors are independent, so if all
//! three agree to 1e-12, each has this accuracy. The tests of the equations compare them with twice the
//! precision.

mod support;

use mstmm::{ChainState, Error, Scalar};
use mstmm_reference::{About, Body, Chain, Element, Frame, Hinge, HingeKind, Random, State};
use support::difference;
use support::mechanism::random_quaternion;

const BODIES: usize = 30;

/// Thirty cubes on alternating hinges of two kinds.
macro_rules! thirty {
    ($name:ident $method:ident [$($odd:tt)*] [$($even:tt)*]) => {
        mstmm::mstmm_chain! { chain $name {
            method = $method;
            gravity = [0, -9.8, 0] m/s^2;
            body Cube {
                mass = 1 kg;
                com = [0.5, 0, 0] m;
                output = [1, 0, 0] m;
                inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
            }
            ground
                -> $($odd)* h1 -> Cube b1 -> $($even)* h2 -> Cube b2
                -> $($odd)* h3 -> Cube b3 -> $($even)* h4 -> Cube b4
                -> $($odd)* h5 -> Cube b5 -> $($even)* h6 -> Cube b6
                -> $($odd)* h7 -> Cube b7 -> $($even)* h8 -> Cube b8
                -> $($odd)* h9 -> Cube b9 -> $($even)* h10 -> Cube b10
                -> $($odd)* h11 -> Cube b11 -> $($even)* h12 -> Cube b12
                -> $($odd)* h13 -> Cube b13 -> $($even)* h14 -> Cube b14
                -> $($odd)* h15 -> Cube b15 -> $($even)* h16 -> Cube b16
                -> $($odd)* h17 -> Cube b17 -> $($even)* h18 -> Cube b18
                -> $($odd)* h19 -> Cube b19 -> $($even)* h20 -> Cube b20
                -> $($odd)* h21 -> Cube b21 -> $($even)* h22 -> Cube b22
                -> $($odd)* h23 -> Cube b23 -> $($even)* h24 -> Cube b24
                -> $($odd)* h25 -> Cube b25 -> $($even)* h26 -> Cube b26
                -> $($odd)* h27 -> Cube b27 -> $($even)* h28 -> Cube b28
                -> $($odd)* h29 -> Cube b29 -> $($even)* h30 -> Cube b30;
        } }

        impl<T: Scalar> Accelerated<T> for $name<T> {
            fn accelerations_at(q: &[f64], v: &[f64]) -> Result<Vec<T>, Error> {
                let chain = Self::new();
                let mut state = chain.initial_state();
                let convert = |to: &mut [T], from: &[f64]| {
                    to.iter_mut().zip(from).for_each(|(to, &from)| *to = T::constant(from));
                };
                assert!(state.coordinates().len() == q.len() && state.rates().len() == v.len());
                convert(state.coordinates_mut(), q);
                convert(state.rates_mut(), v);
                let found = chain.accelerations(&state, &chain.no_inputs())?;
                Ok(found.as_slice().to_vec())
            }
        }
    };
}

thirty! { Balls riccati [ball] [ball] }
thirty! { BallsByTransfer transfer [ball] [ball] }
thirty! { Pins riccati [pin(z)] [pin(y)] }
thirty! { PinsByTransfer transfer [pin(z)] [pin(y)] }

/// A long chain in any precision.
trait Accelerated<T> {
    fn accelerations_at(q: &[f64], v: &[f64]) -> Result<Vec<T>, Error>;
}

/// The same chain for the independent solver.
fn reference(kind: impl Fn(usize) -> HingeKind) -> Chain {
    let cube = |n| Body {
        name: format!("b{n}"),
        mass: 1.0,
        com: [0.5, 0.0, 0.0],
        output: Frame::at([1.0, 0.0, 0.0]),
        inertia: [1.0 / 6.0, 5.0 / 12.0, 5.0 / 12.0, 0.0, 0.0, 0.0],
        about: About::Input,
        points: Vec::new(),
    };
    let hinge = |n| Hinge::new(&format!("h{n}"), kind(n));
    let elements =
        (1..=BODIES).flat_map(|n| [Element::Hinge(hinge(n)), Element::Body(cube(n))]).collect();
    Chain::new("Thirty", [0.0, -9.8, 0.0], elements)
}

/// Poses and rates that are exact in `f32`, except quaternions, which cannot have unit length in every
/// precision: their rounding is an error of the input.
fn random_state(random: &mut Random, reference: &Chain) -> State {
    let mut q = Vec::new();
    let mut short = |limit: f64| f64::from(random.between(-limit, limit) as f32);
    let v = (0..reference.dof_count()).map(|_| short(2.0)).collect();
    for hinge in reference.hinges() {
        match hinge.kind {
            HingeKind::Ball => q.extend(random_quaternion(random)),
            _ => q.push(f64::from(random.between(-3.0, 3.0) as f32)),
        }
    }
    State { q, v }
}

/// Compares both methods in both precisions and the independent solver.
fn check<R, X>(name: &str, reference: &Chain)
where
    R: Accelerated<f64>,
    X: Accelerated<f64>,
{
    for seed in 0..3 {
        let state = random_state(&mut Random::new(seed), reference);
        let riccati = R::accelerations_at(&state.q, &state.v).expect("a regular chain");
        let transfer = X::accelerations_at(&state.q, &state.v).expect("a regular chain");
        let truth = reference.solve(&state, &vec![0.0; state.v.len()]).accelerations;
        let between = difference(&transfer, &riccati);
        let [from_riccati, from_transfer] =
            [&riccati, &transfer].map(|found| difference(found, &truth));
        println!(
            "{name} seed {seed}: {between:.1e} apart, \
             {from_riccati:.1e} {from_transfer:.1e} from the reference"
        );
        assert!(between < 1e-12, "{name} seed {seed}: the methods differ by {between:e}");
        assert!(from_riccati < 1e-12 && from_transfer < 1e-12, "{name} seed {seed}");
    }
}

/// Compares single precision with double precision.
fn check_single<D: Accelerated<f64>, S: Accelerated<f32>>(name: &str, reference: &Chain) {
    for seed in 0..3 {
        let state = random_state(&mut Random::new(seed), reference);
        let double = D::accelerations_at(&state.q, &state.v).expect("a regular chain");
        let single = S::accelerations_at(&state.q, &state.v).expect("a regular chain");
        let single: Vec<f64> = single.into_iter().map(f64::from).collect();
        let off = difference(&single, &double);
        println!("{name} seed {seed}: single precision is off by {off:.1e}");
        assert!(off < 1e-4, "{name} seed {seed}: {off:e}");
    }
}

#[test]
fn thirty_balls() {
    let reference = reference(|_| HingeKind::Ball);
    check::<Balls<f64>, BallsByTransfer<f64>>("balls", &reference);
    check_single::<Balls<f64>, Balls<f32>>("balls, riccati", &reference);
    check_single::<Balls<f64>, BallsByTransfer<f32>>("balls, transfer", &reference);
}

#[test]
fn thirty_pins() {
    let axes = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let reference = reference(|n| HingeKind::Pin { axis: axes[n % 2] });
    check::<Pins<f64>, PinsByTransfer<f64>>("pins", &reference);
    check_single::<Pins<f64>, Pins<f32>>("pins, riccati", &reference);
    check_single::<Pins<f64>, PinsByTransfer<f32>>("pins, transfer", &reference);
}
