//! Results that are written as soon as they are known.
//!
//! Kept until the end, the numbers of all connection points would be put aside, and taken up again, to be
//! written: a third of what a processor then does. So nothing waits for the test whether there are
//! accelerations at all; what has been written is taken back where it fails. And since LLVM puts writes
//! off, to make vectors of neighbours, it is told behind each statement with writes that it may not.

use crate::program::{Operand, Program, Section, Statement};
use proc_macro2::TokenStream;
use quote::quote;
use std::collections::{HashMap, HashSet};

/// What is written between the statements of a program.
pub struct Deliveries<'a> {
    mstmm: &'a TokenStream,
    /// What the program computes.
    computed: HashSet<&'a str>,
    /// What is to be written, and how many values it still waits for.
    all: Vec<(usize, TokenStream)>,
    /// What waits for a value.
    waiting: HashMap<&'a str, Vec<usize>>,
    /// What waits for none.
    at_once: TokenStream,
}

impl<'a> Deliveries<'a> {
    /// None yet, for the statements of `program`.
    pub fn new(program: &'a Program, mstmm: &'a TokenStream) -> Self {
        let statements = program.sections().flat_map(|Section { statements, .. }| statements);
        Deliveries {
            mstmm,
            computed: statements.flat_map(Statement::names).collect(),
            all: Vec::new(),
            waiting: HashMap::new(),
            at_once: TokenStream::new(),
        }
    }

    /// Adds what is written as soon as `operands` are known.
    pub fn add(&mut self, operands: impl IntoIterator<Item = &'a Operand>, tokens: TokenStream) {
        let names: HashSet<&str> = operands.into_iter().filter_map(Operand::name).collect();
        let mut missing = 0;
        for name in names.intersection(&self.computed) {
            self.waiting.entry(name).or_default().push(self.all.len());
            missing += 1;
        }
        if missing == 0 {
            self.at_once.extend(tokens);
        } else {
            self.all.push((missing, tokens));
        }
    }

    /// What is written before any statement.
    pub fn at_once(&mut self) -> TokenStream {
        std::mem::take(&mut self.at_once)
    }

    /// What is written after a statement.
    pub fn after(&mut self, statement: &Statement) -> TokenStream {
        let mut tokens = TokenStream::new();
        for name in statement.names() {
            for number in self.waiting.remove(name).unwrap_or_default() {
                let (missing, delivery) = &mut self.all[number];
                *missing -= 1;
                if *missing == 0 {
                    tokens.extend(std::mem::take(delivery));
                }
            }
        }
        if !tokens.is_empty() {
            let mstmm = self.mstmm;
            tokens.extend(quote!(#mstmm::generated::written();));
        }
        tokens
    }
}
