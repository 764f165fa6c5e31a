//! Loops over the times of repeated parts, and the arrays that they fill.

use super::Plan;
use super::block::{Results, is_long};
use super::inputs;
use super::names::{Variables, helper};
use super::sealed;
use super::spread::{Piece, Spread};
use crate::compile::groups;
use crate::model::RepeatId;
use crate::program::{Block, Loop, Name, Operand, Program};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};

/// A group of results that go into an array.
#[derive(Clone, Debug)]
pub struct Target {
    /// Which group.
    pub group: usize,
    /// Where the numbers of the group lie in the array.
    pub spread: Spread,
    /// The array of the caller's that they are written into; none if it is a new one.
    pub existing: Option<TokenStream>,
}

impl Target {
    /// Into a new array.
    pub fn new(group: usize, spread: Spread) -> Self {
        Target { group, spread, existing: None }
    }
}

/// The pivots of repeated parts: their number among all pivots, and whether all times of them are
/// positive.
pub type Masks = Vec<(usize, Ident)>;

/// The array of a group.
pub fn array(group: usize) -> Ident {
    helper(&format!("results{group}"))
}

/// A pattern and the iterator whose items it takes apart.
pub type Stream = (TokenStream, TokenStream);

impl Plan<'_> {
    /// The blocks of a program with loops, and the arrays that they fill for `targets`.
    pub fn looped(&self, program: &Program, targets: &[Target], results: &Results) -> TokenStream {
        let mstmm = &self.mstmm;
        let Results { variables, masks, .. } = results;
        let arrays = targets.iter().map(|target| {
            let (array, total) = (array(target.group), usize_literal(target.spread.total));
            match &target.existing {
                Some(existing) => quote!(let #array = &mut #existing;),
                None => quote!(let mut #array = [T::constant(0.0); #total];),
            }
        });
        let mask_names = masks.iter().map(|(_, name)| name);
        let stores = program.blocks.iter().enumerate().map(|(number, block)| match block {
            Block::Loop(turn) if !turn.stores.is_empty() => {
                let (store, count) = (store_name(number), usize_literal(turn.stores.len()));
                let times = usize_literal(self.chain.repeats[turn.repeat].count);
                quote!(let mut #store = #mstmm::generated::Stored::<[T; #count], #times>::new_const();)
            }
            Block::Loop(_) | Block::Once(_) => TokenStream::new(),
        });
        let flat = is_long(program);
        let blocks = program.blocks.iter().enumerate().map(|(number, block)| match block {
            Block::Once(sections) => self.sections(variables, sections, flat),
            Block::Loop(turn) => self.turn(program, (number, turn), targets, results),
        });
        let fill = targets.iter().map(|target| self.fill(program, target, variables));
        quote! {
            #(#arrays)*
            #(let mut #mask_names = <T::Mask as #mstmm::Mask>::splat(true);)*
            #(#stores)*
            #(#blocks)*
            #(#fill)*
        }
    }

    /// Results that are the same every time, or stand once.
    fn fill(&self, program: &Program, target: &Target, variables: &Variables) -> TokenStream {
        let outputs = &program.outputs[target.group];
        let fill = |piece: &Piece| {
            let own = &outputs[piece.first..piece.first + piece.count];
            let names: Vec<Option<Ident>> = own
                .iter()
                .enumerate()
                .map(|(k, value)| (*value != Operand::Repeated).then(|| helper(&format!("o{k}"))))
                .collect();
            if names.iter().all(Option::is_none) {
                return TokenStream::new();
            }
            let set = own.iter().zip(&names).filter_map(|(value, name)| {
                let (value, name) = (self.operand(variables, value), name.as_ref()?);
                Some(quote!(*#name = #value;))
            });
            let (pattern, slices) = (pattern(&names), self.slices_mut(&array(target.group), piece));
            quote! {
                for #pattern in #slices {
                    #(#set)*
                }
            }
        };
        target.spread.pieces.iter().map(fill).collect()
    }

    /// A loop.
    fn turn(
        &self,
        program: &Program,
        (number, turn): (usize, &Loop),
        targets: &[Target],
        Results { variables, masks, .. }: &Results,
    ) -> TokenStream {
        let mut streams = self.state_streams(turn);
        let (inputs, taken) = inputs::streams(self, turn);
        streams.extend(inputs);
        streams.extend(self.parameter_streams(turn));
        streams.extend(self.slot_stream(turn, variables));
        streams.extend(turn.loads.iter().filter_map(|load| load_stream(program, variables, load)));
        let mut writes = TokenStream::new();
        if !turn.stores.is_empty() {
            let (store, names) =
                (store_name(number), turn.stores.iter().map(|&name| variables.get(name)));
            writes.extend(quote!(_ = #store.try_push([#(#names),*]);));
        }
        for target in targets {
            let own = target.spread.pieces.iter();
            for piece in own.filter(|piece| piece.repeat == Some(turn.repeat)) {
                let (stream, write) = self.write(turn, target, piece, variables);
                streams.extend(stream);
                writes.extend(write);
            }
        }
        writes.extend(masks.iter().filter_map(|mask| self.check(program, turn, mask, variables)));
        let names: Vec<&Ident> =
            turn.carries.iter().map(|carry| variables.get(carry.name)).collect();
        let firsts = turn.carries.iter().map(|carry| self.operand(variables, &carry.first));
        let nexts = turn.carries.iter().map(|carry| self.operand(variables, &carry.next));
        let entering = turn.carries.iter().map(|carry| variables.get(carry.entering));
        let sections = self.sections(variables, &turn.sections, is_long(program));
        let times = usize_literal(self.chain.repeats[turn.repeat].count);
        let (pattern, iterator) = zipped(streams, &times, turn.inwards);
        quote! {
            #(let mut #names = #firsts;)*
            for #pattern in #iterator {
                #taken
                #(let #entering = #names;)*
                #sections
                #writes
                (#(#names,)*) = (#(#nexts,)*);
            }
        }
    }

    /// What a loop reads of the state.
    fn state_streams(&self, turn: &Loop) -> Vec<Stream> {
        let symbols = &self.programs.symbols;
        let both = [
            (symbols.q(), Spread::coordinates(self), quote!(state_.q)),
            (symbols.v(), Spread::freedoms(self), quote!(state_.v)),
        ];
        let mut streams = Vec::new();
        for (range, spread, from) in both {
            for piece in spread.pieces.iter().filter(|piece| piece.repeat == Some(turn.repeat)) {
                let numbers = range.start + piece.first..range.start + piece.first + piece.count;
                let names: Vec<Option<Ident>> =
                    numbers.map(|number| self.read_in(turn, number)).collect();
                if names.iter().any(Option::is_some) {
                    let pattern = pattern(&names);
                    let slices = self.slices(&from, piece);
                    streams.push((quote!(&#pattern), quote!(#slices.iter())));
                }
            }
        }
        streams
    }

    /// What a loop reads of the parameters that have a number for every time.
    fn parameter_streams(&self, turn: &Loop) -> Vec<Stream> {
        let parameters = self.chain.parameters.iter().zip(self.programs.symbols.parameters());
        let read = parameters.filter_map(|(parameter, number)| {
            let (name, field) = (self.read_in(turn, number)?, &parameter.name);
            Some((quote!(&#name), quote!(parameters_.#field.iter())))
        });
        read.collect()
    }

    /// What a loop reads of what is known of every time since setup.
    fn slot_stream(&self, turn: &Loop, variables: &Variables) -> Option<Stream> {
        let slots = self.slots_of_part(turn.repeat)?;
        let name_of = |index| turn.slots.iter().find(|slot| slot.index == index);
        let variable = |index| name_of(index).map(|slot| variables.get(slot.name).clone());
        let names: Vec<Option<Ident>> = (0..slots.pieces[0].count).map(variable).collect();
        let derived = sealed::of_part(self, &quote!(self), turn.repeat);
        let pattern = pattern(&names);
        let any = names.iter().any(Option::is_some);
        let slices = self.slices(&derived, &slots.pieces[0]);
        any.then(|| (quote!(&#pattern), quote!(#slices.iter())))
    }

    /// How the slots of a repeated part lie in their array; nothing if it has none.
    pub fn slots_of_part(&self, part: RepeatId) -> Option<Spread> {
        let count = self.programs.setup.outputs[2 + part.index()].len();
        (count > 0).then(|| Spread::each(count, part, self.chain.repeats[part].count))
    }

    /// The variable of an unknown, if a loop reads it.
    pub fn read_in(&self, turn: &Loop, number: usize) -> Option<Ident> {
        let read = turn.symbols.binary_search(&(number as u32)).is_ok();
        read.then(|| self.unknowns[number].clone())
    }

    /// Writes what a loop has for a piece of an array.
    fn write(
        &self,
        turn: &Loop,
        target: &Target,
        piece: &Piece,
        variables: &Variables,
    ) -> (Option<Stream>, TokenStream) {
        let mut writes = TokenStream::new();
        let mut names = Vec::new();
        for place in piece.first..piece.first + piece.count {
            let here =
                |(group, at, _): &&(usize, usize, Operand)| *group == target.group && *at == place;
            names.push(turn.outputs.iter().find(here).map(|(_, _, value)| {
                let (name, value) =
                    (helper(&format!("o{}_{place}", target.group)), self.operand(variables, value));
                writes.extend(quote!(*#name = #value;));
                name
            }));
        }
        let any = names.iter().any(Option::is_some);
        let slices = self.slices_mut(&array(target.group), piece);
        let stream = any.then(|| (pattern(&names), quote!(#slices.iter_mut())));
        (stream, writes)
    }

    /// Takes down whether a pivot of this loop is positive.
    fn check(
        &self,
        program: &Program,
        turn: &Loop,
        (number, mask): &(usize, Ident),
        variables: &Variables,
    ) -> Option<TokenStream> {
        let mstmm = &self.mstmm;
        let find = |group: usize| {
            let here = |(g, place, _): &&(usize, usize, Operand)| *g == group && place == number;
            turn.outputs.iter().find(here).map(|(_, _, value)| self.operand(variables, value))
        };
        let once = |group: usize| match &program.outputs[group][*number] {
            Operand::Repeated => None,
            operand => Some(self.operand(variables, operand)),
        };
        let (value, scale) = match (find(groups::PIVOTS), find(groups::SCALES)) {
            (None, None) => return None,
            (value, scale) => {
                (value.or_else(|| once(groups::PIVOTS))?, scale.or_else(|| once(groups::SCALES))?)
            }
        };
        Some(quote!(#mask = #mask & !#mstmm::generated::vanishes(#value, #scale);))
    }

    /// The numbers of a piece, time by time.
    pub fn slices(&self, array: &impl ToTokens, piece: &Piece) -> TokenStream {
        let mstmm = &self.mstmm;
        let [count, place, times] = [piece.count, piece.place, piece.times].map(usize_literal);
        quote!(#mstmm::generated::times::<T, #count>(#array.as_slice(), #place, #times))
    }

    /// The numbers of a piece, time by time, to be written.
    pub fn slices_mut(&self, array: &impl ToTokens, piece: &Piece) -> TokenStream {
        let mstmm = &self.mstmm;
        let [count, place, times] = [piece.count, piece.place, piece.times].map(usize_literal);
        quote! {
            #mstmm::generated::times_mut::<T, #count>(#array.as_mut_slice(), #place, #times)
        }
    }
}

/// What a loop reads of what an earlier one has stored.
fn load_stream(
    program: &Program,
    variables: &Variables,
    (from, names): &(usize, Vec<Name>),
) -> Option<Stream> {
    let Some(Block::Loop(earlier)) = program.blocks.get(*from) else {
        bug!("a loop reads what block {from} stores, which is no loop")
    };
    let wanted = earlier.stores.iter().map(|name| {
        let is_wanted = names.contains(name);
        is_wanted.then(|| variables.get(*name).clone())
    });
    let wanted: Vec<Option<Ident>> = wanted.collect();
    let (pattern, store) = (pattern(&wanted), store_name(*from));
    let times = if earlier.inwards {
        quote!(::core::iter::Iterator::rev(#store.iter()))
    } else {
        quote!(#store.iter())
    };
    Some((quote!(&#pattern), times))
}

fn store_name(block: usize) -> Ident {
    helper(&format!("store{block}"))
}

/// A literal without a suffix.
pub fn usize_literal(value: usize) -> Literal {
    Literal::usize_unsuffixed(value)
}

/// A pattern of an array's numbers.
fn pattern(names: &[Option<Ident>]) -> TokenStream {
    let names = names.iter().map(|name| match name {
        Some(name) => quote!(#name),
        None => quote!(_),
    });
    quote!([#(#names),*])
}

/// One pattern and one iterator for several.
fn zipped(streams: Vec<Stream>, times: &Literal, inwards: bool) -> Stream {
    let mut streams = streams.into_iter();
    let (mut pattern, mut iterator) = streams.next().unwrap_or((quote!(_), quote!((0..#times))));
    for (next_pattern, next_iterator) in streams {
        pattern = quote!((#pattern, #next_pattern));
        iterator = quote!(::core::iter::zip(#iterator, #next_iterator));
    }
    if inwards {
        iterator = quote!(::core::iter::Iterator::rev(#iterator));
    }
    (pattern, iterator)
}
