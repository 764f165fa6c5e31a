//! A common interface of the printed chains.

use mstmm::{ChainState, ConnectionPoint, Energy, GeneratedChain, SpringResult};
use mstmm_reference::Drives;
use nalgebra::SVector;

/// All that a printed chain computes at one instant.
pub struct Answer<P> {
    /// By the fast path.
    pub fast_accelerations: Vec<f64>,
    pub fast_energy: Energy<f64>,
    /// By `solve_into`.
    pub accelerations: Vec<f64>,
    pub efforts: Vec<f64>,
    /// Length, rate of the length, tension and force of every spring.
    pub springs: Vec<f64>,
    pub points: Vec<P>,
    pub energy: Energy<f64>,
}

/// A printed chain.
pub trait Printed: GeneratedChain<Scalar = f64> + Default {
    type Point: ConnectionPoint;

    fn inputs(&self, drives: &Drives) -> Self::Inputs;
    fn answer(&self, state: &Self::State, inputs: &Self::Inputs) -> Answer<Self::Point>;

    /// The state with these coordinates and rates.
    fn state(&self, q: &[f64], v: &[f64]) -> Self::State {
        let mut state = self.initial_state();
        state.coordinates_mut().copy_from_slice(q);
        state.rates_mut().copy_from_slice(v);
        state
    }
}

/// Makes a printed chain by both methods, or by the default method, and gives each its face: the kind
/// of its points, the energy with as many arguments as it takes, the fields of its inputs, its hinges
/// and its springs.
macro_rules! printed {
    (
        $riccati:ident $transfer:ident, $point:ident, $energy:ident $arguments:tt;
        inputs |$drives:ident| $inputs:tt
        hinges $($hinge:ident)*;
        springs $($spring:ident)*;
        pub $($kind:ident)+ { $($items:tt)* }
    ) => {
        mstmm::mstmm_chain! {
            pub $($kind)+ $riccati { method = riccati; $($items)* }
            pub $($kind)+ $transfer { method = transfer; $($items)* }
        }
        $crate::random::face::face! {
            $riccati $point $energy $arguments $drives $inputs $($hinge)*; $($spring)*
        }
        $crate::random::face::face! {
            $transfer $point $energy $arguments $drives $inputs $($hinge)*; $($spring)*
        }
    };
    (
        $name:ident, $point:ident, $energy:ident $arguments:tt;
        inputs |$drives:ident| $inputs:tt
        hinges $($hinge:ident)*;
        springs $($spring:ident)*;
        pub $($kind:ident)+ { $($items:tt)* }
    ) => {
        mstmm::mstmm_chain! { pub $($kind)+ $name { $($items)* } }
        $crate::random::face::face! {
            $name $point $energy $arguments $drives $inputs $($hinge)*; $($spring)*
        }
    };
}
pub(crate) use printed;

/// The face of one chain.
macro_rules! face {
    (
        $name:ident $point:ident $energy:ident ($($argument:ident),*)
        $drives:ident { $($field:ident: $value:expr,)* } $($hinge:ident)*; $($spring:ident)*
    ) => {
        impl $crate::random::face::Printed for $name<f64> {
            type Point = mstmm::$point<f64>;

            #[allow(unused_mut)]
            fn inputs(&self, $drives: &mstmm_reference::Drives) -> Self::Inputs {
                let mut inputs = self.no_inputs();
                $( inputs.$field = $value; )*
                inputs
            }

            fn answer(
                &self,
                state: &Self::State,
                inputs: &Self::Inputs,
            ) -> $crate::random::face::Answer<Self::Point> {
                let fast = self.accelerations(state, inputs).expect("a regular chain");
                let mut at = self.workspace();
                self.solve_into(state, inputs, &mut at).expect("a regular chain");
                let efforts: Vec<Vec<f64>> =
                    vec![$( $crate::random::face::Numbers::list(at.$hinge().effort()) ),*];
                let springs: Vec<Vec<f64>> =
                    vec![$( $crate::random::face::spring(at.$spring()) ),*];
                let given = $crate::random::face::Given { state, inputs };
                $crate::random::face::Answer {
                    fast_accelerations: fast.as_slice().to_vec(),
                    fast_energy: self.$energy($(given.$argument),*),
                    accelerations: at.accelerations().as_slice().to_vec(),
                    efforts: efforts.concat(),
                    springs: springs.concat(),
                    points: at.points().to_vec(),
                    energy: mstmm::Energy {
                        kinetic: at.kinetic_energy(),
                        potential: at.potential_energy(),
                    },
                }
            }
        }
    };
}
pub(crate) use face;

/// What an energy may be asked for with.
pub struct Given<'a, S, I> {
    pub state: &'a S,
    pub inputs: &'a I,
}

/// The values of a spring.
pub fn spring<V: Numbers + Copy>(spring: SpringResult<f64, V>) -> Vec<f64> {
    let lengths = [spring.length(), spring.length_rate(), spring.tension()];
    [&lengths[..], &spring.force().list()].concat()
}

/// The efforts of any hinge, or the force of a spring.
pub trait Numbers {
    fn list(self) -> Vec<f64>;
}

impl Numbers for () {
    fn list(self) -> Vec<f64> {
        Vec::new()
    }
}

impl Numbers for f64 {
    fn list(self) -> Vec<f64> {
        vec![self]
    }
}

impl<const N: usize> Numbers for SVector<f64, N> {
    fn list(self) -> Vec<f64> {
        self.as_slice().to_vec()
    }
}
