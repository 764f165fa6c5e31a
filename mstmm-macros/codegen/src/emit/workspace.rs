//! The type of workspaces, with access to the results of elements by name.

use super::arrays::usize_literal;
use super::point_access::point_type;
use super::{
    EmitContext, body, docs, indexed_access, initial_values, orders, point_access, spring,
};
use crate::compile::outputs;
use crate::ids::PointId;
use crate::model::{BodyId, Element, ElementPoints, Hinge, HingeId};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};
use std::ops::Range;

/// Returns `struct ChainWorkspace<T>` and its constructor.
pub fn emit(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    let (name, chain) = (&cx.names.workspace, &cx.names.chain);
    let visibility = &cx.passthrough.visibility;
    let doc = format!(" The results of [`{chain}::solve_into`]: {}.", docs::results(cx));
    let dof_count = usize_literal(cx.rates().total);
    let point_count = usize_literal(cx.points().total);
    let number_count = usize_literal(cx.numbers_of_points().total);
    let translations = usize_literal(cx.chain.dimension.translations().len());
    let point_access = point_access::emit(cx);
    let (all_points, order) = (point_access::all(cx), orders::of_points(cx));
    let [initial_numbers, initial_base_acceleration] =
        [outputs::POINT_NUMBERS, outputs::BASE_ACCELERATION]
            .map(|id| initial_values::array(cx, id));
    let rates = usize_literal(cx.all_rates().total);
    let point = point_type(cx);
    let if_prescribed = |tokens: TokenStream| cx.chain.has_prescribed_hinges().then_some(tokens);
    let all_rates_field =
        if_prescribed(quote!(rate_accelerations: #mstmm::nalgebra::SVector<T, #rates>,));
    let all_rates_zero =
        if_prescribed(quote!(rate_accelerations: #mstmm::generated::vector([zero_; #rates]),));
    let all_rates_shown =
        if_prescribed(quote!(.field("rate_accelerations", &self.rate_accelerations)));
    let EnergyItems {
        fields: energy_fields,
        zero: energies_zero,
        methods: energy_methods,
        shown: energies_shown,
    } = energies(cx);
    let closure = closure(cx);
    let ClosureItems {
        field: closure_field,
        zero: closure_zero,
        method: closure_method,
        shown: closure_shown,
    } = closure;
    let spring::SpringItems { field: springs_field, zero: springs_zero, methods: springs } =
        spring::items(cx);
    let (text, body_types) = (name.to_string(), body::types(cx));
    let elements = cx.chain.elements.iter().enumerate().map(|(number, element)| match *element {
        Element::Body(index) => match cx.chain.repetitions(*element) {
            _ if cx.chain.repeat_of_body(index).is_none() => self::body(cx, index, number),
            count => indexed_access::body(cx, (index, number), count),
        },
        Element::Hinge(index) => match cx.chain.repetitions(*element) {
            _ if cx.chain.repeat_of_hinge(index).is_none() => hinge(cx, index, number),
            count => indexed_access::hinge(cx, (index, number), count),
        },
    });
    quote! {
        #[doc = #doc]
        #[derive(Clone, PartialEq)]
        #[allow(dead_code, non_snake_case)]
        #visibility struct #name<T> {
            accelerations: #mstmm::nalgebra::SVector<T, #dof_count>,
            #all_rates_field
            efforts: #mstmm::nalgebra::SVector<T, #rates>,
            #energy_fields
            #closure_field
            numbers: [T; #number_count],
            base_acceleration: [T; #translations],
            #springs_field
        }
        #[allow(dead_code, non_snake_case)]
        impl<T: #mstmm::Scalar> #name<T> {
            /// Returns the accelerations `v̇` of all hinges, in the order of `v` of the state, in rad/s² and m/s².
            #[inline]
            #visibility fn accelerations(&self) -> &#mstmm::nalgebra::SVector<T, #dof_count> {
                &self.accelerations
            }

            #energy_methods

            #(#[doc = #order])*
            #[inline]
            #visibility fn points(&self) -> [#point; #point_count] {
                #all_points
            }

            #point_access

            #closure_method

            #(#elements)*

            #springs
        }
        #body_types
        impl<T: #mstmm::Scalar> ::core::fmt::Debug for #name<T> {
            fn fmt(&self, to_: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                to_.debug_struct(#text)
                    .field("accelerations", &self.accelerations)
                    #all_rates_shown
                    .field("efforts", &self.efforts)
                    #energies_shown
                    #closure_shown
                    .field("points", &self.points())
                    .finish()
            }
        }
        #[allow(dead_code, non_snake_case)]
        impl<T: #mstmm::Scalar> #chain<T> {
            /// Returns an empty workspace for [`solve_into`](Self::solve_into). Its contents are unspecified until then.
            #[must_use]
            #[allow(clippy::all)]
            #visibility fn workspace(&self) -> #name<T> {
                let zero_ = T::constant(0.0);
                #name {
                    accelerations: #mstmm::generated::vector([zero_; #dof_count]),
                    #all_rates_zero
                    efforts: #mstmm::generated::vector([zero_; #rates]),
                    #energies_zero
                    #closure_zero
                    numbers: #initial_numbers,
                    base_acceleration: #initial_base_acceleration,
                    #springs_zero
                }
            }
        }
    }
}

impl EmitContext<'_> {
    /// Returns the field with the accelerations of all rates, which is separate only if some are prescribed.
    pub fn rate_accelerations(&self) -> Ident {
        let apart = self.chain.has_prescribed_hinges();
        format_ident!("{}", if apart { "rate_accelerations" } else { "accelerations" })
    }
}

/// The parts of a workspace for the energies.
#[derive(Default)]
struct EnergyItems {
    fields: TokenStream,
    zero: TokenStream,
    methods: TokenStream,
    shown: TokenStream,
}

