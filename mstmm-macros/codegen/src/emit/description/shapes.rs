//! The shapes of bodies.

use super::row::literal;
use crate::model::{Body, Geometry, Shape};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use std::collections::BTreeMap;

/// The lists of shapes that occur. Bodies with the same shapes share a list.
#[derive(Default)]
pub struct ShapeLists {
    numbers: BTreeMap<String, usize>,
    /// The constants of the lists.
    pub items: TokenStream,
}

impl ShapeLists {
    /// Returns the call that sets the shapes of a body, if it has any.
    pub fn of(&mut self, body: &Body) -> Option<TokenStream> {
        if body.shapes.is_empty() {
            return None;
        }
        let shapes = body.shapes.iter().map(shape);
        let list = quote!(&[#(#shapes),*]);
        let next = self.numbers.len();
        let number = *self.numbers.entry(list.to_string()).or_insert(next);
        let name = format_ident!("SHAPES{number}_");
        if number == next {
            self.items.extend(quote!(const #name: Visuals_ = #list;));
        }
        Some(quote!(.shaped(#name)))
    }
}

fn shape(shape: &Shape) -> TokenStream {
    let geometry = match &shape.geometry {
        Geometry::Box(edges) => {
            let edges = edges.map(literal);
            quote!(box_([#(#edges),*]))
        }
        Geometry::Cylinder(lengths) => {
            let lengths = lengths.map(literal);
            quote!(cylinder_(#(#lengths),*))
        }
        Geometry::Capsule(lengths) => {
            let lengths = lengths.map(literal);
            quote!(capsule_(#(#lengths),*))
        }
        Geometry::Sphere(radius) => {
            let radius = literal(*radius);
            quote!(sphere_(#radius))
        }
        Geometry::Mesh(file) => quote!(mesh_(#file)),
    };
    let position = shape.position.map(literal);
    let orientation = shape.orientation.map(literal);
    quote!(visual_(#geometry, [#(#position),*], [#(#orientation),*]))
}
