//! D: the Franka Emika Panda.

use super::{case, each_hinge, mstmm_chain};

include!("../../../examples/panda.rs");

panda! {
    /// The Franka Emika Panda without its hand.
    pub chain Panda {}
}

case!(Panda, "D7", |inputs, torques| each_hinge!(inputs, torques: j1 j2 j3 j4 j5 j6 j7));
