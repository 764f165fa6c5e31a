//! All integrators on generated chains: their orders with quaternions and springs, with loops, with
//! prescribed hinges and with branches, the energy, and springs too stiff for the step.

mod support;

use mstmm::prelude::*;
use mstmm::{Error, GeneratedChain, HingeMotion, PinState};
use support::worst;

mstmm_chain! {
    /// Springs on quaternions, on angles, to the ground, and an elastic hinge.
    chain Sprung {
        gravity = [0, -9.8, 0] m/s^2;
        body Link {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com;
        }
        ground -> ball shoulder -> Link upper -> universal(y, z) elbow -> Link middle
            -> elastic wrist -> Link lower;
        hinge shoulder {
            start = rpy(0, 20, -30) deg; start_rate = [0.5, 1, 0] rad/s;
            stiffness = 20; damping = 1;
        }
        hinge elbow { start = [40, 10] deg; stiffness = 15; damping = 0.5; }
        hinge wrist {
            start_rate = [0.3, 0.1, -1] rad/s; stiffness = 400; damping = 3;
            turning_stiffness = 30; turning_damping = 0.5;
        }
        spring rope {
            on = lower; at = output; to = [1, 1, 1] m; stiffness = 30; damping = 1; length = 0.5 m;
        }
    }
    /// A loop with springs.
    plane chain Loop {
        gravity = [0, -9.8] m/s^2;
        body Crank {
            mass = 1 kg; com = [0.2, 0] m; inertia = 0.02 kg*m^2 about com; output = [0.4, 0] m;
        }
        body Coupler {
            mass = 2 kg; com = [0.5, 0.1] m; inertia = 0.2 kg*m^2 about com; output = [1.1, 0] m;
        }
        body Rocker {
            mass = 1.5 kg; com = [0.3, 0] m; inertia = 0.1 kg*m^2 about com; output = [0.7, 0] m;
        }
        ground -> pin a -> Crank crank -> pin b -> Coupler coupler -> pin c -> Rocker rocker
            -> pin d -> ground at [0.9, 0] m;
        hinge a { start = 60 deg; start_rate = 3 rad/s; }
        hinge b { start = -50 deg; stiffness = 5; damping = 0.3; }
        hinge c { start = -120 deg; }
        hinge d { start = 100 deg; stiffness = 3; damping = 0.2; }
    }
    /// A floating tree with two legs of a part, a spring between them, and a repeated part with a
    /// branch; one hinge of it has a prescribed motion.
    chain Branched {
        gravity = [0, -9.8, 0] m/s^2;
        body Trunk {
            mass = 3 kg;
            com = [0.1, 0, 0.05] m;
            output = [0.5, 0, 0] m;
            inertia = tensor(0.3, 0.4, 0.5, 0.01, 0.02, -0.03) kg*m^2 about com;
            point left = [0.2, 0.3, 0] m;
            point right = [0.2, -0.3, 0] m;
        }
        body Link {
            mass = 1 kg;
            com = [0.3, 0.1, 0] m;
            output = [0.6, 0, 0.2] m;
            inertia = diag(0.1, 0.12, 0.15) kg*m^2 about com;
        }
        part Leg(side) {
            universal(x, y) hip -> Link thigh -> pin(y) knee -> Link shank;
            hinge hip { start = [side*10, 20] deg; stiffness = 15; damping = 0.5; }
            hinge knee { start_rate = side*1 rad/s; stiffness = 20; damping = 0.3; }
        }
        Trunk trunk -> repeat 2 { ball a -> Link link; link.output -> pin(z) b -> Link rung; };
        trunk.left -> Leg(1) left;
        trunk.right -> pin(z) shaker -> Link arm -> Leg(-1) right;
        body trunk { start_rate = [0.3, 1, 0.2] rad/s; }
        hinge a { stiffness = 30; damping = 0.4; start_rate = [0.5, 0, 1] rad/s; }
        hinge b { stiffness = 10; }
        hinge shaker { motion = input; }
        spring cord {
            on = left.shank.output; to = right.shank.output; stiffness = 30; damping = 1; length = 0.5 m;
        }
    }
    /// A pendulum on a hinge with a prescribed motion.
    chain Shaken {
        gravity = [0, -9.8, 0] m/s^2;
        body Link {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com;
        }
        ground -> pin(y) shaker -> Link upper -> ball elbow -> Link lower;
        hinge shaker { motion = input; }
        hinge elbow { stiffness = 10; damping = 0.3; }
    }
}

/// θ = 0.6 sin 5t
fn shaking(time: f64) -> HingeMotion<PinState<f64>, f64> {
    let (sine, cosine) = (5.0 * time).sin_cos();
    let state = PinState::new(0.6 * sine, 3.0 * cosine);
    HingeMotion { state, acceleration: -15.0 * sine }
}

