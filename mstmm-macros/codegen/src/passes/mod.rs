//! From formulas to a program, one step a file:
//!
//! 1. `live` finds what the results need: the rest is dead.
//! 2. [`join()`] makes one loop of those over the same part that may run together.
//! 3. [`factor()`] rewrites sums of products that share a factor.
//! 4. [`order()`] adds up sums in the order in which their terms are known.
//! 5. `turns` finds which values belong into loops over repeated parts.
//! 6. [`schedule()`] puts what is live under the headings of a trace and names it.
//! 7. [`issue()`] orders the statements so that a processor waits little.
//!
//! Folding, signs and common subexpressions need no pass: the graph's rules see to them while the
//! formulas are written down.

mod angles;
mod arrivals;
mod compute;
mod factor;
mod fuse;
mod images;
mod issue;
mod join;
mod latency;
mod live;
mod looped;
mod names;
mod order;
mod owners;
mod schedule;
mod setup;
mod sums;
mod turns;

pub use factor::factor;
pub use images::Images;
pub use issue::issue;
pub use join::join;
pub use live::Live;
pub use order::order;
pub use schedule::{Heading, Unknowns, schedule};
pub use setup::Setup;
pub use turns::{Carry, Home, Turn, Turns, needed_carries};
