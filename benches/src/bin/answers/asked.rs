//! The chains that are asked.

use mstmm::nalgebra::{SMatrix, SVector};
use mstmm::{Error, GeneratedChain};
use mstmm_benches::Lanes;

use crate::models::{
    Balls3, Balls3Variation, Balls30, Balls30Variation, G1, G1Variation, Hyq, HyqVariation, Panda,
    PandaVariation,
};
use crate::questions::{
    inertial_of, jacobian, jacobian_of, matrices, regressor, regressor_of, samples_of, square_of,
    vector_of, vectors,
};
use crate::sample::{Run, Sample, Task, entries, perform, rows, samples_of};

/// A chain with answers.
pub trait Asked: GeneratedChain<Scalar: Lanes, State: Default> + Default {
    /// Performs a task with the answer to a question; `None` if the question is not known.
    fn run(&self, question: &str, numbers: &[f64], task: Task) -> Option<Result<Run, Error>>;
}

/// Implements the trait, from [sizes](vector_of), the macros with the questions, the tip, and the inputs with torques in
/// the order of the rates.
macro_rules! asked {
    (
        $chain:ident,
        $variation:ident,
        $sizes:tt,
        [$($questions:ident)*],
        $tip:tt,
        |$inputs:ident, $torques:ident| $set:expr
        $(, |$damped:ident| $remove:expr)?
    ) => {
        impl<T: Lanes> Asked for $chain<T> {
            fn run(
                &self,
                question: &str,
                numbers: &[f64],
                task: Task,
            ) -> Option<Result<Run, Error>> {
                #[allow(unused_mut, reason = "some chains have no dampers")]
                let mut chain = self.clone();
                $(
                    let $damped = &mut chain;
                    $remove;
                )?
                let chain = &chain;
                let samples =
                    samples_of!(chain, $chain, $variation, $sizes, numbers, |$inputs, $torques| $set);
                None
                    $(.or_else(|| {
                        $questions!(chain, samples, task, question, $variation, $sizes, $tip)
                    }))*
            }
        }
    };
}

/// Sets the torques of hinges by name.
macro_rules! each_hinge {
    ($inputs:ident, $torques:expr, $($hinge:ident)*) => {{
        let hinges = [$(&mut $inputs.$hinge),*];
        for (hinge, torque) in hinges.into_iter().zip($torques) {
            *hinge = *torque;
        }
    }};
}

/// The rates of a floating base, which has no torques.
const FLOATING: usize = 6;

asked!(
    Panda,
    PandaVariation,
    (7, 0, 70, 70), [vectors jacobian regressor matrices],
    (l7_jacobian_into, [0.0, 0.0, 0.107]),
    |inputs, torques| each_hinge!(inputs, torques, j1 j2 j3 j4 j5 j6 j7)
);
asked!(Balls3, Balls3Variation, (9, 0, 30, 30), [vectors jacobian regressor matrices],
    (b3_jacobian_into, [1.0, 0.0, 0.0]), |inputs, torques| {
    let hinges = [&mut inputs.j1, &mut inputs.j2, &mut inputs.j3];
    for (hinge, torque) in hinges.into_iter().zip(torques.as_chunks::<3>().0) {
        *hinge = (*torque).into();
    }
});
asked!(Balls30, Balls30Variation, (90, 0, 300, 300), [vectors jacobian regressor matrices],
    (|at| at.cube(29).map(|cube| cube.output())), |inputs, torques| {
    for (hinge, torque) in inputs.joint.iter_mut().zip(torques.as_chunks::<3>().0) {
        *hinge = (*torque).into();
    }
});
asked!(
    Hyq,
    HyqVariation,
    (18, 6, 142, 130), [vectors jacobian regressor matrices],
    (rh_shank_jacobian_into, [0.346, 0.0, 0.0]),
    |inputs, torques| each_hinge!(inputs, &torques[FLOATING..],
        lf_haa lf_hfe lf_kfe rf_haa rf_hfe rf_kfe lh_haa lh_hfe lh_kfe rh_haa rh_hfe rh_kfe),
    |chain| {
        // Zero is a damping that is never refused.
        let _ = chain.set_damping(T::constant(0.0));
    }
);
asked!(
    G1,
    G1Variation,
    (35, 6, 300, 300), [vectors jacobian regressor matrices],
    (right_arm_wrist_yaw_link_jacobian_into, [0.0; 3]),
    |inputs, torques| each_hinge!(inputs, &torques[FLOATING..],
    waist_yaw waist_roll waist_pitch
    left_leg_hip_pitch left_leg_hip_roll left_leg_hip_yaw
    left_leg_knee left_leg_ankle_pitch left_leg_ankle_roll
    right_leg_hip_pitch right_leg_hip_roll right_leg_hip_yaw
    right_leg_knee right_leg_ankle_pitch right_leg_ankle_roll
    left_arm_shoulder_pitch left_arm_shoulder_roll left_arm_shoulder_yaw left_arm_elbow
    left_arm_wrist_roll left_arm_wrist_pitch left_arm_wrist_yaw
    right_arm_shoulder_pitch right_arm_shoulder_roll right_arm_shoulder_yaw right_arm_elbow
    right_arm_wrist_roll right_arm_wrist_pitch right_arm_wrist_yaw)
);
