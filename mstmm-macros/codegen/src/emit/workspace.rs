//! Where results are written, with named access to every element's connection points.

use super::Plan;
use super::state::result_type;
use crate::model::{Element, Hinge, Results};
use proc_macro2::{Literal, TokenStream};
use quote::quote;
use std::ops::Range;

/// `struct ChainWorkspace<T>` and how to get one.
pub fn emit(plan: &Plan) -> TokenStream {
    let (name, chain) = (&plan.names.workspace, &plan.names.chain);
    let visibility = &plan.surface.visibility;
    let doc = format!(" Results of [`{chain}::solve_into`].");
    let freedoms = Literal::usize_unsuffixed(plan.layout.freedoms());
    let point_count = Literal::usize_unsuffixed(plan.chain.route.len() + 1);
    let elements = plan.chain.route.iter().enumerate().map(|(place, element)| match *element {
        Element::Body(index) => body(plan, index, place),
        Element::Hinge(index) => hinge(plan, index, place),
    });
    quote! {
        #[doc = #doc]
        #[derive(Clone, Debug, PartialEq)]
        #[allow(dead_code, non_snake_case)]
        #visibility struct #name<T> {
            accelerations: ::mstmm::nalgebra::SVector<T, #freedoms>,
            efforts: ::mstmm::nalgebra::SVector<T, #freedoms>,
            kinetic_energy: T,
            potential_energy: T,
            points: [::mstmm::Point<T>; #point_count],
        }
        #[allow(dead_code, non_snake_case)]
        impl<T: ::mstmm::Scalar> #name<T> {
            /// Accelerations `v̇` of all hinges, in the order of the rates.
            #[inline]
            #visibility fn accelerations(&self) -> &::mstmm::nalgebra::SVector<T, #freedoms> {
                &self.accelerations
            }

            /// Kinetic energy in J.
            #[inline]
            #visibility fn kinetic_energy(&self) -> T {
                self.kinetic_energy
            }

            /// Potential energy in J; zero with every centre of mass at the inertial origin.
            #[inline]
            #visibility fn potential_energy(&self) -> T {
                self.potential_energy
            }

            /// All connection points in the order written: the first element's input, then every
            /// element's output.
            #[inline]
            #visibility fn points(&self) -> &[::mstmm::Point<T>; #point_count] {
                &self.points
            }

            #(#elements)*
        }
        #[allow(dead_code, non_snake_case)]
        impl<T: ::mstmm::Scalar> #chain<T> {
            /// Room for the results of [`solve_into`](Self::solve_into).
            #[must_use]
            #visibility fn workspace(&self) -> #name<T> {
                let zero = T::constant(0.0);
                #name {
                    accelerations: ::mstmm::generated::vector([zero; #freedoms]),
                    efforts: ::mstmm::generated::vector([zero; #freedoms]),
                    kinetic_energy: zero,
                    potential_energy: zero,
                    points: [::core::default::Default::default(); #point_count],
                }
            }
        }
    }
}

fn body(plan: &Plan, index: usize, place: usize) -> TokenStream {
    let (name, visibility) = (&plan.chain.bodies[index].name, &plan.surface.visibility);
    let doc = format!(" Input and output of body `{name}`.");
    let ends = ends(place);
    quote! {
        #[doc = #doc]
        #[inline]
        #visibility fn #name(&self) -> ::mstmm::BodyResult<'_, T> {
            #ends
            ::mstmm::BodyResult::new(input, output)
        }
    }
}

fn hinge(plan: &Plan, index: usize, place: usize) -> TokenStream {
    let Hinge { name, kind, .. } = &plan.chain.hinges[index];
    let visibility = &plan.surface.visibility;
    let range = &plan.layout.v[index];
    let results = kind.shape().results;
    let (ty, of) = (result_type(results), |field| match results {
        Results::Nothing => quote!(()),
        Results::Number => scalar(range, field),
        Results::Vector => vector(range, field),
    });
    let (acceleration, effort) = (of("accelerations"), of("efforts"));
    let doc = format!(" Acceleration, effort, input and output of hinge `{name}`.");
    let ends = ends(place);
    quote! {
        #[doc = #doc]
        #[inline]
        #visibility fn #name(&self) -> ::mstmm::HingeResult<'_, T, #ty> {
            #ends
            ::mstmm::HingeResult::new(#acceleration, #effort, input, output)
        }
    }
}

/// Binds `input` and `output` of the element at `place` on the route.
fn ends(place: usize) -> TokenStream {
    let skipped = (0..place).map(|_| quote!(_,));
    quote!(let [#(#skipped)* input, output, ..] = &self.points;)
}

fn scalar(range: &Range<usize>, field: &str) -> TokenStream {
    let (field, skipped) = (quote::format_ident!("{field}"), (0..range.start).map(|_| quote!(_,)));
    quote!({
        let [[#(#skipped)* value, ..]] = self.#field.data.0;
        value
    })
}

fn vector(range: &Range<usize>, field: &str) -> TokenStream {
    let (field, skipped) = (quote::format_ident!("{field}"), (0..range.start).map(|_| quote!(_,)));
    quote!({
        let [[#(#skipped)* x, y, z, ..]] = self.#field.data.0;
        ::mstmm::generated::vector([x, y, z])
    })
}
