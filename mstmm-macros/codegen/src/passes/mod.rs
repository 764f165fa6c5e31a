//! From formulas to a program, one step a file:
//!
//! 1. `live` finds what the results need: the rest is dead.
//! 2. [`factor()`] rewrites sums of products that share a factor.
//! 3. `turns` finds which values belong into loops over repeated parts.
//! 4. [`schedule()`] orders what is live under the headings of a trace and names it.
//!
//! Folding, signs and common subexpressions need no pass: the graph's rules see to them while the
//! formulas are written down.

mod angles;
mod factor;
mod live;
mod looped;
mod schedule;
mod setup;
mod turns;

pub use factor::factor;
pub use live::Live;
pub use schedule::{Heading, Unknowns, schedule};
pub use setup::Setup;
pub use turns::{Carry, Home, Turn, Turns, needed_carries};
