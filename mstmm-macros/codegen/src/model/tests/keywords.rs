//! The documented keywords of the facade (`src/keywords/`), which editors show inside a description: one type for each
//! kind of hinge, setting, field and unit that the compiler knows. Their docs are made from the tables of
//! `src/language.md` and from the units below. `MSTMM_BLESS=1 cargo test -p mstmm-codegen keywords` writes them.

use crate::model::RESERVED_NAMES;
use crate::model::lower::keywords_of;
use crate::syntax::KeywordGroup;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

/// The lines of docs are at most this long.
const WIDTH: usize = 96;

/// Symbols, names, and what they are in SI units.
const UNITS: &[(&str, &str, &str)] = &[
    ("m", "metre", "the SI unit of length"),
    ("g", "gram", "10⁻³ kg"),
    ("s", "second", "the SI unit of time"),
    ("N", "newton", "kg m/s², a force"),
    ("J", "joule", "N m, an energy"),
    ("W", "watt", "J/s, a power"),
    ("Pa", "pascal", "N/m², a pressure"),
    ("Hz", "hertz", "1/s, a frequency; for angular velocities write `rev/s` or `rad/s`"),
    ("rad", "radian", "the SI unit of angles, a plain number"),
    ("deg", "degree", "π/180 rad"),
    ("rev", "revolution", "2π rad"),
    ("rpm", "revolution per minute", "2π/60 rad/s"),
    ("min", "minute", "60 s"),
    ("h", "hour", "3600 s"),
    ("t", "tonne", "1000 kg"),
];

const PREFIXES: &[(&str, &str, &str)] = &[
    ("n", "nano", "10⁻⁹"),
    ("u", "micro", "10⁻⁶"),
    ("m", "milli", "10⁻³"),
    ("c", "centi", "10⁻²"),
    ("d", "deci", "10⁻¹"),
    ("k", "kilo", "10³"),
    ("M", "mega", "10⁶"),
];

pub(super) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The paragraphs of docs of each keyword.
type Docs = BTreeMap<String, Vec<String>>;

/// The tables of the reference: the cells of the rows below each head.
pub(super) struct Reference(pub(super) String);

impl Reference {
    /// Returns the rows of all tables that begin with `head`.
    pub(super) fn rows(&self, head: &str) -> Vec<Vec<&str>> {
        let mut tables = self.0.split(head);
        let before = tables.next().is_some_and(|text| text.ends_with('\n'));
        assert!(before, "there is no table `{head}`");
        let lines = tables.flat_map(|table| {
            table.lines().skip(2).take_while(|line| line.starts_with('|')).collect::<Vec<_>>()
        });
        lines.map(|line| line.trim_matches('|').split(" |").map(str::trim).collect()).collect()
    }
}

/// Splits a cell that begins with keywords in backticks: the keywords, and what follows the last of them.
fn keywords_and_text(cell: &str) -> (Vec<String>, String) {
    let (mut names, mut rest) = (Vec::new(), cell);
    while let Some((name, after)) = rest.strip_prefix('`').and_then(|rest| rest.split_once('`')) {
        names.push(name.split(' ').next().expect("a word").to_owned());
        rest = after.trim_start();
        if rest.starts_with('(') {
            rest = rest.split_once(')').expect("a parenthesis").1;
        }
        rest = rest.trim_start_matches([' ']);
        match rest.strip_prefix(", `") {
            Some(_) => rest = &rest[2..],
            None => break,
        }
    }
    let gap = if rest.is_empty() || rest.starts_with([':', ',']) { "" } else { " " };
    (names, format!("{gap}{rest}"))
}

/// Returns `Unit: …`, of translations and rotations.
fn unit(translational: &str, rotational: &str) -> String {
    match (translational, rotational) {
        ("", _) => format!("Unit: {rotational}."),
        (_, "") => format!("Unit: {translational}."),
        _ => format!("Unit: {translational} for translations, {rotational} for rotations."),
    }
}

/// Links of the reference, as they are outside of it.
pub(super) fn linked(text: &str) -> String {
    text.replace("[see below](#", "[see the reference](#").replace("](#", "](crate::mstmm_chain#")
}

/// The docs of the fields of a table with the columns field, unit and default.
fn fields(rows: &[Vec<&str>], section: &str) -> Docs {
    let mut docs = Docs::new();
    for row in rows {
        let &[cell, of_unit, default] = &row[..] else { panic!("three cells: {row:?}") };
        let (names, text) = keywords_and_text(cell);
        for name in names.iter().filter(|name| *name != "point") {
            let mut values = Vec::new();
            values.extend((!of_unit.is_empty()).then(|| unit(of_unit, "")));
            values.extend((!default.is_empty()).then(|| format!("Default: {default}.")));
            let about = vec![format!("`{name}`{text}."), values.join(" "), section.to_owned()];
            docs.insert(name.clone(), about);
        }
    }
    docs
}

