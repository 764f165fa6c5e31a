//! Repeated hinges and bodies by their index, and errors that name them.

use mstmm::description::Origin;
use mstmm::{
    BallState, ChainState, Described, Error, HingeMotion, PinState, SliderState, mstmm_chain,
};
use mstmm_reference::Random;
use nalgebra::Vector3;

use super::twins::random_state;

mstmm_chain! {
    chain Arm {
        gravity = [0, -9.8, 0] m/s^2;
        body Rod {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 0.09, 0.1) kg*m^2 about com;
        }
        ground -> pin(y) base -> Rod first -> repeat 3 { pin a -> Rod b -> ball c -> Rod d }
            -> weld w -> Rod hand -> repeat 2 { weld x -> Rod y -> cylindrical z -> Rod last };
        hinge base { torque = input; }
        hinge a { torque = input; start = 0.1; }
        hinge c { torque = input; }
        load push { on = b; force = input; }
    }
}

#[test]
fn states_are_read_and_set_by_index() {
    let mut state = ArmState::<f64>::default();
    state.set_each_a(|index| PinState::new(index as f64, 0.5 + index as f64));
    let quaternion = |index: usize| [[0.6, 0.8, 0.0, 0.0], [0.6, 0.0, 0.8, 0.0], [0.0; 4]][index];
    state.set_each_c(|index| BallState::new(quaternion(index), [index as f64; 3]));
    state.base_mut().set_angle(7.0).set_rate(8.0);
    let q = [
        &[7.0, 0.0][..],
        &quaternion(0),
        &[1.0],
        &quaternion(1),
        &[2.0],
        &quaternion(2),
        &[0.0; 4],
    ];
    assert_eq!(state.coordinates(), q.concat());
    let v = [8.0, 0.5, 0.0, 0.0, 0.0, 1.5, 1.0, 1.0, 1.0, 2.5, 2.0, 2.0, 2.0, 0.0, 0.0, 0.0, 0.0];
    assert_eq!(state.rates(), v);
    for index in 0..3 {
        let number = index as f64;
        assert_eq!(state.a(index), Some(PinState::new(number, 0.5 + number)));
        assert_eq!(state.c(index), Some(BallState::new(quaternion(index), [number; 3])));
    }
    state.a_mut(1).expect("there are three").set_angle(-1.0).set_rate(-2.0);
    state.z_mut(1).expect("there are two").set_angle(3.0).set_position(4.0);
    assert_eq!(state.a(1), Some(PinState::new(-1.0, -2.0)));
    assert_eq!(state.a(0), Some(PinState::new(0.0, 0.5)));
    assert_eq!(state.coordinates()[16..], [0.0, 0.0, 4.0, 3.0]);
    for index in [3, 4, usize::MAX / 8, usize::MAX] {
        assert!(state.a(index).is_none() && state.a_mut(index).is_none());
        assert!(state.c(index).is_none() && state.c_mut(index).is_none());
        assert!(state.z(index).is_none() && state.z_mut(index).is_none());
    }
    assert!(state.z(2).is_none() && state.z_mut(2).is_none());
    let start = Arm::<f64>::new().initial_state();
    assert_eq!([0, 1, 2].map(|k| start.a(k)), [Some(PinState::new(0.1, 0.0)); 3]);
}

