//! Methods that a chain does not have because its description does not ask for them.
//!
//! A generated chain dereferences to a type with the Jacobians of bodies that it lacks, and that type to [`NotAsked`], which
//! has the methods of all words of the setting `answers`. A method that the chain has is found first, also one that the
//! user's crate adds to it. The methods here cannot be called: the traits that they need have no implementations, so rustc
//! reports the word to add.

mod bodies;
mod closure;
mod derivatives;
mod dynamics;
mod motion;

pub use bodies::AsksJacobianOfBody;

use core::marker::PhantomData;

/// The methods that a chain `C` does not have.
#[derive(Clone, Copy, Debug)]
pub struct NotAsked<C>(PhantomData<C>);

impl<C> NotAsked<C> {
    /// Returns the methods of the chain.
    #[inline]
    pub const fn of_chain<'a>() -> &'a Self
    where
        C: 'a,
    {
        const { &NotAsked(PhantomData) }
    }
}

/// Stands for the results of the methods; without implementations.
pub trait Unanswered {
    /// Returns any result.
    fn answer<R>() -> R;
}
