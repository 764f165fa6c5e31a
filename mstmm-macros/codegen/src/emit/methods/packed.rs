//! Methods with limbs of one shape side by side, for scalar types that have packs.

use super::super::EmitContext;
use super::super::arrays::usize_literal;
use super::super::names::helper;
use super::super::procedure::body;
use super::{MethodTemplate, fresh, template};
use crate::compile::CompiledFunction;
use crate::program::PACK;
use proc_macro2::{Ident, Spacing, TokenStream, TokenTree};
use quote::quote;

/// Returns the statements that call the packed form of a function, and the private method with this form. Both are empty if
/// there is none.
pub(super) fn emit(cx: &EmitContext, function: &CompiledFunction) -> (TokenStream, TokenStream) {
    let (Some(answer), Some(procedure)) = (function.answer, &function.packed) else {
        return (TokenStream::new(), TokenStream::new());
    };
    if function.by_columns {
        return (TokenStream::new(), TokenStream::new());
    }
    let (mstmm, lanes) = (&cx.mstmm, usize_literal(PACK));
    let MethodTemplate { arguments, returns, opening, end, destination, .. } = template(cx, answer);
    let name = helper(&format!("{}_packed", answer.name()));
    let passed = names(&arguments);
    let statements = cx.procedure_of_packs(procedure, &fresh(answer), |id| destination(cx, id));
    let body = body([opening, statements, end]);
    let dispatch = quote! {
        if <<T as #mstmm::Scalar>::Pack as #mstmm::Columns<T>>::COUNT >= #lanes {
            return self.#name::<<T as #mstmm::Scalar>::Pack>(#(#passed),*);
        }
    };
    let method = quote! {
        #[allow(unused_doc_comments, unused_variables, clippy::all)]
        fn #name<C: #mstmm::Columns<T>>(&self, #arguments) -> #returns #body
    };
    (dispatch, method)
}

/// Returns the names of arguments: identifiers before a single colon.
fn names(arguments: &TokenStream) -> Vec<Ident> {
    let mut names = Vec::new();
    let mut last: Option<TokenTree> = None;
    for token in arguments.clone() {
        let is_colon = matches!(&token, TokenTree::Punct(it) if it.as_char() == ':' && it.spacing() == Spacing::Alone);
        if let (Some(TokenTree::Ident(name)), true) = (&last, is_colon) {
            names.push(name.clone());
        }
        last = Some(token);
    }
    names
}
