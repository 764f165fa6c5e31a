//! The passes from functions to programs, one per file. A pass maps a function to a function:
//!
//! | pass | what it does |
//! |---|---|
//! | [`drop_unused_carries`] | removes loop-carried values that no result needs |
//! | [`factor()`] | factors common factors out of sums of products |
//! | [`fuse_loops()`] | fuses consecutive loops over the same part |
//! | [`separate_factor()`] | separates values of the state from values of the factor of a product |
//! | [`reassociate()`] | adds the terms of sums in the order in which they are ready |
//!
//! [`linearize()`] orders a function into a program; `select_fma` chooses the products that it fuses with their sums, and
//! `angles` groups its sines and cosines. [`list_schedule()`] reorders the statements for processors, [`lower()`] adds
//! loads, tests and stores, and `bounds` finds arguments whose test saves those of results. [`early_stores()`] moves the
//! stores up, and [`pack_limbs()`] computes limbs of one shape side by side. [`choose_signs()`] comes last. The module
//! `compile` lists the order of the passes.
//!
//! Constant folding, signs and common subexpressions need no pass: the graph's rules apply when formulas are created.

mod angles;
mod bounds;
mod choose_signs;
mod compute;
mod early_stores;
mod factor;
mod flatten_sums;
mod fuse_loops;
mod latency;
mod limbs;
mod linearize;
mod list_schedule;
mod live;
mod loops;
mod lower;
mod node_values;
mod owners;
mod ready_times;
mod reassociate;
mod regions;
mod rewrites;
mod select_fma;
mod separate_factor;
mod setup;

pub use choose_signs::{choose_signs, negate};
pub use early_stores::early_stores;
pub use factor::factor;
pub use fuse_loops::fuse_loops;
pub use limbs::{Leaf, Limb, LimbQuantity, Limbs, pack_limbs};
pub use linearize::linearize;
pub use list_schedule::list_schedule;
pub use live::Live;
pub use lower::{Checks, lower};
pub use reassociate::reassociate;
pub use regions::{LoopId, Region, Regions, drop_unused_carries};
use rewrites::Images;
pub use separate_factor::separate_factor;
pub use setup::SetupSlots;
