//! The kinematics of bodies, and their types.

use super::arrays::usize_literal;
use super::const_expr::value_tokens;
use super::{EmitContext, body};
use crate::compile::layouts;
use crate::model::{Body, BodyFrame, BodyId, Dimension, NamedPoint, PresentPoints, Value};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};
use std::collections::HashSet;

/// Returns the types of bodies with named points.
pub fn types(cx: &EmitContext) -> TokenStream {
    let mut seen = HashSet::new();
    let bodies = cx.chain.physical_bodies().map(|id| &cx.chain.bodies[id]);
    let named = bodies.filter(|body| !body.points.is_empty());
    let first = named.filter(|body| seen.insert(body.result_name.to_string()));
    first.map(|body| of_type(cx, body)).collect()
}

/// Returns the type of the motion of a body, with a lifetime.
fn motion_type(cx: &EmitContext, lifetime: &TokenStream) -> TokenStream {
    let mstmm = &cx.mstmm;
    let name = motion_name(cx);
    quote!(#mstmm::#name<#lifetime, T>)
}

fn motion_name(cx: &EmitContext) -> Ident {
    format_ident!(
        "{}",
        match cx.chain.dimension {
            Dimension::Space => "SpaceMotion",
            Dimension::Plane => "PlaneMotion",
            Dimension::Line => "LineMotion",
        }
    )
}

/// Returns the generic arguments for motion, number of rates and columns.
fn arguments(cx: &EmitContext, lifetime: &TokenStream) -> TokenStream {
    let (mstmm, motion) = (&cx.mstmm, motion_type(cx, lifetime));
    let count = usize_literal(cx.rates().total);
    match cx.has_columns() {
        true => quote!(#motion, #count, #mstmm::RateColumns<#lifetime, T>),
        false => quote!(#motion, #count, #mstmm::NoColumns),
    }
}

/// Returns the type of points.
pub fn point_type(cx: &EmitContext, lifetime: &TokenStream) -> TokenStream {
    let (mstmm, arguments) = (&cx.mstmm, arguments(cx, lifetime));
    quote!(#mstmm::PointKinematics<#arguments>)
}

/// Returns the runtime's type of bodies.
fn common(cx: &EmitContext, body: &Body, lifetime: &TokenStream) -> TokenStream {
    let (mstmm, arguments) = (&cx.mstmm, arguments(cx, lifetime));
    match body.present {
        PresentPoints::ALL => quote!(#mstmm::BodyKinematics<#arguments>),
        PresentPoints { output, com } => {
            quote!(#mstmm::BodyKinematics<#arguments, #mstmm::OptionalPoints<#output, #com>>)
        }
    }
}

fn own_name(cx: &EmitContext, body: &Body) -> Ident {
    format_ident!("{}{}Kinematics", cx.chain.name, body.result_name, span = Span::call_site())
}

/// Returns the type of bodies of one type with named points.
fn of_type(cx: &EmitContext, body: &Body) -> TokenStream {
    let mstmm = &cx.mstmm;
    let (name, visibility) = (own_name(cx, body), &cx.passthrough.visibility);
    let lifetime = quote!('a);
    let (common, point) = (common(cx, body, &lifetime), point_type(cx, &lifetime));
    let motion = motion_type(cx, &lifetime);
    let doc = format!(
        " Kinematics of a body `{}` of [`{}`]: its ends, its centre of mass, its named points and any other point.",
        body.type_name, cx.chain.name
    );
    let fields: Vec<Ident> =
        body.points.iter().map(|NamedPoint { name, .. }| body::field(name)).collect();
    let methods = body.points.iter().zip(&fields).map(|(NamedPoint { name, .. }, field)| {
        let doc = format!(" Returns the point `{name}`, with the frame there.");
        quote! {
            #[doc = #doc]
            #[inline]
            #visibility fn #name(&self) -> #point {
                self.common_.frame(self.#field)
            }
        }
    });
    quote! {
        #[doc = #doc]
        #[derive(Clone, Copy, Debug)]
        #[allow(dead_code, non_snake_case, non_camel_case_types)]
        #visibility struct #name<'a, T: #mstmm::Scalar> {
            common_: #common,
            #(#fields: (
                <#motion as #mstmm::BodyMotion>::Vector,
                <#motion as #mstmm::BodyMotion>::Rotation,
            ),)*
        }
        #[allow(dead_code, non_snake_case)]
        impl<'a, T: #mstmm::Scalar> #name<'a, T> {
            #(#methods)*
        }
        impl<'a, T: #mstmm::Scalar> ::core::ops::Deref for #name<'a, T> {
            type Target = #common;
            #[inline]
            fn deref(&self) -> &#common {
                &self.common_
            }
        }
    }
}

/// Returns the type of a body, with an anonymous lifetime.
fn type_of(cx: &EmitContext, body: &Body) -> TokenStream {
    if body.points.is_empty() {
        return common(cx, body, &quote!('_));
    }
    let name = own_name(cx, body);
    quote!(#name<'_, T>)
}

/// Returns the method for a body; `run` is the first run of its path.
pub fn accessor(cx: &EmitContext, id: BodyId, run: usize) -> TokenStream {
    let (body, visibility) = (&cx.chain.bodies[id], &cx.passthrough.visibility);
    let Body { name, path, .. } = body;
    let (ty, what) = (type_of(cx, body), body::contents(body));
    let stored = Stored::of(cx, id);
    let (statements, result) = (stored.statements(cx), stored.result(cx, run));
    match stored.repetitions {
        None => {
            let doc = format!(
                " Returns the kinematics of body `{path}`: {what}, and any other point by `at`."
            );
            quote! {
                #[doc = #doc]
                #[inline]
                #visibility fn #name(&self) -> #ty {
                    #statements
                    #result
                }
            }
        }
        Some(count) => {
            let doc = format!(
                " Returns the kinematics of body `{path}` in repetition `index` of {count}: {what}, and any other point by `at`."
            );
            quote! {
                #[doc = #doc]
                #[inline]
                #visibility fn #name(
                    &self,
                    index_: ::core::primitive::usize,
                ) -> ::core::option::Option<#ty> {
                    #statements
                    ::core::option::Option::Some(#result)
                }
            }
        }
    }
}

/// Where the values of a body are stored.
struct Stored {
    /// The body.
    id: BodyId,
    /// The index of the body among all bodies in an order in which repeated ones count once.
    entry: usize,
    /// The number of its repetitions, if it belongs to a repeated part.
    repetitions: Option<usize>,
}

impl Stored {
    fn of(cx: &EmitContext, id: BodyId) -> Self {
        let mut bodies = cx.chain.physical_bodies();
        let entry = bodies.position(|body| body == id);
        let entry = entry.unwrap_or_else(|| bug!("a body on no route has no kinematics"));
        let repetitions = cx.chain.repeat_of_body(id).map(|repeat| cx.chain.repeats[repeat].count);
        Stored { id, entry, repetitions }
    }

    /// Returns the statements that read the motion and the frames.
    fn statements(&self, cx: &EmitContext) -> TokenStream {
        let mstmm = &cx.mstmm;
        let (name, motion, frames) = (motion_name(cx), self.motion(cx), self.frames(cx));
        quote! {
            let motion_ = #mstmm::#name::new(#motion);
            #frames
        }
    }

    /// Returns the expression for the kinematics after these statements.
    fn result(&self, cx: &EmitContext, run: usize) -> TokenStream {
        let mstmm = &cx.mstmm;
        let body = &cx.chain.bodies[self.id];
        let frame = |frame| self.frame(cx, body, frame);
        let (output, com) = (frame(BodyFrame::Output), position(&frame(BodyFrame::Com)));
        let columns = self.columns(cx, run);
        let common = quote!(#mstmm::BodyKinematics::new(motion_, #output, #com, #columns));
        if body.points.is_empty() {
            return common;
        }
        let points = body.points.iter().enumerate().map(|(index, point)| {
            let (field, frame) = (body::field(&point.name), frame(BodyFrame::Point(index)));
            quote!(#field: #frame)
        });
        let name = own_name(cx, body);
        quote!(#name { common_: #common, #(#points),* })
    }

    /// Returns the expression for the columns of the Jacobian that are not zero.
    fn columns(&self, cx: &EmitContext, run: usize) -> TokenStream {
        let mstmm = &cx.mstmm;
        if !cx.has_columns() {
            return quote!(#mstmm::NoColumns);
        }
        let run = usize_literal(run);
        let repetition =
            self.repetitions.map_or(quote!(0), |_| quote!(index_ as ::core::primitive::u32));
        quote!(#mstmm::RateColumns::new(&self.columns, Self::RUNS_, #run, #repetition))
    }

    /// Returns the expression for a reference to the stored motion.
    fn motion(&self, cx: &EmitContext) -> TokenStream {
        let mstmm = &cx.mstmm;
        let layout = layouts::bodies(cx.chain);
        let segment = layout.segment_of(self.entry);
        let count = layouts::motion_count(cx.chain.dimension);
        let within = self.entry - segment.first;
        let first = count * (segment.offset + within);
        let [length, at, all, offset, place, times] = [
            count,
            first,
            count * segment.count,
            count * segment.offset,
            within,
            segment.repetitions,
        ]
        .map(usize_literal);
        match self.repetitions {
            None => quote!(&#mstmm::generated::chunks::<_, #length, #at, 1>(&self.motions)[0]),
            Some(_) => quote! {
                #mstmm::generated::chunks::<_, #all, #offset, #times>(&self.motions)
                    .get(index_)?
                    .as_chunks::<#length>().0
                    .get(#place)?
            },
        }
    }

    /// Returns the index of the first stored value of a frame, if parameters change the frame.
    fn first_value(&self, cx: &EmitContext, wanted: BodyFrame) -> Option<usize> {
        let mut first = 0;
        for (id, frame, values) in cx.chain.changing_frames() {
            if (id, frame) == (self.id, wanted) {
                return Some(first);
            }
            first += values.all().count();
        }
        None
    }

    /// Returns the statement that borrows the stored frames of the body's segment and repetition, if it has any.
    fn frames(&self, cx: &EmitContext) -> Option<TokenStream> {
        let frames = cx.chain.bodies[self.id].frames();
        let first = frames.filter_map(|frame| self.first_value(cx, frame)).min()?;
        let layout = layouts::changing_frames(cx.chain);
        let slices = cx.slices(&quote!(self.frames), layout.segment_of(first));
        let index = self.repetitions.map_or(quote!([0]), |_| quote!(.get(index_)?));
        Some(match self.repetitions {
            None => quote!(let frames_ = &#slices #index;),
            Some(_) => quote!(let frames_ = #slices #index;),
        })
    }

    /// Returns the expression for a frame of the body.
    fn frame(&self, cx: &EmitContext, body: &Body, frame: BodyFrame) -> TokenStream {
        let values = cx.chain.frame_values(body, frame);
        let first = self
            .first_value(cx, frame)
            .map(|first| first - layouts::changing_frames(cx.chain).segment_of(first).first);
        let entry = |(number, value): (usize, &Value)| match first {
            Some(first) => {
                let place = usize_literal(first + number);
                quote!(frames_[#place])
            }
            None => {
                let value = value_tokens(cx, value);
                quote!(T::constant(#value))
            }
        };
        let all: Vec<TokenStream> = values.all().enumerate().map(entry).collect();
        let (position, rotation) = all.split_at(values.position.len());
        let rotation = match cx.chain.dimension {
            Dimension::Space if !rotation.is_empty() => {
                let rows = rotation.chunks(3).map(|row| quote!([#(#row),*]));
                quote!([#(#rows),*])
            }
            Dimension::Plane if !rotation.is_empty() => quote!([#(#rotation),*]),
            _ => quote!(()),
        };
        quote!(([#(#position),*], #rotation))
    }
}

/// Returns the position of a frame without its rotation.
fn position(frame: &TokenStream) -> TokenStream {
    quote!(#frame.0)
}
