//! The results at bodies, and their types.

use super::EmitContext;
use super::const_expr::value_tokens;
use super::point_access::{self, point_type};
use crate::compile::StoredVector;
use crate::ids::PointId;
use crate::model::{
    Body, BodyId, Chain, ConnectionPoints, Frame, NamedPoint, PresentPoints, Value, listed,
};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, format_ident, quote};
use std::collections::{HashMap, HashSet};

/// Returns the types of results at bodies with named points.
pub fn types(cx: &EmitContext) -> TokenStream {
    let mut seen = HashSet::new();
    let bodies = cx.chain.bodies.enumerate().filter(|(_, body)| !body.points.is_empty());
    let first = bodies.filter(|(_, body)| seen.insert(body.result_name.to_string()));
    first.map(|(_, body)| of_type(cx, body)).collect()
}

/// How the results at bodies report named points, by the name of the type of these results.
pub struct BodyReports(HashMap<String, Vec<Reported>>);

/// How the results at bodies of one type report a named point.
enum Reported {
    /// All report its motion.
    Motion,
    /// Hinges leave it at all bodies, which report a connection point.
    Joined,
    /// Hinges leave it at some bodies: the type of the report is a parameter with this name.
    Either(Ident),
}

impl BodyReports {
    /// Returns how the bodies of a chain report their named points.
    pub fn of(chain: &Chain, points: &ConnectionPoints) -> Self {
        let mut bodies_of_types: HashMap<String, Vec<BodyId>> = HashMap::new();
        for (id, body) in chain.bodies.enumerate().filter(|(_, body)| !body.points.is_empty()) {
            bodies_of_types.entry(body.result_name.to_string()).or_default().push(id);
        }
        let reported = |bodies: &[BodyId]| {
            let point = |index: usize| {
                let is_joined = |&&body: &&BodyId| points.joined.contains_key(&(body, index));
                match bodies.iter().filter(is_joined).count() {
                    0 => Reported::Motion,
                    all if all == bodies.len() => Reported::Joined,
                    _ => Reported::Either(format_ident!("P{index}", span = Span::call_site())),
                }
            };
            bodies
                .first()
                .map_or(0..0, |&first| 0..chain.bodies[first].points.len())
                .map(point)
                .collect()
        };
        let types = bodies_of_types.into_iter();
        BodyReports(types.map(|(name, bodies)| (name, reported(&bodies))).collect())
    }
}

impl Reported {
    /// Returns the type of the report.
    fn type_of(&self, cx: &EmitContext) -> TokenStream {
        let (mstmm, point) = (&cx.mstmm, point_type(cx));
        match self {
            Reported::Motion => quote!(#mstmm::BodyPoint<#point>),
            Reported::Joined => point,
            Reported::Either(parameter) => quote!(#parameter),
        }
    }

    /// Returns what the docs call the report.
    fn description(&self) -> &'static str {
        match self {
            Reported::Motion => "motion of",
            Reported::Joined => "state at",
            Reported::Either(_) => "state at, or the motion of,",
        }
    }

    /// Returns the parameter with the type of the report, if the type depends on the body.
    fn parameter(&self) -> Option<&Ident> {
        match self {
            Reported::Either(parameter) => Some(parameter),
            Reported::Motion | Reported::Joined => None,
        }
    }
}

/// Returns how the named points of a body, which has some, are reported.
fn reported<'a>(cx: &'a EmitContext, body: &Body) -> &'a [Reported] {
    let found = cx.body_reports.0.get(&body.result_name.to_string());
    found.unwrap_or_else(|| bug!("body `{}` has no named points", body.path))
}

/// Returns the connection point at a named point, if hinges leave it.
fn joined(cx: &EmitContext, body: BodyId, point: usize) -> Option<PointId> {
    cx.compiled.point_storage.of.joined.get(&(body, point)).copied()
}

