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

/// Returns `struct ChainWorkspace<T>`, its implementations and its constructor.
pub fn emit(cx: &EmitContext) -> TokenStream {
    let optional = [all_rates(cx), energies(cx), closure(cx), springs(cx)];
    let (declaration, accessors) = (declaration(cx, &optional), accessors(cx, &optional));
    let (debug, constructor) = (debug(cx, &optional), constructor(cx, &optional));
    let body_types = body::types(cx);
    quote! {
        #declaration
        #accessors
        #body_types
        #debug
        #constructor
    }
}

/// The parts of a workspace for a result that only some chains have; empty for all others.
#[derive(Default)]
struct OptionalItems {
    fields: TokenStream,
    /// The initial values of the fields.
    zero: TokenStream,
    methods: TokenStream,
    /// The calls that show the fields in the debug output.
    shown: TokenStream,
}

/// The accelerations of all rates, the energies, the loop closure and the springs.
type OptionalResults = [OptionalItems; 4];

/// Returns the struct.
fn declaration(cx: &EmitContext, optional: &OptionalResults) -> TokenStream {
    let mstmm = &cx.mstmm;
    let (name, visibility) = (&cx.names.workspace, &cx.passthrough.visibility);
    let doc = format!(" The results of [`{}::solve_into`]: {}.", cx.names.chain, docs::results(cx));
    let [dof_count, rates, number_count] =
        [cx.rates().total, cx.all_rates().total, cx.numbers_of_points().total].map(usize_literal);
    let translations = usize_literal(cx.chain.dimension.translations().len());
    let [all_rates, energies, closure, springs] = optional.each_ref().map(|items| &items.fields);
    quote! {
        #[doc = #doc]
        #[derive(Clone, PartialEq)]
        #[allow(dead_code, non_snake_case)]
        #visibility struct #name<T> {
            accelerations: #mstmm::nalgebra::SVector<T, #dof_count>,
            #all_rates
            efforts: #mstmm::nalgebra::SVector<T, #rates>,
            #energies
            #closure
            numbers: [T; #number_count],
            base_acceleration: [T; #translations],
            #springs
        }
    }
}

/// Returns the methods that read the results.
fn accessors(cx: &EmitContext, optional: &OptionalResults) -> TokenStream {
    let mstmm = &cx.mstmm;
    let (name, visibility) = (&cx.names.workspace, &cx.passthrough.visibility);
    let [dof_count, point_count] = [cx.rates().total, cx.points().total].map(usize_literal);
    let (order, point, all_points) = (orders::of_points(cx), point_type(cx), point_access::all(cx));
    let point_access = point_access::emit(cx);
    let [all_rates, energies, closure, springs] = optional.each_ref().map(|items| &items.methods);
    let elements = elements(cx);
    quote! {
        #[allow(dead_code, non_snake_case)]
        impl<T: #mstmm::Scalar> #name<T> {
            /// Returns the accelerations `v̇` of all hinges, in the order of `v` of the state, in rad/s² and m/s².
            #[inline]
            #visibility fn accelerations(&self) -> &#mstmm::nalgebra::SVector<T, #dof_count> {
                &self.accelerations
            }

            #all_rates

            #energies

            #(#[doc = #order])*
            #[inline]
            #visibility fn points(&self) -> [#point; #point_count] {
                #all_points
            }

            #point_access

            #closure

            #elements

            #springs
        }
    }
}

/// Returns the methods for the results at bodies and hinges.
fn elements(cx: &EmitContext) -> TokenStream {
    let elements = cx.chain.elements.iter().enumerate();
    let methods = elements.map(|(number, element)| match *element {
        Element::Body(index) => match cx.chain.repetitions(*element) {
            _ if cx.chain.repeat_of_body(index).is_none() => body(cx, index, number),
            count => indexed_access::body(cx, (index, number), count),
        },
        Element::Hinge(index) => match cx.chain.repetitions(*element) {
            _ if cx.chain.repeat_of_hinge(index).is_none() => hinge(cx, index, number),
            count => indexed_access::hinge(cx, (index, number), count),
        },
    });
    methods.collect()
}

