//! Places: the input, the output and the points of bodies, by their paths.

use proc_macro2::Ident;

use super::body::{BodyType, BodyTypes};
use super::context::Context;
use super::fields::listed;
use super::names::NameTable;
use super::parts::WrittenOut;
use super::route_item::RouteItem;
use super::vector::zeros;
use crate::diag::did_you_mean;
use crate::model::Value;
use crate::syntax::{PathSyntax, SpanRange};

/// The points that every body has.
pub(crate) const POINTS: &[&str] = &["input", "output", "com"];

/// A place of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct BodyPlace {
    /// The body: the index of its item.
    pub item: usize,
    /// The point.
    pub point: PlacePoint,
}

/// A point of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PlacePoint {
    /// The input.
    Input,
    /// The output.
    Output,
    /// The centre of mass.
    Com,
    /// A named point, by its index in the type.
    Named(usize),
}

/// The items of a chain and their names.
#[derive(Clone, Copy)]
pub(crate) struct Resolved<'t, 'a> {
    /// The chain with its parts written out.
    pub written: &'a WrittenOut<'a>,
    /// The items.
    pub items: &'t [RouteItem<'a>],
    /// The body types.
    pub types: &'t BodyTypes<'a>,
    /// The names of the items.
    pub names: &'t NameTable,
}

impl<'t, 'a> Resolved<'t, 'a> {
    /// Returns the type of a body.
    pub fn type_of(&self, item: usize) -> Option<&'t BodyType<'a>> {
        match &self.items[item] {
            RouteItem::Body { body_type, .. } => Some(&self.types.all[(*body_type)?]),
            _ => None,
        }
    }

    /// Returns the repeated part that an item is in.
    pub fn repeat_of(&self, item: usize) -> Option<usize> {
        self.written.items[item].repeat
    }

    /// Returns a place, or reports that there is none; `last` is ignored.
    pub(super) fn place(
        &self,
        path: &PathSyntax,
        scope: usize,
        context: &mut Context,
    ) -> Option<BodyPlace> {
        let (point, body) = path.names.split_last()?;
        let Some(item) = self.names.item(self.written, scope, body) else {
            return self.no_body(path, scope, context);
        };
        let name = body.last()?;
        let shown = PathSyntax { last: None, names: body.to_vec() };
        match &self.items[item] {
            RouteItem::Body { body_type, .. } => {
                let body_type = &self.types.all[(*body_type)?];
                match point_named(body_type, point) {
                    Some(point) => Some(BodyPlace { item, point }),
                    None => no_place(&shown, point, body_type, context),
                }
            }
            RouteItem::Hinge { .. } => {
                context.refuse(name, format!("`{shown}` is a hinge: name a body and a place on it"))
            }
            RouteItem::Moving { .. } => {
                let message = format!("`{shown}` is a moving end and has no places");
                context.refuse(name, message)
            }
            // These are reported already.
            RouteItem::Unknown { .. } | RouteItem::Duplicate { .. } => None,
            RouteItem::Ground { .. } => bug!("the ground has a name"),
        }
    }

    /// Returns the position of a place in the body frame, in m. A missing output is reported.
    pub(super) fn position(
        &self,
        place: BodyPlace,
        path: &PathSyntax,
        context: &mut Context,
    ) -> Option<[Value; 3]> {
        let body_type = self.type_of(place.item)?;
        match place.point {
            PlacePoint::Input => Some(zeros()),
            PlacePoint::Com => body_type.com.as_ref().map(|com| com.value.clone()),
            PlacePoint::Named(index) => Some(body_type.points[index].frame.clone()?.position),
            PlacePoint::Output => output_of(body_type, path.end(), context),
        }
    }

    /// Returns whether an unknown name may follow from another error.
    pub fn is_uncertain(&self, path: &str) -> bool {
        let is_lost = |item: &RouteItem| matches!(item, RouteItem::Unknown { name } if name.as_ref().is_none_or(|name| name.path == path));
        !self.written.routes_are_complete
            || self.names.duplicates().body
            || self.items.iter().any(is_lost)
    }

