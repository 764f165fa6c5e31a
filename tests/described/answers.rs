//! `Answers`: each answer by its name is that of its method, bit for bit.

use mstmm::description::{Answer, Answers, Origin};
use mstmm::nalgebra::{SMatrix, SVector};
use mstmm::{ChainState, Described, Error, FrameMotion, mstmm_chain};

mstmm_chain! {
    /// A pin, a ball and a repeated slider, with parameters, inputs and all answers.
    pub chain Everything {
        gravity = [0.3, -0.2, -9.81] m/s^2;
        answers = [
            inverse_dynamics, bias_efforts, mass_matrix, jacobian, momentum, regressor, derivatives, linearize, push, pull,
            coriolis_matrix
        ];
        param mass = 1 kg;
        param stiffness = 20 N/m;
        body Rod {
            mass = 1 kg + mass; com = [0.5, 0.1, 0] m; inertia = diag(1, 2, 1.5) kg*m^2 about com;
            output = [1, 0, 0.2] m turned rpy(10, 20, 30) deg; point tip = [1, 0.3, 0.1] m;
        }
        body Slide { mass = 0.5 kg; com = [0.1, 0, 0] m; inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com; output = [0.2, 0, 0] m; }
        ground -> pin(y) a -> Rod upper -> ball b -> Rod lower -> repeat 2 { slider(z) c -> Slide slide };
        hinge a { torque = input; start_rate = 0.7 rad/s; start = 0.4 rad; }
        hinge b { start_rate = [0.1, -0.5, 0.3] rad/s; damping = 0.1 N*m*s/rad; }
        hinge c { stiffness = stiffness; force = input; start_velocity = 0.2 m/s; }
    }
}

mstmm_chain! {
    /// A chain in a plane, with a few answers.
    plane chain Flat {
        gravity = [0, -9.81] m/s^2;
        answers = [kinematics, momentum];
        body Bob { mass = 1 kg; com = [0.4, 0] m; inertia = 0.1 kg*m^2 about com; output = [0.8, 0] m; }
        ground -> pin a -> Bob b;
        hinge a { start = 0.3 rad; start_rate = 0.8 rad/s; }
    }
}

mstmm_chain! {
    /// A closed chain, whose mass matrix has no inverse.
    plane chain Closed {
        gravity = [0, -9.81] m/s^2;
        answers = mass_matrix;
        body Bar { mass = 1 kg; com = [0.5, 0] m; inertia = 0.1 kg*m^2 about com; output = [1, 0] m; }
        ground -> pin a -> Bar crank -> pin b -> Bar coupler -> pin c -> Bar rocker -> pin d -> ground at [1, 0] m;
        hinge a { start = 60 deg; } hinge b { start = -60 deg; } hinge c { start = -60 deg; }
    }
}

/// Returns an answer of a chain with given values, or `None` if the chain does not have it.
fn answer<C: Answers<Scalar = f64>>(
    chain: &C,
    answer: Answer,
    given: &[f64],
) -> Option<Result<Vec<f64>, Error>> {
    let mut result = vec![f64::NAN; answer.len(C::DESCRIPTION, C::DYNAMIC_PARAMETER_COUNT)];
    let inputs: Vec<f64> = (0..C::DESCRIPTION.inputs().len()).map(|i| 0.5 + i as f64).collect();
    let inputs = C::inputs_from_slice(&inputs).expect("the number of inputs");
    let computed = chain.answer(answer, &chain.initial_state(), &inputs, given, &mut result)?;
    Some(computed.map(|()| result))
}

/// Given accelerations, efforts or weights.
const GIVEN: [f64; 6] = [0.3, -1.0, 0.7, 0.2, 1.5, -0.4];

