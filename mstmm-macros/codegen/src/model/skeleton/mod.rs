//! What stands in place of a chain that has mistakes: one with the same names and hinges, all its
//! numbers made up. Its types and methods keep the rest of the user's crate quiet, so that the
//! mistakes alone are reported. It never runs, for the crate does not compile.

mod asked;
mod chain;

use super::lower::{Draft, KINDS, Stop};
use super::{Chain, Dimension, Drive, HingeKind, Parameter, Value};
use asked::Said;
use proc_macro2::{Ident, Span};
use quote::format_ident;
use std::collections::{HashSet, VecDeque};
use std::ops::Range;

/// The chain that a draft with mistakes would be without them, as far as it can be guessed; nothing
/// if no type can have its name.
pub(super) fn skeleton(draft: &Draft) -> Option<Chain> {
    let name = draft.def.name.clone();
    if draft.def.clashes || !is_identifier(&name) {
        return None;
    }
    let mut sketch = Sketch::new(draft);
    sketch.trace();
    Some(sketch.finish(name))
}

/// Whether a name can be made part of other names.
fn is_identifier(name: &Ident) -> bool {
    let text = name.to_string();
    !text.starts_with("r#") && syn::parse_str::<Ident>(&text).is_ok()
}

/// The name as written, if it is an identifier and not among these; else one that nobody knows.
fn named(written: Option<&Ident>, taken: &mut HashSet<String>) -> Ident {
    let free = |name: &&Ident| is_identifier(name) && !taken.contains(&name.to_string());
    let name = written.filter(free).cloned();
    let name =
        name.unwrap_or_else(|| format_ident!("unnamed{}", taken.len(), span = Span::call_site()));
    taken.insert(name.to_string());
    name
}

/// An element of the route.
struct Part {
    name: Ident,
    /// What it lets free and how it is driven; nothing for a body.
    hinge: Option<(HingeKind, Drive)>,
    /// The type of a body, if one was written.
    body_type: Option<Ident>,
    /// The repeated part that it is in.
    repeat: Option<usize>,
}

/// What holds an end.
#[derive(Clone)]
enum End {
    Free,
    Held,
    Moving(Ident),
}

/// A route on its way to one in which hinges and bodies alternate.
struct Sketch<'d, 'a> {
    draft: &'d Draft<'a>,
    parts: Vec<Part>,
    start: End,
    finish: End,
    names: HashSet<String>,
    parameters: Vec<Parameter>,
    /// What blocks say of hinges.
    said: Said<'d>,
    /// Names in blocks that nothing on the route has: those of hinges that have none there.
    nameless: VecDeque<Ident>,
}

impl<'d, 'a> Sketch<'d, 'a> {
    fn new(draft: &'d Draft<'a>) -> Self {
        let mut sketch = Sketch {
            draft,
            parts: Vec::new(),
            start: End::Free,
            finish: End::Free,
            names: HashSet::new(),
            parameters: Vec::new(),
            said: asked::said(draft),
            nameless: asked::nameless(draft),
        };
        // Parameters are in types without other names.
        let mut parameters = HashSet::new();
        for parameter in &draft.parameters {
            let name = named(Some(&parameter.name), &mut parameters);
            sketch.parameters.push(Parameter {
                name,
                default: Value::number(1.0),
                ..parameter.clone()
            });
        }
        sketch
    }

    /// The name as written, if it is an identifier and no other element has it; else one that nobody
    /// knows. What the language forbids otherwise is kept: what clashes in a type is left out there.
    fn name(&mut self, written: Option<&Ident>) -> Ident {
        named(written, &mut self.names)
    }

    fn body(&mut self, name: Option<&Ident>, body_type: Option<&Ident>, repeat: Option<usize>) {
        let (name, body_type) = (self.name(name), body_type.cloned());
        self.parts.push(Part { name, hinge: None, body_type, repeat });
    }

    fn hinge(&mut self, name: Option<&Ident>, hinge: (HingeKind, Drive), repeat: Option<usize>) {
        let name = self.name(name);
        self.parts.push(Part { name, hinge: Some(hinge), body_type: None, repeat });
    }

    fn weld(&mut self, repeat: Option<usize>) {
        self.hinge(None, (HingeKind::Weld, Drive::Efforts(Vec::new())), repeat);
    }

    /// Whether a hinge can come next.
    fn wants_hinge(&self) -> bool {
        match self.parts.last() {
            Some(last) => last.hinge.is_none(),
            None => !matches!(self.start, End::Free),
        }
    }

    /// Follows the route, and puts in what is missing.
    fn trace(&mut self) {
        let stops = &self.draft.stops;
        let repeats = self.draft.def.route.iter().flat_map(|route| &route.repeats);
        let repeats: Vec<Range<usize>> = repeats.map(|repeat| repeat.stops.clone()).collect();
        let mut before = None;
        for (index, stop) in stops.iter().enumerate() {
            let repeat = repeats.iter().position(|stops| stops.contains(&index));
            if repeat != before {
                self.enter(before, repeat);
            }
            before = repeat;
            self.stop(index, stop, repeat);
        }
        self.enter(before, None);
        self.close();
    }

