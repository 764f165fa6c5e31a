//! The regressor of chains in space for scalar types that have columns: several rates at a time.

use super::super::arrays::usize_literal;
use super::super::printer::Destination;
use super::super::procedure::body;
use super::super::{EmitContext, initial_values};
use super::dynamics::of_accelerations;
use super::fallible;
use super::regressor::size;
use crate::compile::{CompiledFunction, layouts, outputs};
use crate::model::{Answer, BodyId, DynamicParameter, MovesWith};
use crate::program::{OutputId, PACK};
use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

/// The number of columns of the regressor for one body.
const PARAMETERS: usize = 10;

/// Returns the statements that call the method, and the private method. Both are empty if the chain lacks it.
pub(super) fn emit(cx: &EmitContext) -> (TokenStream, TokenStream) {
    let Some(function) = cx.compiled.find(Answer::RegressorMotions) else {
        return (TokenStream::new(), TokenStream::new());
    };
    let mstmm = &cx.mstmm;
    let lanes = usize_literal(PACK);
    let dispatch = quote! {
        if <<T as #mstmm::Scalar>::Pack as #mstmm::Columns<T>>::COUNT >= #lanes {
            return self.regressor_by_rates_::<<T as #mstmm::Scalar>::Pack>(
                state_,
                accelerations_,
                inputs_,
                regressor_,
            );
        }
    };
    let (given, returns) = (of_accelerations(cx), fallible(cx, &quote!(())));
    let (rows, columns) = size(cx);
    let body = body([statements(cx, function), quote!(::core::result::Result::Ok(()))]);
    let method = quote! {
        #[allow(unused_doc_comments, unused_variables, clippy::all)]
        fn regressor_by_rates_<C: #mstmm::Columns<T>>(
            &self,
            #given
            regressor_: &mut #mstmm::nalgebra::SMatrix<T, #rows, #columns>,
        ) -> #returns #body
    };
    (dispatch, method)
}

/// Returns the statements of the method.
///
/// The code for the motions of bodies and rates is that of the chain, the products of both are the same for all chains.
fn statements(cx: &EmitContext, function: &CompiledFunction) -> TokenStream {
    let mstmm = &cx.mstmm;
    let motions = motions(cx, function);
    let (paths, passive_columns) = (paths(cx), passive_columns(cx));
    let padded = usize_literal(layouts::padded_rates(cx.layout));
    quote! {
        #motions
        let sum_ = #mstmm::generated::regressor_of_bodies::<T, C, _, #padded, _>(
            motions_.as_chunks::<3>().0.as_chunks::<7>().0,
            &[#(#paths),*],
            #mstmm::generated::chunks::<_, #padded, 0, 6>(&columns_),
            &mut regressor_.data.0,
        );
        #passive_columns
        #mstmm::generated::check_finite::<Self, T>(&[&[sum_]], state_, inputs_)?;
    }
}

/// Returns the statements that compute the motions of bodies and rates.
fn motions(cx: &EmitContext, function: &CompiledFunction) -> TokenStream {
    let variable = |id: OutputId| format_ident!("{}_", id.name);
    let arrays = [outputs::MOTIONS, outputs::COLUMNS, outputs::PASSIVE];
    let arrays = arrays.iter().filter_map(|&id| {
        let initial = initial_values::array_of(cx, Answer::RegressorMotions, id)?;
        let name = variable(id);
        Some(quote!(let mut #name = #initial;))
    });
    let destination = |id: OutputId| Destination::Array(variable(id).to_token_stream());
    let fresh = TokenStream::new();
    let statements = match &function.packed {
        Some(packed) => cx.procedure_of_packs(packed, &fresh, destination),
        None => cx.procedure(&function.procedure, &fresh, destination),
    };
    quote! {
        #(#arrays)*
        #statements
    }
}

/// Returns for each body the rates that move it: bit `k` belongs to rate `k`, with 64 bits in each word.
fn paths(cx: &EmitContext) -> Vec<TokenStream> {
    let words = cx.layout.dof_count().div_ceil(64);
    let path = |body: BodyId| {
        let mut bits = vec![0_u64; words];
        let mut next = match cx.layout.parts[body] {
            MovesWith::Ground => None,
            MovesWith::Link(link) => Some(link),
        };
        while let Some(link) = next {
            let link = &cx.layout.links[link];
            cx.layout.v[link.hinge].clone().for_each(|rate| bits[rate / 64] |= 1 << (rate % 64));
            next = link.parent;
        }
        let bits = bits.into_iter().map(Literal::u64_unsuffixed);
        quote!([#(#bits),*])
    };
    cx.chain.physical_bodies().map(path).collect()
}

/// Returns the statements for the columns of passive elements, if the chain has any.
fn passive_columns(cx: &EmitContext) -> Option<TokenStream> {
    let (mstmm, elements) = (&cx.mstmm, elements(cx));
    let first = usize_literal(PARAMETERS * cx.chain.physical_bodies().count());
    (!elements.is_empty()).then(|| {
        quote! {
            if let ::core::option::Option::Some(elements_) = regressor_.data.0.get_mut(#first..) {
                #mstmm::generated::regressor_of_elements(&passive_, &[#(#elements),*], elements_);
            }
        }
    })
}

/// Returns for each passive element the first rate of its hinge and the number of these rates.
fn elements(cx: &EmitContext) -> Vec<TokenStream> {
    let parameters = cx.chain.dynamic_parameters().into_iter();
    let element = |parameter| match parameter {
        DynamicParameter::Passive(hinge, ..) => {
            let range = &cx.layout.v[hinge];
            let [first, count] = [range.start, range.len()].map(usize_literal);
            Some(quote!([#first, #count]))
        }
        DynamicParameter::Inertial(..) => None,
    };
    parameters.filter_map(element).collect()
}
