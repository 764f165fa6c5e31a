//! One system, written in space, in a plane and on a line, has the same motion; a line of masses and
//! springs, [P, Section 4.4], compared with its modes.

mod support;

use mstmm::GeneratedChain;
use mstmm::prelude::*;
use mstmm_reference::Random;
use std::f64::consts::PI;
use support::difference;

/// The same operations in another order, some hundred of them in a state of a condition of ten.
const TOLERANCE: f64 = 1e-13;

mstmm_chain! {
    /// Two links, one on a slider, with motors, springs, rotors, a load and a spring to the ground.
    chain InSpace {
        gravity = [1, -9.8, 0] m/s^2;
        body Link {
            mass = 1.5 kg;
            com = [0.2, -0.1, 0] m;
            output = [0.5, 0.1, 0] m turned rpy(0, 0, 20) deg;
            inertia = diag(0.1, 0.12, 0.09) kg*m^2 about com;
        }
        ground at [0.1, 0.2, 0] m turned rpy(0, 0, 30) deg -> pin shoulder -> Link upper
            -> planar sheet -> Link middle -> slider([1, 2, 0]) rail -> Link lower;
        hinge shoulder {
            stiffness = 20; damping = 1; armature = 0.2; limits = [-1, 1]; limit_stiffness = 50;
        }
        hinge sheet { stiffness = [90, 80]; turning_stiffness = 9; damping = 1; armature = 0.1; }
        hinge rail { stiffness = 50; rest = 0.1 m; friction = 1; friction_speed = 0.3; }
        load push {
            on = lower; at = output; force = [3, 4, 0] N; torque = [0, 0, 2] N*m; axes = body;
        }
        spring rope {
            on = lower; at = com; to = [1, 1, 0] m; stiffness = 30; damping = 1; length = 0.4;
        }
    }
    plane chain InPlane {
        gravity = [1, -9.8] m/s^2;
        body Link {
            mass = 1.5 kg;
            com = [0.2, -0.1] m;
            output = [0.5, 0.1] m turned 20 deg;
            inertia = 0.09 kg*m^2 about com;
        }
        ground at [0.1, 0.2] m turned 30 deg -> pin shoulder -> Link upper -> planar sheet
            -> Link middle -> slider([1, 2]) rail -> Link lower;
        hinge shoulder {
            stiffness = 20; damping = 1; armature = 0.2; limits = [-1, 1]; limit_stiffness = 50;
        }
        hinge sheet { stiffness = [90, 80]; turning_stiffness = 9; damping = 1; armature = 0.1; }
        hinge rail { stiffness = 50; rest = 0.1 m; friction = 1; friction_speed = 0.3; }
        load push { on = lower; at = output; force = [3, 4] N; torque = 2 N*m; axes = body; }
        spring rope {
            on = lower; at = com; to = [1, 1] m; stiffness = 30; damping = 1; length = 0.4;
        }
    }

    /// Wagons, free at the front.
    chain TrainInSpace {
        gravity = [-0.5, -9.8, 1] m/s^2;
        body Wagon {
            mass = 2 kg; com = [0.1, 0.2, 0.3] m; output = [0.4, 0, 0] m;
            inertia = diag(0.1, 0.1, 0.1) kg*m^2 about com;
        }
        ground at [0.2, 0, 0] m -> slider(x) a -> Wagon first -> slider(x) b -> Wagon second
            -> slider(x) c -> Wagon third;
        hinge a, b, c { stiffness = 70; damping = 1; armature = 0.2; rest = 0.1 m; }
        load pull { on = third; force = [5, 0, 0] N; }
        spring buffer {
            on = second; at = output; to = [3, 0, 0] m; stiffness = 60; damping = 2; length = 1 m;
        }
    }
    plane chain TrainInPlane {
        gravity = [-0.5, -9.8] m/s^2;
        body Wagon {
            mass = 2 kg; com = [0.1, 0.2] m; output = [0.4, 0] m; inertia = 0.1 kg*m^2 about com;
        }
        ground at [0.2, 0] m -> slider a -> Wagon first -> slider b -> Wagon second
            -> slider c -> Wagon third;
        hinge a, b, c { stiffness = 70; damping = 1; armature = 0.2; rest = 0.1 m; }
        load pull { on = third; force = [5, 0] N; }
        spring buffer {
            on = second; at = output; to = [3, 0] m; stiffness = 60; damping = 2; length = 1 m;
        }
    }
    line chain TrainOnLine {
        gravity = -0.5 m/s^2;
        body Wagon { mass = 2 kg; com = 0.1 m; output = 0.4 m; }
        ground at 0.2 m -> slider a -> Wagon first -> elastic b -> Wagon second
            -> floating c -> Wagon third;
        hinge a, b, c { stiffness = 70; damping = 1; armature = 0.2; rest = 0.1 m; }
        load pull { on = third; force = 5 N; }
        spring buffer {
            on = second; at = output; to = 3 m; stiffness = 60; damping = 2; length = 1 m;
        }
    }
}

