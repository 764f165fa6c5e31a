//! Runs the compiler's equations on plain numbers.
#![allow(dead_code)]

pub mod double_double;

use mstmm_codegen::equations::{self, Axes, Energy, Numbers, Report, Situation, Trace};
use mstmm_codegen::math::Scalar;
use mstmm_codegen::model::{Chain, Layout, Method};

/// All that the equations say of a chain in a state.
pub struct Computed<S> {
    pub accelerations: Vec<S>,
    pub report: Report<S>,
    pub energy: Energy<S>,
}

/// The only chain in `text`, which must be right.
pub fn read(text: &str) -> Chain {
    let tokens = text.parse().unwrap_or_else(|error| panic!("{error}\n{text}"));
    let chains = mstmm_codegen::read(tokens).unwrap_or_else(|error| panic!("{error}\n{text}"));
    chains.into_iter().next().expect("a chain").0
}

/// Runs the equations on `S` with the parameters at their defaults.
pub fn compute<S: Scalar>(
    chain: &Chain,
    (method, axes): (Method, Axes),
    q: &[f64],
    v: &[f64],
    efforts: &[f64],
) -> Computed<S> {
    let convert = |values: &[f64]| values.iter().map(|&value| S::number(value)).collect();
    let layout = Layout::of(chain);
    let none = Numbers::<S> { parameters: Vec::new(), constants: Vec::new() };
    let defaults = chain.parameters.iter().map(|parameter| none.scalar(&parameter.default));
    let numbers = Numbers { parameters: defaults.collect(), constants: Vec::new() };
    let inputs: Vec<f64> = chain
        .hinges
        .iter()
        .enumerate()
        .filter(|&(index, _)| !layout.inputs[index].is_empty())
        .flat_map(|(index, _)| efforts[layout.v[index].clone()].to_vec())
        .collect();
    let (q, v, inputs): (Vec<S>, Vec<S>, Vec<S>) = (convert(q), convert(v), convert(&inputs));
    let situation =
        Situation { chain, layout: &layout, numbers: &numbers, q: &q, v: &v, inputs: &inputs };
    let mut trace = Trace::new();
    let solved = equations::accelerations(&situation, method, axes, &mut trace);
    let report = equations::report(&situation, &solved.accelerations, &mut trace);
    let energy = equations::energy(&situation, &mut trace);
    Computed { accelerations: solved.accelerations, report, energy }
}

/// Every method in all axes.
pub const WAYS: [(Method, Axes); 4] = [
    (Method::Riccati, Axes::Body),
    (Method::Riccati, Axes::Inertial),
    (Method::Transfer, Axes::Body),
    (Method::Transfer, Axes::Inertial),
];

/// The largest difference of two lists, relative to the largest entry of the second.
pub fn difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let scale = b.iter().fold(1.0_f64, |largest, x| largest.max(x.abs()));
    // NaN must not get lost in a maximum.
    a.iter()
        .zip(b)
        .map(|(x, y)| (x - y).abs() / scale)
        .fold(0.0, |worst, d| if d.is_nan() || d > worst { d } else { worst })
}
