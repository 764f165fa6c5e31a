//! Inputs and parameters by their indices.

use super::super::EmitContext;
use super::super::arrays::usize_literal;
use crate::model::Parameter;
use crate::program::ArrayLayout;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Returns the method that copies all inputs, if there are any.
pub fn inputs(cx: &EmitContext) -> TokenStream {
    let (mstmm, inputs) = (&cx.mstmm, &cx.names.inputs);
    let all = &cx.layout.inputs;
    let (names, repeats): (Vec<_>, Vec<_>) = all
        .iter()
        .map(|input| {
            let repeat = cx.chain.repeat_of_input(input.what);
            (cx.chain.name_of_input(input.what), cx.counted(repeat))
        })
        .unzip();
    if names.is_empty() {
        return TokenStream::new();
    }
    let segments = ArrayLayout::of(repeats.into_iter().map(|repeat| (1, repeat))).segments;
    let copies = segments.iter().map(|segment| {
        let names = &names[segment.entries()];
        if segment.repeat.is_none() {
            return quote!(#(values_.once(&mut inputs_.#names);)*);
        }
        let count = usize_literal(segment.repetitions);
        quote! {
            for index_ in 0..#count {
                #(values_.at(&mut inputs_.#names, index_);)*
            }
        }
    });
    quote! {
        fn copy_inputs_(inputs_: &mut #inputs<T>, mut values_: #mstmm::generated::Values<'_, T>) {
            #(#copies)*
        }
    }
}

/// Returns the implementation of `ParameterRows` for the parameters.
pub fn parameter_rows(cx: &EmitContext) -> TokenStream {
    let (mstmm, name) = (&cx.mstmm, &cx.names.parameters);
    let parameters = &cx.chain.parameters;
    let read = parameters.iter().enumerate().map(|(row, parameter)| {
        let (row, name) = (usize_literal(row), &parameter.name);
        match parameter.repetitions {
            None => quote!(#row => ::core::slice::from_ref(&self.#name),),
            Some(_) => quote!(#row => &self.#name,),
        }
    });
    let read = (!parameters.is_empty()).then(|| {
        quote! {
            fn row_(&self, row_: ::core::primitive::usize) -> &[T] {
                match row_ {
                    #(#read)*
                    _ => &[],
                }
            }
        }
    });
    quote! {
        impl<T: #mstmm::Scalar> #mstmm::generated::ParameterRows<T> for #name<T> {
            #read
        }
    }
}

/// Returns the methods that read and set a parameter, if there are any.
pub fn parameters(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    let parameters = &cx.chain.parameters;
    if parameters.is_empty() {
        return TokenStream::new();
    }
    let set = parameters.iter().enumerate().map(|(row, Parameter { name, repetitions, .. })| {
        let (row, set) = (usize_literal(row), format_ident!("set_{name}"));
        match repetitions {
            None => quote!(#row => self.#set(value_.1),),
            Some(_) => quote! {
                #row => {
                    let before_ = self.parameters().#name;
                    self.#set(|index_| #mstmm::generated::with_entry(&before_, index_, value_))
                }
            },
        }
    });
    let usize = quote!(::core::primitive::usize);
    quote! {
        fn parameter_(&self, row_: #usize) -> &[T] {
            #mstmm::generated::ParameterRows::row_(self.parameters(), row_)
        }
        fn set_parameter_(
            &mut self,
            row_: #usize,
            value_: (#usize, T),
        ) -> #mstmm::generated::description::Set_ {
            match row_ {
                #(#set)*
                _ => #mstmm::generated::description::no_parameter_(),
            }
        }
    }
}
