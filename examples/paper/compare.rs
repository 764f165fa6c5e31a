//! Computes the motion of a system by generated code of both methods and by Newton–Euler, and compares
//! the motions.

use std::f64::consts::TAU;
use std::ops::Range;

use mstmm::Error;
use mstmm::description::{Geometry, Shape};
use mstmm_look::Motion;
use serde::Serialize;

use crate::generated::{self, PaperChain};
use crate::newton_euler::NewtonEuler;
use crate::output::progress::Progress;
use crate::output::time_figure::Curve;
use crate::system::{KnownAcceleration, MARKS_PER_SECOND, RECORDS_PER_SECOND, Record, System};
use crate::verdict::{Bound, Check, Verdict};

/// The number of motions that [`compare`] computes.
pub const MOTIONS_PER_SYSTEM: usize = 3;

/// A unit cube, drawn with gaps.
const CUBE: Shape = Shape {
    geometry: Geometry::Box([0.86, 0.86, 0.86]),
    position: [0.5, 0.0, 0.0],
    orientation: [1.0, 0.0, 0.0, 0.0],
};

/// A system's motion by generated code and by Newton–Euler.
#[derive(Serialize)]
pub struct Comparison {
    pub system: System,
    pub integrator: &'static str,
    pub step_s: f64,
    /// The largest difference between `method = riccati` and Newton–Euler.
    pub difference_to_newton_euler: Difference,
    /// The largest difference between `method = riccati` and `method = transfer`.
    pub difference_between_methods: Difference,
    pub energy_drift: EnergyDrift,
    /// At time zero, in rad/s², in the order of [`System::start`].
    pub accelerations: Accelerations,
    /// The motion by generated code, `method = riccati`.
    pub method: Vec<Record>,
    pub newton_euler: Vec<Record>,
    #[serde(skip)]
    pub verdicts: Vec<Verdict>,
    /// The motion by `method = riccati` with all results, for a page.
    #[serde(skip)]
    pub motion: Motion,
}

/// A difference of two angles, modulo 2π.
#[derive(Serialize)]
pub struct Difference {
    pub size_rad: f64,
    pub angle: String,
    pub time_s: f64,
}

/// The energy drift, the largest |E(t) − E(0)|.
#[derive(Serialize)]
pub struct EnergyDrift {
    pub largest_j: f64,
    /// The scale of the drift. The energy itself may be zero.
    pub largest_kinetic_energy_j: f64,
}

/// The same accelerations by three methods.
#[derive(Serialize)]
pub struct Accelerations {
    pub riccati: Vec<f64>,
    pub transfer: Vec<f64>,
    pub newton_euler: Vec<f64>,
}

/// Computes one system by all three methods. The file `figure` shows the motion.
pub fn compare(
    system: System,
    figure: &'static str,
    riccati: &impl PaperChain,
    transfer: &impl PaperChain,
    newton_euler: &NewtonEuler,
    progress: &Progress,
) -> Result<Comparison, Error> {
    progress.begin(&format!("{}: generated code, riccati", system.label));
    let (method, mut motion) = generated::motion(riccati, progress)?;
    for body in &mut motion.mechanism_mut().bodies {
        body.shapes = vec![CUBE];
    }
    progress.begin(&format!("{}: generated code, transfer", system.label));
    let (by_transfer, _) = generated::motion(transfer, progress)?;
    progress.begin(&format!("{}: Newton–Euler", system.label));
    let independent = newton_euler.motion(progress);

    let records_per_mark = (RECORDS_PER_SECOND / MARKS_PER_SECOND) as usize;
    let at_marks = method.iter().step_by(records_per_mark);
    let difference_to_newton_euler = largest_difference(&system, at_marks, &independent);
    let difference_between_methods = largest_difference(&system, method.iter(), &by_transfer);
    let accelerations = Accelerations {
        riccati: riccati.accelerations(&riccati.initial_state())?,
        transfer: transfer.accelerations(&transfer.initial_state())?,
        newton_euler: newton_euler.start_accelerations(),
    };
    // "4.2 A" is system A of section 4.2.
    let letter =
        system.label.split_once(' ').map_or(String::new(), |(_, letter)| format!("{letter}: "));
    let verdict = |compared: &str, figure, checks| Verdict {
        compared: format!("{letter}{compared}"),
        figure,
        checks,
    };
    let verdicts = vec![
        verdict(
            "generated code – Newton–Euler, angles",
            Some(figure),
            vec![difference_to_newton_euler.check()],
        ),
        verdict(
            "method riccati – method transfer, angles",
            None,
            vec![difference_between_methods.check()],
        ),
        verdict("accelerations at t = 0 – closed form", None, accelerations.checks(&system.start)),
    ];
    Ok(Comparison {
        integrator: "classical Runge–Kutta of order 4",
        step_s: generated::STEP,
        difference_to_newton_euler,
        difference_between_methods,
        energy_drift: energy_drift(&method),
        accelerations,
        method,
        newton_euler: independent,
        verdicts,
        motion,
        system,
    })
}

