//! The layouts of generated arrays, and expressions for their segments.

use super::EmitContext;
use crate::compile::{Compiled, layouts, outputs};
use crate::ids::RepeatId;
use crate::model::{Chain, Layout};
use crate::program::{ArrayLayout, ArrayRole, Segment};
use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

/// Returns a literal without a suffix.
pub fn usize_literal(value: usize) -> Literal {
    Literal::usize_unsuffixed(value)
}

/// The layouts of arrays with entries for all hinges or for all points.
pub struct ArrayLayouts {
    coordinates: ArrayLayout,
    rates: ArrayLayout,
    all_rates: ArrayLayout,
    points: ArrayLayout,
}

impl ArrayLayouts {
    /// Returns the layouts of a chain.
    pub fn of(chain: &Chain, layout: &Layout, compiled: &Compiled) -> Self {
        ArrayLayouts {
            coordinates: layouts::coordinates(chain, layout),
            rates: layouts::rates(chain, layout),
            all_rates: layouts::all_rates(chain, layout),
            points: layouts::points(chain, &compiled.point_storage.of),
        }
    }
}

impl EmitContext<'_> {
    /// Returns the layout of the joint coordinates `q`.
    pub fn coordinates(&self) -> &ArrayLayout {
        &self.layouts.coordinates
    }

    /// Returns the layout of the joint rates `v`.
    pub fn rates(&self) -> &ArrayLayout {
        &self.layouts.rates
    }

    /// Returns the layout of one entry for every rate, including the rates of prescribed hinges.
    pub fn all_rates(&self) -> &ArrayLayout {
        &self.layouts.all_rates
    }

    /// Returns the layout of one entry for every connection point.
    pub fn points(&self) -> &ArrayLayout {
        &self.layouts.points
    }

    /// Returns the layout of the stored values of all connection points; points without values form no segment.
    pub fn numbers_of_points(&self) -> ArrayLayout {
        layouts::numbers_of_points(self.chain, &self.compiled.point_storage)
    }

    /// Returns the layout of the slots of a repeated part, or of the slots outside of repeated parts.
    pub fn slots(&self, part: Option<RepeatId>) -> ArrayLayout {
        let role = ArrayRole::Result(outputs::slots(part));
        let arrays = &self.compiled.setup.procedure.arrays;
        let array = arrays.iter().find(|array| array.role == role);
        array.unwrap_or_else(|| bug!("the setup has no slots of a part")).layout.clone()
    }

    /// Returns an expression for a copy of a segment outside of repeated parts.
    pub fn segment(&self, array: &impl ToTokens, segment: &Segment) -> TokenStream {
        let mstmm = &self.mstmm;
        let [count, offset] = [segment.count, segment.offset].map(usize_literal);
        quote!(#mstmm::generated::segment::<_, #count, #offset>(&#array))
    }

    /// Returns an expression for the repetitions of a segment.
    pub fn slices(&self, array: &impl ToTokens, segment: &Segment) -> TokenStream {
        let mstmm = &self.mstmm;
        let [count, offset, repetitions] =
            [segment.count, segment.offset, segment.repetitions].map(usize_literal);
        quote!(#mstmm::generated::chunks::<_, #count, #offset, #repetitions>(&#array))
    }

    /// Returns an expression for mutable references to the repetitions of a segment.
    pub fn slices_mut(&self, array: &impl ToTokens, segment: &Segment) -> TokenStream {
        let mstmm = &self.mstmm;
        let [count, offset, repetitions] =
            [segment.count, segment.offset, segment.repetitions].map(usize_literal);
        quote! {
            #mstmm::generated::chunks_mut::<_, #count, #offset, #repetitions>(&mut #array)
        }
    }
}
