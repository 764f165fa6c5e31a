//! Vectors: several numbers of one quantity.

use super::context::{Context, Measure, Spanned};
use super::dimension::Quantity;
use super::number::Measured;
use super::unit::misread_symbol;
use crate::diag::did_you_mean;
use crate::model::{Dimension, Source, Value};
use crate::syntax::{
    ExprKind, ExprSyntax, FORMS, FieldSyntax, FormSyntax, ListSyntax, SpanRange, ValueSyntax,
};

impl Context<'_> {
    /// Reads a number after `=`.
    pub fn read_number(&mut self, syntax: &ValueSyntax, expected: &Quantity) -> Option<Value> {
        match syntax {
            ValueSyntax::Number(expr) => self.number(expr, expected),
            ValueSyntax::Form(form) if FORMS.iter().all(|known| form.word != known) => {
                self.unknown_function(&form.word)
            }
            ValueSyntax::Vector(list) => {
                let message =
                    format!("expected {} as a single number, found a vector", expected.name);
                self.refuse(list.extent, message)
            }
            other => {
                let message = format!("expected {}, found {}", expected.name, other.described());
                self.refuse(other.extent(), message)
            }
        }
    }

    /// Reads a vector of the chain's dimension after `=`, which is a number in a line chain.
    /// Components outside the dimension are zero.
    pub fn read_vector(&mut self, syntax: &ValueSyntax, expected: &Quantity) -> Option<[Value; 3]> {
        let mut vector = zeros();
        let translations = self.space.translations();
        for (&axis, part) in
            translations.iter().zip(self.components(syntax, translations.len(), expected)?)
        {
            vector[axis] = part;
        }
        Some(vector)
    }

    /// Reads a vector of rotations in the chain's dimension after `=`: a vector in space, a number
    /// in a plane chain.
    pub fn read_rotational(
        &mut self,
        syntax: &ValueSyntax,
        expected: &Quantity,
    ) -> Option<[Value; 3]> {
        let mut vector = zeros();
        let rotations = self.space.rotations();
        for (&axis, part) in
            rotations.iter().zip(self.components(syntax, rotations.len(), expected)?)
        {
            vector[axis] = part;
        }
        Some(vector)
    }

    /// Reads `count` numbers after `=`; a single one has no brackets.
    pub fn components(
        &mut self,
        syntax: &ValueSyntax,
        count: usize,
        expected: &Quantity,
    ) -> Option<Vec<Value>> {
        if count == 1 {
            return self.read_number(syntax, expected).map(|number| vec![number]);
        }
        match syntax {
            ValueSyntax::Vector(list) => self.vector(list, count, expected),
            ValueSyntax::Turned(_, orientation) => {
                let message =
                    format!("a vector has no orientation: write only `{}`", brackets(count));
                self.refuse(orientation.extent(), message)
            }
            ValueSyntax::Form(form) if FORMS.iter().all(|known| form.word != known) => {
                self.unknown_function(&form.word)
            }
            other => {
                if let Some((unit, message)) = misread_unit(other, expected) {
                    return self.refuse(unit, message);
                }
                let found = other.described();
                let message = format!("expected a vector `{}`, found {found}", brackets(count));
                self.refuse(other.extent(), message)
            }
        }
    }

    /// Reads `count` numbers after `=`, or one number for all of them.
    pub fn each(
        &mut self,
        syntax: &ValueSyntax,
        count: usize,
        expected: &Quantity,
    ) -> Option<Vec<Value>> {
        match syntax {
            ValueSyntax::Vector(list) if count > 1 => self.vector(list, count, expected),
            other => self.read_number(other, expected).map(|number| vec![number; count]),
        }
    }

    /// Reads `count` components.
    pub fn vector(
        &mut self,
        list: &ListSyntax,
        count: usize,
        expected: &Quantity,
    ) -> Option<Vec<Value>> {
        let found = list.entries.len();
        if found != count {
            let message = if count == self.space.translations().len() {
                let chain = self.of_chain();
                let is_plane = (self.space, found) == (Dimension::Space, 2);
                let hint = if is_plane { "; a `plane chain` has 2" } else { "" };
                format!("expected {count} components of a vector{chain}, found {found}{hint}")
            } else {
                format!("expected {count} numbers `{}`, found {found}", brackets(count))
            };
            return self.refuse(list.extent, message);
        }
        self.numbers(list, expected)
    }

    /// Reads the numbers in the parentheses of a form.
    pub fn form_numbers<const N: usize>(
        &mut self,
        form: &FormSyntax,
        names: [&str; N],
        expected: &Quantity,
    ) -> Option<[Value; N]> {
        if form.list.entries.len() != N {
            let (word, found) = (&form.word, form.list.entries.len());
            let message = format!("expected `{word}({})`, found {found} numbers", names.join(", "));
            return self.refuse(form.list.extent, message);
        }
        self.numbers(&form.list, expected)?.try_into().ok()
    }

    fn numbers(&mut self, list: &ListSyntax, expected: &Quantity) -> Option<Vec<Value>> {
        // All entries are read before returning, so that all errors in them are reported.
        let parts: Vec<_> = list.entries.iter().map(|entry| self.measure(entry)).collect();
        let unit = list.unit.as_ref().map(|unit| (unit, self.unit(unit)));
        let mut parts: Vec<_> = parts.into_iter().collect::<Option<_>>()?;
        if let Some((unit, resolved)) = unit {
            let (scale, dimension) = resolved?;
            if parts.len() > 1 && parts.iter().all(Measured::has_unit) {
                let message = format!("the numbers have units already: remove `{}`", unit.text());
                return self.refuse(unit.extent, message);
            }
            let bare =
                parts.iter().map(|part| self.expect_no_unit(part)).fold(Some(()), Option::and);
            bare?;
            let complete = Measured {
                value: Value::number(1.0),
                measure: Measure::Of(dimension),
                unit: Some(unit),
                at: unit.extent,
            };
            self.expect(&complete, expected)?;
            for part in &mut parts {
                part.value = scale.apply(part.value.clone());
            }
        } else {
            let fits =
                parts.iter().map(|part| self.expect(part, expected)).fold(Some(()), Option::and);
            fits?;
            self.common_measure(&parts, "one vector")?;
            for (part, entry) in parts.iter().zip(&list.entries) {
                self.warn_of_degrees(part, entry, expected);
            }
        }
        let values = parts.into_iter().zip(&list.entries);
        let values: Vec<_> =
            values.map(|(part, entry)| self.finite(part.value, entry.extent)).collect();
        values.into_iter().collect()
    }

    /// Reads a vector that may be omitted or be `input`.
    pub fn source(
        &mut self,
        field: Option<&FieldSyntax>,
        read: impl FnOnce(&mut Self, &ValueSyntax) -> Option<[Value; 3]>,
    ) -> Option<Source> {
        self.optional(
            field,
            || Source::Nothing,
            |context, syntax| match context.asks_for_input(syntax)? {
                true => Some(Source::Input),
                false => read(context, syntax).map(Source::Constant),
            },
        )
    }

    /// Returns whether this is the keyword `input`, which the field may be. A misspelt one is reported.
    pub fn asks_for_input(&mut self, syntax: &ValueSyntax) -> Option<bool> {
        self.may_be_input = true;
        let Some(word) = syntax.word() else { return Some(false) };
        let text = word.to_string();
        let is_parameter = self.parameters.iter().any(|other| other.name == word);
        let is_constant = text == text.to_uppercase();
        let hint = did_you_mean(&text, ["input"]);
        if word == "input" || is_parameter || is_constant || hint.is_empty() {
            return Some(word == "input");
        }
        self.refuse(word, format!("unknown word `{word}`{hint}"))
    }

    /// Reads a field that may be omitted.
    pub fn optional<T>(
        &mut self,
        field: Option<&FieldSyntax>,
        default: impl FnOnce() -> T,
        read: impl FnOnce(&mut Self, &ValueSyntax) -> Option<T>,
    ) -> Option<T> {
        match field {
            None => Some(default()),
            Some(field) => self.field(field, read).map(|Spanned { value, .. }| value),
        }
    }

    /// Reads a field that may be omitted. A field with an error, which is reported, counts as
    /// omitted, so that the others are still checked.
    pub fn readable<T>(
        &mut self,
        field: Option<&FieldSyntax>,
        default: impl Fn() -> T,
        read: impl FnOnce(&mut Self, &ValueSyntax) -> Option<T>,
    ) -> T {
        self.optional(field, &default, read).unwrap_or_else(default)
    }
}

/// Returns the unit of a single number if the unit has another usual meaning.
fn misread_unit(syntax: &ValueSyntax, expected: &Quantity) -> Option<(SpanRange, &'static str)> {
    let ValueSyntax::Number(ExprSyntax { kind: ExprKind::Quantity(_, unit), .. }) = syntax else {
        return None;
    };
    Some((unit.extent, misread_symbol(unit, expected)?))
}

/// Returns an example of a vector with `count` components.
fn brackets(count: usize) -> &'static str {
    match count {
        2 => "[a, b]",
        _ => "[x, y, z]",
    }
}

/// Three zeros.
pub(super) fn zeros() -> [Value; 3] {
    [(); 3].map(|()| Value::number(0.0))
}
