//! Which values are kept in memory until they are needed again.
//!
//! A chain needs on its way back what it computed on its way in, more than any processor has registers for.
//! Compilers choose well what to keep in memory, to spill, where a function branches; in one that runs
//! straight on, and is as long as these, they keep too little at hand and too much of the wrong. Here it is
//! known when every value is needed next, and what is needed last of all makes room: that takes the fewest
//! reloads (Belady, A study of replacement algorithms for a virtual-storage computer, IBM Systems Journal 5,
//! 1966).

use crate::program::{Block, Move, Name, Operand, Program, Spills, Statement};
use std::cmp::Reverse;

/// So many values are kept at hand: registers of 512 bits are 32, and what is being computed and known numbers
/// take some.
const REGISTERS: usize = 27;

/// An operand that is not needed again for so many statements is taken from memory by the operation itself.
const SOON: usize = 20;

/// Longer programs are left alone: their statements are not nested, and moves between them would have to be
/// declared.
const LONGEST: usize = 1000;

/// The spills of a program that runs straight on; none in long programs, and where there are registers
/// enough. `readable` tells which unknowns may be read more than once; all others are there from the
/// beginning.
pub fn spills(program: &Program, readable: impl Fn(u32) -> bool) -> Option<Spills> {
    let [Block::Once(sections)] = &program.blocks[..] else { return None };
    let statements: Vec<&Statement> =
        sections.iter().flat_map(|section| &section.statements).collect();
    if statements.len() > LONGEST {
        return None;
    }
    let mut values = Values::of(program);
    for slot in &program.slots {
        values.add(Key::Named(slot.name), true);
    }
    for &symbol in &program.symbols {
        values.add(Key::Symbol(symbol), readable(symbol));
    }
    let reads = statements.iter().map(|statement| values.read(statement.operands()));
    let mut reads: Vec<Vec<usize>> = reads.collect();
    reads.push(values.read(program.outputs.iter().flatten()));
    let made =
        statements.iter().map(|statement| values.of_names(statement.names())).collect::<Vec<_>>();
    let spills = Registers::new(values, &reads).run(&reads, &made);
    (spills.places > 0).then_some(spills)
}

/// An unknown or a value.
#[derive(Clone, Copy)]
enum Key {
    Symbol(u32),
    Named(Name),
}

impl Key {
    /// That of an operand without its sign.
    fn of(operand: &Operand) -> Option<Self> {
        match operand {
            Operand::Symbol(number) => Some(Key::Symbol(*number)),
            Operand::Named(name) => Some(Key::Named(*name)),
            Operand::Minus(inner) => Key::of(inner),
            Operand::Number(_) | Operand::Repeated => None,
        }
    }

    fn operand(self) -> Operand {
        match self {
            Key::Symbol(number) => Operand::Symbol(number),
            Key::Named(name) => Operand::Named(name),
        }
    }
}

/// The unknowns and values of a program that are read, by new numbers in the order in which they are met.
struct Values {
    of_symbols: Vec<Option<usize>>,
    of_names: Vec<Option<usize>>,
    keys: Vec<Key>,
    /// Which the caller keeps in memory.
    readable: Vec<bool>,
}

impl Values {
    /// None so far.
    fn of(program: &Program) -> Self {
        let symbols = program.symbols.last().map_or(0, |&last| last as usize + 1);
        let of_names = vec![None; program.names.count()];
        Values { of_symbols: vec![None; symbols], of_names, keys: Vec::new(), readable: Vec::new() }
    }

    /// The number of an unknown or a value.
    fn add(&mut self, key: Key, readable: bool) -> usize {
        let known = match key {
            Key::Symbol(number) => &mut self.of_symbols[number as usize],
            Key::Named(name) => &mut self.of_names[name.index()],
        };
        *known.get_or_insert_with(|| {
            self.keys.push(key);
            self.readable.push(readable);
            self.keys.len() - 1
        })
    }

    /// The numbers of operands, each once.
    fn read<'a>(&mut self, operands: impl Iterator<Item = &'a Operand>) -> Vec<usize> {
        let mut read = Vec::new();
        for key in operands.filter_map(Key::of) {
            let number = self.add(key, false);
            if !read.contains(&number) {
                read.push(number);
            }
        }
        read
    }

    /// The numbers of those of these values that are read.
    fn of_names(&self, names: impl Iterator<Item = Name>) -> Vec<usize> {
        names.filter_map(|name| self.of_names[name.index()]).collect()
    }
}

