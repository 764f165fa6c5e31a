//! The motion of a closed chain by generated code, compared with a reference solution.

use mstmm::prelude::*;
use mstmm::{Error, GeneratedChain};

use crate::output::drawing::Drawing;
use crate::output::progress::Progress;
use crate::output::result_table::{ResultTable, Row};
use crate::output::time_figure::{Curve, Panel, TimeFigure};
use crate::section::SectionResult;
use crate::system::{DURATION, MARKS_PER_SECOND, RECORDS_PER_SECOND};
use crate::verdict::{Bound, Check, Verdict};

pub const SECTION: &str = "Section 2.4, closed chains";
const METHOD: &str = "generated code";

/// The step of the integrator in s.
pub const STEP: f64 = 5e-5;

/// A closed chain at one time.
pub struct Record {
    /// In s.
    pub time: f64,
    /// Angles in rad or positions in m.
    pub coordinates: Vec<f64>,
    /// The internal force at the closing hinge in N, inertial axes [P, Eq. (3)].
    pub force: Vec<f64>,
}

/// A motion by generated code.
pub struct Generated {
    pub records: Vec<Record>,
    /// The largest |E(t) − E(0)| in J.
    pub energy_drift: f64,
    /// The largest distance between the end of the chain and the point that holds it, in m.
    pub gap: f64,
}

/// A closed chain by generated code and by the reference.
pub struct ClosedChainComparison {
    pub name: &'static str,
    /// The name of the reference solution.
    pub reference: &'static str,
    pub start: Start,
    pub motion: Motion,
    pub texts: Texts,
    pub drawing: Drawing,
}

/// Accelerations at the start, in the order of their names.
pub struct Start {
    pub title: &'static str,
    pub unit: &'static str,
    pub names: &'static [&'static str],
    pub generated: Vec<f64>,
    pub reference: Vec<f64>,
}

/// The same motion by generated code and by the reference.
pub struct Motion {
    pub title: &'static str,
    pub unit: &'static str,
    /// The coordinates in the table and in the figure. All coordinates are compared.
    pub shown: &'static [ShownCoordinate],
    pub generated: Generated,
    /// At the times of [`mark_times`].
    pub reference: Vec<Record>,
}

/// A coordinate by its index in [`Record::coordinates`].
pub struct ShownCoordinate {
    pub index: usize,
    pub name: &'static str,
}

/// The texts of the figure and of the tables.
pub struct Texts {
    pub file_name: &'static str,
    pub figure: &'static str,
    pub caption: &'static str,
    /// The label of the figure's axis for the coordinates.
    pub axis: &'static str,
    pub note: &'static str,
}

/// The start of the chain, with its loop closed.
pub fn assembled<C: GeneratedChain<Scalar = f64>>(chain: &C) -> Result<C::State, Error> {
    let mut state = chain.initial_state();
    chain.assemble(&mut state, &chain.no_inputs())?;
    Ok(state)
}

/// Integrates the motion with the classical method of order four. `record` returns the record of a state
/// and the distance in m by which the loop is open.
pub fn motion<C: GeneratedChain<Scalar = f64>>(
    chain: &C,
    start: &C::State,
    progress: &Progress,
    mut record: impl FnMut(f64, &C::State) -> Result<(Record, f64), Error>,
) -> Result<Generated, Error> {
    let mut state = start.clone();
    let energy = chain.energy(start).total();
    let mut rk4 = Rk4::new(STEP);
    let mut motion = Generated { records: Vec::new(), energy_drift: 0.0, gap: 0.0 };
    for time in times(RECORDS_PER_SECOND) {
        rk4.advance_to(chain, &mut state, time, |_time, _state| chain.no_inputs())?;
        let (record, gap) = record(time, &state)?;
        motion.records.push(record);
        let drift = (chain.energy(&state).total() - energy).abs();
        motion.gap = largest([motion.gap, gap].into_iter());
        motion.energy_drift = largest([motion.energy_drift, drift].into_iter());
        progress.reach(time);
    }
    Ok(motion)
}

/// The times in s at which the reference is recorded.
pub fn mark_times() -> Vec<f64> {
    times(MARKS_PER_SECOND).collect()
}

fn times(per_second: u32) -> impl Iterator<Item = f64> {
    (0..=DURATION * per_second).map(move |count| f64::from(count) / f64::from(per_second))
}

impl ClosedChainComparison {
    pub fn result(self) -> SectionResult {
        SectionResult {
            tables: vec![self.at_start(), self.in_motion()],
            figures: vec![self.figure()],
            drawings: vec![self.drawing],
            ..SectionResult::default()
        }
    }

