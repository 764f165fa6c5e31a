//! States, parameters and connection points of trees by name and by index.

use mstmm::nalgebra::Vector3;
use mstmm::{Chain, ChainState, PinState, mstmm_chain};
use mstmm_reference::Random;

mstmm_chain! {
    chain Ladder {
        gravity = [0, 0, -9.81] m/s^2;
        param person[3] = 0 kg;
        body Beam {
            mass = 5 kg;
            com = [0, 0, 0] m;
            inertia = diag(0.1, 0.01, 0.1) kg*m^2 about com;
            output = [0, 0, -0.1] m;
            point side = [0, 0.5, 0] m;
        }
        body Link {
            mass = 1 kg;
            com = [0, 0, -0.15] m;
            inertia = diag(0.03, 0.03, 0.01) kg*m^2 about com;
            output = [0, 0, -0.3] m;
            point left = [0, 0.02, -0.3] m;
            point right = [0, -0.02, -0.3] m;
        }
        body Rung {
            mass = 0.3 kg + person;
            com = [0, 0.09, 0] m;
            output = [0, 0.09, 0] m;
            inertia = diag(0.01, 0.01, 0.01) kg*m^2 about com;
        }
        body Plain {
            mass = 0.3 kg;
            com = [0, -0.09, 0] m;
            output = [0, -0.18, 0] m;
            inertia = diag(0.01, 0.01, 0.01) kg*m^2 about com;
        }
        part Leg(side) {
            pin([0, side, 0]) hip -> Plain thigh -> pin(y) knee -> Plain shank;
            hinge hip { torque = input; start = side*10 deg; }
        }
        Beam beam -> repeat 3 {
            ball knot -> Link link;
            link.left -> pin(x) a -> Rung rung;
            link.right -> Leg(-1) leg;
        };
        beam.side -> Leg(1) front;
        hinge a { torque = input; }
    }
}

/// The names of hinges in the order of the text with everything written out.
#[test]
fn coordinates_are_in_the_order_of_the_text_written_out() {
    let mut state = LadderState::<f64>::default();
    state.set_each_a(|index| PinState::new(10.0 + index as f64, 20.0 + index as f64));
    for index in 0..3 {
        let number = index as f64;
        state
            .leg_hip_mut(index)
            .expect("of three")
            .set_angle(30.0 + number)
            .set_rate(40.0 + number);
        state.leg_knee_mut(index).expect("of three").set_angle(50.0).set_rate(60.0 + number);
    }
    state.front_hip_mut().set_angle(70.0).set_rate(80.0);
    state.front_knee_mut().set_angle(71.0).set_rate(81.0);
    assert!(state.leg_hip(3).is_none() && state.a_mut(usize::MAX).is_none());
    assert_eq!(state.a(2), Some(PinState::new(12.0, 22.0)));
    assert_eq!(state.front_knee(), PinState::new(71.0, 81.0));

    let mut q = vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    let mut v = vec![0.0; 6];
    for number in [0.0, 1.0, 2.0] {
        q.extend([1.0, 0.0, 0.0, 0.0, 10.0 + number, 30.0 + number, 50.0]);
        v.extend([0.0, 0.0, 0.0, 20.0 + number, 40.0 + number, 60.0 + number]);
    }
    q.extend([70.0, 71.0]);
    v.extend([80.0, 81.0]);
    assert_eq!((state.coordinates(), state.rates()), (&q[..], &v[..]));

    // Starts depend on the arguments of parts.
    let start = Ladder::<f64>::new().initial_state();
    let ten = 10_f64.to_radians();
    assert_eq!(start.leg_hip(1).expect("of three").angle(), -ten);
    assert_eq!(start.front_hip().angle(), ten);
}

fn random_state(random: &mut Random) -> LadderState<f64> {
    let mut state = LadderState::zero_position();
    state.coordinates_mut().iter_mut().for_each(|q| *q += random.between(-0.5, 0.5));
    state.rates_mut().iter_mut().for_each(|v| *v += random.between(-2.0, 2.0));
    Ladder::<f64>::new().normalize(&mut state);
    state
}