impl Accelerations {
    /// Compares each method with the known accelerations.
    fn checks(&self, known: &[KnownAcceleration]) -> Vec<Check> {
        let Accelerations { riccati, transfer, newton_euler } = self;
        let methods =
            [("riccati", riccati), ("transfer", transfer), ("Newton–Euler", newton_euler)];
        let check = |(method, computed): (&str, &Vec<f64>)| {
            let pairs = computed.iter().zip(known);
            let check = |(computed, known): (&f64, &KnownAcceleration)| Check {
                what: format!("{method}, {}", known.name),
                size: (computed - known.value).abs(),
                unit: "rad/s²",
                bound: Bound::Tolerance,
            };
            pairs.map(check).collect::<Vec<_>>()
        };
        methods.into_iter().flat_map(check).collect()
    }
}

impl Comparison {
    /// The curves of some of the angles: generated code as the line, Newton–Euler as the marks.
    pub fn curves(&self, angles: Range<usize>) -> Vec<Curve> {
        let points = |records: &[Record], angle: usize| {
            records.iter().map(|record| (record.time_s, record.angles_rad[angle])).collect()
        };
        let curve = |angle: usize| Curve {
            label: self.system.angles[angle].symbol,
            line: points(&self.method, angle),
            marks: points(&self.newton_euler, angle),
        };
        angles.map(curve).collect()
    }
}

impl Difference {
    fn check(&self) -> Check {
        let &Difference { size_rad, ref angle, time_s } = self;
        Check {
            what: format!("{angle} at t = {time_s} s"),
            size: size_rad,
            unit: "rad",
            bound: Bound::Tolerance,
        }
    }
}

impl EnergyDrift {
    pub fn relative(&self) -> f64 {
        self.largest_j / self.largest_kinetic_energy_j
    }
}

/// The largest difference between two motions recorded at the same times.
fn largest_difference<'a>(
    system: &System,
    computed: impl Iterator<Item = &'a Record>,
    reference: &[Record],
) -> Difference {
    let mut largest = Difference { size_rad: 0.0, angle: String::new(), time_s: 0.0 };
    for (record, reference) in computed.zip(reference) {
        assert_eq!(record.time_s, reference.time_s, "motions are compared at the same times");
        let pairs = record.angles_rad.iter().zip(&reference.angles_rad);
        for (angle, (a, b)) in system.angles.iter().zip(pairs) {
            let size_rad = modulo_full_turns(a - b).abs();
            // In this order NaN is the largest of all.
            if size_rad.total_cmp(&largest.size_rad).is_ge() {
                largest = Difference { size_rad, angle: angle.name(), time_s: record.time_s };
            }
        }
    }
    largest
}

/// The angle between −π and π that differs from `angle` by a multiple of 2π.
fn modulo_full_turns(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

fn energy_drift(motion: &[Record]) -> EnergyDrift {
    let start = motion[0].energy();
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
    EnergyDrift {
        largest_j: largest(&mut motion.iter().map(|record| (record.energy() - start).abs())),
        largest_kinetic_energy_j: largest(&mut motion.iter().map(|record| record.kinetic_energy_j)),
    }
}
