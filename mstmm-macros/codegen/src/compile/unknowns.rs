//! Names the unknowns of a chain and assigns them to arguments.

use super::layouts;
use crate::equations::writes_matrices_out;
use crate::function::Unknowns;
use crate::model::{Chain, ClosureRank, Hinge, HingeSpec, Input, InputKind, Layout, Request};
use crate::program::{Argument, ArrayLayout, Given};
use proc_macro2::Ident;
use std::collections::HashSet;

const AXES: [&str; 3] = ["x", "y", "z"];

/// Returns the unknowns of a chain: parameters, constants, the elimination steps of a loop closure of this rank,
/// coordinates, rates, inputs, the length of an implicit step, and the vectors that its requested functions are given.
pub(super) fn unknowns(chain: &Chain, layout: &Layout, rank: ClosureRank) -> Unknowns {
    let free = || chain.hinges.iter().filter(|hinge| !hinge.is_prescribed());
    let coordinates = free().flat_map(|hinge| named(hinge, coordinates(hinge.kind.spec())));
    let rates = free().flat_map(|hinge| named(hinge, hinge.kind.spec().rates.to_vec()));
    let mut unknowns = Unknowns::new(chain.repeats.iter().map(|repeat| repeat.count).collect());
    let mut taken = HashSet::new();
    let mut add = |argument, layout: ArrayLayout, names: Vec<String>| {
        let names = names.into_iter().map(|name| distinct(name, &mut taken));
        unknowns.add(argument, layout, names.collect());
    };
    for (id, parameter) in chain.parameters.enumerate() {
        let layout = layouts::parameter(chain, id);
        add(Argument::Parameter(id), layout, vec![text(&parameter.name)]);
    }
    let once = |argument, names: Vec<String>| (argument, ArrayLayout::once(names.len()), names);
    let numbered = |name: &str, count: usize| -> Vec<String> {
        (0..count).map(|number| format!("{name}{number}")).collect()
    };
    let steps = match rank {
        ClosureRank::FoundAtRunTime(directions) => directions,
        ClosureRank::Unknown | ClosureRank::Known { .. } => 0,
    };
    let inputs = layout.inputs.enumerate().map(|(index, input)| {
        let names = input_names(chain, input);
        (Argument::Input(index), layouts::input(chain, input), names)
    });
    let all = [
        once(Argument::Constants, numbered("constant", chain.constants)),
        once(Argument::ClosureSteps, numbered("closure_step", steps)),
        (Argument::Coordinates, layouts::coordinates(chain, layout), coordinates.collect()),
        (Argument::Rates, layouts::rates(chain, layout), rates.collect()),
    ];
    let step = once(Argument::Step, vec!["step".to_owned()]);
    for (argument, layout, names) in all.into_iter().chain(inputs).chain([step]) {
        add(argument, layout, names);
    }
    for given in given(chain, layout) {
        let (layout, name) = match given {
            Given::Accelerations => (layouts::rates(chain, layout), "acceleration"),
            Given::Vector => (layouts::rates(chain, layout), "vector"),
            Given::DynamicParameters => (layouts::dynamic_parameters(chain), "dynamic_parameter"),
            Given::Place => (layouts::place(chain), "place"),
            Given::VirtualRates => (layouts::rates(chain, layout), "virtual_rate"),
            Given::CoordinateDirection => (layouts::rates(chain, layout), "coordinate_direction"),
            Given::RateDirection => (layouts::rates(chain, layout), "rate_direction"),
            Given::InputDirection => (layouts::inputs(chain, layout), "input_direction"),
            Given::ParameterDirection => (layouts::parameters(chain), "parameter_direction"),
        };
        let names = numbered(name, layout.entries());
        add(Argument::Given(given), layout, names);
    }
    mark_quaternions(chain, layout, &mut unknowns);
    unknowns
}

/// Marks the quaternions of coordinates and prescribed motions.
fn mark_quaternions(chain: &Chain, layout: &Layout, unknowns: &mut Unknowns) {
    for (index, hinge) in chain.hinges.enumerate().filter(|(_, hinge)| !hinge.is_prescribed()) {
        if let Some(entries) = hinge.kind.spec().quaternion() {
            let first = layout.q[index].start;
            let entries = first + entries.start..first + entries.end;
            unknowns.mark_quaternion(Argument::Coordinates, entries);
        }
    }
    for (index, input) in layout.inputs.enumerate() {
        if let InputKind::Motion(hinge) = input.what
            && let Some(entries) = chain.hinges[hinge].kind.spec().quaternion()
        {
            unknowns.mark_quaternion(Argument::Input(index), entries);
        }
    }
}

