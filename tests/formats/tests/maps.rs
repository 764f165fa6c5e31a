//! `serde`: maps by name in a text format and in a compact one without heap, and refused maps.

use mstmm::{ChainState, Described};
use mstmm_formats::{
    Arm, ArmInputs, ArmState, Crab, CrabInputs, CrabState, Rope, RopeInputs, RopeState, Weight,
    WeightInputs, WeightState,
};
use serde_json::{from_str, json, to_string, to_value};

/// A state in which all values are different. The quaternions are not of unit length: formats change nothing.
fn numbered<S: ChainState<Scalar = f64>>() -> S {
    let mut state = S::zero_position();
    let mut next = 0.0;
    let mut count = |place: &mut f64| {
        next += 1.0;
        *place = 1.0 / next;
    };
    state.coordinates_mut().iter_mut().for_each(&mut count);
    state.rates_mut().iter_mut().for_each(&mut count);
    state.set_time(-0.1);
    state
}

/// Each type comes back from both formats with the same bits.
macro_rules! come_back {
    ($($value:expr => $type:ty),* $(,)?) => { $( {
        let value: $type = $value;
        let text = to_string(&value).expect("a text");
        assert_eq!(from_str::<$type>(&text).expect("the same value"), value, "{text}");
        let mut buffer = [0; 8192];
        let bytes = postcard::to_slice(&value, &mut buffer).expect("enough bytes");
        assert_eq!(postcard::from_bytes::<$type>(bytes).expect("the same value"), value);
    } )* };
}

#[test]
fn values_come_back() {
    let inputs = |count: usize| (0..count).map(|k| 0.1 * k as f64 + 0.05).collect::<Vec<f64>>();
    let mut arm = Arm::<f64>::new();
    arm.set_payload(0.1).expect("a mass");
    let mut rope = Rope::<f64>::new();
    rope.set_stiffness(|index| 0.3 * index as f64).expect("damping");
    come_back! {
        numbered() => ArmState<f64>,
        numbered() => RopeState<f64>,
        numbered() => CrabState<f64>,
        numbered() => WeightState<f64>,
        Arm::<f64>::inputs_from_slice(&inputs(4)).expect("4 inputs") => ArmInputs<f64>,
        Rope::<f64>::inputs_from_slice(&inputs(1)).expect("1 input") => RopeInputs<f64>,
        Crab::<f64>::inputs_from_slice(&inputs(1)).expect("1 input") => CrabInputs<f64>,
        Weight::<f64>::new().no_inputs() => WeightInputs<f64>,
        arm => Arm<f64>,
        rope => Rope<f64>,
        Weight::new() => Weight<f64>,
        WeightState { t: 0.3, ..Default::default() } => WeightState<f32>,
    }
}

#[test]
fn maps_have_the_names_of_the_description() {
    let state = to_value(ArmState::<f64>::default()).expect("a value");
    let angle = ArmState::<f64>::default().shoulder().angle();
    let expected = json!({
        "shoulder.angle": angle, "rail.position": 0.125,
        "shoulder.rate": 0.0, "rail.velocity": -2.0, "time": 0.0,
    });
    assert_eq!(state, expected);
    let parameters = to_value(Arm::<f64>::new().parameters()).expect("a value");
    assert_eq!(parameters, json!({ "payload": 0.5, "reach": 0.4 }));
    assert_eq!(to_value(Arm::<f64>::new()).expect("a value"), parameters);
    let rope = to_value(numbered::<RopeState<f64>>()).expect("a value");
    let state = numbered::<RopeState<f64>>();
    let joint = state.joint(12).expect("a joint");
    assert_eq!(rope["joint[12].orientation.w"], json!(joint.orientation().w));
    assert_eq!(rope["joint[12].rate.y"], json!(joint.rate().y));
    let crab = to_value(numbered::<CrabState<f64>>()).expect("a value");
    assert_eq!(
        crab["left.knuckle.angle"],
        json!(numbered::<CrabState<f64>>().left_knuckle().angle())
    );
}

/// The order of a map does not matter.
#[test]
fn any_order_is_read() {
    let text = r#"{ "time": 2, "rail.velocity": 4, "shoulder.rate": 3, "rail.position": 1, "shoulder.angle": 0 }"#;
    let state: ArmState<f64> = from_str(text).expect("a state");
    assert_eq!((state.rail().position(), state.rail().velocity(), state.t), (1.0, 4.0, 2.0));
}

fn refused<T: for<'de> mstmm::generated::serde::Deserialize<'de> + std::fmt::Debug>(
    text: &str,
) -> String {
    from_str::<T>(text).expect_err("an error").to_string()
}

#[test]
fn errors_name_the_value() {
    let whole = to_string(&ArmState::<f64>::default()).expect("a text");
    let unknown = refused::<ArmState<f64>>(&whole.replace("rail.position", "rail.angle"));
    assert!(
        unknown.starts_with("`rail.angle` is not the name of a coordinate or rate of `Arm`"),
        "{unknown}"
    );
    let missing = refused::<ArmState<f64>>(&whole.replace(r#","time":0.0"#, ""));
    assert!(missing.starts_with("`time` is missing"), "{missing}");
    let missing = refused::<ArmState<f64>>(&whole.replace(r#""rail.velocity":-2.0,"#, ""));
    assert!(missing.starts_with("`rail.velocity` is missing"), "{missing}");
    let twice =
        refused::<ArmState<f64>>(&whole.replace(r#""time":0.0"#, r#""time":0.0,"time":0.0"#));
    assert!(twice.starts_with("`time` is given twice"), "{twice}");
    let twice = whole.replace("shoulder.rate", "shoulder.angle");
    let twice = refused::<ArmState<f64>>(&twice);
    assert!(twice.starts_with("`shoulder.angle` is given twice"), "{twice}");
    let list = refused::<ArmState<f64>>("[1, 2]");
    assert!(
        list.contains("a map from the names of all coordinates and rates of `Arm` to numbers"),
        "{list}"
    );
    let text = refused::<ArmState<f64>>(&whole.replace("-2.0", r#""fast""#));
    assert!(text.contains("expected f64"), "{text}");

    let rope = to_string(&RopeState::<f64>::default()).expect("a text");
    let beyond = refused::<RopeState<f64>>(&rope.replace("joint[12].rate.x", "joint[13].rate.x"));
    assert!(beyond.starts_with("`joint[13].rate.x` is not the name"), "{beyond}");
    let input = refused::<ArmInputs<f64>>(r#"{ "elbow": 1 }"#);
    assert!(input.starts_with("`elbow` is not the name of an input of `Arm`"), "{input}");
}

/// Values of parameters are checked as their setters check them.
#[test]
fn refused_parameters_stay_refused() {
    let error = refused::<Arm<f64>>(r#"{ "payload": -3, "reach": 0.1 }"#);
    let mut arm = Arm::<f64>::new();
    let of_setter = arm.set_payload(-3.0).expect_err("an error").to_string();
    assert!(error.starts_with(&of_setter), "{error} is not {of_setter}");
    let missing = refused::<Arm<f64>>(r#"{ "payload": 1 }"#);
    assert!(missing.starts_with("`reach` is missing"), "{missing}");
}
