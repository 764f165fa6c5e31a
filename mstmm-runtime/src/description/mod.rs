//! The description of a chain at run time: names, units, kinds and starts of its coordinates, rates, inputs and
//! parameters, and its hinges, bodies, springs and connection points.
//!
//! [`Described`] is implemented by all chains of `mstmm_chain!`. The description is static data. A program that does not
//! read it does not contain it.
//!
//! # Names
//!
//! A name is the path of the description, followed by that of the accessor:
//!
//! | quantity | name | in Rust |
//! |---|---|---|
//! | coordinate | `elbow.angle` | `state.elbow().angle()` |
//! | coordinate of a repeated hinge | `joint[12].angle` | `state.joint(12)?.angle()` |
//! | coordinate in an instance `fl` of a part | `fl.knee.angle` | `state.fl_knee().angle()` |
//! | quaternion of a ball | `hook.orientation.w`, then `x`, `y`, `z` | `state.hook().orientation().w`, then `i`, `j`, `k` |
//! | rate | `base.velocity.x` | `state.base().velocity().x` |
//! | acceleration | `elbow.acceleration`; of a hinge with translations and rotations `base.acceleration.linear.x` | `at.elbow().acceleration()` |
//! | effort | `elbow.effort`; of a hinge with translations and rotations `base.effort.torque.x` | `at.elbow().effort()` |
//! | input of a motor | `elbow` | `inputs.elbow` |
//! | efforts of a hinge with translations and rotations | `base.force.x`, `base.torque.x` | entries of `inputs.base` |
//! | force of a load `push` | `push.force.x` | `inputs.push_force.x` |
//! | prescribed motion | `crank.state.angle`, `crank.state.rate`, `crank.acceleration` | `inputs.crank.state.angle()` |
//! | parameter | `payload`, `stiffness[7]` | `chain.parameters().payload()` |
//! | connection point | `rod.input` | `at.rod().input()` |
//!
//! A [`Name`] is formed when it is displayed, so the tables do not grow with the number of repetitions. The names of
//! one list are all different.
//!
//! # Orders
//!
//! The lists are in the orders of the arrays: coordinates and rates in that of [`ChainState`](crate::ChainState),
//! inputs and parameters in that of the columns of a linearisation, connection points in that of `points()` of a
//! workspace. Hinges, bodies and springs are in the order of the text. A repeated part is in the order of its
//! repetitions: all of the first one, then all of the second one, and so on.

mod answers;
mod body;
mod described;
mod displacement;
mod geometry;
mod hinge;
mod items;
mod name;
pub(crate) mod origin;
mod part;
mod quantity;
mod results;
mod rows;
mod shape;
mod table;
mod values;

pub use crate::origin::Origin;
pub use answers::{Answer, AnswerPart, Answers, BodyFrame};
#[doc(hidden)]
pub use body::WrittenInertia;
pub use body::{Body, BodyInertia};
pub use described::Described;
pub(crate) use described::no_parameter;
pub use geometry::{HingeAxis, Spring, SpringEnd};
#[doc(hidden)]
pub use geometry::{Indices, WrittenEnd, WrittenVectors};
pub use hinge::{Dofs, Hinge, HingeShape};
pub use items::{Item, Items};
pub use name::Name;
pub use part::QuantityKind;
pub use quantity::{Quantities, Quantity};
#[doc(hidden)]
pub use results::Arrays;
pub use results::PointResult;
pub use rows::{Input, Parameter, Place};
pub use shape::{Geometry, Shape};
#[doc(hidden)]
pub use values::Values;

use table::Table;

/// The dimension of the space that a chain moves in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// Translations and rotations in space.
    Space,
    /// Translations along x and y, rotations about z.
    Plane,
    /// Translations along x.
    Line,
}

/// The description of a chain.
#[derive(Clone, Copy, Debug)]
pub struct Description {
    name: &'static str,
    docs: &'static str,
    dimension: Dimension,
    hinges: Table<Hinge>,
    bodies: Table<Body>,
    springs: Table<Spring>,
    points: Table<Place>,
    inputs: Table<Input>,
    parameters: Table<Parameter>,
    answers: &'static [&'static str],
}