/// How a method is made for a step.
macro_rules! order {
    ($chain:expr, $inputs:expr, $method:ident, $steps:expr) => {{
        let chain = &$chain;
        let inputs = |time: f64, _: &_| $inputs(chain, time);
        let mut start = chain.initial_state();
        GeneratedChain::assemble(chain, &mut start, &$inputs(chain, 0.0)).expect("a closed chain");
        let mut exact = start.clone();
        Dopri5::new(1e-13, 1e-13).advance_to(chain, &mut exact, 0.5, inputs).expect("steps");
        let samples = $steps.map(|steps: u32| {
            let step = 0.5 / f64::from(steps);
            let (mut state, mut method) = (start.clone(), $method::new(step));
            for _ in 0..steps {
                method.step(chain, &mut state, inputs).expect("a step");
            }
            (step, apart(&state, &exact))
        });
        (slope(&samples), samples)
    }};
}

/// The largest difference of any coordinate or rate.
fn apart<S: ChainState<Scalar = f64>>(a: &S, b: &S) -> f64 {
    let pairs = a.coordinates().iter().zip(b.coordinates()).chain(a.rates().iter().zip(b.rates()));
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, worst)
}

/// The slope of log(error) over log(step), by least squares.
fn slope(samples: &[(f64, f64)]) -> f64 {
    let logs: Vec<(f64, f64)> = samples.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let count = logs.len() as f64;
    let mean = logs.iter().fold((0.0, 0.0), |m, l| (m.0 + l.0 / count, m.1 + l.1 / count));
    let along: f64 = logs.iter().map(|l| (l.0 - mean.0) * (l.1 - mean.1)).sum();
    along / logs.iter().map(|l| (l.0 - mean.0).powi(2)).sum::<f64>()
}

/// Steps so short that the leading term of the error dominates, with errors still above rounding.
#[test]
fn methods_have_their_orders() {
    macro_rules! check {
        ($name:literal, $chain:expr, $inputs:expr) => {
            let orders = [
                ("rk4", order!($chain, $inputs, Rk4, [100, 200, 400, 800]), 4.0),
                ("newmark", order!($chain, $inputs, Newmark, [200, 400, 800, 1600]), 2.0),
                (
                    "semi-implicit",
                    order!($chain, $inputs, SemiImplicitEuler, [1000, 2000, 4000, 8000]),
                    1.0,
                ),
                (
                    "linearly implicit",
                    order!($chain, $inputs, LinearlyImplicitEuler, [1000, 2000, 4000, 8000]),
                    1.0,
                ),
            ];
            for (method, (order, samples), expected) in orders {
                let (_, smallest) = samples[3];
                println!("{}, {method}: order {order:.2}, error down to {smallest:.1e}", $name);
                assert!((order - expected).abs() < 0.2, "{}, {method}: {order}", $name);
            }
        };
    }
    check!("springs", Sprung::<f64>::new(), |chain: &Sprung<f64>, _| chain.no_inputs());
    check!("loop", Loop::<f64>::new(), |chain: &Loop<f64>, _| chain.no_inputs());
    check!("shaken", Shaken::<f64>::new(), |_: &Shaken<f64>, time| ShakenInputs {
        shaker: shaking(time)
    });
    check!("branches", Branched::<f64>::new(), |_: &Branched<f64>, time| BranchedInputs {
        shaker: shaking(time)
    });
}

/// The error of order five over the number of evaluations.
#[test]
fn dopri5_has_order_five() {
    let chain = Sprung::<f64>::new();
    let run = |tolerance: f64| {
        let (mut state, mut dopri5) = (chain.initial_state(), Dopri5::new(tolerance, tolerance));
        dopri5.advance_to(&chain, &mut state, 0.5, |_, _| chain.no_inputs()).expect("steps");
        (state, dopri5.statistics().evaluations)
    };
    let (exact, _) = run(1e-13);
    let samples = [1e-6, 1e-7, 1e-8, 1e-9, 1e-10].map(|tolerance| {
        let (state, evaluations) = run(tolerance);
        (1.0 / f64::from(u32::try_from(evaluations).expect("few")), apart(&state, &exact))
    });
    let order = slope(&samples);
    println!("order {order:.2}");
    assert!((order - 5.0).abs() < 0.5, "{order}, {samples:?}");
}

/// Rounding exceeds smaller tolerances, so steps would be too short to end.
#[test]
fn dopri5_raises_tolerances_below_rounding() {
    let chain = Sprung::<f64>::new();
    let run = |tolerance: f64| {
        let (mut state, mut dopri5) = (chain.initial_state(), Dopri5::new(tolerance, 0.0));
        dopri5.advance_to(&chain, &mut state, 0.01, |_, _| chain.no_inputs()).expect("steps");
        (state, dopri5.statistics().evaluations)
    };
    assert_eq!(run(1e-30), run(4.0 * f64::EPSILON));
}

