//! The answers by their names: the implementation of `Answers`.

use super::super::EmitContext;
use super::super::arrays::usize_literal;
use super::super::kinematics_bodies::point_type;
use crate::compile::layouts;
use crate::model::{Answer, Body, BodyId, Dimension, Request};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// Returns the implementation of `Answers`.
pub fn emit(cx: &EmitContext) -> TokenStream {
    let (mstmm, name) = (&cx.mstmm, &cx.names.chain);
    let (state, inputs) = (&cx.names.state, &cx.names.inputs);
    let arms = arms(cx);
    let (variants, values): (Vec<_>, Vec<_>) =
        arms.iter().map(|(name, value)| (name, value)).unzip();
    let columns = cx.chain.requests.contains(&Request::Regressor).then(|| {
        let columns = usize_literal(layouts::dynamic_parameters(cx.chain).total);
        quote!(const DYNAMIC_PARAMETER_COUNT: ::core::primitive::usize = #columns;)
    });
    let frames = cx.chain.physical_bodies().map(|id| {
        let names = frames(&cx.chain.bodies[id]).into_iter().map(|(name, _)| name);
        quote!(&[#(#names),*])
    });
    let answer = (!arms.is_empty()).then(|| {
        quote! {
            const ANSWERS_: &'static [#mstmm::description::Answer] =
                &[#(#mstmm::description::Answer::#variants),*];
            fn answer(
                &self,
                answer_: #mstmm::description::Answer,
                state_: &#state<T>,
                inputs_: &#inputs<T>,
                given_: &[T],
                result_: &mut [T],
            ) -> ::core::option::Option<::core::result::Result<(), #mstmm::Error>> {
                use #mstmm::generated::answers::*;
                match answer_ {
                    #(Answer_::#variants => #values)*
                    _ => ::core::option::Option::None,
                }
            }
        }
    });
    let kinematics = cx.compiled.find(Answer::Kinematics);
    let (frame, motion) = (kinematics.map(|_| frame(cx)), kinematics.map(|_| motion(cx)));
    quote! {
        #[allow(clippy::all, unused_imports, unused_variables)]
        impl<T: #mstmm::Scalar> #mstmm::Answers for #name<T> {
            #columns
            const FRAMES_: &'static [&'static [&'static ::core::primitive::str]] = &[#(#frames),*];
            #answer
            #motion
        }
        #frame
    }
}

/// The variant of an answer, with the code that computes it.
type AnswerArm = (Ident, TokenStream);

/// Returns the arms of all answers that the chain has.
fn arms(cx: &EmitContext) -> Vec<AnswerArm> {
    [of_state(cx), of_vectors(cx), of_several_parts(cx)].concat()
}

/// Returns the arms of the vectors and matrices in a state.
fn of_state(cx: &EmitContext) -> Vec<AnswerArm> {
    let has = |answer| cx.compiled.find(answer).is_some();
    let asks = |request| cx.chain.requests.contains(&request);
    let inverse_mass_matrix = has(Answer::InverseMassMatrix)
        || (asks(Request::MassMatrix) && has(Answer::InverseMassMatrixTimes));
    let answers = [
        (has(Answer::BiasEfforts), "BiasEfforts", "bias_efforts"),
        (has(Answer::GravityEfforts), "GravityEfforts", "gravity_efforts"),
        (has(Answer::PassiveEfforts), "PassiveEfforts", "passive_efforts"),
        (asks(Request::MassMatrix), "MassMatrix", "mass_matrix"),
        (inverse_mass_matrix, "InverseMassMatrix", "inverse_mass_matrix"),
        (asks(Request::Momentum), "MomentumMatrix", "momentum_matrix"),
        (asks(Request::CoriolisMatrix), "CoriolisMatrix", "coriolis_matrix"),
    ];
    let arguments = quote!(state_, inputs_);
    present(answers.map(|(is_there, name, method)| (is_there, name, call(method, &arguments))))
}

/// Returns the arms of the answers to a vector that the caller gives.
fn of_vectors(cx: &EmitContext) -> Vec<AnswerArm> {
    let has = |answer| cx.compiled.find(answer).is_some();
    let asks = |request| cx.chain.requests.contains(&request);
    let by_accelerations = &quote!(state_, vector_, inputs_);
    let by_vector = &quote!(state_, inputs_, vector_);
    let mass_matrix = asks(Request::MassMatrix);
    let times = mass_matrix && has(Answer::MassMatrixTimes);
    let inverse_times = mass_matrix && has(Answer::InverseMassMatrixTimes);
    let coriolis_times = asks(Request::CoriolisMatrix);
    let answers = [
        (has(Answer::InverseDynamics), "InverseDynamics", "inverse_dynamics", by_accelerations),
        (asks(Request::Regressor), "Regressor", "regressor", by_accelerations),
        (times, "MassMatrixTimes", "mass_matrix_times", by_vector),
        (inverse_times, "InverseMassMatrixTimes", "inverse_mass_matrix_times", by_vector),
        (coriolis_times, "CoriolisMatrixTimes", "coriolis_matrix_times", by_vector),
    ];
    present(answers.map(|(is_there, name, method, arguments)| {
        let call = call(method, arguments);
        let code = quote!(match given(given_) {
            ::core::option::Option::Some(ref vector_) => #call
            ::core::option::Option::None => ::core::option::Option::None,
        });
        (is_there, name, code)
    }))
}

/// Returns the arms of the answers that consist of several parts.
fn of_several_parts(cx: &EmitContext) -> Vec<AnswerArm> {
    let asks = |request| cx.chain.requests.contains(&request);
    present([
        (asks(Request::Regressor), "DynamicParameters", dynamic_parameters()),
        (asks(Request::Derivatives), "InverseDynamicsDerivatives", derivatives(cx)),
        (asks(Request::Linearize), "Linearize", linearize(cx)),
        (asks(Request::Push), "Push", push(cx)),
        (asks(Request::Pull), "Pull", pull(cx)),
        (asks(Request::Momentum), "Momentum", momentum(cx)),
    ])
}

/// Returns the arms of the answers that are there.
fn present<const N: usize>(answers: [(bool, &str, TokenStream); N]) -> Vec<AnswerArm> {
    let present = answers.into_iter().filter(|(is_there, ..)| *is_there);
    present.map(|(_, name, code)| (format_ident!("{name}"), code)).collect()
}

/// Returns the code that copies the result of a method with these arguments.
fn call(method: &str, arguments: &TokenStream) -> TokenStream {
    let method = format_ident!("{method}_into");
    quote!(written(result_, |it_| self.#method(#arguments, it_)),)
}

/// Returns a block that ends with an error of a call, or copies parts of its results.
fn block(before: &TokenStream, call: &TokenStream, parts: &TokenStream) -> TokenStream {
    quote!({
        #before
        match #call {
            ::core::result::Result::Ok(_) => {
                write_parts(result_, [#parts]).map(::core::result::Result::Ok)
            }
            ::core::result::Result::Err(error_) => {
                ::core::option::Option::Some(::core::result::Result::Err(error_))
            }
        }
    })
}

/// Returns the code that copies the dynamic parameters.
fn dynamic_parameters() -> TokenStream {
    quote! {
        write_parts(result_, [self.dynamic_parameters().as_slice()])
            .map(::core::result::Result::Ok),
    }
}

fn derivatives(cx: &EmitContext) -> TokenStream {
    let derivatives = &cx.names.derivatives;
    block(
        &quote! {
            let vector_ = given(given_)?;
            let mut it_ = <#derivatives<T> as ::core::default::Default>::default();
        },
        &quote!(self.inverse_dynamics_derivatives_into(state_, &vector_, inputs_, &mut it_)),
        &quote! {
            it_.by_coordinates.as_slice(),
            it_.by_rates.as_slice(),
            it_.by_accelerations.as_slice(),
        },
    )
}

fn linearize(cx: &EmitContext) -> TokenStream {
    let linearization = &cx.names.linearization;
    block(
        &quote!(let mut it_ = <#linearization<T> as ::core::default::Default>::default();),
        &quote!(self.linearize_into(state_, inputs_, &mut it_)),
        &quote! {
            it_.accelerations.as_slice(),
            it_.inverse_mass_matrix.as_slice(),
            it_.by_coordinates.as_slice(),
            it_.by_rates.as_slice(),
            it_.by_inputs.as_slice(),
            it_.by_parameters.as_slice(),
            it_.a().as_slice(),
            it_.b().as_slice(),
        },
    )
}

fn push(cx: &EmitContext) -> TokenStream {
    let (mstmm, variation, rates) =
        (&cx.mstmm, &cx.names.variation, usize_literal(cx.rates().total));
    block(
        &quote! {
            let mut it_ = <#variation<T> as ::core::default::Default>::default();
            read_parts(given_, [
                it_.coordinates.as_mut_slice(),
                it_.rates.as_mut_slice(),
                it_.inputs.as_mut_slice(),
                it_.parameters.as_mut_slice(),
            ])?;
            let mut accelerations_ = #mstmm::generated::vector([T::constant(0.0); #rates]);
            let mut change_ = accelerations_;
        },
        &quote!(self.push_into(state_, inputs_, &it_, &mut accelerations_, &mut change_)),
        &quote!(accelerations_.as_slice(), change_.as_slice()),
    )
}

fn pull(cx: &EmitContext) -> TokenStream {
    let (mstmm, variation, rates) =
        (&cx.mstmm, &cx.names.variation, usize_literal(cx.rates().total));
    block(
        &quote! {
            let vector_ = given(given_)?;
            let mut it_ = <#variation<T> as ::core::default::Default>::default();
            let mut accelerations_ = #mstmm::generated::vector([T::constant(0.0); #rates]);
        },
        &quote!(self.pull_into(state_, inputs_, &vector_, &mut accelerations_, &mut it_)),
        &quote! {
            accelerations_.as_slice(),
            it_.coordinates.as_slice(),
            it_.rates.as_slice(),
            it_.inputs.as_slice(),
            it_.parameters.as_slice(),
        },
    )
}

fn momentum(cx: &EmitContext) -> TokenStream {
    let one = |field: &str| {
        let field = format_ident!("{field}");
        quote!(::core::slice::from_ref(&it_.#field))
    };
    let vector = |field: &str| {
        let field = format_ident!("{field}");
        quote!(it_.#field.as_slice())
    };
    let mass = one("mass");
    let parts = match cx.chain.dimension {
        Dimension::Space => {
            vec![mass, vector("center_of_mass"), vector("linear"), vector("angular")]
        }
        Dimension::Plane => vec![mass, vector("center_of_mass"), vector("linear"), one("angular")],
        Dimension::Line => vec![mass, one("center_of_mass"), one("linear")],
    };
    quote!(match self.momentum(state_, inputs_) {
        ::core::result::Result::Ok(it_) => {
            write_parts(result_, [#(#parts),*]).map(::core::result::Result::Ok)
        }
        ::core::result::Result::Err(error_) => {
            ::core::option::Option::Some(::core::result::Result::Err(error_))
        }
    })
}

/// Returns the names of the frames of a body, each with the name of its accessor.
pub fn frames(body: &Body) -> Vec<(String, Ident)> {
    let common = [("input", true), ("output", body.present.output), ("com", body.present.com)];
    let common = common.into_iter().filter(|(_, is_there)| *is_there);
    let common = common.map(|(name, _)| (name.to_owned(), format_ident!("{name}")));
    let named = body.points.iter().map(|point| (point.name.to_string(), point.name.clone()));
    common.chain(named).collect()
}

/// Returns the method that finds a frame in the kinematics.
fn frame(cx: &EmitContext) -> TokenStream {
    let (mstmm, name, kinematics) = (&cx.mstmm, &cx.names.chain, &cx.names.kinematics);
    let point = point_type(cx, &quote!('_));
    let bodies: Vec<BodyId> = cx.chain.physical_bodies().collect();
    let arms = bodies.into_iter().enumerate().flat_map(|(row, id)| {
        let (body, row) = (&cx.chain.bodies[id], usize_literal(row));
        let accessor = &body.name;
        let at = match cx.chain.repeat_of_body(id) {
            Some(_) => quote!(at_.#accessor(repetition_)?),
            None => quote!(at_.#accessor()),
        };
        frames(body)
            .into_iter()
            .enumerate()
            .map(|(number, (_, method))| {
                let number = usize_literal(number);
                quote!([#row, #number] => #at.#method(),)
            })
            .collect::<Vec<_>>()
    });
    quote! {
        #[allow(dead_code, unused_variables, clippy::all)]
        impl<T: #mstmm::Scalar> #name<T> {
            /// Returns a frame in the kinematics.
            fn frame_(
                at_: &#kinematics<T>,
                [row_, repetition_, number_]: [::core::primitive::usize; 3],
            ) -> ::core::option::Option<#point> {
                ::core::option::Option::Some(match [row_, number_] {
                    #(#arms)*
                    _ => return ::core::option::Option::None,
                })
            }
        }
    }
}

/// Returns the method that computes the motion of a frame.
fn motion(cx: &EmitContext) -> TokenStream {
    let (mstmm, kinematics) = (&cx.mstmm, &cx.names.kinematics);
    let (state, inputs) = (&cx.names.state, &cx.names.inputs);
    let jacobian = match cx.has_columns() {
        true => {
            quote!(#mstmm::generated::answers::JacobianSlice::write_jacobian(&point_, jacobian_)?)
        }
        false => quote!(return ::core::option::Option::None),
    };
    quote! {
        fn motion_(
            &self,
            state_: &#state<T>,
            inputs_: &#inputs<T>,
            frame_: [::core::primitive::usize; 3],
            jacobian_: &mut [T],
        ) -> ::core::option::Option<::core::result::Result<#mstmm::FrameMotion<T>, #mstmm::Error>> {
            let mut at_ = <#kinematics<T> as ::core::default::Default>::default();
            if let ::core::result::Result::Err(error_) =
                self.kinematics_into(state_, inputs_, &mut at_)
            {
                return ::core::option::Option::Some(::core::result::Result::Err(error_));
            }
            let point_ = Self::frame_(&at_, frame_)?;
            if !jacobian_.is_empty() {
                #jacobian;
            }
            ::core::option::Option::Some(::core::result::Result::Ok(
                ::core::convert::From::from(point_),
            ))
        }
    }
}
