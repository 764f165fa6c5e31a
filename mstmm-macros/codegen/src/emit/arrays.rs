//! Arrays of numbers: how they are laid out, and how segments of them are read and written.

use super::EmitContext;
use crate::compile::{layouts, outputs};
use crate::ids::RepeatId;
use crate::program::{ArrayLayout, ArrayRole, Segment};
use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

/// A literal without a suffix.
pub fn usize_literal(value: usize) -> Literal {
    Literal::usize_unsuffixed(value)
}

impl EmitContext<'_> {
    /// The coordinates `q`.
    pub fn coordinates(&self) -> ArrayLayout {
        layouts::coordinates(self.chain, self.layout)
    }

    /// The rates `v`.
    pub fn rates(&self) -> ArrayLayout {
        layouts::rates(self.chain, self.layout)
    }

    /// Accelerations and efforts of all rates.
    pub fn all_rates(&self) -> ArrayLayout {
        layouts::all_rates(self.chain, self.layout)
    }

    /// All connection points.
    pub fn points(&self) -> ArrayLayout {
        layouts::points(self.chain)
    }

    /// The numbers of all connection points; points without numbers make no segment.
    pub fn numbers_of_points(&self) -> ArrayLayout {
        layouts::numbers_of_points(self.chain, &self.compiled.point_storage)
    }

    /// What the setup derives for every repetition of a part, or what stands once.
    pub fn slots(&self, part: Option<RepeatId>) -> ArrayLayout {
        let role = ArrayRole::Result(outputs::slots(part));
        let arrays = &self.compiled.setup.procedure.arrays;
        let array = arrays.iter().find(|array| array.role == role);
        array.unwrap_or_else(|| bug!("the setup has no slots of a part")).layout.clone()
    }

    /// A copy of a segment that stands once.
    pub fn segment(&self, array: &impl ToTokens, segment: &Segment) -> TokenStream {
        let mstmm = &self.mstmm;
        let [count, place] = [segment.count, segment.offset].map(usize_literal);
        quote!(#mstmm::generated::segment::<_, #count, #place>(&#array))
    }

    /// The numbers of a segment, repetition by repetition.
    pub fn slices(&self, array: &impl ToTokens, segment: &Segment) -> TokenStream {
        let mstmm = &self.mstmm;
        let [count, place, repetitions] =
            [segment.count, segment.offset, segment.repetitions].map(usize_literal);
        quote!(#mstmm::generated::chunks::<_, #count, #place, #repetitions>(&#array))
    }

    /// The numbers of a segment, repetition by repetition, to be written.
    pub fn slices_mut(&self, array: &impl ToTokens, segment: &Segment) -> TokenStream {
        let mstmm = &self.mstmm;
        let [count, place, repetitions] =
            [segment.count, segment.offset, segment.repetitions].map(usize_literal);
        quote! {
            #mstmm::generated::chunks_mut::<_, #count, #place, #repetitions>(&mut #array)
        }
    }
}
