//! Checks the quaternions of states and prescribed motions that the caller supplies.

use super::EmitContext;
use super::arrays::usize_literal;
use crate::model::{Hinge, HingeId, HingeKind, Input, InputKind};
use crate::program::{ArrayLayout, Strided};
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the index of the quaternion among the coordinates of a hinge, if it has one.
fn quaternion_of(kind: &HingeKind) -> Option<usize> {
    kind.spec().quaternion().map(|coordinates| coordinates.start)
}

/// Returns the hinges whose quaternion is in the state, each with the index of the quaternion among the coordinates.
fn in_state(cx: &EmitContext) -> Vec<(HingeId, usize)> {
    let hinges = cx.chain.hinges.enumerate();
    let free = hinges.filter(|(_, hinge)| !hinge.is_prescribed());
    let first_coordinate =
        |index: HingeId, kind| quaternion_of(kind).map(|first| cx.layout.q[index].start + first);
    free.filter_map(|(index, hinge)| Some((index, first_coordinate(index, &hinge.kind)?))).collect()
}

/// Returns the prescribed motions with a quaternion.
fn in_inputs<'a>(cx: &'a EmitContext) -> impl Iterator<Item = &'a Input> {
    cx.layout.inputs.iter().filter(|input| match input.what {
        InputKind::Motion(hinge) => quaternion_of(&cx.chain.hinges[hinge].kind).is_some(),
        _ => false,
    })
}

/// Returns the methods `check_state` and `check_inputs` of the trait `Chain`, if there are quaternions.
pub fn checks(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    let (state, inputs) = (&cx.names.state, &cx.names.inputs);
    let mut methods = TokenStream::new();
    let layout = cx.coordinates();
    let table: Vec<TokenStream> =
        in_state(cx).into_iter().map(|entry| row(cx, layout, entry)).collect();
    if !table.is_empty() {
        methods.extend(quote! {
            #[inline]
            fn check_state(
                &self,
                state_: &#state<T>,
            ) -> ::core::result::Result<(), #mstmm::Error> {
                #mstmm::generated::check_quaternions(state_.q.as_slice(), &[#(#table),*])
            }
        });
    }
    let motions: Vec<TokenStream> = in_inputs(cx).map(|input| motion(cx, input)).collect();
    if !motions.is_empty() {
        methods.extend(quote! {
            #[inline]
            fn check_inputs(
                &self,
                inputs_: &#inputs<T>,
            ) -> ::core::result::Result<(), #mstmm::Error> {
                #(#motions)*
                ::core::result::Result::Ok(())
            }
        });
    }
    methods
}

/// Returns the row of a hinge in the table of quaternions.
fn row(
    cx: &EmitContext,
    layout: &ArrayLayout,
    (index, first_coordinate): (HingeId, usize),
) -> TokenStream {
    let mstmm = &cx.mstmm;
    let hinge = &cx.chain.hinges[index].path;
    let Strided { first, stride, count } = layout.strided(first_coordinate);
    let [first, stride, count] = [first, stride, count].map(usize_literal);
    quote! {
        #mstmm::generated::HingeQuaternions {
            hinge: #hinge,
            first: #first,
            stride: #stride,
            count: #count,
        }
    }
}

/// Returns statements that check a prescribed motion.
fn motion(cx: &EmitContext, input: &Input) -> TokenStream {
    let mstmm = &cx.mstmm;
    let name = cx.chain.name_of_input(input.what);
    let hinge = name.to_string();
    let check = |motion: TokenStream| quote!(#mstmm::generated::check_quaternion(#hinge, &#motion.state.quaternion())?;);
    if cx.chain.repeat_of_input(input.what).is_some() {
        let statement = check(quote!(motion_));
        return quote! {
            for motion_ in &inputs_.#name {
                #statement
            }
        };
    }
    check(quote!(inputs_.#name))
}

/// Returns the call that passes the hinge's name to a view, if the view has errors that report it.
pub fn named(hinge: &Hinge) -> Option<TokenStream> {
    let name = &hinge.path;
    quaternion_of(&hinge.kind).map(|_| quote!(.named(#name)))
}

/// Returns statements that check the state and the inputs of a function.
pub fn checked(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    let mut statements = TokenStream::new();
    if !in_state(cx).is_empty() {
        statements.extend(quote!(#mstmm::Chain::check_state(self, state_)?;));
    }
    if in_inputs(cx).next().is_some() {
        statements.extend(quote!(#mstmm::Chain::check_inputs(self, inputs_)?;));
    }
    statements
}

/// Returns the docs of the error of such a function, if there are quaternions.
pub fn error(cx: &EmitContext) -> Vec<String> {
    if checked(cx).is_empty() {
        return Vec::new();
    }
    let text =
        " `Error::InvalidQuaternion` if the length of a quaternion is not between 0.9 and 1.1.";
    vec![String::new(), text.to_owned()]
}

/// Returns the docs of products of quaternions whose lengths are not one.
pub fn products(cx: &EmitContext) -> Vec<String> {
    of_quaternions(
        cx,
        &[
            "",
            " The quaternions of balls that follow each other are multiplied. If a length n is not one, poses and",
            " Jacobians therefore differ from those of a workspace, by terms of the order of n² − 1.",
        ],
    )
}

/// Returns the docs of quaternions whose length is not one, for functions that do not check them.
pub fn near_one(cx: &EmitContext) -> Vec<String> {
    of_quaternions(
        cx,
        &[
            "",
            " Quaternions may have any length near one, as in the stages of an integrator. They are used",
            " unchanged and without checks: for a quaternion of length n with the rotation matrix R, the",
            " matrix (1 − n²) 1 + n² R is used, which is R up to terms of the order of n² − 1. Jacobians and",
            " momenta do so with the product of the quaternions of balls that follow each other.",
        ],
    )
}

/// Returns docs of a chain that has quaternions.
fn of_quaternions(cx: &EmitContext, lines: &[&str]) -> Vec<String> {
    let has_some = !checked(cx).is_empty();
    lines.iter().filter(|_| has_some).map(|&line| line.to_owned()).collect()
}
