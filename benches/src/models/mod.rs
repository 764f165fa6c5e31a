//! The chains, as users write them: short chains in full, long chains with `repeat`.

mod balls;
mod panda;
mod pins;
mod rods;
mod trees;
pub mod with_z;

use mstmm::mstmm_chain;

pub use balls::{Balls3, Balls10, Balls100};
pub use panda::Panda;
pub use pins::{Pins7, Pins30};
pub use rods::{Rods3, Rods10, Rods100, Rods1000};
pub use trees::{G1, Hyq};

/// Implements [`Case`](crate::Case) for a generated chain, from its name, its inputs and, if it has dampers, how
/// to remove them.
macro_rules! case {
    (
        $chain:ident,
        $name:literal,
        |$inputs:ident, $torques:ident| $set:expr
        $(, |$damped:ident| $remove:expr)?
    ) => {
        impl<T: $crate::Lanes> $crate::Case for $chain<T> {
            const NAME: &'static str = $name;

            $(
                fn undamped() -> Self {
                    let mut $damped = Self::default();
                    $remove;
                    $damped
                }
            )?

            fn accelerations_into(
                &self,
                state: &Self::State,
                inputs: &Self::Inputs,
                rate: &mut Self::State,
            ) -> Result<(), ::mstmm::Error> {
                self.accelerations_into(state, inputs, &mut rate.v)
            }

            fn accelerations_at(at: &Self::Workspace) -> &[T] {
                at.accelerations().as_slice()
            }

            fn points_at(at: &Self::Workspace) -> impl Copy {
                at.points()
            }

            fn set_torques($inputs: &mut Self::Inputs, $torques: &[T]) {
                $set
            }
        }
    };
}
use case;

/// Sets the torques of hinges by name: `each_hinge!(inputs, torques: a b c)`.
macro_rules! each_hinge {
    ($inputs:ident, $torques:ident: $($hinge:ident)*) => {{
        let hinges = [$(&mut $inputs.$hinge),*];
        for (hinge, torque) in hinges.into_iter().zip($torques) {
            *hinge = *torque;
        }
    }};
}
use each_hinge;

/// Sets the torques of hinges with vectors.
macro_rules! each_vector {
    ($inputs:ident, $torques:ident: $($hinge:ident)*) => {{
        let hinges = [$(&mut $inputs.$hinge),*];
        for (hinge, torque) in hinges.into_iter().zip($torques.as_chunks::<3>().0) {
            *hinge = (*torque).into();
        }
    }};
}
use each_vector;
