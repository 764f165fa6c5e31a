//! What `assemble` minimises: the kinetic energy of each correction.

use mstmm::{ChainState, GeneratedChain, Scalar, mstmm_chain};
use mstmm_reference::Random;

macro_rules! chains {
    ($method:ident: $unrolled:ident $repeated:ident $space:ident) => {
        mstmm_chain! {
            /// Five bars, one much heavier, with rotors: two degrees of freedom.
            pub plane chain $unrolled {
                method = $method;
                body Light { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 0.1 about com; }
                body Heavy { mass = 9 kg; com = [0.4, 0.1] m; output = [1, 0] m; inertia = 1 about com; }
                ground -> pin a -> Light la -> pin b -> Heavy lb -> pin c -> Light lc
                    -> pin d -> Light ld -> pin e -> ground at [1.7, 0] m;
                hinge a { start = 90 deg; armature = 0.5; }
                hinge b { start = -40 deg; }
                hinge c { start = -60 deg; }
                hinge d { start = -60 deg; }
                hinge e { armature = 0.3; }
            }
            pub plane chain $repeated {
                method = $method;
                body Light { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 0.1 about com; }
                body Heavy { mass = 9 kg; com = [0.4, 0.1] m; output = [1, 0] m; inertia = 1 about com; }
                ground -> pin a -> Heavy lb -> repeat 3 { pin b -> Light la }
                    -> pin e -> ground at [1.7, 0] m;
                hinge a { start = 90 deg; armature = 0.5; }
                hinge b { start = -50 deg; }
            }
            pub chain $space {
                method = $method;
                body Light {
                    mass = 1 kg; com = [0.5, 0.1, 0] m; output = [1, 0, 0] m;
                    inertia = diag(0.1, 0.2, 0.3) about com;
                }
                ground -> ball a -> Light la -> universal b -> Light lb -> ball c -> Light lc
                    -> ball d -> ground at [1.4, 0.3, 0.2] m;
                hinge a { start = rpy(0, -10, 80) deg; }
                hinge b { start = [5, -10] deg; }
                hinge c { start = rpy(10, 0, -70) deg; }
            }
        }
    };
}

chains! { riccati: Written Repeated Space }
chains! { transfer: WrittenByTransfer RepeatedByTransfer SpaceByTransfer }

/// A number of these tests.
trait Number: Scalar<Real = Self, Mask = bool> + PartialOrd + Into<f64> {}

impl Number for f32 {}
impl Number for f64 {}

trait Closed: GeneratedChain<Scalar: Number> + Default {}

impl<C: GeneratedChain<Scalar: Number> + Default> Closed for C {}

/// aᵀ M b of rates in the pose of `state`, from kinetic energies.
fn product<C: Closed>(chain: &C, pose: &C::State, a: &[f64], b: &[f64]) -> f64 {
    let twice_kinetic = |rates: &dyn Fn(usize) -> f64| {
        let mut state = pose.clone();
        for (k, v) in state.rates_mut().iter_mut().enumerate() {
            *v = Scalar::constant(rates(k));
        }
        let energy: f64 = chain.energy(&state).kinetic.into();
        2.0 * energy
    };
    let sum = twice_kinetic(&|k| a[k] + b[k]);
    let difference = twice_kinetic(&|k| a[k] - b[k]);
    0.25 * (sum - difference)
}

/// The cosine of the angle between rates, as kinetic energy measures it.
fn cosine<C: Closed>(chain: &C, pose: &C::State, a: &[f64], b: &[f64]) -> f64 {
    let square = product(chain, pose, a, a) * product(chain, pose, b, b);
    product(chain, pose, a, b) / square.sqrt()
}

fn numbers<T: Number>(slice: &[T]) -> Vec<f64> {
    slice.iter().map(|&x| x.into()).collect()
}

