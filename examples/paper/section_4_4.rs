//! Section 4.4: five masses in a row on springs. The first spring is fixed to a wall, and a constant force
//! pulls the first mass.
//!
//! The paper's equation (48) does not give the unstressed length of a spring. There are two readings: as
//! printed, with springs of zero length; or with springs that are unstressed at the start, 0.1 m long.
//! Both are computed by generated code, by the paper's 3 × 3 matrices (47) and (52), and exactly, by
//! modes.

use mstmm::paper::line;
use mstmm::prelude::*;
use mstmm::{ChainState, Error, GeneratedChain};
use nalgebra::{SMatrix, SVector, Vector3};

use crate::output::drawing::{Canvas, Drawing, Side};
use crate::output::progress::Progress;
use crate::output::result_table::{ResultTable, Row};
use crate::output::time_figure::{Curve, Panel, TimeFigure};
use crate::section::SectionResult;
use crate::verdict::{Bound, Check, Verdict};

/// The number of masses.
const COUNT: usize = 5;
const MASS: f64 = 0.1;
const STIFFNESS: f64 = 1000.0;
/// The force on the first mass in N.
const FORCE: f64 = 100.0;
/// The distance between neighbouring masses at the start in m.
const SPACING: f64 = 0.1;

/// The step of the integrator in s. The fastest mode has a period of 33 ms.
const STEP: f64 = 2e-5;
/// The end of the figure and of the comparison in s.
const FIGURE_END: f64 = 0.5;
const END: f64 = 5.0;
/// Times in s at which positions are printed.
const TIMES: [f64; 4] = [0.01, 0.1, 1.0, 5.0];

type Positions = SVector<f64, COUNT>;

