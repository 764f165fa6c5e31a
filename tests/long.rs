//! Chains of a thousand bodies, written with `repeat`: as accurate as short ones, in both precisions
//! and by both methods, against the same generated code in numbers of twice the precision.

#[path = "support/double_double_scalar.rs"]
mod double_double;

use double_double::DoubleDouble;
use mstmm::{ChainState, GeneratedChain, PinState, Rk4, Scalar, mstmm_chain};
use mstmm_reference::Random;
use std::time::Instant;

/// Runs a test with a stack for several copies of the states and workspaces of long chains, which
/// unoptimised code needs.
fn with_room(test: impl FnOnce() + Send + 'static) {
    let thread = std::thread::Builder::new().stack_size(256 << 20);
    let running = thread.spawn(test).expect("a thread");
    if let Err(panic) = running.join() {
        std::panic::resume_unwind(panic);
    }
}

macro_rules! long {
    ($($name:ident $method:ident { $($route:tt)* })*) => { $(
        mstmm_chain! { chain $name {
            gravity = [0, -9.8, 0] m/s^2;
            method = $method;
            body Cube {
                mass = 1 kg;
                com = [0.5, 0, 0] m;
                output = [1, 0, 0] m;
                inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
            }
            $($route)*
        } }
    )* };
}

long! {
    Balls riccati { ground -> repeat 1000 { ball a -> Cube b }; }
    BallsByTransfer transfer { ground -> repeat 1000 { ball a -> Cube b }; }
    Pins riccati { ground -> repeat 1000 { pin(z) a -> Cube b }; }
    PinsByTransfer transfer { ground -> repeat 1000 { pin(z) a -> Cube b }; }
    Turning riccati { ground -> repeat 500 { pin(y) a -> Cube b -> pin(z) c -> Cube d }; }
    TurningByTransfer transfer { ground -> repeat 500 { pin(y) a -> Cube b -> pin(z) c -> Cube d }; }
    Universals riccati { ground -> repeat 1000 { universal(y, z) a -> Cube b }; }
    UniversalsByTransfer transfer { ground -> repeat 1000 { universal(y, z) a -> Cube b }; }
    TenThousand riccati { ground -> repeat 10_000 { pin(z) a -> Cube b }; }
}

/// Coordinates and rates.
#[derive(Clone, Debug)]
struct Pose {
    q: Vec<f64>,
    v: Vec<f64>,
}

impl Pose {
    /// Straight, at rest or turning.
    fn straight<C: GeneratedChain>(chain: &C, rate: f64) -> Self {
        let number = |x: &C::Scalar| if *x == C::Scalar::default() { 0.0 } else { 1.0 };
        let zero = chain.initial_state();
        Pose {
            q: zero.coordinates().iter().map(number).collect(),
            v: vec![rate; zero.rates().len()],
        }
    }

    /// Of any angles and rates. All numbers are such that `f32` holds them exactly, so all precisions
    /// solve the same problem; quaternions are of unit length in `f32`.
    fn random<C: GeneratedChain>(chain: &C, seed: u64) -> Self {
        let Pose { q, v } = Pose::straight(chain, 0.0);
        let mut random = Random::new(seed);
        let mut short = |limit: f64| f64::from(random.between(-limit, limit) as f32);
        let mut turned: Vec<f64> = q.iter().map(|_| short(1.0)).collect();
        for (at, _) in q.iter().enumerate().filter(|(_, rest)| **rest == 1.0) {
            let quaternion = &mut turned[at..at + 4];
            let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
            quaternion.iter_mut().for_each(|x| *x = f64::from((*x / length) as f32));
        }
        Pose { q: turned, v: v.iter().map(|_| short(2.0)).collect() }
    }

    /// As a state of a chain.
    fn of<C: GeneratedChain>(&self, chain: &C) -> C::State {
        let mut state = chain.initial_state();
        let set = |(to, from): (&mut C::Scalar, &f64)| *to = C::Scalar::constant(*from);
        state.coordinates_mut().iter_mut().zip(&self.q).for_each(set);
        state.rates_mut().iter_mut().zip(&self.v).for_each(set);
        state
    }

    /// The accelerations of a chain.
    fn accelerations<C>(&self, chain: &C, number: fn(C::Scalar) -> f64) -> Vec<f64>
    where
        C: GeneratedChain,
    {
        let state = self.of(chain);
        let mut rate = state.clone();
        chain.derivative_into(&state, &chain.no_inputs(), &mut rate).expect("a regular chain");
        rate.rates().iter().map(|&x| number(x)).collect()
    }
}

/// The largest error over the largest acceleration.
fn error(computed: &[f64], truth: &[f64]) -> f64 {
    let largest = truth.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let apart = computed.iter().zip(truth).map(|(a, b)| (a - b).abs());
    apart.fold(0.0, |worst, x| if x.is_nan() || x > worst { x } else { worst }) / largest
}

/// Rounding in each of a thousand bodies, some hundred operations each, adds up to √1e5 units in the
/// last place; the parts in front of long chains add a condition number of some tens.
const DOUBLE: f64 = 1e-11;
const SINGLE: f64 = 1e-3;