#[test]
fn parameters_and_inputs_belong_to_their_repetitions() {
    let mut chain = Ladder::<f64>::new();
    let empty = Ladder::<f64>::new();
    let mut at = chain.workspace();
    for seed in 0..9 {
        let state = random_state(&mut Random::new(seed));
        let index = usize::try_from(seed % 3).expect("small");
        let mass = 10.0;
        chain.set_person(|k| if k == index { mass } else { 0.0 }).expect("masses");
        chain.solve_into(&state, &chain.no_inputs(), &mut at).expect("a regular tree");
        // The person's place is the output of the rung.
        let rung = at.rung(index).expect("of three").output();
        let change = [chain.energy(&state), empty.energy(&state)];
        let potential = change[0].potential - change[1].potential;
        let expected = mass * 9.81 * rung.position().z;
        // A difference of energies of some hundred J.
        assert!((potential - expected).abs() < 1e-12 * 1e3, "seed {seed}: {potential} {expected}");
        let kinetic = change[0].kinetic - change[1].kinetic;
        let expected = 0.5 * mass * rung.velocity().norm_squared();
        assert!((kinetic - expected).abs() < 1e-12 * 1e3, "seed {seed}: {kinetic} {expected}");
    }
    // A torque is reported at its hinge.
    let (mut at, state) = (empty.workspace(), random_state(&mut Random::new(9)));
    let mut inputs = empty.no_inputs();
    inputs.a = [1.0, 2.0, 3.0];
    inputs.leg_hip = [4.0, 5.0, 6.0];
    inputs.front_hip = 7.0;
    empty.solve_into(&state, &inputs, &mut at).expect("a regular tree");
    let torque = |point: mstmm::Point<f64>, axis: [f64; 3]| {
        // The torque acts on the outboard side: minus the moment, which acts on the inboard side.
        -(point.orientation().inverse() * point.moment()).dot(&Vector3::from(axis))
    };
    for index in 0..3 {
        let (a, hip) = (at.a(index).expect("of three"), at.leg_hip(index).expect("of three"));
        let found = [torque(a.output(), [1.0, 0.0, 0.0]), torque(hip.output(), [0.0, -1.0, 0.0])];
        let expected = [inputs.a[index], inputs.leg_hip[index]];
        let off = [found[0] - expected[0], found[1] - expected[1]].map(f64::abs);
        assert!(off[0].max(off[1]) < 1e-12, "{index}: {found:?} {expected:?}");
    }
    let found = torque(at.front_hip().output(), [0.0, 1.0, 0.0]);
    assert!((found - 7.0).abs() < 1e-12, "{found}");
}

/// The points of each element in the order of the text written out; named points that hinges leave
/// follow the output of their body.
#[test]
fn points_are_in_the_order_of_the_text_written_out() {
    let chain = Ladder::<f64>::new();
    let mut at = chain.workspace();
    let state = random_state(&mut Random::new(1));
    chain.solve_into(&state, &chain.no_inputs(), &mut at).expect("a regular tree");
    let mut expected = vec![at.beam().input(), at.beam().output(), at.beam().side()];
    for k in 0..3 {
        let (knot, link) = (at.knot(k).expect("of three"), at.link(k).expect("of three"));
        expected.extend([knot.output(), link.output(), link.left(), link.right()]);
        let (a, rung) = (at.a(k).expect("of three"), at.rung(k).expect("of three"));
        expected.extend([a.output(), rung.output()]);
        let (hip, thigh) = (at.leg_hip(k).expect("of three"), at.leg_thigh(k).expect("of three"));
        expected.extend([hip.output(), thigh.output()]);
        let (knee, shank) = (at.leg_knee(k).expect("of three"), at.leg_shank(k).expect("of three"));
        expected.extend([knee.output(), shank.output()]);
    }
    expected.extend([at.front_hip().output(), at.front_thigh().output()]);
    expected.extend([at.front_knee().output(), at.front_shank().output()]);
    let points = at.points();
    assert_eq!(points.len(), expected.len());
    for (index, (point, expected)) in points.iter().zip(expected).enumerate() {
        assert_eq!(*point, expected, "point {index}");
    }
}

/// Nothing remains of earlier calls.
#[test]
fn repeated_calls_give_the_same_bits() {
    let chain = Ladder::<f64>::new();
    let state = random_state(&mut Random::new(1));
    let (mut at, mut rate) = (chain.workspace(), state.clone());
    chain.solve_into(&state, &chain.no_inputs(), &mut at).expect("a regular tree");
    chain.derivative_into(&state, &chain.no_inputs(), &mut rate).expect("a regular tree");
    let first = (format!("{at:?}"), format!("{rate:?}"));
    for seed in 2..5 {
        let other = random_state(&mut Random::new(seed));
        chain.solve_into(&other, &chain.no_inputs(), &mut at).expect("a regular tree");
        chain.derivative_into(&other, &chain.no_inputs(), &mut rate).expect("a regular tree");
        assert_ne!(first, (format!("{at:?}"), format!("{rate:?}")));
    }
    chain.solve_into(&state, &chain.no_inputs(), &mut at).expect("a regular tree");
    chain.derivative_into(&state, &chain.no_inputs(), &mut rate).expect("a regular tree");
    assert_eq!(first, (format!("{at:?}"), format!("{rate:?}")));
}
