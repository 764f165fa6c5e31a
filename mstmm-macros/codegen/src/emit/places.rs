//! How connection points are read off a workspace.

use super::Plan;
use super::arrays::usize_literal;
use crate::compile::{Place, PointPlaces, Sight};
use crate::model::{Dimension, Results};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// The type of a connection point, with what is computed of it unless that is everything.
pub fn point_type(plan: &Plan) -> TokenStream {
    let mstmm = &plan.mstmm;
    let name = match plan.chain.dimension {
        Dimension::Space => "Point",
        Dimension::Plane => "PlanePoint",
        Dimension::Line => "LinePoint",
    };
    let name = format_ident!("{name}");
    match plan.chain.results {
        Results { poses: true, velocities: true, z: true, .. } => quote!(#mstmm::#name<T>),
        Results { poses, velocities, z, .. } => {
            quote!(#mstmm::#name<T, #mstmm::Results<#poses, #velocities, #z>>)
        }
    }
}

/// The table of places, and the methods that read a point and a vector.
pub fn emit(plan: &Plan) -> TokenStream {
    let mstmm = &plan.mstmm;
    let point = point_type(plan);
    let dimension = plan.chain.dimension;
    let vectors = if dimension == Dimension::Line { 3 } else { 6 };
    let [axes, vectors] = [dimension.columns(), vectors].map(usize_literal);
    let points = &plan.compiled.places.points;
    let count = usize_literal(points.len());
    let entries = points.iter().map(|places| entry(plan, places));
    let found = found(plan);
    // Where a place is known while compiling, what is read of its point is all that is left.
    let inline =
        if plan.chain.repeats.is_empty() { quote!(inline(always)) } else { quote!(inline) };
    let vector = vector(plan, &inline);
    quote! {
        /// Where every point of the model has its numbers.
        const PLACES_: [#mstmm::generated::Places<#axes, #vectors>; #count] = [#(#entries),*];

        /// Connection point number `index`.
        #[#inline]
        fn point_(&self, index_: ::core::primitive::usize) -> #point {
            #found
            <#point>::read(numbers_, Self::PLACES_.get(model_), self.at_rest)
        }

        #vector
    }
}

/// The method that reads a vector of a body, where parameters change some.
fn vector(plan: &Plan, inline: &TokenStream) -> Option<TokenStream> {
    let mstmm = &plan.mstmm;
    let mut changing = plan.compiled.places.points.iter().flat_map(|places| &places.changing);
    changing.any(Option::is_some).then(|| {
        let shifts = usize_literal(plan.chain.dimension.shifts().len());
        let found = found(plan);
        quote! {
            /// The vector at a place among the numbers of connection point number `index`.
            #[#inline]
            #[allow(unused_variables)]
            fn vector_(
                &self,
                index_: ::core::primitive::usize,
                place_: ::core::primitive::u32,
            ) -> [T; #shifts] {
                #found
                #mstmm::generated::entries(numbers_, place_)
            }
        }
    })
}

/// All points.
pub fn all(plan: &Plan) -> TokenStream {
    if !plan.chain.repeats.is_empty() {
        return quote!(::core::array::from_fn(|index_| self.point_(index_)));
    }
    let points = (0..plan.compiled.places.points.len()).map(usize_literal);
    quote!([#(self.point_(#points)),*])
}

/// Binds the number of a point in the model and the numbers of its piece, at its time.
fn found(plan: &Plan) -> TokenStream {
    if plan.chain.repeats.is_empty() {
        return quote!(let (model_, numbers_) = (index_, &self.numbers[..]););
    }
    let mstmm = &plan.mstmm;
    let points = plan.points();
    let mut place = 0;
    // Also pieces without numbers count: points of the ground may have none.
    let pieces = points.segments.iter().zip(&plan.compiled.places.pieces).map(|(points, piece)| {
        let (count, first) = (piece.0, place);
        place += count * points.repetitions;
        let entries = [
            points.first,
            points.count,
            points.place,
            points.count * points.repetitions,
            first,
            count,
        ];
        let entries = entries.map(usize_literal);
        quote!([#(#entries),*])
    });
    quote! {
        let (model_, numbers_) = #mstmm::generated::place_of(&self.numbers, &[#(#pieces),*], index_);
    }
}

fn entry(plan: &Plan, places: &PointPlaces) -> TokenStream {
    let mstmm = &plan.mstmm;
    let position = literal(&places.position);
    let count = plan.chain.dimension.columns();
    let axes = |axes: &Option<Vec<Place>>| {
        let columns = match axes {
            Some(columns) => columns.iter().map(literal).collect(),
            None => vec![usize_literal(0); count],
        };
        quote!([#(#columns),*])
    };
    let orientation = axes(&places.orientation);
    let vectors = places.vectors.iter().map(|sight: &Sight| {
        let (axes, vector) = (axes(&sight.axes), literal(&sight.vector));
        quote!((#axes, #vector))
    });
    quote!(#mstmm::generated::Places::new(#position, #orientation, [#(#vectors),*]))
}

/// A place as the runtime has it.
pub fn literal(place: &Place) -> Literal {
    usize_literal(place.first)
}
