//! Everything at every connection point: the function that computes it, and how it is written.

use super::Plan;
use super::block::{Results, body};
use super::delivery::Deliveries;
use super::docs;
use super::dynamics::check;
use super::looped::{Target, usize_literal};
use super::names::local;
use super::spread::{Spread, numbers_of_point};
use crate::model::Dimension;
use proc_macro2::{Delimiter, Group, Ident, TokenStream};
use quote::{format_ident, quote};
use std::ops::Range;

/// The method that computes everything.
pub fn solution(plan: &Plan) -> TokenStream {
    let mstmm = &plan.mstmm;
    let (state, inputs) = (&plan.names.state, &plan.names.inputs);
    let (workspace, visibility) = (&plan.names.workspace, &plan.surface.visibility);
    let program = &plan.programs.solution;
    let body = if plan.chain.repeats.is_empty() { solved(plan) } else { solved_in_loops(plan) };
    let cost = docs::cost(program);
    quote! {
        /// Everything: accelerations, efforts, energies and, at every connection point, pose,
        /// velocity and the state vector `z`, written into `at`.
        ///
        #(#[doc = #cost])*
        ///
        /// # Errors
        ///
        /// As [`accelerations_into`](Self::accelerations_into); `at` is not touched then.
        #[allow(unused_doc_comments, unused_variables, clippy::all)]
        #visibility fn solve_into(
            &self,
            state_: &#state<T>,
            inputs_: &#inputs<T>,
            at_: &mut #workspace<T>,
        ) -> ::core::result::Result<(), #mstmm::Error> #body
    }
}

/// Results that are written as soon as they are known: once the accelerations are, nothing fails.
fn solved(plan: &Plan) -> Group {
    let program = &plan.programs.solution;
    let block = plan.opened(program, true);
    let check = check(plan, program, &block, &plan.programs.pivots);
    let outputs = &program.outputs;
    let mut deliveries = Deliveries::new(program, outputs[..3].iter().flatten(), check);
    let [results, _, _, rates, efforts, ..] = &block.arrays[..] else { return empty() };
    for (number, field, array) in
        [(0, "accelerations", results), (3, "rate_accelerations", rates), (4, "efforts", efforts)]
    {
        let field = format_ident!("{field}");
        deliveries.add(&outputs[number], quote!(at_.#field.data.0 = [#array];));
    }
    for (number, field) in [(0, "kinetic_energy"), (1, "potential_energy")] {
        let (field, energy) = (format_ident!("{field}"), &block.outputs[5][number]);
        deliveries.add(&outputs[5][number..=number], quote!(at_.#field = #energy;));
    }
    deliveries.add(&outputs[6], closure(plan, &block).unwrap_or_default());
    let each = numbers_of_point(plan.chain.dimension);
    let count = block.outputs[7].len() / each;
    let names: Vec<Ident> = (0..count).map(|number| local(&format!("point{number}"))).collect();
    for (name, first) in names.iter().zip((0..).step_by(each)) {
        for (field, range) in fields(plan.chain.dimension) {
            let field = format_ident!("set_{field}");
            let range = first + range.start..first + range.end;
            let numbers = &block.outputs[7][range.clone()];
            deliveries.add(&outputs[7][range], quote!(#name.#field([#(#numbers),*]);));
        }
    }
    let statements = plan.delivering(block, program, deliveries);
    body(
        quote!(let [#(#names),*] = &mut at_.points;),
        quote! {
            #statements
            ::core::result::Result::Ok(())
        },
    )
}

/// The undetermined reactions of a closed chain.
fn closure(plan: &Plan, block: &Results) -> Option<TokenStream> {
    let mstmm = &plan.mstmm;
    plan.programs.held.map(|_| {
        let wrenches = block.outputs[6].chunks(6).map(|wrench| quote!([#(#wrench),*]));
        quote!(at_.closure = #mstmm::generated::closure([#(#wrenches),*]);)
    })
}

fn empty() -> Group {
    Group::new(Delimiter::Brace, TokenStream::new())
}

/// Results of a chain with repeated parts: loops fill arrays, which are written in the end.
fn solved_in_loops(plan: &Plan) -> Group {
    let program = &plan.programs.solution;
    let (freedoms, rates) = (Spread::freedoms(plan), Spread::rates(plan));
    let targets = [(0, freedoms), (3, rates.clone()), (4, rates), (7, Spread::points(plan))];
    let targets = targets.map(|(group, spread)| Target { group, spread });
    let block = plan.step(program, &targets, true);
    let check = check(plan, program, &block, &plan.programs.pivots);
    let points = points(plan, &block);
    let closure = closure(plan, &block);
    let [results, _, _, rates, efforts, ..] = &block.arrays[..] else { return empty() };
    let energies = &block.outputs[5];
    let (kinetic, potential) = (&energies[0], &energies[1]);
    body(
        block.statements,
        quote! {
            #check
            at_.accelerations.data.0 = [#results];
            at_.rate_accelerations.data.0 = [#rates];
            at_.efforts.data.0 = [#efforts];
            #closure
            at_.kinetic_energy = #kinetic;
            at_.potential_energy = #potential;
            #points
            ::core::result::Result::Ok(())
        },
    )
}

/// The parts of a connection point, as its setters name them, and where they are among its numbers.
fn fields(dimension: Dimension) -> Vec<(&'static str, Range<usize>)> {
    let sizes: &[(&str, usize)] = match dimension {
        Dimension::Space => &[
            ("position", 3),
            ("orientation", 9),
            ("velocity", 3),
            ("angular_velocity", 3),
            ("acceleration", 3),
            ("angular_acceleration", 3),
            ("moment", 3),
            ("force", 3),
        ],
        Dimension::Plane => &[
            ("position", 2),
            ("orientation", 2),
            ("velocity", 2),
            ("angular_velocity", 1),
            ("acceleration", 2),
            ("angular_acceleration", 1),
            ("moment", 1),
            ("force", 2),
        ],
        Dimension::Line => &[("position", 1), ("velocity", 1), ("acceleration", 1), ("force", 1)],
    };
    let mut first = 0;
    let mut next = |&(name, size): &(&'static str, usize)| {
        let range = first..first + size;
        first += size;
        (name, range)
    };
    sizes.iter().map(&mut next).collect()
}

/// Writes all connection points from their array.
fn points(plan: &Plan, block: &Results) -> TokenStream {
    let each = numbers_of_point(plan.chain.dimension);
    let names: Vec<Ident> = (0..each).map(|number| local(&format!("p{number}"))).collect();
    let parts = fields(plan.chain.dimension).into_iter().map(|(field, range)| {
        let (field, numbers) = (format_ident!("set_{field}"), &names[range]);
        quote!(point_.#field([#(#numbers),*]);)
    });
    let (numbers, each) = (&block.arrays[7], usize_literal(each));
    quote! {
        for (point_, &[#(#names),*]) in
            ::core::iter::zip(&mut at_.points, #numbers.as_chunks::<#each>().0)
        {
            #(#parts)*
        }
    }
}
