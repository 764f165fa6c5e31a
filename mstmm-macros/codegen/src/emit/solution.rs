//! Everything at every connection point: the function that computes it, and how it is written.

use super::Plan;
use super::block::{Results, body};
use super::delivery::Deliveries;
use super::docs;
use super::dynamics::check;
use super::looped::{Target, usize_literal};
use super::names::local;
use super::spread::Spread;
use crate::model::Hinge;
use crate::program::Operand;
use proc_macro2::{Delimiter, Group, Ident, TokenStream};
use quote::{format_ident, quote};

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
        /// As [`accelerations_into`](Self::accelerations_into); `at` is as a new one then.
        #[allow(unused_doc_comments, unused_variables, clippy::all)]
        #visibility fn solve_into(
            &self,
            state_: &#state<T>,
            inputs_: &#inputs<T>,
            at_: &mut #workspace<T>,
        ) -> ::core::result::Result<(), #mstmm::Error> #body
    }
}

/// Results that are written as soon as they are known.
fn solved(plan: &Plan) -> Group {
    let (mstmm, program) = (&plan.mstmm, &plan.programs.solution);
    let block = plan.opened(program, true);
    let check = check(plan, program, &block, &plan.programs.pivots);
    let outputs = &program.outputs;
    let mut deliveries = Deliveries::new(program, mstmm);
    deliveries.add(outputs[..3].iter().flatten(), taken_back(plan, &check));
    let [results, _, _, rates, efforts, ..] = &block.arrays[..] else { return empty() };
    let apart = is_prescribed(plan).then_some((3, "rate_accelerations", rates));
    let fields = [(0, "accelerations", results), (4, "efforts", efforts)];
    for (number, field, array) in fields.into_iter().chain(apart) {
        let field = format_ident!("{field}");
        deliveries.add(&outputs[number], quote!(at_.#field.data.0 = [#array];));
    }
    for (number, field) in [(0, "kinetic_energy"), (1, "potential_energy")] {
        let (field, energy) = (format_ident!("{field}"), &block.outputs[5][number]);
        deliveries.add(&outputs[5][number..=number], quote!(at_.#field = #energy;));
    }
    deliveries.add(&outputs[6], closure(plan, &block).unwrap_or_default());
    if !outputs[AT_REST].iter().all(is_known) {
        let at_rest = &block.arrays[AT_REST];
        deliveries.add(&outputs[AT_REST], quote!(at_.at_rest = #at_rest;));
    }
    let mut names = Vec::new();
    for (number, (operand, value)) in
        outputs[NUMBERS].iter().zip(&block.outputs[NUMBERS]).enumerate()
    {
        if is_known(operand) {
            names.push(quote!(_));
            continue;
        }
        let name = local(&format!("n{number}"));
        deliveries.add([operand], quote!(*#name = #value;));
        names.push(quote!(#name));
    }
    let statements = plan.delivering(block, program, deliveries);
    body(
        quote!(let [#(#names),*] = &mut at_.numbers;),
        quote! {
            #statements
            ::core::result::Result::Ok(())
        },
    )
}

/// The test that there are accelerations; where it fails, nothing stays of what has been written.
fn taken_back(plan: &Plan, check: &TokenStream) -> TokenStream {
    let mstmm = &plan.mstmm;
    quote! {
        let checked_ = (|| {
            #check
            ::core::result::Result::Ok(())
        })();
        if let ::core::result::Result::Err(error_) = checked_ {
            #mstmm::generated::take_back(at_, || self.workspace());
            return ::core::result::Result::Err(error_);
        }
    }
}

/// Whether some rates are prescribed, so that the accelerations of all rates are not those that are
/// solved for.
pub fn is_prescribed(plan: &Plan) -> bool {
    plan.chain.hinges.iter().any(Hinge::is_prescribed)
}

/// Where a workspace has the accelerations of all rates.
pub fn rate_accelerations(plan: &Plan) -> Ident {
    format_ident!("{}", if is_prescribed(plan) { "rate_accelerations" } else { "accelerations" })
}

/// Whether a result is the same in every state.
fn is_known(operand: &Operand) -> bool {
    match operand {
        Operand::Number(_) => true,
        Operand::Minus(inner) => is_known(inner),
        Operand::Symbol(_) | Operand::Named(_) | Operand::Repeated => false,
    }
}

/// What a workspace starts with: the results of a group that are the same in every state, zeros for
/// all others.
pub fn at_first(plan: &Plan, group: usize) -> TokenStream {
    let outputs = &plan.programs.solution.outputs[group];
    let count = usize_literal(if group == NUMBERS {
        Spread::numbers_of_points(plan).total
    } else {
        outputs.len()
    });
    let zeros = quote!([T::constant(0.0); #count]);
    let is_zero = |operand: &Operand| matches!(operand, Operand::Number(number) if *number == 0.0);
    let known = outputs.iter().enumerate().filter(|(_, x)| is_known(x) && !is_zero(x));
    let known: Vec<TokenStream> = known
        .map(|(number, operand)| {
            let (number, value) = (usize_literal(number), plan.operand(operand));
            quote!((#number, #value))
        })
        .collect();
    if known.is_empty() || !plan.chain.repeats.is_empty() {
        return zeros;
    }
    let (c, mstmm) = (local("c"), &plan.mstmm);
    quote!({
        let #c = T::constant;
        #mstmm::generated::with_known(#zeros, &[#(#known),*])
    })
}

/// The groups of what connection points are read off.
pub const NUMBERS: usize = 7;
pub const AT_REST: usize = 8;

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

/// Results of a chain with repeated parts: loops write them where they belong.
fn solved_in_loops(plan: &Plan) -> Group {
    let program = &plan.programs.solution;
    let (freedoms, rates) = (Spread::freedoms(plan), Spread::rates(plan));
    let apart = is_prescribed(plan).then(|| (3, rates.clone(), quote!(at_.rate_accelerations)));
    let targets = [
        (0, freedoms, quote!(at_.accelerations)),
        (4, rates, quote!(at_.efforts)),
        (NUMBERS, Spread::numbers_of_points(plan), quote!(at_.numbers)),
    ];
    let targets = targets.into_iter().chain(apart);
    let target = |(group, spread, place)| Target { group, spread, place: Some(place) };
    let targets: Vec<Target> = targets.map(target).collect();
    let block = plan.step(program, &targets, true);
    let check = taken_back(plan, &check(plan, program, &block, &plan.programs.pivots));
    let closure = closure(plan, &block);
    let at_rest = &block.arrays[AT_REST];
    let energies = &block.outputs[5];
    let (kinetic, potential) = (&energies[0], &energies[1]);
    body(
        block.statements,
        quote! {
            #check
            #closure
            at_.kinetic_energy = #kinetic;
            at_.potential_energy = #potential;
            at_.at_rest = #at_rest;
            ::core::result::Result::Ok(())
        },
    )
}
