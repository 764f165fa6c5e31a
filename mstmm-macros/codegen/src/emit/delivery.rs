//! Results that are written as soon as they are known.
//!
//! Kept until the end, the numbers of all connection points would be put aside, and taken up again, to be
//! written: a third of what a processor then does. So nothing waits for the test whether there are
//! accelerations at all; what has been written is taken back where it fails. And since LLVM puts writes
//! off, to make vectors of neighbours, it is told behind each statement with writes that it may not.

use crate::program::{Name, Operand, Program, Section, Statement};
use proc_macro2::TokenStream;
use quote::quote;

/// What is written between the statements of a program.
pub struct Deliveries<'a> {
    mstmm: &'a TokenStream,
    /// Which values the program computes.
    computed: Vec<bool>,
    /// What is to be written, and how many values it still waits for.
    all: Vec<(usize, TokenStream)>,
    /// What waits for a value.
    waiting: Vec<Vec<usize>>,
    /// What waits for none.
    at_once: TokenStream,
}

impl<'a> Deliveries<'a> {
    /// None yet, for the statements of `program`.
    pub fn new(program: &Program, mstmm: &'a TokenStream) -> Self {
        let statements = program.sections().flat_map(|Section { statements, .. }| statements);
        let mut computed = vec![false; program.names.count()];
        statements.flat_map(Statement::names).for_each(|name| computed[name.index()] = true);
        Deliveries {
            mstmm,
            waiting: vec![Vec::new(); computed.len()],
            computed,
            all: Vec::new(),
            at_once: TokenStream::new(),
        }
    }

    /// Adds what is written as soon as `operands` are known.
    pub fn add<'o>(
        &mut self,
        operands: impl IntoIterator<Item = &'o Operand>,
        tokens: TokenStream,
    ) {
        let mut names: Vec<Name> = operands.into_iter().filter_map(Operand::name).collect();
        names.retain(|name| self.computed[name.index()]);
        names.sort_unstable();
        names.dedup();
        if names.is_empty() {
            self.at_once.extend(tokens);
            return;
        }
        names.iter().for_each(|name| self.waiting[name.index()].push(self.all.len()));
        self.all.push((names.len(), tokens));
    }

    /// What is written before any statement.
    pub fn at_once(&mut self) -> TokenStream {
        std::mem::take(&mut self.at_once)
    }

    /// What is written after a statement.
    pub fn after(&mut self, statement: &Statement) -> TokenStream {
        let mut tokens = TokenStream::new();
        for name in statement.names() {
            for number in std::mem::take(&mut self.waiting[name.index()]) {
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
