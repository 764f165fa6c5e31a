//! Statements, token by token.
//!
//! There are thousands of them, and `quote!` makes a stream of every part of each. In a macro that is
//! as many calls of rustc; here a stream is made of a whole program, and of what stands in brackets.

use super::EmitContext;
use super::names::{Variables, helper};
use crate::program::{Operand, Operation, Section, SectionCost, Statement, ValueId, by_heading};
use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};

/// So many names are declared at once where they are declared before they are computed.
const DECLARED: usize = 500;

/// Tokens that are being written.
pub struct Writer<'a> {
    cx: &'a EmitContext<'a>,
    variables: &'a Variables,
    tokens: Vec<TokenTree>,
}

impl<'a> Writer<'a> {
    /// Nothing yet, of a program with these variables.
    pub fn new(cx: &'a EmitContext<'a>, variables: &'a Variables) -> Self {
        Writer { cx, variables, tokens: Vec::new() }
    }

    /// Adds what is written already.
    pub fn add(&mut self, tokens: TokenStream) {
        self.tokens.extend(tokens);
    }

    /// What has been written.
    pub fn finish(self) -> TokenStream {
        self.tokens.into_iter().collect()
    }

    /// The headings of sections with their operations, each once.
    pub fn headings<'s>(&self, sections: &[&'s Section]) -> Vec<SectionCost<'s>> {
        by_heading(sections.iter().copied())
    }

    /// The heading of a section: in full where it comes first.
    pub fn heading_of(&mut self, section: &Section, headings: &mut Vec<SectionCost>) {
        if !self.heading(section, headings) {
            self.documentation(&format!(" {}.", section.title));
        }
    }

    /// The statements of a section, each of which declares what it computes unless that is declared before.
    pub fn statements(&mut self, section: &Section, declaring: bool) {
        for statement in &section.statements {
            if declaring {
                self.word("let");
            }
            self.statement(statement);
            self.sign(';');
        }
    }

    /// Declares the names of some sections, at least [`DECLARED`] of them or all, from the one with this
    /// number on, under their headings, for only declarations can be documented; returns the number of
    /// the first section beyond.
    pub fn declare(
        &mut self,
        sections: &[&Section],
        first: usize,
        headings: &mut Vec<SectionCost>,
    ) -> usize {
        let (mut next, mut count) = (first, 0);
        while next < sections.len() && count < DECLARED {
            self.heading(sections[next], headings);
            count += sections[next].statements.len();
            next += 1;
        }
        self.word("let");
        self.group(Delimiter::Parenthesis, |names| {
            let statements = sections[first..next].iter().flat_map(|section| &section.statements);
            for name in statements.flat_map(Statement::defined) {
                names.name(name);
                names.sign(',');
            }
        });
        self.sign(';');
        next
    }

    /// The heading of a section in full, if it is still among `headings`.
    fn heading(&mut self, section: &Section, headings: &mut Vec<SectionCost>) -> bool {
        let same = |headed: &SectionCost| (headed.title, headed.source) == section.heading();
        let Some(first) = headings.iter().position(same) else { return false };
        let SectionCost { title, source, cost } = headings.remove(first);
        let source = if source.is_empty() { String::new() } else { format!(", {source}") };
        self.documentation(&format!(" {title}{source}: {cost}."));
        true
    }

    /// Documentation, which unlike comments survives the expansion.
    fn documentation(&mut self, text: &str) {
        self.sign('#');
        self.group(Delimiter::Bracket, |attribute| {
            attribute.word("doc");
            attribute.sign('=');
            attribute.literal(Literal::string(text));
        });
    }

    fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Let(name, operation) => {
                self.name(*name);
                self.sign('=');
                self.operation(operation);
            }
            Statement::SinCos { sines, cosines, angles } => {
                self.group(Delimiter::Parenthesis, |both| {
                    both.names(sines);
                    both.sign(',');
                    both.names(cosines);
                });
                self.sign('=');
                self.function("sin_cos");
                self.group(Delimiter::Parenthesis, |arguments| {
                    arguments
                        .group(Delimiter::Bracket, |list| list.separated(angles, Self::operand));
                });
            }
        }
    }

    /// A pattern of names where there are some.
    fn names(&mut self, names: &[Option<ValueId>]) {
        self.group(Delimiter::Bracket, |pattern| {
            pattern.separated(names, |pattern, name| match name {
                Some(name) => pattern.name(*name),
                None => pattern.word("_"),
            });
        });
    }

    fn operation(&mut self, operation: &Operation) {
        match operation {
            Operation::Sum(a, b) => self.infix(a, '+', b),
            Operation::Difference(a, b) => self.infix(a, '-', b),
            Operation::Product(a, b) => self.infix(a, '*', b),
            Operation::MulAdd(a, b, c) => self.call("mul_add", [a, b, c]),
            Operation::MulSub(a, b, c) => self.call("mul_sub", [a, b, c]),
            Operation::MulNegAdd(a, b, c) => self.call("mul_neg_add", [a, b, c]),
            Operation::Recip(a) => self.call("recip", [a]),
            Operation::Sqrt(a) => self.call("sqrt", [a]),
            Operation::CopySign(a, b) => self.call("copysign", [a, b]),
            Operation::Atan2(a, b) => self.call("atan2", [a, b]),
            Operation::RecipAbove(a, b) => {
                self.generated("recip_above");
                self.arguments([a, b]);
            }
        }
    }

    /// A function that the crate keeps for generated code.
    pub fn generated(&mut self, function: &str) {
        self.tokens.extend(self.cx.mstmm.clone());
        self.step_into("generated");
        self.step_into(function);
    }

    fn infix(&mut self, a: &Operand, sign: char, b: &Operand) {
        self.operand(a);
        self.sign(sign);
        self.operand(b);
    }

    fn call<const N: usize>(&mut self, function: &str, operands: [&Operand; N]) {
        self.function(function);
        self.arguments(operands);
    }

    fn arguments<const N: usize>(&mut self, operands: [&Operand; N]) {
        self.group(Delimiter::Parenthesis, |arguments| {
            arguments.separated(&operands, |arguments, operand| arguments.operand(operand));
        });
    }

    /// An operand.
    pub fn operand(&mut self, operand: &Operand) {
        match operand {
            Operand::Number(value) => self.number(*value),
            Operand::Value(value) => self.name(*value),
            Operand::Minus(inner) => {
                self.call("negate", [inner]);
            }
        }
    }

    fn number(&mut self, value: f64) {
        self.variable(&helper("c"));
        self.group(Delimiter::Parenthesis, |number| {
            // A pivot that vanishes in every state leaves its reciprocal behind: the test of the
            // pivots comes first, but the number has to be written.
            if !value.is_finite() {
                for part in ["core", "f64", "NAN"] {
                    number.step_into(part);
                }
                return;
            }
            if value < 0.0 {
                number.sign('-');
            }
            number.literal(Literal::f64_unsuffixed(value.abs()));
        });
    }

    /// A function of the scalar.
    fn function(&mut self, name: &str) {
        self.word("T");
        self.step_into(name);
    }

    /// `::name`
    fn step_into(&mut self, name: &str) {
        self.tokens.push(Punct::new(':', Spacing::Joint).into());
        self.sign(':');
        self.word(name);
    }

    fn separated<T>(&mut self, items: &[T], write: impl Fn(&mut Self, &T)) {
        for (place, item) in items.iter().enumerate() {
            if place > 0 {
                self.sign(',');
            }
            write(self, item);
        }
    }

    /// What stands in brackets.
    pub fn group(&mut self, delimiter: Delimiter, write: impl FnOnce(&mut Self)) {
        let mut inner = Writer::new(self.cx, self.variables);
        write(&mut inner);
        self.tokens.push(Group::new(delimiter, inner.finish()).into());
    }

    /// A variable.
    pub fn variable(&mut self, variable: &Ident) {
        self.tokens.push(variable.clone().into());
    }

    /// The variable of a value.
    fn name(&mut self, name: ValueId) {
        self.variable(self.variables.get(name));
    }

    fn word(&mut self, word: &str) {
        self.tokens.push(Ident::new(word, Span::call_site()).into());
    }

    /// A sign that stands for itself.
    pub fn sign(&mut self, sign: char) {
        self.tokens.push(Punct::new(sign, Spacing::Alone).into());
    }

    /// A literal.
    pub fn literal(&mut self, literal: Literal) {
        self.tokens.push(literal.into());
    }
}
