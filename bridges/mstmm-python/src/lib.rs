//! Python modules of chains.
//!
//! ```ignore
//! mstmm::mstmm_chain! { pub chain CartPole { /* … */ } }
//! mstmm_python::module!(robots: CartPole);
//! ```
//!
//! makes the module `robots` with the class `CartPole`. The readme shows how it is built and used. `cargo mstmm python`
//! builds it from the text of a chain.
//!
//! [`Batch`] computes many states of a chain, on SIMD lanes and all cores, for arrays of numbers in memory. It does not
//! depend on Python. The extension module needs the feature `extension`.

mod batch;
mod blocks;
mod gradients;
#[cfg(feature = "extension")]
mod record;
mod work;

#[cfg(feature = "extension")]
#[doc(hidden)]
pub mod extension;

pub use batch::{Arrays, Batch, Failure, Inputs, OnError, Threads};
pub use blocks::{Blocks, Model};
pub use gradients::Steps;
pub use work::{Method, POINT_VALUES, Work};

#[cfg(feature = "extension")]
#[doc(hidden)]
pub use pyo3;
#[cfg(feature = "extension")]
#[doc(hidden)]
pub use record::Recorder;

/// Makes a Python module with a class for each chain: `module!(robots: CartPole, Arm)`.
///
/// The chains are generic over their scalar, as `mstmm_chain!` writes them. Without the feature `extension` the macro does
/// nothing, so that the crate also builds where Python is not installed.
#[cfg(feature = "extension")]
#[macro_export]
macro_rules! module {
    ($module:ident: $($chain:ident),+ $(,)?) => {
        #[doc = "The Python module."]
        #[$crate::pyo3::pymodule(crate = "mstmm_python::pyo3")]
        fn $module(
            module: &$crate::pyo3::Bound<'_, $crate::pyo3::types::PyModule>,
        ) -> $crate::pyo3::PyResult<()> {
            $crate::extension::fill(
                module,
                ::std::vec![$($crate::extension::Maker {
                    blocks: || ::std::boxed::Box::new($crate::Model::<$chain<$crate::Lanes>>::default()),
                    record: || ::std::boxed::Box::new($crate::Recorder::<$chain<f64>>::default()),
                }),+],
            )
        }
    };
}

/// Without the feature `extension` there is no module.
#[cfg(not(feature = "extension"))]
#[macro_export]
macro_rules! module {
    ($($tokens:tt)*) => {};
}

/// The lanes that chains are computed in: the widest that fit one register of the target.
pub type Lanes = mstmm::lanes::NativeF64;
