//! The motion by an independent solver: the Newton–Euler equations of every body, with Lagrange
//! multipliers for the hinges.

use mstmm_reference::{
    About, Body, Chain, Element, Frame, Hinge, HingeKind, Sample, Solution, State, simulate,
};

use crate::output::progress::Progress;
use crate::system::{DURATION, GRAVITY, MARKS_PER_SECOND, Record};

/// A chain for the independent solver, with the values that are compared.
pub struct NewtonEuler {
    pub chain: Chain,
    pub start: State,
    /// The angles in rad, in the order of [`crate::system::System::angles`].
    pub angles: fn(&Sample) -> Vec<f64>,
    /// The accelerations in rad/s², in the order of [`crate::system::System::start`].
    pub accelerations: fn(&Solution) -> Vec<f64>,
}

impl NewtonEuler {
    /// Integrates the motion and records it.
    pub fn motion(&self, progress: &Progress) -> Vec<Record> {
        let times: Vec<f64> = (0..=DURATION * MARKS_PER_SECOND)
            .map(|count| f64::from(count) / f64::from(MARKS_PER_SECOND))
            .collect();
        let mut records = Vec::with_capacity(times.len());
        simulate(&self.chain, &self.start, &self.no_efforts(), &times, |sample| {
            records.push(Record {
                time_s: sample.time,
                angles_rad: (self.angles)(sample),
                kinetic_energy_j: sample.kinetic_energy,
                potential_energy_j: sample.potential_energy,
            });
            progress.reach(sample.time);
        });
        records
    }

    pub fn start_accelerations(&self) -> Vec<f64> {
        (self.accelerations)(&self.chain.solve(&self.start, &self.no_efforts()))
    }

    fn no_efforts(&self) -> Vec<f64> {
        vec![0.0; self.chain.dof_count()]
    }
}

/// Three unit cubes of 1 kg in a row, with hinges of the given kinds at their inputs.
pub fn three_cubes(hinges: [HingeKind; 3]) -> Chain {
    let hinge = |(name, kind): (&str, HingeKind)| Element::Hinge(Hinge::new(name, kind));
    let cube = |name: &str| {
        Element::Body(Body {
            name: name.to_owned(),
            mass: 1.0,
            com: [0.5, 0.0, 0.0],
            output: Frame::at([1.0, 0.0, 0.0]),
            inertia: [1.0 / 6.0, 5.0 / 12.0, 5.0 / 12.0, 0.0, 0.0, 0.0],
            about: About::Input,
            points: Vec::new(),
        })
    };
    let hinges = ["shoulder", "elbow", "wrist"].into_iter().zip(hinges).map(hinge);
    let bodies = ["upper", "middle", "lower"].map(cube);
    let elements = hinges.zip(bodies).flat_map(|(hinge, body)| [hinge, body]).collect();
    Chain::new("ThreeCubes", [0.0, -GRAVITY, 0.0], elements)
}
