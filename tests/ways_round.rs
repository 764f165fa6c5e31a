//! Alternatives that error messages suggest for mechanisms that are not chains: springs between bodies, loops
//! over a body and branches, by pairs of loads that are computed at each step.

use mstmm::nalgebra::Vector2;
use mstmm::prelude::*;

/// The force of a spring with a damper on its first end, from the positions and the velocities of
/// both ends.
fn spring(
    [stiffness, damping]: [f64; 2],
    [first, second]: [(Vector2<f64>, Vector2<f64>); 2],
) -> Vector2<f64> {
    (second.0 - first.0) * stiffness + (second.1 - first.1) * damping
}

/// Position and velocity of a point of a body, from those of its input.
macro_rules! end {
    ($point:expr, $place:expr) => {{
        let (point, place) = ($point, Vector2::from($place));
        let arm = point.orientation() * place;
        let across = Vector2::new(-arm.y, arm.x);
        (point.position() + arm, point.velocity() + across * point.angular_velocity())
    }};
}

mstmm_chain! {
    line chain Joined {
        body Car { mass = 2 kg; output = 3 m; }
        Car front -> elastic coupling -> Car rear;
        hinge coupling { start = 0.1 m; stiffness = 50 N/m; damping = 2 N*s/m; }
    }
    line chain Loaded {
        body Car { mass = 2 kg; output = 3 m; }
        Car front -> elastic coupling -> Car rear;
        hinge coupling { start = 0.1 m; }
        load pull_front { on = front; at = output; force = input; }
        load pull_rear { on = rear; at = input; force = input; }
    }
}

#[test]
fn two_loads_are_a_spring_between_two_bodies() {
    let (joined, loaded) = (Joined::<f64>::new(), Loaded::<f64>::new());
    let (mut a, mut b) = (joined.initial_state(), loaded.initial_state());
    let (mut first, mut second) = (Rk4::new(1e-2), Rk4::new(1e-2));
    let mut at = loaded.workspace();
    for _ in 0..100 {
        first.step(&joined, &mut a, |_, _| joined.no_inputs()).expect("a step");
        second
            .step(&loaded, &mut b, |_, state| {
                // Positions and velocities are there whatever the inputs are.
                loaded.solve_into(state, &loaded.no_inputs(), &mut at).expect("a solution");
                let (front, rear) = (at.front().output(), at.rear().input());
                let stretch = rear.position() - front.position();
                let rate = rear.velocity() - front.velocity();
                let force = 50.0 * stretch + 2.0 * rate;
                LoadedInputs { pull_front_force: force, pull_rear_force: -force }
            })
            .expect("a step");
    }
    // The same numbers but for the order of their sums, in a hundred steps.
    for (x, y) in a.coordinates().iter().zip(b.coordinates()).chain(a.rates().iter().zip(b.rates()))
    {
        assert!((x - y).abs() < 1e-13, "{x} is not {y}");
    }
}

mstmm_chain! {
    plane chain Closed {
        gravity = [0, -9.81] m/s^2;
        body Bar { mass = 1 kg; com = [0.5, 0] m; inertia = 1/12 kg*m^2 about com; output = [1, 0] m; }
        ground -> pin a -> Bar crank -> pin b -> Bar coupler -> pin c -> Bar rocker
               -> pin d -> ground at [1, 0] m;
        hinge a { start = 60 deg; }
        hinge b { start = -60 deg; }
        hinge c { start = -120 deg; }
    }
    plane chain Cut {
        gravity = [0, -9.81] m/s^2;
        body Base { mass = 1 kg; com = [0, 0] m; inertia = 1 kg*m^2 about com; output = [0, 0] m; }
        body Bar { mass = 1 kg; com = [0.5, 0] m; inertia = 1/12 kg*m^2 about com; output = [1, 0] m; }
        ground -> weld held -> Base base -> pin a -> Bar crank -> pin b -> Bar coupler
               -> pin c -> Bar rocker;
        hinge a { start = 60 deg; }
        hinge b { start = -60 deg; }
        hinge c { start = -120 deg; }
        load on_base { on = base; at = [1, 0] m; force = input; }
        load on_rocker { on = rocker; at = output; force = input; }
    }
}

