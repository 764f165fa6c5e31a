//! Actuators of springs: what they push, their power, and derivatives with respect to their forces.

use crate::support::moving::energy_rate;
use crate::support::worst;
use mstmm::Dual;
use mstmm::prelude::*;
use mstmm_reference::Random;

mstmm_chain! {
    line chain Railway {
        answers = [inverse_dynamics, linearize];
        body Cart { mass = 2 kg; output = 0.5 m; }
        ground -> slider first -> Cart left;
        ground at 3 m -> slider second -> Cart right;
        spring ram { on = left.output; to = right.input; force = input; }
        spring gas { on = left.output; to = right.input; stiffness = 20 N/m; length = 2 m; force = 4 N; }
    }
}

#[test]
fn an_actuator_pushes_its_ends_apart() {
    let railway = Railway::<f64>::new();
    let state = railway.initial_state();
    let inputs = RailwayInputs { ram_force: 7.0 };
    let mut at = railway.workspace();
    railway.solve_into(&state, &inputs, &mut at).expect("a regular chain");
    // The ends are 2.5 m apart, so the other spring pulls with 10 N and pushes with 4 N.
    let (ram, gas) = (at.ram(), at.gas());
    // The length is a square root and its inverse a quotient: a few roundings.
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-14, "{a} {b}");
    near(ram.length(), 2.5);
    near(ram.tension(), -7.0);
    near(ram.force(), -7.0);
    near(gas.tension(), 6.0);
    near(gas.force(), 6.0);
    near(at.first().acceleration(), -0.5);
    near(at.second().acceleration(), 0.5);
    // A constant force has no energy.
    near(railway.energy(&state).potential, 0.5 * 20.0 * 0.25);

    // The drives balance the actuators, which are no passive elements.
    let bias = railway.bias_efforts(&state, &inputs).expect("finite efforts");
    near(bias[0], 1.0);
    near(bias[1], -1.0);
    let passive = railway.passive_efforts(&state, &inputs).expect("finite efforts");
    near(passive[0], 10.0);
    near(passive[1], -10.0);
    let linearization = railway.linearize(&state, &inputs).expect("a regular chain");
    near(linearization.by_inputs[0], -0.5);
    near(linearization.by_inputs[1], 0.5);
    let names = Railway::<f64>::DESCRIPTION.inputs().iter().map(|input| input.name.to_string());
    assert_eq!(names.collect::<Vec<_>>(), ["ram.force"]);
}

mstmm_chain! {
    chain Hexapod {
        gravity = [0, 0, -9.81] m/s^2;
        param gas = 40 N;
        body Trunk {
            mass = 8 kg;
            com = [0.1, 0, 0.05] m;
            inertia = diag(0.2, 0.3, 0.4) kg*m^2 about com;
            point hip = [0.3, 0.2, 0] m;
            point rail = [-0.2, 0, 0.4] m;
        }
        body Limb {
            mass = 1.5 kg;
            com = [0.1, 0, -0.2] m;
            output = [0.05, 0, -0.5] m turned rpy(10, 20, 30) deg;
            inertia = diag(0.02, 0.03, 0.01) kg*m^2 about com;
            point lug = [0.05, 0.02, -0.1] m;
        }
        Trunk trunk;
        trunk.hip -> universal(x, y) hip -> Limb thigh -> pin(y) knee -> Limb shank;
        trunk.rail -> repeat 3 { pin([1, 2, 3]) joint -> Limb each };
        spring ram { on = thigh.lug; to = trunk.com; force = input; damping = 3 N*s/m; }
        spring strut { on = shank.lug; to = thigh.lug; stiffness = 50 N/m; length = 0.3 m; force = gas; }
        spring pull { on = shank.output; to = [1, 2, 3] m; force = input; }
        spring muscle { on = each.output; to = trunk.hip; force = input; damping = 2 N*s/m; }
    }
}

/// dE/dt is a difference of terms of up to some thousand W, each of some hundred roundings.
const TOLERANCE: f64 = 1e-13;
const LARGEST_POWER: f64 = 1e4;

#[test]
fn actuators_supply_force_times_rate_of_length() {
    let mut robot = Hexapod::<f64>::new();
    robot.set_gas(-25.0).expect("any force");
    let mut same = Hexapod::<Dual<f64>>::new();
    same.set_gas(Dual::from(-25.0)).expect("any force");
    let (mut state, mut at) = (robot.initial_state(), robot.workspace());
    for seed in 0..50 {
        let mut random = Random::new(seed);
        state.rates_mut().iter_mut().for_each(|rate| *rate = random.between(-2.0, 2.0));
        state.coordinates_mut().iter_mut().for_each(|q| *q += random.between(-0.2, 0.2));
        robot.normalize(&mut state);
        let mut force = || random.between(-50.0, 50.0);
        let inputs = HexapodInputs {
            ram_force: force(),
            pull_force: force(),
            muscle_force: [force(), force(), force()],
        };
        robot.solve_into(&state, &inputs, &mut at).expect("a regular chain");
        let power = |spring: &mstmm::SpringResult<f64, _>, force: f64, damping: f64| {
            let rate = spring.length_rate();
            force * rate - damping * rate * rate
        };
        let muscles = inputs.muscle_force.iter().enumerate();
        let muscles = muscles.map(|(index, &force)| {
            power(&at.muscle(index).expect("three repetitions"), force, 2.0)
        });
        let expected = power(&at.ram(), inputs.ram_force, 3.0)
            + power(&at.strut(), -25.0, 0.0)
            + power(&at.pull(), inputs.pull_force, 0.0)
            + muscles.sum::<f64>();
        let off = worst(0.0, (energy_rate(&robot, &same, &state, &inputs) - expected).abs());
        assert!(off < TOLERANCE * LARGEST_POWER, "seed {seed}: off by {off:e} of {expected}");
    }
}
