//! The method that sets the inputs of motors from efforts, such as those of inverse dynamics.

use super::EmitContext;
use super::arrays::usize_literal;
use crate::model::{Input, InputKind, Request};
use crate::program::Strided;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the method, if the chain has inverse dynamics.
pub fn emit(cx: &EmitContext) -> TokenStream {
    if !cx.chain.requests.contains(&Request::InverseDynamics) {
        return TokenStream::new();
    }
    let is_motor = |input: &&Input| matches!(input.what, InputKind::Efforts(_));
    let driven = cx.layout.driven_rates(cx.chain);
    let motors = cx.layout.inputs.iter().filter(is_motor);
    let sets = motors.map(|input| set(cx, input, &driven));
    let (mstmm, name, visibility) = (&cx.mstmm, &cx.names.inputs, &cx.passthrough.visibility);
    let count = usize_literal(cx.rates().total);
    quote! {
        #[allow(dead_code, unused_variables)]
        impl<T: #mstmm::Scalar> #name<T> {
            /// Sets the efforts of all motors from the efforts of all rates, such as those of inverse dynamics.
            ///
            /// All other inputs stay as they are. Efforts of rates without a motor are not used.
            #[doc(alias("actuation", "selection matrix", "MakeActuationMatrix", "ctrl"))]
            #[inline]
            #visibility fn set_efforts(&mut self, efforts_: &#mstmm::nalgebra::SVector<T, #count>) {
                let [efforts_] = &efforts_.data.0;
                #(#sets)*
            }
        }
    }
}

/// Returns the statement that sets an input.
fn set(cx: &EmitContext, input: &Input, driven: &[Option<usize>]) -> TokenStream {
    let mstmm = &cx.mstmm;
    let is_repeated = cx.chain.repeat_of_input(input.what).is_some();
    let effort = |rate: &Option<usize>| {
        let Some(rate) = *rate else { bug!("an input of a motor drives no rate") };
        let Strided { first, stride, .. } = cx.rates().strided(rate);
        let [first, stride] = [first, stride].map(usize_literal);
        match is_repeated {
            false => quote!(efforts_[#first]),
            true => {
                quote!(efforts_.as_slice().get(#first + #stride * index_).copied().unwrap_or_default())
            }
        }
    };
    let efforts: Vec<TokenStream> = driven[input.range.clone()].iter().map(effort).collect();
    let value = match &efforts[..] {
        [single] => single.clone(),
        _ => quote!(#mstmm::generated::vector([#(#efforts),*])),
    };
    let name = cx.chain.name_of_input(input.what);
    match is_repeated {
        false => quote!(self.#name = #value;),
        true => quote! {
            for (index_, input_) in ::core::iter::Iterator::enumerate(self.#name.iter_mut()) {
                *input_ = #value;
            }
        },
    }
}
