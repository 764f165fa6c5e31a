//! The Jacobians of bodies. Their names depend on the chain, so each chain has a type with these methods.

use super::Unanswered;

/// Bodies at free ends of open chains without `repeat` whose description asks for `jacobian`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `jacobian`, or the body is not at a free end, or the chain is closed or has `repeat`",
    label = "needs `answers = jacobian;`, and a body at a free end of an open chain without `repeat`",
    note = "add `answers = jacobian;` or `answers = basic;` to the chain, or the word to its list: `answers = […, jacobian];`",
    note = "with this word, points of all bodies have a Jacobian: `chain.kinematics(&state, &inputs)?.body().at(place).jacobian()`"
)]
pub trait AsksJacobianOfBody: Unanswered {}

/// Implements `Deref` for a chain: to a type with the methods that write or return the Jacobians of some bodies, by
/// their names, and from there to [`NotAsked`](super::NotAsked).
#[doc(hidden)]
#[macro_export]
macro_rules! not_asked_of_chain {
    ($chain:ident $($by_value:ident $into:ident)*) => {
        const _: () = {
            // An enumeration, because rustc would suggest the fields of a structure to readers of the chain.
            #[doc(hidden)]
            pub enum NotAskedOfBodies_<C> {
                Chain(::core::marker::PhantomData<C>),
            }

            #[allow(dead_code, non_snake_case)]
            impl<C> NotAskedOfBodies_<C> {
                $(
                    pub fn $by_value<R>(
                        &self,
                        _: impl ::core::marker::Sized,
                        _: impl ::core::marker::Sized,
                        _: impl ::core::marker::Sized,
                    ) -> R
                    where
                        Self: $crate::generated::AsksJacobianOfBody,
                    {
                        <Self as $crate::generated::Unanswered>::answer()
                    }

                    pub fn $into<R>(
                        &self,
                        _: impl ::core::marker::Sized,
                        _: impl ::core::marker::Sized,
                        _: impl ::core::marker::Sized,
                        _: impl ::core::marker::Sized,
                    ) -> R
                    where
                        Self: $crate::generated::AsksJacobianOfBody,
                    {
                        <Self as $crate::generated::Unanswered>::answer()
                    }
                )*
            }

            #[doc(hidden)]
            impl<C> ::core::ops::Deref for NotAskedOfBodies_<C> {
                type Target = $crate::generated::NotAsked<C>;

                fn deref(&self) -> &Self::Target {
                    $crate::generated::NotAsked::of_chain()
                }
            }

            #[doc(hidden)]
            impl<T: $crate::Scalar> ::core::ops::Deref for $chain<T> {
                type Target = NotAskedOfBodies_<Self>;

                fn deref(&self) -> &Self::Target {
                    const { &NotAskedOfBodies_::Chain(::core::marker::PhantomData) }
                }
            }
        };
    };
}
