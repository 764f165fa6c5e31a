//! Loads and springs: `load name { … }` and `spring name { … }`.

use proc_macro2::Ident;

use super::body::BodyType;
use super::context::{Context, Spanned};
use super::dimension::{DAMPING, FORCE, LENGTH, STIFFNESS, TORQUE};
use super::fields::{self, Fields};
use super::properties::has_duplicates;
use super::route::RouteItem;
use super::vector::zeros;
use crate::diag::did_you_mean;
use crate::model::{BodyId, BodyPoint, Dimension, Frame, LoadAxes, Source, SpringEnd, Value};
use crate::syntax::{
    BlockKeyword, BlockSyntax, ChainSyntax, FieldSyntax, ListSyntax, SpanRange, ValueSyntax,
};

/// The fields of a load.
pub(super) const LOAD_FIELDS: &[&str] = &["on", "at", "force", "torque", "axes"];
/// A line chain has no torques.
const LINE_LOAD_FIELDS: &[&str] = &["on", "at", "force"];
pub(super) const SPRING_FIELDS: &[&str] = &["on", "at", "to", "stiffness", "damping", "length"];
/// The message for a spring between two bodies.
const BETWEEN_BODIES: &str = "a spring connects a body to the ground: between two bodies write \
                              two loads with `force = input`, and give them opposite forces at \
                              each step";
/// The points that every body has.
pub(crate) const POINTS: &[&str] = &["input", "output", "com"];
pub(super) const AXES: &[(&str, LoadAxes)] =
    &[("inertial", LoadAxes::Inertial), ("body", LoadAxes::Body)];

/// A load, as far as it is readable.
pub(crate) struct LoadDraft<'a> {
    block: &'a BlockSyntax,
    /// Its name.
    pub name: &'a Ident,
    /// The body that it acts on.
    pub body: Option<BodyId>,
    /// Where the force acts.
    pub at: Option<[Value; 3]>,
    /// The axes of force and torque.
    pub axes: Option<LoadAxes>,
    /// The force.
    pub force: Option<Source>,
    /// The torque.
    pub torque: Option<Source>,
}

/// A spring to the ground, as far as it is readable.
pub(crate) struct SpringDraft<'a> {
    block: &'a BlockSyntax,
    /// Its name.
    pub name: &'a Ident,
    /// The body that it acts on.
    pub body: Option<BodyId>,
    /// Its point of application.
    pub at: Option<[Value; 3]>,
    /// The point on the ground.
    pub to: Option<[Value; 3]>,
    /// Its stiffness.
    pub stiffness: Option<Spanned<Value>>,
    /// Its damping; `Some(None)` if it is omitted.
    pub damping: Option<Option<Spanned<Value>>>,
    /// Its length; `Some(None)` if it is omitted.
    pub length: Option<Option<Spanned<Value>>>,
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
    def: &'a ChainSyntax,
    items: &[RouteItem],
    types: &[BodyType],
    context: &mut Context,
) -> (Vec<LoadDraft<'a>>, Vec<SpringDraft<'a>>) {
    let (mut loads, mut springs) = (Vec::new(), Vec::new());
    for block in &def.blocks {
        let word = match block.word {
            BlockKeyword::Load => "load",
            BlockKeyword::Spring => "spring",
            BlockKeyword::Body | BlockKeyword::Hinge => continue,
        };
        if !block.after_route && def.route.is_some() {
            context.diagnostics.error(block.at, format!("write a {word} after the route"));
        }
        let Some((name, others)) = block.names.split_first() else { continue };
        if let Some(other) = others.first() {
            context.diagnostics.error(
                other.span(),
                format!(
                    "a block describes one {word}: write \
                a block for each"
                ),
            );
        }
        let mut fields = Fields::default();
        let owner = format!("{word} `{name}`{}", context.of_chain());
        for field in &block.fields {
            fields.add(field, known_fields(block.word, context.space), &owner, context);
        }
        let on = fields.get("on").and_then(|field| {
            context.field(field, |context, syntax| on(syntax, block.word, def, items, context))
        });
        let target = LoadTarget { items, types, body: on.map(|on| on.value) };
        match block.word {
            BlockKeyword::Load => loads.push(load(block, name, &fields, &target, context)),
            _ => springs.push(spring(block, name, &fields, &target, context)),
        }
    }
    (loads, springs)
}

