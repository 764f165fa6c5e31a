//! The coordinates that are rotations, for corrections of closed chains.

use super::EmitContext;
use super::arrays::usize_literal;
use crate::model::{DofGroup, Hinge, HingeKind, Representation};
use crate::program::Strided;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the table of all coordinates of the state that are rotations. A screw may need many turns, which its
/// translation limits.
pub fn table(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    let rotates =
        |hinge: &Hinge| !hinge.is_prescribed() && !matches!(hinge.kind, HingeKind::Screw { .. });
    let hinges = cx.chain.hinges.enumerate().filter(|(_, hinge)| rotates(hinge));
    let rows = hinges.flat_map(|(id, hinge)| {
        let groups = hinge.kind.spec().groups.iter().filter(|group| group.rotational);
        groups.map(move |group| (cx.layout.q[id].start + group.coordinates.start, group))
    });
    let rows = rows.map(|(coordinate, group): (usize, &DofGroup)| {
        let Strided { first, stride, count } = cx.coordinates().strided(coordinate);
        let [first, entries, stride, count] =
            [first, group.coordinates.len(), stride, count].map(usize_literal);
        let quaternion = group.representation == Representation::Quaternion;
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
