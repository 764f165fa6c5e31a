//! Finds branches of one shape: they become instances of a part.

use super::expressions::{Expressions, Parameters};
use super::frame::Frame;
use super::names::{Names, common_words, snake};
use super::scope::{NameTable, Scope, Source};

/// Branches of one shape at one body or at the ground.
#[derive(Default)]
pub struct Group {
    /// The bodies of each branch, depth first.
    pub branches: Vec<Vec<usize>>,
    /// What distinguishes the names of each branch.
    pub labels: Vec<String>,
    pub parameters: Parameters,
    /// The names of the bodies, without labels.
    pub names: Vec<InnerNames>,
    /// A name for the type of the part.
    pub type_name: String,
    /// Whether other parts have one of the labels, such as `left`. Then instances have the name of the part too:
    /// `left_arm`.
    pub is_shared: bool,
}

/// The names of a body in a part.
#[derive(Clone)]
pub struct InnerNames {
    pub body: String,
    pub hinge: String,
    /// The links that are fixed to it.
    pub fixed: Vec<String>,
}

/// Returns all groups of branches; no branch is inside another one.
pub fn find(source: Source) -> Vec<Group> {
    let bodies = &source.tree.bodies;
    let roots = std::iter::once(source.tree.on_ground());
    let mut groups: Vec<Group> = Vec::new();
    // Outer branches come first, so those inside them are known.
    for siblings in roots.chain(bodies.iter().map(|body| body.children.clone())) {
        let is_taken = |body: &usize| {
            groups.iter().any(|group| group.branches.iter().any(|branch| branch.contains(body)))
        };
        let free = siblings.into_iter().filter(|body| !is_taken(body));
        let mut found: Vec<Group> = Vec::new();
        for branch in free.map(|body| source.tree.branch(body)).filter(|branch| branch.len() > 1) {
            if !found.iter_mut().any(|group| group.take(source, &branch)) {
                found.push(Group::of(branch));
            }
        }
        groups.extend(found.into_iter().filter(|group| group.branches.len() > 1));
    }
    name(&mut groups);
    groups
}

/// Names the types of all groups.
fn name(groups: &mut [Group]) {
    let mut types = Names::default();
    for group in groups.iter_mut() {
        group.type_name = types.unique(group.kind(), "");
    }
    let labels: Vec<String> = groups.iter().flat_map(|group| group.labels.clone()).collect();
    for group in groups {
        let count = |label: &String| labels.iter().filter(|other| *other == label).count();
        group.is_shared = group.labels.iter().any(|label| count(label) > 1);
        if group.is_shared {
            group.shorten_names();
        }
    }
}

impl Group {
    fn of(branch: Vec<usize>) -> Self {
        Group { branches: vec![branch], ..Group::default() }
    }

    /// Adds a branch, if it has the same shape, its names differ by a label, and few numbers differ.
    fn take(&mut self, source: Source, branch: &[usize]) -> bool {
        if !has_shape_of(source, &self.branches[0], branch) {
            return false;
        }
        let branches: Vec<Vec<usize>> =
            self.branches.iter().cloned().chain([branch.to_vec()]).collect();
        let Some((names, labels)) = common_names(source, &branches) else { return false };
        let Some(parameters) = parameters(source, &branches, &names, &labels) else { return false };
        *self = Group { branches, labels, parameters, names, ..Group::default() };
        true
    }

    /// Returns what kind of branch it is by its names, such as `Leg`.
    fn kind(&self) -> &'static str {
        const KINDS: &[(&str, &[&str])] = &[
            ("Finger", &["finger", "thumb"]),
            ("Leg", &["leg", "haa", "hfe", "hip", "thigh", "knee", "calf", "shank", "ankle"]),
            ("Arm", &["arm", "shoulder", "elbow", "wrist"]),
            ("Wheel", &["wheel", "caster"]),
        ];
        let is_kind = |name: &str, words: &[&str]| words.iter().any(|word| name.contains(word));
        let kind = |name: &String| KINDS.iter().find(|(_, words)| is_kind(name, words));
        // The names close to the root say most: an arm may have fingers.
        let mut names = self.names.iter().flat_map(|names| [&names.hinge, &names.body]);
        names.find_map(kind).map_or("Branch", |(kind, _)| kind)
    }

    /// Removes the name of the part where all names begin with it: `left_arm.elbow`, not `left_arm.arm_elbow`.
    fn shorten_names(&mut self) {
        let word = format!("{}_", snake(&self.type_name));
        let rest = |name: &String| -> Option<String> {
            let rest = name.strip_prefix(&word)?;
            rest.starts_with(|letter: char| letter.is_ascii_alphabetic()).then(|| rest.to_owned())
        };
        let shorter = self.names.iter().map(|names| {
            let fixed = names.fixed.iter().map(rest).collect::<Option<_>>()?;
            Some(InnerNames { body: rest(&names.body)?, hinge: rest(&names.hinge)?, fixed })
        });
        if let Some(names) = shorter.collect() {
            self.names = names;
            for name in self.parameters.names_mut() {
                *name = rest(name).unwrap_or_else(|| name.clone());
            }
        }
    }
}

