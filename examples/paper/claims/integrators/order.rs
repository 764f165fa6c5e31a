//! The error of the integrators against the step, and against the number of evaluations.

use mstmm::Error;
use mstmm::prelude::*;
use mstmm_reference::{Element, HingeKind, State, simulate};

use super::methods::{self, Run};
use super::{Cubes, CubesState, DAMPING, END, SECTION, difference, reference};
use crate::newton_euler::three_cubes;
use crate::output::log_figure::{LogFigure, Series, SeriesStyle};
use crate::output::progress::Progress;
use crate::output::result_table::{ResultTable, Row};
use crate::power_law;
use crate::section::SectionResult;
use crate::verdict::{Bound, Check, Verdict};

/// There are 2^k steps for these k. The table shows every third number of steps.
const EXPONENTS: std::ops::RangeInclusive<u32> = 4..=16;
const SHOWN: usize = 3;
/// The tolerance of the reference in rad and rad/s.
const TOLERANCE: f64 = 1e-15;
/// Errors below this are not distinguishable from those of the reference.
const SMALLEST: f64 = 1e-13;
/// Results with larger errors have nothing in common with the motion.
const LARGEST: f64 = 10.0;
/// The order is fitted to this number of the smallest distinguishable errors.
const FITTED: usize = 4;
/// The largest accepted difference between the fitted and the expected order.
const MARGIN: f64 = 0.1;
/// The errors for which the number of evaluations is given.
const WANTED: [f64; 4] = [1e-2, 1e-4, 1e-6, 1e-8];
/// Tolerances for the Dormand–Prince integrator with step-size control, and its name then.
const TOLERANCES: [f64; 9] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11];
const ERRORS_FIGURE: &str = "integrators.svg";
const WORK_FIGURE: &str = "integrators_work.svg";
const CONTROLLED: &str = "Dormand–Prince, own h";

/// The results of an integrator, from the largest step to the smallest.
struct Convergence {
    name: &'static str,
    /// The expected order.
    order: f64,
    runs: Vec<Run>,
}

pub fn run(progress: &Progress) -> Result<SectionResult, Error> {
    let chain = Cubes::<f64>::new();
    progress.begin("integrators: reference");
    let exact = reference(&chain, TOLERANCE)?;
    let to_newton_euler = difference_to_newton_euler(&chain, &exact);
    let mut convergences = Vec::new();
    for method in methods::ALL {
        progress.begin(&format!("integrators: {}", method.name));
        let runs = EXPONENTS.map(|exponent| method.run(&chain, &exact, exponent)).collect();
        convergences.push(Convergence { name: method.name, order: method.order, runs });
    }
    let controlled = controlled_steps(&chain, &exact)?;
    Ok(SectionResult {
        tables: vec![errors(&convergences, to_newton_euler), work(&convergences, &controlled)],
        log_figures: vec![error_figure(&convergences), work_figure(&convergences, &controlled)],
        ..SectionResult::default()
    })
}

/// The Dormand–Prince integrator with step-size control.
fn controlled_steps(chain: &Cubes<f64>, exact: &CubesState<f64>) -> Result<Vec<Run>, Error> {
    let run = |tolerance: f64| {
        let (mut state, mut dopri5) = (chain.initial_state(), Dopri5::new(tolerance, tolerance));
        dopri5.advance_to(chain, &mut state, END, |_time, _state| chain.no_inputs())?;
        let statistics = dopri5.statistics();
        Ok(Run {
            step: END / statistics.accepted as f64,
            error: difference(&state, exact),
            evaluations: statistics.evaluations as f64,
        })
    };
    TOLERANCES.into_iter().map(run).collect()
}

/// The largest difference between the reference and the Newton–Euler equations, integrated with an order
/// of twelve.
fn difference_to_newton_euler(chain: &Cubes<f64>, exact: &CubesState<f64>) -> f64 {
    let mut cubes = three_cubes([HingeKind::Ball, HingeKind::Ball, HingeKind::Ball]);
    let hinges = cubes.elements.iter_mut().filter_map(|element| match element {
        Element::Hinge(hinge) if hinge.name != "shoulder" => Some(hinge),
        _ => None,
    });
    for hinge in hinges {
        hinge.turning.stiffness = vec![chain.parameters().stiffness()];
        hinge.turning.damping = vec![DAMPING];
    }
    let start = chain.initial_state();
    let start = State { q: start.coordinates().to_vec(), v: start.rates().to_vec() };
    let mut largest = f64::NAN;
    simulate(&cubes, &start, &vec![0.0; cubes.dof_count()], &[END], |sample| {
        let state = sample.state.q.iter().chain(&sample.state.v);
        let pairs = state.zip(exact.coordinates().iter().chain(exact.rates()));
        largest = pairs.map(|(a, b)| (a - b).abs()).max_by(f64::total_cmp).unwrap_or(f64::NAN);
    });
    largest
}

