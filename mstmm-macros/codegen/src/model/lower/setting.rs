//! Settings of the whole chain: `gravity = …;`, `method = …;`, `results = …;` and `answers = …;`.

use super::context::{Context, Spanned};
use super::dimension::ACCELERATION;
use super::fields::{FieldOwner, Fields};
use super::words::can_name_parameter;
use crate::diag::{did_you_mean, nearest};
use crate::model::{
    ANSWER_WORDS, Foreign, OTHER_ANSWERS, Request, Results, SolutionMethod, Source,
};
use crate::syntax::{ChainSyntax, ExprKind, ExprSyntax, ListSyntax, SETTINGS, ValueSyntax};
use proc_macro2::Ident;
use std::fmt::Display;

pub(super) const METHODS: &[(&str, SolutionMethod)] =
    &[("riccati", SolutionMethod::Riccati), ("transfer", SolutionMethod::Transfer)];
/// Returns the flag of a result.
type ResultFlag = fn(&mut Results) -> &mut bool;
pub(super) const RESULTS: &[(&str, ResultFlag)] = &[
    ("poses", |results| &mut results.poses),
    ("velocities", |results| &mut results.velocities),
    ("z", |results| &mut results.z),
    ("energies", |results| &mut results.energies),
];

/// Settings of the whole chain, as far as they are readable.
pub(crate) struct Settings {
    /// Acceleration of free fall.
    pub gravity: Option<Source>,
    /// The method that solves for the accelerations.
    pub method: Option<Spanned<SolutionMethod>>,
    /// The results of the solution: everything unless `results` selects some.
    pub results: Results,
    /// What the chain answers beside the functions that every chain has, each with its word.
    pub requests: Vec<Spanned<Request>>,
}

/// All settings.
pub(super) fn settings(def: &ChainSyntax, context: &mut Context) -> Settings {
    let mut fields = Fields::default();
    let owner = format!("chain `{}`", def.name);
    for field in &def.settings {
        let name = field.name.to_string();
        if nearest(&name, SETTINGS.iter().copied()).is_none() {
            let hint = match can_name_parameter(&name) {
                true => format!("; for a parameter write `param {name} = …`"),
                false => String::new(),
            };
            let message = format!("unknown setting `{name}`{hint}");
            context.diagnostics.error(field.name.span(), message);
            // The number may be used later.
            context.complete = false;
            continue;
        }
        fields.add(field, SETTINGS, &FieldOwner::of_block(&owner, &def.settings), context);
    }
    let gravity = context
        .source(fields.get("gravity"), |context, syntax| context.read_vector(syntax, ACCELERATION));
    let method = fields.get("method").and_then(|field| context.field(field, method));
    let results = fields.get("results").and_then(|field| context.field(field, results));
    let answers = fields.get("answers").and_then(|field| context.field(field, answers));
    Settings {
        gravity,
        method,
        results: results.map_or(Results::ALL, |setting| setting.value),
        requests: answers.map_or_else(Vec::new, |setting| setting.value),
    }
}

fn method(context: &mut Context, syntax: &ValueSyntax) -> Option<SolutionMethod> {
    let word = syntax.word().map_or_else(String::new, ToString::to_string);
    let method = METHODS.iter().find(|(name, _)| *name == word).map(|&(_, method)| method);
    if method.is_none() {
        let hint = did_you_mean(&word, METHODS.iter().map(|(name, _)| *name));
        let found = syntax.described();
        let message = format!("expected `riccati` or `transfer`, found {found}{hint}");
        context.diagnostics.error_over(syntax.extent(), message);
    }
    method
}

fn results(context: &mut Context, syntax: &ValueSyntax) -> Option<Results> {
    let chosen = chosen(
        context,
        syntax,
        &Choices { keywords: RESULTS, others: &[], example: "[z, poses]" },
    )?;
    let mut results = Results::NONE;
    chosen.into_iter().for_each(|result| *(result.value)(&mut results) = true);
    Some(results)
}

