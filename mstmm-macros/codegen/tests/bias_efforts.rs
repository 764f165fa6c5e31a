//! Compares the bias efforts with the maximal-coordinate solver, which prescribes every hinge, and with the accelerations:
//! they vanish if the motors supply the bias efforts.

mod common;

use common::given::Given;
use common::{difference, drives, read};
use mstmm_codegen::compile::{chain_text, compile, outputs};
use mstmm_codegen::examine::Findings;
use mstmm_codegen::model::{Answer, Chain, Layout};
use mstmm_reference::{Random, Recipe, random_mechanism, random_motion};

/// The tolerance. Procedure and solver compute the same sums of at most some hundred terms in different orders; the solver
/// inverts matrices with condition numbers of a few thousand, and closes chains to 1e-12.
const TOLERANCE: f64 = 1e-10;

/// Adds a setting to the text of a chain.
fn with(setting: &str, text: &str) -> String {
    text.replacen('{', &format!("{{ {setting}"), 1)
}

#[test]
fn bias_efforts_are_those_of_prescribed_hinges() {
    for seed in 0..150 {
        let mut random = Random::new(seed);
        let recipe = Recipe::any(&mut random, 5);
        let description = random_mechanism(&mut random, "Random", &recipe);
        let (state, driven) = random_motion(&mut random, &description);
        let text = with("answers = bias_efforts;", &description.to_macro_text(None));
        let chain = read(&text);
        let compiled = compile(&chain, &Findings::default(), &Layout::of(&chain));
        let inputs = drives::inputs(&chain, &description, &driven);
        let unknowns = [&state.q[..], &state.v, &inputs, &[0.0]].concat();
        let given = Given::new(&compiled, &unknowns);
        let found = given.run(Answer::BiasEfforts).expect("finite numbers");
        let expected = description.bias_efforts(&state, &driven);
        let off = difference(&found.result(outputs::BIAS_EFFORTS), &expected);
        assert!(off < TOLERANCE, "seed {seed}: {off:e}\n{text}");
    }
}

const ARM: &str = "chain Arm {
    gravity = [0, -9.8, 1] m/s^2;
    body Rod {
        mass = 1.3 kg;
        com = [0.3, 0.1, 0] m;
        output = [0.6, 0, 0.2] m turned rpy(20, -30, 50) deg;
        inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
    }
    ground -> ball a -> Rod b -> repeat 3 { pin c -> Rod d -> slider(y) e -> Rod f };
    hinge a { torque = input; damping = 0.2; armature = 0.1; }
    hinge c { torque = input; stiffness = 3; armature = 0.2; friction = 0.3; friction_speed = 0.1; }
    hinge e { force = input; limits = [-0.1, 0.1]; limit_stiffness = 20; limit_damping = 1; }
}";

fn compiled(text: &str) -> (Chain, mstmm_codegen::compile::Compiled) {
    let chain = read(text);
    let compiled = compile(&chain, &Findings::default(), &Layout::of(&chain));
    (chain, compiled)
}

/// If the motors supply the bias efforts, no rate changes, also in repeated parts.
#[test]
fn no_rate_changes_under_bias_efforts() {
    let (chain, compiled) = compiled(&with("answers = [bias_efforts];", ARM));
    for seed in 0..20 {
        let mut random = Random::new(seed);
        let mut given = Given::zeros(&compiled);
        given.fill(|argument, _| match argument {
            mstmm_codegen::program::Argument::Input(_) => 0.0,
            _ => random.between(-1.0, 1.0),
        });
        given.normalize();
        let bias = given.run(Answer::BiasEfforts).expect("finite numbers");
        let bias = bias.result(outputs::BIAS_EFFORTS);
        given.drive(&chain, &bias);
        let solved = given.run(Answer::Accelerations).expect("a regular chain");
        let accelerations = solved.result(outputs::ACCELERATIONS);
        let largest = accelerations.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        // Efforts up to 100 N m, rounded a hundred times, over inertias of 0.01 kg m² and more.
        assert!(largest < 100.0 * 100.0 / 0.01 * f64::EPSILON, "seed {seed}: {largest:e}");
    }
}

/// An additional answer changes neither texts nor slots of the other functions.
#[test]
fn an_answer_does_not_change_other_functions() {
    let text = |text: &str| {
        let chain = read(text);
        let all = chain_text(&chain, &Findings::default(), None).expect("all functions");
        let functions = all.split("\nfn ").map(str::to_owned);
        // The setup derives what the answer needs as well.
        functions.filter(|function| !function.starts_with("fn setup")).collect::<Vec<String>>()
    };
    let (plain, asked) = (text(ARM), text(&with("answers = bias_efforts;", ARM)));
    assert_eq!(asked.len(), plain.len() + 1);
    let same = plain.iter().zip(&asked).all(|(plain, asked)| plain.trim() == asked.trim());
    assert!(same, "a function has another text");
    assert!(asked.last().is_some_and(|last| last.starts_with("bias_efforts()")));
}