/// Compares accelerations in many states, and the states after a second of a thousand steps.
fn alike<A, B>(name: &str, first: &A, second: &B)
where
    A: GeneratedChain<Scalar = f64>,
    B: GeneratedChain<Scalar = f64>,
{
    let [mut at_once, mut later] = [0.0_f64; 2];
    for seed in 0..20 {
        let mut random = Random::new(seed);
        let (mut one, mut other) = (first.initial_state(), second.initial_state());
        one.coordinates_mut().iter_mut().for_each(|q| *q = random.between(-0.5, 0.5));
        one.rates_mut().iter_mut().for_each(|v| *v = random.between(-1.0, 1.0));
        other.coordinates_mut().copy_from_slice(one.coordinates());
        other.rates_mut().copy_from_slice(one.rates());
        let (mut a, mut b) = (first.initial_state(), second.initial_state());
        first.derivative_into(&one, &first.no_inputs(), &mut a).expect("a regular chain");
        second.derivative_into(&other, &second.no_inputs(), &mut b).expect("a regular chain");
        at_once = at_once.max(difference(a.rates(), b.rates()));
        Rk4::new(1e-3).advance_to(first, &mut one, 1.0, |_, _| first.no_inputs()).expect("steps");
        Rk4::new(1e-3)
            .advance_to(second, &mut other, 1.0, |_, _| second.no_inputs())
            .expect("steps");
        later = later.max(difference(
            &[one.coordinates(), one.rates()].concat(),
            &[other.coordinates(), other.rates()].concat(),
        ));
        assert!(
            at_once < TOLERANCE && later < TOLERANCE,
            "{name}, seed {seed}: {at_once:e} {later:e}"
        );
    }
    println!("{name}: off by {at_once:.1e}, {later:.1e} after a second");
}

#[test]
fn a_plane_system_moves_in_space_as_in_the_plane() {
    alike("arm", &InSpace::<f64>::new(), &InPlane::<f64>::new());
}

#[test]
fn a_line_of_masses_moves_alike_everywhere() {
    let (space, plane) = (TrainInSpace::<f64>::new(), TrainInPlane::<f64>::new());
    let line = TrainOnLine::<f64>::new();
    alike("train in space and in the plane", &space, &plane);
    alike("train in the plane and on the line", &plane, &line);
}

macro_rules! masses_and_springs {
    ($name:ident $rest:literal) => {
        mstmm_chain! { line chain $name {
            body Mass { mass = 0.1 kg; output = 0 m; }
            ground -> slider s1 -> Mass b2 -> elastic s3 -> Mass b4 -> elastic s5 -> Mass b6
                -> elastic s7 -> Mass b8 -> elastic s9 -> Mass b10;
            hinge s1, s3, s5, s7, s9 { start = 0.1 m; rest = $rest m; stiffness = 1000 N/m; }
            load pull { on = b2; force = 100 N; }
        } }
    };
}

