//! Motions through special positions, by their energy.
//!
//! An ideal chain moves by the reference and is projected onto its closure after every step. Its
//! drift is what RK4 leaves, and the bounds are at least three times that. At 1 ms it is, of the
//! greatest kinetic energy: 1e-9 in 60 s of Bennett's linkage at 8 rad/s, and in 3 s of the others
//! at most 6e-9 from 1.5 rad/s and 2e-8 from 8 rad/s, both of Sarrus' linkage.

use super::algebra::norm;
use super::face::Closed;
use super::linkage::Linkage;
use super::reference::apart;
use mstmm::{ChainState, Dopri5, Energy, Rk4};
use mstmm_reference::Random;

/// Starts a linkage as written, but with this rate of the first pin in rad/s.
fn started<C: Closed<Scalar = f64>>(chain: &C, linkage: &Linkage, rate: f64) -> C::State {
    let mut state = chain.initial_state();
    let factor = rate / linkage.start_rate[0];
    state.rates_mut().iter_mut().for_each(|v| *v *= factor);
    state
}

/// The energy along a motion.
struct Ledger {
    start: Energy<f64>,
    kinetic: f64,
    drift: f64,
}

impl Ledger {
    fn new(start: Energy<f64>) -> Ledger {
        Ledger { kinetic: start.kinetic, drift: 0.0, start }
    }

    fn enter(&mut self, now: Energy<f64>) {
        let off = (now.total() - self.start.total()).abs();
        assert!(off.is_finite());
        (self.kinetic, self.drift) = (self.kinetic.max(now.kinetic), self.drift.max(off));
    }

    /// The drift relative to the greatest kinetic energy.
    fn relative(&self) -> f64 {
        self.drift / self.kinetic
    }
}

/// Moves by RK4 at 1 ms, and returns the end and how much energy drifts.
fn by_rk4<C>(chain: &C, mut state: C::State, seconds: usize) -> (C::State, f64)
where
    C: Closed<Scalar = f64>,
{
    let mut ledger = Ledger::new(chain.energy(&state));
    let mut rk4 = Rk4::new(1e-3);
    for step in 0..1000 * seconds {
        rk4.step(chain, &mut state, |_, _| chain.no_inputs()).expect("a regular linkage");
        if step % 10 == 9 {
            ledger.enter(chain.energy(&state));
        }
    }
    (state, ledger.relative())
}

/// Moves by Dopri5 at a tolerance of 1e-10, in the same way.
fn by_dopri5<C>(chain: &C, mut state: C::State, seconds: f64) -> (C::State, f64)
where
    C: Closed<Scalar = f64>,
{
    let mut ledger = Ledger::new(chain.energy(&state));
    let mut dopri5 = Dopri5::new(1e-10, 1e-10);
    while state.time() < seconds {
        dopri5.step(chain, &mut state, |_, _| chain.no_inputs()).expect("a regular linkage");
        ledger.enter(chain.energy(&state));
    }
    (state, ledger.relative())
}

/// A minute of Bennett's linkage, which passes both flat positions about a hundred times.
fn minute<C: Closed<Scalar = f64>>(linkage: &Linkage) {
    let chain = C::default();
    let (end, drift) = by_rk4(&chain, started(&chain, linkage, 8.0), 60);
    let turns = (end.coordinates()[0] / std::f64::consts::TAU).abs();
    println!("{}, RK4: drift {drift:.1e} in {turns:.0} turns", linkage.name);
    assert!(drift < 1e-8 && turns > 30.0, "{}: {drift:e}, {turns} turns", linkage.name);
    let (_, drift) = by_dopri5(&chain, started(&chain, linkage, 8.0), 60.0);
    println!("{}, Dopri5: drift {drift:.1e}", linkage.name);
    assert!(drift < 1e-7, "{}: {drift:e}", linkage.name);
}

/// Three seconds of any linkage, swinging and fast.
fn seconds<C: Closed<Scalar = f64>>(linkage: &Linkage) {
    let chain = C::default();
    for (rate, bound) in [(1.5, 2e-8), (8.0, 1e-7)] {
        let (end, drift) = by_rk4(&chain, started(&chain, linkage, rate), 3);
        let gap = linkage.gap(end.coordinates());
        println!("{} at {rate} rad/s: drift {drift:.1e}, gap {gap:.1e}", linkage.name);
        assert!(drift < bound, "{} at {rate} rad/s: energy drifts by {drift:e}", linkage.name);
        assert!(gap < 1e-12, "{} at {rate} rad/s: open by {gap:e}", linkage.name);
    }
}

/// Three seconds in single precision. Each step may change the energy by some roundings of what is
/// moved to and fro, and 3000 steps add up.
fn single<C: Closed<Scalar = f32>>(linkage: &Linkage) {
    let chain = C::default();
    let mut state = chain.initial_state();
    let energy = |state: &C::State| {
        let Energy { kinetic, potential } = chain.energy(state);
        Energy { kinetic: f64::from(kinetic), potential: f64::from(potential) }
    };
    let mut ledger = Ledger::new(energy(&state));
    let mut rk4 = Rk4::new(1e-3);
    for _ in 0..3000 {
        rk4.step(&chain, &mut state, |_, _| chain.no_inputs()).expect("a regular linkage");
        ledger.enter(energy(&state));
    }
    let drift = ledger.relative();
    println!("{} in single precision: drift {drift:.1e}", linkage.name);
    let bound = 3000.0 * 16.0 * f64::from(f32::EPSILON);
    assert!(drift < bound, "{} in single precision: energy drifts by {drift:e}", linkage.name);
}

