//! The methods of kinematics and Jacobians.

use super::super::kinematics::field;
use super::super::kinematics_bodies::point_type;
use super::super::printer::Destination;
use super::super::{EmitContext, checks, quaternions};
use super::{MethodTemplate, fallible, of_state_and_inputs};
use crate::model::Answer;
use proc_macro2::TokenStream;
use quote::quote;

pub(super) fn kinematics(cx: &EmitContext) -> MethodTemplate {
    let (mstmm, visibility) = (&cx.mstmm, &cx.passthrough.visibility);
    let (kinematics, errors) = (&cx.names.kinematics, quaternions::error(cx));
    let jacobian = cx.has_columns().then(|| {
        quote! {
            /// The Jacobian of any point follows from the columns of all rates, which are computed with the motions.
        }
    });
    let (given, products) = (of_state_and_inputs(cx), quaternions::products(cx));
    let reset = quote! {
        #mstmm::generated::reset(at_, || ::core::default::Default::default());
    };
    MethodTemplate {
        name: quote!(#visibility fn kinematics_into),
        docs: [
            quote! {
                #[doc(alias(
                    "forward kinematics", "forwardKinematics", "framesForwardKinematics", "computeJointJacobians", "mj_kinematics",
                    "CalcJacobianSpatialVelocity", "computeJointJacobiansTimeVariation"
                ))]
                /// Computes position, orientation, velocity and bias acceleration (the acceleration at `v̇ = 0`) of all
                /// bodies, without dynamics. Gravity, loads and efforts do not matter.
                #jacobian
                #(#[doc = #products])*
            },
            quote! {
                ///
                /// # Errors
                ///
                /// `Error::NotFinite` if the state or the inputs are not finite. `at` is then empty, without the
                /// results of earlier calls. Values that are computed from `at` afterwards, such as the acceleration of
                /// a point, may overflow where a length or a rate exceeds 1e150, in `f32` 1e18.
                #(#[doc = #errors])*
            },
        ],
        arguments: quote!(#given at_: &mut #kinematics<T>),
        returns: fallible(cx, &quote!(())),
        opening: checks::with_reset(Some(&reset), quaternions::checked(cx)),
        end: quote!(::core::result::Result::Ok(())),
        destination: |_, id| {
            let field = field(id);
            Destination::Array(quote!(at_.#field))
        },
    }
}

/// Returns the further methods of chains with kinematics: by value, and the inertia at a point.
pub(super) fn further(cx: &EmitContext) -> Option<TokenStream> {
    cx.compiled.find(Answer::Kinematics)?;
    let (by_value, inertia) = (by_value(cx), inertia(cx));
    Some(quote!(#by_value #inertia))
}

fn by_value(cx: &EmitContext) -> TokenStream {
    let (kinematics, visibility) = (&cx.names.kinematics, &cx.passthrough.visibility);
    let (given, errors) = (of_state_and_inputs(cx), quaternions::error(cx));
    let returns = fallible(cx, &quote!(#kinematics<T>));
    quote! {
        /// Returns the kinematics of all bodies; see [`kinematics_into`](Self::kinematics_into).
        ///
        /// # Errors
        ///
        /// Those of [`kinematics_into`](Self::kinematics_into).
        #(#[doc = #errors])*
        #[inline]
        #visibility fn kinematics(&self, #given) -> #returns {
            let mut at_ = <#kinematics<T> as ::core::default::Default>::default();
            self.kinematics_into(state_, inputs_, &mut at_)?;
            ::core::result::Result::Ok(at_)
        }
    }
}

/// Returns the methods for the inertia that a point feels, if the chain has Jacobians and products with `M⁻¹`.
fn inertia(cx: &EmitContext) -> Option<TokenStream> {
    cx.compiled.find(Answer::InverseMassMatrixTimes).filter(|_| cx.has_columns())?;
    let (mstmm, visibility) = (&cx.mstmm, &cx.passthrough.visibility);
    let (given, point) = (of_state_and_inputs(cx), point_type(cx, &quote!('_)));
    let rows = super::super::arrays::usize_literal(cx.chain.dimension.axes().len());
    let returns = fallible(cx, &quote!(#mstmm::nalgebra::SMatrix<T, #rows, #rows>));
    Some(quote! {
        #[doc(alias("mobility tensor", "inverse effective inertia", "J M^-1 J^T", "Delassus"))]
        /// Returns `J M⁻¹ Jᵀ` of a point of the kinematics in this state: the acceleration of the point for a unit
        /// force and a unit moment at the point. Rows and columns are those of the Jacobian.
        ///
        /// # Errors
        ///
        /// Those of `inverse_mass_matrix_times_into`.
        #visibility fn inverse_operational_space_inertia(
            &self,
            #given
            point_: &#point,
        ) -> #returns {
            #mstmm::generated::inverse_operational_space_inertia(
                &point_.jacobian(),
                |vector_, product_| {
                    self.inverse_mass_matrix_times_into(state_, inputs_, vector_, product_)
                },
            )
        }

        #[doc(alias("operational space inertia", "effective mass", "task space inertia", "Lambda", "OSIM"))]
        /// Returns the operational-space inertia `(J M⁻¹ Jᵀ)⁻¹` of a point of the kinematics in this state: the
        /// force and the moment at the point for a unit acceleration of the point, in kg, kg m and kg m².
        ///
        /// It does not exist if the point cannot move in every direction, as that of an arm with fewer joints than rows
        /// of the Jacobian. The inertia against a force only is the inverse of the block of
        /// [`inverse_operational_space_inertia`](Self::inverse_operational_space_inertia) in the rows and columns of the
        /// velocity, if the point can move in all their directions.
        ///
        /// # Errors
        ///
        /// `Error::SingularMatrix` if the point cannot move in every direction,
        /// and those of `inverse_mass_matrix_times_into`.
        #visibility fn operational_space_inertia(
            &self,
            #given
            point_: &#point,
        ) -> #returns {
            let inverse_ = self.inverse_operational_space_inertia(state_, inputs_, point_)?;
            #mstmm::generated::inverse_of_positive(&inverse_)
        }
    })
}
