//! Elements of a robot file, with their numbers and places.

use nalgebra::Vector3;
use roxmltree::Node;

use super::error::{ImportError, Place, Result};
use super::places::Places;
use super::robot::Note;

/// An element of the file.
#[derive(Clone, Copy)]
pub struct Element<'a> {
    node: Node<'a, 'a>,
    places: &'a Places<'a>,
}

impl<'a> Element<'a> {
    pub fn new(node: Node<'a, 'a>, places: &'a Places<'a>) -> Self {
        Element { node, places }
    }

    /// Returns another element of the same file.
    fn with(self, node: Node<'a, 'a>) -> Self {
        Element { node, ..self }
    }

    pub fn tag(self) -> &'a str {
        self.node.tag_name().name()
    }

    /// Returns the address of the namespace of the tag.
    pub fn namespace(self) -> Option<&'a str> {
        self.node.tag_name().namespace()
    }

    /// Returns the values of all attributes.
    pub fn values(self) -> impl Iterator<Item = &'a str> {
        self.node.attributes().map(|attribute| attribute.value())
    }

    /// Returns the names of all attributes without a namespace.
    pub fn names(self) -> impl Iterator<Item = &'a str> {
        let plain = self.node.attributes().filter(|attribute| attribute.namespace().is_none());
        plain.map(|attribute| attribute.name())
    }

    pub fn place(self) -> Place {
        self.places.at(self.node.range().start)
    }

    /// Makes an error that names the link, the joint or the body of the element.
    pub fn error(self, message: impl std::fmt::Display) -> ImportError {
        ImportError::at(self.place(), self.named(message))
    }

    /// Makes a warning that names the link, the joint or the body of the element.
    pub fn note(self, message: impl std::fmt::Display) -> Note {
        Note::new(self.place(), self.named(message))
    }

    /// Returns a message after the innermost name of a link, a joint or a body.
    fn named(self, message: impl std::fmt::Display) -> String {
        let is_owner = |tag: &str| matches!(tag, "link" | "joint" | "body");
        let owners = self.node.ancestors().map(|node| self.with(node));
        let mut owners = owners.filter(|owner| is_owner(owner.tag()));
        let owner = owners.find_map(|owner| Some((owner.tag(), owner.name()?)));
        let owner = owner.map_or_else(String::new, |(tag, name)| format!("{tag} `{name}`: "));
        format!("{owner}{message}")
    }

    /// Returns the child elements with a tag, in the order of the file.
    pub fn children(self, tag: &str) -> impl Iterator<Item = Element<'a>> {
        self.any_children().filter(move |child| child.tag() == tag)
    }

    /// Returns all child elements, in the order of the file.
    pub fn any_children(self) -> impl Iterator<Item = Element<'a>> {
        self.node.children().filter(Node::is_element).map(move |node| self.with(node))
    }

    /// Returns the element and all elements in it, in the order of the file.
    pub fn descendants(self) -> impl Iterator<Item = Element<'a>> {
        self.node.descendants().filter(Node::is_element).map(move |node| self.with(node))
    }

    pub fn child(self, tag: &str) -> Option<Element<'a>> {
        self.children(tag).next()
    }

    /// Returns the only child element with a tag, if there is one. Several are an error.
    pub fn only_child(self, tag: &str) -> Result<Option<Element<'a>>> {
        let mut children = self.children(tag);
        match (children.next(), children.next()) {
            (_, Some(second)) => Err(second.error(format!("a second `{tag}`: keep one"))),
            (first, None) => Ok(first),
        }
    }

    pub fn required_only_child(self, tag: &str) -> Result<Element<'a>> {
        self.only_child(tag)?.map_or_else(|| self.required_child(tag), Ok)
    }

    pub fn required_child(self, tag: &str) -> Result<Element<'a>> {
        self.child(tag).ok_or_else(|| self.error(format!("expected an element `{tag}`")))
    }

    pub fn attribute(self, name: &str) -> Option<&'a str> {
        self.node.attribute(name)
    }

    /// Returns the attribute `name`, unless it is empty.
    pub fn name(self) -> Option<&'a str> {
        self.attribute("name").filter(|name| !name.is_empty())
    }

    pub fn required_name(self) -> Result<&'a str> {
        match self.required_attribute("name")? {
            "" => Err(self.error(format!("`{}` has an empty `name`", self.tag()))),
            name => Ok(name),
        }
    }

    pub fn required_attribute(self, name: &str) -> Result<&'a str> {
        let missing = || self.error(format!("`{}` has no attribute `{name}`", self.tag()));
        self.attribute(name).ok_or_else(missing)
    }

    /// Returns one of several words, if the attribute is present. Other words are errors.
    pub fn keyword(self, name: &str, words: &[&str]) -> Result<Option<&'a str>> {
        let Some(found) = self.attribute(name) else { return Ok(None) };
        if words.contains(&found) {
            return Ok(Some(found));
        }
        let quoted: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
        let allowed = match &quoted[..] {
            [words @ .., last] if !words.is_empty() => format!("{} or {last}", words.join(", ")),
            _ => quoted.concat(),
        };
        Err(self.error(format!("`{name}` is {allowed}, not `{found}`")))
    }

    /// Returns a finite number, or the default if the attribute is absent.
    pub fn number(self, name: &str, default: f64) -> Result<f64> {
        let value = self.any_number(name, default)?;
        if value.is_finite() { Ok(value) } else { Err(self.bad(name, "is not finite")) }
    }

    /// Returns a number, which may be infinite.
    pub fn any_number(self, name: &str, default: f64) -> Result<f64> {
        let Some(text) = self.attribute(name) else { return Ok(default) };
        let value = text.trim().parse::<f64>().map_err(|_| self.bad(name, "is not a number"))?;
        if value.is_nan() { Err(self.bad(name, "is not a number")) } else { Ok(value) }
    }

    pub fn required_number(self, name: &str) -> Result<f64> {
        self.required_attribute(name)?;
        self.number(name, 0.0)
    }

    /// Returns three finite numbers, or the default if the attribute is absent.
    pub fn vector(self, name: &str, default: [f64; 3]) -> Result<Vector3<f64>> {
        if self.attribute(name).is_none() {
            return Ok(default.into());
        }
        let Ok(vector) = <[f64; 3]>::try_from(self.numbers_in(name, "is not three numbers")?)
        else {
            return Err(self.bad(name, "is not three numbers"));
        };
        Ok(vector.into())
    }

    /// Returns finite numbers; none if the attribute is absent.
    pub fn numbers(self, name: &str) -> Result<Vec<f64>> {
        self.numbers_in(name, "is not a list of numbers")
    }

    fn numbers_in(self, name: &str, reason: &str) -> Result<Vec<f64>> {
        let words = self.attribute(name).unwrap_or_default().split_whitespace();
        let numbers = words.map(str::parse::<f64>).collect::<std::result::Result<Vec<_>, _>>();
        let numbers = numbers.map_err(|_| self.bad(name, reason))?;
        match numbers.iter().all(|number| number.is_finite()) {
            true => Ok(numbers),
            false => Err(self.bad(name, "is not finite")),
        }
    }

    fn bad(self, name: &str, reason: &str) -> ImportError {
        let text = self.attribute(name).unwrap_or_default();
        self.error(format!("`{name}=\"{text}\"` of `{}` {reason}", self.tag()))
    }
}