#[test]
fn answers_by_name_are_those_of_the_methods() -> Result<(), Error> {
    let chain = Everything::<f64>::new();
    let (state, vector) = (chain.initial_state(), SVector::from(GIVEN));
    let inputs = Everything::inputs_from_slice(&[0.5, 1.5, 2.5]).expect("three inputs");
    let direction: Vec<f64> = (0..17).map(|i| 0.1 * f64::from(i) - 0.6).collect();
    let mut variation = EverythingVariation::default();
    let mut entries = direction.iter().copied();
    for part in [
        variation.coordinates.as_mut_slice(),
        variation.rates.as_mut_slice(),
        variation.inputs.as_mut_slice(),
        variation.parameters.as_mut_slice(),
    ] {
        part.iter_mut().for_each(|entry| *entry = entries.next().expect("an entry"));
    }
    let (mut linear, mut derivatives) =
        (EverythingLinearization::default(), EverythingInverseDynamicsDerivatives::default());
    chain.linearize_into(&state, &inputs, &mut linear)?;
    chain.inverse_dynamics_derivatives_into(&state, &vector, &inputs, &mut derivatives)?;
    let (mut mass_matrix, mut inverse) = (SMatrix::default(), SMatrix::default());
    chain.mass_matrix_into(&state, &inputs, &mut mass_matrix)?;
    chain.inverse_mass_matrix_into(&state, &inputs, &mut inverse)?;
    let mut coriolis_matrix = SMatrix::default();
    chain.coriolis_matrix_into(&state, &inputs, &mut coriolis_matrix)?;
    let (mut pushed, mut change) = (SVector::default(), SVector::default());
    chain.push_into(&state, &inputs, &variation, &mut pushed, &mut change)?;
    assert_eq!(chain.push(&state, &inputs, &variation)?, (pushed, change));
    let (mut pulled, mut gradient) = (SVector::default(), EverythingVariation::default());
    chain.pull_into(&state, &inputs, &vector, &mut pulled, &mut gradient)?;
    assert_eq!(chain.pull(&state, &inputs, &vector)?, (pulled, gradient));
    let momentum = chain.momentum(&state, &inputs)?;
    let slices = |parts: &[&[f64]]| parts.concat();
    for name in Answer::ALL {
        let (given, expected): (&[f64], Vec<f64>) = match name {
            Answer::BiasEfforts => (&[], chain.bias_efforts(&state, &inputs)?.as_slice().into()),
            Answer::InverseDynamics => {
                (&GIVEN, chain.inverse_dynamics(&state, &vector, &inputs)?.as_slice().into())
            }
            Answer::GravityEfforts => {
                (&[], chain.gravity_efforts(&state, &inputs)?.as_slice().into())
            }
            Answer::PassiveEfforts => {
                (&[], chain.passive_efforts(&state, &inputs)?.as_slice().into())
            }
            Answer::MassMatrix => (&[], mass_matrix.as_slice().into()),
            Answer::InverseMassMatrix => (&[], inverse.as_slice().into()),
            Answer::MassMatrixTimes => {
                (&GIVEN, chain.mass_matrix_times(&state, &inputs, &vector)?.as_slice().into())
            }
            Answer::InverseMassMatrixTimes => (
                &GIVEN,
                chain.inverse_mass_matrix_times(&state, &inputs, &vector)?.as_slice().into(),
            ),
            Answer::InverseDynamicsDerivatives => (
                &GIVEN,
                slices(&[
                    derivatives.by_coordinates.as_slice(),
                    derivatives.by_rates.as_slice(),
                    derivatives.by_accelerations.as_slice(),
                ]),
            ),
            Answer::Linearize => (
                &[],
                slices(&[
                    linear.accelerations.as_slice(),
                    linear.inverse_mass_matrix.as_slice(),
                    linear.by_coordinates.as_slice(),
                    linear.by_rates.as_slice(),
                    linear.by_inputs.as_slice(),
                    linear.by_parameters.as_slice(),
                    linear.a().as_slice(),
                    linear.b().as_slice(),
                ]),
            ),
            Answer::Push => (&direction, slices(&[pushed.as_slice(), change.as_slice()])),
            Answer::Pull => (
                &GIVEN,
                slices(&[
                    pulled.as_slice(),
                    gradient.coordinates.as_slice(),
                    gradient.rates.as_slice(),
                    gradient.inputs.as_slice(),
                    gradient.parameters.as_slice(),
                ]),
            ),
            Answer::Regressor => {
                (&GIVEN, chain.regressor(&state, &vector, &inputs)?.as_slice().into())
            }
            Answer::DynamicParameters => (&[], chain.dynamic_parameters().as_slice().into()),
            Answer::Momentum => (
                &[],
                slices(&[
                    &[momentum.mass],
                    momentum.center_of_mass.as_slice(),
                    momentum.linear.as_slice(),
                    momentum.angular.as_slice(),
                ]),
            ),
            Answer::MomentumMatrix => {
                (&[], chain.momentum_matrix(&state, &inputs)?.as_slice().into())
            }
            Answer::CoriolisMatrix => (&[], coriolis_matrix.as_slice().into()),
            Answer::CoriolisMatrixTimes => {
                (&GIVEN, chain.coriolis_matrix_times(&state, &inputs, &vector)?.as_slice().into())
            }
            _ => unreachable!("an answer without a test"),
        };
        assert_eq!(name.given(Everything::<f64>::DESCRIPTION), given.len(), "{}", name.name());
        assert_eq!(answer(&chain, name, given), Some(Ok(expected)), "{}", name.name());
        assert!(Everything::<f64>::DESCRIPTION.answers_to(name.keyword()), "{}", name.name());
        // Another number of given values is not read.
        assert_eq!(answer(&chain, name, &[0.0; 99]).is_some(), given.is_empty(), "{}", name.name());
    }
    Ok(())
}

