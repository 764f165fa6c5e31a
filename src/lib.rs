// In the documentation the picture's file is not there; the first target of a link counts.
#![doc = concat!("[crane]: ", include_str!("crane.uri"))]
#![doc = include_str!("../README.md")]
#![no_std]
#![deny(missing_docs)]
// The documentation site shows which items need a feature.
#![cfg_attr(docsrs, feature(doc_cfg))]

#[doc = include_str!("frames.md")]
#[doc(alias("IMU", "accelerometer", "gyroscope", "gyro", "velocimeter", "specific force"))]
#[doc(alias("world_body", "worldbody", "universe", "Frame", "FixedOffsetFrame", "pos", "quat"))]
pub mod frames {}

#[doc = include_str!("terms.md")]
#[doc(alias("URDF", "xacro", "SDF", "MJCF", "sensor", "tree", "branch", "site"))]
#[doc(alias("aba", "EvalTimeDerivatives", "mj_rnePostConstraint", "cfrc_int", "Data::f"))]
#[doc(alias("get_reaction_forces_output_port", "Accelerometer", "Gyroscope"))]
#[doc(alias("MultibodyPlant", "Model", "mjModel", "Data", "Context"))]
#[doc(alias("CreateDefaultContext", "mj_resetData", "mj_resetDataKeyframe", "neutral"))]
#[doc(alias("GetPositions", "GetVelocities", "integrate", "mj_step", "Simulator::AdvanceTo"))]
#[doc(alias("normalize", "ten_length", "ten_velocity"))]
#[doc(alias(
    "AddCouplerConstraint",
    "JointModelMimic",
    "equality/joint",
    "mocap",
    "CalcBiasCenterOfMassTranslationalAcceleration"
))]
#[doc(alias("dccrba", "computeCentroidalMapTimeVariation"))]
#[doc(alias("computeCentroidalMomentumTimeVariation", "efc_pos"))]
#[doc(alias("DH", "Denavit-Hartenberg", "DH parameters", "DH table", "modified DH", "Craig"))]
#[doc(alias(
    "TSDA",
    "linear actuator",
    "tendon actuator",
    "hydraulic cylinder",
    "gas spring",
    "muscle"
))]
pub mod terms {}

pub mod hinges;
pub mod keywords;
pub mod tutorial;

#[doc(hidden)]
pub use mstmm_macros::mstmm_chain_by;
#[doc(inline)]
pub use mstmm_runtime::*;

#[doc = include_str!("language.md")]
#[macro_export]
macro_rules! mstmm_chain {
    ($($description:tt)*) => {
        $crate::mstmm_chain_by! { $crate $($description)* }
    };
}

/// What most programs need: the macro, the integrators and the traits that they work on.
pub mod prelude {
    pub use crate::{
        Chain, ChainState, Described, Dopri5, GeneratedChain, LinearlyImplicitEuler, Newmark, Rk4,
        SemiImplicitEuler, mstmm_chain,
    };
}
