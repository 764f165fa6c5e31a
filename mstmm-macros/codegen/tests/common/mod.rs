//! Runs the compiler's equations on numbers.
#![allow(dead_code)]

pub mod cords;
pub mod double_double;
pub mod drives;
pub mod folded;
pub mod formulas;
pub mod functions;
pub mod given;
pub mod interpreter;
pub mod lifted;
pub mod paper;
pub mod paper_tree;
pub mod points;
pub mod scalars;
pub mod slots;
pub mod twins;

use mstmm_codegen::equations::{
    self, Axes, Energy, EvalContext, ForwardDynamics, SymbolValues, Trace,
};
use mstmm_codegen::math::{Mat3, Motion, Scalar, Structured, Vec3};
use mstmm_codegen::model::{Chain, Layout, SolutionMethod};

/// The results of the equations for a chain in a state.
pub struct Computed<S> {
    pub accelerations: Vec<S>,
    pub report: Report<Structured<S>>,
    pub energy: Energy<Structured<S>>,
    pub solved: ForwardDynamics<Structured<S>>,
}

/// The report in inertial axes.
pub struct Report<S> {
    pub points: Vec<Point<S>>,
    pub efforts: Vec<S>,
}

/// A connection point in inertial axes.
#[derive(Clone, Copy)]
pub struct Point<S> {
    pub position: Vec3<S>,
    pub rotation: Mat3<S>,
    pub velocity: Vec3<S>,
    pub omega: Vec3<S>,
    pub acceleration: Motion<S>,
    pub moment: Vec3<S>,
    pub force: Vec3<S>,
}

impl<S: Scalar> Report<S> {
    fn of(report: &equations::Report<S>) -> Self {
        let point = |point: &equations::PointState<S>| Point {
            position: point.position,
            rotation: point.rotation,
            velocity: point.velocity.inertial(),
            omega: point.omega.inertial(),
            acceleration: Motion {
                linear: point.proper_acceleration.inertial() - report.base_acceleration,
                angular: point.angular_acceleration.inertial(),
            },
            moment: point.moment.inertial(),
            force: point.force.inertial(),
        };
        let points = report.points.iter().map(point).collect();
        Report { points, efforts: report.efforts.clone() }
    }
}

/// Returns the only chain in a text, which must be valid.
pub fn read(text: &str) -> Chain {
    let tokens = text.parse().unwrap_or_else(|error| panic!("{error}\n{text}"));
    let chains = mstmm_codegen::read(tokens).unwrap_or_else(|error| panic!("{error}\n{text}"));
    chains.into_iter().next().expect("a chain").0
}

/// Returns numbers as scalars whose values the equations do not know.
pub fn variables<S: Scalar>(values: &[f64]) -> Vec<Structured<S>> {
    values.iter().map(|&value| Structured::variable(S::number(value))).collect()
}

/// Returns the parameters at their defaults.
pub fn numbers<S: Scalar>(chain: &Chain) -> SymbolValues<Structured<S>> {
    let none = SymbolValues::<S>::default();
    let default = |value| Structured::variable(none.scalar(value));
    let defaults = chain.parameters.iter().map(|parameter| default(&parameter.default));
    SymbolValues { parameters: defaults.collect(), ..SymbolValues::default() }
}

/// Runs the equations on `S` with the parameters at their defaults; `efforts` are those of all rates.
pub fn compute<S: Scalar>(
    chain: &Chain,
    way: (SolutionMethod, Axes),
    q: &[f64],
    v: &[f64],
    efforts: &[f64],
) -> Computed<S> {
    compute_with(chain, way, (q, v, &drives::of_motors(chain, efforts)))
}

/// Runs the equations on `S` with the parameters at their defaults.
pub fn compute_with<S: Scalar>(
    chain: &Chain,
    (method, axes): (SolutionMethod, Axes),
    (q, v, inputs): (&[f64], &[f64], &[f64]),
) -> Computed<S> {
    let (layout, merged) = (Layout::of(chain), Layout::merged(chain));
    let numbers = numbers(chain);
    let (q, v, inputs) = (variables::<S>(q), variables(v), variables(inputs));
    let mut trace = Trace::new();
    let context = EvalContext::new(chain, &merged, &numbers, (&q, &v, &inputs));
    let fast = equations::forward_dynamics(&context, method, axes, &mut trace);
    let (solved, swept) =
        equations::forward_dynamics_with_wrenches(&context, method, axes, &mut trace);
    let context = EvalContext::new(chain, &layout, &numbers, (&q, &v, &inputs));
    let report = Report::of(&equations::report(&context, (&solved, &swept), &mut trace));
    let energy = equations::energy(&context, &mut trace);
    let accelerations = fast.accelerations.iter().map(|x| x.value()).collect();
    Computed { accelerations, report, energy, solved }
}

/// Returns every method in all axes.
pub const WAYS: [(SolutionMethod, Axes); 4] = [
    (SolutionMethod::Riccati, Axes::Body),
    (SolutionMethod::Riccati, Axes::Inertial),
    (SolutionMethod::Transfer, Axes::Body),
    (SolutionMethod::Transfer, Axes::Inertial),
];

/// Returns the largest difference of two lists, relative to the largest entry of the second.
pub fn difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let scale = b.iter().fold(1.0_f64, |largest, x| largest.max(x.abs()));
    // `f64::max` ignores NaN.
    a.iter()
        .zip(b)
        .map(|(x, y)| (x - y).abs() / scale)
        .fold(0.0, |worst, d| if d.is_nan() || d > worst { d } else { worst })
}