#[test]
fn answers_that_a_chain_does_not_have_are_none() {
    let has = |name: &Answer| Flat::<f64>::has(*name);
    let names: Vec<&str> = Answer::ALL.iter().filter(|it| has(it)).map(|it| it.name()).collect();
    assert_eq!(names, ["momentum", "momentum_matrix"]);
    let chain = Flat::<f64>::new();
    for name in Answer::ALL {
        let given = vec![0.0; name.given(Flat::<f64>::DESCRIPTION)];
        assert_eq!(answer(&chain, name, &given).is_some(), has(&name), "{}", name.name());
    }
    assert!(Closed::<f64>::has(Answer::MassMatrix));
    assert!(!Closed::<f64>::has(Answer::InverseMassMatrix));
}

#[test]
fn motions_by_name_are_those_of_the_kinematics() -> Result<(), Error> {
    let chain = Everything::<f64>::new();
    let (state, inputs) = (chain.initial_state(), chain.no_inputs());
    let at = chain.kinematics(&state, &inputs)?;
    let bodies = Everything::<f64>::DESCRIPTION.bodies();
    let names: Vec<String> = bodies.iter().map(|body| body.name().to_string()).collect();
    assert_eq!(names, ["upper", "lower", "slide[0]", "slide[1]"]);
    assert_eq!(Everything::<f64>::frames(1), ["input", "output", "com", "tip"]);
    let slide = at.slide(1).expect("the second slide");
    for (body, frame, point) in [
        (0, "output", at.upper().output()),
        (1, "tip", at.lower().tip()),
        (3, "com", slide.com()),
        (3, "input", slide.input()),
    ] {
        let place = Everything::<f64>::frame(body, frame).expect("the frame");
        let mut jacobian = [0.0; 36];
        let motion = chain.motion(&state, &inputs, place, &mut jacobian);
        assert_eq!(motion, Some(Ok(FrameMotion::from(point))));
        assert_eq!(jacobian, point.jacobian().as_slice());
    }
    assert_eq!(Everything::<f64>::frame(1, "elbow"), None);
    assert_eq!(Everything::<f64>::frame(9, "input"), None);
    // A chain without Jacobians has motions only.
    let flat = Flat::<f64>::new();
    let (state, inputs) = (flat.initial_state(), flat.no_inputs());
    let output = Flat::<f64>::frame(0, "output").expect("the output");
    let motion = flat.motion(&state, &inputs, output, &mut []).expect("kinematics")?;
    let (sine, cosine) = 0.3f64.sin_cos();
    // The circle of radius 0.8 m with the rate 0.8 rad/s; the sine of the library differs by one unit in the last place.
    for (value, expected) in [
        (motion.position[0], 0.8 * cosine),
        (motion.position[1], 0.8 * sine),
        (motion.velocity[0], -0.64 * sine),
        (motion.bias_acceleration[1], -0.512 * sine),
        (motion.angular_velocity[2], 0.8),
        (motion.orientation[1][0], sine),
    ] {
        assert!((value - expected).abs() < 4.0 * f64::EPSILON, "{value} {expected}");
    }
    assert_eq!(flat.motion(&state, &inputs, output, &mut [0.0; 3]), None);
    Ok(())
}

