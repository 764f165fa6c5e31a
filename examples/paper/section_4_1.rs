//! Section 4.1: three unit cubes on ball-and-socket hinges. They start in a straight, level row.
//!
//! The paper counts hinges and bodies together, so `upper`, `middle` and `lower` are its bodies 2, 4
//! and 6.

use mstmm::Error;
use mstmm::prelude::*;
use mstmm_reference::{BodySample, HingeKind, State};

use crate::compare::{Comparison, compare};
use crate::generated::PaperChain;
use crate::newton_euler::{NewtonEuler, three_cubes};
use crate::output::drawing::{Drawing, cubes};
use crate::output::progress::Progress;
use crate::output::time_figure::{Panel, TimeFigure};
use crate::section::SectionResult;
use crate::system::{Angle, DURATION, GRAVITY, KnownAcceleration, System};

// The same chain, compiled for either method.
macro_rules! ball_pendulum {
    ($name:ident, $method:ident) => {
        mstmm_chain! {
            /// Three unit cubes on ball-and-socket hinges.
            pub chain $name {
                method = $method;
                gravity = [0, -9.8, 0] m/s^2;

                body Cube {
                    mass = 1 kg;
                    com = [0.5, 0, 0] m;
                    output = [1, 0, 0] m;
                    inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
                }

                ground -> ball shoulder -> Cube upper
                       -> ball elbow    -> Cube middle
                       -> ball wrist    -> Cube lower;

                hinge wrist { start_rate = [0, 0.1, 0] rad/s; }
            }
        }

        impl PaperChain for $name<f64> {
            /// The Bryan angles of all bodies, `[P, Eq. (1)]`.
            fn angles(&self, state: &Self::State) -> Result<Vec<f64>, Error> {
                let mut at = self.workspace();
                self.solve_into(state, &self.no_inputs(), &mut at)?;
                let angles = [at.upper(), at.middle(), at.lower()].map(|body| {
                    let (first, second, third) = body.input().orientation().euler_angles();
                    [first, second, third]
                });
                Ok(angles.concat())
            }

            /// While all angles are zero, θ̈₃ = Ω̇_z + θ̇₁ θ̇₂. At the start every θ̇₁ is zero.
            fn accelerations(&self, state: &Self::State) -> Result<Vec<f64>, Error> {
                let mut at = self.workspace();
                self.solve_into(state, &self.no_inputs(), &mut at)?;
                let bodies = [at.upper(), at.middle(), at.lower()];
                Ok(bodies.map(|body| body.input().angular_acceleration().z).to_vec())
            }
        }
    };
}

ball_pendulum!(BallPendulum, riccati);
ball_pendulum!(BallPendulumByTransfer, transfer);

const FIGURE_4: &str = "figure_4.svg";

pub fn run(progress: &Progress) -> Result<SectionResult, Error> {
    let comparison = compare(
        system(),
        FIGURE_4,
        &BallPendulum::new(),
        &BallPendulumByTransfer::new(),
        &newton_euler(),
        progress,
    )?;
    let figures = vec![figure_4(&comparison)];
    let drawings = vec![drawing()];
    Ok(SectionResult {
        drawings,
        comparisons: vec![comparison],
        figures,
        ..SectionResult::default()
    })
}

fn system() -> System {
    let bodies = [("body 2", "body_2"), ("body 4", "body_4"), ("body 6", "body_6")];
    let symbols = [("θ₁", "theta_1"), ("θ₂", "theta_2"), ("θ₃", "theta_3")];
    let angles_of = |(group, body)| {
        symbols.map(|(symbol, name)| Angle { symbol, group, column: format!("{body}_{name}_rad") })
    };
    System {
        label: "4.1",
        title: "three unit cubes on ball-and-socket hinges, Bryan angles",
        file_stem: "4_1_ball_hinges",
        angles: bodies.into_iter().flat_map(angles_of).collect(),
        // In the straight, level position, the planar equations of motion have rational coefficients.
        start: vec![
            KnownAcceleration {
                name: "θ̈₃ of body 2 = −534/485 g/l",
                value: -106.8 / 97.0 * GRAVITY,
            },
            KnownAcceleration {
                name: "θ̈₃ of body 4 =   54/485 g/l", value: 10.8 / 97.0 * GRAVITY
            },
            KnownAcceleration {
                name: "θ̈₃ of body 6 =   −6/485 g/l", value: -1.2 / 97.0 * GRAVITY
            },
        ],
    }
}

fn newton_euler() -> NewtonEuler {
    let level = [1.0, 0.0, 0.0, 0.0];
    let [none, slow] = [[0.0; 3], [0.0, 0.1, 0.0]];
    NewtonEuler {
        chain: three_cubes([HingeKind::Ball, HingeKind::Ball, HingeKind::Ball]),
        start: State { q: [level; 3].concat(), v: [none, none, slow].concat() },
        angles: |sample| sample.bodies.iter().flat_map(bryan_angles).collect(),
        // The points are the ends of the elements. The input of a body is the output of its hinge.
        accelerations: |solution| {
            [1, 3, 5].map(|point| solution.points[point].angular_acceleration[2]).to_vec()
        },
    }
}

/// The angles of A = A_z(θ₃) A_y(θ₂) A_x(θ₁), `[P, Eq. (1)]`.
fn bryan_angles(body: &BodySample) -> [f64; 3] {
    let [[xx, _, _], [yx, _, _], [zx, zy, zz]] = body.rotation;
    [zy.atan2(zz), (-zx).atan2(zy.hypot(zz)), yx.atan2(xx)]
}

/// The angles of body 2. The first two angles have their own panel because they are small.
fn figure_4(comparison: &Comparison) -> TimeFigure {
    TimeFigure {
        file_name: FIGURE_4,
        title: "Figure 4 of the paper: rotation angles of body 2 on ball-and-socket hinges",
        caption: "Lines: generated code. Crosses: Newton–Euler. Bryan angles lie between −π and π; a line \
                  breaks where its angle passes ±π.",
        reference: "Newton–Euler",
        end: f64::from(DURATION),
        panels: vec![
            Panel { axis: "θ₁, θ₂ in rad", curves: comparison.curves(0..2) },
            Panel { axis: "θ₃ in rad", curves: comparison.curves(2..3) },
        ],
    }
}

fn drawing() -> Drawing {
    let (mut canvas, hinges) = cubes::in_a_row([cubes::Symbol::Ball; 3]);
    cubes::rate_about_y(&mut canvas, hinges[2], 0.66, "0.1 rad/s");
    canvas.finish(
        "Section 4.1: cubes on ball-and-socket hinges",
        "Unit cubes of 1 kg, drawn with gaps. The third cube starts with 0.1 rad/s about y.",
    )
}
