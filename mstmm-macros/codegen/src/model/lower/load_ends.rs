//! The bodies and points that loads and springs act on.

use proc_macro2::Ident;

use super::context::Context;
use super::dimension::LENGTH;
use super::numbering::Numbering;
use super::place::{BodyPlace, POINTS, Resolved, body_extent, example_place, output_of};
use super::start::{self, Seeds};
use super::vector::zeros;
use crate::model::{BodyPoint, Dimension, Value};
use crate::syntax::{
    BlockKeyword, ExprKind, ExprSyntax, FieldSyntax, ListSyntax, PathSyntax, ValueSyntax,
};

/// The message for a spring on several bodies.
const BETWEEN_BODIES: &str = "a spring is between two bodies with `on = a.point; to = b.point;`";

/// The message for a force on the ground.
const FIXED: &str = "the ground is fixed: name a body on a route";

/// The message for the ground in place of a point.
const ON_GROUND: &str = "write the point on the ground: `to = [x, y, z] m`, inertial frame";

/// The other end of a spring.
pub(crate) enum SpringTo {
    /// A point on the ground.
    Ground([Value; 3]),
    /// A point of a body.
    Body(EndPoint),
    /// A point of a body of the previous repetition.
    Previous {
        /// The point.
        point: EndPoint,
        /// What it is in the first repetition.
        first: EndPoint,
    },
}

/// A point of a body.
pub(crate) struct EndPoint {
    /// The index of the body's item.
    item: usize,
    /// The point in m, body frame.
    at: [Value; 3],
}

impl EndPoint {
    /// Returns the point in the model.
    pub(super) fn finish(self, numbers: &Numbering) -> BodyPoint {
        BodyPoint { body: numbers.body(self.item), at: self.at }
    }
}

/// A body, and a point of it if one is given: `None` in it is reported as an error.
pub(super) type OnBody = (usize, Option<Option<[Value; 3]>>);

/// Reads the body that a load or a spring acts on, with its point or without.
pub(super) fn on(
    syntax: &ValueSyntax,
    of: BlockKeyword,
    scope: usize,
    resolved: Resolved,
    context: &mut Context,
) -> Option<OnBody> {
    match syntax {
        ValueSyntax::PlaceOn(body, _) if body == "ground" => {
            return context.refuse(body, FIXED);
        }
        ValueSyntax::PlaceOn(body, extent) => {
            let message = format!("write a point after the body, as in `on = {body}.point;`");
            return context.refuse(*extent, message);
        }
        ValueSyntax::Vector(ListSyntax { entries, .. })
            if entries.len() > 1
                && entries.iter().all(|entry| matches!(entry.kind, ExprKind::Name(_))) =>
        {
            let message = match of {
                BlockKeyword::Spring => BETWEEN_BODIES,
                _ => "a load acts on one body: write a `load` for each",
            };
            return context.refuse(entries[1].extent, message);
        }
        ValueSyntax::Path(path) => return on_path(path, scope, resolved, context),
        _ => {}
    }
    if let ValueSyntax::Vector(ListSyntax { entries, extent, .. }) = syntax
        && let [ExprSyntax { kind: ExprKind::Name(body), .. }] = &entries[..]
    {
        return context.refuse(*extent, format!("write the body without brackets: `on = {body}`"));
    }
    let Some(word) = syntax.word() else {
        let found = syntax.described();
        let ground = match syntax {
            ValueSyntax::Vector(_) if of == BlockKeyword::Spring => {
                ": write a point on the ground after `to`"
            }
            _ => "",
        };
        let message = format!("expected the name of a body on a route, found {found}{ground}");
        return context.refuse(syntax.extent(), message);
    };
    let names = std::slice::from_ref(word);
    let item = resolved.names.item(resolved.written, scope, names);
    match item.map(|item| (item, &resolved.items[item])) {
        Some((item, found)) if found.is_body() => Some((item, None)),
        Some((_, found)) if found.is_hinge() => {
            let message = format!("`{word}` is a hinge: name the body that the force acts on");
            context.refuse(word, message)
        }
        _ if word == "ground" => context.refuse(word, FIXED),
        _ => {
            let instance = resolved.names.instance(resolved.written, scope, names);
            if let Some(instance) = instance {
                let path = PathSyntax::name(word.clone());
                return context.refuse(word, resolved.part_message(&path, instance));
            }
            resolved.unknown_body(names, scope, context)
        }
    }
}

/// Reads a path to a body or to a place of a body.
fn on_path(
    path: &PathSyntax,
    scope: usize,
    resolved: Resolved,
    context: &mut Context,
) -> Option<OnBody> {
    if let Some(last) = path.last {
        let message = "`on` is a body of each repetition: remove `last.`, and write it in `to`";
        context.diagnostics.error(last, message);
        return None;
    }
    let item = resolved.names.item(resolved.written, scope, &path.names);
    if let Some(item) = item.filter(|&item| resolved.items[item].is_body()) {
        return Some((item, None));
    }
    let place = resolved.place(path, scope, context)?;
    Some((place.item, Some(resolved.position(place, path, context))))
}

/// The body that a load or a spring acts on.
pub(super) struct LoadTarget<'t, 'a> {
    /// The chain.
    pub resolved: Resolved<'t, 'a>,
    /// The body: the index of its item.
    pub body: Option<usize>,
    /// Its point, if `on` has one; `None` in it is reported as an error.
    pub at: Option<Option<[Value; 3]>>,
}

