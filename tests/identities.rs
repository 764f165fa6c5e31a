//! Laws that hold for any mechanism, tested on generated chains with motors, held at the start, at the end
//! and floating, by both methods: power, momentum, the balance of every body, and the state vectors at
//! hinges and ends.

mod support;

use mstmm::{ChainState, Dopri5, Dual, Error};
use mstmm_reference::Random;
use nalgebra::{UnitQuaternion, Vector3};
use support::difference;
use support::matter::{Lump, ends, momenta, momentum_rate};
use support::mechanism::{Answer, Mechanism, both};
use support::moving;

/// Random states tried for each chain.
const STATES: u64 = 50;

/// The chains here have three bodies of like masses, with condition numbers of some thousands;
/// a hundred roundings on the way leave 1e3 · 1e2 · 1e-16 relative to the largest term.
const TOLERANCE: f64 = 1e-11;

const GRAVITY: [f64; 3] = [1.0, -9.8, 2.0];

const HUB: Lump =
    Lump { mass: 2.0, com: [0.1, 0.2, -0.3], inertia: [0.5, 0.6, 0.7, 0.05, -0.02, 0.1] };
const ROD: Lump =
    Lump { mass: 1.0, com: [0.5, 0.0, 0.0], inertia: [0.02, 0.09, 0.1, 0.0, 0.0, 0.0] };
const TIP: Lump =
    Lump { mass: 0.5, com: [0.0, -0.2, 0.4], inertia: [0.06, 0.05, 0.04, 0.0, 0.01, 0.0] };
/// In the order of all chains here.
const BODIES: [Lump; 3] = [HUB, ROD, TIP];

/// The bodies above as the descriptions have them, in front of `route`.
macro_rules! of_three_bodies {
    ($riccati:ident $transfer:ident $hinges:tt { $($route:tt)* }) => {
        both! { $riccati $transfer $hinges {
            param lightness = 1;
            gravity = [1 * lightness, -9.8 * lightness, 2 * lightness] m/s^2;
            body Hub {
                mass = 2 kg;
                com = [0.1, 0.2, -0.3] m;
                output = [0.3, 0.8, 0] m turned rpy(20, -50, 110) deg;
                inertia = tensor(0.5, 0.6, 0.7, 0.05, -0.02, 0.1) kg*m^2 about com;
            }
            body Rod {
                mass = 1 kg;
                com = [0.5, 0, 0] m;
                output = [1, 0, 0] m turned rpy(90, 0, 0) deg;
                inertia = diag(0.02, 0.09, 0.1) kg*m^2 about com;
            }
            body Tip {
                mass = 0.5 kg;
                com = [0, -0.2, 0.4] m;
                output = [0, 0, 0.7] m;
                inertia = tensor(0.06, 0.05, 0.04, 0, 0.01, 0) kg*m^2 about com;
            }
            $($route)*
        } }
    };
}

of_three_bodies! { Held HeldByTransfer [Pin, Ball, Pin] {
    ground at [0.2, 0.1, -0.4] m turned rpy(0, 30, 0) deg
        -> pin([1, 2, -1]) base -> Hub hub -> ball elbow -> Rod rod -> pin(y) wrist -> Tip tip;
    hinge base, elbow, wrist { torque = input; }
} }

of_three_bodies! { Adrift AdriftByTransfer [Floating, Ball, Pin] {
    Hub hub -> ball elbow -> Rod rod -> pin(y) wrist -> Tip tip;
    hinge elbow, wrist { torque = input; }
} }

of_three_bodies! { Hanging HangingByTransfer [Pin, Pin, Ball] {
    Hub hub -> pin(x) elbow -> Rod rod -> pin([0, 1, 1]) wrist -> Tip tip
        -> ball base -> ground at [0, 1, 0] m turned rpy(0, 0, 45) deg;
    hinge elbow, wrist, base { torque = input; }
} }

/// The interface of a chain in these tests, in addition to the common interface.
trait Driven: Mechanism {
    /// The index of the first body's input among the points.
    const FIRST: usize;
    /// Which ends are free: 0 the start, 1 the finish.
    const FREE_ENDS: &'static [usize];

