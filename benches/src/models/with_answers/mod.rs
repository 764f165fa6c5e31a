//! Chains with all answers that are timed, in a separate program, since other programs do not need their code.

mod arm;
mod balls;
mod robots;

pub use arm::{Panda, PandaVariation};
pub use balls::{Balls3, Balls3Variation, Balls30, Balls30Variation};
pub use robots::{G1, G1Variation, Hyq, HyqVariation};

/// Adds the setting to a chain.
macro_rules! mstmm_chain {
    ($($(#[$doc:meta])* pub $($word:ident)+ { $($items:tt)* })*) => {
        ::mstmm::mstmm_chain! {
            $($(#[$doc])* pub $($word)+ {
                answers = [basic, coriolis_matrix, regressor, derivatives, linearize, push, pull];
                $($items)*
            })*
        }
    };
}
use mstmm_chain;
