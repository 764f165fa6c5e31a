//! Closed chains in which the closing hinge constrains the axes about which a body has no inertia.

mod support;

use mstmm::{Chain, ChainState, GeneratedChain, mstmm_chain};
use mstmm_reference::Random;
use support::difference;

macro_rules! sliding_rods {
    ($($name:ident $method:ident $thickness:literal $mass:expr;)*) => { $(
        mstmm_chain! { chain $name {
            method = $method;
            gravity = [1, -9.8, 2] m/s^2;
            body Block {
                mass = $mass;
                com = [0, 0, 0] m;
                output = [0, 0, 0] m;
                inertia = diag(0.01, 0.01, 0.01) kg*m^2 about com;
            }
            body Rod {
                mass = 1 kg;
                com = [0.5, 0, 0] m;
                output = [1, 0, 0] m;
                inertia = diag($thickness, 1/12, 1/12) kg*m^2 about com;
            }
            ground -> planar(z) plate -> Block block -> ball socket -> Rod rod
                -> universal(y, z) cross -> ground at [1, 0, 0] m;
        } }
    )* };
}

/// What the compiler does not know.
const ONE: f64 = 1.0;

sliding_rods! {
    Thin riccati 0 1;
    ThinByTransfer transfer 0 1;
    ThinConstant riccati 0 ONE;
    Thick riccati 1e-3 1;
    ThickByTransfer transfer 1e-3 1;
    Thinner riccati 1e-6 1;
}

/// At rest in its zero position the rod falls about the universal hinge, with the block at its other
/// end.
#[test]
fn a_thin_rod_is_held_by_its_end() {
    let thin = Thin::<f64>::new();
    let mut state = thin.initial_state();
    thin.assemble(&mut state, &thin.no_inputs()).expect("it is closed already");
    let accelerations = thin.accelerations(&state, &thin.no_inputs()).expect("a regular chain");
    // The moment of gravity about the end over the inertia about it: (m/2 + m) g and m/3 + m.
    let fall = -9.8 * 1.5 / (4.0 / 3.0);
    let expected = [0.0, fall, 0.0, 0.0, 0.0, -fall, 0.0, fall];
    // Ten roundings or so of numbers up to ten, and a condition of a hundred.
    let off = difference(accelerations.as_slice(), &expected);
    assert!(off < 1e-12, "{accelerations} {off:e}");
}

/// A thin rod is the limit of a thick rod, and both methods agree.
#[test]
fn thin_is_the_limit_of_thick() {
    let thin = Thin::<f64>::new();
    let mut random = Random::new(1);
    for seed in 0..20 {
        let mut state = thin.initial_state();
        state.coordinates_mut().iter_mut().for_each(|q| *q += random.between(-0.3, 0.3));
        state.rates_mut().iter_mut().for_each(|v| *v = random.between(-1.0, 1.0));
        thin.normalize(&mut state);
        thin.assemble(&mut state, &thin.no_inputs()).expect("a pose nearby");
        let a = results(&thin, state.coordinates(), state.rates());
        let b = results(&ThinByTransfer::<f64>::new(), state.coordinates(), state.rates());
        assert!(difference(&b, &a) < 1e-11, "seed {seed}: {:e}", difference(&b, &a));
        let b = results(&ThinConstant::<f64>::new(), state.coordinates(), state.rates());
        assert!(difference(&b, &a) < 1e-12, "seed {seed}: {:e}", difference(&b, &a));
        let c = results(&Thinner::<f64>::new(), state.coordinates(), state.rates());
        // A millionth of the inertia about the axis makes a difference of some millionths.
        assert!(difference(&c, &a) < 1e-4, "seed {seed}: {:e}", difference(&c, &a));
        let d = results(&Thick::<f64>::new(), state.coordinates(), state.rates());
        let e = results(&ThickByTransfer::<f64>::new(), state.coordinates(), state.rates());
        assert!(difference(&d, &e) < 1e-11, "seed {seed}: {:e}", difference(&d, &e));
    }
}

/// Accelerations and internal forces.
fn results<C: GeneratedChain<Scalar = f64, State: Default, Workspace: std::fmt::Debug>>(
    chain: &C,
    q: &[f64],
    v: &[f64],
) -> Vec<f64> {
    let mut state = C::State::zero_position();
    state.coordinates_mut().copy_from_slice(q);
    state.rates_mut().copy_from_slice(v);
    let mut at = chain.workspace();
    chain.solve_into(&state, &chain.no_inputs(), &mut at).expect("a regular chain");
    let text = format!("{at:?}");
    let words = text.split(|c: char| !(c.is_alphanumeric() || "-+.".contains(c)));
    words.filter_map(|word| word.parse().ok()).collect()
}