    fn random_inputs(&self, random: &mut Random) -> Self::Inputs;
    /// Σ effort · rate over all hinges, from the workspace.
    fn power(&self, state: &Self::State, inputs: &Self::Inputs) -> f64;
    /// The rate of the total energy, with the state moving as the chain says.
    fn energy_rate(&self, state: &Self::State, inputs: &Self::Inputs) -> f64;
}

/// Implements [`Driven`] from the names of pins and balls that have motors.
macro_rules! driven {
    ($(
        $name:ident $first:literal free $free:tt
        pins [$($pin:ident),*] balls [$($ball:ident),*];
    )*) => { $(
        impl Driven for $name<f64> {
            const FIRST: usize = $first;
            const FREE_ENDS: &'static [usize] = &$free;

            fn random_inputs(&self, random: &mut Random) -> Self::Inputs {
                let mut inputs = self.no_inputs();
                $( inputs.$pin = random.between(-5.0, 5.0); )*
                $( inputs.$ball = Vector3::from_fn(|_, _| random.between(-5.0, 5.0)).into(); )*
                inputs
            }

            fn power(&self, state: &Self::State, inputs: &Self::Inputs) -> f64 {
                let mut at = self.workspace();
                self.solve_into(state, inputs, &mut at).expect("a regular chain");
                0.0 $( + at.$pin().effort() * state.$pin().rate() )*
                    $( + at.$ball().effort().dot(&state.$ball().rate()) )*
            }

            fn energy_rate(&self, state: &Self::State, inputs: &Self::Inputs) -> f64 {
                moving::energy_rate(self, &$name::<Dual<f64>>::new(), state, inputs)
            }
        }
    )* };
}

driven! {
    Held 1 free [1] pins [base, wrist] balls [elbow];
    HeldByTransfer 1 free [1] pins [base, wrist] balls [elbow];
    Adrift 0 free [0, 1] pins [wrist] balls [elbow];
    AdriftByTransfer 0 free [0, 1] pins [wrist] balls [elbow];
    Hanging 0 free [0] pins [elbow, wrist] balls [base];
    HangingByTransfer 0 free [0] pins [elbow, wrist] balls [base];
}

/// Runs a check in many states of every chain; the last argument is for messages.
macro_rules! in_all_chains {
    ($check:ident) => {
        $check::<Held<f64>>("Held");
        $check::<HeldByTransfer<f64>>("HeldByTransfer");
        $check::<Adrift<f64>>("Adrift");
        $check::<AdriftByTransfer<f64>>("AdriftByTransfer");
        $check::<Hanging<f64>>("Hanging");
        $check::<HangingByTransfer<f64>>("HangingByTransfer");
    };
}

/// Calls `check` with random states and inputs; it returns an error that must be within tolerance.
fn in_many_states<C: Driven>(name: &str, check: impl Fn(&C, &C::State, &C::Inputs) -> f64) {
    let chain = C::default();
    let mut largest = 0.0;
    for seed in 0..STATES {
        let mut random = Random::new(seed);
        let state = chain.random_state(&mut random);
        let inputs = chain.random_inputs(&mut random);
        let off = check(&chain, &state, &inputs);
        assert!(off <= TOLERANCE, "{name}, seed {seed}: off by {off:e}");
        largest = support::worst(largest, off);
    }
    println!("{name}: off by {largest:.1e} at most");
}

fn solved<C: Driven>(chain: &C, state: &C::State, inputs: &C::Inputs) -> Answer {
    chain.answer(state, inputs).expect("a regular chain")
}

/// The rate of the energy is exact, by dual numbers; no hinge does work but its motor.
#[test]
fn energy_changes_by_the_power_of_the_motors() {
    fn check<C: Driven>(name: &str) {
        in_many_states::<C>(name, |chain, state, inputs| {
            difference(&[chain.energy_rate(state, inputs)], &[chain.power(state, inputs)])
        });
    }
    in_all_chains!(check);
}

#[test]
fn every_body_is_in_balance_with_the_wrenches_at_its_ends() {
    fn check<C: Driven>(name: &str) {
        in_many_states::<C>(name, |chain, state, inputs| {
            let points = solved(chain, state, inputs).points;
            let bodies = BODIES.iter().zip(ends(&points, C::FIRST));
            bodies.map(|(body, ends)| body.imbalance(ends, GRAVITY)).fold(0.0, support::worst)
        });
    }
    in_all_chains!(check);
}

