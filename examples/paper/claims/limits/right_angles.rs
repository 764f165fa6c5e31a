//! Pins at right angles, where the paper's matrix of a pin (43) is singular, and near them.
//!
//! The determinant of E₀ in (41) is −ζ₊ · u₃₂ ζ for the axes ζ of a pin and ζ₊ of the next one. On the
//! paper's cubes u₃₂ has no entry off its diagonal in the body's frame, so that it vanishes in every
//! state for axes such as z and y.

use mstmm::prelude::*;
use mstmm::{Error, Scalar};
use nalgebra::Vector3;

use super::DIGITS;
use super::measure::{Cubes, accelerations, bound, error};
use super::pose::{Joint, Pose};
use super::product::Product;
use super::truth;
use crate::output::exhibit::{Exhibit, Row};
use crate::output::progress::Progress;

/// How many parts the progress counts.
pub const MOTIONS: usize = 1;

/// The tangents of the angles δ that are missing to right ones.
const MISSING: [f64; 9] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 0.0];

const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// Cubes on pins, and the names of its bodies.
macro_rules! cubes {
    ($name:ident $method:ident [$($first:tt)*] $([$($pin:tt)*] $body:ident)*) => {
        mstmm_chain! {
            chain $name {
                method = $method;
                gravity = [0, -9.8, 0] m/s^2;
                $($first)*
                body Cube {
                    mass = 1 kg;
                    com = [0.5, 0, 0] m;
                    output = [1, 0, 0] m;
                    inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
                }
                ground $(-> $($pin)* -> Cube $body)*;
            }
        }

        impl<T: Scalar> Cubes for $name<T> {
            fn at_inputs(at: &Self::Workspace) -> Vec<[Vector3<T>; 2]> {
                let inputs = [$(at.$body().input()),*];
                inputs.map(|input| [input.acceleration(), input.angular_acceleration()]).into()
            }
        }
    };
}

cubes! { Oblique riccati [param tilt = 0;] [pin(z) a] first [pin([0, 1, tilt]) b] second }
cubes! { ObliqueByTransfer transfer [param tilt = 0;] [pin(z) a] first [pin([0, 1, tilt]) b] second }
cubes! { Turned riccati [] [pin([1, 2, 3]) a] first [pin(z) b] second [pin(y) c] third }
cubes! { TurnedByTransfer transfer [] [pin([1, 2, 3]) a] first [pin(z) b] second [pin(y) c] third }
cubes! { SystemB riccati [] [pin(z) a] first [pin(y) b] second [pin(z) c] third }
cubes! { SystemBByTransfer transfer [] [pin(z) a] first [pin(y) b] second [pin(z) c] third }

pub fn exhibit(progress: &Progress) -> Result<Exhibit, Error> {
    progress.begin("limits: pins at right angles");
    let (mut rows, mut faults) = (Vec::new(), Vec::new());
    for tilt in MISSING {
        let found = near(tilt)?;
        let tangent = if tilt == 0.0 { "0".into() } else { format!("{tilt:e}") };
        rows.push(found.row(format!("z and [0, 1, tan δ], tan δ = {tangent}")));
        faults.extend(found.faults());
    }
    let start = Pose { joints: [(Z, 0.0), (Y, 1.0), (Z, 0.0)].map(level).into() };
    let states = [("at its start", start), ("elsewhere", Pose::of_pins([Z, Y, Z], 0))];
    for (which, pose) in states {
        let found = system_b(&pose)?;
        rows.push(found.row(format!("section 4.2 B: z, y, z, {which}")));
        faults.extend(found.faults());
    }
    let found = oblique()?;
    rows.push(found.row("[1, 2, 3], z and y".into()));
    faults.extend(found.faults());
    Ok(Exhibit {
        section: "Limits",
        title: "least |det E₀| in kg m² and relative errors of all accelerations, pins near right angles",
        columns: ["|det E₀|", "product, f64", "transfer", "riccati"].map(str::to_owned).into(),
        rows,
        says: vec![
            "Where neighbouring axes are at right angles the matrix of a pin (43) does not exist: det E₀,",
            "sin δ / 12 for an angle of 90° − δ, is zero, and every digit by which δ is smaller is a digit lost.",
            "So system B of section 4.2 cannot be computed by the product of the printed matrices at all: what",
            "comes out is not a number (–), and where rounding hides the zero, as in the last row, a wrong one.",
            "It is the order of elimination that fails, not the mechanism: generated code does not notice.",
        ],
        differences: Vec::new(),
        faults,
    })
}

/// What comes out in a state.
struct Found {
    bodies: usize,
    /// The smallest det E₀ of all pins but the last.
    determinant: f64,
    product: f64,
    transfer: f64,
    riccati: f64,
}

/// Two cubes, the second on a pin that is nearly at right angles to the first one.
fn near(tilt: f64) -> Result<Found, Error> {
    let pose = Pose::of_pins([Z, [0.0, 1.0, tilt]], 0);
    let (mut riccati, mut transfer) = (Oblique::<f64>::new(), ObliqueByTransfer::<f64>::new());
    riccati.set_tilt(tilt)?;
    transfer.set_tilt(tilt)?;
    found::<4>(&pose, &transfer, &riccati)
}

fn system_b(pose: &Pose) -> Result<Found, Error> {
    found::<6>(pose, &SystemBByTransfer::<f64>::new(), &SystemB::<f64>::new())
}

/// Behind an oblique pin no axis lies along the inertial ones, so that rounding hides the zero.
fn oblique() -> Result<Found, Error> {
    let pose = Pose::of_pins([[1.0, 2.0, 3.0], Z, Y], 0);
    found::<6>(&pose, &TurnedByTransfer::<f64>::new(), &Turned::<f64>::new())
}

/// A pin at the angle zero.
fn level((axis, rate): ([f64; 3], f64)) -> Joint {
    Joint::Pin { axis, tangent: 0.0, rate }
}

/// N is twice the number of bodies.
fn found<const N: usize>(
    pose: &Pose,
    transfer: &impl Cubes<Scalar = f64>,
    riccati: &impl Cubes<Scalar = f64>,
) -> Result<Found, Error> {
    let truth = truth::accelerations(pose, DIGITS)?;
    let product = Product::<f64>::new(pose);
    let followed = 0..pose.joints.len().saturating_sub(1);
    let blocks = followed.filter_map(|k| product.pin_blocks(k));
    let determinants = blocks.map(|blocks| blocks.determinant().abs());
    Ok(Found {
        bodies: pose.joints.len(),
        determinant: determinants.min_by(f64::total_cmp).unwrap_or(f64::NAN),
        product: error(&product.accelerations::<N>(), &truth),
        transfer: error(&accelerations(transfer, pose)?, &truth),
        riccati: error(&accelerations(riccati, pose)?, &truth),
    })
}

impl Found {
    fn row(&self, name: String) -> Row {
        let Found { determinant, product, transfer, riccati, .. } = *self;
        Row { name, values: vec![determinant, product, transfer, riccati] }
    }

    /// What generated code does not do as it must.
    fn faults(&self) -> Option<String> {
        let bound = bound(self.bodies, f64::EPSILON);
        let holds = self.transfer <= bound && self.riccati <= bound;
        (!holds).then(|| {
            format!(
                "pins near right angles: transfer is off by {:.1e}, riccati by {:.1e}, of {bound:.1e}",
                self.transfer, self.riccati
            )
        })
    }
}
