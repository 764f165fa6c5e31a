//! A robot as the text of a chain.

use std::collections::HashMap;

use super::comments::comments;
use super::expressions::Expressions;
use super::names::{Names, camel};
use super::naming::Naming;
use super::numbers::{number, wrapped};
use super::parts::{Group, find};
use super::scope::{Scope, Source};

/// What the text needs in addition to the robot.
pub struct Heading<'a> {
    /// The name of the chain.
    pub chain: &'a str,
    /// The file, for a comment.
    pub file: &'a str,
    /// What the text has otherwise than the file.
    pub warnings: &'a [String],
}

/// The text, and where it comes from.
pub struct Written {
    pub text: String,
    /// The link of each body type, in the order of the text.
    pub types: Vec<usize>,
}

/// Returns the text.
pub fn write(source: Source, heading: &Heading) -> Written {
    let groups = find(source);
    let naming = Naming::of(source, &groups);
    let mut writer = Writer { source, groups: &groups, naming, types: Vec::new() };
    let mut lines = comments(source, &groups, &writer.naming, heading);
    lines.push("mstmm_chain! {".to_owned());
    lines.push(format!("    /// The robot `{}`: {}.", heading.chain, size(source)));
    lines.push(format!("    pub chain {} {{", heading.chain));
    let gravity: [String; 3] = <[f64; 3]>::from(source.robot.gravity).map(number);
    lines.push(format!("        gravity = [{}] m/s^2;", gravity.join(", ")));
    lines.push(String::new());
    lines.extend(writer.items().into_iter().map(|line| format!("        {line}")));
    lines.push("    }\n}".to_owned());
    let text = lines.iter().map(|line| line.trim_end().to_owned() + "\n").collect();
    Written { text, types: writer.types }
}

/// Describes the number of bodies and of degrees of freedom.
pub fn size(source: Source) -> String {
    use super::robot::Kind;
    let bodies = source.tree.bodies.len();
    let freedom = (0..bodies).map(|body| match source.joint(body).map(|joint| joint.kind) {
        None | Some(Kind::Floating) => 6,
        Some(Kind::Planar | Kind::Ball) => 3,
        Some(_) => 1,
    });
    let freedom: usize = freedom.sum();
    let plural = |count: usize, one: &str, many: &str| {
        if count == 1 { format!("1 {one}") } else { format!("{count} {many}") }
    };
    let freedom = plural(freedom, "degree of freedom", "degrees of freedom");
    format!("{}, {freedom}", plural(bodies, "body", "bodies"))
}

struct Writer<'a> {
    source: Source<'a>,
    groups: &'a [Group],
    naming: Naming,
    /// The link of each body type so far.
    types: Vec<usize>,
}

/// The texts of a scope.
struct Texts {
    /// The blocks of the types.
    types: Vec<String>,
    /// The steps of the routes: the hinge of a body, if it has one, and the body.
    steps: Vec<Vec<String>>,
    /// The blocks of the hinges.
    hinges: Vec<String>,
}