/// The values at hand while a program runs.
struct Registers {
    values: Values,
    /// By which statements a value is still to be read, the next one last.
    uses: Vec<Vec<usize>>,
    held: Vec<usize>,
    /// Where a value is kept in memory.
    places: Vec<Option<usize>>,
    free: Vec<usize>,
    count: usize,
}

impl Registers {
    /// Before the first statement.
    fn new(values: Values, reads: &[Vec<usize>]) -> Self {
        let mut uses = vec![Vec::new(); values.keys.len()];
        for (number, read) in reads.iter().enumerate().rev() {
            read.iter().for_each(|&value| uses[value].push(number));
        }
        let is_given = |&value: &usize| {
            matches!(values.keys[value], Key::Symbol(_)) && !values.readable[value]
        };
        let held = (0..values.keys.len()).filter(is_given).collect();
        let places = vec![None; values.keys.len()];
        Registers { values, uses, held, places, free: Vec::new(), count: 0 }
    }

    /// The moves of a program whose statements read and make these values; the results are read last.
    fn run(mut self, reads: &[Vec<usize>], made: &[Vec<usize>]) -> Spills {
        let mut all = Vec::with_capacity(reads.len());
        for (number, (read, made)) in reads.iter().zip(made).enumerate() {
            let mut moves = Vec::new();
            self.fetch(number, read, &mut moves);
            self.finish(read);
            let made: Vec<usize> =
                made.iter().copied().filter(|&value| !self.uses[value].is_empty()).collect();
            self.make_room(made.len(), read, &mut moves);
            self.held.extend(made);
            all.push(moves);
        }
        let results = reads.last().into_iter().flatten();
        let away = results.filter(|value| !self.held.contains(value));
        let back = away.map(|&value| self.back(value)).collect();
        all.push(back);
        Spills { moves: all, places: self.count }
    }

    /// Brings what a statement reads.
    fn fetch(&mut self, number: usize, read: &[usize], moves: &mut Vec<Move>) {
        let mut by_itself = true;
        for &value in read {
            if self.held.contains(&value) {
                continue;
            }
            moves.push(self.back(value));
            let next = self.uses[value].iter().rev().nth(1);
            if by_itself && next.is_none_or(|next| next - number > SOON) {
                by_itself = false;
                continue;
            }
            self.make_room(1, read, moves);
            self.held.push(value);
        }
    }

    /// A value from memory.
    fn back(&self, value: usize) -> Move {
        let operand = self.values.keys[value].operand();
        if self.values.readable[value] { Move::Read(operand) } else { Move::Reload(operand) }
    }

    /// Drops what has been read for the last time.
    fn finish(&mut self, read: &[usize]) {
        for &value in read {
            self.uses[value].pop();
            if self.uses[value].is_empty() {
                if let Some(at) = self.held.iter().position(|&held| held == value) {
                    self.held.swap_remove(at);
                }
                self.free.extend(self.places[value].take());
            }
        }
    }

