//! Reads the results of the function for kinematics with the types of the runtime.

use mstmm_codegen::compile::{RatePaths, layouts};
use mstmm_codegen::model::{BodyId, Chain, Dimension};
use mstmm_runtime::generated::RateRun;
use mstmm_runtime::nalgebra::{SVector, Vector2, Vector3};
use mstmm_runtime::{
    BodyKinematics, LineMotion, OptionalPoints, PlaneMotion, RateColumns, SpaceMotion,
};

/// More rates than any sample has; further rates move nothing.
const RATES: usize = 200;

/// What is multiplied with the Jacobians.
#[derive(Default)]
pub struct Asked {
    pub rates: Vec<f64>,
    pub accelerations: Vec<f64>,
    pub wrench: Vec<f64>,
}

/// A body in a repetition.
pub struct BodyAt {
    pub body: BodyId,
    pub repetition: usize,
    /// Its index among all bodies written out.
    pub index: usize,
}

/// Returns all bodies in the order of their stored motions.
pub fn bodies(chain: &Chain) -> Vec<BodyAt> {
    let all: Vec<BodyId> = chain.physical_bodies().collect();
    let mut found = Vec::new();
    for segment in &layouts::bodies(chain).segments {
        for repetition in 0..segment.repetitions {
            for &body in &all[segment.entries()] {
                let index = found.len();
                found.push(BodyAt { body, repetition, index });
            }
        }
    }
    found
}

/// The kinematics of a point.
#[derive(Clone, Debug)]
pub struct Seen {
    pub position: Vec<f64>,
    pub orientation: Vec<f64>,
    pub velocity: Vec<f64>,
    pub omega: Vec<f64>,
    pub acceleration: Vec<f64>,
    pub angular_acceleration: Vec<f64>,
    pub jacobian_times_rates: Vec<f64>,
    /// By rows.
    pub jacobian: Vec<Vec<f64>>,
    pub transpose_times_wrench: Vec<f64>,
}

impl Seen {
    /// Returns the quantities in the order of a connection point's.
    pub fn quantities(&self) -> [&[f64]; 6] {
        [
            &self.position,
            &self.orientation,
            &self.velocity,
            &self.omega,
            &self.acceleration,
            &self.angular_acceleration,
        ]
    }
}

fn padded(values: &[f64]) -> SVector<f64, RATES> {
    SVector::from_fn(|row, _| values.get(row).copied().unwrap_or(0.0))
}

type Written = OptionalPoints<true, true>;

/// Returns the kinematics of a point on a body; without a place, of its input.
pub fn see(
    dimension: Dimension,
    (motions, columns): (&[f64], &[f64]),
    (paths, run): (&RatePaths, usize),
    (at, place): (&BodyAt, Vec<f64>),
    asked: &Asked,
) -> Seen {
    let small = |numbers: [usize; 3]| numbers.map(|number| u32::try_from(number).expect("small"));
    let rows = paths.rows().into_iter();
    let runs: Vec<RateRun> =
        rows.map(|(rates, next)| RateRun::new(small(rates), small(next))).collect();
    let [run, repetition, _] = small([run, at.repetition, 0]);
    let columns = RateColumns::new(columns, runs.leak(), run, repetition);
    let count = layouts::motion_count(dimension);
    let motion = &motions[count * at.index..][..count];
    match dimension {
        Dimension::Space => space(motion, columns, &place, asked),
        Dimension::Plane => plane(motion, columns, &place, asked),
        Dimension::Line => line(motion, columns, &place, asked),
    }
}

fn space(motion: &[f64], columns: RateColumns<f64>, place: &[f64], asked: &Asked) -> Seen {
    let motion = SpaceMotion::new(motion.try_into().expect("24 values"));
    let body = BodyKinematics::<_, RATES, _, Written>::new(
        motion,
        Default::default(),
        Default::default(),
        columns,
    );
    let point = match place {
        [] => body.input(),
        _ => body.at(place.try_into().expect("three entries")),
    };
    let (rates, accelerations) = (padded(&asked.rates), padded(&asked.accelerations));
    let wrench = |first: usize| {
        Vector3::from_fn(|row, _| asked.wrench.get(first + row).copied().unwrap_or(0.0))
    };
    let jacobian = point.jacobian();
    Seen {
        position: point.position().as_slice().to_vec(),
        orientation: point.orientation().matrix().as_slice().to_vec(),
        velocity: point.velocity().as_slice().to_vec(),
        omega: point.angular_velocity().as_slice().to_vec(),
        acceleration: point.acceleration(&accelerations).as_slice().to_vec(),
        angular_acceleration: point.angular_acceleration(&accelerations).as_slice().to_vec(),
        jacobian_times_rates: point.jacobian_times(&rates).as_slice().to_vec(),
        jacobian: jacobian.row_iter().map(|row| row.iter().copied().collect()).collect(),
        transpose_times_wrench: point
            .jacobian_transpose_times(wrench(0), wrench(3))
            .as_slice()
            .to_vec(),
    }
}

fn plane(motion: &[f64], columns: RateColumns<f64>, place: &[f64], asked: &Asked) -> Seen {
    let motion = PlaneMotion::new(motion.try_into().expect("ten values"));
    let body = BodyKinematics::<_, RATES, _, Written>::new(
        motion,
        Default::default(),
        Default::default(),
        columns,
    );
    let point = match place {
        [] => body.input(),
        _ => body.at(place.try_into().expect("two entries")),
    };
    let (rates, accelerations) = (padded(&asked.rates), padded(&asked.accelerations));
    let load = |k: usize| asked.wrench.get(k).copied().unwrap_or(0.0);
    let (cosine, sine) = point.cos_sin();
    let efforts = point.jacobian_transpose_times(Vector2::new(load(0), load(1)), load(2));
    let jacobian = point.jacobian();
    Seen {
        position: point.position().as_slice().to_vec(),
        orientation: vec![cosine, sine],
        velocity: point.velocity().as_slice().to_vec(),
        omega: vec![point.angular_velocity()],
        acceleration: point.acceleration(&accelerations).as_slice().to_vec(),
        angular_acceleration: vec![point.angular_acceleration(&accelerations)],
        jacobian_times_rates: point.jacobian_times(&rates).as_slice().to_vec(),
        jacobian: jacobian.row_iter().map(|row| row.iter().copied().collect()).collect(),
        transpose_times_wrench: efforts.as_slice().to_vec(),
    }
}

fn line(motion: &[f64], columns: RateColumns<f64>, place: &[f64], asked: &Asked) -> Seen {
    let motion = LineMotion::new(motion.try_into().expect("three values"));
    let body = BodyKinematics::<_, RATES, _, Written>::new(motion, ([0.0], ()), [0.0], columns);
    let point = match place {
        [] => body.input(),
        _ => body.at(place.try_into().expect("one entry")),
    };
    let (rates, accelerations) = (padded(&asked.rates), padded(&asked.accelerations));
    let force = asked.wrench.first().copied().unwrap_or(0.0);
    let jacobian = point.jacobian();
    Seen {
        position: vec![point.position()],
        orientation: Vec::new(),
        velocity: vec![point.velocity()],
        omega: Vec::new(),
        acceleration: vec![point.acceleration(&accelerations)],
        angular_acceleration: Vec::new(),
        jacobian_times_rates: vec![point.jacobian_times(&rates)],
        jacobian: jacobian.row_iter().map(|row| row.iter().copied().collect()).collect(),
        transpose_times_wrench: point.jacobian_transpose_times(force).as_slice().to_vec(),
    }
}
