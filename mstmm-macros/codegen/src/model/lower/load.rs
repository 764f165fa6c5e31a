//! Loads and springs: `load name { … }` and `spring name { … }`.

use super::context::{Context, Spanned};
use super::dimension::{DAMPING, FORCE, LENGTH, STIFFNESS, TORQUE};
use super::fields::{self, FieldOwner, Fields};
use super::load_ends::{LoadTarget, SpringTo, on, spring_to};
use super::numbering::Numbering;
use super::parts::{ItemName, WrittenBlock};
use super::place::Resolved;
use super::start::Seeds;
use crate::diag::did_you_mean;
use crate::model::{BodyPoint, Dimension, Effort, Frame, LoadAxes, Source, SpringEnd, Value};
use crate::syntax::{BlockKeyword, BlockSyntax, ValueSyntax};

/// The fields of a load.
pub(super) const LOAD_FIELDS: &[&str] = &["on", "at", "force", "torque", "axes"];
/// A line chain has no torques.
const LINE_LOAD_FIELDS: &[&str] = &["on", "at", "force"];
pub(super) const SPRING_FIELDS: &[&str] =
    &["on", "at", "to", "stiffness", "damping", "length", "force"];
pub(super) const AXES: &[(&str, LoadAxes)] =
    &[("inertial", LoadAxes::Inertial), ("body", LoadAxes::Body)];

/// A load, as far as it is readable.
pub(crate) struct LoadDraft<'a> {
    block: &'a BlockSyntax,
    /// Its name.
    pub name: ItemName,
    /// The body that it acts on: the index of its item.
    pub body: Option<usize>,
    /// Where the force acts.
    pub at: Option<[Value; 3]>,
    /// The axes of force and torque.
    pub axes: Option<LoadAxes>,
    /// The force.
    pub force: Option<Source>,
    /// The torque.
    pub torque: Option<Source>,
}

/// A spring, as far as it is readable.
pub(crate) struct SpringDraft<'a> {
    block: &'a BlockSyntax,
    /// Its name.
    pub name: ItemName,
    /// The body that it acts on: the index of its item.
    pub body: Option<usize>,
    /// Its point of application.
    pub at: Option<[Value; 3]>,
    /// Its other end.
    pub to: Option<SpringTo>,
    /// Its stiffness; `Some(None)` if it is omitted.
    pub stiffness: Option<Option<Spanned<Value>>>,
    /// Its damping; `Some(None)` if it is omitted.
    pub damping: Option<Option<Spanned<Value>>>,
    /// Its length; `Some(None)` if it is omitted.
    pub length: Option<Option<Spanned<Value>>>,
    /// The force of its actuator.
    pub force: Option<Effort>,
}

/// The fields of a block of this word.
fn known_fields(word: BlockKeyword, space: Dimension) -> &'static [&'static str] {
    match (word, space) {
        (BlockKeyword::Load, Dimension::Line) => LINE_LOAD_FIELDS,
        (BlockKeyword::Load, _) => LOAD_FIELDS,
        _ => SPRING_FIELDS,
    }
}

/// All loads and springs.
pub(super) fn loads<'a>(
    resolved: Resolved<'_, 'a>,
    seeds: &[Seeds],
    context: &mut Context,
) -> (Vec<LoadDraft<'a>>, Vec<SpringDraft<'a>>) {
    let (mut loads, mut springs) = (Vec::new(), Vec::new());
    for written in &resolved.written.blocks {
        let block: &'a BlockSyntax = &written.syntax;
        let word = match block.word {
            BlockKeyword::Load => "load",
            BlockKeyword::Spring => "spring",
            BlockKeyword::Body | BlockKeyword::Hinge => continue,
        };
        if !block.after_route && !resolved.written.routes.is_empty() {
            context.diagnostics.error(block.at, format!("write a {word} after the route"));
        }
        let Some(name) = name_of(written, word, resolved, context) else { continue };
        let mut fields = Fields::default();
        let owner = format!("{word} `{name}`{}", context.of_chain());
        for field in &block.fields {
            let known = known_fields(block.word, context.space);
            fields.add(field, known, &FieldOwner::of_block(&owner, &block.fields), context);
        }
        let target = target(written, &fields, resolved, context);
        match block.word {
            BlockKeyword::Load => loads.push(load(block, name, &fields, &target, context)),
            _ => springs.push(spring(written, name, &fields, &target, seeds, context)),
        }
    }
    (loads, springs)
}