#[test]
fn the_length_of_a_motion_in_a_state_is_checked() {
    let chain = Everything::<f64>::new();
    let place = Everything::<f64>::frame(0, "com").expect("the centre of mass");
    let (mut state, inputs) = (chain.initial_state(), chain.no_inputs());
    assert_eq!(chain.motion(&state, &inputs, place, &mut [0.0; 7]), None);
    state.coordinates_mut()[0] = f64::NAN;
    assert_eq!(
        chain.motion(&state, &inputs, place, &mut []),
        Some(Err(Error::NotFinite(Origin::Coordinate(0))))
    );
}

/// A given vector that is not finite is named, with the index of its entry.
#[test]
fn given_values_that_are_not_finite_are_named() {
    let chain = Everything::<f64>::new();
    let of = Everything::<f64>::DESCRIPTION;
    let (n, inputs) = (of.rates().len(), of.inputs().len());
    let direction = [
        ("direction.coordinates", n),
        ("direction.rates", n),
        ("direction.inputs", inputs),
        ("direction.parameters", of.parameters().len()),
    ];
    let mut named = 0;
    for answer in Answer::ALL {
        let parts = match answer {
            Answer::InverseDynamics | Answer::InverseDynamicsDerivatives | Answer::Regressor => {
                vec![("accelerations", n)]
            }
            Answer::MassMatrixTimes
            | Answer::InverseMassMatrixTimes
            | Answer::CoriolisMatrixTimes
            | Answer::Pull => vec![("vector", n)],
            Answer::Push => direction.to_vec(),
            _ => vec![],
        };
        let mut given = vec![0.1; answer.given(of)];
        assert_eq!(given.len(), parts.iter().map(|(_, len)| len).sum::<usize>(), "{answer:?}");
        let mut result = vec![0.0; answer.len(of, Everything::<f64>::DYNAMIC_PARAMETER_COUNT)];
        let mut ask = |given: &[f64]| {
            let (state, inputs) = (chain.initial_state(), chain.no_inputs());
            chain.answer(answer, &state, &inputs, given, &mut result)
        };
        assert_eq!(ask(&given), Some(Ok(())), "{answer:?}");
        let places = parts.iter().flat_map(|&(name, len)| (0..len).map(move |i| (name, i)));
        for (place, (name, index)) in places.enumerate() {
            for wrong in [f64::NAN, f64::NEG_INFINITY] {
                given[place] = wrong;
                let origin = Origin::Argument { name, index };
                assert_eq!(ask(&given), Some(Err(Error::NotFinite(origin))), "{answer:?}");
            }
            given[place] = 0.1;
            named += 1;
        }
    }
    assert_eq!(named, 7 * n + 2 * n + inputs + of.parameters().len());
}
