//! Section 4.2: three unit cubes on pin hinges. They start in a straight, level row.
//!
//! The paper does not give the axes of the pins. By its boundary conditions the first pin rotates about
//! z. In system A all pins rotate about z, and the motion is planar. In system B the second pin rotates
//! about y, as in many robot arms.

use mstmm::Error;
use mstmm::prelude::*;
use mstmm_reference::{HingeKind, State};

use crate::compare::{Comparison, compare};
use crate::generated::PaperChain;
use crate::newton_euler::{NewtonEuler, three_cubes};
use crate::output::drawing::{Drawing, cubes};
use crate::output::progress::Progress;
use crate::output::time_figure::{Panel, TimeFigure};
use crate::section::SectionResult;
use crate::system::{Angle, DURATION, GRAVITY, KnownAcceleration, System};

// The same chain, compiled for either choice of axes and either method.
macro_rules! pin_arm {
    ($name:ident, $second_axis:ident, $method:ident) => {
        mstmm_chain! {
            /// Three unit cubes on pin hinges.
            pub chain $name {
                method = $method;
                gravity = [0, -9.8, 0] m/s^2;

                body Cube {
                    mass = 1 kg;
                    com = [0.5, 0, 0] m;
                    output = [1, 0, 0] m;
                    inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
                }

                ground -> pin(z) shoulder         -> Cube upper
                       -> pin($second_axis) elbow -> Cube middle
                       -> pin(z) wrist            -> Cube lower;

                hinge elbow { start_rate = 1 rad/s; }
            }
        }

        impl PaperChain for $name<f64> {
            fn angles(&self, state: &Self::State) -> Result<Vec<f64>, Error> {
                let pins = [state.shoulder(), state.elbow(), state.wrist()];
                Ok(pins.map(|pin| pin.angle()).to_vec())
            }

            fn accelerations(&self, state: &Self::State) -> Result<Vec<f64>, Error> {
                Ok(self.accelerations(state, &self.no_inputs())?.iter().copied().collect())
            }
        }
    };
}

pin_arm!(PlanarArm, z, riccati);
pin_arm!(PlanarArmByTransfer, z, transfer);
pin_arm!(SpatialArm, y, riccati);
pin_arm!(SpatialArmByTransfer, y, transfer);

const FIGURE_6_A: &str = "figure_6_a.svg";
const FIGURE_6_B: &str = "figure_6_b.svg";

pub fn run(progress: &Progress) -> Result<SectionResult, Error> {
    let planar = compare(
        system_a(),
        FIGURE_6_A,
        &PlanarArm::new(),
        &PlanarArmByTransfer::new(),
        &newton_euler([0.0, 0.0, 1.0]),
        progress,
    )?;
    let spatial = compare(
        system_b(),
        FIGURE_6_B,
        &SpatialArm::new(),
        &SpatialArmByTransfer::new(),
        &newton_euler([0.0, 1.0, 0.0]),
        progress,
    )?;
    let figures = vec![
        figure_6(&planar, FIGURE_6_A, "Figure 6 of the paper, A: angles of the pins, axes z, z, z"),
        figure_6(
            &spatial,
            FIGURE_6_B,
            "Figure 6 of the paper, B: angles of the pins, axes z, y, z",
        ),
    ];
    let drawings = vec![drawing_a(), drawing_b()];
    Ok(SectionResult {
        drawings,
        comparisons: vec![planar, spatial],
        figures,
        ..SectionResult::default()
    })
}

fn system_a() -> System {
    System {
        label: "4.2 A",
        title: "three unit cubes on pins about z, z, z, relative angles",
        file_stem: "4_2_a_pins_zzz",
        angles: angles(),
        // In the straight, level position, the planar equations of motion have rational coefficients.
        start: vec![
            KnownAcceleration { name: "Θ̈₁ = −534/485 g/l", value: -106.8 / 97.0 * GRAVITY },
            KnownAcceleration { name: "Θ̈₂ =  588/485 g/l", value: 117.6 / 97.0 * GRAVITY },
            KnownAcceleration { name: "Θ̈₃ =  −12/97 g/l", value: -12.0 / 97.0 * GRAVITY },
        ],
    }
}

fn system_b() -> System {
    System {
        label: "4.2 B",
        title: "three unit cubes on pins about z, y, z, relative angles",
        file_stem: "4_2_b_pins_zyz",
        angles: angles(),
        // At the start the first two cubes move as one rod, and the third cube is hinged to its end.
        start: vec![
            KnownAcceleration { name: "Θ̈₁ = −12/19 g/l", value: -12.0 / 19.0 * GRAVITY },
            KnownAcceleration { name: "Θ̈₂ = 0", value: 0.0 },
            KnownAcceleration { name: "Θ̈₃ = 18/19 g/l", value: 18.0 / 19.0 * GRAVITY },
        ],
    }
}

fn angles() -> Vec<Angle> {
    [("Θ₁", "pin_1_rad"), ("Θ₂", "pin_2_rad"), ("Θ₃", "pin_3_rad")]
        .map(|(symbol, column)| Angle { symbol, group: "the pins", column: column.to_owned() })
        .into()
}

fn newton_euler(second_axis: [f64; 3]) -> NewtonEuler {
    let axes = [[0.0, 0.0, 1.0], second_axis, [0.0, 0.0, 1.0]];
    NewtonEuler {
        chain: three_cubes(axes.map(|axis| HingeKind::Pin { axis })),
        start: State { q: vec![0.0; 3], v: vec![0.0, 1.0, 0.0] },
        angles: |sample| sample.pin_angles.iter().copied().flatten().collect(),
        accelerations: |solution| solution.accelerations.clone(),
    }
}

fn figure_6(comparison: &Comparison, file_name: &'static str, title: &'static str) -> TimeFigure {
    let panels =
        vec![Panel { axis: "Θ₁, Θ₂, Θ₃ in rad", curves: comparison.curves(0..3) }];
    let caption = "Lines: generated code. Crosses: Newton–Euler.";
    let reference = "Newton–Euler";
    TimeFigure { file_name, title, caption, reference, end: f64::from(DURATION), panels }
}

fn drawing_a() -> Drawing {
    let (mut canvas, hinges) = cubes::in_a_row([cubes::Symbol::Pin; 3]);
    cubes::rate_about_z(&mut canvas, hinges[1], "1 rad/s");
    canvas.finish(
        "Section 4.2 A: cubes on pins about z, z, z",
        "Unit cubes of 1 kg, drawn with gaps. The second pin starts with 1 rad/s.",
    )
}

fn drawing_b() -> Drawing {
    use cubes::Symbol::{Pin, VerticalPin};
    let (mut canvas, hinges) = cubes::in_a_row([Pin, VerticalPin, Pin]);
    cubes::rate_about_y(&mut canvas, hinges[1], 0.72, "1 rad/s");
    canvas.finish(
        "Section 4.2 B: cubes on pins about z, y, z",
        "Unit cubes of 1 kg, drawn with gaps. The second pin is about y and starts with 1 rad/s.",
    )
}