/// Compares both precisions, straight and in random poses. A straight chain that turns has centripetal
/// forces far above all else, which do not accelerate any hinge: `fast` asks for that as well.
macro_rules! compare {
    ($($chain:ident $fast:literal)*) => { $(
        with_room(|| {
            let name = stringify!($chain);
            let exact = $chain::<DoubleDouble>::new();
            let (double, single) = ($chain::<f64>::new(), $chain::<f32>::new());
            let mut poses = vec![("straight".to_owned(), Pose::straight(&double, 0.0))];
            if $fast {
                poses.push(("straight, turning".to_owned(), Pose::straight(&double, 0.5)));
            }
            poses.extend((0..3).map(|seed| (format!("seed {seed}"), Pose::random(&double, seed))));
            for (which, pose) in poses {
                let truth = pose.accelerations(&exact, |x| x.high);
                let off = error(&pose.accelerations(&double, |x| x), &truth);
                let in_single = error(&pose.accelerations(&single, f64::from), &truth);
                println!("{name}, {which}: off by {off:.1e}, in single precision {in_single:.1e}");
                assert!(off < DOUBLE, "{name}, {which}: off by {off:e}");
                assert!(in_single < SINGLE, "{name}, {which}: off by {in_single:e}");
                // Energies of the whole are sums of a thousand numbers.
                let energy = double.energy(&pose.of(&double)).total();
                let (exact_energy, scale) = exact_energy(&exact, &pose);
                let off = (energy - exact_energy).abs() / scale;
                assert!(off < 1e-13, "{name}, {which}: energy off by {off:e}");
            }
        });
    )* };
}

/// The energy, and the sum of both energies' magnitudes and of one joule.
fn exact_energy<C: GeneratedChain<Scalar = DoubleDouble>>(chain: &C, pose: &Pose) -> (f64, f64) {
    let energy = chain.energy(&pose.of(chain));
    let (kinetic, potential) = (energy.kinetic.high, energy.potential.high);
    (energy.total().high, kinetic.abs() + potential.abs() + 1.0)
}

#[test]
fn a_thousand_balls() {
    compare!(Balls true BallsByTransfer false);
}

#[test]
fn a_thousand_pins_in_a_plane() {
    compare!(Pins true PinsByTransfer false);
}

#[test]
fn a_thousand_pins_about_axes_in_turn() {
    compare!(Turning true TurningByTransfer false);
}

#[test]
fn a_thousand_universals() {
    compare!(Universals true UniversalsByTransfer false);
}

/// Prints the time, without a limit.
#[test]
fn ten_thousand_pins_run() {
    with_room(|| {
        let chain = TenThousand::<f64>::new();
        let mut state = chain.initial_state();
        state.set_each_a(|index| PinState::new((index as f64).sin(), 0.0));
        let inputs = chain.no_inputs();
        let start = Instant::now();
        let accelerations = chain.accelerations(&state, &inputs).expect("a regular chain");
        let fast = start.elapsed();
        let mut at = Box::new(chain.workspace());
        let start = Instant::now();
        chain.solve_into(&state, &inputs, &mut at).expect("a regular chain");
        println!("ten thousand pins: accelerations in {fast:.1?}, all in {:.1?}", start.elapsed());
        let off = error(at.accelerations().as_slice(), accelerations.as_slice());
        assert!(off < 1e-12, "{off:e}");
        // What the ground carries is what weight and motion of all cubes ask for.
        let last = at.b(9999).expect("the last of them");
        assert!(at.b(10_000).is_none() && last.output().force().norm() < 1e-6);
        // The gravity of ten thousand cubes is 98 kN.
        let carried = at.a(0).expect("the first of them").input().force();
        let momentum_rate: nalgebra::Vector3<f64> = (0..10_000)
            .filter_map(|k| at.b(k))
            .map(|cube| {
                let (input, output) = (cube.input(), cube.output());
                (input.acceleration() + output.acceleration()) * 0.5
            })
            .sum();
        let weight = nalgebra::Vector3::new(0.0, -98_000.0, 0.0);
        let off = (carried + weight - momentum_rate).norm();
        assert!(off < 1e-9 * weight.norm(), "{off:e}");
    });
}

mstmm_chain! {
    /// Ten metres of rope.
    plane chain Rope {
        gravity = [0, -9.8] m/s^2;
        body Link {
            mass = 1 g;
            com = [5, 0] mm;
            output = [10, 0] mm;
            inertia = 1e-8 kg*m^2 about com;
        }
        ground -> repeat 1000 { pin joint -> Link link };
        hinge joint { start = 0.1 deg; }
    }
}

/// Waves between links are as fast as 2 √(tension / mass) / length, 2e3 /s; steps resolve them.
#[test]
fn a_rope_keeps_its_energy() {
    with_room(|| {
        let chain = Rope::<f64>::new();
        let (mut state, mut rk4) = (chain.initial_state(), Rk4::new(1e-4));
        let before = chain.energy(&state);
        assert_eq!(before.kinetic, 0.0);
        for _ in 0..100 {
            rk4.step(&chain, &mut state, |_, _| chain.no_inputs()).expect("a step");
        }
        let after = chain.energy(&state);
        let off = ((after.total() - before.total()) / after.kinetic).abs();
        println!("after 10 ms {:.1e} J are kinetic, {off:.1e} of them gained", after.kinetic);
        assert!(after.kinetic > 1e-4 && off < 1e-8, "{off:e} of {after:?}");
    });
}

mod long {
    mod counted;
    mod linearization;
    mod products;
    mod trees;
}
