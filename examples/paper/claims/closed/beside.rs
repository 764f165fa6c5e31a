//! A closed chain by generated code and by a rival, and what they come to beside each other.

use mstmm::prelude::*;
use mstmm::{Error, GeneratedChain};

use crate::output::exhibit::{Exhibit, KnownDifference, Row};
use crate::output::plot::{Curve, Figure, Panel};
use crate::output::progress::Progress;
use crate::section::Outcome;
use crate::system::{DURATION, MARKS_PER_SECOND, RECORDS_PER_SECOND};

pub const SECTION: &str = "Section 2.4, closed chains";
const METHOD: &str = "generated code";

/// The step of the integrator in s.
pub const STEP: f64 = 5e-5;

/// A closed chain at one time.
pub struct Record {
    pub time: f64,
    /// Angles in rad or positions in m.
    pub coordinates: Vec<f64>,
    /// The internal force at the closing hinge in N, inertial axes [P, Eq. (3)].
    pub force: Vec<f64>,
}

/// A motion by generated code.
pub struct Generated {
    pub records: Vec<Record>,
    /// How far the energy strays from what it was at the start, in J.
    pub energy_drift: f64,
    /// How far the end of the chain is from where it is held, in m.
    pub gap: f64,
}

/// Both ways beside each other.
pub struct Beside {
    /// How the differences begin.
    pub name: &'static str,
    pub rival: &'static str,
    pub start: Start,
    pub motion: Motion,
    pub words: Words,
}

/// Accelerations at the start, in the order of their names.
pub struct Start {
    pub title: &'static str,
    pub unit: &'static str,
    pub names: &'static [&'static str],
    pub generated: Vec<f64>,
    pub rival: Vec<f64>,
}

/// The same motion by both ways.
pub struct Motion {
    pub title: &'static str,
    pub unit: &'static str,
    /// What the table shows and the figure draws; all coordinates are compared.
    pub shown: &'static [Shown],
    pub generated: Generated,
    /// At marks.
    pub rival: Vec<Record>,
}

/// A coordinate by its place in [`Record::coordinates`].
pub struct Shown {
    pub place: usize,
    pub name: &'static str,
}

/// What stands in the figure and below the tables.
pub struct Words {
    pub file_name: &'static str,
    pub figure: &'static str,
    pub figure_says: &'static str,
    /// The label of the figure's axis for the coordinates.
    pub axis: &'static str,
    pub says: Vec<&'static str>,
}

/// The state in which a description starts, made to close.
pub fn assembled<C: GeneratedChain<Scalar = f64>>(chain: &C) -> Result<C::State, Error> {
    let mut state = chain.initial_state();
    chain.assemble(&mut state, &chain.no_inputs())?;
    Ok(state)
}

/// Moves a chain by the classical method of order four. `record` gives besides the record how far the
/// chain is open.
pub fn motion<C: GeneratedChain<Scalar = f64>>(
    chain: &C,
    start: &C::State,
    progress: &Progress,
    mut record: impl FnMut(f64, &C::State) -> Result<(Record, f64), Error>,
) -> Result<Generated, Error> {
    let mut state = start.clone();
    let energy = chain.energy(start).total();
    let mut rk4 = Rk4::new(STEP);
    let mut all = Generated { records: Vec::new(), energy_drift: 0.0, gap: 0.0 };
    for time in times(RECORDS_PER_SECOND) {
        rk4.advance_to(chain, &mut state, time, |_time, _state| chain.no_inputs())?;
        let (record, gap) = record(time, &state)?;
        all.records.push(record);
        let drift = (chain.energy(&state).total() - energy).abs();
        all.gap = largest([all.gap, gap].into_iter());
        all.energy_drift = largest([all.energy_drift, drift].into_iter());
        progress.reach(time);
    }
    Ok(all)
}

/// The times of marks in s.
pub fn mark_times() -> Vec<f64> {
    times(MARKS_PER_SECOND).collect()
}

fn times(per_second: u32) -> impl Iterator<Item = f64> {
    (0..=DURATION * per_second).map(move |count| f64::from(count) / f64::from(per_second))
}