fn energies(cx: &EmitContext) -> EnergyItems {
    if !cx.chain.results.energies {
        return EnergyItems::default();
    }
    let visibility = &cx.passthrough.visibility;
    let [kinetic, potential] =
        [0, 1].map(|entry| initial_values::entry(cx, outputs::ENERGIES, entry));
    EnergyItems {
        fields: quote! {
            kinetic_energy: T,
            potential_energy: T,
        },
        zero: quote! {
            kinetic_energy: #kinetic,
            potential_energy: #potential,
        },
        methods: quote! {
            /// Returns the kinetic energy in J.
            #[inline]
            #visibility fn kinetic_energy(&self) -> T {
                self.kinetic_energy
            }

            /// Returns the potential energy in J of gravity and springs.
            ///
            /// That of gravity is zero if all centres of mass are at the inertial origin.
            #[inline]
            #visibility fn potential_energy(&self) -> T {
                self.potential_energy
            }
        },
        shown: quote! {
            .field("kinetic_energy", &self.kinetic_energy)
            .field("potential_energy", &self.potential_energy)
        },
    }
}

/// The parts of a workspace for the loop closure of a closed chain.
struct ClosureItems {
    field: TokenStream,
    zero: TokenStream,
    method: TokenStream,
    shown: TokenStream,
}

fn closure(cx: &EmitContext) -> ClosureItems {
    let mstmm = &cx.mstmm;
    let Some(held) = initial_values::length(cx, outputs::UNDETERMINED).map(|count| count / 6)
    else {
        let [field, zero, method, shown] = [(); 4].map(|()| TokenStream::new());
        return ClosureItems { field, zero, method, shown };
    };
    let closing = cx.layout.loop_hinges.first();
    let closing = closing.unwrap_or_else(|| bug!("a chain without a closing hinge has reactions"));
    let doc = format!(
        " Returns the redundant directions of the closing hinge `{}`.",
        cx.chain.hinges[*closing].path
    );
    let (held, visibility) = (Literal::usize_unsuffixed(held), &cx.passthrough.visibility);
    ClosureItems {
        field: quote!(closure: #mstmm::LoopClosure<T, #held>,),
        zero: quote!(closure: ::core::default::Default::default(),),
        shown: quote!(.field("closure", &self.closure)),
        method: quote! {
            #[doc = #doc]
            ///
            /// The motion does not determine the reactions along them; their wrenches are in the inboard frame.
            #[inline]
            #visibility fn closure(&self) -> &#mstmm::LoopClosure<T, #held> {
                &self.closure
            }
        },
    }
}

fn body(cx: &EmitContext, index: BodyId, element: usize) -> TokenStream {
    let (body, visibility) = (&cx.chain.bodies[index], &cx.passthrough.visibility);
    let name = &body.name;
    let doc = format!(" Returns the results at body `{}`: {}.", body.path, body::contents(body));
    let (ends, ty) = (ends(cx, element), body::type_of(cx, index));
    let at = |point: PointId| usize_literal(cx.point_index(point).last).to_token_stream();
    let result = body::result(cx, (index, element), &at(cx.ends(element).input), at);
    quote! {
        #[doc = #doc]
        #[inline]
        #visibility fn #name(&self) -> #ty {
            #ends
            #result
        }
    }
}

fn hinge(cx: &EmitContext, index: HingeId, element: usize) -> TokenStream {
    let mstmm = &cx.mstmm;
    let Hinge { name, path, kind, .. } = &cx.chain.hinges[index];
    let visibility = &cx.passthrough.visibility;
    let range = &cx.layout.rates[index];
    let ty = cx.numbers_type(kind.dof_count());
    let of = |field: &Ident| match range.len() {
        0 => quote!(()),
        1 => scalar(cx, range, field),
        _ => vector(cx, range, field),
    };
    let (acceleration, effort) = (of(&cx.rate_accelerations()), of(&format_ident!("efforts")));
    let doc = format!(" Returns acceleration, effort, input and output of hinge `{path}`.");
    let (ends, point) = (ends(cx, element), point_type(cx));
    quote! {
        #[doc = #doc]
        #[inline]
        #visibility fn #name(&self) -> #mstmm::HingeResult<T, #ty, #point> {
            #ends
            #mstmm::HingeResult::new(#acceleration, #effort, input_, output_)
        }
    }
}

/// Returns a statement that binds `input` and `output` of an element.
fn ends(cx: &EmitContext, element: usize) -> TokenStream {
    let ElementPoints { input, output, .. } = cx.ends(element);
    let [input, output] = [input, output].map(|point| usize_literal(cx.point_index(point).last));
    quote!(let (input_, output_) = (self.point_(#input), self.point_(#output));)
}

fn scalar(cx: &EmitContext, range: &Range<usize>, field: &Ident) -> TokenStream {
    let numbers = numbers(cx, range, field);
    quote!({
        let [value_] = #numbers;
        value_
    })
}

fn vector(cx: &EmitContext, range: &Range<usize>, field: &Ident) -> TokenStream {
    let mstmm = &cx.mstmm;
    let numbers = numbers(cx, range, field);
    quote!(#mstmm::generated::vector(#numbers))
}

/// Returns the expression for a range of the entries of all rates.
fn numbers(cx: &EmitContext, range: &Range<usize>, field: &Ident) -> TokenStream {
    let mstmm = &cx.mstmm;
    let layout = cx.all_rates();
    let segment = layout.segment_of(range.start);
    let offset = segment.offset + range.start - segment.first;
    let [count, offset] = [range.len(), offset].map(usize_literal);
    quote!(#mstmm::generated::segment::<_, #count, #offset>(&self.#field))
}
