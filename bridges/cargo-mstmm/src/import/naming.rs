//! Names of bodies, hinges, points, types and parts, each unique.

use super::names::{Names, snake};
use super::parts::Group;
use super::scope::{NameTable, Source};

/// All names of the text.
pub struct Naming {
    pub table: NameTable,
    /// The names of the instances of each group.
    pub instances: Vec<Vec<String>>,
    /// The types of the parts.
    pub parts: Vec<String>,
    /// The names of types so far.
    pub types: Names,
}

impl Naming {
    pub fn of(source: Source, groups: &[Group]) -> Naming {
        let count = source.tree.bodies.len();
        let none = || vec![String::new(); count];
        let table = NameTable {
            bodies: none(),
            hinges: none(),
            places: none(),
            fixed: vec![Vec::new(); count],
        };
        let (instances, parts) = (Vec::new(), Vec::new());
        let mut naming = Naming { table, instances, parts, types: Names::default() };
        let mut names = Names::default();
        for group in groups {
            naming.add_part(group, &mut names);
        }
        naming.add_bodies(source, &mut names);
        naming.add_points(source, groups);
        naming
    }

    fn add_part(&mut self, group: &Group, names: &mut Names) {
        let part = self.types.unique(&group.type_name, "Part");
        let suffix = format!("_{}", snake(&part));
        let label = |label: &String| match group.is_shared {
            true => names.unique(&format!("{label}{suffix}"), ""),
            false => names.unique(label, &suffix),
        };
        let instances: Vec<String> = group.labels.iter().map(label).collect();
        let prefix = format!("{}_", instances[0]);
        for (position, inner) in group.names.iter().enumerate() {
            let body = names.unique_with(&inner.body, "_link", &prefix);
            let hinge = names.unique_with(&inner.hinge, "_joint", &prefix);
            for branch in &group.branches {
                self.table.bodies[branch[position]].clone_from(&body);
                self.table.hinges[branch[position]].clone_from(&hinge);
                self.table.fixed[branch[position]].clone_from(&inner.fixed);
            }
        }
        // So that no name outside equals one of another instance.
        for (branch, instance) in group.branches.iter().zip(&instances).skip(1) {
            for table in [&self.table.bodies, &self.table.hinges] {
                for &body in branch {
                    names.unique_with(&table[body], "", &format!("{instance}_"));
                }
            }
        }
        self.instances.push(instances);
        self.parts.push(part);
    }

    /// Names what is in no part, bodies first: a joint with the name of a link gets a suffix.
    fn add_bodies(&mut self, source: Source, names: &mut Names) {
        let free: Vec<usize> = (0..self.table.bodies.len())
            .filter(|body| self.table.bodies[*body].is_empty())
            .collect();
        for &body in &free {
            self.table.bodies[body] = names.unique(&snake(source.link_name(body)), "_link");
        }
        for &body in &free {
            if let Some(joint) = source.joint(body) {
                self.table.hinges[body] = names.unique(&snake(&joint.name), "_joint");
            }
        }
    }

    /// Names the points of bodies; each body has its own set of names.
    fn add_points(&mut self, source: Source, groups: &[Group]) {
        let place = |body: usize| {
            let instances = groups.iter().zip(&self.instances);
            let root = instances.flat_map(|(group, names)| group.branches.iter().zip(names));
            let instance =
                root.filter(|(branch, _)| branch[0] == body).map(|(_, name)| name).next();
            instance.unwrap_or(&self.table.hinges[body]).clone()
        };
        let places: Vec<String> = (0..self.table.bodies.len()).map(place).collect();
        for (index, body) in source.tree.bodies.iter().enumerate() {
            let mut names = Names::default();
            for &child in &body.children {
                self.table.places[child] = names.unique(&places[child], "_joint");
            }
            if !groups.iter().any(|group| group.contains(index)) {
                let links = body.fixed.iter().map(|(link, _)| &source.robot.links[*link].name);
                self.table.fixed[index] = links.map(|name| snake(name)).collect();
            }
            let fixed = std::mem::take(&mut self.table.fixed[index]);
            self.table.fixed[index] =
                fixed.iter().map(|name| names.unique(name, "_link")).collect();
        }
    }

    /// Returns the path of a body or a hinge as seen from outside of parts.
    pub fn path(&self, groups: &[Group], body: usize, name: &str) -> String {
        let instances = groups.iter().zip(&self.instances);
        let mut branches = instances.flat_map(|(group, names)| group.branches.iter().zip(names));
        match branches.find(|(branch, _)| branch.contains(&body)) {
            Some((_, instance)) => format!("{instance}.{name}"),
            None => name.to_owned(),
        }
    }
}
