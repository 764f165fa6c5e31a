//! The chain's type, its parameters, how it is made and where it starts.

use super::Plan;
use super::docs;
use super::looped::{Target, usize_literal};
use super::spread::Spread;
use crate::model::{Must, Parameter, Requirement, Symbol, Value};
use proc_macro2::{Delimiter, Group, Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote, quote_spanned};

/// `struct Chain<T>`, `struct ChainParameters<T>` and their constructors.
pub fn emit(plan: &Plan) -> TokenStream {
    let mstmm = &plan.mstmm;
    let chain = chain_type(plan);
    let parameters = parameters_type(plan);
    let constructors = constructors(plan);
    let derive = derive(plan);
    let start = start(plan);
    let setters = plan.chain.parameters.iter().map(|parameter| setter(plan, parameter));
    let name = &plan.names.chain;
    let assertions = plan.chain.assertions.iter().filter_map(|rule| assertion(plan, rule));
    quote! {
        #chain
        #parameters
        #[allow(dead_code, non_snake_case)]
        impl<T: #mstmm::Scalar> #name<T> {
            #constructors
            #(#setters)*
            #start
            #derive
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
    let (name, parameters) = (&plan.names.chain, &plan.names.parameters);
    let (visibility, attributes) = (&plan.surface.visibility, &plan.surface.attributes);
    let description = docs::chain(plan);
    let slots = Literal::usize_unsuffixed(plan.programs.setup.outputs[0].len());
    let parts = parts(plan).into_iter().map(|(name, spread)| {
        let total = usize_literal(spread.total);
        quote!(#name: [T; #total],)
    });
    quote! {
        #(#attributes)*
        #(#[doc = #description])*
        #[derive(Clone, Debug, PartialEq)]
        #[allow(dead_code, non_snake_case)]
        #visibility struct #name<T> {
            parameters: #parameters<T>,
            derived: [T; #slots],
            #(#parts)*
        }
    }
}

fn parameters_type(plan: &Plan) -> TokenStream {
    let mstmm = &plan.mstmm;
    let (name, visibility) = (&plan.names.parameters, &plan.surface.visibility);
    let doc = format!(" Numbers of [`{}`] that may change at run time.", plan.names.chain);
    let fields = plan.chain.parameters.iter().map(|parameter| {
        let (name, ty) = (&parameter.name, type_of(parameter));
        quote!(#name: #ty)
    });
    let getters = plan.chain.parameters.iter().map(|parameter| {
        let (name, doc) = (&parameter.name, docs::parameter(parameter));
        let ty = type_of(parameter);
        let (ty, value) = match parameter.times {
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
    // A struct without fields would not use `T`.
    let marker =
        plan.chain.parameters.is_empty().then(|| quote!(none: ::core::marker::PhantomData<T>));
    quote! {
        #[doc = #doc]
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[allow(dead_code, non_snake_case)]
        #visibility struct #name<T> {
            #(#fields,)*
            #marker
        }
        #[allow(dead_code, non_snake_case)]
        impl<T: #mstmm::Scalar> #name<T> {
            #(#getters)*
        }
    }
}

/// `new`, `parameters` and the evaluation of constants.
fn constructors(plan: &Plan) -> TokenStream {
    let (parameters, visibility) = (&plan.names.parameters, &plan.surface.visibility);
    let values = plan.chain.parameters.iter().map(|parameter| {
        let (name, value) = (&parameter.name, value_tokens(plan, &parameter.default));
        let one = quote!(T::constant(#value));
        match parameter.times.map(usize_literal) {
            None => quote!(#name: #one),
            Some(times) => quote!(#name: [#one; #times]),
        }
    });
    let marker =
        plan.chain.parameters.is_empty().then(|| quote!(none: ::core::marker::PhantomData));
    let doc = if plan.chain.parameters.is_empty() {
        " The chain as described."
    } else {
        " The chain as described, its parameters at their defaults."
    };
    quote! {
        #[doc = #doc]
        #[inline]
        #[must_use]
        #[allow(clippy::all)]
        #visibility fn new() -> Self {
            let parameters_ = #parameters { #(#values,)* #marker };
            let (chain_, _) = Self::derive(parameters_);
            chain_
        }

        /// The numbers that may change at run time.
        #[inline]
        #visibility fn parameters(&self) -> &#parameters<T> {
            &self.parameters
        }
    }
}

/// The type of a parameter.
fn type_of(parameter: &Parameter) -> TokenStream {
    match parameter.times.map(usize_literal) {
        None => quote!(T),
        Some(times) => quote!([T; #times]),
    }
}

/// The fields for what is known of every time of repeated parts, and how it lies there.
fn parts(plan: &Plan) -> Vec<(Ident, Spread)> {
    let field = |part: usize| Some((format_ident!("derived{part}"), plan.slots_of_part(part)?));
    (0..plan.chain.repeats.len()).filter_map(field).collect()
}

/// The chain with what follows from parameters and constants, once for all steps; and the numbers to
/// be checked.
fn derive(plan: &Plan) -> TokenStream {
    let program = &plan.programs.setup;
    let checked = checked(plan);
    let own = (0..plan.chain.repeats.len())
        .filter_map(|part| Some((2 + part, plan.slots_of_part(part)?)));
    let targets: Vec<Target> = std::iter::once((1, checked.clone()))
        .chain(own)
        .map(|(group, spread)| Target::new(group, spread))
        .collect();
    let block = plan.setup_block(program, &targets);
    let (statements, slots, checks) = (&block.statements, &block.arrays[0], &block.arrays[1]);
    let check_count = usize_literal(checked.total);
    let (names, arrays): (Vec<Ident>, Vec<&TokenStream>) = (0..plan.chain.repeats.len())
        .filter(|&part| plan.slots_of_part(part).is_some())
        .map(|part| (format_ident!("derived{part}"), &block.arrays[2 + part]))
        .unzip();
    let constants = plan.surface.constants.iter();
    let evaluate = (!plan.surface.constants.is_empty()).then(|| {
        let count = Literal::usize_unsuffixed(plan.surface.constants.len());
        quote!(let constants_: &[T; #count] = &[#(T::constant(#constants)),*];)
    });
    let parameters = &plan.names.parameters;
    let doc = format!(" Quantities derived from parameters and constants: {}.", program.cost());
    quote! {
        #[doc = #doc]
        #[allow(unused_doc_comments, unused_variables, unused_mut, clippy::all)]
        fn derive(parameters_: #parameters<T>) -> (Self, [T; #check_count]) {
            #evaluate
            #statements
            let (derived_, checks_) = (#slots, #checks);
            (Self { parameters: parameters_, derived: derived_, #(#names: #arrays,)* }, checks_)
        }
    }
}

/// How the numbers lie that are checked when a parameter is set.
fn checked(plan: &Plan) -> Spread {
    Spread::of_parts(plan, plan.programs.checks.iter().map(|check| check.part))
}

/// `set_x`: takes effect only if the chain stays a physical one.
fn setter(plan: &Plan, parameter: &Parameter) -> TokenStream {
    let mstmm = &plan.mstmm;
    let (name, visibility) = (&parameter.name, &plan.surface.visibility);
    let set = format_ident!("set_{name}", span = name.span());
    let text = name.to_string();
    let doc = format!(" Sets {}", docs::parameter(parameter).trim_start());
    let rules = checked(plan).pieces.into_iter().map(|piece| {
        let rules = plan.programs.checks[piece.first..piece.first + piece.count].iter();
        let rules = rules.map(|check| {
            let (positive, reason) = (check.positive, &check.reason);
            quote!((#positive, #reason))
        });
        if piece.times == 1 && piece.place == 0 && piece.count == plan.programs.checks.len() {
            return quote!(#mstmm::generated::check_numbers(#text, &checks_, &[#(#rules),*])?;);
        }
        let slices = plan.slices(&quote!(checks_), &piece);
        quote! {
            for numbers_ in #slices {
                #mstmm::generated::check_numbers(#text, numbers_, &[#(#rules),*])?;
            }
        }
    });
    let derived = parts(plan).into_iter().map(|(name, _)| quote!(&chain_.#name));
    let (arguments, change, values) = match parameter.times {
        None => (quote!(value_: T), quote!(parameters_.#name = value_;), quote!(&[value_])),
        Some(_) => (
            quote!(mut value_: impl ::core::ops::FnMut(::core::primitive::usize) -> T),
            quote! {
                for (index_, place_) in ::core::iter::zip(0.., &mut parameters_.#name) {
                    *place_ = value_(index_);
                }
            },
            quote!(&parameters_.#name),
        ),
    };
    let each = parameter.times.map(|times| {
        let doc = format!(" One number for each of {times} times, from `value` by index.");
        quote! {
            ///
            #[doc = #doc]
        }
    });
    quote! {
        #[doc = #doc]
        #each
        ///
        /// # Errors
        ///
        /// `Error::Parameter` if the number is not finite or would
        /// leave the chain with a mass that is not positive, a stiffness or damping that is negative
        /// or a quantity that is not finite; the old one is kept then.
        #[allow(unused_variables, clippy::all)]
        #visibility fn #set(&mut self, #arguments) -> ::core::result::Result<(), #mstmm::Error> {
            let mut parameters_ = self.parameters;
            #change
            let values_ = #values;
            let (chain_, checks_) = Self::derive(parameters_);
            #mstmm::generated::check_parameter(#text, values_, &[&chain_.derived, #(#derived),*])?;
            #(#rules)*
            *self = chain_;
            ::core::result::Result::Ok(())
        }
    }
}

fn start(plan: &Plan) -> TokenStream {
    let mstmm = &plan.mstmm;
    let (state, visibility) = (&plan.names.state, &plan.surface.visibility);
    let targets = [(0, Spread::coordinates(plan)), (1, Spread::freedoms(plan))];
    let targets = targets.map(|(group, spread)| Target::new(group, spread));
    let block = plan.step(&plan.programs.start, &targets, false);
    let (statements, q, v) = (block.statements, &block.arrays[0], &block.arrays[1]);
    quote! {
        /// The state that the description starts from, at time zero.
        #[must_use]
        #[allow(unused_doc_comments, clippy::all)]
        #visibility fn initial_state(&self) -> #state<T> {
            #statements
            #state {
                q: #mstmm::generated::vector(#q),
                v: #mstmm::generated::vector(#v),
                t: T::constant(0.0),
            }
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

/// A formula of constants as an `f64` expression, with parameters at their defaults.
fn value_tokens(plan: &Plan, value: &Value) -> TokenStream {
    let go = |value: &Value| value_tokens(plan, value);
    match value {
        Value::Number(number) => {
            let magnitude = Literal::f64_suffixed(number.abs());
            if *number < 0.0 { quote!((-#magnitude)) } else { quote!(#magnitude) }
        }
        Value::Symbol(Symbol::Constant(index)) => plan.surface.constants[*index].clone(),
        Value::Symbol(Symbol::Parameter(index)) => go(&plan.chain.parameters[*index].default),
        Value::Sum(a, b) => {
            let (a, b) = (go(a), go(b));
            quote!((#a + #b))
        }
        Value::Product(a, b) => {
            let (a, b) = (go(a), go(b));
            quote!((#a * #b))
        }
        Value::Quotient(a, b) => {
            let (a, b) = (go(a), go(b));
            quote!((#a / #b))
        }
        Value::Sqrt(a) => function(plan, "sqrt", go(a)),
        Value::Sin(a) => function(plan, "sin", go(a)),
        Value::Cos(a) => function(plan, "cos", go(a)),
    }
}

/// `core` has no such functions of `f64`; the runtime has.
fn function(plan: &Plan, name: &str, argument: TokenStream) -> TokenStream {
    let mstmm = &plan.mstmm;
    let name = format_ident!("{name}");
    quote!(#mstmm::generated::#name(#argument))
}
