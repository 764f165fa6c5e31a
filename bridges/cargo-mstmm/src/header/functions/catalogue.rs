//! All functions that a chain can have in C.

use super::makers::{
    accelerations, found, function, matrix, of_matrix, rates, singular, structure, to_rates,
};
use super::{Argument, Function, Has, MOMENTUM, MOTION, RESULTS, Shape, Size, VARIATION};
use crate::header::names::Constants;
use mstmm_codegen::model::{Answer, Request};

/// Returns the functions, each with whether the chain has it.
pub fn all(has: &Has) -> Vec<(Function, bool)> {
    let mut all =
        [dynamics(has), mass_matrix(has), coriolis_matrix(has), derivatives(has), regressor(has)]
            .concat();
    if has.tables.rates.length == 0 {
        all.clear();
    }
    all.extend(momentum(has));
    all.extend(motion(has));
    all.extend(end_bodies(has));
    all
}

fn dynamics(has: &Has) -> Vec<(Function, bool)> {
    vec![
        (
            singular(to_rates(
                "accelerations",
                "Computes the time derivatives of the rates (forward dynamics), in the order of `v`.",
                None,
                "accelerations",
            )),
            true,
        ),
        (
            to_rates(
                "bias_efforts",
                "Computes the efforts that keep all rates constant, in the order of `v`.",
                None,
                "efforts",
            ),
            has.computes(Answer::BiasEfforts),
        ),
        (
            to_rates(
                "inverse_dynamics",
                "Computes the efforts in addition to those of motors that cause these accelerations, in the order of `v`.",
                Some(accelerations()),
                "efforts",
            ),
            has.computes(Answer::InverseDynamics),
        ),
        (
            function(
                "inverse_solve",
                "Computes the results for given accelerations, also the wrench in each hinge.",
                (vec![accelerations()], vec![structure("results", "", RESULTS)]),
                "let mut results = chain.workspace();\n    \
                 let computed =\n        \
                     chain.inverse_solve_into(&state, &(*accelerations).into(), &inputs, &mut results);",
            ),
            has.computes(Answer::InverseSolution),
        ),
        (
            to_rates(
                "gravity_efforts",
                "Computes the efforts that balance gravity at rest, in the order of `v`.",
                None,
                "efforts",
            ),
            has.computes(Answer::GravityEfforts),
        ),
        (
            to_rates(
                "passive_efforts",
                "Computes the efforts of springs, dampers, friction and limits in hinges, in the order of `v`.",
                None,
                "efforts",
            ),
            has.computes(Answer::PassiveEfforts),
        ),
    ]
}

fn mass_matrix(has: &Has) -> Vec<(Function, bool)> {
    let asked = has.asks(Request::MassMatrix);
    let vector = || Some(rates("vector", "any vector"));
    vec![
        (
            to_rates(
                "mass_matrix_times",
                "Computes the product of the mass matrix with a vector in the order of `v`.",
                vector(),
                "product",
            ),
            asked && has.computes(Answer::MassMatrixTimes),
        ),
        (
            singular(to_rates(
                "inverse_mass_matrix_times",
                "Computes the product of the inverse of the mass matrix with a vector in the order of `v`.",
                vector(),
                "product",
            )),
            asked && has.computes(Answer::InverseMassMatrixTimes),
        ),
        (
            of_matrix(
                "mass_matrix",
                "Computes the mass matrix, with a row and a column for each entry of `v`.",
            ),
            asked,
        ),
        (
            singular(of_matrix(
                "inverse_mass_matrix",
                "Computes the inverse of the mass matrix, with a row and a column for each entry of `v`.",
            )),
            asked
                && (has.computes(Answer::InverseMassMatrix)
                    || has.computes(Answer::InverseMassMatrixTimes)),
        ),
    ]
}

fn coriolis_matrix(has: &Has) -> Vec<(Function, bool)> {
    let asked = has.asks(Request::CoriolisMatrix);
    vec![
        (
            to_rates(
                "coriolis_matrix_times",
                "Computes the product of the Coriolis matrix with a vector in the order of `v`.",
                Some(rates("vector", "any vector")),
                "product",
            ),
            asked,
        ),
        (
            of_matrix(
                "coriolis_matrix",
                "Computes the Coriolis matrix, with a row and a column for each entry of `v`.",
            ),
            asked,
        ),
    ]
}

