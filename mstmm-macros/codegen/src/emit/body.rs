//! The results at bodies, and their types.

use super::EmitContext;
use super::arrays::usize_literal;
use super::const_expr::value_tokens;
use super::point_access::{self, point_type};
use crate::model::{Body, BodyId, NamedPoint, PresentPoints, Value, listed};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, format_ident, quote};
use std::collections::HashSet;

/// Returns the types of results at bodies with named points.
pub fn types(cx: &EmitContext) -> TokenStream {
    let mut seen = HashSet::new();
    let bodies = cx.chain.bodies.iter().filter(|body| !body.points.is_empty());
    bodies.filter(|body| seen.insert(body.type_name.to_string())).map(|b| of_type(cx, b)).collect()
}

/// Returns the type of results at bodies of one type.
fn of_type(cx: &EmitContext, body: &Body) -> TokenStream {
    let mstmm = &cx.mstmm;
    let (name, visibility) = (own_name(cx, body), &cx.passthrough.visibility);
    let (common, point) = (common(cx, body), point_type(cx));
    let doc = format!(
        " Results at a body `{}` of [`{}`]: its ends, its centre of mass and its named points.",
        body.type_name, cx.chain.name
    );
    let translations = usize_literal(cx.chain.dimension.translations().len());
    let (names, fields): (Vec<_>, Vec<_>) =
        body.points.iter().map(|NamedPoint { name, .. }| (name, field(name))).unzip();
    let docs = names.iter().map(|name| format!(" Returns the motion of the point `{name}`."));
    quote! {
        #[doc = #doc]
        #[derive(Clone, Copy, Debug)]
        #[allow(dead_code, non_snake_case, non_camel_case_types)]
        #visibility struct #name<T> {
            common_: #common,
            #(#fields: [T; #translations],)*
        }
        #[allow(dead_code, non_snake_case)]
        impl<T: #mstmm::Scalar> #name<T> {
            #(
                #[doc = #docs]
                #[inline]
                #visibility fn #names(&self) -> #mstmm::BodyPoint<#point> {
                    #mstmm::BodyPoint::new(self.common_.input(), self.#fields)
                }
            )*
        }
        impl<T: #mstmm::Scalar> ::core::ops::Deref for #name<T> {
            type Target = #common;
            #[inline]
            fn deref(&self) -> &#common {
                &self.common_
            }
        }
    }
}

/// Returns the runtime's type of results at a body.
fn common(cx: &EmitContext, body: &Body) -> TokenStream {
    let (mstmm, point) = (&cx.mstmm, point_type(cx));
    match body.present {
        PresentPoints::ALL => quote!(#mstmm::BodyResult<T, #point>),
        PresentPoints { output, com } => {
            quote!(#mstmm::BodyResult<T, #point, #mstmm::OptionalPoints<#output, #com>>)
        }
    }
}

fn own_name(cx: &EmitContext, body: &Body) -> Ident {
    format_ident!("{}{}Result", cx.chain.name, body.type_name, span = Span::call_site())
}

/// Returns the field for a named point.
fn field(point: &Ident) -> Ident {
    format_ident!("place_of_{point}", span = Span::call_site())
}

/// Returns the type of results at a body.
pub fn type_of(cx: &EmitContext, body: &Body) -> TokenStream {
    if body.points.is_empty() {
        return common(cx, body);
    }
    let name = own_name(cx, body);
    quote!(#name<T>)
}

/// Returns the expression for the results at a body whose connection points are bound to `input_` and `output_`; `first` is
/// the index of its input among all points.
pub fn result(
    cx: &EmitContext,
    (body, route_index): (BodyId, usize),
    first: &impl ToTokens,
) -> TokenStream {
    let mstmm = &cx.mstmm;
    let body = &cx.chain.bodies[body];
    let changing = &cx.compiled.point_storage.points[route_index].changing;
    let mut vectors = body.own_points().zip(changing).map(|(position, stored)| match stored {
        Some(stored) => {
            let stored = point_access::literal(stored);
            quote!(self.vector_(#first, #stored))
        }
        None => fixed(cx, position),
    });
    let com = vectors.next();
    let common = quote!(#mstmm::BodyResult::new(input_, output_, #com));
    if body.points.is_empty() {
        return common;
    }
    let (name, fields) = (own_name(cx, body), body.points.iter().map(|point| field(&point.name)));
    quote!(#name { common_: #common, #(#fields: #vectors,)* })
}

/// Returns a vector whose entries no parameter changes; an entry that a parameter changes is never read and is zero.
fn fixed(cx: &EmitContext, position: &[Value; 3]) -> TokenStream {
    let entries = cx.chain.dimension.translations().iter().map(|&axis| match &position[axis] {
        value if value.changes() => quote!(T::constant(0.0)),
        value => {
            let value = value_tokens(cx, value);
            quote!(T::constant(#value))
        }
    });
    quote!([#(#entries),*])
}

/// Lists the points whose results a body has.
pub fn contents(body: &Body) -> String {
    let names = body.points.iter().map(|point| format!("`{}`", point.name));
    let ends = [("output", body.present.output), ("centre of mass", body.present.com)];
    let ends =
        ends.iter().filter(|(_, is_present)| *is_present).map(|(text, _)| (*text).to_owned());
    let all: Vec<String> = std::iter::once("input".to_owned()).chain(ends).chain(names).collect();
    let all: Vec<&str> = all.iter().map(String::as_str).collect();
    listed(&all)
}
