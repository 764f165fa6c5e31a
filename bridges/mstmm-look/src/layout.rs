//! The columns of a motion.

use crate::Mechanism;
use mstmm_runtime::Description;
use mstmm_runtime::description::Quantities;

/// A group of recorded quantities.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Group {
    /// Coordinates of the hinges.
    Coordinates,
    /// Rates of the hinges.
    Rates,
    /// Accelerations of the hinges.
    Accelerations,
    /// Efforts of motors and of prescribed motions.
    Efforts,
    /// Inputs.
    Inputs,
    /// Kinetic and potential energy.
    Energies,
    /// Length, rate of the length, tension and force of springs.
    Springs,
    /// Positions and orientations of connection points.
    Poses,
    /// Velocities and angular velocities of connection points.
    Velocities,
    /// Internal forces and moments at connection points.
    Wrenches,
}

impl Group {
    /// All groups, in the order of the columns.
    pub const ALL: [Group; 10] = [
        Group::Coordinates,
        Group::Rates,
        Group::Accelerations,
        Group::Efforts,
        Group::Inputs,
        Group::Energies,
        Group::Springs,
        Group::Poses,
        Group::Velocities,
        Group::Wrenches,
    ];
}

/// The content of a recording: groups of quantities, and a stride `n`: every `n`-th state is recorded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    groups: Vec<Group>,
    stride: usize,
}

/// All groups except velocities of connection points, and every state.
impl Default for Options {
    fn default() -> Self {
        let groups = Group::ALL.into_iter().filter(|group| *group != Group::Velocities).collect();
        Options { groups, stride: 1 }
    }
}

impl Options {
    /// Records a group, too.
    #[must_use]
    pub fn with(mut self, group: Group) -> Self {
        if !self.has(group) {
            self.groups.push(group);
        }
        self
    }

    /// Omits a group. A page needs [`Group::Poses`].
    #[must_use]
    pub fn without(mut self, group: Group) -> Self {
        self.groups.retain(|it| *it != group);
        self
    }

    /// Records the first of every `stride` states; zero counts as one.
    #[must_use]
    pub fn stride(mut self, stride: usize) -> Self {
        self.stride = stride.max(1);
        self
    }

    /// Returns whether a group is recorded.
    #[must_use]
    pub fn has(&self, group: Group) -> bool {
        self.groups.contains(&group)
    }

    pub(crate) fn every(&self) -> usize {
        self.stride
    }
}

/// A recorded quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// The name, such as `elbow.angle` or `rod.input.force.x`.
    pub name: String,
    /// The unit as text, such as `N*m`; `1` for components of quaternions.
    pub unit: &'static str,
    /// The limits of a coordinate.
    pub limits: Option<[f64; 2]>,
}

/// Adjacent columns that form an array in each frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// The name, such as `coordinates` or `force`.
    pub name: &'static str,
    /// The group; `None` for the time.
    pub group: Option<Group>,
    /// The index of its first column.
    pub first: usize,
    /// The lengths of the array in each frame: none for a scalar, `[points, 3]` for forces.
    pub shape: Vec<usize>,
    /// What the entries along the first axis are called in an NPZ file, such as `coordinate_names`.
    pub names: Option<(&'static str, Vec<String>)>,
}

impl Block {
    /// Returns the number of columns.
    #[must_use]
    pub fn width(&self) -> usize {
        self.shape.iter().product()
    }
}

/// The columns of a motion and their blocks.
#[derive(Clone, Debug, Default)]
pub struct Layout {
    pub columns: Vec<Column>,
    pub blocks: Vec<Block>,
}

/// Which results a chain computes: its setting `results` may omit some.
#[derive(Clone, Copy, Debug)]
pub struct Computed {
    pub poses: bool,
    pub velocities: bool,
    pub z: bool,
    pub energies: bool,
    pub springs: bool,
}

const XYZ: [&str; 3] = ["x", "y", "z"];
const WXYZ: [&str; 4] = ["w", "x", "y", "z"];

