//! Homogeneity of forward dynamics [Euler]: if all masses, inertias, stiffnesses, damping constants, friction, loads and
//! efforts of motors are multiplied by one factor, the accelerations stay. So the derivatives of the accelerations along these
//! parameters and inputs, each multiplied by its value, have the sum zero.

use crate::differences::Direction;
use crate::products::push;
use crate::samples::{Kind, Sample, changed_samples, largest, times};
use mstmm_codegen::compile::outputs;
use mstmm_codegen::ids::{IdVec, ParameterId};
use mstmm_codegen::model::{
    Answer, Chain, Drive, Effort, InputKind, Layout, Parameter, Passive, Source, Symbol, Value,
};
use mstmm_codegen::program::Argument;
use proc_macro2::{Ident, Span};

/// The tolerance relative to the terms of the sum. A solution loses as many digits as the condition number of the mass
/// matrix has, at most four here.
const TOLERANCE: f64 = 1e-11;

/// Returns the same chain with a parameter for every number that has the unit of a mass, in its numerator once, except zeros.
fn weighed(mut chain: Chain) -> Chain {
    let mut scale = Scale { parameters: std::mem::take(&mut chain.parameters) };
    for body in &mut chain.bodies {
        scale.value(&mut body.mass);
        scale.all(&mut body.inertia.tensor);
    }
    for hinge in chain.hinges.iter_mut() {
        if let Drive::Efforts(efforts) = &mut hinge.drive {
            efforts.iter_mut().for_each(|effort| scale.effort(effort));
        }
        hinge.passive.iter_mut().for_each(|passive| scale.passive(passive));
    }
    for load in chain.loads.iter_mut() {
        for source in [&mut load.force, &mut load.torque] {
            if let Source::Constant(values) = source {
                scale.all(values);
            }
        }
    }
    for spring in &mut chain.springs {
        scale.value(&mut spring.stiffness);
        scale.value(&mut spring.damping);
        scale.effort(&mut spring.force);
    }
    Chain { parameters: scale.parameters, ..chain }
}

struct Scale {
    parameters: IdVec<ParameterId, Parameter>,
}

impl Scale {
    fn value(&mut self, value: &mut Value) {
        if value.is_zero() {
            return;
        }
        let id = ParameterId(self.parameters.len());
        let name = Ident::new(&format!("scaled{}", id.0), Span::call_site());
        let default = std::mem::replace(value, Value::Symbol(Symbol::Parameter(id)));
        self.parameters.push(Parameter { name, default, unit: String::new(), repetitions: None });
    }

    fn all(&mut self, values: &mut [Value]) {
        values.iter_mut().for_each(|value| self.value(value));
    }

    fn effort(&mut self, effort: &mut Effort) {
        if let Effort::Constant(value) = effort {
            self.value(value);
        }
    }

    fn passive(&mut self, passive: &mut Passive) {
        self.value(&mut passive.stiffness);
        self.value(&mut passive.damping);
        self.value(&mut passive.armature);
        if let Some(friction) = &mut passive.friction {
            self.value(&mut friction.effort);
        }
        if let Some(limits) = &mut passive.limits {
            self.value(&mut limits.stiffness);
            self.value(&mut limits.damping);
        }
    }
}

/// Returns the direction along the parameters, and the one along the inputs that are forces.
fn directions(sample: &Sample) -> [Direction; 2] {
    let (layout, given) = (Layout::of(&sample.chain), sample.given::<f64>());
    let parameters = crate::common::numbers::<f64>(&sample.chain).parameters;
    let parameters = parameters.iter().map(|value| value.value()).collect();
    let inputs = sample.joined_inputs(|id| {
        let values = &given.arrays.arguments[&Argument::Input(id)];
        match layout.inputs[id].what {
            InputKind::Gravity | InputKind::Motion(_) => vec![0.0; values.len()],
            InputKind::Efforts(_)
            | InputKind::Force(_)
            | InputKind::Torque(_)
            | InputKind::SpringForce(_) => values.clone(),
        }
    });
    let none = sample.no_direction();
    [Direction { parameters, ..none.clone() }, Direction { inputs, ..none }]
}

/// Checks the products with the direction, and returns the largest change along the inputs only.
fn by_products(sample: &Sample) -> f64 {
    let (given, [parameters, inputs]) = (sample.given::<f64>(), directions(sample));
    let both = Direction { inputs: inputs.inputs.clone(), ..parameters.clone() };
    let [accelerations, of_parameters] = push(sample, &given, &parameters);
    let [[_, of_inputs], [_, of_both]] = [&inputs, &both].map(|it| push(sample, &given, it));
    let scale = largest(&accelerations).max(largest(&of_inputs));
    let sum: Vec<f64> = of_parameters.iter().zip(&of_inputs).map(|(a, b)| a + b).collect();
    let none = vec![0.0; sample.rates()];
    sample.check("J (π, u)", (&of_both, &none), scale, TOLERANCE);
    sample.check("J π + J u", (&sum, &none), scale, TOLERANCE);
    of_inputs.iter().fold(0.0, |most, change| most.max(change.abs()))
}

/// Checks the columns of the linearisation.
fn by_columns(sample: &Sample) {
    let results = sample.all(&sample.given::<f64>(), Answer::Linearization, &[]);
    let count = sample.rates().max(1);
    let matrix =
        |id| -> Vec<Vec<f64>> { results.result(id).chunks(count).map(<[f64]>::to_vec).collect() };
    // The matrix is symmetric: its columns are its rows.
    let inverse = matrix(outputs::INVERSE_MASS_MATRIX);
    let layout = Layout::of(&sample.chain);
    let is_motor = |entry: usize| {
        let mut inputs = layout.inputs.iter();
        let input = inputs.find(|input| input.range.contains(&entry)).expect("an input");
        matches!(input.what, InputKind::Efforts(_))
    };
    let [parameters, inputs] = directions(sample);
    let (mut sum, mut sizes) = (vec![0.0; sample.rates()], vec![1.0; sample.rates()]);
    let mut add = |column: &[f64], value: f64| {
        for ((sum, size), entry) in sum.iter_mut().zip(&mut sizes).zip(column) {
            *sum += value * entry;
            *size += (value * entry).abs();
        }
    };
    // Columns of motors are derivatives of the accelerations; the others are derivatives of the efforts of inverse dynamics.
    for (entry, column) in matrix(outputs::BY_INPUTS).iter().enumerate() {
        match is_motor(entry) {
            true => add(column, inputs.inputs[entry]),
            false => add(&times(&inverse, column), -inputs.inputs[entry]),
        }
    }
    for (column, value) in matrix(outputs::BY_PARAMETERS).iter().zip(&parameters.parameters) {
        add(&times(&inverse, column), -value);
    }
    let none = vec![0.0; sample.rates()];
    sample.check("∂v̇/∂π π + ∂v̇/∂u u", (&sum, &none), largest(&sizes), TOLERANCE);
}

#[test]
fn a_common_factor_of_masses_and_forces_does_not_accelerate() {
    let mut moved = 0;
    for (kind, seeds) in [(Kind::OpenRoute, 0..12), (Kind::OpenTree, 1000..1006)] {
        for sample in changed_samples(kind, seeds, "[push, linearize]", weighed) {
            moved += usize::from(by_products(&sample) > 1e-3);
            by_columns(&sample);
        }
    }
    for sample in changed_samples(Kind::Described, 2000..2006, "push", weighed) {
        moved += usize::from(by_products(&sample) > 1e-3);
    }
    assert!(moved > 10, "forces accelerate {moved} chains");
}
