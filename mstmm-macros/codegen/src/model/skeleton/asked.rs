//! Inputs of the caller, inferred from a description that may be wrong.

use crate::diag::nearest;
use crate::model::lower::{Draft, LOAD_FIELDS, fields, groups, meant};
use crate::model::{Drive, Effort, Shape, Source};
use crate::syntax::{Block, BlockWord, Field};
use proc_macro2::Ident;
use std::collections::{HashMap, HashSet, VecDeque};

/// Slips in names of blocks are looked up for so many of them: a long chain has many names.
const MOST_SLIPS: usize = 100;

/// The fields that blocks give of each hinge, by its name.
pub(super) type Said<'d> = HashMap<String, Vec<&'d Field>>;

/// What drives a hinge of which this is said.
pub(super) fn drive(said: &[&Field], shape: &'static Shape) -> Drive {
    let known = fields(shape);
    let mut efforts = vec![Effort::Free; shape.rates.len()];
    for field in said {
        let written = field.name.to_string();
        let is_known = known.contains(&written.as_str());
        let meant = if is_known { Some(written.as_str()) } else { meant(&written, &known) };
        match meant {
            Some("motion") if shape.view.is_some() => return Drive::Motion,
            _ if !field.asks_for_input => {}
            Some(meant) => {
                for (group, _) in groups(shape).filter(|(_, words)| words.effort == meant) {
                    efforts[group.rates.clone()].fill(Effort::Input);
                }
            }
            None => efforts.fill(Effort::Input),
        }
    }
    Drive::Efforts(efforts)
}

/// What blocks say, also by a name that is close to that of a stop and nobody's.
pub(super) fn said<'d>(draft: &'d Draft) -> Said<'d> {
    let names: Vec<String> =
        draft.stops.iter().filter_map(|stop| stop.name()).map(Ident::to_string).collect();
    let on_route: HashSet<&str> = names.iter().map(String::as_str).collect();
    let blocks = draft.def.blocks.iter().filter(|block| match block.word {
        BlockWord::Hinge => true,
        BlockWord::Body => block.after_route,
        BlockWord::Load | BlockWord::Spring => false,
    });
    let mut said = Said::new();
    let mut slips = 0;
    for (block, name) in blocks.flat_map(|block| block.names.iter().map(move |name| (block, name)))
    {
        let mut name = name.to_string();
        if !on_route.contains(name.as_str()) {
            slips += 1;
            if slips > MOST_SLIPS {
                continue;
            }
            if let Some(near) = nearest(&name, names.iter().map(String::as_str)) {
                name = near.to_owned();
            }
        }
        said.entry(name).or_default().extend(&block.fields);
    }
    said
}

/// Names of hinges in blocks that are neither on the route nor close to one there.
pub(super) fn nameless(draft: &Draft) -> VecDeque<Ident> {
    let names: Vec<String> =
        draft.stops.iter().filter_map(|stop| stop.name()).map(Ident::to_string).collect();
    let is_far =
        |name: &&Ident| nearest(&name.to_string(), names.iter().map(String::as_str)).is_none();
    let blocks = draft.def.blocks.iter().filter(|block| block.word == BlockWord::Hinge);
    let far = blocks.flat_map(|block| &block.names).take(MOST_SLIPS).filter(is_far);
    far.cloned().collect()
}

/// Whether gravity is given at each step.
pub(super) fn gravity(draft: &Draft) -> bool {
    let is_gravity = |field: &&Field| {
        nearest(&field.name.to_string(), ["gravity", "method", "results"]) == Some("gravity")
    };
    draft.def.settings.iter().filter(is_gravity).any(|field| field.asks_for_input)
}

/// The source of a vector that is an input, or none.
pub(super) fn source(asked: bool) -> Source {
    if asked { Source::Input } else { Source::Nothing }
}

/// Whether force and torque of a load are given at each step.
pub(super) fn efforts_of_load(block: &Block) -> [bool; 2] {
    let asking: Vec<_> = block.fields.iter().filter(|field| field.asks_for_input).collect();
    let means = |field: &Field| meant_of_load(field);
    let mut efforts =
        ["force", "torque"].map(|effort| asking.iter().any(|field| means(field) == Some(effort)));
    if asking.iter().any(|field| means(field).is_none()) {
        // What else could take it, the force first.
        let given = |effort: &str| block.fields.iter().any(|field| means(field) == Some(effort));
        efforts[usize::from(given("force"))] = true;
    }
    efforts
}

/// The body that a load names.
pub(super) fn body_of_load(block: &Block) -> Option<&Ident> {
    let word = |field: &'_ &Field| field.value.as_ref().is_some_and(|value| value.word().is_some());
    let named = |on: Option<&'static str>| {
        let mut fields = block.fields.iter().filter(word);
        fields.find(|field| meant_of_load(field) == on && !field.asks_for_input)
    };
    named(Some("on")).or_else(|| named(None))?.value.as_ref()?.word()
}

fn meant_of_load(field: &Field) -> Option<&'static str> {
    let written = field.name.to_string();
    LOAD_FIELDS
        .iter()
        .find(|known| **known == written)
        .copied()
        .or_else(|| meant(&written, LOAD_FIELDS))
}
