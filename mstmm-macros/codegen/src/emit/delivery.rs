//! Results that are written as soon as they are known.
//!
//! Kept until the end, the numbers of all connection points would be put aside, and taken up again, to be
//! written: a third of what a processor then does.

use crate::program::{Operand, Program, Section, Statement};
use proc_macro2::TokenStream;
use std::collections::{HashMap, HashSet};

/// What is written between the statements of a program.
pub struct Deliveries<'a> {
    /// What the program computes.
    computed: HashSet<&'a str>,
    /// What is to be written, and how many values it still waits for.
    all: Vec<(usize, TokenStream)>,
    /// What waits for a value.
    waiting: HashMap<&'a str, Vec<usize>>,
}

impl<'a> Deliveries<'a> {
    /// For the statements of `program`; `first` is written before anything else, as soon as
    /// `operands` are known.
    pub fn new(
        program: &'a Program,
        operands: impl IntoIterator<Item = &'a Operand>,
        first: TokenStream,
    ) -> Self {
        let statements = program.sections().flat_map(|Section { statements, .. }| statements);
        let computed = statements.flat_map(Statement::names).collect();
        let mut deliveries = Deliveries { computed, all: Vec::new(), waiting: HashMap::new() };
        deliveries.add(operands, first);
        deliveries
    }

    /// Adds what is written as soon as `operands` are known, and the first is written.
    pub fn add(&mut self, operands: impl IntoIterator<Item = &'a Operand>, tokens: TokenStream) {
        let names: HashSet<&str> = operands.into_iter().filter_map(Operand::name).collect();
        let number = self.all.len();
        let mut missing = usize::from(number > 0);
        for name in names.intersection(&self.computed) {
            self.waiting.entry(name).or_default().push(number);
            missing += 1;
        }
        self.all.push((missing, tokens));
    }

    /// What is written before any statement.
    pub fn at_once(&mut self) -> TokenStream {
        let mut tokens = TokenStream::new();
        if self.all[0].0 == 0 {
            self.write(0, &mut tokens);
        }
        tokens
    }

    /// What is written after a statement.
    pub fn after(&mut self, statement: &Statement) -> TokenStream {
        let mut tokens = TokenStream::new();
        for name in statement.names() {
            for number in self.waiting.remove(name).unwrap_or_default() {
                self.arrive(number, &mut tokens);
            }
        }
        tokens
    }

    /// One of the values that a delivery waits for is there.
    fn arrive(&mut self, number: usize, tokens: &mut TokenStream) {
        self.all[number].0 -= 1;
        if self.all[number].0 == 0 {
            self.write(number, tokens);
        }
    }

    fn write(&mut self, number: usize, tokens: &mut TokenStream) {
        tokens.extend(std::mem::take(&mut self.all[number].1));
        // All others have waited for the first.
        if number == 0 {
            (1..self.all.len()).for_each(|other| self.arrive(other, tokens));
        }
    }
}
