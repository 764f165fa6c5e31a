//! The methods that map states: coordinate rates, normalised quaternions, projections of closed chains, and the initial
//! state.

use super::super::EmitContext;
use super::super::arrays::usize_literal;
use super::super::closure;
use super::super::printer::Destination;
use super::{MethodTemplate, new, of_state};
use proc_macro2::TokenStream;
use quote::quote;

pub(super) fn coordinate_rates(cx: &EmitContext) -> MethodTemplate {
    let (mstmm, count) = (&cx.mstmm, usize_literal(cx.coordinates().total));
    let given = of_state(cx);
    MethodTemplate {
        name: quote!(#[inline] fn coordinate_rates_into_),
        docs: [
            quote! {
                /// Computes the time derivatives of the coordinates.
            },
            TokenStream::new(),
        ],
        arguments: quote!(#given coordinates_: &mut #mstmm::nalgebra::SVector<T, #count>),
        returns: quote!(()),
        opening: TokenStream::new(),
        end: TokenStream::new(),
        destination: |_, _| Destination::Vector(quote!((*coordinates_))),
    }
}

pub(super) fn normalized(cx: &EmitContext) -> MethodTemplate {
    let count = usize_literal(cx.coordinates().total);
    MethodTemplate {
        name: quote!(#[inline] fn normalized_),
        docs: [
            quote! {
                /// Returns the coordinates with normalised quaternions.
            },
            TokenStream::new(),
        ],
        arguments: of_state(cx),
        returns: quote!([T; #count]),
        opening: TokenStream::new(),
        end: quote!(coordinates_),
        destination: |_, _| new("coordinates"),
    }
}

pub(super) fn correction(cx: &EmitContext) -> MethodTemplate {
    let mstmm = &cx.mstmm;
    let (state, inputs) = (&cx.names.state, &cx.names.inputs);
    MethodTemplate {
        name: quote!(fn correct),
        docs: [
            quote! {
                /// Corrects coordinates and rates once, by the motion of least kinetic energy that satisfies the
                /// linearised loop constraints, and returns how far they were from satisfying them.
            },
            TokenStream::new(),
        ],
        arguments: quote!(state_: &mut #state<T>, inputs_: &#inputs<T>),
        returns: quote!(#mstmm::generated::Residual<T>),
        opening: TokenStream::new(),
        end: quote! {
            state_.q.data.0 = [coordinates_];
            state_.v.data.0 = [rates_];
            #mstmm::generated::Residual::from_array(residual_)
        },
        destination: |_, id| new(id.name),
    }
}

pub(super) fn closure_pivots(cx: &EmitContext) -> MethodTemplate {
    let count = closure::directions(cx).map(usize_literal);
    MethodTemplate {
        name: quote!(fn closure_pivots_),
        docs: [
            quote! {
                /// Returns the pivots of the directions of the closing hinge, the largest first.
            },
            TokenStream::new(),
        ],
        arguments: of_state(cx),
        returns: quote!([T; #count]),
        opening: TokenStream::new(),
        end: quote!(pivots_),
        destination: |_, _| new("pivots"),
    }
}

pub(super) fn start(cx: &EmitContext) -> MethodTemplate {
    let mstmm = &cx.mstmm;
    let (state, visibility) = (&cx.names.state, &cx.passthrough.visibility);
    MethodTemplate {
        name: quote!(#[must_use] #visibility fn initial_state),
        docs: [
            quote! {
                /// Returns the state at the start of the description, at time zero.
            },
            TokenStream::new(),
        ],
        arguments: TokenStream::new(),
        returns: quote!(#state<T>),
        opening: TokenStream::new(),
        end: quote! {
            #state {
                q: #mstmm::generated::vector(coordinates_),
                v: #mstmm::generated::vector(rates_),
                t: T::constant(0.0),
            }
        },
        destination: |_, id| new(id.name),
    }
}
