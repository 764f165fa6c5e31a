//! Runs a system by generated code of both methods and by Newton–Euler, and finds what differs.

use std::f64::consts::TAU;
use std::ops::Range;

use mstmm::Error;
use serde::Serialize;

use crate::generated::{self, PaperChain};
use crate::newton_euler::NewtonEuler;
use crate::output::plot::Curve;
use crate::output::progress::Progress;
use crate::system::{MARKS_PER_SECOND, RECORDS_PER_SECOND, Record, System};

/// How many motions [`compare`] computes.
pub const MOTIONS_PER_SYSTEM: usize = 3;

/// A system's motion by generated code and by Newton–Euler.
#[derive(Serialize)]
pub struct Comparison {
    pub system: System,
    pub integrator: &'static str,
    pub step_s: f64,
    /// Where the largest of all differences to Newton–Euler is.
    pub difference_to_newton_euler: Difference,
    /// The same between `method = riccati` and `method = transfer`.
    pub difference_between_methods: Difference,
    pub energy_drift: EnergyDrift,
    /// At time zero, in rad/s², in the order of [`System::start`].
    pub accelerations: Accelerations,
    /// The motion by generated code, `method = riccati`.
    pub method: Vec<Record>,
    pub newton_euler: Vec<Record>,
}

/// A difference of two angles, modulo a full turn.
#[derive(Serialize)]
pub struct Difference {
    pub size_rad: f64,
    pub angle: String,
    pub time_s: f64,
}

/// How far the energy strays from what it was at the start.
#[derive(Serialize)]
pub struct EnergyDrift {
    pub largest_j: f64,
    /// The drift's scale; the energy itself may be zero.
    pub largest_kinetic_energy_j: f64,
}

/// The same accelerations by different ways.
#[derive(Serialize)]
pub struct Accelerations {
    pub riccati: Vec<f64>,
    pub transfer: Vec<f64>,
    pub newton_euler: Vec<f64>,
}

/// Computes one system in all three ways.
pub fn compare(
    system: System,
    riccati: &impl PaperChain,
    transfer: &impl PaperChain,
    newton_euler: &NewtonEuler,
    progress: &Progress,
) -> Result<Comparison, Error> {
    progress.begin(&format!("{}: generated code, riccati", system.label));
    let method = generated::motion(riccati, progress)?;
    progress.begin(&format!("{}: generated code, transfer", system.label));
    let by_transfer = generated::motion(transfer, progress)?;
    progress.begin(&format!("{}: Newton–Euler", system.label));
    let independent = newton_euler.motion(progress);

    let records_per_mark = (RECORDS_PER_SECOND / MARKS_PER_SECOND) as usize;
    let at_marks = method.iter().step_by(records_per_mark);
    Ok(Comparison {
        integrator: "classical Runge–Kutta of order 4",
        step_s: generated::STEP,
        difference_to_newton_euler: largest_difference(&system, at_marks, &independent),
        difference_between_methods: largest_difference(&system, method.iter(), &by_transfer),
        energy_drift: energy_drift(&method),
        accelerations: Accelerations {
            riccati: riccati.accelerations(&riccati.initial_state())?,
            transfer: transfer.accelerations(&transfer.initial_state())?,
            newton_euler: newton_euler.start_accelerations(),
        },
        method,
        newton_euler: independent,
        system,
    })
}

impl Comparison {
    /// Says what differs by more than `tolerance`, in rad for angles and rad/s² for accelerations.
    pub fn complaints(&self, tolerance: f64) -> Vec<String> {
        let against_newton_euler =
            self.difference_to_newton_euler.complaint("riccati", "Newton–Euler", tolerance);
        let between_methods =
            self.difference_between_methods.complaint("riccati", "transfer", tolerance);
        let angles = [against_newton_euler, between_methods].into_iter().flatten();
        let accelerations = self.acceleration_complaints(tolerance);
        angles.chain(accelerations).map(|text| format!("{}: {text}", self.system.label)).collect()
    }

    fn acceleration_complaints(&self, tolerance: f64) -> Vec<String> {
        let Accelerations { riccati, transfer, newton_euler } = &self.accelerations;
        let ways = [("riccati", riccati), ("transfer", transfer), ("Newton–Euler", newton_euler)];
        let complaint = |way: &str, found: f64, name: &str, known: f64| {
            // Written so that NaN is a complaint too.
            let close = (found - known).abs() <= tolerance;
            (!close).then(|| {
                let difference = (found - known).abs();
                format!(
                    "the acceleration {name} by {way} is off by {difference:.1e} rad/s², more than \
                     {tolerance:.1e} rad/s²"
                )
            })
        };
        ways.iter()
            .flat_map(|(way, found)| {
                found.iter().zip(&self.system.start).map(move |one| (way, one))
            })
            .filter_map(|(way, (&found, known))| complaint(way, found, known.name, known.value))
            .collect()
    }

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
    fn complaint(&self, one: &str, other: &str, tolerance: f64) -> Option<String> {
        let Difference { size_rad, angle, time_s } = self;
        // Written so that NaN is a complaint too.
        let close = *size_rad <= tolerance;
        (!close).then(|| {
            format!(
                "{one} and {other} differ by {size_rad:.1e} rad in {angle} at t = {time_s} s, more \
                 than {tolerance:.1e} rad"
            )
        })
    }
}

impl EnergyDrift {
    pub fn relative(&self) -> f64 {
        self.largest_j / self.largest_kinetic_energy_j
    }
}

/// The largest difference of two motions recorded at the same times.
fn largest_difference<'a>(
    system: &System,
    one: impl Iterator<Item = &'a Record>,
    other: &[Record],
) -> Difference {
    let mut largest = Difference { size_rad: 0.0, angle: String::new(), time_s: 0.0 };
    for (one, other) in one.zip(other) {
        assert_eq!(one.time_s, other.time_s, "motions are compared at the same times");
        for (angle, (a, b)) in
            system.angles.iter().zip(one.angles_rad.iter().zip(&other.angles_rad))
        {
            let size_rad = modulo_full_turns(a - b).abs();
            // In this order NaN is the largest of all.
            if size_rad.total_cmp(&largest.size_rad).is_ge() {
                largest = Difference { size_rad, angle: angle.name(), time_s: one.time_s };
            }
        }
    }
    largest
}

/// The angle between −π and π that differs from `angle` by full turns.
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