/// Returns the type of results at bodies of one type.
fn of_type(cx: &EmitContext, body: &Body) -> TokenStream {
    let mstmm = &cx.mstmm;
    let (name, visibility) = (own_name(cx, body), &cx.passthrough.visibility);
    let common = common(cx, body);
    let doc = format!(
        " Results at a body `{}` of [`{}`]: its ends, its centre of mass and its named points.",
        body.type_name, cx.chain.name
    );
    let reports = reported(cx, body);
    let parameters: Vec<&Ident> = reports.iter().filter_map(Reported::parameter).collect();
    let points = body.points.iter().zip(reports);
    let fields = points.clone().map(|(named, reported)| {
        let (field, ty) = (field(&named.name), reported.type_of(cx));
        quote!(#field: #ty,)
    });
    let methods = points.map(|(NamedPoint { name, .. }, reported)| {
        let (field, ty) = (field(name), reported.type_of(cx));
        let doc = format!(" Returns the {} the point `{name}`.", reported.description());
        quote! {
            #[doc = #doc]
            #[inline]
            #visibility fn #name(&self) -> #ty {
                self.#field
            }
        }
    });
    quote! {
        #[doc = #doc]
        #[derive(Clone, Copy, Debug)]
        #[allow(dead_code, non_snake_case, non_camel_case_types)]
        #visibility struct #name<T #(, #parameters)*> {
            common_: #common,
            #(#fields)*
        }
        #[allow(dead_code, non_snake_case, clippy::misnamed_getters)]
        impl<T: #mstmm::Scalar #(, #parameters: ::core::marker::Copy)*> #name<T #(, #parameters)*> {
            #(#methods)*
        }
        impl<T: #mstmm::Scalar #(, #parameters)*> ::core::ops::Deref for #name<T #(, #parameters)*> {
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
    format_ident!("{}{}Result", cx.chain.name, body.result_name, span = Span::call_site())
}

/// Returns the field for a named point.
pub fn field(point: &Ident) -> Ident {
    format_ident!("place_of_{point}", span = Span::call_site())
}

/// Returns the type of results at a body.
pub fn type_of(cx: &EmitContext, index: BodyId) -> TokenStream {
    let body = &cx.chain.bodies[index];
    if body.points.is_empty() {
        return common(cx, body);
    }
    let (mstmm, point) = (&cx.mstmm, point_type(cx));
    let types = reported(cx, body).iter().enumerate();
    let types = types.filter_map(|(number, reported)| match reported {
        Reported::Motion | Reported::Joined => None,
        Reported::Either(_) => Some(match joined(cx, index, number) {
            Some(_) => point.clone(),
            None => quote!(#mstmm::BodyPoint<#point>),
        }),
    });
    let name = own_name(cx, body);
    quote!(#name<T #(, #types)*>)
}

/// Returns the expression for the results at a body whose connection points are bound to `input_` and `output_`; `first` is
/// the index of its input among all points, and `at` returns the index of another point.
pub fn result(
    cx: &EmitContext,
    (index, element): (BodyId, usize),
    first: &impl ToTokens,
    at: impl Fn(PointId) -> TokenStream,
) -> TokenStream {
    let mstmm = &cx.mstmm;
    let body = &cx.chain.bodies[index];
    let stored = &cx.compiled.point_storage.points[cx.ends(element).input].own;
    let read = |vector: &StoredVector| {
        let vector = point_access::literal(vector);
        quote!(self.vector_(#first, #vector))
    };
    let mut frames = body.own_frames().zip(stored).map(|((place, rotation), stored)| {
        let place = stored.position.as_ref().map_or_else(|| fixed(cx, place), read);
        let axes: Option<Vec<TokenStream>> = match &stored.axes {
            Some(axes) => Some(axes.iter().map(read).collect()),
            None => rotation.and_then(|rotation| fixed_axes(cx, rotation)),
        };
        (place, axes.map(|axes| quote!(.turned([#(#axes),*]))))
    });
    let com = frames.next().map(|(place, _)| place);
    let common = quote!(#mstmm::BodyResult::new(input_, output_, #com));
    if body.points.is_empty() {
        return common;
    }
    let reports = reported(cx, body);
    let points = body.points.iter().zip(reports).enumerate().zip(frames);
    let fields = points.map(|((number, (named, reported)), (place, axes))| {
        let value = match (reported, joined(cx, index, number)) {
            (Reported::Motion | Reported::Either(_), None) => {
                quote!(#mstmm::BodyPoint::new(input_, #place) #axes)
            }
            (Reported::Joined | Reported::Either(_), Some(point)) => {
                let at = at(point);
                quote!(self.point_(#at))
            }
            (Reported::Motion, Some(_)) | (Reported::Joined, None) => {
                bug!("the bodies of a type report a point differently")
            }
        };
        let field = field(&named.name);
        quote!(#field: #value,)
    });
    let name = own_name(cx, body);
    quote!(#name { common_: #common, #(#fields)* })
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

/// Returns the columns of a rotation that no parameter changes; none for the axes of the body.
fn fixed_axes(cx: &EmitContext, rotation: &[[Value; 3]; 3]) -> Option<Vec<TokenStream>> {
    let is_identity = *rotation == Frame::identity().rotation;
    if is_identity || rotation.iter().flatten().any(Value::changes) {
        return None;
    }
    let column = |k: usize| fixed(cx, &[0, 1, 2].map(|i: usize| rotation[i][k].clone()));
    Some((0..cx.chain.dimension.columns()).map(column).collect())
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
