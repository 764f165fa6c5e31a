//! Writes out routes item by item.

use proc_macro2::Ident;
use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use syn::ext::IdentExt;

use super::arguments::substitution;
use super::definitions::has_repeat;
use super::{
    Scope, WrittenBlock, WrittenItem, WrittenOut, WrittenRepeat, WrittenRoute, snake_case,
};
use crate::diag::Diagnostics;
use crate::syntax::{
    ArgumentsSyntax, ChainSyntax, ContentSyntax, PartSyntax, RepeatSyntax, RouteItemSyntax,
    RouteSyntax, StepSyntax,
};

/// The largest number of items of a chain, and of instances of parts: parts in parts double them.
const MOST_ITEMS: usize = 20_000;
/// The largest depth of parts in parts.
const DEEPEST: usize = 32;

/// Writes out a chain.
pub(super) struct RouteWriter<'a, 'd> {
    /// The items written out so far.
    pub written: WrittenOut<'a>,
    def: &'a ChainSyntax,
    parts: HashMap<String, &'a PartSyntax>,
    diagnostics: &'d mut Diagnostics,
    /// The paths of the instances so far.
    instances: HashSet<String>,
    /// The parts without parameters to which an instance gives arguments, which is reported.
    without_parameters: HashSet<String>,
    is_full: bool,
}

/// The route that is being written out.
struct OpenRoute {
    /// Its index.
    route: usize,
    /// The scope of the text that is read, and the index of the route in it.
    scope: usize,
    index: usize,
    /// The repeated part around it.
    repeat: Option<usize>,
    /// The further routes of parts that it sets: their scopes and indices.
    further: Vec<(usize, usize)>,
}

/// An instance of a part as written.
struct PartUse<'s> {
    word: &'s Ident,
    name: Option<&'s Ident>,
    arguments: Option<&'s ArgumentsSyntax>,
}

impl<'a, 'd> RouteWriter<'a, 'd> {
    /// Begins with an empty chain.
    pub fn new(
        def: &'a ChainSyntax,
        parts: HashMap<String, &'a PartSyntax>,
        diagnostics: &'d mut Diagnostics,
    ) -> Self {
        let chain = Scope {
            part: None,
            parent: 0,
            name: None,
            is_named: true,
            prefix: String::new(),
            joined_prefix: String::new(),
            depth: 0,
            substitution: None,
            instances: vec![Vec::new(); def.content.routes.len()],
        };
        let written = WrittenOut {
            scopes: vec![chain],
            parts: def.parts.iter().map(|part| &part.name).collect(),
            unused_parts: Vec::new(),
            items: Vec::new(),
            routes: Vec::new(),
            repeats: Vec::new(),
            blocks: Vec::new(),
            complete: true,
            routes_are_complete: true,
        };
        let (instances, without_parameters) = (HashSet::new(), HashSet::new());
        RouteWriter {
            written,
            def,
            parts,
            diagnostics,
            instances,
            without_parameters,
            is_full: false,
        }
    }

    /// Writes out all routes and blocks.
    pub fn write_chain(&mut self) {
        let def = self.def;
        for (index, route) in def.content.routes.iter().enumerate() {
            self.whole_route((0, index), route, None);
        }
        self.blocks(0);
    }

    /// Writes out a route, then the further routes of the parts on it.
    fn whole_route(
        &mut self,
        (scope, index): (usize, usize),
        syntax: &'a RouteSyntax,
        repeat: Option<usize>,
    ) {
        self.written.routes.push(WrittenRoute { syntax, scope, repeat, items: Vec::new() });
        let route = self.written.routes.len() - 1;
        let mut open = OpenRoute { route, scope, index, repeat, further: Vec::new() };
        self.steps(syntax, &mut open);
        self.further_routes(open.further, repeat);
    }

    /// Writes out further routes of parts.
    fn further_routes(&mut self, further: Vec<(usize, usize)>, repeat: Option<usize>) {
        for (scope, index) in further {
            if let Some(part) = self.written.scopes[scope].part {
                self.whole_route((scope, index), &part.content.routes[index], repeat);
            }
        }
    }

    fn steps(&mut self, syntax: &'a RouteSyntax, open: &mut OpenRoute) {
        for step in &syntax.steps {
            match step {
                StepSyntax::Item(item) => self.item(item, open),
                StepSyntax::Repeat(repeat) => self.repeat(repeat, open),
            }
        }
    }

    /// Writes out an item: a part by its first route, anything else as it is.
    fn item(&mut self, item: &'a RouteItemSyntax, open: &mut OpenRoute) {
        let substitution = self.written.scopes[open.scope].substitution.as_ref();
        let item = match substitution.and_then(|substitution| substitution.item(item)) {
            Some(replaced) => Cow::Owned(replaced),
            None => Cow::Borrowed(item),
        };
        if let RouteItemSyntax::Element { word, name, arguments, .. } = &*item
            && let Some(&part) = self.parts.get(&word.to_string())
        {
            let set = PartUse { word, name: name.as_ref(), arguments: arguments.as_ref() };
            if let Some(reason) = self.cannot_be_set(part, open) {
                self.written.routes_are_complete = false;
                if let Some(message) = reason {
                    self.diagnostics.error(word.span(), message);
                }
                return;
            }
            return self.part(part, &set, open);
        }
        let OpenRoute { route, scope, repeat, .. } = *open;
        self.written.routes[route].items.push(self.written.items.len());
        self.written.items.push(WrittenItem { syntax: item, scope, route, repeat });
    }

