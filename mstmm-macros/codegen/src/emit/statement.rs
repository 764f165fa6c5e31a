//! Writes statements token by token.
//!
//! A program has thousands of statements, and `quote!` would create a stream for every part of each. In a macro each stream
//! is a call into rustc. The writer creates one stream per program and one per bracketed group.

use super::EmitContext;
use super::columns::Varying;
use super::names::{Variables, helper};
use crate::program::{Operand, Operation, Section, SectionCost, Statement, ValueId, by_heading};
use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};

/// The smallest number of names in one declaration, if names are declared before they are computed.
const DECLARED: usize = 500;

/// Writes tokens.
pub struct Writer<'a> {
    cx: &'a EmitContext<'a>,
    variables: &'a Variables,
    varying: &'a Varying,
    tokens: Vec<TokenTree>,
}

impl<'a> Writer<'a> {
    /// Returns an empty writer for a procedure with these variables, some of which may differ between columns.
    pub fn new(cx: &'a EmitContext<'a>, variables: &'a Variables, varying: &'a Varying) -> Self {
        Writer { cx, variables, varying, tokens: Vec::new() }
    }

    /// Appends tokens.
    pub fn add(&mut self, tokens: TokenStream) {
        self.tokens.extend(tokens);
    }

    /// Returns the tokens.
    pub fn finish(self) -> TokenStream {
        self.tokens.into_iter().collect()
    }

