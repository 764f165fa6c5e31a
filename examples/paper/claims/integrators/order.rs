//! Error against step, and against work.

use mstmm::Error;
use mstmm::prelude::*;
use mstmm_reference::{Element, HingeKind, State, simulate};

use super::methods::{self, Run};
use super::{Cubes, CubesState, DAMPING, END, SECTION, apart, reference};
use crate::newton_euler::three_cubes;
use crate::output::exhibit::{Exhibit, KnownDifference, Row};
use crate::output::log_plot::{LogFigure, Series, Way};
use crate::output::progress::Progress;
use crate::power_law;
use crate::section::Outcome;

/// There are 2^k steps for these k. The table shows every third number of steps.
const EXPONENTS: std::ops::RangeInclusive<u32> = 4..=16;
const SHOWN: usize = 3;
/// The tolerance of the reference in rad and rad/s.
const TOLERANCE: f64 = 1e-15;
/// Errors below this are not told from those of the reference.
const SMALLEST: f64 = 1e-13;
/// With larger ones nothing of the motion is left.
const LARGEST: f64 = 10.0;
/// An order is fitted to so many of the smallest errors that can be told.
const FITTED: usize = 4;
/// How far it may be from the expected one.
const MARGIN: f64 = 0.1;
/// Errors for which the work is told.
const WANTED: [f64; 4] = [1e-2, 1e-4, 1e-6, 1e-8];
/// Tolerances with which Dormand and Prince's method chooses its own steps, and its name then.
const TOLERANCES: [f64; 9] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11];
const OWN_STEPS: &str = "Dormand–Prince, own h";

/// What a method came to, from the coarsest step to the finest.
struct Tried {
    name: &'static str,
    /// The order that it promises.
    order: f64,
    runs: Vec<Run>,
}

pub fn outcome(progress: &Progress) -> Result<Outcome, Error> {
    let chain = Cubes::<f64>::new();
    progress.begin("integrators: reference");
    let exact = reference(&chain, TOLERANCE)?;
    let independent = apart_from_newton_euler(&chain, &exact);
    let mut tried = Vec::new();
    for method in methods::ALL {
        progress.begin(&format!("integrators: {}", method.name));
        let runs = EXPONENTS.map(|exponent| method.run(&chain, &exact, exponent)).collect();
        tried.push(Tried { name: method.name, order: method.order, runs });
    }
    let own = own_steps(&chain, &exact)?;
    Ok(Outcome {
        exhibits: vec![errors(&tried, independent), work(&tried, &own)],
        log_figures: vec![error_figure(&tried), work_figure(&tried, &own)],
        ..Outcome::default()
    })
}

/// Dormand and Prince's method as it is meant to be used.
fn own_steps(chain: &Cubes<f64>, exact: &CubesState<f64>) -> Result<Vec<Run>, Error> {
    let run = |tolerance: f64| {
        let (mut state, mut dopri5) = (chain.initial_state(), Dopri5::new(tolerance, tolerance));
        dopri5.advance_to(chain, &mut state, END, |_time, _state| chain.no_inputs())?;
        let done = dopri5.statistics();
        Ok(Run {
            step: END / done.accepted as f64,
            error: apart(&state, exact),
            evaluations: done.evaluations as f64,
        })
    };
    TOLERANCES.into_iter().map(run).collect()
}

/// How far the reference is from Newton's and Euler's equations, integrated with an order of twelve.
fn apart_from_newton_euler(chain: &Cubes<f64>, exact: &CubesState<f64>) -> f64 {
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
        let found = sample.state.q.iter().chain(&sample.state.v);
        let pairs = found.zip(exact.coordinates().iter().chain(exact.rates()));
        largest = pairs.map(|(a, b)| (a - b).abs()).max_by(f64::total_cmp).unwrap_or(f64::NAN);
    });
    largest
}

impl Tried {
    /// The exponent of the power law through the smallest errors.
    fn fitted(&self) -> f64 {
        let told: Vec<_> = points(&self.runs, |run| run.step);
        power_law::exponent(&told[told.len().saturating_sub(FITTED)..])
    }