#[test]
fn results_are_read_by_index() {
    let chain = Arm::<f64>::new();
    let mut state = chain.initial_state();
    state.set_each_a(|index| PinState::new(0.3 * index as f64, 0.5));
    let torques = [1.0, 2.0, 3.0];
    let inputs = ArmInputs {
        base: 4.0,
        a: torques,
        c: torques.map(|x| Vector3::new(x, -x, 5.0)),
        push_force: torques.map(|x| Vector3::new(0.0, x, 0.0)),
    };
    let mut at = chain.workspace();
    chain.solve_into(&state, &inputs, &mut at).expect("a regular chain");
    // The first input, then two elements at the start, four of each of three times, and so on.
    assert_eq!(at.points().len(), 1 + 2 + 3 * 4 + 2 + 2 * 4);
    let same = |a: mstmm::Point<f64>, place: usize| assert_eq!(a, at.points()[place]);
    for (index, &torque) in torques.iter().enumerate() {
        let first = 2 + 4 * index;
        let (a, c) = (at.a(index).expect("of three"), at.c(index).expect("of three"));
        let (b, d) = (at.b(index).expect("of three"), at.d(index).expect("of three"));
        same(a.input(), first);
        same(a.output(), first + 1);
        same(b.input(), first + 1);
        same(b.output(), first + 2);
        same(c.input(), first + 2);
        same(c.output(), first + 3);
        same(d.input(), first + 3);
        same(d.output(), first + 4);
        assert_eq!(a.effort(), torque);
        assert_eq!(c.effort(), inputs.c[index]);
        assert_eq!(a.acceleration(), at.accelerations()[1 + 4 * index]);
        assert_eq!(
            c.acceleration().as_slice(),
            &at.accelerations().as_slice()[2 + 4 * index..][..3]
        );
    }
    same(at.w().input(), 14);
    same(at.hand().output(), 16);
    for index in 0..2 {
        same(at.x(index).expect("of two").input(), 16 + 4 * index);
        same(at.last(index).expect("of two").output(), 20 + 4 * index);
        let z = at.z(index).expect("of two");
        assert_eq!(
            z.acceleration().as_slice(),
            &at.accelerations().as_slice()[13 + 2 * index..][..2]
        );
    }
    for index in [3, 4, usize::MAX / 8, usize::MAX] {
        assert!(at.a(index).is_none() && at.b(index).is_none());
        assert!(at.c(index).is_none() && at.d(index).is_none());
    }
    assert!(at.x(2).is_none() && at.y(2).is_none() && at.z(2).is_none() && at.last(2).is_none());
}

#[test]
fn values_that_are_not_finite_are_found_everywhere() {
    let chain = Arm::<f64>::new();
    let (state, inputs) = (chain.initial_state(), chain.no_inputs());
    let refused = |state: &ArmState<f64>, inputs: &ArmInputs<f64>, name: String| {
        let origin = Arm::<f64>::not_finite(state, inputs).expect("a value");
        let found = Arm::<f64>::DESCRIPTION.name_of(origin).expect("a name").to_string();
        assert!(found.starts_with(&name), "{found} is no {name}");
        let mut at = chain.workspace();
        let before = at.clone();
        assert_eq!(chain.solve_into(state, inputs, &mut at), Err(Error::NotFinite(origin)));
        assert!(at == before);
        assert_eq!(chain.accelerations(state, inputs), Err(Error::NotFinite(origin)));
    };
    let (coordinates, rates) =
        (Arm::<f64>::DESCRIPTION.coordinates(), Arm::<f64>::DESCRIPTION.rates());
    // Where no number is zero, infinite ones do not vanish in products that are undefined.
    let somewhere = random_state::<Arm<f64>>(&mut Random::new(7));
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for start in [&state, &somewhere] {
            for place in 0..state.q.len() {
                let mut state = start.clone();
                state.q[place] = wrong;
                refused(&state, &inputs, coordinates.get(place).expect("a name").name.to_string());
            }
            for place in 0..state.v.len() {
                let mut state = start.clone();
                state.v[place] = wrong;
                refused(&state, &inputs, rates.get(place).expect("a name").name.to_string());
            }
        }
        for index in 0..3 {
            let mut with = inputs;
            with.a[index] = wrong;
            refused(&state, &with, format!("a[{index}]"));
            for axis in 0..3 {
                let mut with = inputs;
                with.c[index][axis] = wrong;
                refused(&state, &with, format!("c[{index}].{}", ["x", "y", "z"][axis]));
                let mut with = inputs;
                with.push_force[index][axis] = wrong;
                refused(&state, &with, format!("push[{index}].force.{}", ["x", "y", "z"][axis]));
            }
        }
    }
}

