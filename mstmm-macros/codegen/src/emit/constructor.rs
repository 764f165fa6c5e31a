//! The chain's type, its constructors and its initial state.

use super::EmitContext;
use super::arrays::usize_literal;
use super::closure;
use super::const_expr::{constant, constants, is_const, value_tokens};
use super::docs;
use super::methods;
use super::names::helper;
use super::parameters;
use super::printer::Destination;
use super::sealed;
use crate::compile::outputs;
use crate::ids::RepeatId;
use crate::model::{Bound, Requirement};
use proc_macro2::{Delimiter, Group, Literal, Span, TokenStream};
use quote::{ToTokens, quote, quote_spanned};

/// Returns `struct Chain<T>`, `struct ChainParameters<T>` and their constructors.
pub fn emit(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    let chain = chain_type(cx);
    let parameters = parameters::type_of_all(cx);
    let constants = constants(cx);
    let constructors = constructors(cx);
    let derive = derive(cx);
    let rank = closure::emit(cx);
    let setters = cx.chain.parameters.iter().map(|parameter| parameters::setter(cx, parameter));
    let name = &cx.names.chain;
    let assertions = cx.chain.assertions.iter().filter_map(|rule| assertion(cx, rule));
    quote! {
        #chain
        #parameters
        #constants
        #[allow(dead_code, non_snake_case)]
        impl<T: #mstmm::Scalar> #name<T> {
            #constructors
            #(#setters)*
            #derive
            #rank
        }
        impl<T: #mstmm::Scalar> ::core::default::Default for #name<T> {
            fn default() -> Self {
                Self::new()
            }
        }
        #(#assertions)*
    }
}

fn chain_type(cx: &EmitContext) -> TokenStream {
    let name = &cx.names.chain;
    let (visibility, attributes) = (&cx.passthrough.visibility, &cx.passthrough.attributes);
    let description = [docs::chain(cx), methods::operations(cx)].concat();
    let (field, sealed) = (sealed::field(), sealed::type_of(cx));
    quote! {
        #(#attributes)*
        #(#[doc = #description])*
        #[derive(Clone, Debug, PartialEq)]
        #[allow(dead_code, non_snake_case)]
        #visibility struct #name<T> {
            #field: #sealed,
        }
    }
}

/// Returns `new`, `parameters` and the evaluation of constants.
fn constructors(cx: &EmitContext) -> TokenStream {
    let (mstmm, field) = (&cx.mstmm, sealed::field());
    let (parameters, visibility) = (&cx.names.parameters, &cx.passthrough.visibility);
    let values = cx.chain.parameters.iter().map(|parameter| {
        let (name, value) = (&parameter.name, value_tokens(cx, &parameter.default));
        let constant = quote!(T::constant(#value));
        match parameter.repetitions.map(usize_literal) {
            None => quote!(#name: #constant),
            Some(times) => quote!(#name: [#constant; #times]),
        }
    });
    let steps = closure::directions(cx).map(|count| {
        let (field, count) = (closure::steps(cx), usize_literal(count));
        quote!(#field: [T::constant(1.0); #count],)
    });
    let is_empty = cx.chain.parameters.is_empty() && steps.is_none();
    let marker = is_empty.then(|| quote!(none: ::core::marker::PhantomData));
    let chain = closure::with_rank(cx, true, quote!(chain_));
    let doc = if cx.chain.parameters.is_empty() {
        " Makes the chain of the description."
    } else {
        " Makes the chain of the description, with default parameters."
    };
    let read = match cx.chain.parameters.is_empty() {
        true => " Returns the parameters, which can change at run time: there are none.",
        false => " Returns the parameters, which can change at run time. Each has a setter.",
    };
    quote! {
        #[doc = #doc]
        #[inline]
        #[must_use]
        #[allow(clippy::all)]
        #visibility fn new() -> Self {
            let parameters_ = #parameters { #(#values,)* #steps #marker };
            let (chain_, _) = Self::derive(#mstmm::generated::Sealed::new(parameters_));
            #chain
        }

        #[doc = #read]
        #[inline]
        #visibility fn parameters(&self) -> &#parameters<T> {
            self.#field.parameters()
        }
    }
}

/// Returns the method that derives the slots from parameters and constants, and the values to be checked.
fn derive(cx: &EmitContext) -> TokenStream {
    let (mstmm, field) = (&cx.mstmm, sealed::field());
    let procedure = &cx.compiled.setup.procedure;
    let of_part = |part: RepeatId| helper(&format!("derived{}", part.index()));
    let statements = cx.procedure(procedure, &TokenStream::new(), |id| {
        Destination::New(match (id, id.part) {
            (outputs::CHECKED, _) => helper("checks"),
            (_, Some(part)) => of_part(part),
            (_, None) => helper("derived"),
        })
    });
    let check_count = usize_literal(parameters::checked(cx).total);
    let parts = sealed::parts(cx).into_iter().map(|(part, _)| of_part(part).to_token_stream());
    let constants = (0..cx.passthrough.constants.len()).map(|index| constant(cx, index));
    let evaluate = (!cx.passthrough.constants.is_empty()).then(|| {
        let count = Literal::usize_unsuffixed(cx.passthrough.constants.len());
        quote!(let constants_: &[T; #count] = &[#(T::constant(#constants)),*];)
    });
    let parameters = &cx.names.parameters;
    let doc = format!(
        " Computes the values derived from parameters and constants: {}.",
        procedure.cost()
    );
    let derived = sealed::paired(quote!(derived_), parts);
    quote! {
        #[doc = #doc]
        #[allow(unused_doc_comments, unused_variables, unused_mut, clippy::all)]
        fn derive(
            sealed_: #mstmm::generated::Sealed<#parameters<T>>,
        ) -> (Self, [T; #check_count]) {
            #evaluate
            let parameters_ = sealed_.parameters();
            #statements
            (Self { #field: sealed_.with(#derived) }, checks_)
        }
    }
}

/// Returns the assertion of a requirement on Rust constants, which is evaluated when the user's crate compiles, with the
/// parameters at their defaults.
fn assertion(cx: &EmitContext, requirement: &Requirement) -> Option<TokenStream> {
    let conditions = requirement.iter().filter(|condition| is_const(cx, &condition.value));
    let checks = conditions.rev().fold(TokenStream::new(), |rest, condition| {
        let (value, zero) = (value_tokens(cx, &condition.value), Literal::f64_suffixed(0.0));
        let holds = match condition.must {
            Bound::BeFinite => quote!(<::core::primitive::f64>::is_finite(#value)),
            Bound::BePositive => quote!(!(#value <= #zero)),
            Bound::NotBeNegative => quote!(!(#value < #zero)),
        };
        match &condition.message {
            // It is reported elsewhere.
            None => quote!(if #holds { #rest }),
            Some(message) => {
                // From the first to the last token of the number, for the compiler to point there.
                let [first, last] = [condition.at.first, condition.at.last]
                    .map(|span| span.resolved_at(Span::call_site()));
                let mut arguments = Group::new(Delimiter::Parenthesis, quote!(#holds, #message));
                arguments.set_span(last);
                let assert = quote_spanned!(first=> ::core::assert!);
                quote!(#assert #arguments; #rest)
            }
        }
    });
    (!checks.is_empty()).then(|| {
        quote! {
            #[allow(clippy::all)]
            const _: () = { #checks };
        }
    })
}
