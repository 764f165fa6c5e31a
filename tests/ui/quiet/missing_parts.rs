//! Parts that cannot be read: what is behind them is known all the same.

use mstmm::prelude::*;

mstmm_chain! {
    chain Arrow {
        body Rod { mass = 1 kg; com = [1, 0, 0] m; output = [1, 0, 0] m; inertia = diag(1, 1, 1) about com; }
        ground -> pin a -> Rod one ball b -> Rod two -> repeat three { pin c -> Rod each } -> pin d -> Rod last;
        hinge b { torque = input; }
    }

    chain Semicolon {
        body Rod { mass = 1 kg; com = [1, 0, 0] m; output = [1, 0, 0] m; inertia = diag(1, 1, 1) about com; }
        ground -> pin a -> Rod one; -> ball b -> Rod two;
        hinge b { torque = input; }
    }

    chain Second {
        body Rod { mass = 1 kg; com = [1, 0, 0] m; output = [1, 0, 0] m; inertia = diag(1, 1, 1) about com; }
        ground -> pin a -> Rod one;
        moving deck -> ball b -> Rod two;
        hinge b { torque = input; }
        load push { on = two; force = input; }
    }

    chain Branch {
        body Rod { mass = 1 kg; com = [1, 0, 0] m; output = [1, 0, 0] m; inertia = diag(1, 1, 1) about com; }
        ground -> pin a -> Rod hub -> { pin b -> Rod left, ball c -> Rod right };
        hinge c { torque = input; }
    }

    chain Tree {
        body Rod { mass = 1 kg; com = [1, 0, 0] m; output = [1, 0, 0] m; inertia = diag(1, 1, 1) about com; }
        part Leg(side) {
            body Hip {
                mass = 1 kg; com = [0, 0, 0] m; output = [side, 0, 0] m; inertia = diag(1, 1, 1) about com;
                point toe = [0, 0, 0] m;
            }
            pin a -> Hip hip -> ball b -> Rod rod;
            load push { on = rod; force = input; }
        }
        Rod trunk;
        trunk.output -> Leg(1, 2) left;
        trunk.top -> Leg(-1) right;
        hinge left.a { torque = input; }
    }

    chian Named {
        body Rod { mass = 1 kg; com = [1, 0, 0] m; output = [1, 0, 0] m; inertia = diag(1, 1, 1) about com; }
        ground -> pin -> Rod one -> ball b -> Rod two;
        hinge a { torque = input; }
    }
}

fn main() {
    let arrow = Arrow::<f64>::new();
    let state = arrow.initial_state();
    let _ = (state.a().angle(), state.b().rate(), state.c(1).map(|c| c.angle()), state.d().angle());
    let _ = ArrowInputs::<f64> { b: [0.0; 3].into() };
    let _ = (arrow.workspace().each(0).map(|each| each.input().force()), arrow.workspace().last().input());

    let semicolon = Semicolon::<f64>::new();
    let _ = (semicolon.initial_state().b().rate(), semicolon.workspace().two().input());
    let _ = SemicolonInputs::<f64> { b: [0.0; 3].into() };

    let second = Second::<f64>::new();
    let _ = (second.initial_state().b().rate(), second.workspace().two().input());
    let _ = SecondInputs::<f64> {
        deck: mstmm::HingeMotion::default(),
        b: [0.0; 3].into(),
        push_force: [0.0; 3].into(),
    };

    let tree = Tree::<f64>::new();
    let _ = (tree.initial_state().left_a().angle(), tree.initial_state().right_b().rate());
    let hip: TreeLegHipResult<f64> = tree.workspace().right_hip();
    let _ = (hip.toe().position(), tree.workspace().trunk().output().position());
    let _ = TreeInputs::<f64> { left_a: 0.0, left_push_force: [0.0; 3].into() };

    let branch = Branch::<f64>::new();
    let _ = (branch.initial_state().c().rate(), branch.workspace().left().input(), branch.workspace().right());
    let _ = BranchInputs::<f64> { c: [0.0; 3].into() };

    let named = Named::<f64>::new();
    let _ = (named.initial_state().a().angle(), named.workspace().two().input());
    let _ = NamedInputs::<f64> { a: 0.0 };
}