/// Assembly of starts that miss by a little closes them nearby: each angle moves by no more than
/// the misses move the ends, over the weakest singular value.
fn rough<C: Closed<Scalar = f64>>(linkage: &Linkage) {
    let chain = C::default();
    let strength = linkage.instant::<f64>(linkage.start[0], 1.5).reference.strength;
    for (seed, miss) in [(0, 1e-6), (1, 1e-3), (2, 1e-2)] {
        let mut random = Random::new(seed);
        let mut state = chain.initial_state();
        let mut off = |x: &mut f64| *x += miss * random.between(-1.0, 1.0);
        state.coordinates_mut().iter_mut().for_each(&mut off);
        state.rates_mut().iter_mut().for_each(&mut off);
        let before = state.clone();
        chain.assemble(&mut state, &chain.no_inputs()).expect("a linkage that closes");
        let [gap, drift] =
            [linkage.gap(state.coordinates()), linkage.drift(state.coordinates(), state.rates())];
        let moved = apart(state.coordinates(), before.coordinates()) / (miss / strength);
        println!("{}, seed {seed}, {miss:e} off: moved {moved:.1e}, gap {gap:.1e}", linkage.name);
        assert!(gap < 1e-12 && drift < 1e-11, "{}: {gap:e}, {drift:e}", linkage.name);
        assert!(moved < 4.0, "{}, {miss:e} off: moved by {moved:e} of it", linkage.name);
        let answer = chain.answer(&state).expect("a regular linkage");
        assert_eq!(answer.redundant, 6 - linkage.rank, "{}, {miss:e} off", linkage.name);
        let [kept, start] = [state.rates(), &linkage.start_rate].map(norm);
        assert!((kept / start - 1.0).abs() < 0.2, "{}: speed {kept} of {start}", linkage.name);
    }
}

/// Assembly keeps a start that closes, and of rates that do not fit leaves a motion that does.
fn assembled<C: Closed<Scalar = f64>>(linkage: &Linkage) {
    let chain = C::default();
    let before = chain.initial_state();
    let mut state = before.clone();
    chain.assemble(&mut state, &chain.no_inputs()).expect("a linkage that closes");
    // The start misses by its last bits, and what that moves the weakest singular value divides.
    let off =
        |a: &[f64], b: &[f64]| a.iter().zip(b).fold(0.0_f64, |o, (a, b)| o.max((a - b).abs()));
    let moved =
        [off(state.coordinates(), before.coordinates()), off(state.rates(), before.rates())];
    let mut alone = before.clone();
    alone.rates_mut()[1..].fill(0.0);
    chain.assemble(&mut alone, &chain.no_inputs()).expect("a linkage that closes");
    let drift = linkage.drift(alone.coordinates(), alone.rates());
    let kept = alone.rates()[0] / before.rates()[0];
    println!("{}: moved {moved:?}, drift {drift:.1e}, kept {kept:.2}", linkage.name);
    assert!(moved.iter().all(|x| *x < 1e-12), "{}: moved by {moved:?}", linkage.name);
    assert!(drift < 1e-12, "{}: the ends drift apart at {drift:e}", linkage.name);
    let speed = alone.rates().iter().fold(0.0_f64, |speed, v| speed.max(v.abs()));
    assert!(speed > 0.1, "{}: stopped to {speed:e}", linkage.name);
}

/// Tests each linkage by both methods.
macro_rules! motions {
    ($($module:ident::$name:ident $riccati:ident $transfer:ident;)*) => { $(
        mod $name {
            use super::super::$module as models;
            use super::{assembled, rough, seconds, single};

            #[test]
            fn energy_lasts() {
                let linkage = models::$name();
                seconds::<models::$riccati<f64>>(&linkage);
                seconds::<models::$transfer<f64>>(&linkage);
            }

            #[test]
            fn single_precision_lasts() {
                let linkage = models::$name();
                single::<models::$riccati<f32>>(&linkage);
                single::<models::$transfer<f32>>(&linkage);
            }

            #[test]
            fn assembly_closes_nearby() {
                let linkage = models::$name();
                rough::<models::$riccati<f64>>(&linkage);
                rough::<models::$transfer<f64>>(&linkage);
            }

            #[test]
            fn assembly_keeps_rates() {
                let linkage = models::$name();
                assembled::<models::$riccati<f64>>(&linkage);
                assembled::<models::$transfer<f64>>(&linkage);
            }
        } )*
    };
}

each_linkage! { motions }

mod minutes {
    use super::super::bennett as models;
    use super::minute;

    #[test]
    fn bennett_by_riccati() {
        minute::<models::Bennett<f64>>(&models::bennett());
    }

    #[test]
    fn bennett_by_transfer() {
        minute::<models::BennettByTransfer<f64>>(&models::bennett());
    }

    #[test]
    fn tilted_by_riccati() {
        minute::<models::BennettTilted<f64>>(&models::bennett_tilted());
    }

    #[test]
    fn tilted_by_transfer() {
        minute::<models::BennettTiltedByTransfer<f64>>(&models::bennett_tilted());
    }
}