    /// Between parts that are repeated and others there is a body on the inboard side.
    fn enter(&mut self, before: Option<usize>, repeat: Option<usize>) {
        let ends_with_hinge = self.parts.last().is_some_and(|last| last.hinge.is_some());
        if (before.is_some() && ends_with_hinge) || (repeat.is_some() && !self.wants_hinge()) {
            self.body(None, None, before);
        }
    }

    fn stop(&mut self, index: usize, stop: &Stop, repeat: Option<usize>) {
        let route = self.draft.def.route.as_ref();
        let last = route.is_some_and(|route| index + 1 == route.first_end());
        match stop {
            Stop::Ground { .. } if index == 0 => self.start = End::Held,
            Stop::Ground { .. } if last => self.finish = End::Held,
            Stop::Moving { name, .. } if index == 0 || last => {
                let same = |(other, stop): (usize, &Stop)| {
                    other != index && name.is_some() && stop.name() == *name
                };
                // The inputs have a name once.
                let end = match self.draft.stops.iter().enumerate().any(same) {
                    true => End::Held,
                    false => End::Moving(self.name(*name)),
                };
                if index == 0 { self.start = end } else { self.finish = end }
            }
            Stop::Moving { name, .. } if matches!(self.finish, End::Free) => {
                self.finish = End::Moving(self.name(*name));
            }
            Stop::Ground { .. } | Stop::Moving { .. } | Stop::Again { .. } => {}
            Stop::Hinge { name, kind, .. } => {
                let kind = kind.plain(self.draft.space).unwrap_or(HingeKind::Weld);
                self.driven(*name, kind, repeat);
            }
            Stop::Unknown { name, kind: Some("moving") } if index == 0 || last => {
                let end = End::Moving(self.name(*name));
                if index == 0 { self.start = end } else { self.finish = end }
            }
            Stop::Unknown { kind: Some("ground"), .. } if index == 0 => self.start = End::Held,
            Stop::Unknown { kind: Some("ground"), .. } if last => self.finish = End::Held,
            Stop::Unknown { name, kind: Some(word) } => {
                let kind = KINDS.iter().find(|kind| kind.word == *word);
                let kind = kind.and_then(|kind| kind.plain(self.draft.space));
                self.driven(*name, kind.unwrap_or_else(|| pin_or_slider(self.draft)), repeat);
            }
            Stop::Body { name, word, .. } => {
                if self.wants_hinge() {
                    self.weld(repeat);
                }
                self.body(Some(name), Some(word), repeat);
            }
            // The commonest hinge.
            Stop::Unknown { name, kind: None } if self.wants_hinge() => {
                self.driven(*name, pin_or_slider(self.draft), repeat);
            }
            Stop::Unknown { name, kind: None } => self.body(*name, *name, repeat),
        }
    }

    /// A hinge, with a body before it where there is none.
    fn driven(&mut self, name: Option<&Ident>, kind: HingeKind, repeat: Option<usize>) {
        if !self.wants_hinge() {
            self.body(None, None, repeat);
        }
        let block = match name {
            Some(_) => None,
            None => self.nameless.pop_front(),
        };
        let name = name.or(block.as_ref());
        let said = name.and_then(|name| self.said.get(&name.to_string()));
        let drive = asked::drive(said.map_or(&[], Vec::as_slice), kind.shape());
        self.hinge(name, (kind, drive), repeat);
    }

    /// Ends the route, with a body at least.
    fn close(&mut self) {
        let moves = |part: &Part| {
            part.hinge
                .as_ref()
                .is_some_and(|(kind, drive)| kind.freedoms() > 0 && *drive != Drive::Motion)
        };
        let starts_free = matches!(self.start, End::Free);
        let has_repeat = self.parts.iter().any(|part| part.repeat.is_some());
        let has_body = self.parts.iter().any(|part| part.hinge.is_none());
        if !has_body || !self.parts.iter().any(moves) || (starts_free && has_repeat) {
            self.finish = End::Free;
        }
        match (&self.finish, self.parts.last().map(|last| last.hinge.is_some())) {
            (End::Free, Some(true)) => self.body(None, None, None),
            (End::Free, None) => {
                if !starts_free {
                    self.weld(None);
                }
                self.body(None, None, None);
            }
            (End::Held | End::Moving(_), Some(false)) => self.weld(None),
            _ => {}
        }
    }
}

/// A pin, or what stands for it where nothing turns.
fn pin_or_slider(draft: &Draft) -> HingeKind {
    let axis = |direction: usize| {
        let mut axis = [(); 3].map(|()| Value::number(0.0));
        axis[direction] = Value::number(1.0);
        axis
    };
    match draft.space {
        Dimension::Line => HingeKind::Slider { axis: axis(0) },
        _ => HingeKind::Pin { axis: axis(2) },
    }
}
