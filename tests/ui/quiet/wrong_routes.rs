//! Routes are wrong: what is on them can be called all the same.

use mstmm::prelude::*;

mstmm_chain! {
    chain Two {
        body Rod { mass = 1 kg; com = [0.5, 0, 0] m; inertia = diag(1, 1, 1) about com; output = [1, 0, 0] m; }
        ground -> pin first -> ball second -> Rod rod -> Rod other -> pin last;
        hinge second { torque = input; }
    }

    chain Misspelt {
        body Rod { mass = 1 kg; com = [0.5, 0, 0] m; inertia = diag(1, 1, 1) about com; output = [1, 0, 0] m; }
        ground -> pim first -> Rod rod -> pin second -> Rood other;
        hinge second { tork = input; }
    }

    plane chain Flat {
        body Rod { mass = 1 kg; com = [0.5, 0] m; inertia = 1 about com; output = [1, 0] m; }
        ground -> ball first -> Rod rod -> repeat 2 { Rod again -> pin joint } -> pin first -> Rod end;
    }

    line chain Rowless {}
}

fn main() {
    let two = Two::<f64>::new();
    let mut state = two.initial_state();
    state.first_mut().set_angle(1.0);
    state.last_mut().set_angle(1.0);
    let inputs = TwoInputs { second: [1.0, 0.0, 0.0].into() };
    let mut at = two.workspace();
    let _ = two.solve_into(&state, &inputs, &mut at);
    println!("{} {}", at.other().input().force(), at.last().effort());

    let misspelt = Misspelt::<f32>::new();
    let mut state = misspelt.initial_state();
    state.first_mut().set_angle(0.0);
    let mut euler = SemiImplicitEuler::new(1e-3);
    let _ = euler.step(&misspelt, &mut state, |_, _| misspelt.no_inputs());
    println!("{}", state.second().rate());

    let flat = Flat::<f64>::default();
    println!("{:?}", flat.initial_state().joint(1).map(|joint| joint.angle()));
    println!("{:?}", flat.energy(&FlatState::default()));

    let _: RowlessWorkspace<f64> = Rowless::new().workspace();
}