/// Reads the body that a load or a spring acts on.
fn on(
    syntax: &ValueSyntax,
    of: BlockKeyword,
    def: &ChainSyntax,
    items: &[RouteItem],
    context: &mut Context,
) -> Option<BodyId> {
    let bodies = || items.iter().filter(|item| matches!(item, RouteItem::Body { .. }));
    if let ValueSyntax::PlaceOn(body, extent) = syntax {
        let message = format!("a point is a separate field: write `on = {body}; at = …;`");
        return context.refuse(*extent, message);
    }
    if let ValueSyntax::Vector(ListSyntax { entries, .. }) = syntax
        && let [_, second, ..] = &entries[..]
    {
        let message = match of {
            BlockKeyword::Spring => BETWEEN_BODIES,
            _ => "a load acts on one body: write a `load` for each",
        };
        return context.refuse(second.extent, message);
    }
    let Some(word) = syntax.word() else {
        let found = syntax.described();
        let message = format!("expected the name of a body on the route, found {found}");
        return context.refuse(syntax.extent(), message);
    };
    if let Some(body) = bodies().position(|item| item.name() == Some(word)) {
        return Some(BodyId(body));
    }
    let is_unknown = |item: &RouteItem| matches!(item, RouteItem::Unknown { name } if name.is_none_or(|name| name == word));
    if !def.route.as_ref().is_some_and(|route| route.complete)
        || items.iter().any(is_unknown)
        || has_duplicates(items, |item| matches!(item, RouteItem::Body { .. }))
    {
        return None;
    }
    if items
        .iter()
        .any(|item| matches!(item, RouteItem::Hinge { name: Some(name), .. } if *name == word))
    {
        return context.refuse(
            word,
            format!(
                "`{word}` is a hinge: name the body that the force \
                                             acts on"
            ),
        );
    }
    if word == "ground" {
        return context.refuse(word, "the ground is fixed: name a body on the route");
    }
    let hint = context.hint(word, bodies().filter_map(RouteItem::name));
    let names = bodies().filter_map(RouteItem::name);
    let message = format!("no body `{word}` on the route{hint}");
    context.diagnostics.unknown(word, message, names);
    None
}

/// The body that a load or a spring acts on.
struct LoadTarget<'t, 'a> {
    items: &'t [RouteItem<'a>],
    types: &'t [BodyType<'a>],
    body: Option<BodyId>,
}

impl LoadTarget<'_, '_> {
    fn body_type(&self) -> Option<&BodyType<'_>> {
        let mut types = self.items.iter().filter_map(|item| match item {
            RouteItem::Body { body_type, .. } => Some(*body_type),
            _ => None,
        });
        self.types.get(types.nth(self.body?.index())??)
    }

    /// Reads the point of application, which is the centre of mass if it is omitted.
    fn at(&self, field: Option<&FieldSyntax>, context: &mut Context) -> Option<[Value; 3]> {
        let com = || self.body_type()?.com.as_ref().map(|com| com.value.clone());
        match field {
            None => com(),
            Some(field) => {
                let at = |context: &mut Context, syntax: &ValueSyntax| match syntax.word() {
                    Some(word) if word == "com" => Some(com()),
                    Some(word) => self.point(word, syntax, context),
                    None => context.read_vector(syntax, LENGTH).map(Some),
                };
                context.field(field, at)?.value
            }
        }
    }

    /// Reads a named point; `Some(None)` if it has no position, which is reported.
    fn point(
        &self,
        word: &Ident,
        syntax: &ValueSyntax,
        context: &mut Context,
    ) -> Option<Option<[Value; 3]>> {
        if word == "input" {
            return Some(Some(zeros()));
        }
        let Some(body_type) = self.body_type() else { return Some(None) };
        if word == "output" {
            if body_type.missing(true).contains(&"output") {
                let message =
                    format!("body `{}` has no output: give its type an `output`", body_type.name);
                return context.refuse(word, message);
            }
            return Some(body_type.output.as_ref().map(|output| output.value.position.clone()));
        }
        if let Some(point) = body_type.points.iter().find(|point| word == point.name) {
            return Some(point.position.clone());
        }
        if context.space == Dimension::Line {
            return context.read_vector(syntax, LENGTH).map(Some);
        }
        // The unknown field is reported already.
        if body_type.has_unknown_field(word) {
            return Some(None);
        }
        let names = body_type.points.iter().map(|point| point.name.to_string());
        let every_body_has = POINTS.iter().map(|name| (*name).to_owned());
        let hint = context.hint(word, names.chain(every_body_has));
        let message = format!("body `{}` has no point `{word}`{hint}", body_type.name);
        let points = body_type.points.iter().map(|point| point.name);
        context.diagnostics.unknown(word, message, points);
        None
    }
}