impl Description {
    /// Makes the description of a chain without elements.
    pub(crate) const fn new(name: &'static str, docs: &'static str, dimension: Dimension) -> Self {
        Description {
            name,
            docs,
            dimension,
            hinges: Table::EMPTY,
            bodies: Table::EMPTY,
            springs: Table::EMPTY,
            points: Table::EMPTY,
            inputs: Table::EMPTY,
            parameters: Table::EMPTY,
            answers: &[],
        }
    }

    /// Returns the name of the chain.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        self.name
    }

    /// Returns the doc comment of the chain, line by line; empty if there is none.
    #[must_use]
    pub const fn docs(&self) -> &'static str {
        self.docs
    }

    /// Returns the dimension of the space that the chain moves in.
    #[must_use]
    pub const fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// Returns the keywords of `answers = […]`, with those that a keyword such as `basic` stands for.
    #[must_use]
    pub const fn answers(&self) -> &'static [&'static str] {
        self.answers
    }

    /// Returns whether the chain has the functions of a keyword of `answers = […]`.
    #[must_use]
    pub fn answers_to(&self, keyword: &str) -> bool {
        self.answers.contains(&keyword)
    }

    /// Returns the coordinates, in the order of [`ChainState::coordinates`](crate::ChainState::coordinates).
    #[doc(alias("GetPositionNames", "GetStateNames"))]
    #[must_use]
    pub const fn coordinates(&self) -> Quantities {
        Quantities::coordinates(self.hinges)
    }

    /// Returns the rates, in the order of [`ChainState::rates`](crate::ChainState::rates).
    #[doc(alias("GetVelocityNames", "GetStateNames"))]
    #[must_use]
    pub const fn rates(&self) -> Quantities {
        Quantities::rates(self.hinges)
    }

    /// Returns the accelerations, in the order of [`rates`](Self::rates).
    #[must_use]
    pub const fn accelerations(&self) -> Quantities {
        Quantities::accelerations(self.hinges)
    }

    /// Returns the efforts of all hinges, in the order of the rates. Hinges with a prescribed motion have entries, too:
    /// the efforts that their drives must supply.
    #[must_use]
    pub const fn efforts(&self) -> Quantities {
        Quantities::efforts(self.hinges)
    }

    /// Returns the inputs.
    #[doc(alias("GetActuatorNames"))]
    #[must_use]
    pub const fn inputs(&self) -> Quantities {
        Quantities::inputs(self.inputs)
    }

    /// Returns the parameters.
    #[must_use]
    pub const fn parameters(&self) -> Quantities {
        Quantities::parameters(self.parameters)
    }

    /// Returns the hinges, with a floating base and the motions of moving ends, which have the name of their body or end.
    #[must_use]
    pub const fn hinges(&self) -> Items<Hinge> {
        Items::new(self.hinges)
    }

    /// Returns the bodies on the routes.
    #[must_use]
    pub const fn bodies(&self) -> Items<Body> {
        Items::new(self.bodies)
    }

    /// Returns the springs between bodies, or between a body and the ground.
    #[must_use]
    pub const fn springs(&self) -> Items<Spring> {
        Items::new(self.springs)
    }

    /// Returns the connection points, in the order of `points()` of a workspace.
    ///
    /// Each has one name: that of a body if it is the input, the output or a named point of a body. Other points are
    /// the inputs or outputs of hinges: points on the ground or at moving ends, and the separate input of a hinge that
    /// leaves a place together with others.
    #[must_use]
    pub const fn points(&self) -> Items<Place> {
        Items::new(self.points)
    }

    /// Returns the index of a coordinate, such as `joint[12].angle`.
    #[must_use]
    pub fn coordinate(&self, name: &str) -> Option<usize> {
        self.coordinates().index(name)
    }

    /// Returns the index of a rate, such as `elbow.rate`.
    #[must_use]
    pub fn rate(&self, name: &str) -> Option<usize> {
        self.rates().index(name)
    }

    /// Returns the index of an input, such as `push.force.x`.
    #[must_use]
    pub fn input(&self, name: &str) -> Option<usize> {
        self.inputs().index(name)
    }

    /// Returns the index of a parameter, such as `stiffness[7]`.
    #[must_use]
    pub fn parameter(&self, name: &str) -> Option<usize> {
        self.parameters().index(name)
    }

    /// Returns the index of a hinge, such as `joint[12]`.
    #[doc(alias("GetJointByName", "getJointId", "mj_name2id"))]
    #[must_use]
    pub fn hinge(&self, name: &str) -> Option<usize> {
        self.hinges().index(name)
    }

    /// Returns the index of a body, such as `rod[12]`.
    #[doc(alias("GetBodyByName", "getBodyId", "mj_name2id"))]
    #[must_use]
    pub fn body(&self, name: &str) -> Option<usize> {
        self.bodies().index(name)
    }

    /// Returns the index of a spring.
    #[must_use]
    pub fn spring(&self, name: &str) -> Option<usize> {
        self.springs().index(name)
    }

    /// Returns the index of a connection point, such as `rod[12].input`.
    #[doc(alias("GetFrameByName", "getFrameId", "mj_name2id"))]
    #[must_use]
    pub fn point(&self, name: &str) -> Option<usize> {
        self.points().index(name)
    }

    /// Returns the range of the coordinates of a hinge; empty if its motion is prescribed.
    #[must_use]
    pub fn coordinates_of(&self, hinge: usize) -> Option<core::ops::Range<usize>> {
        self.hinges.range(hinge, Hinge::coordinate_count)
    }

    /// Returns the range of the rates of a hinge; empty if its motion is prescribed.
    #[must_use]
    pub fn rates_of(&self, hinge: usize) -> Option<core::ops::Range<usize>> {
        self.hinges.range(hinge, Hinge::rate_count)
    }

    /// Returns the indices of the connection points at the input and the output of a hinge. `None` of the motion of a
    /// moving end, which is not between two points of the chain.
    #[must_use]
    pub fn points_of_hinge(&self, hinge: usize) -> Option<[usize; 2]> {
        let at = self.hinges.entry(hinge, |_| 1)?;
        at.row.points(at.repetition)
    }
}