/// Returns the vectors that the functions of a chain's requests are given, each once.
fn given(chain: &Chain, layout: &Layout) -> Vec<Given> {
    const DIRECTION: [Given; 4] = [
        Given::CoordinateDirection,
        Given::RateDirection,
        Given::InputDirection,
        Given::ParameterDirection,
    ];
    let is_dense = writes_matrices_out(!chain.repeats.is_empty(), layout.dof_count());
    let of_request = |request: &Request| match request {
        Request::InverseDynamics => vec![Given::Accelerations],
        Request::Regressor => vec![Given::Accelerations, Given::DynamicParameters],
        Request::MassMatrix | Request::CoriolisMatrix => vec![Given::Vector],
        Request::Jacobian => vec![Given::Vector, Given::Place],
        Request::Pull => vec![
            Given::Vector,
            Given::Accelerations,
            Given::VirtualRates,
            Given::CoordinateDirection,
        ],
        Request::Push => DIRECTION.to_vec(),
        Request::Derivatives if is_dense => vec![Given::Accelerations],
        // Column by column, by products.
        Request::Derivatives => [&[Given::Accelerations, Given::Vector], &DIRECTION[..]].concat(),
        Request::Linearize if is_dense => Vec::new(),
        Request::Linearize => [&[Given::Vector], &DIRECTION[..]].concat(),
        Request::BiasEfforts | Request::Kinematics | Request::Momentum => Vec::new(),
    };
    let mut all: Vec<Given> = Vec::new();
    for given in chain.requests.iter().flat_map(of_request) {
        if !all.contains(&given) {
            all.push(given);
        }
    }
    all
}

fn coordinates(shape: &HingeSpec) -> Vec<&'static str> {
    shape.coordinates.iter().map(|coordinate| coordinate.name).collect()
}

fn named(hinge: &Hinge, suffixes: Vec<&str>) -> Vec<String> {
    let name = text(&hinge.name);
    suffixes.into_iter().map(|suffix| format!("{name}_{suffix}")).collect()
}

fn input_names(chain: &Chain, input: &Input) -> Vec<String> {
    let along = |name: &str, axes: &[usize]| -> Vec<String> {
        axes.iter().map(|&axis| format!("{name}_{}", AXES[axis])).collect()
    };
    match input.what {
        InputKind::Gravity => along("gravity", chain.dimension.translations()),
        InputKind::Force(load) => along(
            &format!("{}_force", text(&chain.loads[load].name)),
            chain.dimension.translations(),
        ),
        InputKind::Torque(load) => {
            along(&format!("{}_torque", text(&chain.loads[load].name)), chain.dimension.rotations())
        }
        InputKind::SpringForce(spring) => {
            vec![format!("{}_force", text(&chain.springs[spring].name))]
        }
        InputKind::Efforts(hinge) => {
            let name = text(&chain.hinges[hinge].name);
            (0..input.range.len()).map(|k| format!("{name}_input{k}")).collect()
        }
        InputKind::Motion(index) => {
            let hinge = &chain.hinges[index];
            let shape = hinge.kind.spec();
            let accelerations: Vec<String> =
                shape.rates.iter().map(|rate| format!("{rate}_dot")).collect();
            let mut names = named(hinge, coordinates(shape));
            names.extend(named(hinge, shape.rates.to_vec()));
            names.extend(named(hinge, accelerations.iter().map(String::as_str).collect()));
            names
        }
    }
}

/// Makes a name unique: a chain may have a parameter `elbow_angle` and a hinge `elbow`.
fn distinct(mut name: String, taken: &mut HashSet<String>) -> String {
    while !taken.insert(name.clone()) {
        name.push('_');
    }
    name
}

/// Returns an identifier in lower case, since rustc could take an upper-case variable for one of the user's constants.
///
/// Rust compares identifiers in Unicode normalization form C. Lower-casing may leave that form; parsing the identifier
/// restores it.
fn text(ident: &Ident) -> String {
    let lower = ident.to_string().to_lowercase();
    syn::parse_str::<Ident>(&lower).map_or(lower, |normal| normal.to_string())
}
