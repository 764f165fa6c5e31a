//! The parameters: the type of their values, and their setters.

use super::EmitContext;
use super::arrays::usize_literal;
use super::closure;
use super::docs;
use super::sealed;
use crate::compile::layouts;
use crate::model::{Bound, Parameter};
use crate::program::{ArrayLayout, Segment};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Returns `struct ChainParameters<T>`.
pub fn type_of_all(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    let (name, visibility) = (&cx.names.parameters, &cx.passthrough.visibility);
    let doc = format!(" The parameters of [`{}`], which can change at run time.", cx.names.chain);
    let fields = cx.chain.parameters.iter().map(|parameter| {
        let (name, ty) = (&parameter.name, type_of(parameter));
        quote!(#name: #ty)
    });
    let getters = cx.chain.parameters.iter().map(|parameter| {
        let (name, doc) = (&parameter.name, docs::parameter(parameter));
        let ty = type_of(parameter);
        let (ty, value) = match parameter.repetitions {
            None => (ty, quote!(self.#name)),
            Some(_) => (quote!(&#ty), quote!(&self.#name)),
        };
        quote! {
            #[doc = #doc]
            #[inline]
            #visibility fn #name(&self) -> #ty {
                #value
            }
        }
    });
    // The rank is found again when parameters are set, and kept with them.
    let steps = closure::directions(cx).map(|count| {
        let (field, count) = (closure::steps(cx), usize_literal(count));
        quote!(#field: [T; #count],)
    });
    // A struct without fields would not use `T`.
    let is_empty = cx.chain.parameters.is_empty() && steps.is_none();
    let marker = is_empty.then(|| quote!(none: ::core::marker::PhantomData<T>));
    quote! {
        #[doc = #doc]
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[allow(dead_code, non_snake_case)]
        #visibility struct #name<T> {
            #(#fields,)*
            #steps
            #marker
        }
        #[allow(dead_code, non_snake_case)]
        impl<T: #mstmm::Scalar> #name<T> {
            #(#getters)*
        }
    }
}

/// Returns the type of a parameter.
fn type_of(parameter: &Parameter) -> TokenStream {
    match parameter.repetitions.map(usize_literal) {
        None => quote!(T),
        Some(times) => quote!([T; #times]),
    }
}

/// Returns the layout of the values that are checked when a parameter is set.
pub fn checked(cx: &EmitContext) -> ArrayLayout {
    layouts::of(cx.chain, cx.compiled.checks.iter().map(|check| (1, check.part)))
}

/// Returns `set_x`, which changes a parameter only if the chain stays physical.
pub fn setter(cx: &EmitContext, parameter: &Parameter) -> TokenStream {
    let mstmm = &cx.mstmm;
    let (name, visibility) = (&parameter.name, &cx.passthrough.visibility);
    let set = format_ident!("set_{name}", span = name.span());
    let text = name.to_string();
    let doc = format!(" Sets {}", docs::parameter(parameter).trim_start());
    let NewValue { argument, doc: doc_of_value, change, values } = NewValue::of(parameter);
    let rules = rules(cx, &text);
    let derived = sealed::arrays(cx, &quote!(chain_));
    let id = cx.chain.parameters.position(|other| other.name == *name);
    let is_used = id.is_some_and(|id| cx.chain.closure_uses(id));
    let chain = closure::with_rank(cx, is_used, quote!(chain_));
    let doc_of_rank = (is_used && closure::directions(cx).is_some()).then(|| {
        quote! {
            ///
            /// It computes the rank of the loop constraints again, in up to four poses assembled around
            /// the start. If none can be assembled, no direction counts as redundant.
        }
    });
    quote! {
        #[doc = #doc]
        #doc_of_value
        #doc_of_rank
        ///
        /// # Errors
        ///
        /// `Error::InvalidParameter` if the number is not finite or would leave the chain with a mass that is not
        /// positive, with a negative moment of inertia, stiffness or damping, with limits out of order or, for a ball, above
        /// 180 deg, with an axis or a quaternion whose length is not between 1e-15 and 1e15, with a universal hinge or a
        /// gimbal whose successive axes are parallel, with an elastic hinge whose pitch angle at the start or at rest is
        /// not between -90 and 90 deg, or with a quantity that is not finite. It names the body, the hinge or the spring,
        /// and the old number is kept. Whether moments and products of inertia fit together is not tested, because
        /// parameters are set one by one.
        #[allow(unused_variables, clippy::all)]
        #visibility fn #set(&mut self, #argument) -> ::core::result::Result<(), #mstmm::Error> {
            let mut parameters_ = *self.parameters();
            #change
            let values_ = #values;
            let sealed_ = #mstmm::generated::Sealed::new(parameters_);
            let (chain_, checks_) = Self::derive(sealed_);
            #mstmm::generated::check_parameter(#text, values_)?;
            #rules
            #mstmm::generated::check_derived(#text, &[#(&#derived),*])?;
            *self = #chain;
            ::core::result::Result::Ok(())
        }
    }
}

/// The parts of a setter that differ between one value and a value for each repetition.
struct NewValue {
    /// The argument `value_`.
    argument: TokenStream,
    /// The lines of docs on the argument.
    doc: TokenStream,
    /// The statements that change the parameter.
    change: TokenStream,
    /// The slice of the new values.
    values: TokenStream,
}

impl NewValue {
    /// Returns the parts for a parameter.
    fn of(Parameter { name, repetitions, .. }: &Parameter) -> Self {
        let Some(repetitions) = repetitions else {
            return NewValue {
                argument: quote!(value_: T),
                doc: TokenStream::new(),
                change: quote!(parameters_.#name = value_;),
                values: quote!(&[value_]),
            };
        };
        let doc = format!(
            " `value` returns the number of each of the {repetitions} repetitions, by index."
        );
        NewValue {
            argument: quote!(mut value_: impl ::core::ops::FnMut(::core::primitive::usize) -> T),
            doc: quote! {
                ///
                #[doc = #doc]
            },
            change: quote! {
                for (index_, place_) in ::core::iter::zip(0.., &mut parameters_.#name) {
                    *place_ = value_(index_);
                }
            },
            values: quote!(&parameters_.#name),
        }
    }
}

/// Returns the statements that test the rules on the chain with the new parameter.
fn rules(cx: &EmitContext, parameter: &str) -> TokenStream {
    let mstmm = &cx.mstmm;
    let of_segment = |segment: Segment| {
        let rules = cx.compiled.checks[segment.first..segment.first + segment.count].iter();
        let rules = rules.map(|check| {
            let (positive, reason) = (check.must == Bound::BePositive, &check.reason);
            quote!((#positive, #reason))
        });
        if segment.repetitions == 1
            && segment.offset == 0
            && segment.count == cx.compiled.checks.len()
        {
            return quote!(#mstmm::generated::check_rules(#parameter, &checks_, &[#(#rules),*])?;);
        }
        let slices = cx.slices(&quote!(checks_), &segment);
        quote! {
            for numbers_ in #slices {
                #mstmm::generated::check_rules(#parameter, numbers_, &[#(#rules),*])?;
            }
        }
    };
    checked(cx).segments.into_iter().map(of_segment).collect()
}
