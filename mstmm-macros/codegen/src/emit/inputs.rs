//! What the caller gives at every step.

use super::Plan;
use super::looped::{Stream, usize_literal};
use super::names::helper;
use crate::model::{Driven, Group, Hinge, HingeId, Input, View};
use crate::program::{Loop, Program};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::HashSet;

/// `struct ChainInputs<T>` and how to get one.
pub fn emit(plan: &Plan) -> TokenStream {
    let mstmm = &plan.mstmm;
    let (name, visibility) = (&plan.names.inputs, &plan.surface.visibility);
    let chain = &plan.names.chain;
    let doc = format!(" What drives [`{chain}`] from outside, given at every step.");
    let inputs = &plan.layout.inputs;
    let fields = inputs.iter().map(|input| {
        let (name, doc, one) =
            (plan.chain.name_of_input(input.what), doc_of(plan, input), type_of(plan, input));
        let ty = times(plan, input).map_or(one.clone(), |times| quote!([#one; #times]));
        quote!(#[doc = #doc] #visibility #name: #ty)
    });
    let zeros = inputs.iter().map(|input| {
        let (name, one) = (plan.chain.name_of_input(input.what), zero_of(plan, input));
        let zero = times(plan, input).map_or(one.clone(), |times| quote!([#one; #times]));
        quote!(#name: #zero)
    });
    // A struct without fields would not use `T`.
    let (marker, marker_value) = if inputs.is_empty() {
        (quote!(none: ::core::marker::PhantomData<T>), quote!(none: ::core::marker::PhantomData))
    } else {
        (TokenStream::new(), TokenStream::new())
    };
    quote! {
        #[doc = #doc]
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[allow(dead_code, non_snake_case)]
        #visibility struct #name<T> {
            #(#fields,)*
            #marker
        }
        impl<T: #mstmm::Scalar> ::core::default::Default for #name<T> {
            #[inline]
            fn default() -> Self {
                Self { #(#zeros,)* #marker_value }
            }
        }
        #[allow(dead_code, non_snake_case)]
        impl<T: #mstmm::Scalar> #chain<T> {
            /// Inputs that are all zero; prescribed motions rest in the zero position.
            #[inline]
            #[must_use]
            #visibility fn no_inputs(&self) -> #name<T> {
                ::core::default::Default::default()
            }
        }
    }
}

/// How many there are of an input to a repeated part.
fn times(plan: &Plan, input: &Input) -> Option<Literal> {
    let repeat = plan.chain.repeat_of_input(input.what)?;
    Some(usize_literal(plan.chain.repeats[repeat].count))
}

/// What a loop reads of the inputs: streams, and statements that take their items apart.
pub fn streams(plan: &Plan, turn: &Loop) -> (Vec<Stream>, TokenStream) {
    let first = plan.programs.symbols.inputs().start;
    let (mut streams, mut taken) = (Vec::new(), TokenStream::new());
    for input in &plan.layout.inputs {
        let is_read = input.range.clone().any(|k| plan.read_in(turn, first + k).is_some());
        if plan.chain.repeat_of_input(input.what) == Some(turn.repeat) && is_read {
            let name = plan.chain.name_of_input(input.what);
            let item = helper(&format!("{name}_input"));
            streams.push((quote!(&#item), quote!(inputs_.#name.iter())));
            taken.extend(plan.read_input(input, &quote!(#item)));
        }
    }
    (streams, taken)
}

fn doc_of(plan: &Plan, input: &Input) -> String {
    match input.what {
        Driven::Gravity => " The acceleration of free fall in m/s², inertial frame.".to_owned(),
        Driven::Efforts(index) => {
            let Hinge { name, kind, .. } = &plan.chain.hinges[index];
            let unit = |turns: bool| if turns { "N m" } else { "N" };
            let units: Vec<&str> = kind.shape().groups.iter().map(|g| unit(g.turns)).collect();
            let unit = units.join(", ");
            format!(" Efforts in {unit} that drive `{name}`, in the order of its rates.")
        }
        Driven::Motion(index) => {
            let Hinge { name, .. } = &plan.chain.hinges[index];
            format!(" The motion of `{name}`.")
        }
        Driven::Force(load) => format!(" The force of `{}` in N.", plan.chain.loads[load].name),
        Driven::Torque(load) => {
            format!(" The torque of `{}` in N m.", plan.chain.loads[load].name)
        }
    }
}

fn type_of(plan: &Plan, input: &Input) -> TokenStream {
    let mstmm = &plan.mstmm;
    match input.what {
        Driven::Motion(hinge) => {
            let view = view_name(plan, hinge);
            let acceleration = plan.numbers_type(plan.chain.hinges[hinge].kind.freedoms());
            quote!(#mstmm::HingeMotion<#mstmm::#view<T>, #acceleration>)
        }
        Driven::Gravity | Driven::Efforts(_) | Driven::Force(_) | Driven::Torque(_) => {
            plan.numbers_type(input.range.len())
        }
    }
}

fn zero_of(plan: &Plan, input: &Input) -> TokenStream {
    let mstmm = &plan.mstmm;
    let zero = |count: usize| match count {
        1 => quote!(T::constant(0.0)),
        _ => quote!(#mstmm::generated::vector([T::constant(0.0); #count])),
    };
    match input.what {
        Driven::Motion(hinge) => {
            let view = view_name(plan, hinge);
            let acceleration = zero(plan.chain.hinges[hinge].kind.freedoms());
            quote! {
                #mstmm::HingeMotion {
                    state: <#mstmm::#view<T> as ::core::default::Default>::default(),
                    acceleration: #acceleration,
                }
            }
        }
        Driven::Gravity | Driven::Efforts(_) | Driven::Force(_) | Driven::Torque(_) => {
            zero(input.range.len())
        }
    }
}

fn view_name(plan: &Plan, hinge: HingeId) -> Ident {
    format_ident!("{}", plan.view(hinge).name)
}

impl Plan<'_> {
    /// The view of a hinge that has coordinates.
    pub fn view(&self, hinge: HingeId) -> &'static View {
        let Hinge { name, kind, .. } = &self.chain.hinges[hinge];
        kind.shape()
            .view
            .as_ref()
            .unwrap_or_else(|| bug!("hinge `{name}` has no coordinates to view"))
    }

    /// The type of so many numbers: a number, or a vector.
    pub fn numbers_type(&self, count: usize) -> TokenStream {
        let mstmm = &self.mstmm;
        match count {
            0 => quote!(()),
            1 => quote!(T),
            _ => quote!(#mstmm::nalgebra::SVector<T, #count>),
        }
    }

    /// Takes the inputs that a program reads into variables.
    pub fn read_inputs(&self, program: &Program) -> TokenStream {
        let first = self.programs.symbols.inputs().start;
        let needed = self.layout.inputs.iter().filter(|input| {
            let mut numbers = input.range.clone();
            numbers.any(|k| program.symbols.binary_search(&((first + k) as u32)).is_ok())
        });
        let read = needed.map(|input| {
            let name = self.chain.name_of_input(input.what);
            self.read_input(input, &quote!(inputs_.#name))
        });
        read.collect()
    }

    /// Takes an input apart.
    fn read_input(&self, input: &Input, from: &TokenStream) -> TokenStream {
        let symbols = self.input_variables(input);
        match input.what {
            Driven::Motion(hinge) => {
                let kind = &self.chain.hinges[hinge].kind;
                let (coordinates, freedoms) = (kind.coordinates(), kind.freedoms());
                let groups = self.view(hinge).groups.iter().map(|group| match group {
                    Group::Coordinates(range) => tuple_or_one(&symbols[range.clone()]),
                    Group::Rates(range) => {
                        let range = coordinates + range.start..coordinates + range.end;
                        tuple_or_one(&symbols[range])
                    }
                });
                let accelerations = &symbols[coordinates + freedoms..];
                let taken = take(accelerations, quote!(#from.acceleration));
                quote! {
                    let (#(#groups,)*) = #from.state.into_groups();
                    #taken
                }
            }
            _ => take(&symbols, quote!(#from)),
        }
    }

    fn input_variables(&self, input: &Input) -> Vec<Ident> {
        let first = self.programs.symbols.inputs().start;
        input.range.clone().map(|k| self.unknowns[first + k].clone()).collect()
    }

    /// Slices that together hold all numbers of the inputs that stand once, but for inputs all of
    /// whose numbers are `shown`, and statements before, which look at all others.
    pub fn input_slices(&self, shown: &HashSet<u32>) -> (TokenStream, Vec<TokenStream>) {
        let first = self.programs.symbols.inputs().start;
        let is_shown = |number: usize| shown.contains(&((first + number) as u32));
        let mstmm = &self.mstmm;
        let mut before = TokenStream::new();
        let mut slices = Vec::new();
        for input in &self.layout.inputs {
            if input.range.clone().all(is_shown) {
                continue;
            }
            let name = self.chain.name_of_input(input.what);
            if times(self, input).is_some() {
                let (taken, slice) = self.input_slice(input, &quote!(item_));
                before.extend(quote! {
                    for &item_ in &inputs_.#name {
                        #taken
                        #mstmm::generated::finite::<T>(&[#slice])?;
                    }
                });
            } else {
                let (taken, slice) = self.input_slice(input, &quote!(inputs_.#name));
                before.extend(taken);
                slices.push(slice);
            }
        }
        (before, slices)
    }

    /// All numbers of an input as a slice, and what it borrows from.
    fn input_slice(&self, input: &Input, from: &TokenStream) -> (TokenStream, TokenStream) {
        match input.what {
            Driven::Motion(_) => {
                let variables = self.input_variables(input);
                (self.read_input(input, from), quote!(&[#(#variables),*]))
            }
            _ if input.range.len() == 1 => (TokenStream::new(), quote!(&[#from])),
            _ => (TokenStream::new(), quote!(#from.as_slice())),
        }
    }
}

/// Takes numbers out of a number, or out of a vector.
fn take(variables: &[Ident], from: TokenStream) -> TokenStream {
    match variables {
        [one] => quote!(let #one = #from;),
        _ => quote!(let [[#(#variables),*]] = #from.data.0;),
    }
}

fn tuple_or_one(variables: &[Ident]) -> TokenStream {
    match variables {
        [one] => quote!(#one),
        _ => quote!([#(#variables),*]),
    }
}
