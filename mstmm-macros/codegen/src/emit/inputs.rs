//! The inputs: values that the caller supplies at every step.

use super::EmitContext;
use super::arrays::usize_literal;
use crate::ids::InputId;
use crate::model::{Hinge, HingeId, Input, InputKind, StateView, ViewArgument};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// Returns `struct ChainInputs<T>` and its constructors.
pub fn emit(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    let (name, visibility) = (&cx.names.inputs, &cx.passthrough.visibility);
    let chain = &cx.names.chain;
    let doc =
        format!(" The inputs of [`{chain}`]: what acts on it from outside, given at every step.");
    let inputs = &cx.layout.inputs;
    let fields = inputs.iter().map(|input| {
        let (name, doc, single) =
            (cx.chain.name_of_input(input.what), doc_of(cx, input), type_of(cx, input));
        let ty = repetitions(cx, input).map_or(single.clone(), |count| quote!([#single; #count]));
        quote!(#[doc = #doc] #visibility #name: #ty)
    });
    let zeros = inputs.iter().map(|input| {
        let (name, single) = (cx.chain.name_of_input(input.what), zero_of(cx, input));
        let zero = repetitions(cx, input).map_or(single.clone(), |count| quote!([#single; #count]));
        quote!(#name: #zero)
    });
    // A struct without fields would not use `T`.
    let (marker, marker_value) = if inputs.is_empty() {
        (quote!(none: ::core::marker::PhantomData<T>), quote!(none: ::core::marker::PhantomData))
    } else {
        (TokenStream::new(), TokenStream::new())
    };
    quote! {
        #[doc = #doc]
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[allow(dead_code, non_snake_case)]
        #visibility struct #name<T> {
            #(#fields,)*
            #marker
        }
        impl<T: #mstmm::Scalar> ::core::default::Default for #name<T> {
            #[inline]
            fn default() -> Self {
                Self { #(#zeros,)* #marker_value }
            }
        }
        #[allow(dead_code, non_snake_case)]
        impl<T: #mstmm::Scalar> #chain<T> {
            /// Returns inputs that are all zero; prescribed motions are at rest in the zero position.
            #[inline]
            #[must_use]
            #visibility fn no_inputs(&self) -> #name<T> {
                ::core::default::Default::default()
            }
        }
    }
}

/// Returns the number of repetitions of an input to a repeated part.
fn repetitions(cx: &EmitContext, input: &Input) -> Option<Literal> {
    let repeat = cx.chain.repeat_of_input(input.what)?;
    Some(usize_literal(cx.chain.repeats[repeat].count))
}

fn doc_of(cx: &EmitContext, input: &Input) -> String {
    match input.what {
        InputKind::Gravity => " The acceleration of free fall in m/s², inertial frame.".to_owned(),
        InputKind::Efforts(index) => {
            let Hinge { name, kind, .. } = &cx.chain.hinges[index];
            let unit = |rotational: bool| if rotational { "N m" } else { "N" };
            let units: Vec<&str> = kind.spec().groups.iter().map(|g| unit(g.rotational)).collect();
            let unit = units.join(", ");
            format!(" The efforts of the motor of `{name}` in {unit}, in the order of its rates.")
        }
        InputKind::Motion(index) => {
            let Hinge { name, .. } = &cx.chain.hinges[index];
            format!(" The prescribed motion of `{name}`.")
        }
        InputKind::Force(load) => format!(" The force of `{}` in N.", cx.chain.loads[load].name),
        InputKind::Torque(load) => {
            format!(" The torque of `{}` in N m.", cx.chain.loads[load].name)
        }
        InputKind::SpringForce(spring) => format!(
            " The force of the actuator of `{}` in N, positive if it pushes the ends apart.",
            cx.chain.springs[spring].name
        ),
    }
}

fn type_of(cx: &EmitContext, input: &Input) -> TokenStream {
    let mstmm = &cx.mstmm;
    match input.what {
        InputKind::Motion(hinge) => {
            let view = view_name(cx, hinge);
            let acceleration = cx.numbers_type(cx.chain.hinges[hinge].kind.dof_count());
            quote!(#mstmm::HingeMotion<#mstmm::#view<T>, #acceleration>)
        }
        _ => cx.numbers_type(input.range.len()),
    }
}

fn zero_of(cx: &EmitContext, input: &Input) -> TokenStream {
    let mstmm = &cx.mstmm;
    let zero = |count: usize| match count {
        1 => quote!(T::constant(0.0)),
        _ => quote!(#mstmm::generated::vector([T::constant(0.0); #count])),
    };
    match input.what {
        InputKind::Motion(hinge) => {
            let view = view_name(cx, hinge);
            let acceleration = zero(cx.chain.hinges[hinge].kind.dof_count());
            quote! {
                #mstmm::HingeMotion {
                    state: <#mstmm::#view<T> as ::core::default::Default>::default(),
                    acceleration: #acceleration,
                }
            }
        }
        _ => zero(input.range.len()),
    }
}

fn view_name(cx: &EmitContext, hinge: HingeId) -> Ident {
    format_ident!("{}", cx.view(hinge).name)
}

impl EmitContext<'_> {
    /// Returns the view of a hinge that has coordinates.
    pub fn view(&self, hinge: HingeId) -> &'static StateView {
        let Hinge { name, kind, .. } = &self.chain.hinges[hinge];
        kind.spec()
            .view
            .as_ref()
            .unwrap_or_else(|| bug!("hinge `{name}` has no coordinates to view"))
    }

    /// Returns the type of this number of values: a scalar or a vector.
    pub fn numbers_type(&self, count: usize) -> TokenStream {
        let mstmm = &self.mstmm;
        match count {
            0 => quote!(()),
            1 => quote!(T),
            _ => quote!(#mstmm::nalgebra::SVector<T, #count>),
        }
    }

    /// Returns statements that destructure an input into variables for all its values.
    pub fn read_input(&self, input: InputId, from: &TokenStream, symbols: &[Ident]) -> TokenStream {
        let input = &self.layout.inputs[input];
        match input.what {
            InputKind::Motion(hinge) => {
                let kind = &self.chain.hinges[hinge].kind;
                let (coordinates, dof_count) = (kind.coordinates(), kind.dof_count());
                let groups = self.view(hinge).groups.iter().map(|group| match group {
                    ViewArgument::Coordinates(range) => tuple_or_one(&symbols[range.clone()]),
                    ViewArgument::Rates(range) => {
                        let range = coordinates + range.start..coordinates + range.end;
                        tuple_or_one(&symbols[range])
                    }
                });
                let accelerations = &symbols[coordinates + dof_count..];
                let taken = take(accelerations, quote!(#from.acceleration));
                quote! {
                    let (#(#groups,)*) = #from.state.into_groups();
                    #taken
                }
            }
            _ => take(symbols, quote!(#from)),
        }
    }
}

/// Returns statements that destructure a scalar or a vector.
fn take(variables: &[Ident], from: TokenStream) -> TokenStream {
    match variables {
        [single] => quote!(let #single = #from;),
        _ => quote!(let [[#(#variables),*]] = #from.data.0;),
    }
}

fn tuple_or_one(variables: &[Ident]) -> TokenStream {
    match variables {
        [single] => quote!(#single),
        _ => quote!([#(#variables),*]),
    }
}
