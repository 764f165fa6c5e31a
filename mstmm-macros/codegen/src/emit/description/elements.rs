//! The tables of hinges and connection points, and the list of answers.

use super::super::EmitContext;
use super::geometry;
use super::row::{Row, default, described_hinges, indexed};
use crate::ids::{HingeId, PointId, RepeatId};
use crate::model::{
    ANSWER_WORDS, Attachment, Body, BodyId, DofGroup, Element, Hinge, Representation, Value,
};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// Returns the kinds of hinges that occur, and the table of hinges.
pub fn hinges(cx: &EmitContext) -> (TokenStream, Vec<Row>) {
    let mut kinds: Vec<&'static str> = Vec::new();
    let (mut items, mut rows) = (TokenStream::new(), Vec::new());
    for (id, hinge) in described_hinges(cx) {
        let spec = hinge.kind.spec();
        if !kinds.contains(&spec.word) {
            kinds.push(spec.word);
            let (name, word) = (kind(hinge), spec.word);
            let dofs = spec.groups.iter().map(dofs);
            items.extend(quote! {
                const #name: Shape_ = shape_(#word, &[#(#dofs),*]);
            });
        }
        rows.push(row(cx, id, hinge));
    }
    (items, rows)
}

/// Returns the constant of a kind.
fn kind(hinge: &Hinge) -> Ident {
    format_ident!("{}_", hinge.kind.spec().word.to_uppercase())
}

fn dofs(group: &DofGroup) -> TokenStream {
    let [coordinates, rates] = group.names;
    match group.representation {
        Representation::Quaternion => quote!(orienting_(#coordinates, #rates)),
        Representation::Numbers | Representation::Angles => {
            let components = components(group.rates.len());
            let make = if group.rotational { quote!(turning_) } else { quote!(moving_) };
            quote!(#make(#coordinates, #rates, #components))
        }
    }
}

/// Returns the names of the components of a vector; a scalar has none.
pub fn components(count: usize) -> &'static str {
    match count {
        2 => "xy",
        3 => "xyz",
        _ => "",
    }
}

fn row(cx: &EmitContext, id: HingeId, hinge: &Hinge) -> Row {
    let repeat = cx.chain.repeat_of_hinge(id);
    let (kind, path) = (kind(hinge), indexed(&hinge.path, repeat.is_some()));
    let prescribed = hinge.is_prescribed().then(|| quote!(.prescribed()));
    let starts =
        hinge.start != hinge.kind.zero_position() || !hinge.start_rate.iter().all(Value::is_zero);
    let start = (starts && !hinge.is_prescribed()).then(|| {
        let start = hinge.start.iter().map(|value| default(cx, value));
        let rates = hinge.start_rate.iter().map(|value| default(cx, value));
        quote!(.starting(&[#(#start),*], &[#(#rates),*]))
    });
    let limits = limits(cx, hinge);
    let geometry = geometry::of_hinge(cx, id);
    let tokens = quote!(#kind.named(#path) #prescribed #start #limits #geometry);
    Row { tokens, repeat: cx.counted(repeat) }
}

/// Returns the limits of the groups of a hinge, if it has any.
fn limits(cx: &EmitContext, hinge: &Hinge) -> Option<TokenStream> {
    let groups = hinge.kind.spec().groups.iter();
    let limits: Vec<_> = groups
        .map(|group| {
            let limits = hinge.passive.get(group.rates.start)?.limits.as_ref()?;
            let low = match group.representation {
                Representation::Quaternion => quote!(0.0),
                Representation::Numbers | Representation::Angles => default(cx, &limits.low),
            };
            let high = default(cx, &limits.high);
            Some(quote!([#low, #high]))
        })
        .collect();
    limits.iter().any(Option::is_some).then(|| {
        let limits =
            limits.into_iter().map(|limits| limits.unwrap_or_else(|| quote!([NAN_, NAN_])));
        quote!(.limited(&[#(#limits),*]))
    })
}

/// Returns the table of connection points.
pub fn points(cx: &EmitContext) -> Vec<Row> {
    let row = |(name, repeat)| Row { tokens: quote!(#name), repeat };
    point_names(cx).into_iter().map(row).collect()
}

/// Returns the names of connection points, each with the repeated part that it belongs to and the number of repetitions.
pub fn point_names(cx: &EmitContext) -> Vec<(String, Option<(RepeatId, usize)>)> {
    let points = &cx.compiled.point_storage.of;
    let rows = points.points.enumerate().map(|(id, point)| {
        let is_repeated = point.repeat.is_some();
        let name = match &point.attachment {
            Attachment::Ground(_) => None,
            Attachment::Input(body) => body_point(cx, (id, *body), is_repeated, "input"),
            Attachment::Output(body) => body_point(cx, (id, *body), is_repeated, "output"),
            Attachment::Point(body, index) => {
                let name = cx.chain.bodies[*body].points[*index].name.to_string();
                body_point(cx, (id, *body), is_repeated, &name)
            }
        };
        let name = name.unwrap_or_else(|| hinge_point(cx, id, is_repeated));
        (name, cx.counted(point.repeat))
    });
    rows.collect()
}

/// Returns the name of a point as a point of a body, if the results of the body have it.
fn body_point(
    cx: &EmitContext,
    (point, id): (PointId, BodyId),
    is_repeated: bool,
    place: &str,
) -> Option<String> {
    let element = Element::Body(id);
    let number = cx.chain.elements.iter().position(|it| *it == element)?;
    let points = &cx.compiled.point_storage.of;
    let ends = points.elements[number];
    let joined = points.joined.iter().any(|((body, _), at)| *body == id && *at == point);
    let Body { path, .. } = &cx.chain.bodies[id];
    (ends.input == point || ends.output == point || joined)
        .then(|| format!("{}.{place}", indexed(path, is_repeated)))
}

/// Returns the name of a point as an end of a hinge.
fn hinge_point(cx: &EmitContext, point: PointId, is_repeated: bool) -> String {
    let ends = cx.compiled.point_storage.of.elements.iter();
    let found = cx.chain.elements.iter().zip(ends).find_map(|(element, ends)| {
        let Element::Hinge(id) = *element else { return None };
        let end = if ends.input == point { "input" } else { "output" };
        (ends.input == point || ends.output == point).then_some((id, end))
    });
    let (id, end) = found.unwrap_or_else(|| bug!("a connection point belongs to no element"));
    // The first repetition of a repeated hinge may leave a point outside of its part.
    let index = match (is_repeated, cx.chain.repeat_of_hinge(id)) {
        (true, _) => "[]",
        (false, Some(_)) => "[0]",
        (false, None) => "",
    };
    format!("{}{index}.{end}", cx.chain.hinges[id].path)
}

/// Returns the call that lists the answers, if there are any.
pub fn answers(cx: &EmitContext) -> Option<TokenStream> {
    let requests = &cx.chain.requests;
    let is_asked = |(_, of): &&(&str, &[_])| of.iter().all(|request| requests.contains(request));
    let words: Vec<&str> = ANSWER_WORDS.iter().filter(is_asked).map(|(word, _)| *word).collect();
    (!words.is_empty()).then(|| quote!(.answering(&[#(#words),*])))
}
