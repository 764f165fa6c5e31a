//! The Jacobians of bodies at free ends, without the motions of other bodies.

use super::super::arrays::usize_literal;
use super::super::printer::Destination;
use super::super::procedure::body;
use super::super::{EmitContext, docs, quaternions};
use super::{fallible, of_state_and_inputs};
use crate::model::BodyId;
use crate::program::Procedure;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Returns the methods.
pub(super) fn emit(cx: &EmitContext) -> TokenStream {
    cx.compiled.jacobians.iter().map(|(body, procedure)| method(cx, *body, procedure)).collect()
}

/// Returns the name of the method of a body that writes to the caller's matrix.
pub(super) fn name(cx: &EmitContext, of: BodyId) -> String {
    format!("{}_jacobian_into", cx.chain.bodies[of].name)
}

fn method(cx: &EmitContext, of: BodyId, procedure: &Procedure) -> TokenStream {
    let (mstmm, visibility) = (&cx.mstmm, &cx.passthrough.visibility);
    let into = format_ident!("{}", name(cx, of));
    let (of, dimension) = (&cx.chain.bodies[of], cx.chain.dimension);
    let [places, rows, columns] =
        [dimension.translations().len(), dimension.axes().len(), cx.rates().total]
            .map(usize_literal);
    let name = format_ident!("{}_jacobian", of.name);
    let by_value = format!(
        " Returns the Jacobian of a point of body `{}`; see [`{into}`](Self::{into}).",
        of.path
    );
    let errors_of = format!(" Those of [`{into}`](Self::{into}).");
    let doc = format!(
        " Computes the Jacobian of the point at `place` of body `{}`, in m in the frame of the body, without the kinematics \
         of other bodies.",
        of.path
    );
    let (cost, near_one) = (docs::cost(procedure), quaternions::near_one(cx));
    let (given, returns) = (of_state_and_inputs(cx), fallible(cx, &quote!(())));
    let place = quote!(place_: &#mstmm::nalgebra::SVector<T, #places>,);
    let matrix = quote!(#mstmm::nalgebra::SMatrix<T, #rows, #columns>);
    let returned = fallible(cx, &matrix);
    let (checked, errors) = (quaternions::checked(cx), quaternions::error(cx));
    let statements = cx.procedure(procedure, &TokenStream::new(), |_| {
        Destination::Matrix(quote!((*jacobian_)), dimension.axes().len())
    });
    let body = body([statements, quote!(::core::result::Result::Ok(()))]);
    quote! {
        #[doc(alias("computeFrameJacobian", "mj_jac", "mj_jacSite", "getFrameJacobian", "tool Jacobian"))]
        #[doc = #doc]
        ///
        /// Its rows are those of `jacobian()` of a point of the [kinematics](Self::kinematics_into): velocity, then angular
        /// velocity, in inertial axes. It has one column for each rate, in the order of `v` of the state. Bodies at free
        /// ends have this method; the kinematics have the Jacobians of all bodies.
        #(#[doc = #near_one])*
        #(#[doc = #cost])*
        ///
        /// # Errors
        ///
        /// `Error::NotFinite` if the coordinates, the place or the prescribed motions are not finite. Entries of `jacobian`
        /// may then be overwritten.
        #[allow(unused_doc_comments, unused_variables, clippy::all)]
        #visibility fn #into(&self, #given #place jacobian_: &mut #matrix) -> #returns #body
        #[doc = #by_value]
        ///
        /// # Errors
        ///
        #[doc = #errors_of]
        #(#[doc = #errors])*
        #visibility fn #name(&self, #given #place) -> #returned {
            #checked
            let mut jacobian_ = #mstmm::generated::matrix([[T::constant(0.0); #rows]; #columns]);
            self.#into(state_, inputs_, place_, &mut jacobian_)?;
            ::core::result::Result::Ok(jacobian_)
        }
    }
}
