//! Inputs and parameters by index compared with fields and setters.

use super::models::{
    Crawler, CrawlerInputs, Kinds, KindsInputs, Raft, RaftInputs, Rope, Train, TrainInputs,
};
use mstmm::nalgebra::{Vector2, Vector3, Vector6};
use mstmm::{ChainState, Described, Error, FloatingState, HingeMotion, PinState, SliderState};

/// Returns the numbers from one on, one for each input.
fn numbers<C: Described<Scalar = f64>>() -> Vec<f64> {
    (0..C::DESCRIPTION.inputs().len()).map(|index| 1.0 + index as f64).collect()
}

fn from_numbers<C: Described<Scalar = f64>>() -> C::Inputs {
    C::inputs_from_slice(&numbers::<C>()).expect("as many values as inputs")
}

/// Returns the value that an input with this name has among the numbers.
fn at<C: Described>(name: &str) -> f64 {
    1.0 + C::DESCRIPTION.input(name).expect(name) as f64
}

/// Returns the values at these names.
fn all<C: Described, const N: usize>(name: &str, components: [&str; N]) -> [f64; N] {
    components.map(|component| at::<C>(&format!("{name}.{component}")))
}

#[test]
fn slices_fill_the_fields_that_names_say() {
    type Of = Kinds<f64>;
    let three = |name: &str| all::<Of, 3>(name, ["x", "y", "z"]);
    let six = |name: &str, [first, second]: [&str; 2]| {
        let parts = [first, second].map(|part| three(&format!("{name}.{part}")));
        Vector6::from_iterator(parts.into_iter().flatten())
    };
    let expected = KindsInputs {
        gravity: Vector3::from(three("gravity")),
        deck: HingeMotion {
            state: FloatingState::new(
                three("deck.state.position"),
                all::<Of, 4>("deck.state.orientation", ["w", "x", "y", "z"]),
                three("deck.state.velocity"),
                three("deck.state.rate"),
            ),
            acceleration: six("deck.acceleration", ["linear", "angular"]),
        },
        a: at::<Of>("a"),
        b: Vector2::from(all::<Of, 2>("b", ["force", "torque"])),
        c: Vector2::from(all::<Of, 2>("c", ["x", "y"])),
        e: Vector2::from(all::<Of, 2>("e", ["x", "y"])),
        shaker: HingeMotion {
            state: PinState::new(at::<Of>("shaker.state.angle"), at::<Of>("shaker.state.rate")),
            acceleration: at::<Of>("shaker.acceleration"),
        },
        g: Vector3::from(three("g")),
        h: six("h", ["force", "torque"]),
        push_force: Vector3::from(three("push.force")),
        push_torque: Vector3::from(three("push.torque")),
    };
    assert_eq!(from_numbers::<Of>(), expected);
}

#[test]
fn repeated_inputs_are_entries_of_arrays() {
    type Of = Crawler<f64>;
    let three = |name: &str| Vector3::from(all::<Of, 3>(name, ["x", "y", "z"]));
    let expected = CrawlerInputs {
        b: [0, 1, 2].map(|k| at::<Of>(&format!("b[{k}]"))),
        left_knee: at::<Of>("left.knee"),
        right_knee: at::<Of>("right.knee"),
        left_kick_force: three("left.kick.force"),
        right_kick_force: three("right.kick.force"),
        push_force: [0, 1, 2].map(|k| three(&format!("push[{k}].force"))),
        steer_torque: three("steer.torque"),
    };
    assert_eq!(from_numbers::<Of>(), expected);
}

#[test]
fn planes_and_lines_have_fewer_components() {
    type Flat = Raft<f64>;
    let expected = RaftInputs {
        gravity: Vector2::from(all::<Flat, 2>("gravity", ["x", "y"])),
        b: at::<Flat>("b"),
        d: Vector3::new(at::<Flat>("d.force.x"), at::<Flat>("d.force.y"), at::<Flat>("d.torque")),
        wind_force: Vector2::from(all::<Flat, 2>("wind.force", ["x", "y"])),
        wind_torque: at::<Flat>("wind.torque"),
    };
    assert_eq!(from_numbers::<Flat>(), expected);
    type Straight = Train<f64>;
    let state =
        SliderState::new(at::<Straight>("b.state.position"), at::<Straight>("b.state.velocity"));
    let expected = TrainInputs {
        gravity: at::<Straight>("gravity"),
        b: HingeMotion { state, acceleration: at::<Straight>("b.acceleration") },
        engine_force: at::<Straight>("engine.force"),
    };
    assert_eq!(from_numbers::<Straight>(), expected);
}

