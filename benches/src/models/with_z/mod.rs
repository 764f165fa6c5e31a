//! The same chains with `results = z`.
#![allow(clippy::duplicate_mod)] // The same text, for another macro.

#[path = "../balls.rs"]
mod balls;
#[path = "../panda.rs"]
mod panda;
#[path = "../pins.rs"]
mod pins;
#[path = "../rods.rs"]
mod rods;

pub use balls::{Balls3, Balls10, Balls100};
pub use panda::Panda;
pub use pins::{Pins7, Pins30};
pub use rods::{Rods3, Rods10, Rods100, Rods1000};

use super::{case, each_hinge, each_vector};

/// Adds the setting to a chain.
macro_rules! mstmm_chain {
    ($($(#[$doc:meta])* pub $($word:ident)+ { $($items:tt)* })*) => {
        ::mstmm::mstmm_chain! {
            $($(#[$doc])* pub $($word)+ { results = z; $($items)* })*
        }
    };
}
use mstmm_chain;
