//! Keywords and parameters as written, for editors: each use with its span.

use proc_macro2::Ident;

use super::hinge::{KINDS, fields, start_fields};
use super::{body, load, unit};
use crate::model::{ANSWER_WORDS, Dimension, HingeKind};
use crate::syntax::{
    BlockKeyword, BlockSyntax, ChainSyntax, ContentSyntax, ExprKind, ExprSyntax, FieldSyntax,
    KeywordGroup, KeywordUses, ListSyntax, OrientationSyntax, RouteItemSyntax, RouteSyntax,
    SETTINGS, ShapeArgument, ShapeSyntax, UnitFactorSyntax, UnitSyntax, ValueSyntax,
};

/// Fields whose value is a place, not a number.
const PLACES: &[&str] = &["on", "at", "to"];

/// Returns the keywords of a chain, and the names of its parameters in numbers. A part counts once,
/// however often it is set. Unknown words are omitted: a part that no route sets may have some.
pub(super) fn of_chain(def: &ChainSyntax) -> (Vec<KeywordUses>, Vec<Ident>) {
    let known = def.parameters.iter().map(|parameter| &parameter.field.name).collect();
    let mut uses = KeywordSearch { words: Vec::new(), parameters: Vec::new(), known, of_part: &[] };
    uses.fields(KeywordGroup::Settings, &def.settings);
    for parameter in &def.parameters {
        uses.field_value(&parameter.field);
    }
    uses.content(&def.content);
    for part in &def.parts {
        uses.of_part = &part.parameters;
        uses.content(&part.content);
    }
    let of_group = |group: KeywordGroup| {
        let known = keywords(group);
        let of_group = uses.words.iter().filter(|(of, _)| *of == group).map(|(_, word)| word);
        let words = of_group.filter(|word| known.iter().any(|known| **word == **known)).cloned();
        KeywordUses { group, words: words.collect() }
    };
    let groups = KeywordGroup::ALL.into_iter().map(of_group);
    (groups.filter(|uses| !uses.words.is_empty()).collect(), uses.parameters)
}

/// Returns all keywords of a group, in alphabetical order.
pub(crate) fn keywords(group: KeywordGroup) -> Vec<String> {
    let hinge_fields = || {
        let spaces = [Dimension::Space, Dimension::Plane, Dimension::Line];
        let kinds =
            KINDS.iter().flat_map(|kind| spaces.iter().filter_map(|&space| kind.plain(space)));
        kinds.flat_map(|kind: HingeKind| fields(kind.spec())).collect()
    };
    let words: Vec<&str> = match group {
        KeywordGroup::Kinds => KINDS.iter().map(|kind| kind.word).collect(),
        KeywordGroup::Settings => SETTINGS.to_vec(),
        KeywordGroup::Answers => ANSWER_WORDS.iter().map(|(word, _)| *word).collect(),
        KeywordGroup::Body => body::FIELDS.to_vec(),
        KeywordGroup::Hinge => hinge_fields(),
        KeywordGroup::Base => start_fields(HingeKind::Floating.spec()),
        KeywordGroup::Load => load::LOAD_FIELDS.to_vec(),
        KeywordGroup::Spring => load::SPRING_FIELDS.to_vec(),
        KeywordGroup::Units => Vec::new(),
    };
    let units = if group == KeywordGroup::Units { unit::symbols() } else { Vec::new() };
    let mut words: Vec<String> = words.into_iter().map(str::to_owned).chain(units).collect();
    words.sort();
    words.dedup();
    words
}

/// The uses found so far.
struct KeywordSearch<'a> {
    words: Vec<(KeywordGroup, Ident)>,
    parameters: Vec<Ident>,
    /// The parameters of the chain.
    known: Vec<&'a Ident>,
    /// The parameters of the part, which hide those of the chain.
    of_part: &'a [Ident],
}