/// Returns the implementation of `Debug`.
fn debug(cx: &EmitContext, optional: &OptionalResults) -> TokenStream {
    let (mstmm, name) = (&cx.mstmm, &cx.names.workspace);
    let text = name.to_string();
    let [all_rates, energies, closure, springs] = optional.each_ref().map(|items| &items.shown);
    quote! {
        impl<T: #mstmm::Scalar> ::core::fmt::Debug for #name<T> {
            fn fmt(&self, to_: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                to_.debug_struct(#text)
                    .field("accelerations", &self.accelerations)
                    #all_rates
                    .field("efforts", &self.efforts)
                    #energies
                    #closure
                    #springs
                    .field("points", &self.points())
                    .finish()
            }
        }
    }
}

/// Returns the chain's method for an empty workspace.
fn constructor(cx: &EmitContext, optional: &OptionalResults) -> TokenStream {
    let mstmm = &cx.mstmm;
    let (name, chain) = (&cx.names.workspace, &cx.names.chain);
    let visibility = &cx.passthrough.visibility;
    let [dof_count, rates] = [cx.rates().total, cx.all_rates().total].map(usize_literal);
    let [numbers, base_acceleration] = [outputs::POINT_NUMBERS, outputs::BASE_ACCELERATION]
        .map(|id| initial_values::array(cx, id));
    let [all_rates, energies, closure, springs] = optional.each_ref().map(|items| &items.zero);
    quote! {
        #[allow(dead_code, non_snake_case)]
        impl<T: #mstmm::Scalar> #chain<T> {
            /// Returns an empty workspace for [`solve_into`](Self::solve_into). Its contents are unspecified until then.
            #[must_use]
            #[allow(clippy::all)]
            #visibility fn workspace(&self) -> #name<T> {
                let zero_ = T::constant(0.0);
                #name {
                    accelerations: #mstmm::generated::vector([zero_; #dof_count]),
                    #all_rates
                    efforts: #mstmm::generated::vector([zero_; #rates]),
                    #energies
                    #closure
                    numbers: #numbers,
                    base_acceleration: #base_acceleration,
                    #springs
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

/// Returns the parts for the accelerations of all rates, which are separate only if some are prescribed.
fn all_rates(cx: &EmitContext) -> OptionalItems {
    if !cx.chain.has_prescribed_hinges() {
        return OptionalItems::default();
    }
    let (mstmm, rates) = (&cx.mstmm, usize_literal(cx.all_rates().total));
    OptionalItems {
        fields: quote!(rate_accelerations: #mstmm::nalgebra::SVector<T, #rates>,),
        zero: quote!(rate_accelerations: #mstmm::generated::vector([zero_; #rates]),),
        methods: TokenStream::new(),
        shown: quote!(.field("rate_accelerations", &self.rate_accelerations)),
    }
}

/// Returns the parts for the energies.
fn energies(cx: &EmitContext) -> OptionalItems {
    if !cx.chain.results.energies {
        return OptionalItems::default();
    }
    let visibility = &cx.passthrough.visibility;
    let [kinetic, potential] =
        [0, 1].map(|entry| initial_values::entry(cx, outputs::ENERGIES, entry));
    OptionalItems {
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

/// Returns the parts for the loop closure of a closed chain.
fn closure(cx: &EmitContext) -> OptionalItems {
    let mstmm = &cx.mstmm;
    let Some(held) = initial_values::length(cx, outputs::UNDETERMINED).map(|count| count / 6)
    else {
        return OptionalItems::default();
    };
    let closing = cx.layout.loop_hinges.first();
    let closing = closing.unwrap_or_else(|| bug!("a chain without a closing hinge has reactions"));
    let doc = format!(
        " Returns the redundant directions of the closing hinge `{}`.",
        cx.chain.hinges[*closing].path
    );
    let (held, visibility) = (Literal::usize_unsuffixed(held), &cx.passthrough.visibility);
    OptionalItems {
        fields: quote!(closure: #mstmm::LoopClosure<T, #held>,),
        zero: quote!(closure: ::core::default::Default::default(),),
        shown: quote!(.field("closure", &self.closure)),
        methods: quote! {
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

/// Returns the parts for the springs, if the solution computes them.
fn springs(cx: &EmitContext) -> OptionalItems {
    let Some(length) = initial_values::length(cx, outputs::SPRINGS) else {
        return OptionalItems::default();
    };
    let (length, initial) = (usize_literal(length), initial_values::array(cx, outputs::SPRINGS));
    OptionalItems {
        fields: quote!(springs: [T; #length],),
        zero: quote!(springs: #initial,),
        methods: spring::methods(cx),
        shown: TokenStream::new(),
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