impl Writer<'_> {
    /// Returns all lines of the chain after its settings.
    fn items(&mut self) -> Vec<String> {
        let bodies = 0..self.source.tree.bodies.len();
        let is_in_part = |body: &usize| self.groups.iter().any(|group| group.contains(*body));
        let free: Vec<usize> = bodies.filter(|body| !is_in_part(body)).collect();
        let branches = [free];
        let texts = self.texts(&branches, Expressions::default(), "");
        let mut lines = texts.types;
        for index in 0..self.groups.len() {
            lines.push(String::new());
            lines.extend(self.part(index));
        }
        lines.push(String::new());
        lines.extend(self.routes(&branches[0], &texts.steps));
        if !texts.hinges.is_empty() {
            lines.push(String::new());
        }
        lines.extend(texts.hinges);
        lines
    }

    fn part(&mut self, index: usize) -> Vec<String> {
        let group = &self.groups[index];
        let name = self.naming.parts[index].clone();
        let expressions = Expressions::with(group.parameters.clone());
        let texts = self.texts(&group.branches, expressions, &name);
        let parameters: Vec<&str> = group.parameters.all().map(|p| &*p.name).collect();
        let list = match parameters[..] {
            [] => String::new(),
            _ => format!("({})", parameters.join(", ")),
        };
        let mut inner = texts.types;
        inner.extend(self.inner_routes(&group.branches[0], &texts.steps));
        inner.extend(texts.hinges);
        let mut lines: Vec<String> = self.signs(group);
        lines.extend(wrapped(&format!("part {name}{list} {{"), "    ", ", "));
        lines.extend(inner.into_iter().map(|line| format!("    {line}")));
        lines.push("}".to_owned());
        lines
    }

    /// Explains the parameters of a part that are signs.
    fn signs(&self, group: &Group) -> Vec<String> {
        let explain = |name: &str| match name {
            "side" => Some("`side` is 1 left and -1 right"),
            "front" => Some("`front` is 1 in front and -1 behind"),
            _ => None,
        };
        let explained: Vec<&str> =
            group.parameters.all().filter_map(|p| explain(&p.name)).collect();
        match explained[..] {
            [] => Vec::new(),
            _ => vec![format!("/// {}.", explained.join(", "))],
        }
    }

    fn texts(&mut self, branches: &[Vec<usize>], expressions: Expressions, part: &str) -> Texts {
        let mut scope =
            Scope { source: self.source, names: &self.naming.table, branches, expressions };
        let mut types: HashMap<String, String> = HashMap::new();
        let mut texts = Texts { types: Vec::new(), steps: Vec::new(), hinges: Vec::new() };
        let mut blocks: Vec<HingeBlock> = Vec::new();
        for (position, &body) in branches[0].iter().enumerate() {
            let fields = scope.fields(position);
            // Equal bodies are one type.
            let name = types.entry(fields.join("\n")).or_insert_with(|| {
                let name = type_name(&mut self.naming.types, &self.naming.table.bodies[body], part);
                texts.types.extend(block(&format!("body {name}"), &fields));
                self.types.push(self.source.tree.bodies[body].link);
                name
            });
            let step = format!("{name} {}", self.naming.table.bodies[body]);
            if self.source.joint(body).is_none() {
                texts.steps.push(vec![step]);
                continue;
            }
            let hinge = &self.naming.table.hinges[body];
            texts.steps.push(vec![format!("{} {hinge}", scope.hinge_kind(position)), step]);
            let (fields, largest) = (scope.properties(position), scope.largest(position));
            match blocks.iter_mut().find(|block| block.fields == fields) {
                Some(block) => block.hinges.push((hinge.clone(), largest)),
                None => blocks.push(HingeBlock { fields, hinges: vec![(hinge.clone(), largest)] }),
            }
        }
        for block in blocks.iter().filter(|block| !block.fields.is_empty()) {
            texts.hinges.extend(block.comment());
            texts.hinges.extend(block.text());
        }
        texts
    }

    /// Returns the routes outside of parts. A route continues while a body has a single child.
    fn routes(&self, free: &[usize], steps: &[Vec<String>]) -> Vec<String> {
        let mut lines = Vec::new();
        for (index, body) in self.source.tree.bodies.iter().enumerate() {
            if let Some(instance) = self.instance(index) {
                lines.extend(route([self.place(index), instance]));
            } else if let Some(position) = free.iter().position(|free| *free == index) {
                let is_begun = body.inboard.is_some_and(|inboard| self.has_one_child(inboard));
                if !is_begun {
                    let place = body.joint.map(|_| self.place(index));
                    lines.extend(route(place.into_iter().chain(self.path(free, steps, position))));
                }
            }
        }
        lines
    }

    /// Returns the routes of a part.
    fn inner_routes(&self, branch: &[usize], steps: &[Vec<String>]) -> Vec<String> {
        let mut lines = Vec::new();
        for (position, &body) in branch.iter().enumerate() {
            let inboard = self.source.tree.bodies[body].inboard;
            if position == 0 {
                lines.extend(route(self.path(branch, steps, position)));
            } else if !inboard.is_some_and(|inboard| self.has_one_child(inboard)) {
                lines.extend(route(
                    [self.place(body)].into_iter().chain(self.path(branch, steps, position)),
                ));
            }
        }
        lines
    }

    fn has_one_child(&self, body: usize) -> bool {
        self.source.tree.bodies[body].children.len() == 1
    }

    /// Returns the steps of a body and of the bodies that continue its route.
    fn path(&self, bodies: &[usize], steps: &[Vec<String>], position: usize) -> Vec<String> {
        let mut path = steps[position].clone();
        let mut body = bodies[position];
        while let [child] = self.source.tree.bodies[body].children[..] {
            body = child;
            let position = bodies.iter().position(|other| *other == body);
            path.extend(position.into_iter().flat_map(|position| steps[position].clone()));
        }
        path
    }

    /// Returns the place where a hinge leaves its inboard body or the ground.
    fn place(&self, body: usize) -> String {
        let described = &self.source.tree.bodies[body];
        match described.inboard {
            Some(inboard) => {
                format!("{}.{}", self.naming.table.bodies[inboard], self.naming.table.places[body])
            }
            None => {
                let expressions = Expressions::default();
                let (source, names) = (self.source, &self.naming.table);
                let mut scope = Scope { source, names, branches: &[], expressions };
                let frame = std::slice::from_ref(&described.frame);
                match (described.frame.position.norm() == 0.0, described.frame.is_parallel()) {
                    (true, true) => "ground".to_owned(),
                    (true, false) => format!("ground turned {}", scope.orientation(frame, "")),
                    _ => format!("ground at {}", scope.frame(frame, "")),
                }
            }
        }
    }

    /// Returns the step of the part that begins with a body.
    fn instance(&self, body: usize) -> Option<String> {
        for (index, group) in self.groups.iter().enumerate() {
            if let Some(branch) = group.branches.iter().position(|branch| branch[0] == body) {
                let values = group.parameters.all().map(|p| number(p.values[branch]));
                let values: Vec<String> = values.collect();
                let list = if values.is_empty() {
                    String::new()
                } else {
                    format!("({})", values.join(", "))
                };
                return Some(format!(
                    "{}{list} {}",
                    self.naming.parts[index], self.naming.instances[index][branch]
                ));
            }
        }
        None
    }
}