    fn fault(&self) -> Option<String> {
        let Tried { name, order, .. } = self;
        let found = self.fitted();
        // Written so that NaN is a fault too.
        let close = (found - order).abs() <= MARGIN;
        (!close).then(|| format!("{name} has the order {found:.2} instead of {order}"))
    }
}

/// The errors that can be told, against something.
fn points(runs: &[Run], against: impl Fn(&Run) -> f64) -> Vec<(f64, f64)> {
    let told = runs.iter().filter(|run| run.error > SMALLEST && run.error < LARGEST);
    told.map(|run| (against(run), run.error)).collect()
}

fn errors(tried: &[Tried], independent: f64) -> Exhibit {
    let rows = tried.iter().map(|one| {
        let errors = one.runs.iter().step_by(SHOWN).map(|run| run.error);
        let values = errors.chain([one.fitted(), one.order]);
        Row { name: one.name.into(), values: values.collect() }
    });
    let columns = EXPONENTS.step_by(SHOWN).map(|exponent| format!("h = 2^-{exponent} s"));
    Exhibit {
        section: SECTION,
        title: "largest error of any coordinate or rate at t = 1 s in rad or rad/s",
        columns: columns.chain(["order".into(), "expected".into()]).collect(),
        rows: rows.collect(),
        says: vec![
            "Every method has its own order on the chain: accelerations are a function of the state, in",
            "which nothing is linearised or bound to one method. Orders are fitted to the four smallest",
            "errors above 1e-13. The reference is the first method with a tolerance of 1e-15.",
        ],
        differences: vec![KnownDifference {
            what: "the reference beside Newton–Euler".into(),
            size: independent,
            unit: "rad or rad/s",
        }],
        faults: tried.iter().filter_map(Tried::fault).collect(),
    }
}

fn work(tried: &[Tried], own: &[Run]) -> Exhibit {
    let row = |name: &str, runs: &[Run]| {
        let least = |wanted: &f64| {
            let enough = runs.iter().filter(|run| run.error <= *wanted);
            enough.map(|run| run.evaluations).min_by(f64::total_cmp).unwrap_or(f64::NAN)
        };
        Row { name: name.into(), values: WANTED.iter().map(least).collect() }
    };
    Exhibit {
        section: SECTION,
        title: "evaluations of all accelerations for one second with an error of at most",
        columns: WANTED.iter().map(|wanted| format!("{wanted:.0e}")).collect(),
        rows: [row(OWN_STEPS, own)]
            .into_iter()
            .chain(tried.iter().map(|one| row(one.name, &one.runs)))
            .collect(),
        says: vec![
            "The fewest of those tried; a dash: not reached with 65536 steps. For small errors a high order",
            "costs least.",
        ],
        differences: Vec::new(),
        faults: Vec::new(),
    }
}

fn error_figure(tried: &[Tried]) -> LogFigure {
    LogFigure {
        file_name: "integrators.svg",
        title: "Five integrators on the same chain: error at t = 1 s against step",
        says: "Three cubes on balls with springs, by generated code throughout. The slopes are the methods' \
               orders: 5, 4, 2, 1 and 1.",
        x: "step in s",
        y: "error in rad or rad/s",
        series: tried.iter().map(|one| series(one.name, &one.runs, |run| run.step)).collect(),
    }
}

fn work_figure(tried: &[Tried], own: &[Run]) -> LogFigure {
    let work = |run: &Run| run.evaluations;
    let tried = tried.iter().map(|one| series(one.name, &one.runs, work));
    LogFigure {
        file_name: "integrators_work.svg",
        title: "Five integrators on the same chain: error at t = 1 s against work",
        says: "The same errors against how often all accelerations were computed, and besides the method of \
               Dormand and Prince with steps of its own, for tolerances from 1e-3 to 1e-11.",
        x: "evaluations of all accelerations",
        y: "error in rad or rad/s",
        series: tried.chain([series(OWN_STEPS, own, work)]).collect(),
    }
}

fn series(label: &'static str, runs: &[Run], against: impl Fn(&Run) -> f64) -> Series {
    Series { label, way: Way::Method, points: points(runs, against) }
}