    fn at_start(&self) -> ResultTable {
        let Start { title, unit, names, generated, reference } = &self.start;
        let row = |name: &str, values: &[f64]| Row { name: name.into(), values: values.to_vec() };
        ResultTable {
            section: SECTION,
            title,
            columns: names.iter().map(|name| (*name).into()).collect(),
            rows: vec![row(METHOD, generated), row(self.reference, reference)],
            note: "Generated code and the reference agree.",
            verdicts: vec![Verdict {
                compared: format!("{} – {}, start", self.name, self.reference),
                figure: None,
                checks: vec![self.check(
                    "largest difference of accelerations at the start",
                    apart(generated, reference),
                    unit,
                )],
            }],
        }
    }

    fn in_motion(&self) -> ResultTable {
        let Motion { title, shown, generated, reference, .. } = &self.motion;
        let rows = shown.iter().flat_map(|ShownCoordinate { index, name }| {
            let row = |method: &str, records: &[Record]| Row {
                name: format!("{name}, {method}"),
                values: whole_seconds(records).map(|record| record.coordinates[*index]).collect(),
            };
            [row(METHOD, &generated.records), row(self.reference, reference)]
        });
        ResultTable {
            section: SECTION,
            title,
            columns: whole_seconds(reference)
                .map(|record| format!("t = {} s", record.time))
                .collect(),
            rows: rows.collect(),
            note: self.texts.note,
            verdicts: self.motion_verdicts(),
        }
    }

    /// Compares the motions, and the energy and the loop with those at the start.
    fn motion_verdicts(&self) -> Vec<Verdict> {
        let Motion { unit, generated, .. } = &self.motion;
        let coordinates =
            largest(self.at_marks().map(|(a, b)| apart(&a.coordinates, &b.coordinates)));
        let force = largest(self.at_marks().map(|(a, b)| apart(&a.force, &b.force)));
        let largest_force = largest(generated.records.iter().map(|record| norm(&record.force)));
        let force = force / largest_force;
        vec![
            Verdict {
                compared: format!("{} – {}, motion", self.name, self.reference),
                figure: Some(self.texts.file_name),
                checks: vec![
                    self.check("largest difference of coordinates", coordinates, unit),
                    self.check(
                        "difference of the force at the closing hinge, of the largest",
                        force,
                        "",
                    ),
                ],
            },
            Verdict {
                compared: format!("{}: energy drift, loop gap", self.name),
                figure: None,
                checks: vec![
                    self.check("energy drift, largest |E(t) − E(0)|", generated.energy_drift, "J"),
                    self.check("how far the chain opens at most", generated.gap, "m"),
                ],
            },
        ]
    }

    fn check(&self, what: &str, size: f64, unit: &'static str) -> Check {
        let what = format!("{}: {what}", self.name);
        Check { what, size, unit, bound: Bound::Tolerance }
    }

    /// The records of generated code and of the reference at the same times.
    fn at_marks(&self) -> impl Iterator<Item = (&Record, &Record)> {
        let records_per_mark = (RECORDS_PER_SECOND / MARKS_PER_SECOND) as usize;
        self.motion.generated.records.iter().step_by(records_per_mark).zip(&self.motion.reference)
    }

    fn figure(&self) -> TimeFigure {
        let curve = |label: &'static str, value: &dyn Fn(&Record) -> f64| {
            let points = |records: &[Record]| {
                records.iter().map(|record| (record.time, value(record))).collect::<Vec<_>>()
            };
            Curve {
                label,
                line: points(&self.motion.generated.records),
                marks: points(&self.motion.reference),
            }
        };
        let Texts { file_name, figure, caption, axis, .. } = self.texts;
        let coordinates = self.motion.shown.iter();
        let coordinates =
            coordinates.map(|shown| curve(shown.name, &|record| record.coordinates[shown.index]));
        let force = curve("force", &|record| norm(&record.force));
        TimeFigure {
            file_name,
            title: figure,
            caption,
            reference: self.reference,
            end: f64::from(DURATION),
            panels: vec![
                Panel { axis, curves: coordinates.collect() },
                Panel { axis: "|q| in N", curves: vec![force] },
            ],
        }
    }
}

fn whole_seconds(records: &[Record]) -> impl Iterator<Item = &Record> {
    records.iter().filter(|record| record.time.fract() == 0.0)
}

/// The largest difference between two lists.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    largest(a.iter().zip(b).map(|(a, b)| (a - b).abs()))
}

/// The largest value. NaN is larger than all others.
fn largest(sizes: impl Iterator<Item = f64>) -> f64 {
    sizes.max_by(f64::total_cmp).unwrap_or(f64::NAN)
}

fn norm(vector: &[f64]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}
