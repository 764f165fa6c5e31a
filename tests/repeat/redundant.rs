//! Linkages with redundant closures whose bars are repeated, beside the same written out: in motion, near
//! positions in which a row of the closure vanishes, and by both methods.

// Closed chains here start with their links in line, which gives a warning; the tests bend them.
#![allow(deprecated)]

use mstmm::prelude::*;
use mstmm::{ChainState, Error, GeneratedChain, Scalar};

macro_rules! linkages {
    ($module:ident, $method:ident) => {
        mod $module {
            mstmm::mstmm_chain! {
                pub chain Sarrus {
                    method = $method;
                    gravity = [1, 2, -9.8] m/s^2;
                    body Up {
                        mass = 1 kg; com = [0.1, 0, 0.5] m; output = [0, 0, 1] m;
                        inertia = diag(0.1, 0.11, 0.02) kg*m^2 about com;
                    }
                    body Platform {
                        mass = 3 kg; com = [-1, 0.2, 0.1] m; output = [-1, 1, 0] m;
                        inertia = diag(0.5, 0.6, 0.8) kg*m^2 about com;
                    }
                    body Down {
                        mass = 1.5 kg; com = [0, 0.1, -0.5] m; output = [0, 0, -1] m;
                        inertia = diag(0.1, 0.11, 0.02) kg*m^2 about com;
                    }
                    ground at [1, 0, 0] m -> repeat 2 { pin(y) a -> Up up } -> pin(y) b -> Platform
                        -> repeat 2 { pin(x) c -> Down down } -> pin(x) d -> ground at [0, 1, 0] m;
                    hinge b, d { start = 40 deg; }
                }
                pub chain SarrusOut {
                    method = $method;
                    gravity = [1, 2, -9.8] m/s^2;
                    body Up {
                        mass = 1 kg; com = [0.1, 0, 0.5] m; output = [0, 0, 1] m;
                        inertia = diag(0.1, 0.11, 0.02) kg*m^2 about com;
                    }
                    body Platform {
                        mass = 3 kg; com = [-1, 0.2, 0.1] m; output = [-1, 1, 0] m;
                        inertia = diag(0.5, 0.6, 0.8) kg*m^2 about com;
                    }
                    body Down {
                        mass = 1.5 kg; com = [0, 0.1, -0.5] m; output = [0, 0, -1] m;
                        inertia = diag(0.1, 0.11, 0.02) kg*m^2 about com;
                    }
                    ground at [1, 0, 0] m -> pin(y) a1 -> Up up1 -> pin(y) a2 -> Up up2 -> pin(y) b
                        -> Platform -> pin(x) c1 -> Down down1 -> pin(x) c2 -> Down down2
                        -> pin(x) d -> ground at [0, 1, 0] m;
                    hinge b, d { start = 40 deg; }
                }
                pub chain Bennett {
                    method = $method;
                    gravity = [1, 2, -9.8] m/s^2;
                    body Short {
                        mass = 1 kg; com = [0.5, 0.1, 0.05] m; inertia = diag(0.05, 0.1, 0.12) kg*m^2 about com;
                        output = [1, 0, 0] m turned rpy(30, 0, 0) deg;
                    }
                    body Long {
                        mass = 1.5 kg; com = [0.7, 0, 0.1] m; inertia = diag(0.06, 0.2, 0.22) kg*m^2 about com;
                        output = [sqrt(2), 0, 0] m turned rpy(45, 0, 0) deg;
                    }
                    ground -> pin a -> Short first -> repeat 1 { pin b -> Long second -> pin c -> Short third }
                        -> pin d -> ground at [-sqrt(2), 0, 0] m turned rpy(-45, 0, 0) deg;
                }
                pub chain BennettOut {
                    method = $method;
                    gravity = [1, 2, -9.8] m/s^2;
                    body Short {
                        mass = 1 kg; com = [0.5, 0.1, 0.05] m; inertia = diag(0.05, 0.1, 0.12) kg*m^2 about com;
                        output = [1, 0, 0] m turned rpy(30, 0, 0) deg;
                    }
                    body Long {
                        mass = 1.5 kg; com = [0.7, 0, 0.1] m; inertia = diag(0.06, 0.2, 0.22) kg*m^2 about com;
                        output = [sqrt(2), 0, 0] m turned rpy(45, 0, 0) deg;
                    }
                    ground -> pin a -> Short first -> pin b -> Long second -> pin c -> Short third
                        -> pin d -> ground at [-sqrt(2), 0, 0] m turned rpy(-45, 0, 0) deg;
                }
            }
        }
    };
}

linkages!(riccati, riccati);
linkages!(transfer, transfer);

/// Both arms of Sarrus' linkage at this angle of their first bars from the vertical.
fn sarrus(angle: f64) -> [f64; 6] {
    [angle, -2.0 * angle, angle, angle, -2.0 * angle, angle]
}