/// The docs of the fields of hinges: also those with the prefix of rotations.
fn hinge_fields(rows: &[Vec<&str>]) -> Docs {
    let section = "See [hinges](crate::mstmm_chain#hinges).";
    let known = keywords_of(KeywordGroup::Hinge);
    let mut docs = Docs::new();
    for row in rows {
        let &[cell, translational, rotational, default] = &row[..] else { panic!("{row:?}") };
        let (names, text) = keywords_and_text(cell);
        for name in &names {
            let of_unit = match (&**name, translational) {
                (_, "") => String::new(),
                ("start_velocity" | "force", _) => unit(translational, ""),
                ("start_rate" | "torque", _) => unit("", rotational),
                _ => unit(translational, rotational),
            };
            let values = format!("{of_unit} Default: {default}.");
            let about = vec![format!("`{name}`{text}."), values, section.to_owned()];
            docs.insert(name.clone(), about);
            let prefixed = format!("turning_{name}");
            if known.contains(&prefixed) {
                let first = format!("`{prefixed}`: the field `{name}` of the rotations.");
                let others =
                    "In a hinge that also has translations, `NAME` is that of the translations.";
                let values = format!("{} Default: {default}.", unit("", rotational));
                let about = vec![first, others.replace("NAME", name), values, section.to_owned()];
                docs.insert(prefixed, about);
            }
        }
    }
    docs
}

fn kinds(rows: &[Vec<&str>]) -> Docs {
    let mut docs = Docs::new();
    for row in rows {
        let &[kind, motion, coordinates, frame, rates] = &row[..] else { panic!("{row:?}") };
        let name = kind.trim_start_matches("[`").split(['`', '(']).next().expect("a name");
        let written = kind.split('`').nth(1).expect("the form");
        let others =
            kind.split_once(") (").map_or(String::new(), |(_, other)| format!(" ({other}"));
        let motion = if motion == "none" { "no motion" } else { motion };
        let mut values = vec![format!("Rotation R and displacement d: {frame}.")];
        if coordinates != "–" {
            values.insert(0, format!("Coordinates: {coordinates}."));
            values.push(format!("Rates, each with an effort: {rates}."));
        }
        let page =
            format!("See [the page of this kind](mod@crate::hinges::{name}) for its equations.");
        let about = vec![format!("`{written}`{others}: {motion}."), values.join(" "), page];
        docs.insert(name.to_owned(), about);
    }
    docs
}

fn settings(rows: &[Vec<&str>]) -> Docs {
    let about = rows.iter().map(|row| {
        let &[name, value, default] = &row[..] else { panic!("{row:?}") };
        let more = "See [the chain](crate::mstmm_chain#the-chain).";
        let first = format!("{name}: {value}.");
        (
            name.trim_matches('`').to_owned(),
            vec![first, format!("Default: {default}."), more.into()],
        )
    });
    about.collect()
}

fn units() -> Docs {
    let known = keywords_of(KeywordGroup::Units);
    let more = "See [numbers and units](crate::mstmm_chain#numbers-and-units).";
    let about = |symbol: &str, text: String| {
        (symbol.to_owned(), vec![format!("`{symbol}`: {text}."), more.to_owned()])
    };
    let mut docs = Docs::new();
    for (symbol, name, value) in UNITS {
        docs.extend([about(symbol, format!("{name}, {value}"))]);
        for (prefix, prefix_name, factor) in PREFIXES {
            let prefixed = format!("{prefix}{symbol}");
            if known.contains(&prefixed) && prefixed != "min" {
                let value = format!("{prefix_name}{name}, {factor} {symbol}");
                docs.entry(prefixed.clone()).or_insert(about(&prefixed, value).1);
            }
        }
    }
    docs
}

fn docs(group: KeywordGroup) -> Docs {
    let text = fs::read_to_string(root().join("src/language.md")).expect("the reference");
    let reference = Reference(text);
    let rows = |head: &str| reference.rows(head);
    match group {
        KeywordGroup::Kinds => kinds(&rows("| kind | motion | coordinates |")),
        KeywordGroup::Settings => settings(&rows("| setting | value | default |")),
        KeywordGroup::Body | KeywordGroup::Base => {
            let section = if group == KeywordGroup::Body { "bodies" } else { "ends" };
            let more = format!("See [{section}](crate::mstmm_chain#{section}).");
            let mut docs = fields(&rows("| field | unit | default |"), &more);
            docs.retain(|name, _| (group == KeywordGroup::Base) == name.starts_with("start"));
            docs
        }
        KeywordGroup::Hinge => hinge_fields(&rows("| field | translational | rotational |")),
        KeywordGroup::Load | KeywordGroup::Spring => {
            let block = if group == KeywordGroup::Load { "load" } else { "spring" };
            let more = "See [loads and springs](crate::mstmm_chain#loads-and-springs).";
            fields(&rows(&format!("| field of a `{block}` | unit | default |")), more)
        }
        KeywordGroup::Units => units(),
        // `answer_pages` makes their pages.
        KeywordGroup::Answers => Docs::new(),
    }
}