impl KeywordSearch<'_> {
    fn content(&mut self, content: &ContentSyntax) {
        content.routes.iter().for_each(|route| self.route(route));
        content.blocks.iter().for_each(|block| self.block(block));
    }

    fn route(&mut self, route: &RouteSyntax) {
        for item in route.items() {
            match item {
                RouteItemSyntax::Ground { position, turned, .. } => {
                    position.iter().for_each(|position| self.value(position));
                    turned.iter().for_each(|turned| self.orientation(turned));
                }
                RouteItemSyntax::Element { word, arguments, .. } => {
                    self.words.push((KeywordGroup::Kinds, word.clone()));
                    let values = arguments.iter().flat_map(|arguments| &arguments.values);
                    values.for_each(|value| self.value(value));
                }
                RouteItemSyntax::Moving { .. } | RouteItemSyntax::Unread { .. } => {}
            }
        }
    }

    fn block(&mut self, block: &BlockSyntax) {
        let group = match block.word {
            BlockKeyword::Body => KeywordGroup::Body,
            BlockKeyword::Hinge => KeywordGroup::Hinge,
            BlockKeyword::Load => KeywordGroup::Load,
            BlockKeyword::Spring => KeywordGroup::Spring,
        };
        self.fields(group, &block.fields);
        block.points.iter().for_each(|point| self.field_value(point));
    }

    fn fields(&mut self, group: KeywordGroup, fields: &[FieldSyntax]) {
        for field in fields {
            // A block of a body describes its type or its start: the other name is unknown in its group.
            let start = (group == KeywordGroup::Body).then_some(KeywordGroup::Base);
            let groups = [Some(group), start].into_iter().flatten();
            self.words.extend(groups.map(|group| (group, field.name.clone())));
            if group == KeywordGroup::Settings && field.name == "answers" {
                self.answers(field);
            } else {
                self.field_value(field);
            }
        }
    }

    /// The words of `answers`, which are no values.
    fn answers(&mut self, field: &FieldSyntax) {
        let entries = match &field.value {
            Some(ValueSyntax::Number(entry)) => std::slice::from_ref(entry),
            Some(ValueSyntax::Vector(list)) => &list.entries,
            _ => return,
        };
        let word = |entry: &ExprSyntax| match &entry.kind {
            ExprKind::Name(word) => Some((KeywordGroup::Answers, word.clone())),
            _ => None,
        };
        self.words.extend(entries.iter().filter_map(word));
    }

    fn field_value(&mut self, field: &FieldSyntax) {
        let Some(value) = &field.value else { return };
        let is_place = value.word().is_some() && PLACES.iter().any(|place| field.name == place);
        if !is_place {
            self.value(value);
        }
    }

    fn value(&mut self, value: &ValueSyntax) {
        match value {
            ValueSyntax::Number(expr) | ValueSyntax::About(expr, _) => self.expr(expr),
            ValueSyntax::Vector(list) => self.list(list),
            ValueSyntax::Turned(position, orientation) => {
                self.value(position);
                self.orientation(orientation);
            }
            ValueSyntax::Form(form) => self.list(&form.list),
            ValueSyntax::Shapes(list) => list.shapes.iter().for_each(|shape| self.shape(shape)),
            ValueSyntax::Path(_) | ValueSyntax::PlaceOn(..) => {}
        }
    }

    fn shape(&mut self, shape: &ShapeSyntax) {
        for (_, argument) in &shape.arguments {
            if let ShapeArgument::Value(value) = argument {
                self.value(value);
            }
        }
        shape.position.iter().for_each(|position| self.value(position));
        shape.orientation.iter().for_each(|orientation| self.orientation(orientation));
    }

    fn orientation(&mut self, orientation: &OrientationSyntax) {
        match orientation {
            OrientationSyntax::Angle(angle) => self.expr(angle),
            OrientationSyntax::Form(form) => self.list(&form.list),
        }
    }

    fn list(&mut self, list: &ListSyntax) {
        list.entries.iter().for_each(|entry| self.expr(entry));
        list.unit.iter().for_each(|unit| self.unit(unit));
    }

    fn expr(&mut self, expr: &ExprSyntax) {
        match &expr.kind {
            ExprKind::Name(name) => {
                if self.known.contains(&name) && !self.of_part.contains(name) {
                    self.parameters.push(name.clone());
                }
            }
            ExprKind::Parenthesized(inner)
            | ExprKind::Negated(inner)
            | ExprKind::Power(inner, _) => self.expr(inner),
            ExprKind::Sum(terms) => terms.iter().for_each(|term| self.expr(&term.expr)),
            ExprKind::Product(factors) => {
                factors.iter().for_each(|factor| self.expr(&factor.expr));
            }
            ExprKind::Quantity(number, unit) => {
                self.expr(number);
                self.unit(unit);
            }
            ExprKind::Call(_, arguments) => arguments.iter().for_each(|inner| self.expr(inner)),
            ExprKind::Number(_) | ExprKind::Lost | ExprKind::Path(_) | ExprKind::Argument(..) => {}
        }
    }

    fn unit(&mut self, unit: &UnitSyntax) {
        let symbol = |factor: &UnitFactorSyntax| {
            unit::is_symbol(&factor.symbol).then(|| Ident::new(&factor.symbol, factor.at))
        };
        let symbols = unit.factors.iter().filter_map(symbol);
        self.words.extend(symbols.map(|symbol| (KeywordGroup::Units, symbol)));
    }
}
