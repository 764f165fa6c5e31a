//! The access to hinges and bodies of chains with repeated parts: by index within a repeated part.

use super::arrays::usize_literal;
use super::names::{accessor_mut, helper};
use super::point_access::{PointIndex, point_type};
use super::quaternions;
use super::{EmitContext, body};
use crate::ids::PointId;
use crate::model::{BodyId, Hinge, HingeId, ViewArgument};
use crate::program::{ArrayLayout, Segment};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use std::ops::Range;

/// The segments of a hinge's coordinates and rates, and the ranges of its entries within them.
struct HingeSegments {
    q: (Segment, Range<usize>),
    v: (Segment, Range<usize>),
}

impl HingeSegments {
    fn of(cx: &EmitContext, hinge: HingeId) -> Self {
        let within = |layout: &ArrayLayout, range: &Range<usize>| {
            let segment = *layout.segment_of(range.start);
            (segment, range.start - segment.first..range.end - segment.first)
        };
        HingeSegments {
            q: within(cx.coordinates(), &cx.layout.q[hinge]),
            v: within(cx.rates(), &cx.layout.v[hinge]),
        }
    }

    /// Returns statements that read the entries of one repetition, or that borrow them mutably if `change`.
    fn taken(&self, cx: &EmitContext, at: &TokenStream, change: bool) -> TokenStream {
        let take =
            |(segment, range): &(Segment, Range<usize>), letter: &str, array: TokenStream| {
                let names = entries(segment, range, letter);
                if change {
                    let slices = cx.slices_mut(&array, segment);
                    quote!(let [#(#names),*] = #slices.get_mut(#at)?;)
                } else {
                    let slices = cx.slices(&array, segment);
                    quote!(let &[#(#names),*] = #slices.get(#at)?;)
                }
            };
        let (q, v) = (take(&self.q, "q", quote!(self.q)), take(&self.v, "v", quote!(self.v)));
        quote!(#q #v)
    }
}

fn variable(letter: &str, number: usize) -> TokenStream {
    let name = helper(&format!("{letter}{number}"));
    quote!(#name)
}

/// Returns the pattern of a segment's entries, in which only those of a range have names.
fn entries(segment: &Segment, range: &Range<usize>, letter: &str) -> Vec<TokenStream> {
    let name = |k: usize| match range.contains(&k) {
        true => variable(letter, k - range.start),
        false => quote!(_),
    };
    (0..segment.count).map(name).collect()
}

/// Returns the arguments of a view's constructor, by group; the names of the variables start with `prefix`.
fn groups(cx: &EmitContext, hinge: HingeId, prefix: &str) -> Vec<TokenStream> {
    let group = |group: &ViewArgument| {
        let (letter, range) = match group {
            ViewArgument::Coordinates(range) => ("q", range.clone()),
            ViewArgument::Rates(range) => ("v", range.clone()),
        };
        let letter = format!("{prefix}{letter}");
        let names: Vec<TokenStream> = range.map(|k| variable(&letter, k)).collect();
        if names.len() == 1 { quote!(#(#names)*) } else { quote!([#(#names),*]) }
    };
    cx.view(hinge).groups.iter().map(group).collect()
}

fn view_name(cx: &EmitContext, hinge: HingeId, suffix: &str) -> Ident {
    format_ident!("{}{suffix}", cx.view(hinge).name)
}

/// Returns the methods for the views of a repeated hinge.
pub fn state_accessors(cx: &EmitContext, hinge: HingeId, count: usize) -> TokenStream {
    let mstmm = &cx.mstmm;
    let Hinge { name, path, .. } = &cx.chain.hinges[hinge];
    let (name_mut, visibility) = (accessor_mut(name), &cx.passthrough.visibility);
    let segments = HingeSegments::of(cx, hinge);
    let [read, change] = [false, true].map(|change| segments.taken(cx, &quote!(index_), change));
    let (view, view_mut) = (view_name(cx, hinge, ""), view_name(cx, hinge, "Mut"));
    let groups = groups(cx, hinge, "");
    let named = quaternions::named(&cx.chain.hinges[hinge]);
    let doc = format!(
        " Returns coordinates and rates of hinge `{path}` in repetition `index` of {count}."
    );
    let doc_mut = format!("{doc} To be changed.");
    let set_each = set_each(cx, hinge, count, &change);
    quote! {
        #[doc = #doc]
        #[inline]
        #[must_use]
        #visibility fn #name(
            &self,
            index_: ::core::primitive::usize,
        ) -> ::core::option::Option<#mstmm::#view<T>> {
            #read
            ::core::option::Option::Some(#mstmm::#view::new(#(#groups),*))
        }

        #[doc = #doc_mut]
        #[inline]
        #visibility fn #name_mut(
            &mut self,
            index_: ::core::primitive::usize,
        ) -> ::core::option::Option<#mstmm::#view_mut<'_, T>> {
            #change
            ::core::option::Option::Some(#mstmm::#view_mut::new(#(#groups),*)#named)
        }

        #set_each
    }
}

/// Returns the method that sets coordinates and rates in all repetitions; `change` borrows those of one.
fn set_each(cx: &EmitContext, hinge: HingeId, count: usize, change: &TokenStream) -> TokenStream {
    let mstmm = &cx.mstmm;
    let Hinge { name, path, kind, .. } = &cx.chain.hinges[hinge];
    let (set_each, visibility) = (format_ident!("set_each_{name}"), &cx.passthrough.visibility);
    let (view, new_groups) = (view_name(cx, hinge, ""), groups(cx, hinge, "new_"));
    let given =
        |letter: &'static str, count: usize| (0..count).map(move |k| format!("{letter}{k}"));
    let all: Vec<String> =
        given("q", kind.coordinates()).chain(given("v", kind.dof_count())).collect();
    let new = all.iter().map(|name| helper(&format!("new_{name}")));
    let all = all.iter().map(|name| helper(name));
    let times = usize_literal(count);
    let doc =
        format!(" Sets coordinates and rates of hinge `{path}` in all repetitions, by index.");
    quote! {
        #[doc = #doc]
        #visibility fn #set_each(&mut self, mut view_: impl ::core::ops::FnMut(::core::primitive::usize) -> #mstmm::#view<T>) {
            let mut set_ = |index_: ::core::primitive::usize| -> ::core::option::Option<()> {
                let (#(#new_groups,)*) = view_(index_).into_groups();
                #change
                #(*#all = #new;)*
                ::core::option::Option::Some(())
            };
            for index_ in 0..#times {
                set_(index_);
            }
        }
    }
}

/// Returns the methods for the views of a hinge outside of repeated parts.
pub fn single_accessors(
    cx: &EmitContext,
    hinge: HingeId,
    (doc, doc_mut): (&str, &str),
) -> TokenStream {
    let mstmm = &cx.mstmm;
    let name = &cx.chain.hinges[hinge].name;
    let (name_mut, visibility) = (accessor_mut(name), &cx.passthrough.visibility);
    let (view, view_mut) = (view_name(cx, hinge, ""), view_name(cx, hinge, "Mut"));
    let HingeSegments { q, v } = HingeSegments::of(cx, hinge);
    let (q_of_state, v_of_state) = (quote!(self.q), quote!(self.v));
    let (read_q, read_v) = (copied(cx, &q, "q", &q_of_state), copied(cx, &v, "v", &v_of_state));
    let (change_q, change_v) = (
        borrowed(cx.coordinates(), &q, "q", &q_of_state),
        borrowed(cx.rates(), &v, "v", &v_of_state),
    );
    let groups = groups(cx, hinge, "");
    let named = quaternions::named(&cx.chain.hinges[hinge]);
    quote! {
        #[doc = #doc]
        #[inline]
        #[must_use]
        #visibility fn #name(&self) -> #mstmm::#view<T> {
            #read_q
            #read_v
            #mstmm::#view::new(#(#groups),*)
        }

        #[doc = #doc_mut]
        #[inline]
        #visibility fn #name_mut(&mut self) -> #mstmm::#view_mut<'_, T> {
            #change_q
            #change_v
            #mstmm::#view_mut::new(#(#groups),*)#named
        }
    }
}

/// Returns the statement that copies the entries of a hinge outside of repeated parts.
fn copied(
    cx: &EmitContext,
    (segment, range): &(Segment, Range<usize>),
    letter: &str,
    array: &TokenStream,
) -> TokenStream {
    let mstmm = &cx.mstmm;
    let names = entries(segment, range, letter);
    let [count, offset] = [segment.count, segment.offset].map(usize_literal);
    quote! {
        let [#(#names),*] = #mstmm::generated::segment::<_, #count, #offset>(&#array);
    }
}

/// Returns the statement that borrows the entries of a hinge outside of repeated parts for writing.
///
/// Its pattern counts from the nearer end, so that it stays short after a long repeated part.
fn borrowed(
    layout: &ArrayLayout,
    (segment, range): &(Segment, Range<usize>),
    letter: &str,
    array: &TokenStream,
) -> TokenStream {
    let names = (0..range.len()).map(|k| variable(letter, k));
    let before = segment.offset + range.start;
    let after = layout.total - before - range.len();
    let pattern = if before <= after {
        let skipped = (0..before).map(|_| quote!(_,));
        quote!([#(#skipped)* #(#names,)* ..])
    } else {
        let skipped = (0..after).map(|_| quote!(_,));
        quote!([.., #(#names,)* #(#skipped)*])
    };
    quote!(let [#pattern] = &mut #array.data.0;)
}

/// Returns the method for the results of a repeated body.
pub fn body(cx: &EmitContext, (index, element): (BodyId, usize), count: usize) -> TokenStream {
    let (body, visibility) = (&cx.chain.bodies[index], &cx.passthrough.visibility);
    let name = &body.name;
    let contents = body::contents(body);
    let doc = format!(
        " Returns the results at body `{}` in repetition `index` of {count}: {contents}.",
        body.path
    );
    let (ends, ty) = (ends(cx, element, count), body::type_of(cx, index));
    let at = |point: PointId| {
        let PointIndex { first, stride, .. } = cx.point_index(point);
        affine(first, stride)
    };
    let result = body::result(cx, (index, element), &quote!(first_), at);
    quote! {
        #[doc = #doc]
        #[inline]
        #visibility fn #name(
            &self,
            index_: ::core::primitive::usize,
        ) -> ::core::option::Option<#ty> {
            #ends
            ::core::option::Option::Some(#result)
        }
    }
}

/// Returns the method for the results of a repeated hinge.
pub fn hinge(cx: &EmitContext, (index, element): (HingeId, usize), count: usize) -> TokenStream {
    let mstmm = &cx.mstmm;
    let Hinge { name, path, .. } = &cx.chain.hinges[index];
    let (visibility, point) = (&cx.passthrough.visibility, point_type(cx));
    let range = &cx.layout.rates[index];
    let ty = cx.numbers_type(range.len());
    let layout = cx.all_rates();
    let of = |field: TokenStream| match range.len() {
        0 => quote!(()),
        _ => {
            let segment = layout.segment_of(range.start);
            let slices = cx.slices(&field, segment);
            let within = range.start - segment.first..range.end - segment.first;
            let names = entries(segment, &within, "x");
            let own: Vec<TokenStream> = (0..range.len()).map(|k| variable("x", k)).collect();
            let value = match &own[..] {
                [one] => quote!(#one),
                _ => quote!(#mstmm::generated::vector([#(#own),*])),
            };
            quote!({
                let &[#(#names),*] = #slices.get(index_)?;
                #value
            })
        }
    };
    let accelerations = cx.rate_accelerations();
    let (acceleration, effort) = (of(quote!(self.#accelerations)), of(quote!(self.efforts)));
    let doc = format!(
        " Returns acceleration, effort, input and output of hinge `{path}` in repetition `index` of {count}."
    );
    let ends = ends(cx, element, count);
    quote! {
        #[doc = #doc]
        #[inline]
        #visibility fn #name(
            &self,
            index_: ::core::primitive::usize,
        ) -> ::core::option::Option<#mstmm::HingeResult<T, #ty, #point>> {
            #ends
            let result_ = #mstmm::HingeResult::new(#acceleration, #effort, input_, output_);
            ::core::option::Option::Some(result_)
        }
    }
}

/// Returns statements that bind `input` and `output` of a repeated element, and the index of its input.
fn ends(cx: &EmitContext, element: usize, count: usize) -> TokenStream {
    let output = cx.point_index(cx.ends(element).output);
    let [first, second, stride] = cx.repeated_input(element);
    let is_affine = first + stride == second;
    let out = match is_affine && first + 1 == output.first {
        true => quote!(first_ + 1),
        false => affine(output.first, output.stride),
    };
    let first = match is_affine {
        true => affine(first, stride),
        false => {
            let [first, second, stride] = [first, second, stride].map(usize_literal);
            quote!(if index_ == 0 { #first } else { #second + (index_ - 1) * #stride })
        }
    };
    let count = usize_literal(count);
    quote! {
        if index_ >= #count {
            return ::core::option::Option::None;
        }
        let first_ = #first;
        let (input_, output_) = (self.point_(first_), self.point_(#out));
    }
}

/// Returns the expression for an index in the repetition `index_`.
fn affine(first: usize, stride: usize) -> TokenStream {
    let [first, stride] = [first, stride].map(usize_literal);
    quote!(#first + index_ * #stride)
}
