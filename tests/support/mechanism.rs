//! One face for all generated chains, so that a test can be written once and run on many.

use mstmm::{Chain, ChainState, Energy, Error, Point};
use mstmm_reference::Random;
use std::f64::consts::PI;

/// A kind of hinge, by what it keeps in a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    Pin,
    Ball,
    Floating,
}

/// All that `solve_into` says.
#[derive(Clone, Debug)]
pub struct Answer {
    pub accelerations: Vec<f64>,
    pub points: Vec<Point<f64>>,
    pub energy: Energy<f64>,
}

/// A generated chain in double precision.
pub trait Mechanism: Chain<Scalar = f64> + Default {
    /// What lies in a state, in order.
    const HINGES: &'static [Kind];

    fn start(&self) -> Self::State;
    fn answer(&self, state: &Self::State, inputs: &Self::Inputs) -> Result<Answer, Error>;
    fn fast_accelerations(&self, state: &Self::State, inputs: &Self::Inputs) -> Vec<f64>;
    fn fast_energy(&self, state: &Self::State) -> Energy<f64>;

    /// Any pose, with rates of up to two.
    fn random_state(&self, random: &mut Random) -> Self::State {
        let mut state = self.start();
        let mut q: Vec<f64> = Vec::new();
        for kind in Self::HINGES {
            match kind {
                Kind::Pin => q.push(random.between(-PI, PI)),
                Kind::Ball => q.extend(random_quaternion(random)),
                Kind::Floating => {
                    q.extend((0..3).map(|_| random.between(-2.0, 2.0)));
                    q.extend(random_quaternion(random));
                }
            }
        }
        state.coordinates_mut().copy_from_slice(&q);
        state.rates_mut().iter_mut().for_each(|rate| *rate = random.between(-2.0, 2.0));
        state
    }
}

/// A quaternion w, x, y, z of unit length.
pub fn random_quaternion(random: &mut Random) -> [f64; 4] {
    loop {
        let candidate = [0.0; 4].map(|_: f64| random.between(-1.0, 1.0));
        let length = candidate.iter().map(|x| x * x).sum::<f64>().sqrt();
        if (0.1..=1.0).contains(&length) {
            return candidate.map(|x| x / length);
        }
    }
}

/// Gives generated chains their common face: `mechanisms! { Name [Ball, Pin]; … }`.
#[allow(unused_macros)]
macro_rules! mechanisms {
    ($($name:ident [$($kind:ident),*];)*) => { $(
        impl $crate::support::mechanism::Mechanism for $name<f64> {
            const HINGES: &'static [$crate::support::mechanism::Kind] =
                &[$($crate::support::mechanism::Kind::$kind),*];

            fn start(&self) -> Self::State {
                self.initial_state()
            }

            fn answer(
                &self,
                state: &Self::State,
                inputs: &Self::Inputs,
            ) -> Result<$crate::support::mechanism::Answer, mstmm::Error> {
                let mut at = self.workspace();
                self.solve_into(state, inputs, &mut at)?;
                Ok($crate::support::mechanism::Answer {
                    accelerations: at.accelerations().as_slice().to_vec(),
                    points: at.points().to_vec(),
                    energy: mstmm::Energy {
                        kinetic: at.kinetic_energy(),
                        potential: at.potential_energy(),
                    },
                })
            }

            fn fast_accelerations(
                &self,
                state: &Self::State,
                inputs: &Self::Inputs,
            ) -> Vec<f64> {
                self.accelerations(state, inputs).expect("a regular chain").as_slice().to_vec()
            }

            fn fast_energy(&self, state: &Self::State) -> mstmm::Energy<f64> {
                self.energy(state)
            }
        }
    )* };
}

/// One description compiled by `riccati` and by `transfer`:
/// `both! { Name NameByTransfer [Ball, Pin] { … } }`.
#[allow(unused_macros)]
macro_rules! both {
    ($riccati:ident $transfer:ident [$($kind:ident),*] { $($description:tt)* }) => {
        mstmm::mstmm_chain! { pub chain $riccati { method = riccati; $($description)* } }
        mstmm::mstmm_chain! { pub chain $transfer { method = transfer; $($description)* } }
        $crate::support::mechanism::mechanisms! {
            $riccati [$($kind),*];
            $transfer [$($kind),*];
        }
    };
}

#[allow(unused_imports)]
pub(crate) use {both, mechanisms};