mstmm_chain! {
    line chain Told {
        body Car { mass = 1 kg; output = 1 m; }
        ground -> repeat 3 { slider a -> Car b -> slider c -> Car d };
        hinge a { motion = input; }
    }
}

#[test]
fn motions_that_are_not_finite_are_found_everywhere() {
    let chain = Told::<f64>::new();
    let state = chain.initial_state();
    assert!(chain.accelerations(&state, &chain.no_inputs()).is_ok());
    for index in 0..3 {
        for place in 0..3 {
            let mut numbers = [0.0; 3];
            numbers[place] = f64::NAN;
            let [q, v, acceleration] = numbers;
            let mut inputs = chain.no_inputs();
            inputs.a[index] = HingeMotion { state: SliderState::new(q, v), acceleration };
            let result = chain.accelerations(&state, &inputs);
            assert_eq!(result, Err(Error::NotFinite(Origin::Input(3 * index + place))));
        }
    }
}

macro_rules! needles {
    ($($name:ident $method:ident)*) => { $(
        mstmm_chain! { chain $name {
            method = $method;
            param thickness = 0.01;
            body Needle {
                mass = 1 kg;
                com = [0.5, 0, 0] m;
                output = [1, 0, 0] m;
                inertia = diag(thickness, 0.1, 0.1) kg*m^2 about com;
            }
            body Rod {
                mass = 1 kg;
                com = [0, 0.5, 0] m;
                output = [1, 0, 0] m;
                inertia = diag(0.1, 0.1, 0.1) kg*m^2 about com;
            }
            ground -> ball base -> Rod rod -> repeat 4 { pin(x) spin -> Needle needle };
        } }
    )* };
}

needles! {
    Needles riccati
    NeedlesByTransfer transfer
}

/// Needles without inertia about their axis cannot be turned about it.
#[test]
fn a_repeated_hinge_without_inertia_is_named() {
    macro_rules! check {
        ($($chain:ident)*) => { $(
            let mut chain = $chain::<f64>::new();
            let (state, inputs) = (chain.initial_state(), chain.no_inputs());
            let mut at = chain.workspace();
            assert_eq!(chain.solve_into(&state, &inputs, &mut at), Ok(()));
            assert!(at != chain.workspace() && chain.accelerations(&state, &inputs).is_ok());
            // Lost in rounding; by zero something would be divided here.
            chain.set_thickness(1e-22).expect("a thin needle");
            let singular = Err(Error::Singular { hinge: "spin" });
            assert_eq!(chain.solve_into(&state, &inputs, &mut at), singular);
            assert_eq!(chain.accelerations(&state, &inputs).map(|_| ()), singular);
            assert!(at == chain.workspace());
        )* };
    }
    check! { Needles NeedlesByTransfer }
}

mstmm_chain! {
    plane chain Knots {
        answers = [basic, linearize];
        param _knot[3] = 1 kg;
        body Rod { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 0.1 kg*m^2 about com; }
        ground -> repeat 3 { pin joint -> Rod rod };
    }
}

#[test]
fn unused_parameters_have_all_their_values() -> Result<(), Error> {
    let mut chain = Knots::<f64>::new();
    chain.set__knot(|index| index as f64)?;
    let names: Vec<_> =
        Knots::<f64>::DESCRIPTION.parameters().iter().map(|it| it.name.to_string()).collect();
    assert_eq!(names, ["_knot[0]", "_knot[1]", "_knot[2]"]);
    let values = [0, 1, 2, 3].map(|index| chain.parameter(index));
    assert_eq!(values, [Some(0.0), Some(1.0), Some(2.0), None]);
    chain.set_parameter(1, 5.0)?;
    assert_eq!(*chain.parameters()._knot(), [0.0, 5.0, 2.0]);
    assert_eq!(chain.parameters().to_string().lines().count(), 3);
    let mut at = KnotsLinearization::default();
    chain.linearize_into(&chain.initial_state(), &chain.no_inputs(), &mut at)?;
    assert_eq!(at.by_parameters.ncols(), 3);
    Ok(())
}