mstmm::mstmm_chain! {
    /// ω = 1 rad/s.
    line chain Oscillator {
        body Mass { mass = 2 kg; }
        ground -> slider spring -> Mass mass;
        hinge spring { start = 1 m; stiffness = 2 N/m; }
    }
}

/// The final energy and the largest change of energy of a method over a number of steps.
macro_rules! energies {
    ($method:expr, $steps:expr) => {{
        let chain = Oscillator::<f64>::new();
        let (mut state, mut method) = (chain.initial_state(), $method);
        let mut swing = 0.0_f64;
        for _ in 0..$steps {
            method.step(&chain, &mut state, |_, _| chain.no_inputs()).expect("a step");
            swing = swing.max((chain.energy(&state).total() - 1.0).abs());
        }
        (chain.energy(&state).total(), swing)
    }};
}

/// With hω = 0.2 a step loses (hω)⁶/72, (hω)⁸/128 or (hω)² of the energy, to a tenth of that: terms
/// of the next even order are (hω)² smaller. The semi-implicit method swings by hω/2 for ever.
#[test]
fn energy_goes_where_it_should() {
    let (h, steps) = (0.2_f64, 20_000);
    let lost = |(left, _): (f64, f64), steps: u32| -f64::ln(left) / f64::from(steps);
    let rk4 = lost(energies!(Rk4::new(h), steps), steps);
    let newmark = lost(energies!(Newmark::new(h), steps), steps);
    let implicit = lost(energies!(LinearlyImplicitEuler::new(h), 500), 500);
    let (_, swing) = energies!(SemiImplicitEuler::new(h), steps);
    println!("lost a step: {rk4:.2e}, {newmark:.2e}, {implicit:.2e}; swing {swing:.3}");
    for (found, expected) in
        [(rk4, h.powi(6) / 72.0), (newmark, h.powi(8) / 128.0), (implicit, h * h)]
    {
        assert!((found / expected - 1.0).abs() < 0.1, "{found:e} instead of {expected:e}");
    }
    assert!(swing < 1.2 * 0.5 * h, "{swing}");
}

mstmm::mstmm_chain! {
    /// A double pendulum without friction, whose accelerations depend on its rates.
    plane chain Pendulums {
        gravity = [0, -9.81] m/s^2;
        body Rod { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 1/12 kg*m^2 about com; }
        ground -> pin upper -> Rod first -> pin lower -> Rod second;
        hinge upper { start = -50 deg; }
    }
}

/// Both Euler methods take what depends on rates at the start of a step. Within a hundred seconds the energy changes by more
/// than the largest energy of motion. The other methods keep it.
#[test]
fn euler_methods_change_the_energy_of_a_double_pendulum() {
    let chain = Pendulums::<f64>::new();
    macro_rules! change {
        ($method:expr) => {{
            let (mut state, mut method) = (chain.initial_state(), $method);
            let before = chain.energy(&state).total();
            let mut largest = 0.0_f64;
            for _ in 0..10_000 {
                method.step(&chain, &mut state, |_, _| chain.no_inputs()).expect("a step");
                largest = largest.max((chain.energy(&state).total() - before).abs());
            }
            largest
        }};
    }
    let euler = [change!(SemiImplicitEuler::new(0.01)), change!(LinearlyImplicitEuler::new(0.01))];
    let others = [change!(Rk4::new(0.01)), change!(Newmark::new(0.01))];
    println!("changes in J: {euler:.2?}, {others:?}");
    // The height of both centres of mass above the lowest pose, times the weight.
    let motion = 9.81 * (0.5 + 1.5) * (1.0 - 40.0_f64.to_radians().cos());
    assert!(euler.iter().all(|&change| change > motion), "{euler:?}");
    assert!(others.iter().all(|&change| change < 1e-2), "{others:?}");
}

macro_rules! stiff {
    ($name:ident [$($elbow:tt)*] { $($fields:tt)* }) => {
        mstmm_chain! { chain $name {
            gravity = [0, -9.8, 0] m/s^2;
            body Link {
                mass = 1 kg;
                com = [0.5, 0, 0] m;
                output = [1, 0, 0] m;
                inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com;
            }
            ground -> pin(z) shoulder -> Link upper -> $($elbow)* elbow -> Link lower;
            $($fields)*
        } }
    };
}

