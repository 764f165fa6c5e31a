//! The setting `results`: the selected results equal those of a chain with all results, and no others exist.

mod support;

use mstmm::description::Origin;
use mstmm::prelude::*;
use mstmm::{Error, GeneratedChain, HingeMotion};
use mstmm_reference::Random;
use std::collections::BTreeSet;
use std::fmt::Debug;
use support::printed::quantities;
use support::states::{copied, random_state};
use support::{difference, worst};

/// Random states tried of each chain.
const STATES: u64 = 20;

/// Programs with fewer results share less and add up in other orders: like repeated parts beside what is
/// written out they round some hundred times on the way to a number, in chains whose condition is
/// below a hundred.
const TOLERANCE: f64 = 1e3 * f64::EPSILON;

const POSES: &[&str] = &["position", "rotation", "cos_sin"];
const VELOCITIES: &[&str] = &["velocity", "angular_velocity"];
const Z: &[&str] = &["acceleration", "angular_acceleration", "moment", "force"];
const ENERGIES: &[&str] = &["kinetic_energy", "potential_energy"];

/// What sets the inputs of a chain from numbers.
type Set<C> = fn(&mut <C as Chain>::Inputs, &[f64]);

/// Compares a chain that leaves all these results out with one that has everything.
fn check<A, B>(everything: Set<A>, fewer: Set<B>, left_out: &[&[&str]])
where
    A: GeneratedChain<Scalar = f64, Workspace: Debug> + Default,
    B: GeneratedChain<Scalar = f64, Workspace: Debug> + Default,
{
    let (a, b) = (A::default(), B::default());
    let (mut at, mut fewer_at) = (a.workspace(), b.workspace());
    let left_out: BTreeSet<&str> = left_out.iter().copied().flatten().copied().collect();
    let mut largest = 0.0;
    for seed in 0..STATES {
        let mut random = Random::new(seed);
        let state = random_state::<A>(&mut random);
        let given = [(); 16].map(|()| random.between(-1.0, 1.0));
        let (mut inputs, mut same) = (a.no_inputs(), b.no_inputs());
        everything(&mut inputs, &given);
        fewer(&mut same, &given);
        a.solve_into(&state, &inputs, &mut at).expect("regular");
        b.solve_into(&copied(&state), &same, &mut fewer_at).expect("regular");
        let (all, some) = (quantities(&at), quantities(&fewer_at));
        let expected = all.keys().filter(|name| !left_out.contains(&name[..]));
        assert!(some.keys().eq(expected), "{:?} of {:?}", some.keys(), all.keys());
        for (name, values) in &some {
            let off = difference(values, &all[name]);
            assert!(off <= TOLERANCE, "seed {seed}: {name} off by {off:e}");
            largest = worst(largest, off);
        }
    }
    println!("off by {largest:.1e} at most");
    let mut state: B::State = copied(&random_state::<A>(&mut Random::new(0)));
    state.rates_mut()[0] = f64::NAN;
    assert_eq!(
        b.solve_into(&state, &b.no_inputs(), &mut fewer_at),
        Err(Error::NotFinite(Origin::Rate(0)))
    );
    assert_eq!(format!("{fewer_at:?}"), format!("{:?}", b.workspace()), "something stays");
}

/// A chain with every choice of results, and a test that compares them.
macro_rules! chosen {
    ($test:ident: $kind:ident { $($items:tt)* } |$inputs:ident, $x:ident| $set:block) => {
        mod $test {
            use super::*;

            mstmm_chain! {
                $kind chain Everything { $($items)* }
                $kind chain Poses { results = poses; $($items)* }
                $kind chain Velocities { results = [velocities]; $($items)* }
                $kind chain Z { results = z; $($items)* }
                $kind chain Energies { results = energies; $($items)* }
                $kind chain Watched { results = [poses, velocities]; $($items)* }
                $kind chain Sound { $($items)* results = [energies, z, velocities, poses]; }
            }

            macro_rules! check {
                ($chain:ident without $left_out:expr) => {
                    check::<Everything<f64>, $chain<f64>>(
                        |$inputs, $x| $set,
                        |$inputs, $x| $set,
                        $left_out,
                    )
                };
            }

            #[test]
            fn selected_results_equal_all_results() {
                check!(Poses without &[VELOCITIES, Z, ENERGIES]);
                check!(Velocities without &[POSES, Z, ENERGIES]);
                check!(Z without &[POSES, VELOCITIES, ENERGIES]);
                check!(Energies without &[POSES, VELOCITIES, Z]);
                check!(Watched without &[Z, ENERGIES]);
                check!(Sound without &[]);
            }

            #[test]
            fn omitted_results_need_no_memory() {
                let everything = size_of::<EverythingWorkspace<f64>>();
                assert_eq!(size_of::<SoundWorkspace<f64>>(), everything);
                let fewer = [
                    size_of::<PosesWorkspace<f64>>(),
                    size_of::<VelocitiesWorkspace<f64>>(),
                    size_of::<ZWorkspace<f64>>(),
                    size_of::<EnergiesWorkspace<f64>>(),
                    size_of::<WatchedWorkspace<f64>>(),
                ];
                assert!(fewer.iter().all(|&size| size < everything), "{fewer:?}, {everything}");
            }
        }
    };
}

