//! Displacements between states of chains with hinges of every kind.

use super::models::{Crawler, Kinds};
use mstmm::wide::f64x4;
use mstmm::{ChainState, Described};

mstmm::mstmm_chain! {
    /// An elastic hinge in a plane.
    plane chain Leaf {
        body Plate { mass = 1 kg; com = [0.2, 0] m; output = [0.4, 0] m; inertia = 0.1 kg*m^2 about com; }
        ground -> elastic clamp -> Plate plate -> pin tip -> Plate flap;
        hinge clamp { stiffness = 1e3; turning_stiffness = 1e2; }
    }
}

/// Numbers from −1 to 1.
fn numbers(seed: u64) -> impl Iterator<Item = f64> {
    (1u64..).map(move |index| {
        let mixed = (index + 1000 * seed).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        (mixed ^ (mixed >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9) as f64 / 2f64.powi(63) - 1.0
    })
}

/// Returns a random state, with quaternions of unit length and angles of elastic hinges below a right angle.
fn random<C: Described<Scalar = f64>>(chain: &C, seed: u64) -> C::State {
    let mut state = chain.initial_state();
    state.coordinates_mut().iter_mut().zip(numbers(seed)).for_each(|(q, number)| *q = number);
    state.rates_mut().iter_mut().zip(numbers(seed + 500)).for_each(|(v, number)| *v = number);
    chain.normalize(&mut state);
    state
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// `displace` and `displacement_to_slice` are inverse for rotations of less than half a turn, and `displace` has the
/// derivative N(q), which `configuration_rate_into` computes.
fn check<C: Described<Scalar = f64>>(chain: &C) {
    let count = C::DESCRIPTION.rates().len();
    for seed in 0..20 {
        let start = random(chain, seed);
        let displacement: Vec<f64> = numbers(seed + 100).take(count).map(|x| 1.2 * x).collect();
        let mut end = start.clone();
        assert_eq!(C::displace(&mut end, &displacement), Some(()));
        assert_eq!((end.rates(), end.time()), (start.rates(), start.time()));
        let mut found = vec![0.0; count];
        assert_eq!(C::displacement_to_slice(&start, &end, &mut found), Some(()));
        // Rotation vectors of up to 2.1 rad: some dozens of operations on numbers of up to 3.
        let off = largest_difference(&found, &displacement);
        assert!(off < 1e-13, "seed {seed}: {off:e}");

        // (q(h) - q(-h)) / 2h = N v + O(h²), with third derivatives of up to about 10, and rounding of 1e-16 / h.
        let h = 1e-5;
        let [mut ahead, mut behind] = [start.clone(), start.clone()];
        let step: Vec<f64> = start.rates().iter().map(|v| v * h).collect();
        let back: Vec<f64> = step.iter().map(|x| -x).collect();
        assert_eq!(C::displace(&mut ahead, &step), Some(()));
        assert_eq!(C::displace(&mut behind, &back), Some(()));
        let mut rate = start.clone();
        chain.configuration_rate_into(&start, &mut rate);
        let pairs = ahead.coordinates().iter().zip(behind.coordinates());
        let found: Vec<f64> = pairs.map(|(ahead, behind)| (ahead - behind) / (2.0 * h)).collect();
        let off = largest_difference(&found, rate.coordinates());
        assert!(off < 1e-8, "seed {seed}: {off:e}");

        let mut short = vec![7.0; count - 1];
        assert_eq!(C::displacement_to_slice(&start, &end, &mut short), None);
        assert!(short.iter().all(|&entry| entry == 7.0));
        let before = end.clone();
        assert_eq!(C::displace(&mut end, &short), None);
        assert_eq!(end.coordinates(), before.coordinates());
    }
}

#[test]
fn displacements_are_those_of_the_rates() {
    check(&Kinds::<f64>::new());
    check(&Crawler::<f64>::new());
    check(&Leaf::<f64>::new());
}

mstmm::mstmm_chain! {
    /// Two rods on balls with springs, and a plate on an elastic hinge, which gravity bends.
    chain Mobile {
        gravity = [0, 0, -9.81] m/s^2;
        answers = linearize;
        body Rod {
            mass = 1 kg; com = [0.2, 0.05, 0] m; output = [0.4, 0, 0.1] m; inertia = diag(0.01, 0.02, 0.02) kg*m^2 about com;
        }
        ground -> ball a -> Rod one -> elastic b -> Rod two -> ball c -> Rod three;
        hinge a, c { stiffness = 8 N*m/rad; }
        hinge b { stiffness = 200 N/m; turning_stiffness = 20 N*m/rad; }
    }
}

/// Displacements are the δ of a linearisation: Newton's method with them converges quadratically to an equilibrium.
#[test]
fn newtons_method_finds_an_equilibrium_by_displacements() -> Result<(), mstmm::Error> {
    let chain = Mobile::<f64>::new();
    let (mut state, inputs) = (chain.initial_state(), chain.no_inputs());
    let mut sizes = Vec::new();
    for _ in 0..12 {
        let linear = chain.linearize(&state, &inputs)?;
        let step = linear.by_coordinates.lu().solve(&linear.accelerations).expect("stiff springs");
        sizes.push(step.amax());
        assert_eq!(Mobile::displace(&mut state, (-step).as_slice()), Some(()));
    }
    assert!(sizes[0] > 0.1, "{sizes:?}");
    let last = sizes.iter().position(|&size| size < 1e-4).expect("it converges");
    // The square of 1e-4, times second derivatives of about 10.
    assert!(last < 10 && sizes[last + 1] < 1e-6 && sizes[last + 2] < 1e-11, "{sizes:?}");
    // Stiffness over inertia is about 1e4 per s², times rounding.
    assert!(chain.accelerations(&state, &inputs)?.amax() < 1e-10);
    Ok(())
}

/// The shorter way, for both quaternions of a rotation; no division by zero without a rotation.
#[test]
fn displacements_go_the_shorter_way() {
    let chain = Kinds::<f64>::new();
    let start = random(&chain, 3);
    let count = Kinds::<f64>::DESCRIPTION.rates().len();
    let mut opposite = start.clone();
    let orientation = start.g().orientation();
    let [w, i, j, k] = [orientation.w, orientation.i, orientation.j, orientation.k];
    let ball = Kinds::<f64>::DESCRIPTION.coordinates().index("g.orientation.w").expect("a ball");
    opposite.coordinates_mut()[ball..ball + 4].copy_from_slice(&[-w, -i, -j, -k]);
    let mut displacement = vec![1.0; count];
    assert_eq!(Kinds::displacement_to_slice(&start, &opposite, &mut displacement), Some(()));
    // The elastic hinge's angles are converted to a quaternion, and rounded.
    assert!(displacement.iter().all(|entry| entry.abs() < 1e-15), "{displacement:?}");
}

#[test]
fn lanes_are_displaced_as_single_states() {
    let (chain, lanes) = (Kinds::<f64>::new(), Kinds::<f64x4>::new());
    let singles: Vec<_> = (0..4).map(|seed| random(&chain, seed)).collect();
    let count = Kinds::<f64>::DESCRIPTION.rates().len();
    let displacement: Vec<f64> = numbers(9).take(count).collect();
    let mut state = lanes.initial_state();
    for (index, q) in state.coordinates_mut().iter_mut().enumerate() {
        *q = f64x4::from([0, 1, 2, 3].map(|lane: usize| singles[lane].coordinates()[index]));
    }
    let wide: Vec<f64x4> = displacement.iter().map(|&x| f64x4::splat(x)).collect();
    assert_eq!(Kinds::displace(&mut state, &wide), Some(()));
    for (lane, single) in singles.into_iter().enumerate() {
        let mut single = single;
        assert_eq!(Kinds::displace(&mut single, &displacement), Some(()));
        let found: Vec<f64> = state.coordinates().iter().map(|q| q.to_array()[lane]).collect();
        assert_eq!(found, single.coordinates());
    }
}
