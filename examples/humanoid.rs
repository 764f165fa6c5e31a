//! A humanoid stands on springy joints, is pushed, and stands again: each foot carries half of the weight.
//!
//! `cargo run --release --example humanoid`; with `-- --page humanoid.html` it also writes a page that shows the motion.

mod page;

use mstmm::nalgebra::Vector3;
use mstmm::prelude::*;
use mstmm::{BodyPoint, Point};
use page::Page;

mstmm_chain! {
    /// A tree: a trunk that floats, two legs and two arms, each of a `part`. x points forward, y to the left.
    chain Humanoid {
        gravity = [0, 0, -9.81] m/s^2;
        body Trunk {
            mass = 30 kg; com = [0, 0, 0.25] m; inertia = diag(0.9, 0.8, 0.3) kg*m^2 about com;
            output = [0, 0, 0.5] m;
            point left_hip = [0, 0.1, 0] m; point left_shoulder = [0, 0.2, 0.45] m;
            point right_hip = [0, -0.1, 0] m; point right_shoulder = [0, -0.2, 0.45] m;
        }
        body Head { mass = 5 kg; com = [0, 0, 0.12] m; inertia = diag(0.03, 0.03, 0.02) kg*m^2 about com; }
        part Leg(side) {
            body Bone {
                mass = 5 kg; com = [0, 0, -0.18] m; inertia = diag(0.07, 0.07, 0.01) kg*m^2 about com;
                output = [0, 0, -0.4] m;
            }
            body Foot {
                mass = 1 kg; com = [0.04, 0, -0.04] m; inertia = diag(0.002, 0.004, 0.004) kg*m^2 about com;
                point heel = [-0.1, 0, -0.08] m;
                point toe = [0.14, -side*0.03, -0.08] m; point small_toe = [0.14, side*0.04, -0.08] m;
            }
            ball hip -> Bone thigh -> pin(y) knee -> Bone shank -> universal(y, x) ankle -> Foot foot;
            hinge hip, knee, ankle { stiffness = 2500 N*m/rad; damping = 200 N*m*s/rad; armature = 0.1 kg*m^2; }
            load heel { on = foot.heel; force = input; }
            load toe { on = foot.toe; force = input; }
            load small_toe { on = foot.small_toe; force = input; }
        }
        part Arm {
            body Bone {
                mass = 1.5 kg; com = [0, 0, -0.12] m; inertia = diag(0.01, 0.01, 0.001) kg*m^2 about com;
                output = [0, 0, -0.28] m;
            }
            ball shoulder -> Bone upper -> pin(y) elbow -> Bone lower;
            hinge shoulder, elbow { stiffness = 20 N*m/rad; damping = 2 N*m*s/rad; }
        }
        Trunk trunk -> weld neck -> Head head;
        trunk.left_hip -> Leg(1) left_leg;
        trunk.right_hip -> Leg(-1) right_leg;
        trunk.left_shoulder -> Arm left_arm;
        trunk.right_shoulder -> Arm right_arm;
        load push { on = trunk.output; force = input; }
        body trunk { start = [0, 0, 0.88] m; }
    }
}

/// Returns the points of the soles, first those of the left foot.
fn soles(at: &HumanoidWorkspace<f64>) -> [BodyPoint<Point<f64>>; 6] {
    let (left, right) = (at.left_leg_foot(), at.right_leg_foot());
    [left.heel(), left.toe(), left.small_toe(), right.heel(), right.toe(), right.small_toe()]
}

/// Returns the forces of the floor in N: a spring and a damper hold each point below z = 0 to its place at the start.
fn floor(at: &HumanoidWorkspace<f64>, start: &[Vector3<f64>; 6]) -> [Vector3<f64>; 6] {
    let soles = soles(at).map(|point| (point.position(), point.velocity()));
    std::array::from_fn(|k| match soles[k] {
        (position, velocity) if position.z <= 0.0 => (start[k] - position) * 1e5 - velocity * 300.0,
        _ => Vector3::zeros(),
    })
}

fn main() -> Result<(), mstmm::Error> {
    let humanoid = Humanoid::<f64>::new();
    let mut state = humanoid.initial_state();
    let mut at = humanoid.workspace();
    humanoid.solve_into(&state, &humanoid.no_inputs(), &mut at)?;
    let start = soles(&at).map(|point| point.position());
    let inputs = |time: f64, state: &HumanoidState<f64>, at: &mut HumanoidWorkspace<f64>| {
        humanoid.solve_into(state, &humanoid.no_inputs(), at)?;
        let force = floor(at, &start);
        Ok::<_, mstmm::Error>(HumanoidInputs {
            push_force: Vector3::x() * if (1.0..1.2).contains(&time) { 40.0 } else { 0.0 },
            left_leg_heel_force: force[0],
            left_leg_toe_force: force[1],
            left_leg_small_toe_force: force[2],
            right_leg_heel_force: force[3],
            right_leg_toe_force: force[4],
            right_leg_small_toe_force: force[5],
        })
    };
    let mut page = Page::of(&humanoid, 1);
    let mut rk4 = Rk4::new(1e-3);
    for frame in 0..500 {
        let time = 0.02 * frame as f64;
        page.record(&state, &inputs(time, &state, &mut at)?)?;
        let end = 0.02 * (frame + 1) as f64;
        rk4.try_advance_to(&humanoid, &mut state, end, |time, state| inputs(time, state, &mut at))?;
    }
    let now = inputs(10.0, &state, &mut at)?;
    humanoid.solve_into(&state, &now, &mut at)?;
    // At rest the floor carries 63 kg, half of it by each foot, and the legs carry 41 kg.
    let hips = [at.trunk().left_hip(), at.trunk().right_hip()].map(|hip| hip.force().z);
    for (feet, hip) in floor(&at, &start).chunks(3).zip(hips) {
        let foot = feet.iter().sum::<Vector3<f64>>().z;
        println!("floor on foot {foot:8.3} N, trunk on leg {hip:8.3} N");
        assert!((foot - 63.0 * 9.81 / 2.0).abs() < 1e-2 && (hip + 41.0 * 9.81 / 2.0).abs() < 1e-2);
    }
    page.write();
    Ok(())
}

#[test]
fn humanoid_stands_after_a_push() -> Result<(), mstmm::Error> {
    main()
}