impl Description {
    /// Returns row and repetition of a parameter.
    pub(crate) fn parameter_row(&self, index: usize) -> Option<(usize, usize)> {
        let at = self.parameters.entry(index, |_| 1)?;
        Some((at.number, at.repetition))
    }
}

/// The tables, for generated code.
#[doc(hidden)]
impl Description {
    /// Sets the hinges.
    #[must_use]
    pub const fn hinged(mut self, rows: &'static [Hinge]) -> Self {
        self.hinges = Table::new(rows);
        self
    }

    /// Sets the bodies.
    #[must_use]
    pub const fn bodied(mut self, rows: &'static [Body]) -> Self {
        self.bodies = Table::new(rows);
        self
    }

    /// Sets the springs.
    #[must_use]
    pub const fn sprung(mut self, rows: &'static [Spring]) -> Self {
        self.springs = Table::new(rows);
        self
    }

    /// Sets the connection points.
    #[must_use]
    pub const fn connected(mut self, rows: &'static [Place]) -> Self {
        self.points = Table::new(rows);
        self
    }

    /// Sets the inputs.
    #[must_use]
    pub const fn driven(mut self, rows: &'static [Input]) -> Self {
        self.inputs = Table::new(rows);
        self
    }

    /// Sets the parameters.
    #[must_use]
    pub const fn changed(mut self, rows: &'static [Parameter]) -> Self {
        self.parameters = Table::new(rows);
        self
    }

    /// Sets the answers.
    #[must_use]
    pub const fn answering(mut self, answers: &'static [&'static str]) -> Self {
        self.answers = answers;
        self
    }

    /// Repeats runs of rows, in the order of the functions above. Each run is a number of rows and that of their
    /// repetitions. All rows of a table without runs occur once.
    #[must_use]
    pub const fn repeated(mut self, runs: [&'static [[usize; 2]]; 6]) -> Self {
        let [hinges, bodies, springs, points, inputs, parameters] = runs;
        self.hinges = self.hinges.repeated(hinges);
        self.bodies = self.bodies.repeated(bodies);
        self.springs = self.springs.repeated(springs);
        self.points = self.points.repeated(points);
        self.inputs = self.inputs.repeated(inputs);
        self.parameters = self.parameters.repeated(parameters);
        self
    }
}
