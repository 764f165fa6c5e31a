//! Names of generated items, keywords and names twice: each is one error, whatever is called by them.

use mstmm::prelude::*;

mstmm_chain! {
    chain Arm {
        param PLACES_ = 0.5 kg;
        param r#fn = 1 m;
        body r#type {
            mass = 1 kg + PLACES_;
            com = [r#fn, 0, 0];
            output = [1, 0, 0] m;
            inertia = diag(1, 1, 1) kg*m^2 about com;
            point r#in = [1, 0, 0] m;
        }
        ground -> pin points -> r#type accelerations -> ball kinetic_energy -> r#type potential_energy
            -> repeat 3 { pin point_ -> r#type each } -> pin r#loop -> r#type;
        hinge points, r#loop { torque = input; }
        load r#use { on = accelerations; force = input; }
        load wind { force = input; }
    }

    chain Arm {
        body Rod { mass = 1 kg; com = [1, 0, 0] m; inertia = diag(1, 1, 1) about com; }
        ground -> ball second -> Rod rod;
        hinge second { torque = input; }
        load { on = rod; force = input; }
    }

    chain r#type {
        body Rod { mass = 1 kg; com = [1, 0, 0] m; inertia = diag(1, 1, 1) about com; }
        moving -> ball joint -> Rod rod;
    }

    chain Last {
        body Rod { mass = 1 kg; com = [1, 0, 0] m; inertia = diag(1, 1, 1) about com; }
        ground -> ball joint -> Rod rod -> pin end;
    }
}

/// Types and traits that a user adds.
#[derive(Clone, Debug)]
struct Simulation {
    arm: Arm<f64>,
    state: ArmState<f64>,
    inputs: ArmInputs<f64>,
}

trait Controlled {
    type State;
    fn torque(&self, state: &Self::State) -> f64;
}

impl Controlled for Arm<f64> {
    type State = ArmState<f64>;
    fn torque(&self, state: &ArmState<f64>) -> f64 {
        -self.parameters().PLACES_() * state.points().angle()
    }
}

impl Controlled for Last<f64> {
    type State = LastState<f64>;
    fn torque(&self, state: &LastState<f64>) -> f64 {
        state.end().angle() + state.joint().rate()[0]
    }
}

impl Arm<f64> {
    fn total(&self, state: &ArmState<f64>) -> f64 {
        let (kinetic, potential) = self.energy(state);
        kinetic + potential
    }
}

impl From<ArmState<f64>> for Simulation {
    fn from(state: ArmState<f64>) -> Self {
        let arm = Arm::new();
        Simulation { inputs: arm.no_inputs(), arm, state }
    }
}

impl std::fmt::Display for ArmState<f64> {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "{}", self.points().angle())
    }
}

fn run<C: mstmm::Chain<Scalar = f64>>(
    chain: &C,
    state: &mut C::State,
    inputs: impl FnMut(f64, &C::State) -> C::Inputs,
) -> Result<(), mstmm::Error> {
    Rk4::new(1e-3).step(chain, state, inputs)
}

fn main() -> Result<(), mstmm::Error> {
    let mut arm = Arm::<f64>::new();
    arm.set_fn(2.0)?;
    arm.set_PLACES_(arm.parameters().r#fn())?;
    let mut state = arm.initial_state();
    state.points_mut().set_angle(1.0).set_rate(2.0);
    state.kinetic_energy_mut().set_rate([1.0, 0.0, 0.0].into());
    state.set_each_point_(|index| mstmm::PinState::new(index as f64, 0.0));
    state.second_mut().set_rate([1.0, 0.0, 0.0].into());
    let inputs = |_time: f64, state: &ArmState<f64>| ArmInputs {
        points: -state.points().angle(),
        r#loop: state.r#loop().rate(),
        use_force: [1.0, 0.0, 0.0].into(),
        wind_force: [1.0, 0.0, 0.0].into(),
        second: [0.0; 3].into(),
        ..arm.no_inputs()
    };
    Rk4::new(1e-3).step(&arm, &mut state, inputs)?;
    run(&arm, &mut state, |_, _| arm.no_inputs())?;
    let mut at = arm.workspace();
    arm.solve_into(&state, &arm.no_inputs(), &mut at)?;
    let [first, .., last] = at.points();
    println!("{} {}", first.position(), last.force());
    println!("{} {}", at.points().effort(), at.accelerations().r#in().position());
    println!("{} {}", at.accelerations()[0], at.kinetic_energy() + at.potential_energy());
    println!("{:?} {}", at.each(1).map(|each| each.input().velocity()), at.r#type().com().position());
    println!("{} {}", state, arm.total(&state) + arm.torque(&state));
    let simulation = Simulation::from(state.clone());
    let ArmState { q, v, t } = simulation.state;
    println!("{q} {v} {t} {:?} {:?}", simulation.arm, simulation.inputs);

    let chain = r#type::<f32>::default();
    let state: typeState<f32> = chain.initial_state();
    let end = typeInputs { base: mstmm::HingeMotion { state: state.joint(), acceleration: [0.0; 3].into() } };
    println!("{:?}", chain.accelerations(&state, &end));

    let last = Last::<f64>::new();
    println!("{}", last.torque(&LastState::default()));
    Ok(())
}