fn derivatives(has: &Has) -> Vec<(Function, bool)> {
    let part = |name, docs, value| matrix(name, docs, [Size::Rates, Size::Rates], value);
    let both = [Size::TwiceRates, Size::TwiceRates];
    let mut linear = vec![matrix("a", "", both, "linear.a()")];
    if has.tables.inputs.length > 0 {
        linear.push(matrix("b", "", [Size::TwiceRates, Size::Inputs], "linear.b()"));
    }
    vec![
        (
            function(
                "inverse_dynamics_derivatives",
                "Computes the derivatives of inverse dynamics at given accelerations.",
                (
                    vec![accelerations()],
                    vec![
                        part("by_coordinates", "along the rates", "derivatives.by_coordinates"),
                        part("by_rates", "", "derivatives.by_rates"),
                        part("by_accelerations", "the mass matrix", "derivatives.by_accelerations"),
                    ],
                ),
                "let mut derivatives = Default::default();\n    \
                 let accelerations = (*accelerations).into();\n    \
                 let computed = chain.inverse_dynamics_derivatives_into(\n        \
                     &state,\n        &accelerations,\n        &inputs,\n        &mut derivatives,\n    );",
            ),
            has.asks(Request::Derivatives),
        ),
        (
            singular(function(
                "linearize",
                "Computes the linearised equations of motion dx/dt = a x + b u. x are small changes of the coordinates,\n \
                 * along the rates, and of the rates.",
                (vec![], linear),
                "let mut linear = Default::default();\n    \
                 let computed = chain.linearize_into(&state, &inputs, &mut linear);",
            )),
            has.asks(Request::Linearize),
        ),
        (
            singular(function(
                "push",
                "Computes the accelerations and their derivative along a direction, in O(n) operations.",
                (
                    vec![structure("direction", "the direction", VARIATION)],
                    vec![rates("accelerations", ""), rates("change", "the derivative")],
                ),
                "let (mut accelerations, mut change) = (SVector::zeros(), SVector::zeros());\n    \
                 let direction = (*direction).into();\n    \
                 let computed =\n        \
                     chain.push_into(&state, &inputs, &direction, &mut accelerations, &mut change);",
            )),
            has.asks(Request::Push),
        ),
        (
            singular(function(
                "pull",
                "Computes the accelerations and the gradient of their sum with weights, in O(n) operations.",
                (
                    vec![rates("weights", "the weights of the accelerations")],
                    vec![
                        rates("accelerations", ""),
                        structure("gradient", "the gradient", VARIATION),
                    ],
                ),
                "let (mut accelerations, mut gradient) = (SVector::zeros(), Default::default());\n    \
                 let weights = (*weights).into();\n    \
                 let computed =\n        \
                     chain.pull_into(&state, &inputs, &weights, &mut accelerations, &mut gradient);",
            )),
            has.asks(Request::Pull),
        ),
    ]
}

fn regressor(has: &Has) -> Vec<(Function, bool)> {
    let is_asked = has.asks(Request::Regressor) && has.tables.dynamic_parameters.length > 0;
    let parameters = |docs| Argument {
        name: "parameters",
        docs,
        shape: Shape::Vector(Size::DynamicParameters),
        value: "parameters.into()".into(),
    };
    let columns = [Size::Rates, Size::DynamicParameters];
    let own = Function {
        of_state: false,
        ..function(
            "dynamic_parameters",
            "Returns the dynamic parameters with the parameters as they are set, in the order of the columns of the\n * regressor.",
            (vec![], vec![parameters("")]),
            "let parameters = chain.dynamic_parameters();\n    let computed = Ok(());",
        )
    };
    vec![
        (
            function(
                "regressor",
                "Computes the regressor: its product with the dynamic parameters are the efforts of inverse dynamics, less\n \
                 * those of loads, springs between bodies and limits.",
                (vec![accelerations()], vec![matrix("matrix", "", columns, "matrix")]),
                "let mut matrix = SMatrix::zeros();\n    \
                 let computed =\n        \
                     chain.regressor_into(&state, &(*accelerations).into(), &inputs, &mut matrix);",
            ),
            is_asked,
        ),
        (
            function(
                "regressor_times",
                "Computes the product of the regressor with values of the dynamic parameters, in O(n) operations.",
                (
                    vec![accelerations(), parameters("values of the dynamic parameters")],
                    vec![rates("product", "")],
                ),
                "let mut product = SVector::zeros();\n    \
                 let (accelerations, parameters) = ((*accelerations).into(), (*parameters).into());\n    \
                 let computed = chain.regressor_times_into(\n        \
                     &state,\n        &accelerations,\n        &inputs,\n        &parameters,\n        &mut product,\n    );",
            ),
            is_asked,
        ),
        (own, is_asked),
    ]
}

