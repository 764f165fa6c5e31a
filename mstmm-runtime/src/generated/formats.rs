//! The implementations of the formats for generated types.
//!
//! Generated types cannot see the features of this crate. Generated code therefore calls the macro `formats_of_chain_`,
//! which adds implementations for the features that are on.

/// Implements the formats for the types of a chain.
///
/// The numbers are those of the values of a state with its time, of the inputs and of the parameters.
#[doc(hidden)]
#[macro_export]
macro_rules! formats_of_chain_ {
    (
        $chain:ident $state:ident $state_count:literal $inputs:ident $input_count:literal
        $parameters:ident $parameter_count:literal
    ) => {
        $crate::tables_! { $chain
            #[doc = "Shows coordinates, rates and time as a table with names and units."]
            $state $state_count of_state
            #[doc = "Shows the inputs as a table with names and units."]
            $inputs $input_count of_inputs
            #[doc = "Shows the parameters as a table with names and units."]
            $parameters $parameter_count of_parameters
        }
        $crate::maps_! {
            $chain $state $state_count $inputs $input_count $parameters $parameter_count
        }
        $crate::logs_! {
            $chain $state $state_count of_state $inputs $input_count of_inputs
            $parameters $parameter_count of_parameters
        }
        $crate::closeness_! { $chain $state }
    };
}