chosen! {
    in_space: space {
        gravity = input;
        body Cube {
            mass = 1 kg;
            com = [0.5, 0.1, 0] m;
            output = [1, 0, 0.2] m turned rpy(20, -30, 50) deg;
            inertia = diag(1/6, 5/12, 5/12) kg*m^2 about com;
        }
        ground at [0, 1, 0] m turned rpy(10, 20, 30) deg
            -> ball shoulder -> Cube upper -> weld glue -> Cube glued
            -> universal(y, z) elbow -> Cube lower -> pin([1, 2, 3]) driven -> Cube tool;
        hinge shoulder { torque = input; stiffness = 3 N*m; }
        hinge driven { motion = input; }
        load push { on = tool; at = output; force = input; torque = input; }
    } |inputs, x| {
        inputs.gravity = [x[0], x[1], 9.0 + x[2]].into();
        inputs.shoulder = [x[3], x[4], x[5]].into();
        let state = mstmm::PinState::new(x[6], x[7]);
        inputs.driven = HingeMotion { state, acceleration: x[8] };
        inputs.push_force = [x[9], x[10], x[11]].into();
        inputs.push_torque = [x[12], x[13], x[14]].into();
    }
}

chosen! {
    in_loops: space {
        gravity = [1, -9.8, 2] m/s^2;
        body Cube {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0.2] m turned rpy(20, -30, 50) deg;
            inertia = diag(1/6, 5/12, 5/12) kg*m^2 about com;
        }
        ground -> pin(y) base -> Cube first
            -> repeat 4 { ball joint -> Cube link -> pin(x) wrist -> Cube hand }
            -> slider(z) last -> Cube tip;
        hinge wrist { torque = input; damping = 0.1 N*m*s; }
    } |inputs, x| {
        inputs.wrist.copy_from_slice(&x[..4]);
    }
}

chosen! {
    in_loops_from_the_ground: space {
        gravity = [1, -9.8, 2] m/s^2;
        body Cube {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0.2] m turned rpy(20, -30, 50) deg;
            inertia = diag(1/6, 5/12, 5/12) kg*m^2 about com;
        }
        ground -> repeat 3 { pin joint -> Cube link };
        hinge joint { torque = input; }
    } |inputs, x| {
        inputs.joint.copy_from_slice(&x[..3]);
    }
}

chosen! {
    in_the_plane: plane {
        gravity = [0, -9.8] m/s^2;
        body Rod {
            mass = 1 kg;
            com = [0.5, 0.1] m;
            output = [1, 0] m turned 20 deg;
            inertia = 1/12 kg*m^2 about com;
        }
        ground -> pin a -> Rod b -> slider([1, 1]) c -> Rod d -> pin e -> Rod f;
        hinge a { torque = input; }
        spring rope { on = f; at = output; to = [1, 2] m; stiffness = 5 N/m; length = 0.5 m; }
    } |inputs, x| {
        inputs.a = x[0];
    }
}

chosen! {
    on_a_line: line {
        gravity = -9.8 m/s^2;
        body Cart { mass = 1 kg; com = 0.1 m; output = 0.3 m; }
        ground -> slider first -> Cart front -> slider second -> Cart rear;
        hinge first { force = input; }
        hinge second { stiffness = 10 N/m; damping = 1 N*s/m; }
    } |inputs, x| {
        inputs.first = x[0];
    }
}

chosen! {
    closed: plane {
        gravity = [0, -9.8] m/s^2;
        body Crank { mass = 1 kg; com = [0.2, 0] m; output = [0.4, 0] m; inertia = 0.02 kg*m^2 about com; }
        body Rod { mass = 2 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 0.2 kg*m^2 about com; }
        ground -> pin a -> Crank crank -> pin b -> Rod rod -> pin c -> Crank rocker
            -> pin d -> ground at [0.9, 0.1] m;
        hinge a { torque = input; }
    } |inputs, x| {
        inputs.a = x[0];
    }
}