fn differences(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// A closed pose, and rates of a motion that the closure leaves.
fn closed<C: Closed>(chain: &C, random: &mut Random) -> C::State {
    let mut state = chain.initial_state();
    for v in state.rates_mut() {
        *v = Scalar::constant(random.between(-1.0, 1.0));
    }
    chain.assemble(&mut state, &chain.no_inputs()).expect("a chain that closes");
    state
}

/// A change of rates is minimal if it is orthogonal to all motions that the constraint allows.
fn rates_change_least<C: Closed>(name: &str) {
    let chain = C::default();
    let mut random = Random::new(11);
    let epsilon: f64 = C::Scalar::epsilon().into();
    for _ in 0..10 {
        let pose = closed(&chain, &mut random);
        let mut state = pose.clone();
        for v in state.rates_mut() {
            *v = Scalar::constant(random.between(-1.0, 1.0));
        }
        let before = numbers(state.rates());
        chain.assemble(&mut state, &chain.no_inputs()).expect("a closed chain");
        let change = differences(&numbers(state.rates()), &before);
        let motions = [numbers(pose.rates()), numbers(state.rates())];
        for motion in motions {
            let cosine = cosine(&chain, &pose, &change, &motion);
            assert!(cosine.abs() < 1e4 * epsilon, "{name}: {cosine:e}");
        }
        // What fits already stays.
        let fitting = state.clone();
        chain.assemble(&mut state, &chain.no_inputs()).expect("a closed chain");
        let off = differences(&numbers(state.rates()), &numbers(fitting.rates()));
        assert!(off.iter().all(|off| off.abs() < 1e3 * epsilon), "{name}: {off:?}");
    }
}

#[test]
fn rates_change_by_the_least_kinetic_energy() {
    rates_change_least::<Written<f64>>("written out");
    rates_change_least::<Written<f32>>("written out");
    rates_change_least::<WrittenByTransfer<f64>>("written out, transfer");
    rates_change_least::<Repeated<f64>>("repeated");
    rates_change_least::<Repeated<f32>>("repeated");
    rates_change_least::<RepeatedByTransfer<f64>>("repeated, transfer");
    rates_change_least::<Space<f64>>("in space");
    rates_change_least::<Space<f32>>("in space");
    rates_change_least::<SpaceByTransfer<f64>>("in space, transfer");
}

/// The change of coordinates is orthogonal to all motions that the constraint allows, up to its length: so it
/// is minimal up to the square of its length.
fn coordinates_move_least<C: Closed>(name: &str, far: f64) {
    let chain = C::default();
    let mut random = Random::new(5);
    for _ in 0..10 {
        let pose = closed(&chain, &mut random);
        let mut state = pose.clone();
        for q in state.coordinates_mut() {
            *q += C::Scalar::constant(random.between(-far, far));
        }
        let before = numbers(state.coordinates());
        chain.assemble(&mut state, &chain.no_inputs()).expect("a chain nearly closed");
        let way = differences(&numbers(state.coordinates()), &before);
        let cosine = cosine(&chain, &state, &way, &numbers(state.rates()));
        // The chains' condition is some ten.
        assert!(cosine.abs() < 20.0 * far, "{name}: {cosine:e}");
        // Not all motions would do: that of one hinge alone is not at right angles.
        let mut one = vec![0.0; way.len()];
        one[0] = 1.0;
        let cosine = self::cosine(&chain, &state, &one, &numbers(state.rates()));
        assert!(cosine.abs() > 20.0 * far, "{name}: {cosine:e}");
    }
}

#[test]
fn coordinates_move_by_the_least_kinetic_energy() {
    coordinates_move_least::<Written<f64>>("written out", 1e-5);
    coordinates_move_least::<Written<f32>>("written out", 1e-3);
    coordinates_move_least::<WrittenByTransfer<f64>>("written out, transfer", 1e-5);
    coordinates_move_least::<Repeated<f64>>("repeated", 1e-5);
    coordinates_move_least::<Repeated<f32>>("repeated", 1e-3);
    coordinates_move_least::<RepeatedByTransfer<f64>>("repeated, transfer", 1e-5);
}
