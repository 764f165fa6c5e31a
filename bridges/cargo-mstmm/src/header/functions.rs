//! The functions of a chain in C that depend on its description.

mod catalogue;
mod makers;

use mstmm_codegen::emit::Tables;
use mstmm_codegen::model::{Answer, Chain, Dimension, Request};
use std::borrow::Cow;

/// A function of a state and inputs.
#[derive(Clone, Debug)]
pub struct Function {
    /// Its name after the prefix in C.
    pub name: Cow<'static, str>,
    /// What it computes, for the header.
    pub docs: Cow<'static, str>,
    /// Whether it may be singular.
    pub may_be_singular: bool,
    /// Whether it needs a state and inputs.
    pub of_state: bool,
    /// What it is given in addition.
    pub given: Vec<Argument>,
    /// Its results.
    pub results: Vec<Argument>,
    /// The statements in Rust that make `computed`, a `Result`, from `chain`, `state`, `inputs` and what is given. The values
    /// of the results are evaluated where `found` is its value.
    pub compute: String,
}

/// An argument or a result.
#[derive(Clone, Debug)]
pub struct Argument {
    /// Its name.
    pub name: &'static str,
    /// Its documentation, after "is"; empty if the size says everything.
    pub docs: &'static str,
    /// Its shape.
    pub shape: Shape,
    /// The value of a result in Rust.
    pub value: String,
}

/// The shape of an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A vector.
    Vector(Size),
    /// A matrix with rows and columns.
    Matrix(Size, Size),
    /// The index of a frame on a body.
    Frame,
    /// A struct by its name after the prefix in C, and in Rust.
    Struct(&'static str, &'static str),
}

/// The number of entries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Size {
    /// One for each rate.
    Rates,
    /// Two for each rate.
    TwiceRates,
    /// One for each scalar of the inputs.
    Inputs,
    /// One for each dynamic parameter.
    DynamicParameters,
    /// One for each component of a velocity and an angular velocity.
    Components,
    /// One for each component of a position.
    Place,
}

impl Size {
    /// Returns the number.
    pub fn of(self, tables: &Tables, dimension: Dimension) -> usize {
        match self {
            Size::Rates => tables.rates.length,
            Size::TwiceRates => 2 * tables.rates.length,
            Size::Inputs => tables.inputs.length,
            Size::DynamicParameters => tables.dynamic_parameters.length,
            Size::Components => match dimension {
                Dimension::Space => 6,
                Dimension::Plane => 3,
                Dimension::Line => 1,
            },
            Size::Place => match dimension {
                Dimension::Space => 3,
                Dimension::Plane => 2,
                Dimension::Line => 1,
            },
        }
    }

    /// Returns the number in C.
    pub fn in_c(self, upper: &str, dimension: Dimension) -> String {
        match self {
            Size::Rates => format!("{upper}_RATES"),
            Size::TwiceRates => format!("2 {upper}_RATES"),
            Size::Inputs => format!("{upper}_INPUTS"),
            Size::DynamicParameters => format!("{upper}_DYNAMIC_PARAMETERS"),
            Size::Components => match dimension {
                Dimension::Space => "6".into(),
                Dimension::Plane => "3".into(),
                Dimension::Line => "1".into(),
            },
            Size::Place => match dimension {
                Dimension::Space => "3".into(),
                Dimension::Plane => "2".into(),
                Dimension::Line => "1".into(),
            },
        }
    }
}

/// What a library has of a chain.
#[derive(Debug)]
pub struct Functions {
    /// The functions that depend on the description.
    pub all: Vec<Function>,
    /// What the chain has in Rust and not in C, by name.
    pub missing: Vec<String>,
}

impl Functions {
    /// Returns the functions of a chain.
    pub fn of(chain: &Chain, tables: &Tables) -> Self {
        let has = Has { chain, tables };
        let is_there = |(function, is_there): (Function, bool)| is_there.then_some(function);
        let all = catalogue::all(&has).into_iter().filter_map(is_there).collect();
        Functions { all, missing: has.missing() }
    }

    /// Returns whether a function has an argument or a result of this shape.
    pub fn use_shape(&self, shape: Shape) -> bool {
        let mut arguments = self.all.iter().flat_map(|it| it.given.iter().chain(&it.results));
        arguments.any(|argument| argument.shape == shape)
    }

    /// Returns whether a function has a size.
    pub fn use_dynamic_parameters(&self) -> bool {
        self.use_shape(Shape::Vector(Size::DynamicParameters))
    }
}

/// The small change of a state, inputs and parameters, or a gradient.
pub const VARIATION: Shape = Shape::Struct("variation", "Variation");
/// The motion of a frame.
pub const MOTION: Shape = Shape::Struct("motion", "Motion");
/// Mass, centre of mass and momentum.
pub const MOMENTUM: Shape = Shape::Struct("momentum_result", "Momentum");
/// All results.
pub const RESULTS: Shape = Shape::Struct("results", "Results");

/// What a chain has.
struct Has<'a> {
    chain: &'a Chain,
    tables: &'a Tables,
}

impl Has<'_> {
    fn asks(&self, request: Request) -> bool {
        self.chain.requests.contains(&request)
    }

    fn computes(&self, answer: Answer) -> bool {
        self.tables.answers.contains(&answer)
    }

    /// Returns what has no function in C.
    fn missing(&self) -> Vec<String> {
        let mut names = Vec::new();
        if self.tables.rates.length == 0 && !self.chain.requests.is_empty() {
            names.push("functions with an entry for each rate, because the chain has no rates");
        }
        if self.asks(Request::Kinematics) || self.asks(Request::Jacobian) {
            names.push("`at` of kinematics, for points without a name");
        }
        if self.asks(Request::Jacobian) {
            names.extend(["jacobian_times", "jacobian_transpose_times"]);
            if self.asks(Request::MassMatrix) {
                names.extend(["operational_space_inertia", "inverse_operational_space_inertia"]);
            }
            if is_closed(self.tables) {
                names.push("closure_jacobian");
            }
        }
        if self.asks(Request::Regressor) {
            names.push("BASE_PARAMETERS");
        }
        if self.asks(Request::Linearize) {
            names.push("the derivatives of `linearize` with respect to parameters");
        }
        names.into_iter().map(str::to_owned).collect()
    }
}

/// Returns whether a chain is closed.
pub fn is_closed(tables: &Tables) -> bool {
    tables.answers.contains(&Answer::Correction)
}