    /// Returns why a part cannot be set here; the reason is `None` if it is reported already.
    fn cannot_be_set(&mut self, part: &PartSyntax, open: &OpenRoute) -> Option<Option<String>> {
        let mut around = Vec::new();
        let mut scope = &self.written.scopes[open.scope];
        while let Some(outer) = scope.part {
            around.push(outer.name.to_string());
            scope = &self.written.scopes[scope.parent];
        }
        let name = &part.name;
        if let Some(index) = around.iter().position(|outer| name == outer) {
            let mut names: Vec<String> = around[..=index].iter().rev().cloned().collect();
            names.push(name.to_string());
            let names = names.join(", ");
            return Some(Some(format!("part `{name}` contains itself: {names}")));
        }
        if open.repeat.is_some() && has_repeat(part, &self.parts) {
            return Some(Some(format!(
                "part `{name}` has a `repeat` and is set in a `repeat`: `repeat` blocks cannot be \
                 nested"
            )));
        }
        if around.len() >= DEEPEST {
            return Some(Some(format!("more than {DEEPEST} parts in parts")));
        }
        let size = self.written.items.len().max(self.written.scopes.len());
        if size >= MOST_ITEMS {
            let reported = std::mem::replace(&mut self.is_full, true);
            let message = || {
                format!("with its parts written out this chain has more than {MOST_ITEMS} items")
            };
            return Some((!reported).then(message));
        }
        None
    }

    /// Writes out an instance of a part.
    fn part(&mut self, part: &'a PartSyntax, set: &PartUse, open: &mut OpenRoute) {
        let name = set.name.cloned().unwrap_or_else(|| snake_case(set.word));
        let item_name = self.written.scopes[open.scope].item_name(&name);
        let is_new = self.instances.insert(item_name.path.clone());
        if !is_new || name == "last" {
            let message = match (is_new, set.name) {
                (true, _) => "an instance of a part cannot be called `last`".to_owned(),
                (false, Some(_)) => format!("the name `{name}` is used twice"),
                (false, None) => {
                    format!("the name `{name}` is used twice; write a name after the part")
                }
            };
            self.diagnostics.name(&item_name.joined, message);
            self.written.routes_are_complete = false;
            return;
        }
        let arguments = self.arguments(part, set);
        let substitution = substitution(part, set.word, &name, arguments, self.diagnostics);
        let outer = &self.written.scopes[open.scope];
        let scope = Scope {
            part: Some(part),
            parent: open.scope,
            prefix: format!("{}.", item_name.path),
            joined_prefix: format!("{}_", item_name.joined.unraw()),
            depth: outer.depth + 1,
            is_named: set.name.is_some(),
            name: Some(item_name),
            substitution,
            instances: vec![Vec::new(); part.content.routes.len()],
        };
        self.written.scopes.push(scope);
        let instance = self.written.scopes.len() - 1;
        self.written.scopes[open.scope].instances[open.index].push(instance);
        let Some(first) = part.content.routes.first() else { return };
        let outer = (open.scope, open.index);
        (open.scope, open.index) = (instance, 0);
        self.steps(first, open);
        (open.scope, open.index) = outer;
        let further = 1..part.content.routes.len();
        open.further.extend(further.map(|index| (instance, index)));
    }

    /// Returns the arguments of an instance; none if the part has no parameters, which is one error for all instances. The
    /// names that are unknown in the part may be these parameters.
    fn arguments<'s>(
        &mut self,
        part: &PartSyntax,
        set: &PartUse<'s>,
    ) -> Option<&'s ArgumentsSyntax> {
        let arguments = set.arguments?;
        if !part.parameters.is_empty() || arguments.values.is_empty() {
            return Some(arguments);
        }
        let name = &part.name;
        if self.without_parameters.insert(name.to_string()) {
            let message = format!(
                "part `{name}` has no parameters: remove the parentheses, or name the parameters in `part {name}(…)`"
            );
            self.diagnostics.error_over(arguments.extent, message);
        }
        self.written.complete = false;
        None
    }

    /// Writes out a repeated part: its first route, then its branches.
    fn repeat(&mut self, syntax: &'a RepeatSyntax, open: &mut OpenRoute) {
        let OpenRoute { route, scope, index, .. } = *open;
        let (start, on_route) = (self.written.items.len(), self.written.routes[route].items.len());
        let (items, on_route) = (start..start, on_route..on_route);
        self.written.repeats.push(WrittenRepeat { syntax, scope, route, items, on_route });
        let repeat = self.written.repeats.len() - 1;
        let Some((first, branches)) = syntax.routes.split_first() else { return };
        let mut inside =
            OpenRoute { route, scope, index, repeat: Some(repeat), further: Vec::new() };
        self.steps(first, &mut inside);
        self.written.repeats[repeat].on_route.end = self.written.routes[route].items.len();
        self.further_routes(inside.further, Some(repeat));
        for branch in branches {
            self.whole_route((scope, index), branch, Some(repeat));
        }
        self.written.repeats[repeat].items.end = self.written.items.len();
    }

    /// Writes out the blocks of a scope, those of each instance with the route that sets it.
    fn blocks(&mut self, scope: usize) {
        let content: &'a ContentSyntax = match self.written.scopes[scope].part {
            Some(part) => &part.content,
            None => &self.def.content,
        };
        let instances = std::mem::take(&mut self.written.scopes[scope].instances);
        let mut instances = instances.into_iter();
        let mut routes = 0;
        for source in &content.blocks {
            while routes < source.routes_before {
                routes += 1;
                for instance in instances.next().into_iter().flatten() {
                    self.blocks(instance);
                }
            }
            let substitution = self.written.scopes[scope].substitution.as_ref();
            let syntax = match substitution.and_then(|substitution| substitution.block(source)) {
                Some(replaced) => Cow::Owned(replaced),
                None => Cow::Borrowed(source),
            };
            self.written.blocks.push(WrittenBlock { syntax, source, scope });
        }
        for instance in instances.flatten() {
            self.blocks(instance);
        }
    }
}
