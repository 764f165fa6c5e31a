//! Robots that branch and float, written with parts.

use super::{case, each_hinge, mstmm_chain};
use crate::states::FLOATING;

include!("trees/hyq.chain");
include!("trees/g1.chain");

case!(
    Hyq,
    "HyQ",
    |inputs, torques| {
        let torques = &torques[FLOATING..];
        each_hinge!(inputs, torques:
            lf_haa lf_hfe lf_kfe rf_haa rf_hfe rf_kfe lh_haa lh_hfe lh_kfe rh_haa rh_hfe rh_kfe)
    },
    |chain| {
        // Zero is a damping that is never refused.
        let _ = chain.set_damping(T::constant(0.0));
    }
);

case!(G1, "G1", |inputs, torques| {
    let torques = &torques[FLOATING..];
    each_hinge!(inputs, torques:
        waist_yaw waist_roll waist_pitch
        left_leg_hip_pitch left_leg_hip_roll left_leg_hip_yaw
        left_leg_knee left_leg_ankle_pitch left_leg_ankle_roll
        right_leg_hip_pitch right_leg_hip_roll right_leg_hip_yaw
        right_leg_knee right_leg_ankle_pitch right_leg_ankle_roll
        left_arm_shoulder_pitch left_arm_shoulder_roll left_arm_shoulder_yaw left_arm_elbow
        left_arm_wrist_roll left_arm_wrist_pitch left_arm_wrist_yaw
        right_arm_shoulder_pitch right_arm_shoulder_roll right_arm_shoulder_yaw right_arm_elbow
        right_arm_wrist_roll right_arm_wrist_pitch right_arm_wrist_yaw)
});