impl Convergence {
    /// The exponent of the power law through the smallest errors.
    fn fitted(&self) -> f64 {
        let points = points(&self.runs, |run| run.step);
        power_law::exponent(&points[points.len().saturating_sub(FITTED)..])
    }

    /// Compares the fitted order with the expected one.
    fn check(&self) -> Check {
        let Convergence { name, order, .. } = self;
        let fitted = self.fitted();
        Check {
            what: format!("{name}, fitted order {fitted:.2}, expected {order}"),
            size: (fitted - order).abs(),
            unit: "",
            bound: Bound::Fixed(MARGIN),
        }
    }
}

/// The distinguishable errors against a property of the runs.
fn points(runs: &[Run], against: impl Fn(&Run) -> f64) -> Vec<(f64, f64)> {
    let runs = runs.iter().filter(|run| run.error > SMALLEST && run.error < LARGEST);
    runs.map(|run| (against(run), run.error)).collect()
}

fn errors(convergences: &[Convergence], to_newton_euler: f64) -> ResultTable {
    let rows = convergences.iter().map(|convergence| {
        let errors = convergence.runs.iter().step_by(SHOWN).map(|run| run.error);
        let values = errors.chain([convergence.fitted(), convergence.order]);
        Row { name: convergence.name.into(), values: values.collect() }
    });
    let columns = EXPONENTS.step_by(SHOWN).map(|exponent| format!("h = 2^-{exponent} s"));
    ResultTable {
        section: SECTION,
        title: "largest error of any coordinate or rate at t = 1 s in rad or rad/s",
        columns: columns.chain(["order".into(), "expected".into()]).collect(),
        rows: rows.collect(),
        note: "Every integrator has its order of convergence on the chain: the accelerations are a function of \
               the state, and nothing is linearised or adapted to one integrator. The orders are fitted to the \
               four smallest errors above 1e-13. The reference is the Dormand–Prince integrator with a \
               tolerance of 1e-15.",
        verdicts: vec![
            Verdict {
                compared: "order of convergence – theory, five integrators".into(),
                figure: Some(ERRORS_FIGURE),
                checks: convergences.iter().map(Convergence::check).collect(),
            },
            Verdict {
                compared: "reference – Newton–Euler, state at t = 1 s".into(),
                figure: None,
                checks: vec![Check {
                    what: "the reference beside Newton–Euler".into(),
                    size: to_newton_euler,
                    unit: "rad or rad/s",
                    bound: Bound::Tolerance,
                }],
            },
        ],
    }
}

fn work(convergences: &[Convergence], controlled: &[Run]) -> ResultTable {
    let row = |name: &str, runs: &[Run]| {
        let least = |wanted: &f64| {
            let enough = runs.iter().filter(|run| run.error <= *wanted);
            enough.map(|run| run.evaluations).min_by(f64::total_cmp).unwrap_or(f64::NAN)
        };
        Row { name: name.into(), values: WANTED.iter().map(least).collect() }
    };
    ResultTable {
        section: SECTION,
        title: "evaluations of all accelerations for one second with an error of at most",
        columns: WANTED.iter().map(|wanted| format!("{wanted:.0e}")).collect(),
        rows: [row(CONTROLLED, controlled)]
            .into_iter()
            .chain(convergences.iter().map(|convergence| row(convergence.name, &convergence.runs)))
            .collect(),
        note: "The smallest number of evaluations among the steps of the previous table. A dash: not reached with \
               65536 steps. Small errors cost least with a high order.",
        verdicts: Vec::new(),
    }
}

fn error_figure(convergences: &[Convergence]) -> LogFigure {
    let series = |convergence: &Convergence| {
        error_series(convergence.name, &convergence.runs, |run| run.step)
    };
    LogFigure {
        file_name: ERRORS_FIGURE,
        title: "Five integrators on the same chain: error at t = 1 s against step",
        caption: "Three cubes on balls with springs, by generated code. The slopes are the orders of the \
                  integrators: 5, 4, 2, 1 and 1.",
        x: "step in s",
        y: "error in rad or rad/s",
        series: convergences.iter().map(series).collect(),
    }
}

fn work_figure(convergences: &[Convergence], controlled: &[Run]) -> LogFigure {
    let work = |run: &Run| run.evaluations;
    let series =
        |convergence: &Convergence| error_series(convergence.name, &convergence.runs, work);
    LogFigure {
        file_name: WORK_FIGURE,
        title: "Five integrators on the same chain: error at t = 1 s against work",
        caption: "The same errors against the number of evaluations of all accelerations. “Dormand–Prince, own h” \
                  is the integrator with step-size control, for tolerances from 1e-3 to 1e-11.",
        x: "evaluations of all accelerations",
        y: "error in rad or rad/s",
        series: convergences
            .iter()
            .map(series)
            .chain([error_series(CONTROLLED, controlled, work)])
            .collect(),
    }
}

fn error_series(label: &'static str, runs: &[Run], against: impl Fn(&Run) -> f64) -> Series {
    Series { label, style: SeriesStyle::Line, points: points(runs, against) }
}