// The springs of [P, Eq. (48)] to the letter, and springs that are at rest at first.
masses_and_springs! { Literal 0 }
masses_and_springs! { AtRest 0.1 }

/// Positions of all five masses: with one end held and one free, mode j of n = 5 masses has the
/// shape sin(i (2j − 1) π / (2n + 1)) and ω = 2 √(k/m) sin((2j − 1) π / (2 (2n + 1))).
fn modal(time: f64, rest: f64) -> [f64; 5] {
    let (mass, stiffness) = (0.1, 1000.0);
    let phase = |mode: usize| f64::from(2 * mode as u32 + 1) * PI / 11.0;
    let shape = |mode: usize, body: usize| (f64::from(body as u32 + 1) * phase(mode)).sin();
    // At equilibrium the first spring alone carries the load.
    let equilibrium = |body: usize| 0.1 + f64::from(body as u32 + 1) * rest;
    let start = |body: usize| 0.1 * f64::from(body as u32 + 1) - equilibrium(body);
    std::array::from_fn(|body| {
        let parts = (0..5).map(|mode| {
            let frequency = 2.0 * f64::sqrt(stiffness / mass) * (0.5 * phase(mode)).sin();
            let norm: f64 = (0..5).map(|i| shape(mode, i).powi(2)).sum();
            let amplitude: f64 = (0..5).map(|i| shape(mode, i) * start(i)).sum::<f64>() / norm;
            amplitude * shape(mode, body) * (frequency * time).cos()
        });
        equilibrium(body) + parts.sum::<f64>()
    })
}

/// The exact solution from a separate program in Python: time, then the positions of `Literal`
/// and of `AtRest`.
const EXACT: [(f64, [f64; 5], [f64; 5]); 2] = [
    (
        0.1,
        [
            0.045318570324841864,
            -0.03146912859898225,
            -0.10978115593273369,
            -0.17522469396994067,
            -0.24432705806712612,
        ],
        [
            0.23131593248523144,
            0.3783120273337506,
            0.510915304475798,
            0.6237837937723426,
            0.685997362160389,
        ],
    ),
    (
        5.0,
        [
            -0.01568224228833037,
            -0.055916860633125225,
            -0.07113948237662633,
            -0.06552317828697299,
            -0.017661825730631468,
        ],
        [
            0.18763635035630669,
            0.3152226217435004,
            0.44698196389883355,
            0.5678208897319879,
            0.7033185926446363,
        ],
    ),
];

/// Some hundred oscillations of tolerance 10⁻¹³ a step.
#[test]
fn masses_and_springs_move_in_their_modes() {
    let (literal, at_rest) = (Literal::<f64>::new(), AtRest::<f64>::new());
    let (mut state, mut same) = (literal.initial_state(), at_rest.initial_state());
    let mut methods = (Dopri5::new(1e-13, 1e-13), Dopri5::new(1e-13, 1e-13));
    let positions = |q: &[f64]| -> Vec<f64> {
        q.iter()
            .scan(0.0, |place, q| {
                *place += q;
                Some(*place)
            })
            .collect()
    };
    for (time, exact, exact_at_rest) in EXACT {
        methods
            .0
            .advance_to(&literal, &mut state, time, |_, _| literal.no_inputs())
            .expect("steps");
        methods.1.advance_to(&at_rest, &mut same, time, |_, _| at_rest.no_inputs()).expect("steps");
        for (found, modes, exact) in [
            (positions(state.coordinates()), modal(time, 0.0), exact),
            (positions(same.coordinates()), modal(time, 0.1), exact_at_rest),
        ] {
            let (off, from_modes) = (difference(&found, &exact), difference(&modes, &exact));
            println!("at {time} s: off by {off:.1e}; modes by {from_modes:.1e}");
            assert!(off < 1e-10 && from_modes < 1e-12);
        }
    }
}