    /// Returns the headings of sections with their operation counts, each once.
    pub fn headings<'s>(&self, sections: &[&'s Section]) -> Vec<SectionCost<'s>> {
        by_heading(sections.iter().copied())
    }

    /// Writes the heading of a section: with the operation count at its first occurrence, otherwise the title only.
    pub fn heading_of(&mut self, section: &Section, headings: &mut Vec<SectionCost>) {
        if !self.heading(section, headings) {
            self.documentation(&format!(" {}.", section.title));
        }
    }

    /// Writes the statements of a section, as declarations if `declaring`.
    pub fn statements(&mut self, section: &Section, declaring: bool) {
        for statement in &section.statements {
            if declaring {
                self.word("let");
            }
            self.statement(statement);
            self.sign(';');
        }
    }

    /// Declares the names of the sections from index `first` on, at least [`DECLARED`] names unless the sections end, under
    /// their headings, since only declarations can have docs. Returns the index of the next section.
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

    /// Writes the heading of a section with its operation count, and removes it from `headings`. Returns false if it is not
    /// among them.
    fn heading(&mut self, section: &Section, headings: &mut Vec<SectionCost>) -> bool {
        let same = |headed: &SectionCost| (headed.title, headed.source) == section.heading();
        let Some(first) = headings.iter().position(same) else { return false };
        let SectionCost { title, source, cost } = headings.remove(first);
        let source = if source.is_empty() { String::new() } else { format!(", {source}") };
        self.documentation(&format!(" {title}{source}: {cost}."));
        true
    }

    /// Writes a doc attribute, which survives the expansion, unlike a comment.
    fn documentation(&mut self, text: &str) {
        self.sign('#');
        self.group(Delimiter::Bracket, |attribute| {
            attribute.word("doc");
            attribute.sign('=');
            attribute.literal(Literal::string(text));
        });
    }

    fn statement(&mut self, statement: &Statement) {
        let varying = self.varying.statement(statement);
        match statement {
            Statement::Let(name, operation) => {
                self.name(*name);
                self.sign('=');
                self.operation(operation, varying);
            }
            Statement::Pack { pack, values } => {
                self.name(*pack);
                self.sign('=');
                self.pack(values);
            }
            Statement::Lane { value, pack, lane, negative } => {
                self.name(*value);
                self.sign('=');
                self.lane(*pack, *lane, *negative);
            }
            Statement::SinCos { sines, cosines, angles } => {
                if varying {
                    bug!("a product is not linear in its factor");
                }
                self.group(Delimiter::Parenthesis, |both| {
                    both.names(sines);
                    both.sign(',');
                    both.names(cosines);
                });
                self.sign('=');
                self.function("sin_cos", false);
                self.group(Delimiter::Parenthesis, |arguments| {
                    arguments.group(Delimiter::Bracket, |list| {
                        list.separated(angles, |list, angle| list.operand(angle, false));
                    });
                });
            }
        }
    }

    /// Writes `mstmm::generated::pack::<T, C>([…])`.
    fn pack(&mut self, values: &[Operand]) {
        self.generated("pack");
        self.lanes_of_scalars();
        self.group(Delimiter::Parenthesis, |arguments| {
            arguments.group(Delimiter::Bracket, |list| {
                list.separated(values, |list, value| list.operand(value, false));
            });
        });
    }

    /// Writes `mstmm::generated::lane::<T, C>(pack, lane)`, or its negative.
    fn lane(&mut self, pack: ValueId, lane: usize, negative: bool) {
        if negative {
            self.function("negate", false);
            return self.group(Delimiter::Parenthesis, |inner| inner.lane(pack, lane, false));
        }
        self.generated("lane");
        self.lanes_of_scalars();
        self.group(Delimiter::Parenthesis, |arguments| {
            arguments.name(pack);
            arguments.sign(',');
            arguments.literal(Literal::usize_unsuffixed(lane));
        });
    }

    /// Writes `::<T, C>`.
    fn lanes_of_scalars(&mut self) {
        self.tokens.push(Punct::new(':', Spacing::Joint).into());
        self.sign(':');
        self.sign('<');
        self.word("T");
        self.sign(',');
        self.word("C");
        self.sign('>');
    }

    /// Writes an array pattern of names, with `_` for missing names.
    fn names(&mut self, names: &[Option<ValueId>]) {
        self.group(Delimiter::Bracket, |pattern| {
            pattern.separated(names, |pattern, name| match name {
                Some(name) => pattern.name(*name),
                None => pattern.word("_"),
            });
        });
    }

    fn operation(&mut self, operation: &Operation, varying: bool) {
        match operation {
            Operation::Sum(a, b) => self.infix(a, '+', b, varying),
            Operation::Difference(a, b) => self.infix(a, '-', b, varying),
            Operation::Product(a, b) => self.infix(a, '*', b, varying),
            Operation::MulAdd(a, b, c) => self.call("mul_add", [a, b, c], varying),
            Operation::MulSub(a, b, c) => self.call("mul_sub", [a, b, c], varying),
            Operation::MulNegAdd(a, b, c) => self.call("mul_neg_add", [a, b, c], varying),
            Operation::Recip(a) => self.call("recip", [a], varying),
            Operation::Sqrt(a) => self.call("sqrt", [a], varying),
            Operation::CopySign(a, b) => self.call("copysign", [a, b], varying),
            Operation::Atan2(a, b) => self.call("atan2", [a, b], varying),
            Operation::RecipAbove(a, b) => {
                self.generated("recip_above");
                self.arguments([a, b], varying);
            }
        }
    }

    /// Writes the path of a function of `mstmm::generated`.
    pub fn generated(&mut self, function: &str) {
        self.tokens.extend(self.cx.mstmm.clone());
        self.step_into("generated");
        self.step_into(function);
    }

    fn infix(&mut self, a: &Operand, sign: char, b: &Operand, varying: bool) {
        self.operand(a, varying);
        self.sign(sign);
        self.operand(b, varying);
    }

    fn call<const N: usize>(&mut self, function: &str, operands: [&Operand; N], varying: bool) {
        self.function(function, varying);
        self.arguments(operands, varying);
    }

    fn arguments<const N: usize>(&mut self, operands: [&Operand; N], varying: bool) {
        self.group(Delimiter::Parenthesis, |arguments| {
            arguments
                .separated(&operands, |arguments, operand| arguments.operand(operand, varying));
        });
    }

    /// Writes an operand, of the type of columns if `varying`.
    pub fn operand(&mut self, operand: &Operand, varying: bool) {
        if varying && !self.varying.operand(operand) {
            self.function("repeated", true);
            return self.arguments([operand], false);
        }
        match operand {
            Operand::Number(value) => self.number(*value),
            Operand::Value(value) => self.name(*value),
            Operand::Minus(value) => {
                self.function("negate", varying);
                self.group(Delimiter::Parenthesis, |inner| inner.name(*value));
            }
        }
    }

    fn number(&mut self, value: f64) {
        self.variable(&helper("c"));
        self.group(Delimiter::Parenthesis, |number| {
            // The reciprocal of a pivot that vanishes in every state. The test of the pivots fails before anyone reads it,
            // but the literal must compile.
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

    /// Writes the path of a function of the scalar type, or of the type `C` of columns.
    fn function(&mut self, name: &str, varying: bool) {
        self.word(if varying { "C" } else { "T" });
        self.step_into(name);
    }

    /// Writes `::name`.
    fn step_into(&mut self, name: &str) {
        self.tokens.push(Punct::new(':', Spacing::Joint).into());
        self.sign(':');
        self.word(name);
    }

    fn separated<T>(&mut self, items: &[T], write: impl Fn(&mut Self, &T)) {
        for (index, item) in items.iter().enumerate() {
            if index > 0 {
                self.sign(',');
            }
            write(self, item);
        }
    }

    /// Writes a bracketed group.
    pub fn group(&mut self, delimiter: Delimiter, write: impl FnOnce(&mut Self)) {
        let mut inner = Writer::new(self.cx, self.variables, self.varying);
        write(&mut inner);
        self.tokens.push(Group::new(delimiter, inner.finish()).into());
    }

    /// Writes a variable.
    pub fn variable(&mut self, variable: &Ident) {
        self.tokens.push(variable.clone().into());
    }

    /// Writes the variable of a value.
    fn name(&mut self, name: ValueId) {
        self.variable(self.variables.get(name));
    }

    fn word(&mut self, word: &str) {
        self.tokens.push(Ident::new(word, Span::call_site()).into());
    }

    /// Writes a single punctuation character.
    pub fn sign(&mut self, sign: char) {
        self.tokens.push(Punct::new(sign, Spacing::Alone).into());
    }

    /// Writes a literal.
    pub fn literal(&mut self, literal: Literal) {
        self.tokens.push(literal.into());
    }
}