stiff! { OnPin [pin(z)] { hinge elbow { stiffness = 1e8; } } }
stiff! { OnBall [ball] { hinge elbow { stiffness = 1e8; damping = 1e3; } } }
stiff! { OnElastic [elastic] { hinge elbow { stiffness = 1e8; turning_stiffness = 1e8; } } }
stiff! { OnLimits [pin(z)] {
    hinge elbow { limits = [-1e-6, 1e-6]; limit_stiffness = 1e8; limit_damping = 1e4; }
} }
stiff! { Welded [weld] {} }

/// With h = 1 ms and ω of 3·10⁴ rad/s, hω is thirty: explicit methods of any order gain a factor of
/// thousands a step. The linearly implicit one goes on as if the hinge were welded, to what the
/// spring gives way, some 20 N m / 10⁸ N m/rad, and first steps swing more.
#[test]
fn stiff_springs_do_not_limit_the_linearly_implicit_method() {
    fn check<C: GeneratedChain<Scalar = f64>>(name: &str, chain: &C) {
        let welded = Welded::<f64>::new();
        let (mut state, mut same) = (chain.initial_state(), welded.initial_state());
        let mut implicit = LinearlyImplicitEuler::new(1e-3);
        let mut beside = SemiImplicitEuler::new(1e-3);
        let mut off = 0.0;
        for _ in 0..2000 {
            implicit.step(chain, &mut state, |_, _| chain.no_inputs()).expect("a stable step");
            beside.step(&welded, &mut same, |_, _| welded.no_inputs()).expect("a step");
            off = worst(off, (state.coordinates()[0] - same.coordinates()[0]).abs());
        }
        println!("{name}: off from welded by {off:.1e}");
        assert!(off < 1e-5, "{name}: {off:e}");

        let (mut state, mut rk4) = (chain.initial_state(), Rk4::new(1e-3));
        let diverged = (0..200).any(|_| {
            let step = rk4.step(chain, &mut state, |_, _| chain.no_inputs());
            matches!(step, Err(Error::NotFinite(_))) || state.rates().iter().any(|v| v.abs() > 1e6)
        });
        assert!(diverged, "{name}: the explicit method should not manage");
    }
    check("pin", &OnPin::<f64>::new());
    check("ball", &OnBall::<f64>::new());
    check("elastic", &OnElastic::<f64>::new());
    check("limits", &OnLimits::<f64>::new());
}

mstmm_chain! {
    /// Friction stops this wheel within a tenth of a millisecond.
    plane chain Wheel {
        body Disc { mass = 0.4 kg; com = [0, 0] m; inertia = 2e-4 kg*m^2 about com; }
        ground -> pin axle -> Disc disc;
        hinge axle { torque = input; friction = 2 N*m; friction_speed = 0.05 rad/s; start_rate = 1 rad/s; }
    }

    /// The same on a ball.
    chain Globe {
        body Sphere {
            mass = 0.4 kg;
            com = [0, 0, 0] m;
            inertia = diag(2e-4, 2e-4, 2e-4) kg*m^2 about com;
        }
        ground -> ball socket -> Sphere sphere;
        hinge socket { friction = 2 N*m; friction_speed = 0.05 rad/s; start_rate = [0.6, 0, 0.8] rad/s; }
    }
}

/// `v⁺ = v / (1 + h f / (J √(v² + s²)))` with the friction speed s: friction never reverses a motion, however long the
/// step. Below the friction the wheel creeps at the rate that the docs state.
#[test]
fn friction_does_not_reverse_a_motion_in_a_linearly_implicit_step() {
    fn check<C: GeneratedChain<Scalar = f64>>(chain: &C) {
        for h in [1e-6, 1e-4, 1e-3, 0.3] {
            let (mut state, mut euler) = (chain.initial_state(), LinearlyImplicitEuler::new(h));
            for _ in 0..20 {
                let before = state.rates().to_vec();
                let speed: f64 = before.iter().map(|v| v * v).sum();
                let drag = 1.0 + h * 2.0 / (2e-4 * (speed + 0.05f64.powi(2)).sqrt());
                euler.step(chain, &mut state, |_, _| chain.no_inputs()).expect("a step");
                for (after, before) in state.rates().iter().zip(before) {
                    // A dozen operations.
                    let off = (after - before / drag).abs();
                    assert!(off <= 12.0 * f64::EPSILON * before.abs(), "h = {h}: {off:e}");
                }
            }
        }
    }
    check(&Wheel::<f64>::new());
    check(&Globe::<f64>::new());

    let wheel = Wheel::<f64>::new();
    let (mut state, mut euler) = (wheel.initial_state(), LinearlyImplicitEuler::new(0.3));
    for _ in 0..100 {
        let inputs = WheelInputs { axle: 1.0 };
        euler.step(&wheel, &mut state, |_, _| inputs).expect("a step");
    }
    let creep: f64 = 0.05 / 3f64.sqrt();
    assert!((state.axle().rate() - creep).abs() < 1e-9, "{}", state.axle().rate());
}
