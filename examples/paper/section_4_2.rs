//! Section 4.2: three unit cubes on pin hinges, let go straight and level.
//!
//! The paper does not say how the pins lie. Its boundary conditions make the first one turn about
//! z. System A has all of them about z and moves in a plane; system B has the second one about y,
//! the order of axes of many robot arms.

use mstmm::Error;
use mstmm::prelude::*;
use mstmm_reference::{HingeKind, State};

use crate::compare::{Comparison, compare};
use crate::generated::PaperChain;
use crate::newton_euler::{NewtonEuler, three_cubes};
use crate::output::plot::{Figure, Panel};
use crate::output::progress::Progress;
use crate::section::Outcome;
use crate::system::{Angle, DURATION, GRAVITY, KnownAcceleration, System};

// The chain is written once and compiled for either choice of axes, by either method.
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

pub fn run(progress: &Progress) -> Result<Outcome, Error> {
    let planar = compare(
        system_a(),
        &PlanarArm::new(),
        &PlanarArmByTransfer::new(),
        &newton_euler([0.0, 0.0, 1.0]),
        progress,
    )?;
    let spatial = compare(
        system_b(),
        &SpatialArm::new(),
        &SpatialArmByTransfer::new(),
        &newton_euler([0.0, 1.0, 0.0]),
        progress,
    )?;
    let figures = vec![
        figure_6(&planar, "figure_6_a.svg", "Figure 6, A: angles of the pins, axes z, z, z"),
        figure_6(&spatial, "figure_6_b.svg", "Figure 6, B: angles of the pins, axes z, y, z"),
    ];
    Ok(Outcome { comparisons: vec![planar, spatial], figures, ..Outcome::default() })
}

fn system_a() -> System {
    System {
        label: "4.2 A",
        title: "three unit cubes on pins about z, z, z, relative angles",
        file_stem: "4_2_a_pins_zzz",
        angles: angles(),
        // Straight and level, the planar equations of motion have rational coefficients.
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
        // At the start the first two cubes fall as one rod, with the third one hung from it.
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

fn figure_6(comparison: &Comparison, file_name: &'static str, title: &'static str) -> Figure {
    let panels =
        vec![Panel { axis: "Θ₁, Θ₂, Θ₃ in rad", curves: comparison.curves(0..3) }];
    let says = "Lines are generated code, crosses Newton–Euler: they cannot be told apart.";
    Figure { file_name, title, says, rival: "Newton–Euler", end: f64::from(DURATION), panels }
}
