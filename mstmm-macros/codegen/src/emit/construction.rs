//! The chain's type, how it is made and where it starts.

use super::Plan;
use super::arrays::usize_literal;
use super::closure;
use super::docs;
use super::formula::value_tokens;
use super::names::helper;
use super::parameters;
use super::printer::Destination;
use super::sealed;
use crate::compile::outputs;
use crate::ids::RepeatId;
use crate::model::{Must, Requirement, Symbol, Value};
use proc_macro2::{Delimiter, Group, Literal, Span, TokenStream};
use quote::{ToTokens, quote, quote_spanned};

/// `struct Chain<T>`, `struct ChainParameters<T>` and their constructors.
pub fn emit(plan: &Plan) -> TokenStream {
    let mstmm = &plan.mstmm;
    let chain = chain_type(plan);
    let parameters = parameters::type_of_all(plan);
    let constructors = constructors(plan);
    let derive = derive(plan);
    let rank = closure::emit(plan);
    let setters = plan.chain.parameters.iter().map(|parameter| parameters::setter(plan, parameter));
    let name = &plan.names.chain;
    let assertions = plan.chain.assertions.iter().filter_map(|rule| assertion(plan, rule));
    quote! {
        #chain
        #parameters
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

fn chain_type(plan: &Plan) -> TokenStream {
    let name = &plan.names.chain;
    let (visibility, attributes) = (&plan.surface.visibility, &plan.surface.attributes);
    let description = docs::chain(plan);
    let (field, sealed) = (sealed::field(), sealed::type_of(plan));
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

/// `new`, `parameters` and the evaluation of constants.
fn constructors(plan: &Plan) -> TokenStream {
    let (mstmm, field) = (&plan.mstmm, sealed::field());
    let (parameters, visibility) = (&plan.names.parameters, &plan.surface.visibility);
    let values = plan.chain.parameters.iter().map(|parameter| {
        let (name, value) = (&parameter.name, value_tokens(plan, &parameter.default));
        let one = quote!(T::constant(#value));
        match parameter.times.map(usize_literal) {
            None => quote!(#name: #one),
            Some(times) => quote!(#name: [#one; #times]),
        }
    });
    let steps = closure::directions(plan).map(|count| {
        let (field, count) = (closure::steps(plan), usize_literal(count));
        quote!(#field: [T::constant(1.0); #count],)
    });
    let is_empty = plan.chain.parameters.is_empty() && steps.is_none();
    let marker = is_empty.then(|| quote!(none: ::core::marker::PhantomData));
    let chain = closure::found(plan, true, quote!(chain_));
    let doc = if plan.chain.parameters.is_empty() {
        " The chain as described."
    } else {
        " The chain as described, its parameters at their defaults."
    };
    let read = match plan.chain.parameters.is_empty() {
        true => " The values that may change at run time: there are none.",
        false => " The values that may change at run time. Each has a setter.",
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

/// The chain with what follows from parameters and constants, once for all steps; and the numbers to
/// be checked.
fn derive(plan: &Plan) -> TokenStream {
    let (mstmm, field) = (&plan.mstmm, sealed::field());
    let procedure = &plan.compiled.setup.procedure;
    let of_part = |part: RepeatId| helper(&format!("derived{}", part.index()));
    let statements = plan.procedure(procedure, |id| {
        Destination::New(match (id, id.part) {
            (outputs::CHECKED, _) => helper("checks"),
            (_, Some(part)) => of_part(part),
            (_, None) => helper("derived"),
        })
    });
    let check_count = usize_literal(parameters::checked(plan).total);
    let parts = sealed::parts(plan).into_iter().map(|(part, _)| of_part(part).to_token_stream());
    let constants = plan.surface.constants.iter();
    let evaluate = (!plan.surface.constants.is_empty()).then(|| {
        let count = Literal::usize_unsuffixed(plan.surface.constants.len());
        quote!(let constants_: &[T; #count] = &[#(T::constant(#constants)),*];)
    });
    let parameters = &plan.names.parameters;
    let doc = format!(" Quantities derived from parameters and constants: {}.", procedure.cost());
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

/// What must hold of Rust constants is checked while the user's crate compiles, with the parameters
/// at their defaults.
fn assertion(plan: &Plan, requirement: &Requirement) -> Option<TokenStream> {
    let conditions = requirement.iter().filter(|condition| is_const(plan, &condition.value));
    let checks = conditions.rev().fold(TokenStream::new(), |rest, condition| {
        let (value, zero) = (value_tokens(plan, &condition.value), Literal::f64_suffixed(0.0));
        let holds = match condition.must {
            Must::BeFinite => quote!(<::core::primitive::f64>::is_finite(#value)),
            Must::BePositive => quote!(!(#value <= #zero)),
            Must::NotBeNegative => quote!(!(#value < #zero)),
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

/// Whether a formula can be evaluated in a `const` item.
fn is_const(plan: &Plan, value: &Value) -> bool {
    let is_const = |value: &Value| is_const(plan, value);
    match value {
        Value::Number(_) | Value::Symbol(Symbol::Constant(_)) => true,
        Value::Sum(a, b) | Value::Product(a, b) | Value::Quotient(a, b) => {
            is_const(a) && is_const(b)
        }
        Value::Symbol(Symbol::Parameter(index)) => is_const(&plan.chain.parameters[*index].default),
        Value::Sqrt(_) | Value::Sin(_) | Value::Cos(_) => false,
    }
}
