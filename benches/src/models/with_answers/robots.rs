//! Robots that branch and float.

use super::mstmm_chain;

include!("../trees/hyq.chain");
include!("../trees/g1.chain");