    /// Makes room for so many values more, but not of those that are being read.
    fn make_room(&mut self, count: usize, read: &[usize], moves: &mut Vec<Move>) {
        while self.held.len() + count > REGISTERS {
            let in_memory =
                |value: usize| self.values.readable[value] || self.places[value].is_some();
            let may_go = self.held.iter().enumerate().filter(|(_, value)| !read.contains(value));
            let last = may_go.max_by_key(|&(_, &value)| {
                (self.uses[value].last(), in_memory(value), Reverse(value))
            });
            let Some((at, &value)) = last else { break };
            self.held.swap_remove(at);
            if !in_memory(value) {
                let place = self.free.pop().unwrap_or_else(|| {
                    self.count += 1;
                    self.count - 1
                });
                self.places[value] = Some(place);
                moves.push(Move::Spill(self.values.keys[value].operand(), place));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::{Names, Operation, Section};
    use std::collections::HashMap;

    /// So many unknowns are read by as many first values, each of the others adds up two values before it.
    const UNKNOWNS: usize = 40;
    const STATEMENTS: usize = 300;

    /// Which values a statement reads, by SplitMix64 (Steele, Lea and Flood 2014).
    fn read(random: &mut u64, number: usize) -> usize {
        *random = random.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = *random;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (mixed ^ (mixed >> 31)) as usize % number
    }

    /// A program that needs what it computes at first until its end.
    fn program(seed: u64) -> Program {
        let (mut random, mut names) = (seed, Names::default());
        let all: Vec<Name> =
            (0..STATEMENTS).map(|number| names.add(format!("x{number}"))).collect();
        let value = |number: usize| Operand::Named(all[number]);
        let statements = (0..STATEMENTS).map(|number| {
            let operation = match number {
                0 => Operation::Recip(Operand::Symbol(0)),
                _ if number < UNKNOWNS => {
                    Operation::RecipAbove(value(number - 1), Operand::Symbol(number as u32))
                }
                _ => {
                    let [a, b] = [(); 2].map(|()| value(read(&mut random, number)));
                    Operation::Sum(a, b)
                }
            };
            Statement::Let(all[number], operation)
        });
        let section = Section {
            title: String::new(),
            source: String::new(),
            statements: statements.collect(),
        };
        Program {
            names,
            symbols: (0..UNKNOWNS as u32).collect(),
            slots: Vec::new(),
            blocks: vec![Block::Once(vec![section])],
            outputs: vec![[STATEMENTS - 1, 1].map(value).to_vec()],
        }
    }

    /// A processor with registers and memory that does nothing but what it is told.
    #[derive(Default)]
    struct Processor {
        at_hand: Vec<Operand>,
        memory: HashMap<usize, Operand>,
    }

    impl Processor {
        fn run(&mut self, it: &Move) {
            match it {
                Move::Spill(value, place) => {
                    assert!(self.at_hand.contains(value), "{value:?} is not there to be spilled");
                    self.memory.insert(*place, value.clone());
                }
                Move::Reload(value) => {
                    assert!(self.memory.values().any(|kept| kept == value), "{value:?} is lost");
                    self.at_hand.push(value.clone());
                }
                Move::Read(value) => {
                    assert!(matches!(value, Operand::Symbol(_)), "{value:?} cannot be read");
                    self.at_hand.push(value.clone());
                }
            }
        }

        /// Forgets what is fetched before it is read or spilled next, and all that is not read again.
        fn forget(&mut self, program: &Program, spills: &Spills, next: usize) {
            let Block::Once(sections) = &program.blocks[0] else { return };
            let statements = &sections[0].statements;
            self.at_hand.retain(|value| {
                for number in next..=statements.len() {
                    let next = spills.moves[number].iter().find_map(|it| match it {
                        Move::Spill(spilled, _) => (spilled == value).then_some(true),
                        Move::Read(it) | Move::Reload(it) => (it == value).then_some(false),
                    });
                    if let Some(kept) = next {
                        return kept;
                    }
                    let reads = match statements.get(number) {
                        Some(statement) => statement.operands().any(|operand| operand == value),
                        None => program.outputs[0].contains(value),
                    };
                    if reads {
                        return true;
                    }
                }
                false
            });
        }
    }

    #[test]
    fn everything_is_at_hand_when_it_is_needed_and_no_more_than_there_is_room_for() {
        for seed in 0..20 {
            let program = program(seed);
            let spills = spills(&program, |number| number % 5 > 0).expect("it is short");
            assert!(spills.places > 0, "seed {seed}");
            let mut processor = Processor::default();
            // Unknowns that cannot be read are there from the beginning.
            processor.at_hand.extend((0..UNKNOWNS as u32).step_by(5).map(Operand::Symbol));
            let Block::Once(sections) = &program.blocks[0] else { panic!("it has no loops") };
            for (number, statement) in sections[0].statements.iter().enumerate() {
                spills.moves[number].iter().for_each(|it| processor.run(it));
                for operand in statement.operands() {
                    let there = processor.at_hand.contains(operand);
                    assert!(there, "{operand:?} at {number} of seed {seed}");
                }
                let made = statement.names().map(Operand::Named);
                processor.at_hand.extend(made);
                processor.at_hand.sort_by_key(|value| format!("{value:?}"));
                processor.at_hand.dedup();
                processor.forget(&program, &spills, number + 1);
                let held = processor.at_hand.len();
                assert!(held <= REGISTERS, "{held} behind {number} of seed {seed}");
            }
            spills.moves[STATEMENTS].iter().for_each(|it| processor.run(it));
            for result in &program.outputs[0] {
                assert!(processor.at_hand.contains(result), "{result:?} of seed {seed}");
            }
        }
    }

    #[test]
    fn what_is_read_from_where_it_is_needs_no_place() {
        let mut program = program(0);
        let Block::Once(sections) = &mut program.blocks[0] else { panic!("it has no loops") };
        for (number, statement) in sections[0].statements.iter_mut().enumerate() {
            let unknown = Operand::Symbol((number % UNKNOWNS) as u32);
            if let Statement::Let(_, operation) = statement {
                *operation = Operation::Sum(unknown.clone(), unknown);
            }
        }
        assert_eq!(spills(&program, |_| true), None);
    }
}