/// Bennett's linkage at this angle of its crank: tan(a/2) tan(b/2) = sin 37.5° / sin 7.5°.
fn bennett(angle: f64) -> [f64; 4] {
    let ratio = 37.5_f64.to_radians().sin() / 7.5_f64.to_radians().sin();
    let other = 2.0 * ratio.atan2((angle / 2.0).tan());
    [angle, other, -angle, -other]
}

/// Returns the state at these angles, with rates projected onto the loop constraint.
fn state<C: GeneratedChain>(chain: &C, angles: &[f64]) -> C::State {
    let mut state = chain.initial_state();
    for (q, &angle) in state.coordinates_mut().iter_mut().zip(angles) {
        *q = C::Scalar::constant(angle);
    }
    state.rates_mut().fill(C::Scalar::constant(1.0));
    for _ in 0..3 {
        chain.project(&mut state, |_| Ok::<_, Error>(chain.no_inputs())).expect("a linkage");
    }
    state
}

/// In units in the last place: a thousand operations, and singular values down to a twentieth of the largest,
/// which repeated parts square.
const TOLERANCE: f64 = 1e3 * 400.0;

macro_rules! compare {
    ($scalar:ty, $module:ident, $repeated:ident, $unrolled:ident, $angles:ident, $list:expr, $redundant:literal) => {
        let repeated = $module::$repeated::<$scalar>::new();
        let unrolled = $module::$unrolled::<$scalar>::new();
        let (mut at, mut out) = (repeated.workspace(), unrolled.workspace());
        for angle in $list {
            let state = state(&repeated, &$angles(angle));
            let mut twin = unrolled.initial_state();
            twin.coordinates_mut().copy_from_slice(state.coordinates());
            twin.rates_mut().copy_from_slice(state.rates());
            repeated.solve_into(&state, &repeated.no_inputs(), &mut at).expect("a state");
            unrolled.solve_into(&twin, &unrolled.no_inputs(), &mut out).expect("a state");
            let label = format!("{}, {}, {angle:e}", stringify!($repeated), stringify!($module));
            let redundant = (at.closure().redundant(), out.closure().redundant());
            assert_eq!(redundant, ($redundant, $redundant), "{label}");
            let wrench = |point: mstmm::Point<$scalar>| [point.force(), point.moment()];
            let reactions = [wrench(at.d().input()), wrench(out.d().input())];
            let size = reactions[1].iter().fold(1.0, |size, part| part.norm().max(size));
            let off = reactions[0].iter().zip(&reactions[1]);
            let off = off.map(|(a, b)| (a - b).norm() / size).fold(0.0, <$scalar>::max);
            let tolerance = TOLERANCE * f64::from(<$scalar>::EPSILON);
            assert!(f64::from(off) < tolerance, "{label}: reactions off by {off:e}");
            let accelerations = (at.accelerations() - out.accelerations()).amax();
            let size = out.accelerations().amax().max(1.0);
            let off = f64::from(accelerations / size);
            assert!(off < tolerance, "{label}: accelerations off by {off:e}");
        }
    };
}

macro_rules! compare_both {
    ($scalar:ty, $sarrus:expr, $bennett:expr) => {
        compare!($scalar, riccati, Sarrus, SarrusOut, sarrus, $sarrus, 1);
        compare!($scalar, transfer, Sarrus, SarrusOut, sarrus, $sarrus, 1);
        compare!($scalar, riccati, Bennett, BennettOut, bennett, $bennett, 3);
        compare!($scalar, transfer, Bennett, BennettOut, bennett, $bennett, 3);
    };
}

#[test]
fn redundant_closures_of_repeated_bars() {
    compare_both!(f64, [0.3, 0.7, 1.2], [2.5, 0.8, 1e-3, 1e-6, 1e-9, 1e-12, -1e-9]);
}

#[test]
fn redundant_closures_of_repeated_bars_in_single_precision() {
    compare_both!(f32, [0.3, 0.7, 1.2], [2.5, 0.8, 1e-3, 1e-5, -1e-4]);
}

/// Three seconds under gravity, through flat positions.
#[test]
fn linkages_of_repeated_bars_keep_their_energy() {
    let chain = riccati::Bennett::<f64>::new();
    let mut state = state(&chain, &bennett(0.5));
    state.rates_mut().iter_mut().for_each(|rate| *rate *= 6.0);
    let total = |state: &_| chain.energy(state).total();
    let (start, kinetic) = (total(&state), chain.energy(&state).kinetic);
    let mut rk4 = Rk4::new(1e-3);
    let (mut worst, mut flat) = (0.0_f64, 0);
    for _ in 0..3000 {
        let before = state.a().angle().sin();
        rk4.step(&chain, &mut state, |_, _| chain.no_inputs()).expect("a step");
        worst = worst.max((total(&state) - start).abs() / kinetic);
        flat += usize::from(before.signum() != state.a().angle().sin().signum());
    }
    println!("energy off by {worst:.1e}, {flat} flat positions");
    assert!(worst < 1e-8 && flat >= 2);
}