/// Breaks a paragraph into lines of docs.
fn wrapped(paragraph: &str, text: &mut String) {
    let mut line = String::from("///");
    for word in paragraph.split(' ') {
        if line.chars().count() + 1 + word.chars().count() > WIDTH {
            text.push_str(&line);
            text.push('\n');
            line = String::from("///");
        }
        line.push(' ');
        line.push_str(word);
    }
    text.push_str(&line);
    text.push('\n');
}

/// Adds the names that other tools have for a field of hinges: a paragraph, and an alias for each.
fn other_names(field: &str, text: &mut String) {
    let others = super::answer_pages::of_hinge_field(field);
    if others.is_empty() {
        return;
    }
    let listed: Vec<String> = others.iter().map(|other| format!("`{other}`")).collect();
    text.push_str("///\n");
    wrapped(&format!("Other tools: {}.", listed.join(", ")), text);
    for other in others {
        writeln!(text, "#[doc(alias = {other:?})]").expect("a text");
    }
}

/// The module of a group.
fn module(group: KeywordGroup, docs: &Docs) -> String {
    let mut text = String::from(
        "// Written by the test `keywords` of `mstmm-codegen` from `src/language.md`: change the tables there.\n",
    );
    if group == KeywordGroup::Hinge {
        text.push_str("// Names of other tools are from `src/terms.md`.\n");
    }
    for (name, paragraphs) in docs {
        let paragraphs = paragraphs.iter().filter(|paragraph| !paragraph.is_empty());
        let paragraphs: Vec<String> = paragraphs.map(|paragraph| linked(paragraph)).collect();
        text.push('\n');
        for (index, paragraph) in paragraphs.iter().enumerate() {
            if index > 0 {
                text.push_str("///\n");
            }
            wrapped(paragraph, &mut text);
        }
        if group == KeywordGroup::Hinge {
            other_names(name, &mut text);
        }
        // `mN.html` and `MN.html` would be one file where names ignore case.
        let is_plain = name == "kg" || UNITS.iter().any(|(symbol, ..)| symbol == name);
        if group == KeywordGroup::Units && !is_plain {
            text.push_str("#[doc(hidden)]\n");
        }
        writeln!(text, "pub enum {name} {{}}").expect("a text");
    }
    text
}

/// Generated code imports these together.
#[test]
fn groups_with_unique_names_have_no_common_keyword() {
    let groups = KeywordGroup::ALL.into_iter().filter(|group| group.has_unique_names());
    let mut words: Vec<String> = groups.flat_map(keywords_of).collect();
    let count = words.len();
    words.sort();
    words.dedup();
    assert_eq!(words.len(), count);
}

#[test]
fn the_reference_lists_all_reserved_names() {
    let text = fs::read_to_string(root().join("src/language.md")).expect("the reference");
    let (_, rest) = text.split_once("a name that the generated types use: ").expect("the list");
    let (list, _) = rest.split_once(';').expect("the end of the list");
    let mut listed: Vec<&str> = list.split('`').skip(1).step_by(2).collect();
    let mut reserved = RESERVED_NAMES.to_vec();
    listed.sort_unstable();
    reserved.sort_unstable();
    assert_eq!(listed, reserved);
}

#[test]
fn every_keyword_is_documented_as_in_the_reference() {
    for group in KeywordGroup::ALL {
        let (documented, expected) = match group {
            KeywordGroup::Answers => super::answer_pages::module(),
            _ => {
                let docs = docs(group);
                (docs.keys().cloned().collect(), module(group, &docs))
            }
        };
        assert_eq!(documented, keywords_of(group), "tables of `src/language.md`, {group:?}");
        let path = root().join(format!("src/keywords/{}.rs", group.module()));
        if std::env::var_os("MSTMM_BLESS").is_some() {
            fs::write(&path, expected).expect("a writable file");
            continue;
        }
        let committed = fs::read_to_string(&path).unwrap_or_default();
        assert!(committed == expected, "{}: MSTMM_BLESS=1 writes it", path.display());
    }
}