macro_rules! spring_chain {
    ($(#[$doc:meta])* $name:ident $rest:literal) => {
        mstmm_chain! {
            $(#[$doc])*
            pub line chain $name {
                body Mass { mass = 100 g; output = 0 m; }
                ground -> elastic k1 -> Mass m2 -> elastic k3 -> Mass m4 -> elastic k5 -> Mass m6
                       -> elastic k7 -> Mass m8 -> elastic k9 -> Mass m10;
                hinge k1, k3, k5, k7, k9 { stiffness = 1000 N/m; start = 0.1 m; rest = $rest m; }
                load pull { on = m2; force = 100 N; }
            }
        }
    };
}

spring_chain! {
    /// Springs of zero length, as printed.
    Literal 0
}
spring_chain! {
    /// Springs that are unstressed at the start.
    Rested 0.1
}

pub fn run(progress: &Progress) -> Result<SectionResult, Error> {
    let mut result = SectionResult { drawings: vec![drawing()], ..SectionResult::default() };
    progress.begin("4.4: springs without a length");
    let literal = Reading { name: "springs without a length", rest: 0.0 };
    let chain = Literal::<f64>::new();
    literal.compare(&chain, "figure_10_a.svg", &mut result, progress)?;
    progress.begin("4.4: springs at rest at the start");
    let rested = Reading { name: "springs at rest at the start", rest: SPACING };
    let chain = Rested::<f64>::new();
    rested.compare(&chain, "figure_10_b.svg", &mut result, progress)?;
    Ok(result)
}

/// A reading of equation (48).
struct Reading {
    name: &'static str,
    /// The unstressed length of every spring in m.
    rest: f64,
}

/// The positions of all masses over time in m, by each method.
#[derive(Default)]
struct Motion {
    times: Vec<f64>,
    generated: Vec<Positions>,
    matrices: Vec<Positions>,
    exact: Vec<Positions>,
}

impl Reading {
    fn compare<C: GeneratedChain<Scalar = f64>>(
        &self,
        chain: &C,
        file_name: &'static str,
        result: &mut SectionResult,
        progress: &Progress,
    ) -> Result<(), Error> {
        let motion = self.motion(chain, progress)?;
        let largest = |found: &[Positions]| {
            let differences = found.iter().zip(&motion.exact).map(|(a, b)| (a - b).amax());
            // In this order NaN is the largest of all.
            differences.max_by(f64::total_cmp).unwrap_or(f64::NAN)
        };
        let difference = |what: &str, found: &[Positions]| Check {
            what: format!("{}, {what}: largest difference to the modes", self.name),
            size: largest(found),
            unit: "m",
            bound: Bound::Tolerance,
        };
        let row = |name: &str, found: &[Positions], mass: usize| Row {
            name: format!("{name}, body {}", 2 * mass + 2),
            values: TIMES.map(|time| found[index(time)][mass]).to_vec(),
        };
        result.tables.push(ResultTable {
            section: "Section 4.4",
            title: match self.rest {
                0.0 => "positions in m, springs without a length, as (48) is printed",
                _ => "positions in m, springs at rest at the start",
            },
            columns: TIMES.iter().map(|time| format!("t = {time} s")).collect(),
            rows: vec![
                row("generated code", &motion.generated, 0),
                row("matrices (47) and (52)", &motion.matrices, 0),
                row("modes, exact", &motion.exact, 0),
                row("generated code", &motion.generated, COUNT - 1),
                row("matrices (47) and (52)", &motion.matrices, COUNT - 1),
                row("modes, exact", &motion.exact, COUNT - 1),
            ],
            note: "Generated code and the paper's matrices agree with the exact motion by modes.",
            verdicts: vec![Verdict {
                compared: match self.rest {
                    0.0 => "zero length: code, matrices – modes, positions".into(),
                    _ => "0.1 m length: code, matrices – modes, positions".into(),
                },
                figure: Some(file_name),
                checks: vec![
                    difference("generated code", &motion.generated),
                    difference("matrices (47) and (52)", &motion.matrices),
                ],
            }],
        });
        result.figures.push(self.figure(file_name, &motion));
        Ok(())
    }

    fn motion<C: GeneratedChain<Scalar = f64>>(
        &self,
        chain: &C,
        progress: &Progress,
    ) -> Result<Motion, Error> {
        let modes = Modes::new(self.rest);
        let mut state = chain.initial_state();
        let mut rk4 = Rk4::new(STEP);
        let (mut x, mut v) = (start(), Positions::zeros());
        let mut motion = Motion::default();
        let steps_per_record = (RECORD / STEP).round() as usize;
        for record in 0..=index(END) {
            let time = record as f64 * RECORD;
            if record > 0 {
                for _ in 0..steps_per_record {
                    rk4.step(chain, &mut state, |_time, _state| chain.no_inputs())?;
                    runge_kutta(&mut x, &mut v, |x| self.by_matrices(x));
                }
            }
            motion.times.push(time);
            motion.generated.push(positions(state.coordinates()));
            motion.matrices.push(x);
            motion.exact.push(modes.at(time));
            progress.reach(time);
        }
        Ok(motion)
    }

    /// The force on each mass [P, Eqs. (48), (49)], with the wall at zero and the springs' unstressed
    /// length.
    fn forces(&self, x: &Positions) -> Positions {
        let pull = |k: usize| {
            let previous = if k == 0 { 0.0 } else { x[k - 1] };
            STIFFNESS * (x[k] - previous - self.rest)
        };
        Positions::from_fn(|k, _| {
            let applied = if k == 0 { FORCE } else { 0.0 };
            let next = if k + 1 < COUNT { pull(k + 1) } else { 0.0 };
            applied - pull(k) + next
        })
    }

    /// The accelerations by the overall transfer equation for `z = [ẍ, q, 1]`, with the matrices (47)
    /// and (52) as printed.
    fn by_matrices(&self, x: &Positions) -> Positions {
        let forces = self.forces(x);
        let body = |k: usize| line::body(MASS, forces[k]);
        let hinge = |k: usize| line::acceleration_hinge(MASS, forces[k]);
        let overall = (1..COUNT).fold(body(0), |product, k| body(k) * hinge(k) * product);
        // Both ends are free, q = 0. The second row of z_{10,O} = U z_{2,I} gives ẍ of the first mass.
        let first = -overall[(1, 2)] / overall[(1, 0)];
        let mut z = Vector3::new(first, 0.0, 1.0);
        let mut accelerations = Positions::zeros();
        for k in 0..COUNT {
            if k > 0 {
                z = hinge(k) * z;
            }
            accelerations[k] = z[0];
            z = body(k) * z;
        }
        accelerations
    }

    fn figure(&self, file_name: &'static str, motion: &Motion) -> TimeFigure {
        let end = index(FIGURE_END);
        let curve = |label: &'static str, mass: usize| {
            let point = |k: usize, found: &[Positions]| (motion.times[k], found[k][mass]);
            Curve {
                label,
                line: (0..=end).map(|k| point(k, &motion.generated)).collect(),
                marks: (0..=end).step_by(10).map(|k| point(k, &motion.exact)).collect(),
            }
        };
        let curves = vec![curve("body 2", 0), curve("body 10", COUNT - 1)];
        TimeFigure {
            file_name,
            title: match self.rest {
                0.0 => "Figure 10 of the paper: positions, springs of zero length",
                _ => "Figure 10 of the paper: positions, springs of 0.1 m",
            },
            caption: "Lines: generated code. Crosses: the exact motion by modes.",
            reference: "exact, by modes",
            end: FIGURE_END,
            panels: vec![Panel { axis: "x in m", curves }],
        }
    }
}

/// The time between two records in s.
const RECORD: f64 = 1e-3;

/// The index of the record at a time in s.
fn index(time: f64) -> usize {
    (time / RECORD).round() as usize
}

fn start() -> Positions {
    Positions::from_fn(|k, _| SPACING * (k + 1) as f64)
}

/// The positions from the displacement of each mass relative to the previous one.
fn positions(displacements: &[f64]) -> Positions {
    let mut sum = 0.0;
    Positions::from_fn(|k, _| {
        sum += displacements[k];
        sum
    })
}

/// A step of the classical method of order four for `ẍ = f(x)`.
fn runge_kutta(x: &mut Positions, v: &mut Positions, f: impl Fn(&Positions) -> Positions) {
    let h = STEP;
    let (v1, a1) = (*v, f(x));
    let (v2, a2) = (*v + a1 * (h / 2.0), f(&(*x + v1 * (h / 2.0))));
    let (v3, a3) = (*v + a2 * (h / 2.0), f(&(*x + v2 * (h / 2.0))));
    let (v4, a4) = (*v + a3 * h, f(&(*x + v3 * h)));
    *x += (v1 + (v2 + v3) * 2.0 + v4) * (h / 6.0);
    *v += (a1 + (a2 + a3) * 2.0 + a4) * (h / 6.0);
}

/// The exact solution: each mode oscillates about its equilibrium.
struct Modes {
    shapes: SMatrix<f64, COUNT, COUNT>,
    frequencies: Positions,
    /// The amplitudes of the modes at the start, where all velocities are zero.
    amplitudes: Positions,
    equilibrium: Positions,
}

impl Modes {
    fn new(rest: f64) -> Self {
        let stiffness = SMatrix::<f64, COUNT, COUNT>::from_fn(|i, k| match i.abs_diff(k) {
            0 if i + 1 == COUNT => STIFFNESS,
            0 => 2.0 * STIFFNESS,
            1 => -STIFFNESS,
            _ => 0.0,
        });
        let eigen = stiffness.symmetric_eigen();
        let mut load = Positions::zeros();
        load[0] = FORCE;
        // The unstressed length pushes the last mass away from the wall. On every other mass, the pushes
        // of two springs cancel.
        load[COUNT - 1] = STIFFNESS * rest;
        let modal = eigen.eigenvectors.transpose() * load;
        let equilibrium = eigen.eigenvectors * modal.component_div(&eigen.eigenvalues);
        Modes {
            shapes: eigen.eigenvectors,
            frequencies: eigen.eigenvalues.map(|value| (value / MASS).sqrt()),
            amplitudes: eigen.eigenvectors.transpose() * (start() - equilibrium),
            equilibrium,
        }
    }

    fn at(&self, time: f64) -> Positions {
        let phases = self.frequencies.map(|frequency| (frequency * time).cos());
        self.equilibrium + self.shapes * self.amplitudes.component_mul(&phases)
    }
}

fn drawing() -> Drawing {
    const HALF: f64 = 0.017;
    let mut canvas = Canvas::new([-0.03, 0.56], [-0.11, 0.1], 440.0);
    canvas.wall([0.0, 0.0], 30.0);
    for k in 0..COUNT {
        let x = SPACING * (k + 1) as f64;
        let from = if k == 0 { 0.0 } else { x - SPACING + HALF };
        canvas.spring([from, 0.0], [x - HALF, 0.0]);
        canvas.body(&[[x - HALF, -HALF], [x + HALF, -HALF], [x + HALF, HALF], [x - HALF, HALF]]);
        canvas.text([x, 0.0], Side::Centre, &(2 * k + 2).to_string());
    }
    canvas.arrow([SPACING, 0.045], [SPACING + 0.06, 0.045]);
    canvas.text([SPACING + 0.06, 0.045], Side::Right, "100 N on body 2");
    canvas.dimension([3.0 * SPACING, -0.045], [4.0 * SPACING, -0.045], "0.1 m");
    canvas.finish(
        "Section 4.4: five masses on springs",
        "Bodies 2 to 10 of 0.1 kg each, springs of 1000 N/m. There is no gravity.",
    )
}
