//! The type of states, with access to hinges by name.

use super::arrays::usize_literal;
use super::names::{accessor_mut, helper};
use super::{EmitContext, indexed_access, orders, quaternions};
use crate::model::{Element, HingeId, ViewArgument};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use std::ops::Range;

/// Returns `struct ChainState<T>` and its implementations.
pub fn emit(cx: &EmitContext) -> TokenStream {
    let (mstmm, name, chain) = (&cx.mstmm, &cx.names.state, &cx.names.chain);
    let declaration = declaration(cx);
    let accessors = cx.chain.hinges.ids().into_iter().map(|index| accessors(cx, index));
    let chain_state = chain_state(cx);
    quote! {
        #declaration
        #[allow(dead_code, non_snake_case)]
        impl<T: #mstmm::Scalar> #name<T> {
            #(#accessors)*
        }
        impl<T: #mstmm::Scalar> ::core::default::Default for #name<T> {
            fn default() -> Self {
                #chain::new().initial_state()
            }
        }
        #chain_state
    }
}

/// Returns the struct.
fn declaration(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    let (name, visibility) = (&cx.names.state, &cx.passthrough.visibility);
    let doc = format!(" The state of [`{}`]: coordinates, rates and time.", cx.names.chain);
    let order = orders::of_state(cx);
    let [coordinates, dof_count] = [cx.coordinates(), cx.rates()].map(|it| usize_literal(it.total));
    quote! {
        #[doc = #doc]
        ///
        #(#[doc = #order])*
        ///
        /// [`Default`] is the start of the description with default parameters, at time zero.
        #[derive(Clone, Debug, PartialEq)]
        #[allow(dead_code, non_snake_case)]
        #visibility struct #name<T> {
            /// The coordinates: angles in rad, lengths in m, unit quaternions as w, x, y, z.
            #[doc(alias("generalized coordinates", "qpos", "configuration", "nq"))]
            #visibility q: #mstmm::nalgebra::SVector<T, #coordinates>,
            /// The rates in rad/s and m/s.
            #[doc(alias("generalized velocities", "qvel", "nv"))]
            #visibility v: #mstmm::nalgebra::SVector<T, #dof_count>,
            /// The time in s.
            #visibility t: T,
        }
    }
}

/// Returns the implementation of `ChainState`.
fn chain_state(cx: &EmitContext) -> TokenStream {
    let (mstmm, name) = (&cx.mstmm, &cx.names.state);
    let (rest, dof_count) = (rest(cx), usize_literal(cx.rates().total));
    quote! {
        impl<T: #mstmm::Scalar> #mstmm::ChainState for #name<T> {
            type Scalar = T;
            fn zero_position() -> Self {
                let (zero_, one_) = (T::constant(0.0), T::constant(1.0));
                let _ = one_;
                Self {
                    q: #mstmm::generated::vector(#rest),
                    v: #mstmm::generated::vector([zero_; #dof_count]),
                    t: zero_,
                }
            }
            #[inline]
            fn coordinates(&self) -> &[T] {
                self.q.as_slice()
            }
            #[inline]
            fn coordinates_mut(&mut self) -> &mut [T] {
                self.q.as_mut_slice()
            }
            #[inline]
            fn rates(&self) -> &[T] {
                self.v.as_slice()
            }
            #[inline]
            fn rates_mut(&mut self) -> &mut [T] {
                self.v.as_mut_slice()
            }
            #[inline]
            fn time(&self) -> T {
                self.t
            }
            #[inline]
            fn set_time(&mut self, time_: T) {
                self.t = time_;
            }
        }
    }
}

/// Returns the coordinates with every hinge in its zero position.
fn rest(cx: &EmitContext) -> TokenStream {
    let free = cx.chain.hinges.iter().filter(|hinge| !hinge.is_prescribed());
    let coordinates = free.flat_map(|hinge| hinge.kind.spec().coordinates);
    let rest: Vec<TokenStream> =
        coordinates.map(|c| if c.rest == 1.0 { quote!(one_) } else { quote!(zero_) }).collect();
    let layout = cx.coordinates();
    if cx.chain.repeats.is_empty() {
        return quote!([#(#rest),*]);
    }
    let total = usize_literal(layout.total);
    let fill = layout.segments.iter().map(|segment| {
        let own = &rest[segment.first..segment.first + segment.count];
        let slices = cx.slices_mut(&quote!(rest_), segment);
        quote! {
            for part_ in #slices {
                *part_ = [#(#own),*];
            }
        }
    });
    quote!({
        let mut rest_ = [zero_; #total];
        #(#fill)*
        rest_
    })
}

/// Returns the methods for the views of a hinge's coordinates and rates.
fn accessors(cx: &EmitContext, index: HingeId) -> TokenStream {
    let mstmm = &cx.mstmm;
    let hinge = &cx.chain.hinges[index];
    if hinge.is_prescribed() {
        return TokenStream::new();
    }
    let (name, name_mut) = (&hinge.name, accessor_mut(&hinge.name));
    let Some(view) = &hinge.kind.spec().view else { return TokenStream::new() };
    if let Some(repeat) = cx.chain.repeat_of_hinge(index) {
        return indexed_access::state_accessors(cx, index, cx.chain.repeats[repeat].count);
    }
    let (q, v) = (&cx.layout.q[index], &cx.layout.v[index]);
    let arguments = view.groups.iter().map(|group| {
        let (is_q, range) = match group {
            ViewArgument::Coordinates(range) => (true, q.start + range.start..q.start + range.end),
            ViewArgument::Rates(range) => (false, v.start + range.start..v.start + range.end),
        };
        let names = range.clone().map(|number| variable(is_q, number));
        if range.len() == 1 { quote!(#(#names),*) } else { quote!([#(#names),*]) }
    });
    let arguments = quote!(#(#arguments),*);
    let (view, view_mut) = (format_ident!("{}", view.name), format_ident!("{}Mut", view.name));
    let visibility = &cx.passthrough.visibility;
    let on_route = cx.chain.elements.contains(&Element::Hinge(index));
    let kind = if on_route { "hinge" } else { "body" };
    let path = &hinge.path;
    let doc = format!(" Returns coordinates and rates of {kind} `{path}`.");
    let doc_mut = format!(" Returns coordinates and rates of {kind} `{path}`, for writing.");
    if !cx.chain.repeats.is_empty() {
        return indexed_access::single_accessors(cx, index, (&doc, &doc_mut));
    }
    let (from_q, from_v) = (pattern((true, q)), pattern((false, v)));
    let named = quaternions::named(hinge);
    quote! {
        #[doc = #doc]
        #[inline]
        #[must_use]
        #visibility fn #name(&self) -> #mstmm::#view<T> {
            let [#from_q] = self.q.data.0;
            let [#from_v] = self.v.data.0;
            #mstmm::#view::new(#arguments)
        }

        #[doc = #doc_mut]
        #[inline]
        #visibility fn #name_mut(&mut self) -> #mstmm::#view_mut<'_, T> {
            let [#from_q] = &mut self.q.data.0;
            let [#from_v] = &mut self.v.data.0;
            #mstmm::#view_mut::new(#arguments)#named
        }
    }
}

fn variable(is_q: bool, number: usize) -> Ident {
    helper(&format!("{}{number}", if is_q { "q" } else { "v" }))
}

/// Returns a pattern that binds a range of an array.
fn pattern((is_q, range): (bool, &Range<usize>)) -> TokenStream {
    let skipped = (0..range.start).map(|_| quote!(_,));
    let names = range.clone().map(|number| variable(is_q, number));
    quote!([#(#skipped)* #(#names,)* ..])
}