/// Copies inputs back, and refuses slices of other lengths.
fn copies_back<C: Described<Scalar = f64>>() {
    let values = numbers::<C>();
    let inputs = C::inputs_from_slice(&values).expect("as many values as inputs");
    let mut copied = vec![0.0; values.len()];
    assert_eq!(C::inputs_to_slice(&inputs, &mut copied), Some(()));
    assert_eq!(copied, values);
    let longer = vec![0.0; values.len() + 1];
    assert!(C::inputs_from_slice(&longer).is_none());
    assert!(C::inputs_to_slice(&inputs, &mut longer.clone()).is_none());
    if let Some((_, shorter)) = values.split_first() {
        assert!(C::inputs_from_slice(shorter).is_none());
    }
    // Zero inputs are those of the description: a quaternion at rest is 1, 0, 0, 0.
    let mut zeros = values;
    C::inputs_to_slice(&C::Inputs::default(), &mut zeros).expect("the right length");
    let starts: Vec<f64> =
        C::DESCRIPTION.inputs().iter().map(|input| input.start.expect("a value")).collect();
    assert_eq!(zeros, starts);
}

#[test]
fn inputs_are_copied_back() {
    copies_back::<Kinds<f64>>();
    copies_back::<Crawler<f64>>();
    copies_back::<Raft<f64>>();
    copies_back::<Train<f64>>();
    copies_back::<Rope<f64>>();
}

/// Returns the bits of the accelerations at the start with every rate one.
fn accelerations<C: Described<Scalar = f64>>(chain: &C) -> Vec<u64> {
    let mut state = chain.initial_state();
    state.rates_mut().fill(1.0);
    let mut rate = state.clone();
    let inputs = chain.no_inputs();
    chain.derivative_into(&state, &inputs, &mut rate).expect("a regular state");
    rate.rates().iter().map(|value| value.to_bits()).collect()
}

#[test]
fn parameters_by_index_are_those_by_setters() -> Result<(), Error> {
    let (mut by_index, mut by_setter) = (Kinds::<f64>::new(), Kinds::<f64>::new());
    let before = accelerations(&by_index);
    let index = |name: &str| Kinds::<f64>::DESCRIPTION.parameter(name).expect(name);
    by_index.set_parameter(index("payload"), 0.7)?;
    by_index.set_parameter(index("slope"), -0.2)?;
    by_index.set_parameter(index("lift"), 0.1)?;
    by_setter.set_payload(0.7)?;
    by_setter.set_slope(-0.2)?;
    by_setter.set_lift(0.1)?;
    assert_eq!(by_index, by_setter);
    assert_eq!(accelerations(&by_index), accelerations(&by_setter));
    assert_ne!(accelerations(&by_index), before);
    assert_eq!(by_index.parameter(index("slope")), Some(-0.2));
    assert_eq!(by_index.parameter(3), None);

    let (mut by_index, mut by_setter) = (Crawler::<f64>::new(), Crawler::<f64>::new());
    let index = |name: &str| Crawler::<f64>::DESCRIPTION.parameter(name).expect(name);
    for k in 0..3 {
        by_index.set_parameter(index(&format!("knot[{k}]")), 0.5 + k as f64)?;
        by_index.set_parameter(index(&format!("bend[{k}]")), 0.1 * k as f64)?;
    }
    by_index.set_parameter(index("hull"), 9.0)?;
    by_setter.set_knot(|k| 0.5 + k as f64)?;
    by_setter.set_bend(|k| 0.1 * k as f64)?;
    by_setter.set_hull(9.0)?;
    assert_eq!(by_index, by_setter);
    assert_eq!(accelerations(&by_index), accelerations(&by_setter));
    let values: Vec<f64> = (0..7).map_while(|index| by_index.parameter(index)).collect();
    assert_eq!(values, [0.5, 1.5, 2.5, 9.0, 0.0, 0.1, 0.2]);
    Ok(())
}

#[test]
fn parameters_by_index_are_refused_as_by_setters() {
    let mut chain = Crawler::<f64>::new();
    let index = Crawler::<f64>::DESCRIPTION.parameter("knot[1]").expect("a parameter");
    for refused in [-1.0, f64::NAN, f64::INFINITY] {
        let unchanged = chain.clone();
        let found = chain.set_parameter(index, refused);
        assert!(matches!(found, Err(Error::InvalidParameter { name: "knot", .. })), "{found:?}");
        assert_eq!(found, chain.set_knot(|k| if k == 1 { refused } else { 0.1 }));
        assert_eq!(chain, unchanged);
    }
    let found = chain.set_parameter(7, 1.0);
    assert!(matches!(found, Err(Error::InvalidParameter { name: "index", .. })), "{found:?}");
    let mut rope = Rope::<f64>::new();
    assert!(rope.set_parameter(0, 1.0).is_err());
    assert_eq!(rope.parameter(0), None);
}