/// Implements `Display` and `LowerExp`.
#[doc(hidden)]
#[macro_export]
macro_rules! tables_ {
    // A constant of the user may have any name without an underscore at its end: names of arguments are patterns.
    ($chain:ident $($(#[$doc:meta])* $name:ident $count:literal $of:ident)*) => { $(
        $(#[$doc])*
        ///
        /// The precision, 4 if omitted, and a sign `+` of the format are used: `{:+.6}`. `{:e}` writes powers of ten.
        impl<T: $crate::Scalar + ::core::fmt::Display> ::core::fmt::Display for $name<T> {
            fn fmt(&self, formatter_: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::generated::Listing::<T, $count>::$of::<$chain<T>>(self)
                    .table(formatter_, <T as ::core::fmt::Display>::fmt)
            }
        }
        $(#[$doc])*
        impl<T: $crate::Scalar + ::core::fmt::LowerExp> ::core::fmt::LowerExp for $name<T> {
            fn fmt(&self, formatter_: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::generated::Listing::<T, $count>::$of::<$chain<T>>(self)
                    .table(formatter_, <T as ::core::fmt::LowerExp>::fmt)
            }
        }
    )* };
}

/// Implements the traits of `serde`.
#[cfg(feature = "serde")]
#[doc(hidden)]
#[macro_export]
macro_rules! maps_ {
    (
        $chain:ident $state:ident $state_count:literal $inputs:ident $input_count:literal
        $parameters:ident $parameter_count:literal
    ) => {
        $crate::maps_! { @to $chain
            $state $state_count of_state
            $inputs $input_count of_inputs
            $parameters $parameter_count of_parameters
        }
        $crate::maps_! { @from $chain
            $state $state_count read_state
            $inputs $input_count read_inputs
            $chain $parameter_count read_parameters
        }
        /// A map of the parameters, as that of [`parameters`](
        #[doc = concat!(stringify!($chain), "::parameters).")]
        impl<T: $crate::Scalar + $crate::generated::serde::Serialize>
            $crate::generated::serde::Serialize for $chain<T>
        {
            fn serialize<Z: $crate::generated::serde::Serializer>(
                &self,
                serializer: Z,
            ) -> ::core::result::Result<Z::Ok, Z::Error> {
                $crate::generated::serde::Serialize::serialize(self.parameters(), serializer)
            }
        }
    };
    (@to $chain:ident $($name:ident $count:literal $of:ident)*) => { $(
        impl<T: $crate::Scalar + $crate::generated::serde::Serialize>
            $crate::generated::serde::Serialize for $name<T>
        {
            fn serialize<Z: $crate::generated::serde::Serializer>(
                &self,
                serializer: Z,
            ) -> ::core::result::Result<Z::Ok, Z::Error> {
                let listing = $crate::generated::Listing::<T, $count>::$of::<$chain<T>>(self);
                $crate::generated::serde::Serialize::serialize(&listing, serializer)
            }
        }
    )* };
    (@from $chain:ident $($name:ident $count:literal $read:ident)*) => { $(
        impl<'de, T: $crate::Scalar + $crate::generated::serde::Deserialize<'de>>
            $crate::generated::serde::Deserialize<'de> for $name<T>
        {
            fn deserialize<D: $crate::generated::serde::Deserializer<'de>>(
                deserializer: D,
            ) -> ::core::result::Result<Self, D::Error> {
                $crate::generated::maps::$read::<$chain<T>, D, $count>(deserializer)
            }
        }
    )* };
}

/// Implements the traits of `serde`.
#[cfg(not(feature = "serde"))]
#[doc(hidden)]
#[macro_export]
macro_rules! maps_ {
    ($($types:tt)*) => {};
}

/// Implements `defmt::Format`.
#[cfg(feature = "defmt")]
#[doc(hidden)]
#[macro_export]
macro_rules! logs_ {
    ($chain:ident $($name:ident $count:literal $of:ident)*) => { $(
        impl<T: $crate::Scalar + $crate::generated::defmt::Format> $crate::generated::defmt::Format
            for $name<T>
        {
            fn format(&self, formatter_: $crate::generated::defmt::Formatter<'_>) {
                let listing = $crate::generated::Listing::<T, $count>::$of::<$chain<T>>(self);
                $crate::generated::defmt::Format::format(&listing, formatter_);
            }
        }
    )* };
}

/// Implements `defmt::Format`.
#[cfg(not(feature = "defmt"))]
#[doc(hidden)]
#[macro_export]
macro_rules! logs_ {
    ($($types:tt)*) => {};
}

/// Implements the traits of `approx`.
#[cfg(feature = "approx")]
#[doc(hidden)]
#[macro_export]
macro_rules! closeness_ {
    ($chain:ident $state:ident) => {
        /// Compares coordinates, rates and time one by one. Quaternions q and −q are equal: they are one rotation.
        impl<T: $crate::Scalar + $crate::generated::approx::AbsDiffEq<Epsilon: Copy>>
            $crate::generated::approx::AbsDiffEq for $state<T>
        {
            type Epsilon = T::Epsilon;
            fn default_epsilon() -> T::Epsilon {
                T::default_epsilon()
            }
            fn abs_diff_eq(&self, other: &Self, epsilon: T::Epsilon) -> ::core::primitive::bool {
                let close = |a: &T, b: &T| a.abs_diff_eq(b, epsilon);
                $crate::generated::closeness::are_close::<$chain<T>>([self, other], close)
            }
        }
        /// Compares as [`AbsDiffEq`]($crate::generated::approx::AbsDiffEq) does.
        impl<T: $crate::Scalar + $crate::generated::approx::RelativeEq<Epsilon: Copy>>
            $crate::generated::approx::RelativeEq for $state<T>
        {
            fn default_max_relative() -> T::Epsilon {
                T::default_max_relative()
            }
            fn relative_eq(
                &self,
                other: &Self,
                epsilon: T::Epsilon,
                max: T::Epsilon,
            ) -> ::core::primitive::bool {
                let close = |a: &T, b: &T| a.relative_eq(b, epsilon, max);
                $crate::generated::closeness::are_close::<$chain<T>>([self, other], close)
            }
        }
        /// Compares as [`AbsDiffEq`]($crate::generated::approx::AbsDiffEq) does.
        impl<T: $crate::Scalar + $crate::generated::approx::UlpsEq<Epsilon: Copy>>
            $crate::generated::approx::UlpsEq for $state<T>
        {
            fn default_max_ulps() -> ::core::primitive::u32 {
                T::default_max_ulps()
            }
            fn ulps_eq(
                &self,
                other: &Self,
                epsilon: T::Epsilon,
                max_ulps: ::core::primitive::u32,
            ) -> ::core::primitive::bool {
                let close = |a: &T, b: &T| a.ulps_eq(b, epsilon, max_ulps);
                $crate::generated::closeness::are_close::<$chain<T>>([self, other], close)
            }
        }
    };
}

/// Implements the traits of `approx`.
#[cfg(not(feature = "approx"))]
#[doc(hidden)]
#[macro_export]
macro_rules! closeness_ {
    ($($types:tt)*) => {};
}
