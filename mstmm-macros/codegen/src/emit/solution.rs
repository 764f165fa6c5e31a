//! The results that are asked for: the function that computes them, and how they are written.

use super::Plan;
use super::block::{Results, body};
use super::delivery::Deliveries;
use super::docs;
use super::dynamics::{Check, check};
use super::looped::{Target, usize_literal};
use super::names::{Variables, helper};
use super::quaternions;
use super::spread::Spread;
use crate::compile::groups;
use crate::program::Operand;
use proc_macro2::{Group, Ident, TokenStream};
use quote::{format_ident, quote};

/// Where a workspace has the energies.
const ENERGIES: [&str; 2] = ["kinetic_energy", "potential_energy"];

/// The method `solve_into`.
pub fn solution(plan: &Plan) -> TokenStream {
    let mstmm = &plan.mstmm;
    let (state, inputs) = (&plan.names.state, &plan.names.inputs);
    let (workspace, visibility) = (&plan.names.workspace, &plan.surface.visibility);
    let program = &plan.programs.solution;
    let body = if plan.chain.repeats.is_empty() { solved(plan) } else { solved_in_loops(plan) };
    let (cost, errors) = (docs::cost(program), quaternions::error(plan));
    let doc = format!(" Writes into `at`: {}.", docs::results(plan));
    quote! {
        #[doc = #doc]
        ///
        #(#[doc = #cost])*
        ///
        /// # Errors
        ///
        /// As [`accelerations_into`](Self::accelerations_into); `at` is then as
        /// [`workspace`](Self::workspace) makes it: results of earlier calls are gone.
        #(#[doc = #errors])*
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
    deliveries.add(outputs[..groups::ALL_RATES].iter().flatten(), found(plan, &check));
    for (group, field) in rates(plan) {
        let array = &block.arrays[group];
        deliveries.add(&outputs[group], quote!(at_.#field.data.0 = [#array];));
    }
    let energies = outputs[groups::ENERGIES].iter().zip(&block.outputs[groups::ENERGIES]);
    for ((operand, energy), field) in energies.zip(ENERGIES) {
        let field = format_ident!("{field}");
        deliveries.add([operand], quote!(at_.#field = #energy;));
    }
    deliveries.add(&outputs[groups::UNDETERMINED], closure(plan, &block).unwrap_or_default());
    if !outputs[groups::AT_REST].iter().all(is_known) {
        let at_rest = &block.arrays[groups::AT_REST];
        deliveries.add(&outputs[groups::AT_REST], quote!(at_.at_rest = #at_rest;));
    }
    let mut names = Vec::new();
    for (number, (operand, value)) in
        outputs[groups::NUMBERS].iter().zip(&block.outputs[groups::NUMBERS]).enumerate()
    {
        if is_known(operand) {
            names.push(quote!(_));
            continue;
        }
        let name = helper(&format!("n{number}"));
        deliveries.add([operand], quote!(*#name = #value;));
        names.push(quote!(#name));
    }
    let statements = plan.delivering(block, program, deliveries);
    let given = taken_back(plan, &given(plan, &check));
    body(
        quote! {
            #given
            let [#(#names),*] = &mut at_.numbers;
        },
        quote! {
            #statements
            ::core::result::Result::Ok(())
        },
    )
}

/// Statements that fail where what is given is refused.
fn given(plan: &Plan, check: &Check) -> TokenStream {
    let mut statements = quaternions::checked(plan);
    statements.extend(check.given.clone());
    statements
}

/// The test of what has been found: where it fails, nothing stays of what has been written.
fn found(plan: &Plan, check: &Check) -> TokenStream {
    let mstmm = &plan.mstmm;
    let Check { repeated_pivots, regular, error, repeated_results, .. } = check;
    let pivots = taken_back(plan, repeated_pivots);
    let results = repeated_results.as_ref().map(|statements| taken_back(plan, statements));
    quote! {
        #pivots
        if !#regular {
            let error_ = #error;
            #mstmm::generated::take_back(at_, || self.workspace());
            return ::core::result::Result::Err(error_);
        }
        #results
    }
}

/// Statements that may fail, if there are any: where they do, nothing stays of what has been written.
fn taken_back(plan: &Plan, statements: &TokenStream) -> TokenStream {
    if statements.is_empty() {
        return TokenStream::new();
    }
    let mstmm = &plan.mstmm;
    quote! {
        let checked_ = (|| {
            #statements
            ::core::result::Result::Ok(())
        })();
        if let ::core::result::Result::Err(error_) = checked_ {
            #mstmm::generated::take_back(at_, || self.workspace());
            return ::core::result::Result::Err(error_);
        }
    }
}

/// The groups with a number for each rate, and where a workspace has them.
fn rates(plan: &Plan) -> Vec<(usize, Ident)> {
    let mut groups = vec![
        (groups::ACCELERATIONS, format_ident!("accelerations")),
        (groups::EFFORTS, format_ident!("efforts")),
    ];
    if plan.chain.has_prescribed_hinges() {
        groups.push((groups::ALL_RATES, plan.rate_accelerations()));
    }
    groups
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
    let count = usize_literal(if group == groups::NUMBERS {
        Spread::numbers_of_points(plan).total
    } else {
        outputs.len()
    });
    let zeros = quote!([T::constant(0.0); #count]);
    let is_zero = |operand: &Operand| matches!(operand, Operand::Number(number) if *number == 0.0);
    let known = outputs.iter().enumerate().filter(|(_, x)| is_known(x) && !is_zero(x));
    let known: Vec<TokenStream> = known
        .map(|(number, operand)| {
            let (number, value) =
                (usize_literal(number), plan.operand(&Variables::default(), operand));
            quote!((#number, #value))
        })
        .collect();
    if known.is_empty() || !plan.chain.repeats.is_empty() {
        return zeros;
    }
    let (c, mstmm) = (helper("c"), &plan.mstmm);
    quote!({
        let #c = T::constant;
        #mstmm::generated::with_known(#zeros, &[#(#known),*])
    })
}

/// The undetermined reactions of a closed chain.
fn closure(plan: &Plan, block: &Results) -> Option<TokenStream> {
    let mstmm = &plan.mstmm;
    plan.programs.held.map(|_| {
        let wrenches =
            block.outputs[groups::UNDETERMINED].chunks(6).map(|wrench| quote!([#(#wrench),*]));
        quote!(at_.closure = #mstmm::generated::closure([#(#wrenches),*]);)
    })
}

/// Results of a chain with repeated parts: loops write them where they belong.
fn solved_in_loops(plan: &Plan) -> Group {
    let program = &plan.programs.solution;
    let mut targets = vec![Target {
        group: groups::NUMBERS,
        spread: Spread::numbers_of_points(plan),
        existing: Some(quote!(at_.numbers)),
    }];
    for (group, field) in rates(plan) {
        let all = group != groups::ACCELERATIONS;
        let spread = if all { Spread::rates(plan) } else { Spread::freedoms(plan) };
        targets.push(Target { group, spread, existing: Some(quote!(at_.#field)) });
    }
    let block = plan.step(program, &targets, true);
    let check = check(plan, program, &block, &plan.programs.pivots);
    let found = found(plan, &check);
    let closure = closure(plan, &block);
    let at_rest = &block.arrays[groups::AT_REST];
    let energies = block.outputs[groups::ENERGIES].iter().zip(ENERGIES).map(|(energy, field)| {
        let field = format_ident!("{field}");
        quote!(at_.#field = #energy;)
    });
    let mut statements = taken_back(plan, &given(plan, &check));
    statements.extend(block.statements);
    body(
        statements,
        quote! {
            #found
            #closure
            #(#energies)*
            at_.at_rest = #at_rest;
            ::core::result::Result::Ok(())
        },
    )
}