/// Returns the name of a load or of a spring, and reports further names.
fn name_of(
    written: &WrittenBlock,
    word: &str,
    resolved: Resolved,
    context: &mut Context,
) -> Option<ItemName> {
    let (path, others) = written.syntax.names.split_first()?;
    if let Some(other) = others.first() {
        let message = format!("a block describes one {word}: write a block for each");
        context.diagnostics.error_over(other.extent(), message);
    }
    if path.names.len() > 1 {
        let message = format!(
            "the name of a {word} is a single word: write `{word} {}_… {{ … }}`",
            path.names[0]
        );
        context.diagnostics.error_over(path.extent(), message);
    }
    Some(resolved.written.scopes[written.scope].item_name(path.end()))
}

/// Reads the body and the point that a load or a spring acts on.
fn target<'t, 'a>(
    written: &WrittenBlock,
    fields: &Fields,
    resolved: Resolved<'t, 'a>,
    context: &mut Context,
) -> LoadTarget<'t, 'a> {
    let read = |context: &mut Context, syntax: &ValueSyntax| {
        on(syntax, written.syntax.word, written.scope, resolved, context)
    };
    let on = fields.get("on").and_then(|field| context.field(field, read));
    if let (Some(Spanned { value, .. }), Some(at)) = (&on, fields.get("at"))
        && value.1.is_some()
    {
        let message = "`on` has a point already: remove `at`, or name only the body in `on`";
        context.diagnostics.error(at.name.span(), message);
    }
    let (body, at) = on.map_or((None, None), |on| (Some(on.value.0), on.value.1));
    LoadTarget { resolved, body, at }
}

fn load<'a>(
    block: &'a BlockSyntax,
    name: ItemName,
    fields: &Fields,
    target: &LoadTarget,
    context: &mut Context,
) -> LoadDraft<'a> {
    LoadDraft {
        block,
        name,
        body: target.body,
        at: target.at(fields.get("at"), context),
        axes: context.optional(fields.get("axes"), || LoadAxes::Inertial, axes),
        force: context.source(fields.get("force"), |context, it| context.read_vector(it, FORCE)),
        torque: context
            .source(fields.get("torque"), |context, it| context.read_rotational(it, TORQUE)),
    }
}

fn axes(context: &mut Context, syntax: &ValueSyntax) -> Option<LoadAxes> {
    let word = syntax.word().map_or_else(String::new, ToString::to_string);
    let axes = AXES.iter().find(|(name, _)| *name == word).map(|&(_, axes)| axes);
    if axes.is_none() {
        let hint = did_you_mean(&word, AXES.iter().map(|(name, _)| *name));
        let message = format!("expected `inertial` or `body`, found {}{hint}", syntax.described());
        context.diagnostics.error_over(syntax.extent(), message);
    }
    axes
}

fn spring<'a>(
    written: &'a WrittenBlock,
    name: ItemName,
    fields: &Fields,
    target: &LoadTarget,
    seeds: &[Seeds],
    context: &mut Context,
) -> SpringDraft<'a> {
    let [stiffness, damping, length] =
        [("stiffness", STIFFNESS), ("damping", DAMPING), ("length", LENGTH)].map(
            |(name, expected)| match fields.get(name) {
                None => Some(None),
                Some(field) => {
                    context.field(field, |context, it| context.read_number(it, expected)).map(Some)
                }
            },
        );
    let at = target.at(fields.get("at"), context);
    let to = |context: &mut Context, syntax: &ValueSyntax| {
        spring_to(syntax, written.scope, target, seeds, context)
    };
    SpringDraft {
        block: &written.syntax,
        name,
        body: target.body,
        at,
        to: fields.get("to").and_then(|field| context.field(field, to)).map(|to| to.value),
        stiffness,
        damping,
        length,
        force: context.optional(fields.get("force"), || Effort::Free, force),
    }
}

