//! The surroundings of a chain: docs, visibility, other chains, and the location of the items.

mod two {
    mstmm::mstmm_chain! {
        /// Documented, and seen by all.
        pub chain Public {
            /// A body can be documented,
            body Rod {
                /// and so can a field.
                mass = 1 kg;
                com = [0, 0, 0];
                inertia = diag(1, 1, 1) about com;
            }
            /// So can the route,
            ground -> pin axle -> Rod rod;
            /// and the blocks after it.
            hinge axle { start = 1; torque = input; }
        }

        pub(super) space chain Neighbour {
            body Rod { mass = 1 kg; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; }
            ground -> pin axle -> Rod rod;
        }
    }

    mstmm::mstmm_chain! {
        // With a separate body type, under a name that other chains use, too.
        pub(crate) chain Crate {
            body Rod { mass = 2 kg; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; }
            ground -> pin axle -> Rod rod;
        }

        #[derive(Copy)]
        chain Private {
            body Rod { mass = 1 kg; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; }
            ground -> pin axle -> Rod rod;
        }
    }

    /// Attributes are the chain's.
    #[test]
    fn a_chain_can_be_copied_if_it_asks_to() {
        fn copy<T: Copy>(_: T) {}
        copy(Private::<f64>::new());
    }
}

#[test]
fn chains_are_types_of_their_scope() {
    let (public, neighbour, inside) =
        (two::Public::<f64>::new(), two::Neighbour::<f32>::new(), two::Crate::<f64>::new());
    let inputs = two::PublicInputs { axle: 3.0 };
    let accelerations = public.accelerations(&public.initial_state(), &inputs);
    assert_eq!(accelerations.expect("a regular chain")[0], 3.0);
    assert_eq!(neighbour.initial_state().axle().rate(), 0.0);
    assert_eq!(
        inside.initial_state(),
        <two::CrateState<f64> as mstmm::ChainState>::zero_position()
    );
    let _: (two::PublicParameters<f64>, two::PublicWorkspace<f64>) =
        (*public.parameters(), public.workspace());
}

/// A body without a name takes its type's.
#[test]
fn names_are_made_from_types() {
    mstmm::mstmm_chain! {
        chain Arm {
            body UpperArm {
                mass = 1;
                com = [0, 0, 0];
                output = [1, 0, 0];
                inertia = diag(1, 1, 1) about com;
            }
            body IMUCase { mass = 1; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; }
            ground -> pin shoulder -> UpperArm -> weld screw -> IMUCase;
        }
    }
    let arm = Arm::<f64>::new();
    let mut at = arm.workspace();
    arm.solve_into(&arm.initial_state(), &arm.no_inputs(), &mut at).expect("a regular chain");
    crate::assert_close(at.upper_arm().output().position(), [1.0, 0.0, 0.0]);
    assert_eq!(at.imu_case().input().position(), at.screw().output().position());
    assert_eq!(at.points().len(), 5);
}

/// The expansion does not need Rust's prelude.
#[no_implicit_prelude]
mod bare {
    ::mstmm::mstmm_chain! {
        pub chain Bare {
            gravity = [0, -9.81, 0] m/s^2;
            method = transfer;
            param load = 1 kg;
            body Rod {
                mass = 1 kg + load;
                com = [0.5, 0, 0] m;
                output = [1, 0, 0] m;
                inertia = diag(0.1, 1, 1) about com;
            }
            Rod first -> pin elbow -> Rod second -> ball wrist -> Rod third -> weld seam -> Rod last;
            hinge elbow, wrist { torque = input; }
        }
    }
}

#[test]
fn a_module_without_prelude_has_a_chain() {
    let bare = bare::Bare::<f64>::new();
    assert!(bare.accelerations(&bare.initial_state(), &bare.no_inputs()).is_ok());
}

/// The user's items may have any name, also one that the expansion uses.
#[allow(dead_code, unused_macros)]
mod crowded {
    mod core {}
    mod std {}
    mod nalgebra {}
    struct Option;
    struct Result;
    struct Default;
    struct Error;
    struct Energy;
    struct Point;
    enum Chain {}
    trait Scalar {}
    macro_rules! assert {
        () => {};
    }
    const MASS: f64 = 2.0;
    mstmm::mstmm_chain! {
        pub chain Crowded {
            body Rod { mass = MASS; com = [1, 0, 0]; inertia = diag(1, 1, 1) about com; }
            ground -> pin axle -> Rod rod;
            hinge axle { torque = 3 N*m; }
        }
    }
}

#[test]
fn a_module_full_of_names_has_a_chain() {
    let crowded = crowded::Crowded::<f64>::new();
    let accelerations = crowded.accelerations(&crowded.initial_state(), &crowded.no_inputs());
    assert_eq!(accelerations.expect("a regular chain")[0], 1.0);
}