impl Beside {
    pub fn outcome(self) -> Outcome {
        let exhibits = vec![self.at_start(), self.in_motion()];
        Outcome { exhibits, figures: vec![self.figure()], ..Outcome::default() }
    }

    fn at_start(&self) -> Exhibit {
        let Start { title, unit, names, generated, rival } = &self.start;
        let row = |name: &str, values: &[f64]| Row { name: name.into(), values: values.to_vec() };
        Exhibit {
            section: SECTION,
            title,
            columns: names.iter().map(|name| (*name).into()).collect(),
            rows: vec![row(METHOD, generated), row(self.rival, rival)],
            says: vec!["Both ways agree on how the closed chain begins to move."],
            differences: vec![self.difference(
                "largest difference of accelerations at the start",
                apart(generated, rival),
                unit,
            )],
            faults: Vec::new(),
        }
    }

    fn in_motion(&self) -> Exhibit {
        let Motion { title, shown, generated, rival, .. } = &self.motion;
        let rows = shown.iter().flat_map(|Shown { place, name }| {
            let row = |way: &str, records: &[Record]| Row {
                name: format!("{name}, {way}"),
                values: whole_seconds(records).map(|one| one.coordinates[*place]).collect(),
            };
            [row(METHOD, &generated.records), row(self.rival, rival)]
        });
        Exhibit {
            section: SECTION,
            title,
            columns: whole_seconds(rival).map(|one| format!("t = {} s", one.time)).collect(),
            rows: rows.collect(),
            says: self.words.says.clone(),
            differences: self.differences(),
            faults: Vec::new(),
        }
    }

    /// What must stay small over the whole motion.
    fn differences(&self) -> Vec<KnownDifference> {
        let Motion { unit, generated, .. } = &self.motion;
        let coordinates =
            largest(self.at_marks().map(|(a, b)| apart(&a.coordinates, &b.coordinates)));
        let force = largest(self.at_marks().map(|(a, b)| apart(&a.force, &b.force)));
        let force = force / largest(generated.records.iter().map(|one| norm(&one.force)));
        vec![
            self.difference("largest difference of coordinates", coordinates, unit),
            self.difference(
                "difference of the force at the closing hinge, of the largest",
                force,
                "",
            ),
            self.difference("energy drift, largest |E(t) − E(0)|", generated.energy_drift, "J"),
            self.difference("how far the chain opens at most", generated.gap, "m"),
        ]
    }

    fn difference(&self, what: &str, size: f64, unit: &'static str) -> KnownDifference {
        KnownDifference { what: format!("{}: {what}", self.name), size, unit }
    }

    /// Generated code and the rival at the same times.
    fn at_marks(&self) -> impl Iterator<Item = (&Record, &Record)> {
        let records_per_mark = (RECORDS_PER_SECOND / MARKS_PER_SECOND) as usize;
        self.motion.generated.records.iter().step_by(records_per_mark).zip(&self.motion.rival)
    }

    fn figure(&self) -> Figure {
        let curve = |label: &'static str, value: &dyn Fn(&Record) -> f64| {
            let points = |records: &[Record]| {
                records.iter().map(|record| (record.time, value(record))).collect::<Vec<_>>()
            };
            Curve {
                label,
                line: points(&self.motion.generated.records),
                marks: points(&self.motion.rival),
            }
        };
        let Words { file_name, figure, figure_says, axis, .. } = self.words;
        let coordinates = self.motion.shown.iter();
        let coordinates =
            coordinates.map(|one| curve(one.name, &|record| record.coordinates[one.place]));
        let force = curve("force", &|record| norm(&record.force));
        Figure {
            file_name,
            title: figure,
            says: figure_says,
            rival: self.rival,
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

/// The largest difference of two lists.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    largest(a.iter().zip(b).map(|(a, b)| (a - b).abs()))
}

/// In this order NaN is the largest of all.
fn largest(sizes: impl Iterator<Item = f64>) -> f64 {
    sizes.max_by(f64::total_cmp).unwrap_or(f64::NAN)
}

fn norm(vector: &[f64]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}
