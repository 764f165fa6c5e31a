//! The functions of a chain in C that depend on its description.

use mstmm_codegen::emit::Tables;
use mstmm_codegen::model::{Answer, Request};

/// The requests whose functions are in C.
pub const HAVE: [Request; 4] =
    [Request::InverseDynamics, Request::BiasEfforts, Request::MassMatrix, Request::Linearize];

/// A function from a state, inputs and possibly a vector to a vector or a matrix.
#[derive(Clone, Copy, Debug)]
pub struct Function {
    /// Its name, in Rust and after the prefix in C.
    pub name: &'static str,
    /// The name and the documentation of a given vector, with an entry for each rate.
    pub given: Option<(&'static str, &'static str)>,
    /// The name of the result.
    pub result: &'static str,
    /// Whether the result is a matrix with a row and a column for each rate; otherwise a vector.
    pub is_matrix: bool,
    /// Whether it may be singular.
    pub may_be_singular: bool,
    /// What it computes, for the header.
    pub docs: &'static str,
}

const ALL: [(Answer, Function); 9] = [
    (
        Answer::Accelerations,
        Function {
            name: "accelerations",
            given: None,
            result: "accelerations",
            is_matrix: false,
            may_be_singular: true,
            docs: "Computes the time derivatives of the rates (forward dynamics), in the order of `v`.",
        },
    ),
    (
        Answer::BiasEfforts,
        Function {
            name: "bias_efforts",
            given: None,
            result: "efforts",
            is_matrix: false,
            may_be_singular: false,
            docs: "Computes the efforts that keep all rates constant, in the order of `v`.",
        },
    ),
    (
        Answer::InverseDynamics,
        Function {
            name: "inverse_dynamics",
            given: Some(("accelerations", "the time derivatives of the rates")),
            result: "efforts",
            is_matrix: false,
            may_be_singular: false,
            docs: "Computes the efforts in addition to those of motors that cause these accelerations, in the order of `v`.",
        },
    ),
    (
        Answer::GravityEfforts,
        Function {
            name: "gravity_efforts",
            given: None,
            result: "efforts",
            is_matrix: false,
            may_be_singular: false,
            docs: "Computes the efforts that balance gravity at rest, in the order of `v`.",
        },
    ),
    (
        Answer::PassiveEfforts,
        Function {
            name: "passive_efforts",
            given: None,
            result: "efforts",
            is_matrix: false,
            may_be_singular: false,
            docs: "Computes the efforts of springs, dampers, friction and limits in hinges, in the order of `v`.",
        },
    ),
    (
        Answer::MassMatrixTimes,
        Function {
            name: "mass_matrix_times",
            given: Some(("vector", "any vector")),
            result: "product",
            is_matrix: false,
            may_be_singular: false,
            docs: "Computes the product of the mass matrix with a vector in the order of `v`.",
        },
    ),
    (
        Answer::InverseMassMatrixTimes,
        Function {
            name: "inverse_mass_matrix_times",
            given: Some(("vector", "any vector")),
            result: "product",
            is_matrix: false,
            may_be_singular: true,
            docs: "Computes the product of the inverse of the mass matrix with a vector in the order of `v`.",
        },
    ),
    (
        Answer::MassMatrix,
        Function {
            name: "mass_matrix",
            given: None,
            result: "matrix",
            is_matrix: true,
            may_be_singular: false,
            docs: "Computes the mass matrix, with a row and a column for each entry of `v`.",
        },
    ),
    (
        Answer::InverseMassMatrix,
        Function {
            name: "inverse_mass_matrix",
            given: None,
            result: "matrix",
            is_matrix: true,
            may_be_singular: true,
            docs: "Computes the inverse of the mass matrix, with a row and a column for each entry of `v`.",
        },
    ),
];

/// Returns the functions of a chain.
pub fn of(tables: &Tables) -> Vec<Function> {
    let has_rates = tables.rates.length > 0;
    let found = ALL.iter().filter(|(answer, _)| has_rates && tables.answers.contains(answer));
    found.map(|(_, function)| *function).collect()
}

/// Returns whether a chain has the linearised equations of motion.
pub fn linearizes(tables: &Tables) -> bool {
    tables.rates.length > 0 && tables.answers.contains(&Answer::Linearization)
}

/// Returns whether a chain is closed.
pub fn is_closed(tables: &Tables) -> bool {
    tables.answers.contains(&Answer::Correction)
}