impl Layout {
    /// Returns the columns of a chain.
    pub fn new(
        it: &Description,
        mechanism: &Mechanism,
        options: &Options,
        computed: Computed,
    ) -> Self {
        let mut layout = Layout::default();
        layout.column("time".to_owned(), "s");
        layout.block("time", None, vec![]);
        for (group, name, names, list) in [
            (Group::Coordinates, "coordinates", "coordinate_names", it.coordinates()),
            (Group::Rates, "rates", "rate_names", it.rates()),
            (Group::Accelerations, "accelerations", "acceleration_names", it.accelerations()),
            (Group::Efforts, "efforts", "effort_names", it.efforts()),
            (Group::Inputs, "inputs", "input_names", it.inputs()),
        ] {
            if options.has(group) {
                layout.quantities(group, (name, names), list);
            }
        }
        if options.has(Group::Energies) && computed.energies {
            for name in ["kinetic_energy", "potential_energy"] {
                layout.column(name.to_owned(), "J");
                layout.block(name, Some(Group::Energies), vec![]);
            }
        }
        if options.has(Group::Springs) && computed.springs {
            let springs: Vec<String> =
                it.springs().iter().map(|it| it.name().to_string()).collect();
            let group = Group::Springs;
            layout.items(group, ("spring_length", "length", "m"), &springs, &[]);
            layout.items(group, ("spring_length_rate", "length_rate", "m/s"), &springs, &[]);
            layout.items(group, ("spring_tension", "tension", "N"), &springs, &[]);
            layout.items(group, ("spring_force", "force", "N"), &springs, &XYZ);
        }
        let points: Vec<String> = mechanism.points.iter().map(|it| it.name.clone()).collect();
        for (group, is_computed, name, unit, components) in [
            (Group::Poses, computed.poses, "position", "m", &XYZ[..]),
            (Group::Poses, computed.poses, "orientation", "1", &WXYZ),
            (Group::Velocities, computed.velocities, "velocity", "m/s", &XYZ),
            (Group::Velocities, computed.velocities, "angular_velocity", "rad/s", &XYZ),
            (Group::Wrenches, computed.z, "force", "N", &XYZ),
            (Group::Wrenches, computed.z, "moment", "N*m", &XYZ),
        ] {
            if options.has(group) && is_computed {
                layout.items(group, (name, name, unit), &points, components);
            }
        }
        layout
    }

    /// Returns a block by its name.
    pub fn find(&self, name: &str) -> Option<&Block> {
        self.blocks.iter().find(|block| block.name == name)
    }

    fn column(&mut self, name: String, unit: &'static str) {
        self.columns.push(Column { name, unit, limits: None });
    }

    /// Makes a block of the last columns.
    fn block(&mut self, name: &'static str, group: Option<Group>, shape: Vec<usize>) {
        let width: usize = shape.iter().product();
        let first = self.columns.len() - width;
        self.blocks.push(Block { name, group, first, shape, names: None });
    }

    fn quantities(
        &mut self,
        group: Group,
        (name, names): (&'static str, &'static str),
        list: Quantities,
    ) {
        for quantity in list.iter() {
            let (name, unit) = (quantity.name.to_string(), quantity.unit);
            self.columns.push(Column { name, unit, limits: quantity.limits });
        }
        self.block(name, Some(group), vec![list.len()]);
        self.name_last(names, list.iter().map(|quantity| quantity.name.to_string()).collect());
    }

    /// Adds a block with the same components for each item.
    fn items(
        &mut self,
        group: Group,
        (block, name, unit): (&'static str, &'static str, &'static str),
        items: &[String],
        components: &[&str],
    ) {
        for item in items {
            match components {
                [] => self.column(format!("{item}.{name}"), unit),
                _ => components.iter().for_each(|component| {
                    self.column(format!("{item}.{name}.{component}"), unit);
                }),
            }
        }
        let mut shape = vec![items.len()];
        shape.extend((!components.is_empty()).then_some(components.len()));
        self.block(block, Some(group), shape);
        let names = if group == Group::Springs { "spring_names" } else { "point_names" };
        self.name_last(names, items.to_vec());
    }

    fn name_last(&mut self, array: &'static str, names: Vec<String>) {
        if let Some(block) = self.blocks.last_mut() {
            block.names = Some((array, names));
        }
    }
}
