//! The trait of chains that describe themselves.

use super::{BodyInertia, Description, WrittenInertia};
use crate::GeneratedChain;

/// A chain that describes itself at run time. `mstmm_chain!` implements it for all chains.
///
/// Tools that work with any chain, such as files of results, tables and interfaces to other languages, take names, units
/// and inertia from here. See the [module](crate::description) for names and orders.
///
/// ```
/// use mstmm_runtime::{ChainState, Described};
///
/// fn print<C: Described>(state: &C::State) {
///     for (quantity, value) in C::DESCRIPTION.coordinates().iter().zip(state.coordinates()) {
///         println!("{} = {value:?} {}", quantity.name, quantity.unit);
///     }
/// }
/// ```
pub trait Described: GeneratedChain {
    /// The description.
    const DESCRIPTION: &'static Description;

    /// Returns mass, centre of mass and inertia tensor of a body with the parameters as they are set, by its index in
    /// [`Description::bodies`]. `None` if there is no such body.
    fn inertia(&self, body: usize) -> Option<BodyInertia<Self::Scalar>> {
        let at = Self::DESCRIPTION.bodies.entry(body, |_| 1)?;
        let mut written = at.row.inertia().of_scalar(at.number, at.repetition);
        self.change_inertia_(&mut written);
        Some(written.about_com(Self::DESCRIPTION.dimension))
    }

    /// Sets the values that parameters change; for generated code.
    #[doc(hidden)]
    fn change_inertia_(&self, inertia: &mut WrittenInertia<Self::Scalar>) {
        let _ = inertia;
    }
}