impl Group {
    /// Returns whether a body is in a branch.
    pub fn contains(&self, body: usize) -> bool {
        self.branches.iter().any(|branch| branch.contains(&body))
    }
}

/// Returns the name of a body type. In a part its results have the name of the part, too.
fn type_name(types: &mut Names, body: &str, part: &str) -> String {
    types.unique_with(&camel(body), "Link", part)
}

fn route(steps: impl IntoIterator<Item = String>) -> Vec<String> {
    let steps: Vec<String> = steps.into_iter().collect();
    wrapped(&format!("{};", steps.join(" -> ")), "    ", " -> ")
}

fn block(head: &str, fields: &[String]) -> Vec<String> {
    let mut lines = vec![format!("{head} {{")];
    let indent = |field: &str| if field.starts_with("//") { "//     " } else { "    " };
    let fields = fields.iter().flat_map(|field| match field.contains('"') {
        // A line break would change the text in quotes.
        true => vec![field.clone()],
        false => wrapped(field, indent(field), ", "),
    });
    lines.extend(fields.map(|line| format!("    {line}")));
    lines.push("}".to_owned());
    lines
}

/// Hinges with the same fields.
struct HingeBlock {
    fields: Vec<String>,
    /// Their names, each with what the file limits and a chain does not.
    hinges: Vec<(String, Option<String>)>,
}

impl HingeBlock {
    /// Returns the largest efforts and velocities of the file.
    fn comment(&self) -> Vec<String> {
        let (_, first) = &self.hinges[0];
        let list = match first {
            Some(first) if self.hinges.iter().all(|(_, other)| other.as_ref() == Some(first)) => {
                first.clone()
            }
            _ => {
                let each = |(name, largest): &(String, Option<String>)| {
                    largest.as_ref().map(|largest| format!("{name} {largest}"))
                };
                self.hinges.iter().filter_map(each).collect::<Vec<_>>().join("; ")
            }
        };
        match list.is_empty() {
            true => Vec::new(),
            false => wrapped(
                &format!("// Largest in the file, not limited here: {list}."),
                "//     ",
                ", ",
            ),
        }
    }

    fn text(&self) -> Vec<String> {
        let names: Vec<&str> = self.hinges.iter().map(|(name, _)| &**name).collect();
        let head = format!("hinge {}", names.join(", "));
        let line = format!("{head} {{ {} }}", self.fields.join(" "));
        if line.len() <= 96 {
            return vec![line];
        }
        let mut lines = wrapped(&format!("{head} {{"), "    ", ", ");
        lines.extend(self.fields.iter().map(|field| format!("    {field}")));
        lines.push("}".to_owned());
        lines
    }
}
