//! Driven chains, a controller that fails on request, and a common interface to all integrators.

use mstmm::prelude::*;
use mstmm::{Error, GeneratedChain, Scalar};
use std::fmt::Debug;

macro_rules! chains {
    ($method:ident: $arm:ident $repeated:ident $loop:ident $moved:ident) => {
        mstmm_chain! {
            /// An arm with a motor in each hinge.
            pub chain $arm {
                method = $method;
                gravity = [0, -9.8, 0] m/s^2;
                body Link {
                    mass = 1 kg; com = [0.5, 0.1, 0] m; output = [1, 0, 0] m;
                    inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
                }
                ground -> ball a -> Link la -> pin(z) b -> Link lb -> pin(z) c -> Link lc;
                hinge a, b, c { torque = input; }
            }
        }
        mstmm_chain! {
            /// The same motors in a repeated part.
            pub chain $repeated {
                method = $method;
                gravity = [0, -9.8, 0] m/s^2;
                body Link {
                    mass = 1 kg; com = [0.5, 0.1, 0] m; output = [1, 0, 0] m;
                    inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
                }
                ground -> ball a -> Link la -> repeat 2 { pin(z) b -> Link lb };
                hinge a, b { torque = input; }
            }
        }
        mstmm_chain! {
            /// A closed chain, which needs inputs once more at the end of a step.
            pub plane chain $loop {
                method = $method;
                gravity = [0, -9.8] m/s^2;
                body Bar {
                    mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m;
                    inertia = 0.1 kg*m^2 about com;
                }
                ground -> pin a -> Bar la -> pin b -> Bar lb -> pin c -> Bar lc -> pin d
                    -> ground at [1.3, 0] m;
                hinge a { start = 80 deg; torque = input; }
                hinge b { start = -70 deg; }
                hinge c { start = -90 deg; }
            }
        }
        mstmm_chain! {
            /// A chain on a frame that moves.
            pub plane chain $moved {
                method = $method;
                gravity = [0, -9.8] m/s^2;
                body Bar {
                    mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m;
                    inertia = 0.1 kg*m^2 about com;
                }
                moving deck -> pin a -> Bar la -> pin b -> Bar lb;
                hinge b { torque = input; }
            }
        }
    };
}

chains! { riccati: Arm Repeated Loop Moved }
chains! { transfer: ArmByTransfer RepeatedByTransfer LoopByTransfer MovedByTransfer }

/// An error of the controller or of the chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// The controller failed in the call with this number.
    Sensor(usize),
    Chain(Error),
}

impl From<Error> for Fault {
    fn from(error: Error) -> Self {
        Fault::Chain(error)
    }
}

/// A scalar of the tests.
pub trait Number: Scalar<Real = Self, Mask = bool> + PartialOrd {}

impl Number for f32 {}
impl Number for f64 {}

/// A chain whose inputs are a torque that depends on time and state.
pub trait Driven:
    GeneratedChain<Scalar: Number, State: Debug + PartialEq, Inputs: Clone + Debug> + Default
{
    fn drive(&self, time: Self::Scalar, state: &Self::State) -> Self::Inputs;

    /// A start on the closure, in motion.
    fn start(&self) -> Self::State {
        let mut state = self.initial_state();
        state.rates_mut().iter_mut().for_each(|rate| *rate = Scalar::constant(0.25));
        GeneratedChain::assemble(self, &mut state, &self.no_inputs()).expect("a closed chain");
        state
    }
}

macro_rules! driven {
    ($($chain:ident $inputs:ident |$torque:ident, $to:ident| $set:block)*) => { $(
        impl<T: Number> Driven for $chain<T> {
            fn drive(&self, time: T, state: &Self::State) -> $inputs<T> {
                let ([sine], _) = T::sin_cos([time * T::constant(8.0)]);
                let $torque = sine - state.rates()[0] * T::constant(0.5);
                let mut $to = self.no_inputs();
                $set
                $to
            }
        }
    )* };
}

driven! {
    Arm ArmInputs |torque, to| { to.a.x = torque; to.b = torque; to.c = -torque; }
    ArmByTransfer ArmByTransferInputs |torque, to| { to.a.x = torque; to.b = torque; to.c = -torque; }
    Repeated RepeatedInputs |torque, to| { to.a.x = torque; to.b = [torque, -torque]; }
    RepeatedByTransfer RepeatedByTransferInputs |torque, to| {
        to.a.x = torque;
        to.b = [torque, -torque];
    }
    Loop LoopInputs |torque, to| { to.a = torque; }
    LoopByTransfer LoopByTransferInputs |torque, to| { to.a = torque; }
    Moved MovedInputs |torque, to| { to.deck.acceleration.x = torque; to.b = torque; }
    MovedByTransfer MovedByTransferInputs |torque, to| {
        to.deck.acceleration.x = torque;
        to.b = torque;
    }
}