    /// Returns whether a path may lead into a part that is lost: one that is not readable, or an item of an unknown type,
    /// which is reported.
    pub fn may_be_in_lost_part(&self, scope: usize, path: &[Ident]) -> bool {
        let [first, _, ..] = path else { return false };
        let first = self.written.scopes[scope].path(std::slice::from_ref(first));
        let is_lost = |item: &RouteItem| match item {
            RouteItem::Body { name, body_type: None, .. }
            | RouteItem::Unknown { name: Some(name) } => name.path == first,
            _ => false,
        };
        !self.written.complete || self.items.iter().any(is_lost)
    }

    /// Reports a path to a place whose body is unknown.
    fn no_body<T>(&self, path: &PathSyntax, scope: usize, context: &mut Context) -> Option<T> {
        let (_, body) = path.names.split_last()?;
        let shown = PathSyntax { last: None, names: path.names.clone() };
        if let Some(item) = self.names.item(self.written, scope, &path.names) {
            return match &self.items[item] {
                RouteItem::Body { .. } => {
                    let place = self.type_of(item).map_or_else(|| "output".into(), example_place);
                    let message = format!("name the place on `{shown}`: `{shown}.{place}`");
                    context.refuse(path.extent(), message)
                }
                RouteItem::Hinge { .. } => {
                    let message = format!("`{shown}` is a hinge: name a body and a place on it");
                    context.refuse(path.extent(), message)
                }
                _ => None,
            };
        }
        if let Some(instance) = self.names.instance(self.written, scope, &path.names) {
            return context.refuse(path.extent(), self.part_message(&shown, instance));
        }
        if let Some(instance) = self.names.instance(self.written, scope, body) {
            let meant = did_you_mean(&shown.to_string(), self.body_paths(scope));
            if !meant.is_empty() && !POINTS.iter().any(|point| path.end() == point) {
                let message = format!("no body `{shown}` on a route{meant}");
                return context.refuse(path.end(), message);
            }
            let shown = PathSyntax { last: None, names: body.to_vec() };
            return context.refuse(shown.extent(), self.part_message(&shown, instance));
        }
        self.unknown_body(body, scope, context)
    }

    /// Returns the message for an instance of a part in place of a body.
    pub fn part_message(&self, shown: &PathSyntax, instance: usize) -> String {
        let outer = &self.written.scopes[self.written.scopes[instance].parent];
        let example = self.items.iter().enumerate().find_map(|(index, item)| match item {
            RouteItem::Body { name, .. } if self.written.items[index].scope == instance => {
                let place = example_place(self.type_of(index)?);
                Some(format!("{}.{place}", name.path.strip_prefix(outer.prefix())?))
            }
            _ => None,
        });
        let example = example.unwrap_or_else(|| format!("{shown}.body.output"));
        format!("`{shown}` is a part: name the body and the place, `{example}`")
    }

    /// Reports an unknown body.
    pub(super) fn unknown_body<T>(
        &self,
        body: &[Ident],
        scope: usize,
        context: &mut Context,
    ) -> Option<T> {
        let shown = PathSyntax { last: None, names: body.to_vec() };
        let written = self.written;
        if self.may_be_in_lost_part(scope, body)
            || self.is_uncertain(&written.scopes[scope].path(body))
        {
            return None;
        }
        if let [name] = body
            && let Some(message) = self.type_message(name, scope).or_else(|| keyword_message(name))
        {
            return context.refuse(name, message);
        }
        let mut outer = scope;
        while outer > 0 {
            outer = written.scopes[outer].parent;
            if self.names.item(written, outer, body).is_some() {
                let part = written.scopes[scope].part.map(|part| &part.name)?;
                let message = format!(
                    "part `{part}` knows only its own bodies: write this after the route that sets \
                     the part"
                );
                return context.refuse(shown.extent(), message);
            }
        }
        let hint = if context.diagnostics.is_full() {
            String::new()
        } else {
            did_you_mean(&shown.to_string(), self.body_paths(scope))
        };
        let message = format!("no body `{shown}` on a route{hint}");
        match body {
            [name] => {
                let bodies = self.items.iter().filter(|item| item.is_body());
                let meant = bodies.filter_map(|item| Some(&item.name()?.joined));
                context.diagnostics.unknown(name, message, meant);
                None
            }
            _ => context.refuse(shown.extent(), message),
        }
    }