/// The force of a spring's actuator.
fn force(context: &mut Context, syntax: &ValueSyntax) -> Option<Effort> {
    match context.asks_for_input(syntax)? {
        true => Some(Effort::Input),
        false => context.read_number(syntax, FORCE).map(Effort::Constant),
    }
}

/// Those of `required` that a block lacks.
fn missing<'r>(block: &BlockSyntax, required: &[&'r str]) -> Vec<&'r str> {
    if !block.complete {
        return Vec::new();
    }
    fields::missing(&block.fields, required, known_fields(block.word, Dimension::Space))
}

impl LoadDraft<'_> {
    /// The fields that it lacks, in words.
    pub fn missing(&self) -> Vec<&'static str> {
        let on = missing(self.block, &["on"]).into_iter().map(|_| "`on`");
        let acting = missing(self.block, &["force", "torque"]);
        let acting = (acting.len() == 2).then_some("a `force` or a `torque`");
        on.chain(acting).collect()
    }

    /// Returns the load; `None` if a part is missing, which is reported then.
    pub(super) fn finish(self, numbers: &Numbering) -> Option<crate::model::Load> {
        let at = Frame { position: self.at?, ..Frame::identity() };
        Some(crate::model::Load {
            name: self.name.joined,
            path: self.name.path,
            body: numbers.body(self.body?),
            at,
            axes: self.axes?,
            force: self.force?,
            torque: self.torque?,
        })
    }
}

impl SpringDraft<'_> {
    /// Returns whether the caller gives the force of its actuator.
    pub fn has_input(&self) -> bool {
        self.force == Some(Effort::Input)
    }

    /// The fields that it lacks, in words.
    pub fn missing(&self) -> Vec<String> {
        let field = |name: &str| self.block.fields.iter().find(|field| field.name == name);
        let on = field("on");
        let is_body = |on: &ValueSyntax| on.word().is_some() || matches!(on, ValueSyntax::Path(_));
        let body = on.is_none_or(|on| on.value.as_ref().is_some_and(is_body));
        // If `on` is not one body, the second body replaces the point.
        let ends = if body { missing(self.block, &["on", "to"]) } else { Vec::new() };
        // An actuator needs no stiffness, unless it has a length at rest.
        // A length has no effect without a stiffness.
        let (acting, words) = match field("length") {
            Some(_) => (&["stiffness"][..], "`stiffness`"),
            None => (&["stiffness", "force"][..], "a `stiffness` or a `force`"),
        };
        let acting = (missing(self.block, acting).len() == acting.len()).then_some(words);
        let ends = ends.iter().map(|name| format!("`{name}`"));
        ends.chain(acting.map(str::to_owned)).collect()
    }

    /// Returns the spring; `None` if a part is missing, which is reported then.
    pub(super) fn finish(self, numbers: &Numbering) -> Option<crate::model::Spring> {
        let number =
            |field: Option<Spanned<Value>>| field.map_or(Value::number(0.0), |field| field.value);
        Some(crate::model::Spring {
            on: BodyPoint { body: numbers.body(self.body?), at: self.at? },
            to: match self.to? {
                SpringTo::Ground(point) => SpringEnd::Ground(point),
                SpringTo::Body(end) => SpringEnd::Body(end.finish(numbers)),
                SpringTo::Previous { point, first } => SpringEnd::Previous {
                    point: point.finish(numbers),
                    first: first.finish(numbers),
                },
            },
            name: self.name.joined,
            path: self.name.path,
            stiffness: number(self.stiffness?),
            damping: number(self.damping?),
            length: number(self.length?),
            force: self.force?,
        })
    }
}