/// Both sides of a pin or ball have the same position and transmit the same wrench; a free end transmits none.
#[test]
fn hinges_pass_on_everything_and_free_ends_nothing() {
    fn check<C: Driven>(name: &str) {
        in_many_states::<C>(name, |chain, state, inputs| {
            let points = solved(chain, state, inputs).points;
            let hinges = points[1 - C::FIRST..].windows(2).step_by(2);
            let both_sides = hinges.map(|pair| {
                let entries = |k: usize| {
                    let point = &pair[k];
                    let vectors = [
                        point.position(),
                        point.velocity(),
                        point.acceleration(),
                        point.force(),
                        point.moment(),
                    ];
                    vectors.map(<[f64; 3]>::from).concat()
                };
                difference(&entries(0), &entries(1))
            });
            let load = |point: &mstmm::Point<f64>| {
                [point.force(), point.moment()].map(<[f64; 3]>::from).concat()
            };
            let free_ends = C::FREE_ENDS.iter().map(|&end| {
                let at_end = [&points[0], &points[points.len() - 1]][end];
                let largest = points.iter().flat_map(load).fold(1.0, |m: f64, x| m.max(x.abs()));
                load(at_end).iter().map(|x| x.abs() / largest).fold(0.0, support::worst)
            });
            both_sides.chain(free_ends).fold(0.0, support::worst)
        });
    }
    in_all_chains!(check);
}

/// The torque on the outboard body is −m; along free axes it is the motor's torque.
#[test]
fn moments_along_free_directions_are_the_efforts() {
    let chain = Held::<f64>::new();
    let mut at = chain.workspace();
    for seed in 0..STATES {
        let mut random = Random::new(seed);
        let state = chain.random_state(&mut random);
        let inputs = chain.random_inputs(&mut random);
        chain.solve_into(&state, &inputs, &mut at).expect("a regular chain");
        let free = |of: &mstmm::Point<f64>| of.orientation().inverse() * -of.moment();
        let axis = Vector3::new(1.0, 2.0, -1.0).normalize();
        let elbow = free(&at.elbow().output());
        let computed = [
            free(&at.base().output()).dot(&axis),
            elbow.x,
            elbow.y,
            elbow.z,
            free(&at.wrist().output()).y,
        ];
        let [x, y, z] = inputs.elbow.into();
        let expected = [inputs.base, x, y, z, inputs.wrist];
        // Moments along the axis are small differences of moments of up to a few hundred.
        let largest = at.points().iter().fold(1.0_f64, |m, p| m.max(p.moment().norm()));
        let off = difference(&computed, &expected);
        assert!(off <= TOLERANCE * largest, "seed {seed}: {off:e}");
        assert_eq!([at.base().effort(), at.wrist().effort()], [inputs.base, inputs.wrist]);
        assert_eq!(at.elbow().effort(), Vector3::from([x, y, z]));
    }
}

#[test]
fn partial_functions_equal_the_full_solution() {
    fn check<C: Driven>(name: &str) {
        in_many_states::<C>(name, |chain, state, inputs| {
            let answer = solved(chain, state, inputs);
            let mut rate = state.clone();
            chain.derivative_into(state, inputs, &mut rate).expect("a regular chain");
            let fast = chain.fast_energy(state);
            let energies = |e: mstmm::Energy<f64>| [e.kinetic, e.potential, e.total()];
            [
                difference(&chain.fast_accelerations(state, inputs), &answer.accelerations),
                difference(rate.rates(), &answer.accelerations),
                difference(&energies(fast), &energies(answer.energy)),
            ]
            .into_iter()
            .fold(0.0, support::worst)
        });
    }
    in_all_chains!(check);
}

#[test]
fn a_floating_chain_falls_as_a_whole() {
    fn check<C: Driven>(name: &str) {
        in_many_states::<C>(name, |chain, state, inputs| {
            let points = solved(chain, state, inputs).points;
            let rate: [f64; 3] = momentum_rate(&BODIES, &points, 0).into();
            let total: f64 = BODIES.iter().map(|body| body.mass).sum();
            difference(&rate, &GRAVITY.map(|g| total * g))
        });
    }
    check::<Adrift<f64>>("Adrift");
    check::<AdriftByTransfer<f64>>("AdriftByTransfer");
}