    /// Returns the message for a type in place of a body.
    fn type_message(&self, name: &Ident, scope: usize) -> Option<String> {
        let index = self.types.find(scope, name)?;
        let body = self.items.iter().find_map(|item| match item {
            RouteItem::Body { body_type, name, .. } if *body_type == Some(index) => Some(name),
            _ => None,
        })?;
        Some(format!("`{name}` is a type; its body is `{body}`"))
    }

    /// Returns the paths of the bodies of a scope, as it writes them.
    fn body_paths(&self, scope: usize) -> impl Iterator<Item = &'t str> {
        let prefix = self.written.scopes[scope].prefix();
        let bodies = self.items.iter().filter(|item| item.is_body());
        bodies.filter_map(move |item| item.name()?.path.strip_prefix(prefix))
    }
}

/// Returns the message for a keyword in place of a body.
fn keyword_message(word: &Ident) -> Option<String> {
    Some(match &*word.to_string() {
        "ground" => {
            "the ground has no named places: write `ground at [x, y, z] m` on a route, and \
                     `[x, y, z] m` in a spring"
                .into()
        }
        "last" => "`last` is the previous repetition: name a body and a place in it, as in \
                   `last.link.output`"
            .into(),
        _ => return None,
    })
}

/// Returns the point of a type with this name.
fn point_named(body_type: &BodyType, name: &Ident) -> Option<PlacePoint> {
    match &*name.to_string() {
        "input" => Some(PlacePoint::Input),
        "output" => Some(PlacePoint::Output),
        "com" => Some(PlacePoint::Com),
        _ => {
            let index = body_type.points.iter().position(|point| name == point.name);
            index.map(PlacePoint::Named)
        }
    }
}

/// Returns the output of a type; a missing one is reported at `word`.
pub(super) fn output_of(
    body_type: &BodyType,
    word: &Ident,
    context: &mut Context,
) -> Option<[Value; 3]> {
    if body_type.missing(true).contains(&"output") {
        let message = format!("body `{}` has no output: give its type an `output`", body_type.name);
        return context.refuse(word, message);
    }
    body_type.output.as_ref().map(|output| output.value.position.clone())
}

/// Reports a place that a body has not.
fn no_place<T>(
    body: &PathSyntax,
    point: &Ident,
    body_type: &BodyType,
    context: &mut Context,
) -> Option<T> {
    // It is reported already.
    if body_type.may_have_point(point) {
        return None;
    }
    let message = format!("`{body}` has no place `{point}`; it has {}", places_of(body_type));
    let points = body_type.points.iter().map(|point| point.name);
    context.diagnostics.unknown(point, message, points);
    None
}

/// Returns a place of a body, for examples in messages.
pub(crate) fn example_place(body_type: &BodyType) -> String {
    match body_type.points.first() {
        Some(point) if !body_type.gives("output") => point.name.to_string(),
        _ => "output".into(),
    }
}

/// Lists the places of a body for messages.
pub(crate) fn places_of(body_type: &BodyType) -> String {
    let output = body_type.gives("output").then(|| "`output`".to_owned());
    let points = body_type.points.iter().map(|point| format!("`{}`", point.name));
    let places: Vec<String> =
        ["`input`".to_owned()].into_iter().chain(output).chain(points).collect();
    listed(&places)
}

/// Returns the extent of the body in a path to a place.
pub(super) fn body_extent(path: &PathSyntax) -> SpanRange {
    match path.names.split_last() {
        Some((_, [first, .., last])) => SpanRange::from(first).to(SpanRange::from(last)),
        Some((_, [only])) => SpanRange::from(only),
        _ => path.extent(),
    }
}
