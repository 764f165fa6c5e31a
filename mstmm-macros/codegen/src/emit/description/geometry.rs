//! The table of springs with their ends, the axes and the connection points of hinges, and the values of them that
//! parameters change.

use super::super::EmitContext;
use super::super::arrays::usize_literal;
use super::inertia::assignment;
use super::row::{Row, default, described_hinges, indexed};
use crate::model::{
    BodyId, BodyPoint, Element, Hinge, HingeId, HingeKind, Spring, SpringEnd, Value,
};
use crate::program::ArrayLayout;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// Returns the table of springs.
pub fn springs(cx: &EmitContext) -> Vec<Row> {
    let bodies = BodyIndices::of(cx);
    let rows = cx.chain.springs.iter().map(|spring| {
        let repeat = cx.chain.repeat_of_body(spring.on.body);
        let path = indexed(&spring.path, repeat.is_some());
        let on = bodies.end(cx, spring, &spring.on);
        let to = match &spring.to {
            SpringEnd::Ground(at) => {
                let at = vector(cx, at);
                quote!(grounded_(#at))
            }
            SpringEnd::Body(point) => bodies.end(cx, spring, point),
            SpringEnd::Previous { point, first } => bodies.previous(cx, point, first),
        };
        Row { tokens: quote!(spring_(#path, [#on, #to])), repeat: cx.counted(repeat) }
    });
    rows.collect()
}

/// Returns a vector with default parameters.
fn vector(cx: &EmitContext, vector: &[Value; 3]) -> TokenStream {
    let entries = vector.iter().map(|value| default(cx, value));
    quote!([#(#entries),*])
}

fn indices(indices: [usize; 3]) -> TokenStream {
    let indices = indices.map(usize_literal);
    quote!([#(#indices),*])
}

/// The indices of the bodies in their table.
struct BodyIndices {
    bodies: Vec<BodyId>,
    layout: ArrayLayout,
}

impl BodyIndices {
    fn of(cx: &EmitContext) -> Self {
        let bodies: Vec<BodyId> = cx.chain.physical_bodies().collect();
        let rows = bodies.iter().map(|body| (1, cx.counted(cx.chain.repeat_of_body(*body))));
        BodyIndices { layout: ArrayLayout::of(rows), bodies }
    }

    /// Returns the index of a body in the first repetition, the number of bodies from one repetition to the next, and the
    /// index in the last one.
    fn index(&self, body: BodyId) -> (usize, usize, usize) {
        let row = self.bodies.iter().position(|it| *it == body);
        let Some(row) = row else { bug!("a spring ends on a body that is not on a route") };
        let segment = self.layout.segment_of(row);
        let first = segment.offset + row - segment.first;
        (first, segment.count, first + segment.count * (segment.repetitions - 1))
    }

    /// Returns an end of a spring on a body: of the same repetition, or of the last one of another part.
    fn end(&self, cx: &EmitContext, spring: &Spring, point: &BodyPoint) -> TokenStream {
        let at = vector(cx, &point.at);
        let [on, to] = [spring.on.body, point.body].map(|body| cx.chain.repeat_of_body(body));
        let (first, stride, last) = self.index(point.body);
        if to.is_some() && to == on {
            let bodies = indices([first, first + stride, stride]);
            return quote!(fixed_each_(#bodies, [#at, #at]));
        }
        let body = usize_literal(last);
        quote!(fixed_(#body, #at))
    }

    /// Returns an end of a spring on a body of the previous repetition.
    fn previous(&self, cx: &EmitContext, point: &BodyPoint, first: &BodyPoint) -> TokenStream {
        let [at_first, at] = [first, point].map(|point| vector(cx, &point.at));
        let ((.., before), (second, stride, _)) = (self.index(first.body), self.index(point.body));
        let bodies = indices([before, second, stride]);
        quote!(fixed_each_(#bodies, [#at_first, #at]))
    }
}

/// Returns the calls that set the connection points and the axes of a hinge. The hinge of a moving end has neither: it is
/// not between two points of the chain.
pub fn of_hinge(cx: &EmitContext, id: HingeId) -> Option<TokenStream> {
    let element = element(cx, id)?;
    let output = cx.point_index(cx.ends(element).output);
    let between = match cx.chain.repeat_of_hinge(id) {
        None => {
            let input = cx.point_index(cx.ends(element).input);
            let [input, output] = [input.last, output.last].map(usize_literal);
            quote!(.between(#input, #output))
        }
        Some(_) => {
            let input = indices(cx.repeated_input(element));
            let output = indices([output.first, output.first + output.stride, output.stride]);
            quote!(.between_each(#input, #output))
        }
    };
    let axes = axes(&cx.chain.hinges[id]);
    let about = (!axes.is_empty()).then(|| {
        let axes = axes.iter().map(|axis| vector(cx, axis));
        quote!(.about(&[#(#axes),*]))
    });
    Some(quote!(#between #about))
}

/// Returns the number of a hinge among the elements.
fn element(cx: &EmitContext, id: HingeId) -> Option<usize> {
    cx.chain.elements.iter().position(|it| *it == Element::Hinge(id))
}

/// Returns the axes of a hinge that are fixed on one of its sides, with the normal of a planar one.
fn axes(hinge: &Hinge) -> Vec<[Value; 3]> {
    match &hinge.kind {
        HingeKind::Planar { normal } => {
            vec![[0, 1, 2].map(|axis| Value::number(if axis == *normal { 1.0 } else { 0.0 }))]
        }
        kind => match kind.axes() {
            [first, .., last] => vec![first.clone(), last.clone()],
            axes => axes.to_vec(),
        },
    }
}

/// Returns the methods that set the components of ends and axes which are not constants, if there are any.
pub fn changes(cx: &EmitContext) -> TokenStream {
    let ends = cx.chain.springs.iter().map(|spring| changes_of_spring(cx, spring));
    let axes = described_hinges(cx).map(|(id, hinge)| match element(cx, id) {
        Some(_) => changes_of_vectors(cx, axes(hinge).iter()),
        None => TokenStream::new(),
    });
    [method(cx, "change_ends_", ends.collect()), method(cx, "change_axes_", axes.collect())]
        .into_iter()
        .collect()
}

/// Returns a method that changes the vectors of a row, if any changes.
fn method(cx: &EmitContext, name: &str, rows: Vec<TokenStream>) -> TokenStream {
    let rows = rows.into_iter().enumerate().filter(|(_, changes)| !changes.is_empty());
    let arms: Vec<TokenStream> = rows
        .map(|(row, changes)| {
            let row = usize_literal(row);
            quote!(#row => { #changes })
        })
        .collect();
    if arms.is_empty() {
        return TokenStream::new();
    }
    let (mstmm, name) = (&cx.mstmm, format_ident!("{name}"));
    quote! {
        fn #name(&self, it_: &mut #mstmm::generated::description::Vectors_<T>) {
            let parameters_ = self.parameters();
            match it_.row {
                #(#arms)*
                _ => {}
            }
        }
    }
}

fn changes_of_spring(cx: &EmitContext, spring: &Spring) -> TokenStream {
    let on = &spring.on.at;
    match &spring.to {
        SpringEnd::Ground(at) | SpringEnd::Body(BodyPoint { at, .. }) => {
            changes_of_vectors(cx, [on, at].into_iter())
        }
        SpringEnd::Previous { point, first } => {
            let changes = changes_of_vectors(cx, [on].into_iter());
            let [first, later] = [first, point].map(|end| changes_of_vector(cx, 1, &end.at));
            if first.is_empty() && later.is_empty() {
                return changes;
            }
            // The parameters of the previous repetition count for its point.
            let previous = quote!(it_.index = it_.index.saturating_sub(1););
            quote!(#changes if it_.index == 0 { #first } else { #previous #later })
        }
    }
}

fn changes_of_vectors<'a>(
    cx: &EmitContext,
    vectors: impl Iterator<Item = &'a [Value; 3]>,
) -> TokenStream {
    vectors.enumerate().map(|(number, vector)| changes_of_vector(cx, number, vector)).collect()
}

fn changes_of_vector(cx: &EmitContext, number: usize, vector: &[Value; 3]) -> TokenStream {
    let number = usize_literal(number);
    let entry = |(entry, value): (usize, &Value)| {
        let entry: Literal = usize_literal(entry);
        assignment(cx, &quote!(it_.vectors[#number][#entry]), value)
    };
    vector.iter().enumerate().map(entry).collect()
}