/// Motors act between bodies, so without gravity they change neither the momentum nor the angular momentum.
macro_rules! keeps_its_momenta {
    ($chain:ident) => {
        for seed in 0..5 {
            let mut random = Random::new(seed);
            let mut chain = $chain::<f64>::new();
            chain.set_lightness(0.0).expect("no gravity");
            let mut state = chain.random_state(&mut random);
            let inputs = chain.random_inputs(&mut random);
            let now = |chain: &$chain<f64>, state: &_| {
                let points = solved(chain, state, &inputs).points;
                momenta(&BODIES, &points, 0).map(<[f64; 3]>::from).concat()
            };
            let before = now(&chain, &state);
            Dopri5::new(1e-12, 1e-12)
                .advance_to(&chain, &mut state, 1.0, |_, _| inputs)
                .expect("steps");
            let off = difference(&now(&chain, &state), &before);
            // About a hundred steps of tolerance 1e-12 each, in units of momentum.
            assert!(off < 1e-10, "{}, seed {seed}: {off:e}", stringify!($chain));
        }
    };
}

#[test]
fn a_floating_chain_keeps_its_momenta_without_gravity() {
    keeps_its_momenta!(Adrift);
    keeps_its_momenta!(AdriftByTransfer);
}

#[test]
fn values_set_in_a_state_are_read_back() -> Result<(), Error> {
    let mut held = Held::<f64>::new().initial_state();
    held.base_mut().set_angle(0.3).set_rate(-0.7);
    held.elbow_mut().set_bryan_angles([0.1, -0.2, 0.5]).set_rate(Vector3::new(1.0, 2.0, 3.0));
    held.wrist_mut().set_angle(-4.0);
    assert_eq!((held.base().angle(), held.base().rate()), (0.3, -0.7));
    assert_eq!((held.wrist().angle(), held.wrist().rate()), (-4.0, 0.0));
    assert_eq!(held.elbow().rate(), Vector3::new(1.0, 2.0, 3.0));
    // nalgebra composes roll, pitch and yaw by itself.
    let expected = UnitQuaternion::from_euler_angles(0.1, -0.2, 0.5);
    assert!(held.elbow().orientation().angle_to(&expected) < 1e-15);
    assert_eq!(held.rates().to_vec(), [-0.7, 1.0, 2.0, 3.0, 0.0]);
    assert_eq!((held.coordinates()[0], held.coordinates()[5]), (0.3, -4.0));
    assert_eq!(held.coordinates()[1], expected.w);

    let mut adrift = Adrift::<f64>::new().initial_state();
    adrift
        .hub_mut()
        .set_position(Vector3::new(1.0, 2.0, 3.0))
        .set_orientation(expected)
        .set_velocity(Vector3::new(4.0, 5.0, 6.0))
        .set_rate(Vector3::new(7.0, 8.0, 9.0));
    assert_eq!(adrift.hub().position(), Vector3::new(1.0, 2.0, 3.0));
    assert_eq!(adrift.hub().orientation(), expected);
    assert_eq!(adrift.hub().velocity(), Vector3::new(4.0, 5.0, 6.0));
    assert_eq!(adrift.hub().rate(), Vector3::new(7.0, 8.0, 9.0));
    let orientation = [expected.w, expected.i, expected.j, expected.k];
    assert_eq!(adrift.coordinates()[..7].to_vec(), [&[1.0, 2.0, 3.0][..], &orientation].concat());
    assert_eq!(adrift.rates()[..6].to_vec(), [4.0, 5.0, 6.0, 7.0, 8.0, 9.0]);

    // What the accessors set is what the chain sees.
    let chain = Adrift::<f64>::new();
    let mut at = chain.workspace();
    chain.solve_into(&adrift, &chain.no_inputs(), &mut at)?;
    let hub = at.hub();
    assert!((hub.input().position() - Vector3::new(1.0, 2.0, 3.0)).norm() < 1e-15);
    // Turned into the body's axes and back: two sums of three products each of numbers up to nine.
    assert!((hub.input().velocity() - Vector3::new(4.0, 5.0, 6.0)).norm() < 2e-14);
    let spin = expected * Vector3::new(7.0, 8.0, 9.0);
    assert!((hub.input().angular_velocity() - spin).norm() < 1e-14);
    let turned =
        hub.input().orientation().into_inner() - expected.to_rotation_matrix().into_inner();
    assert!(turned.norm() < 1e-14);
    Ok(())
}