impl LoadTarget<'_, '_> {
    /// Reads the point of application, which is the centre of mass if it is omitted.
    pub fn at(&self, field: Option<&FieldSyntax>, context: &mut Context) -> Option<[Value; 3]> {
        if let Some(at) = &self.at {
            return at.clone();
        }
        let body_type = self.body.and_then(|body| self.resolved.type_of(body));
        let com = || body_type?.com.as_ref().map(|com| com.value.clone());
        match field {
            None => com(),
            Some(field) => {
                let at = |context: &mut Context, syntax: &ValueSyntax| match syntax.word() {
                    Some(word) if word == "com" => Some(com()),
                    Some(word) => self.point(word, syntax, context),
                    None => self.position(syntax, context).map(Some),
                };
                context.field(field, at)?.value
            }
        }
    }

    /// Reads a position; a place on the body is reported with the name of its point.
    fn position(&self, syntax: &ValueSyntax, context: &mut Context) -> Option<[Value; 3]> {
        if let ValueSyntax::Path(path) = syntax {
            let message = format!("a point of this body has a single name: `at = {}`", path.end());
            return context.refuse(path.extent(), message);
        }
        context.read_vector(syntax, LENGTH)
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
        let body_type = self.body.and_then(|body| self.resolved.type_of(body));
        let Some(body_type) = body_type else { return Some(None) };
        if word == "output" {
            return output_of(body_type, word, context).map(Some);
        }
        if let Some(point) = body_type.points.iter().find(|point| word == point.name) {
            return Some(point.frame.as_ref().map(|frame| frame.position.clone()));
        }
        if context.space == Dimension::Line {
            return context.read_vector(syntax, LENGTH).map(Some);
        }
        // It is reported already.
        if body_type.may_have_point(word) {
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

/// Reads the other end of a spring.
pub(super) fn spring_to(
    syntax: &ValueSyntax,
    scope: usize,
    target: &LoadTarget,
    seeds: &[Seeds],
    context: &mut Context,
) -> Option<SpringTo> {
    let resolved = target.resolved;
    let word = match syntax {
        ValueSyntax::Path(path) if path.last.is_some() => {
            let repeat = resolved.repeat_of(target.body?);
            let place = start::previous(path, scope, repeat, (resolved, seeds), context)?;
            let mut end = |place| end_point(place, path, resolved, context);
            let (point, first) = (end(place.previous), end(place.first));
            return Some(SpringTo::Previous { point: point?, first: first? });
        }
        ValueSyntax::Path(path) => return to_body(path, scope, target, context),
        ValueSyntax::PlaceOn(body, extent) if body == "ground" => {
            return context.refuse(*extent, ON_GROUND);
        }
        ValueSyntax::PlaceOn(body, extent) => {
            let message = format!("write a point after the body, as in `to = {body}.point;`");
            return context.refuse(*extent, message);
        }
        other => other.word(),
    };
    let Some(word) = word else {
        return context.read_vector(syntax, LENGTH).map(SpringTo::Ground);
    };
    if word == "ground" {
        return context.refuse(word, ON_GROUND);
    }
    let item = resolved.names.item(resolved.written, scope, std::slice::from_ref(word));
    if let Some(item) = item.filter(|&item| resolved.items[item].is_body()) {
        let point = resolved.type_of(item).map_or_else(|| "output".into(), example_place);
        let message = format!("name the place on `{word}`: `to = {word}.{point}`");
        return context.refuse(word, message);
    }
    if context.space != Dimension::Line && !begins_constant(word) {
        let message = format!(
            "expected a place on a body, as in `to = body.point`, or a vector for a point on the \
             ground; found `{word}`"
        );
        return context.refuse(word, message);
    }
    context.read_vector(syntax, LENGTH).map(SpringTo::Ground)
}

/// Returns whether a word looks like a Rust constant.
fn begins_constant(word: &Ident) -> bool {
    word.to_string().starts_with(char::is_uppercase)
}

fn end_point(
    place: BodyPlace,
    path: &PathSyntax,
    resolved: Resolved,
    context: &mut Context,
) -> Option<EndPoint> {
    let at = resolved.position(place, path, context)?;
    Some(EndPoint { item: place.item, at })
}

/// Reads a point of a body at the other end of a spring.
fn to_body(
    path: &PathSyntax,
    scope: usize,
    target: &LoadTarget,
    context: &mut Context,
) -> Option<SpringTo> {
    let resolved = target.resolved;
    let place = resolved.place(path, scope, context)?;
    let on = target.body?;
    if place.item == on {
        let message = format!("both ends of this spring are on `{}`", resolved.items[on].name()?);
        return context.refuse(body_extent(path), message);
    }
    let (of_to, of_on) = (resolved.repeat_of(place.item), resolved.repeat_of(on));
    if of_to.is_some() && of_to != of_on {
        let (to, on) = (resolved.items[place.item].name()?, resolved.items[on].name()?);
        let message = if of_on.is_none() {
            format!("`{to}` is repeated: write the spring with `on = {path}; to = {on}.place`")
        } else {
            format!("`{to}` is in another `repeat` than `{on}`: a spring cannot join them")
        };
        return context.refuse(body_extent(path), message);
    }
    end_point(place, path, resolved, context).map(SpringTo::Body)
}
