//! From functions to programs, one step a file. A pass maps a function to a function:
//!
//! | pass | what it does |
//! |---|---|
//! | [`drop_unused_carries`] | leaves out what loops carry for nothing |
//! | [`factor()`] | takes shared factors out of sums of products |
//! | [`fuse_loops()`] | makes one loop of neighbours over the same part |
//! | [`reassociate()`] | adds up sums in the order in which their terms are ready |
//!
//! [`linearize()`] orders a function; while it does so, `select_fma` joins products with their sums and `angles` puts
//! sines and cosines side by side. [`list_schedule()`] reorders the statements for processors, [`lower()`] adds
//! reading, tests and writing, and [`early_stores()`] moves writes up. `compile` lists the order of all.
//!
//! Folding, signs and common subexpressions need no pass: the graph's rules see to them while the
//! formulas are written down.

mod angles;
mod compute;
mod early_stores;
mod factor;
mod flatten_sums;
mod fuse_loops;
mod latency;
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
mod setup;

pub use early_stores::early_stores;
pub use factor::factor;
pub use fuse_loops::fuse_loops;
pub use linearize::linearize;
pub use list_schedule::list_schedule;
pub use live::Live;
pub use lower::{Checks, lower};
pub use reassociate::reassociate;
pub use regions::{LoopId, Region, Regions, drop_unused_carries};
use rewrites::Images;
pub use setup::SetupSlots;