/// All integrators.
pub trait Integrator<C: Chain>: Clone {
    /// Returns the integrator with steps of about 1/128 s.
    fn make() -> Self;

    fn try_step<E: From<Error>>(
        &mut self,
        chain: &C,
        state: &mut C::State,
        inputs: impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
    ) -> Result<(), E>;

    fn try_advance_to<E: From<Error>>(
        &mut self,
        chain: &C,
        state: &mut C::State,
        end: C::Scalar,
        inputs: impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
    ) -> Result<(), E>;

    /// The same by the methods whose inputs cannot fail.
    fn plain_step(
        &mut self,
        chain: &C,
        state: &mut C::State,
        inputs: impl FnMut(C::Scalar, &C::State) -> C::Inputs,
    ) -> Result<(), Error>;

    fn plain_advance(
        &mut self,
        chain: &C,
        state: &mut C::State,
        end: C::Scalar,
        inputs: impl FnMut(C::Scalar, &C::State) -> C::Inputs,
    ) -> Result<(), Error>;

    /// The observable properties of the integrator: the size of the next step, states within the last step.
    fn seen(&self, chain: &C) -> Vec<String>;
}

/// The size of steps in s.
pub const STEP: f64 = 1.0 / 128.0;

macro_rules! integrators {
    ($($name:ident |$number:ident| $make:expr, |$this:ident, $chain:ident| $seen:expr;)*) => { $(
        impl<C: Chain<Scalar: Number, State: Debug>> Integrator<C> for $name<C> {
            fn make() -> Self {
                let $number = |value| C::Scalar::constant(value);
                $make
            }

            fn try_step<E: From<Error>>(
                &mut self,
                chain: &C,
                state: &mut C::State,
                inputs: impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
            ) -> Result<(), E> {
                $name::try_step(self, chain, state, inputs)
            }

            fn try_advance_to<E: From<Error>>(
                &mut self,
                chain: &C,
                state: &mut C::State,
                end: C::Scalar,
                inputs: impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
            ) -> Result<(), E> {
                $name::try_advance_to(self, chain, state, end, inputs)
            }

            fn plain_step(
                &mut self,
                chain: &C,
                state: &mut C::State,
                inputs: impl FnMut(C::Scalar, &C::State) -> C::Inputs,
            ) -> Result<(), Error> {
                self.step(chain, state, inputs)
            }

            fn plain_advance(
                &mut self,
                chain: &C,
                state: &mut C::State,
                end: C::Scalar,
                inputs: impl FnMut(C::Scalar, &C::State) -> C::Inputs,
            ) -> Result<(), Error> {
                self.advance_to(chain, state, end, inputs)
            }

            fn seen(&self, $chain: &C) -> Vec<String> {
                let $this = self;
                $seen
            }
        }
    )* };
}

integrators! {
    Rk4 |number| Rk4::new(number(STEP)), |this, _chain| vec![format!("{:?}", this.step_size())];
    SemiImplicitEuler |number| SemiImplicitEuler::new(number(STEP)),
        |this, _chain| vec![format!("{:?}", this.step_size())];
    LinearlyImplicitEuler |number| LinearlyImplicitEuler::new(number(STEP)),
        |this, _chain| vec![format!("{:?}", this.step_size())];
    Newmark |number| Newmark::new(number(STEP)),
        |this, _chain| vec![format!("{:?}", this.step_size())];
    Dopri5 |number| Dopri5::new(number(1e-4), number(1e-4)), |this, chain| {
        let mut seen = vec![format!("{:?}", this.next_step())];
        // Wherever the last step was, some of these times are in it.
        for k in 0..512 {
            let mut state = C::State::zero_position();
            let time = C::Scalar::constant(f64::from(k) / 1024.0);
            let result = this.interpolate(chain, time, &mut state);
            seen.push(format!("{result:?} {state:?}"));
        }
        seen
    };
}

/// Runs a test of all integrators on all chains, in both precisions.
macro_rules! on_everything {
    ($check:ident) => {
        on_everything!($check Arm Repeated Loop Moved ArmByTransfer RepeatedByTransfer
            LoopByTransfer MovedByTransfer);
    };
    ($check:ident $($chain:ident)*) => { $(
        on_everything!(@ $check $chain<f64>);
        on_everything!(@ $check $chain<f32>);
    )* };
    (@ $check:ident $chain:ty) => {
        $check::<$chain, Rk4<$chain>>();
        $check::<$chain, SemiImplicitEuler<$chain>>();
        $check::<$chain, LinearlyImplicitEuler<$chain>>();
        $check::<$chain, Newmark<$chain>>();
        $check::<$chain, Dopri5<$chain>>();
    };
}
pub(super) use on_everything;
