//! Reads connection points from a workspace.

use super::EmitContext;
use super::arrays::usize_literal;
use crate::compile::{StoredFramedVector, StoredPoint, StoredVector};
use crate::ids::PointId;
use crate::model::{Dimension, ElementPoints, Results};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// Returns the type of a connection point; its parameter lists the computed results unless all are computed.
pub fn point_type(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    let name = match cx.chain.dimension {
        Dimension::Space => "Point",
        Dimension::Plane => "PlanePoint",
        Dimension::Line => "LinePoint",
    };
    let name = format_ident!("{name}");
    match cx.chain.results {
        Results { poses: true, velocities: true, z: true, .. } => quote!(#mstmm::#name<T>),
        Results { poses, velocities, z, .. } => {
            quote!(#mstmm::#name<T, #mstmm::Results<#poses, #velocities, #z>>)
        }
    }
}

/// Returns the table of the points' storage, and the methods that read a point and a vector.
pub fn emit(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    let point = point_type(cx);
    let dimension = cx.chain.dimension;
    let vectors = if dimension == Dimension::Line { 3 } else { 6 };
    let [axes, vectors] = [dimension.columns(), vectors].map(usize_literal);
    let points = &cx.compiled.point_storage.points;
    let count = usize_literal(points.len());
    let entries = points.iter().map(|point| entry(cx, point));
    let located = located(cx);
    // Inlined with a constant index, only the reads of the used vectors remain.
    let inline = if cx.chain.repeats.is_empty() { quote!(inline(always)) } else { quote!(inline) };
    let vector = vector(cx, &inline);
    quote! {
        /// Where every point of the model has its numbers.
        const PLACES_: [#mstmm::generated::PointSlots<#axes, #vectors>; #count] = [#(#entries),*];

        /// Connection point number `index`.
        #[#inline]
        fn point_(&self, index_: ::core::primitive::usize) -> #point {
            #located
            <#point>::read(numbers_, Self::PLACES_.as_slice().get(model_), self.base_acceleration)
        }

        #vector
    }
}

/// Returns the method that reads a vector of a body, if parameters change any.
fn vector(cx: &EmitContext, inline: &TokenStream) -> Option<TokenStream> {
    let mstmm = &cx.mstmm;
    let mut frames = cx.compiled.point_storage.points.iter().flat_map(|point| &point.own);
    frames.any(|frame| frame.position.is_some() || frame.axes.is_some()).then(|| {
        let translations = usize_literal(cx.chain.dimension.translations().len());
        let located = located(cx);
        quote! {
            /// The vector at an offset among the numbers of connection point number `index`.
            #[#inline]
            #[allow(unused_variables)]
            fn vector_(
                &self,
                index_: ::core::primitive::usize,
                place_: ::core::primitive::u32,
            ) -> [T; #translations] {
                #located
                #mstmm::generated::vector_at(numbers_, place_)
            }
        }
    })
}

/// The index of a connection point among all points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointIndex {
    /// Its index, in a repeated part that in the first repetition.
    pub first: usize,
    /// The number of points from one repetition to the next; zero outside of repeated parts.
    pub stride: usize,
    /// Its index in the last repetition.
    pub last: usize,
}

impl EmitContext<'_> {
    /// Returns the points of an element.
    pub fn ends(&self, element: usize) -> ElementPoints {
        self.compiled.point_storage.of.elements[element]
    }

    /// Returns the index of a point.
    pub fn point_index(&self, point: PointId) -> PointIndex {
        let layout = self.points();
        let segment = layout.segment_of(point.index());
        let first = segment.offset + point.index() - segment.first;
        let stride = if segment.repeat.is_some() { segment.count } else { 0 };
        PointIndex { first, stride, last: first + stride * (segment.repetitions - 1) }
    }

    /// Returns the index of the input of a repeated element in the first and in the second repetition, and the difference
    /// from each later one to the next.
    pub fn repeated_input(&self, element: usize) -> [usize; 3] {
        let ElementPoints { input, previous, .. } = self.ends(element);
        let input = self.point_index(input);
        match previous.map(|point| self.point_index(point)) {
            None => [input.first, input.first + input.stride, input.stride],
            Some(previous) => [input.last, previous.first, previous.stride],
        }
    }
}

/// Returns the expression for all points.
pub fn all(cx: &EmitContext) -> TokenStream {
    if !cx.chain.repeats.is_empty() {
        return quote!(::core::array::from_fn(|index_| self.point_(index_)));
    }
    let points = (0..cx.compiled.point_storage.points.len()).map(usize_literal);
    quote!([#(self.point_(#points)),*])
}

/// Returns a statement that binds the index of a point in the model and the stored values of its segment and repetition.
fn located(cx: &EmitContext) -> TokenStream {
    if cx.chain.repeats.is_empty() {
        return quote!(let (model_, numbers_) = (index_, &self.numbers[..]););
    }
    let mstmm = &cx.mstmm;
    let points = cx.points();
    let mut offset = 0;
    // Segments without values count as well: points of the ground may have none.
    let segments =
        points.segments.iter().zip(&cx.compiled.point_storage.segments).map(|(points, segment)| {
            let (count, first) = (segment.0, offset);
            offset += count * points.repetitions;
            let entries = [
                points.first,
                points.count,
                points.offset,
                points.count * points.repetitions,
                first,
                count,
            ];
            let entries = entries.map(usize_literal);
            quote!([#(#entries),*])
        });
    quote! {
        let (model_, numbers_) = #mstmm::generated::locate_point(&self.numbers, &[#(#segments),*], index_);
    }
}

fn entry(cx: &EmitContext, point: &StoredPoint) -> TokenStream {
    let mstmm = &cx.mstmm;
    let position = literal(&point.position);
    let count = cx.chain.dimension.columns();
    let axes = |axes: &Option<Vec<StoredVector>>| {
        let columns = match axes {
            Some(columns) => columns.iter().map(literal).collect(),
            None => vec![usize_literal(0); count],
        };
        quote!([#(#columns),*])
    };
    let orientation = axes(&point.orientation);
    let vectors = point.vectors.iter().map(|framed: &StoredFramedVector| {
        let (axes, vector) = (axes(&framed.axes), literal(&framed.vector));
        quote!((#axes, #vector))
    });
    quote!(#mstmm::generated::PointSlots::new(#position, #orientation, [#(#vectors),*]))
}

/// Returns a stored vector in the encoding of the runtime.
pub fn literal(vector: &StoredVector) -> Literal {
    usize_literal(vector.first)
}
