//! Prints the loops of a procedure. A loop zips one iterator per array that it reads or writes.

use super::arguments;
use super::arrays::usize_literal;
use super::loop_inputs::{LoopInput, pattern, zipped};
use super::names::helper;
use super::printer::{Printer, flag};
use crate::program::{
    Array, ArrayId, ArrayRole, ArraySlice, CarriedValue, ForLoop, Operand, Segment, Step, ValueId,
};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};

/// Declares the flags of the pivot tests and the arrays of values that loops store for later loops.
pub fn declarations(printer: &Printer) -> TokenStream {
    let mstmm = &printer.cx.mstmm;
    let loops = printer.body.iter().filter_map(|step| match step {
        Step::Loop(loop_) => Some(loop_.body.iter()),
        _ => None,
    });
    let flags = loops.flatten().filter_map(|step| match step {
        Step::CheckPivot { check, .. } => Some(flag(*check)),
        _ => None,
    });
    let locals = printer.procedure.arrays.enumerate().filter(|(id, array)| {
        let is_written = printer.body.iter().any(|step| step.stores_into(*id));
        matches!(array.role, ArrayRole::Local(_)) && is_written
    });
    let locals = locals.map(|(id, array)| {
        let (store, segment) = (local(id), &array.layout.segments[0]);
        let repetitions = usize_literal(segment.repetitions);
        let entries = 0..segment.count;
        let columns = entries.filter(|&entry| printer.varying.entry(id, entry)).count();
        let [once, columns] = [segment.count - columns, columns];
        let [count, of_columns] = [once, columns].map(usize_literal);
        let values = match columns {
            0 => quote!([T; #count]),
            _ => quote!(([T; #count], [C; #of_columns])),
        };
        quote! {
            let mut #store =
                #mstmm::generated::LoopStore::<#values, #repetitions>::new_const();
        }
    });
    quote! {
        #(let mut #flags = <T::Mask as #mstmm::Mask>::splat(true);)*
        #(#locals)*
    }
}

fn local(array: ArrayId) -> Ident {
    helper(&format!("store{}", array.index()))
}

/// Prints a loop.
pub fn print(printer: &Printer, loop_: &ForLoop) -> TokenStream {
    let LoopAccess { inputs, taken, writes } = accesses(printer, loop_);
    let computed: Vec<Step> =
        loop_.body.iter().filter(|step| matches!(step, Step::Compute(_))).cloned().collect();
    let mut sections = printer.writer();
    printer.write_steps(&mut sections, &computed, |_| {
        bug!("the steps of a loop other than sections are printed separately")
    });
    let sections = sections.finish();
    let variable = |value| printer.variables.get(value);
    let exits: Vec<&Ident> = loop_.carries.iter().map(|carry| variable(carry.exit)).collect();
    let phis = loop_.carries.iter().map(|carry| variable(carry.phi));
    let of_type = |carry: &CarriedValue, operand: &Operand| {
        printer.operand_of(operand, printer.varying.value(carry.phi))
    };
    let inits = loop_.carries.iter().map(|carry| of_type(carry, &carry.init));
    let nexts = loop_.carries.iter().map(|carry| of_type(carry, &carry.next));
    let (pattern, iterator) = zipped(inputs, &usize_literal(loop_.repetitions), loop_.inward);
    let taken_apart = taken_apart(printer, loop_);
    quote! {
        #(let mut #exits = #inits;)*
        #taken_apart
        for #pattern in #iterator {
            #taken
            #(let #phis = #exits;)*
            #sections
            #writes
            (#(#exits,)*) = (#(#nexts,)*);
        }
    }
}

/// What a repetition reads and writes.
struct LoopAccess {
    inputs: Vec<LoopInput>,
    /// The statements at the start that take the values of arguments.
    taken: TokenStream,
    /// The statements at the end that store values and test pivots.
    writes: TokenStream,
}

/// Prints what a repetition of a loop reads and writes.
fn accesses(printer: &Printer, loop_: &ForLoop) -> LoopAccess {
    let mstmm = &printer.cx.mstmm;
    let (mut inputs, mut taken, mut writes) = (Vec::new(), TokenStream::new(), TokenStream::new());
    for step in &loop_.body {
        match step {
            Step::Load { from, into } => match printer.array(from).role {
                ArrayRole::Local(_) => inputs.push(load_local(printer, from, into)),
                ArrayRole::Argument(argument) => {
                    let (input, statements) =
                        arguments::loop_input(printer, (argument, from), into);
                    inputs.push(input);
                    taken.extend(statements);
                }
                ArrayRole::Result(_) => bug!("a loop reads a result"),
            },
            Step::Store { to, values } => match printer.array(to).role {
                ArrayRole::Local(_) => {
                    let (store, values) = (local(to.array), values.iter().flatten());
                    let values = of_local(printer, to.array, values.map(|it| printer.operand(it)));
                    writes.extend(quote!(_ = #store.try_push(#values);));
                }
                _ => {
                    let (input, statements) = write(printer, loop_, to, values);
                    inputs.push(input);
                    writes.extend(statements);
                }
            },
            Step::CheckPivot { check, value, scale } => {
                let flag = flag(*check);
                let [value, scale] = [value, scale].map(|operand| printer.operand(operand));
                writes.extend(
                    quote!(#flag = #flag & !#mstmm::generated::pivot_vanishes(#value, #scale);),
                );
            }
            Step::Compute(_) => {}
            Step::CheckArguments(_)
            | Step::TestBounds(_)
            | Step::Loop(_)
            | Step::CheckResults(_) => {
                bug!("a loop contains a step that is allowed only outside of loops")
            }
        }
    }
    LoopAccess { inputs, taken, writes }
}

/// Returns the iterator over values of an earlier loop, which has stored them in the order of its direction.
fn load_local(printer: &Printer, from: &ArraySlice, into: &[Option<ValueId>]) -> LoopInput {
    let entries = into.iter().map(|value| match value {
        Some(value) => printer.variables.get(*value).to_token_stream(),
        None => quote!(_),
    });
    let (pattern, store) = (of_local(printer, from.array, entries), local(from.array));
    let steps = printer.procedure.body.iter();
    let mut loops = steps.filter_map(|step| match step {
        Step::Loop(loop_) => Some(loop_),
        _ => None,
    });
    let leaves = |step: &Step| matches!(step, Step::Store { to, .. } if to.array == from.array);
    let Some(earlier) = loops.find(|loop_| loop_.body.iter().any(leaves)) else {
        bug!("a loop loads values that no loop has stored")
    };
    let times = if earlier.inward {
        quote!(::core::iter::Iterator::rev(#store.iter()))
    } else {
        quote!(#store.iter())
    };
    (quote!(&#pattern), times)
}

/// Prints the values that a loop stores in a repetition, or their pattern: an array, or two arrays if some values differ
/// between columns.
fn of_local(
    printer: &Printer,
    array: ArrayId,
    entries: impl Iterator<Item = TokenStream>,
) -> TokenStream {
    let (mut once, mut columns) = (Vec::new(), Vec::new());
    for (entry, value) in entries.enumerate() {
        let list = if printer.varying.entry(array, entry) { &mut columns } else { &mut once };
        list.push(value);
    }
    match columns.is_empty() {
        true => quote!([#(#once),*]),
        false => quote!(([#(#once),*], [#(#columns),*])),
    }
}

/// Prints the store of a loop into a segment of a result.
fn write(
    printer: &Printer,
    loop_: &ForLoop,
    to: &ArraySlice,
    values: &[Option<Operand>],
) -> (LoopInput, TokenStream) {
    let segment = segment(printer, to);
    let (names, writes) = assigned(printer, (to, segment), values);
    let slices = match segments_stored(loop_, to.array).len() {
        1 => printer.cx.slices_mut(&printer.filled(to.array), segment),
        _ => part(to.array, to.segment).to_token_stream(),
    };
    ((pattern(&names), quote!(#slices.iter_mut())), writes)
}

/// Returns the segments of an array that a loop stores, in their order.
fn segments_stored(loop_: &ForLoop, array: ArrayId) -> Vec<usize> {
    let segments = loop_.body.iter().filter_map(|step| match step {
        Step::Store { to, .. } if to.array == array => Some(to.segment),
        _ => None,
    });
    let mut segments: Vec<usize> = segments.collect();
    segments.sort_unstable();
    segments
}

/// Declares the slices of each result of which a loop stores several segments: the loop borrows all of them at a time.
fn taken_apart(printer: &Printer, loop_: &ForLoop) -> TokenStream {
    let mstmm = &printer.cx.mstmm;
    let of_array = |(id, array): (ArrayId, &Array)| {
        let segments = segments_stored(loop_, id);
        if matches!(array.role, ArrayRole::Local(_)) || segments.len() < 2 {
            return TokenStream::new();
        }
        let (result, rest) = (printer.filled(id), helper(&format!("rest{}", id.index())));
        let mut end = 0;
        let parts = segments.into_iter().map(|number| {
            let segment = &array.layout.segments[number];
            let [count, skipped, repetitions] =
                [segment.count, segment.offset - end, segment.repetitions].map(usize_literal);
            end = segment.offset + segment.count * segment.repetitions;
            let part = part(id, number);
            quote! {
                let #part =
                    #mstmm::generated::take_chunks::<_, #count, #skipped, #repetitions>(&mut #rest);
            }
        });
        let parts: TokenStream = parts.collect();
        quote! {
            let mut #rest = #mstmm::generated::FixedLen::values_mut(&mut #result);
            #parts
        }
    };
    printer.procedure.arrays.enumerate().map(of_array).collect()
}

/// Returns the variable of the slices of a segment.
fn part(array: ArrayId, segment: usize) -> Ident {
    helper(&format!("part{}_{segment}", array.index()))
}

/// Prints the store, in a procedure with loops, of results that lie outside of repeated parts or are the same in every
/// repetition.
pub fn fill(printer: &Printer, to: &ArraySlice, values: &[Option<Operand>]) -> TokenStream {
    let array = printer.filled(to.array);
    let segment = segment(printer, to);
    let (names, writes) = assigned(printer, (to, segment), values);
    let (pattern, slices) = (pattern(&names), printer.cx.slices_mut(&array, segment));
    quote! {
        for #pattern in #slices {
            #writes
        }
    }
}

fn segment<'a>(printer: &'a Printer, slice: &ArraySlice) -> &'a Segment {
    &printer.array(slice).layout.segments[slice.segment]
}

/// Returns the names of the entries that are written, and the statements that write them.
fn assigned(
    printer: &Printer,
    (to, segment): (&ArraySlice, &Segment),
    values: &[Option<Operand>],
) -> (Vec<Option<Ident>>, TokenStream) {
    let mut writes = TokenStream::new();
    let mut names = vec![None; segment.count];
    for (entry, value) in values.iter().enumerate() {
        let Some(value) = value else { continue };
        let number = segment.first + to.first + entry;
        let name = helper(&format!("o{}_{number}", to.array.index()));
        let value = printer.stored(to.array, value);
        writes.extend(quote!(*#name = #value;));
        names[to.first + entry] = Some(name);
    }
    (names, writes)
}