fn momentum(has: &Has) -> Vec<(Function, bool)> {
    let asked = has.asks(Request::Momentum);
    let size = [Size::Components, Size::Rates];
    vec![
        (
            function(
                "momentum",
                "Computes mass, centre of mass and momentum of all bodies.",
                (vec![], vec![found("momentum", MOMENTUM)]),
                "let computed = chain.momentum(&state, &inputs);",
            ),
            asked,
        ),
        (
            function(
                "momentum_matrix",
                "Computes the matrix that maps the rates to the momentum: rows of linear momentum, then rows of angular\n \
                 * momentum about the centre of mass.",
                (vec![], vec![matrix("matrix", "", size, "matrix")]),
                "let mut matrix = SMatrix::zeros();\n    \
                 let computed = chain.momentum_matrix_into(&state, &inputs, &mut matrix);",
            ),
            asked && has.tables.rates.length > 0,
        ),
    ]
}

fn motion(has: &Has) -> Vec<(Function, bool)> {
    let frame = || Argument {
        name: "frame",
        docs: "the index of a frame on a body",
        shape: Shape::Frame,
        value: String::new(),
    };
    let at = "let Some(frame) = frame_at(frame) else { return Status::INDEX };\n    ";
    let moved = "let Some(computed) = moved else { return Status::INDEX };";
    let size = [Size::Components, Size::Rates];
    let [rows, columns] = size.map(|size| size.of(has.tables, has.chain.dimension));
    let there = has.computes(Answer::Kinematics);
    vec![
        (
            function(
                "kinematics",
                "Computes the motion of a frame on a body, without dynamics.",
                (vec![frame()], vec![found("motion", MOTION)]),
                &format!(
                    "{at}let moved = chain.motion_(&state, &inputs, frame, &mut []);\n    {moved}"
                ),
            ),
            there,
        ),
        (
            function(
                "jacobian",
                "Computes the Jacobian of a frame on a body, with a column for each entry of `v`: rows of velocity, then rows\n \
                 * of angular velocity. Its product with the rates is the velocity without prescribed motions.",
                (
                    vec![frame()],
                    vec![matrix(
                        "jacobian",
                        "",
                        size,
                        &format!("SMatrix::<Real, {rows}, {columns}>::from(jacobian)"),
                    )],
                ),
                &format!(
                    "{at}let mut jacobian = [[0.0; {rows}]; {columns}];\n    \
                     let moved = chain.motion_(&state, &inputs, frame, jacobian.as_flattened_mut());\n    {moved}"
                ),
            ),
            there && has.asks(Request::Jacobian) && has.tables.rates.length > 0,
        ),
    ]
}

/// Returns the Jacobians of bodies at free ends.
fn end_bodies(has: &Has) -> Vec<(Function, bool)> {
    let mut names = Constants::default();
    let of_body = |[body, path]: &[String; 2]| {
        let name = names.name("", body).trim_start_matches('_').to_lowercase();
        let place = Argument {
            name: "place",
            docs: "the position of the point in m, in the frame of the body",
            shape: Shape::Vector(Size::Place),
            value: String::new(),
        };
        let function = function(
            format!("{name}_jacobian"),
            format!(
                "Computes the Jacobian of a point of `{path}` without the kinematics of other bodies.\n \
                 * It has the rows and columns of the Jacobian of a frame, at a fraction of the cost. Bodies at free ends have it."
            ),
            (
                vec![place],
                vec![matrix("jacobian", "", [Size::Components, Size::Rates], "jacobian")],
            ),
            &format!(
                "let mut jacobian = SMatrix::zeros();\n    \
                 let computed =\n        \
                     chain.{body}_jacobian_into(&state, &inputs, &(*place).into(), &mut jacobian);"
            ),
        );
        (function, has.tables.rates.length > 0)
    };
    has.tables.end_bodies.iter().map(of_body).collect()
}