/// Returns whether two branches have the same bodies and hinges, except for numbers.
fn has_shape_of(source: Source, first: &[usize], second: &[usize]) -> bool {
    let is_same = |(&a, &b): (&usize, &usize)| {
        let (one, other) = (&source.tree.bodies[a], &source.tree.bodies[b]);
        let (Some(one_joint), Some(other_joint)) = (source.joint(a), source.joint(b)) else {
            return false;
        };
        // Depth first, the numbers of children determine the shape.
        one.children.len() == other.children.len()
            && one
                .fixed
                .iter()
                .map(|(_, frame)| frame.is_identity())
                .eq(other.fixed.iter().map(|(_, frame): &(usize, Frame)| frame.is_identity()))
            && one_joint.kind == other_joint.kind
            && one_joint.limit.range.is_some() == other_joint.limit.range.is_some()
            && (one_joint.damping == 0.0) == (other_joint.damping == 0.0)
            && (one_joint.friction == 0.0) == (other_joint.friction == 0.0)
            && (one_joint.armature == 0.0) == (other_joint.armature == 0.0)
    };
    first.len() == second.len() && first.iter().zip(second).all(is_same)
}

/// Returns a label, in words if it is a letter: `left` for `l`. Files use both for one branch.
fn side(label: &str) -> &str {
    match label {
        "l" => "left",
        "r" => "right",
        other => other,
    }
}

/// Returns the names in the part, and the label of each branch.
fn common_names(source: Source, branches: &[Vec<usize>]) -> Option<(Vec<InnerNames>, Vec<String>)> {
    let mut all: Option<Vec<String>> = None;
    let mut inner = |names: Vec<String>| {
        let (common, labels) = common_words(&names)?;
        let known = all.get_or_insert_with(|| labels.clone());
        let is_same = |(known, label): (&String, &String)| side(known) == side(label);
        known.iter().zip(&labels).all(is_same).then_some(common)
    };
    let each = |position: usize, name: &dyn Fn(usize) -> Option<String>| {
        branches.iter().map(|branch| name(branch[position])).collect::<Option<Vec<String>>>()
    };
    let mut names = Vec::new();
    for (position, first) in branches[0].iter().enumerate() {
        let body = inner(each(position, &|body| Some(snake(source.link_name(body))))?)?;
        let hinge = inner(each(position, &|body| Some(snake(&source.joint(body)?.name)))?)?;
        let count = source.tree.bodies[*first].fixed.len();
        let fixed = (0..count).map(|index| {
            let link =
                |body: usize| source.tree.bodies[body].fixed.get(index).map(|(link, _)| *link);
            inner(each(position, &|body| Some(snake(&source.robot.links[link(body)?].name)))?)
        });
        names.push(InnerNames { body, hinge, fixed: fixed.collect::<Option<_>>()? });
    }
    Some((names, all?))
}

/// Returns the parameters of a part, if there are few.
fn parameters(
    source: Source,
    branches: &[Vec<usize>],
    names: &[InnerNames],
    labels: &[String],
) -> Option<Parameters> {
    let count = source.tree.bodies.len();
    let none = vec![String::new(); count];
    let fixed = vec![Vec::new(); count];
    let mut table = NameTable { bodies: none.clone(), hinges: none.clone(), places: none, fixed };
    for (&body, names) in branches[0].iter().zip(names) {
        table.bodies[body].clone_from(&names.body);
        table.hinges[body].clone_from(&names.hinge);
        table.places[body].clone_from(&names.hinge);
        table.fixed[body].clone_from(&names.fixed);
    }
    let expressions = Expressions::default();
    let mut scope = Scope { source, names: &table, branches, expressions };
    for position in 0..names.len() {
        scope.fields(position);
        scope.hinge_kind(position);
        scope.properties(position);
    }
    scope.expressions.choose(labels)
}