#[test]
fn two_loads_close_a_loop_over_a_body() {
    let (closed, cut) = (Closed::<f64>::new(), Cut::<f64>::new());
    let (mut a, mut b) = (closed.initial_state(), cut.initial_state());
    closed.assemble(&mut a, &closed.no_inputs()).expect("a closed chain");
    let step = 1e-4;
    let (mut first, mut second) = (Rk4::new(step), Rk4::new(step));
    let mut at = cut.workspace();
    let mut gap = 0.0_f64;
    for _ in 0..5000 {
        first.step(&closed, &mut a, |_, _| closed.no_inputs()).expect("a step");
        second
            .step(&cut, &mut b, |_, state| {
                cut.solve_into(state, &cut.no_inputs(), &mut at).expect("a solution");
                let ends =
                    [end!(at.base().input(), [1.0, 0.0]), end!(at.rocker().input(), [1.0, 0.0])];
                gap = gap.max((ends[1].0 - ends[0].0).norm());
                let force = spring([1e6, 1e3], ends);
                CutInputs { on_base_force: force, on_rocker_force: -force }
            })
            .expect("a step");
    }
    // The spring gives by the weight of the bars over its stiffness, some 1e-5 m.
    assert!(gap < 1e-4, "{gap} m");
    assert!((a.a().angle() - b.a().angle()).abs() < 1e-3, "{} {}", a.a().angle(), b.a().angle());
    assert!((a.a().angle() - 60_f64.to_radians()).abs() > 0.1, "nothing moves");
}

mstmm_chain! {
    plane chain Through {
        gravity = [0, -9.81] m/s^2;
        body Arm { mass = 1 kg; com = [0.5, 0] m; inertia = 1/12 kg*m^2 about com; output = [1, 0] m; }
        body Hub { mass = 4 kg; com = [0, 0] m; inertia = 1 kg*m^2 about com; output = [0.5, 0] m; }
        Arm left -> pin a -> Hub hub -> pin b -> Arm right;
        hinge a { start_rate = 1 rad/s; }
        hinge b { start_rate = 3 rad/s; }
    }
    plane chain Trunk {
        gravity = [0, -9.81] m/s^2;
        body Arm { mass = 1 kg; com = [0.5, 0] m; inertia = 1/12 kg*m^2 about com; output = [1, 0] m; }
        body Hub { mass = 4 kg; com = [0, 0] m; inertia = 1 kg*m^2 about com; output = [0.5, 0] m; }
        Arm left -> pin a -> Hub hub;
        hinge a { start_rate = 1 rad/s; }
        load branch { on = hub; at = output; force = input; }
    }
    plane chain Branch {
        gravity = [0, -9.81] m/s^2;
        body Arm { mass = 1 kg; com = [0.5, 0] m; inertia = 1/12 kg*m^2 about com; }
        Arm right;
        load trunk { on = right; at = input; force = input; }
    }
}

/// A step of semi-implicit Euler uses the forces at its start: both chains together move as one.
#[test]
fn two_loads_join_a_branch_to_its_trunk() {
    let (through, trunk, branch) =
        (Through::<f64>::new(), Trunk::<f64>::new(), Branch::<f64>::new());
    let (mut whole, mut a, mut b) =
        (through.initial_state(), trunk.initial_state(), branch.initial_state());
    let mut at = through.workspace();
    through.solve_into(&whole, &through.no_inputs(), &mut at).expect("a solution");
    let start = at.right().input();
    b.right_mut()
        .set_position(start.position())
        .set_velocity(start.velocity())
        .set_rate(start.angular_velocity());

    let (mut on_trunk, mut on_branch) = (trunk.workspace(), branch.workspace());
    let step = 2e-5;
    let mut all = SemiImplicitEuler::new(step);
    let (mut first, mut second) = (SemiImplicitEuler::new(step), SemiImplicitEuler::new(step));
    for _ in 0..25_000 {
        trunk.solve_into(&a, &trunk.no_inputs(), &mut on_trunk).expect("a solution");
        branch.solve_into(&b, &branch.no_inputs(), &mut on_branch).expect("a solution");
        let (hub, right) = (on_trunk.hub().output(), on_branch.right().input());
        let ends = [(hub.position(), hub.velocity()), (right.position(), right.velocity())];
        let force = spring([1e6, 1e3], ends);
        all.step(&through, &mut whole, |_, _| through.no_inputs()).expect("a step");
        first.step(&trunk, &mut a, |_, _| TrunkInputs { branch_force: force }).expect("a step");
        second.step(&branch, &mut b, |_, _| BranchInputs { trunk_force: -force }).expect("a step");
    }
    through.solve_into(&whole, &through.no_inputs(), &mut at).expect("a solution");
    branch.solve_into(&b, &branch.no_inputs(), &mut on_branch).expect("a solution");
    let (exact, coupled) = (at.right().input(), on_branch.right().input());
    let apart = (exact.position() - coupled.position()).norm();
    assert!(apart < 1e-3, "{apart} m");
    let turned = (exact.angular_velocity() - coupled.angular_velocity()).abs();
    assert!(turned < 1e-2, "{turned} rad/s");
}
