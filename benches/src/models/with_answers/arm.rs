//! D: the Franka Emika Panda.

use super::mstmm_chain;

include!("../../../../examples/panda.rs");

panda! {
    /// The Franka Emika Panda without its hand.
    pub chain Panda {}
}