fn load<'a>(
    block: &'a BlockSyntax,
    name: &'a Ident,
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
    block: &'a BlockSyntax,
    name: &'a Ident,
    fields: &Fields,
    target: &LoadTarget,
    context: &mut Context,
) -> SpringDraft<'a> {
    let to = |context: &mut Context, syntax: &ValueSyntax| match not_on_ground(syntax, target) {
        Some((at, message)) => context.refuse(at, message),
        None => context.read_vector(syntax, LENGTH),
    };
    let [stiffness, damping, length] =
        [("stiffness", STIFFNESS), ("damping", DAMPING), ("length", LENGTH)].map(
            |(name, expected)| match fields.get(name) {
                None => Some(None),
                Some(field) => {
                    context.field(field, |context, it| context.read_number(it, expected)).map(Some)
                }
            },
        );
    SpringDraft {
        block,
        name,
        body: target.body,
        at: target.at(fields.get("at"), context),
        to: fields.get("to").and_then(|field| context.field(field, to)).map(|to| to.value),
        stiffness: stiffness.flatten(),
        damping,
        length,
    }
}

/// Returns the span and the message if the end of a spring is not a point on the ground.
fn not_on_ground(syntax: &ValueSyntax, target: &LoadTarget) -> Option<(SpanRange, String)> {
    let word = match syntax {
        ValueSyntax::PlaceOn(body, _) => body,
        other => other.word()?,
    };
    let at = SpanRange::token(word.span());
    if word == "ground" {
        let message = "write the point on the ground: `to = [x, y, z] m`, inertial frame";
        return Some((at, message.into()));
    }
    let is_it =
        |item: &RouteItem| matches!(item, RouteItem::Body { .. }) && item.name() == Some(word);
    target.items.iter().any(is_it).then(|| (at, BETWEEN_BODIES.into()))
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
    pub(super) fn finish(self) -> Option<crate::model::Load> {
        let at = Frame { position: self.at?, ..Frame::identity() };
        Some(crate::model::Load {
            name: self.name.clone(),
            body: self.body?,
            at,
            axes: self.axes?,
            force: self.force?,
            torque: self.torque?,
        })
    }
}

impl SpringDraft<'_> {
    /// The fields that it lacks, in words.
    pub fn missing(&self) -> Vec<String> {
        let on = self.block.fields.iter().find(|field| field.name == "on");
        let body = on.is_none_or(|on| on.value.as_ref().is_some_and(|on| on.word().is_some()));
        // If `on` is not one body, the second body replaces the point.
        let required = if body { &["on", "to", "stiffness"][..] } else { &["stiffness"] };
        let missing = missing(self.block, required);
        missing.iter().map(|name| format!("`{name}`")).collect()
    }

    /// Returns the spring; `None` if a part is missing, which is reported then.
    pub(super) fn finish(self) -> Option<crate::model::Spring> {
        let number =
            |field: Option<Spanned<Value>>| field.map_or(Value::number(0.0), |field| field.value);
        Some(crate::model::Spring {
            name: self.name.clone(),
            path: self.name.to_string(),
            on: BodyPoint { body: self.body?, at: self.at? },
            to: SpringEnd::Ground(self.to?),
            stiffness: self.stiffness?.value,
            damping: number(self.damping?),
            length: number(self.length?),
        })
    }
}
