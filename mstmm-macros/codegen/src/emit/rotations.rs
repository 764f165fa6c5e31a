//! The table of the coordinates that are rotations, for corrections of closed chains.

use super::EmitContext;
use super::arrays::usize_literal;
use crate::model::{RotationCoordinates, rotation_coordinates};
use crate::program::Strided;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the table of all coordinates of the state that are rotations.
pub fn table(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    let rows = rotation_coordinates(cx.chain, cx.layout).into_iter().map(|rotation| {
        let RotationCoordinates { coordinates, quaternion } = rotation;
        let Strided { first, stride, count } = cx.coordinates().strided(coordinates.start);
        let [first, entries, stride, count] =
            [first, coordinates.len(), stride, count].map(usize_literal);
        quote! {
            #mstmm::generated::RotationCoordinates {
                first: #first,
                entries: #entries,
                stride: #stride,
                count: #count,
                quaternion: #quaternion,
            }
        }
    });
    quote!(&[#(#rows),*])
}