/// Reads the requests. A request that two words stand for belongs to the first.
fn answers(context: &mut Context, syntax: &ValueSyntax) -> Option<Vec<Spanned<Request>>> {
    let choices =
        Choices { keywords: ANSWER_WORDS, others: OTHER_ANSWERS, example: "[basic, linearize]" };
    let words = chosen(context, syntax, &choices)?;
    let of_word = |word: Spanned<&'static [Request]>| {
        word.value.iter().map(move |&value| Spanned { value, at: word.at })
    };
    let mut requests: Vec<Spanned<Request>> = words.into_iter().flat_map(of_word).collect();
    requests.sort_by_key(|request| request.value);
    requests.dedup_by_key(|request| request.value);
    Some(requests)
}

/// Keywords that may be chosen.
struct Choices<'a, T> {
    keywords: &'a [(&'a str, T)],
    /// Words for the same in other programs.
    others: &'a [(&'a str, Foreign)],
    /// An example of several keywords.
    example: &'a str,
}

/// Reads one keyword, or several in brackets, each at most once.
fn chosen<T: Copy>(
    context: &mut Context,
    syntax: &ValueSyntax,
    words: &Choices<T>,
) -> Option<Vec<Spanned<T>>> {
    let entries = match syntax {
        ValueSyntax::Number(entry) => std::slice::from_ref(entry),
        ValueSyntax::Vector(ListSyntax { unit: Some(unit), .. }) => {
            return context.refuse(unit.extent, "a keyword has no unit: remove the unit");
        }
        ValueSyntax::Vector(ListSyntax { entries, extent, .. }) if entries.is_empty() => {
            return context.refuse(*extent, words.missing("nothing"));
        }
        ValueSyntax::Vector(ListSyntax { entries, .. }) => entries,
        _ => return context.refuse(syntax.extent(), words.missing(syntax.described())),
    };
    let (mut chosen, mut right): (Vec<usize>, bool) = (Vec::new(), true);
    for entry in entries {
        right &= words.choose(context, entry, &mut chosen).is_some();
    }
    let spanned = |(number, entry): (usize, &ExprSyntax)| Spanned {
        value: words.keywords[number].1,
        at: entry.extent,
    };
    right.then(|| chosen.into_iter().zip(entries).map(spanned).collect())
}

impl<T> Choices<'_, T> {
    fn choose(
        &self,
        context: &mut Context,
        entry: &ExprSyntax,
        chosen: &mut Vec<usize>,
    ) -> Option<()> {
        let position = |name: &str| self.keywords.iter().position(|(word, _)| *word == name);
        let word = match &entry.kind {
            ExprKind::Name(word) => word,
            ExprKind::Quantity(of, unit) if matches!(of.kind, ExprKind::Name(_)) => {
                let second = unit.factors.first().map(|factor| factor.symbol.as_str());
                let message = match second.filter(|second| position(second).is_some()) {
                    Some(second) => format!("write `,` before `{second}`"),
                    None => "a keyword has no unit: remove the unit".to_owned(),
                };
                return context.refuse(unit.extent, message);
            }
            ExprKind::Parenthesized(_) => {
                return context.refuse(entry.extent, "a keyword has no parentheses: remove them");
            }
            _ => return context.refuse(entry.extent, self.missing("a number")),
        };
        let Some(number) = position(&word.to_string()) else {
            return context.refuse(word, self.unknown(word));
        };
        if chosen.contains(&number) {
            return context.refuse(word, format!("`{word}` is given twice"));
        }
        chosen.push(number);
        Some(())
    }

    /// Returns the message for a word that is no keyword.
    fn unknown(&self, word: &Ident) -> String {
        let name = word.to_string();
        let mut others = self.others.iter().filter(|(other, _)| other.eq_ignore_ascii_case(&name));
        match others.next() {
            Some((_, Foreign::OfAll(method))) => {
                format!("every chain has `{method}`: remove `{word}`")
            }
            Some((_, Foreign::Keyword(meant))) => {
                self.missing(format!("`{word}`; did you mean `{meant}`?"))
            }
            None => {
                let hint = did_you_mean(&name, self.keywords.iter().map(|(word, _)| *word));
                self.missing(format!("`{word}`{hint}"))
            }
        }
    }

    fn missing(&self, found: impl Display) -> String {
        let keywords: Vec<String> =
            self.keywords.iter().map(|(word, _)| format!("`{word}`")).collect();
        match &keywords[..] {
            [only] => format!("expected {only}, found {found}"),
            _ => {
                let (keywords, example) = (keywords.join(", "), self.example);
                format!("expected {keywords} or several of them as in `{example}`, found {found}")
            }
        }
    }
}
