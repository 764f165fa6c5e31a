//! Pins at and near right angles to each other, where the paper's pin matrix (43) is singular.
//!
//! The determinant of E₀ in (41) is −ζ₊ · u₃₂ ζ for the axis ζ of a pin and the axis ζ₊ of the next pin.
//! For the paper's cubes u₃₂ is diagonal in the body's frame. The determinant is therefore zero in every
//! state if the axes are perpendicular, such as z and y.

use mstmm::prelude::*;
use mstmm::{Error, Scalar};
use nalgebra::Vector3;

use super::DIGITS;
use super::errors::{Cubes, accelerations, bound, error};
use super::pose::{Joint, Pose};
use super::product::Product;
use super::reference;
use crate::output::progress::Progress;
use crate::output::result_table::{ResultTable, Row};
use crate::verdict::{Bound, Check, Verdict};

/// The number of parts that the progress bar counts.
pub const MOTIONS: usize = 1;

/// The tangents of the angles δ by which the axes differ from right angles.
const MISSING: [f64; 9] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 0.0];

const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// A chain of cubes on pins.
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

pub fn table(progress: &Progress) -> Result<ResultTable, Error> {
    progress.begin("limits: pins at right angles");
    let (mut rows, mut checks) = (Vec::new(), Vec::new());
    for tilt in MISSING {
        let errors = near(tilt)?;
        let tangent = if tilt == 0.0 { "0".into() } else { format!("{tilt:e}") };
        let name = format!("z and [0, 1, tan δ], tan δ = {tangent}");
        checks.extend(errors.checks(&name));
        rows.push(errors.row(name));
    }
    let start = Pose { joints: [(Z, 0.0), (Y, 1.0), (Z, 0.0)].map(level).into() };
    let states = [("at its start", start), ("elsewhere", Pose::of_pins([Z, Y, Z], 0))];
    for (which, pose) in states {
        let errors = system_b(&pose)?;
        let name = format!("section 4.2 B: z, y, z, {which}");
        checks.extend(errors.checks(&name));
        rows.push(errors.row(name));
    }
    let errors = oblique()?;
    let name = "[1, 2, 3], z and y";
    checks.extend(errors.checks(name));
    rows.push(errors.row(name.into()));
    Ok(ResultTable {
        section: "Limits",
        title: "least |det E₀| in kg m² and relative errors of all accelerations, pins near right angles",
        columns: ["|det E₀|", "product, f64", "transfer", "riccati"].map(str::to_owned).into(),
        rows,
        note: "If neighbouring axes are perpendicular, the pin matrix (43) does not exist: det E₀ = sin δ / 12 is \
               zero, where 90° − δ is the angle between the axes. Each power of ten in δ costs one digit. The \
               product of the printed matrices therefore cannot compute system B of section 4.2: the result is \
               not finite (–), or wrong where rounding hides the zero, as in the last row. The cause is the \
               order of elimination, not the mechanism: generated code keeps its accuracy.",
        verdicts: vec![Verdict {
            compared: "pins near 90°: code – 160-bit, relative".into(),
            figure: None,
            checks,
        }],
    })
}

/// The determinant and the relative errors in a state.
struct Errors {
    bodies: usize,
    /// The smallest |det E₀| of all pins except the last.
    determinant: f64,
    product: f64,
    transfer: f64,
    riccati: f64,
}

/// Two cubes on pins that are nearly at right angles to each other.
fn near(tilt: f64) -> Result<Errors, Error> {
    let pose = Pose::of_pins([Z, [0.0, 1.0, tilt]], 0);
    let (mut riccati, mut transfer) = (Oblique::<f64>::new(), ObliqueByTransfer::<f64>::new());
    riccati.set_tilt(tilt)?;
    transfer.set_tilt(tilt)?;
    errors::<4>(&pose, &transfer, &riccati)
}

fn system_b(pose: &Pose) -> Result<Errors, Error> {
    errors::<6>(pose, &SystemBByTransfer::<f64>::new(), &SystemB::<f64>::new())
}

/// Outboard of an oblique pin, no axis is parallel to an inertial axis, so rounding hides the zero.
fn oblique() -> Result<Errors, Error> {
    let pose = Pose::of_pins([[1.0, 2.0, 3.0], Z, Y], 0);
    errors::<6>(&pose, &TurnedByTransfer::<f64>::new(), &Turned::<f64>::new())
}

/// A pin at the angle zero.
fn level((axis, rate): ([f64; 3], f64)) -> Joint {
    Joint::Pin { axis, tangent: 0.0, rate }
}

/// Computes the errors in a pose. N is twice the number of bodies.
fn errors<const N: usize>(
    pose: &Pose,
    transfer: &impl Cubes<Scalar = f64>,
    riccati: &impl Cubes<Scalar = f64>,
) -> Result<Errors, Error> {
    let truth = reference::accelerations(pose, DIGITS)?;
    let product = Product::<f64>::new(pose);
    let with_next = 0..pose.joints.len().saturating_sub(1);
    let blocks = with_next.filter_map(|k| product.pin_blocks(k));
    let determinants = blocks.map(|blocks| blocks.determinant().abs());
    Ok(Errors {
        bodies: pose.joints.len(),
        determinant: determinants.min_by(f64::total_cmp).unwrap_or(f64::NAN),
        product: error(&product.accelerations::<N>(), &truth),
        transfer: error(&accelerations(transfer, pose)?, &truth),
        riccati: error(&accelerations(riccati, pose)?, &truth),
    })
}

impl Errors {
    fn row(&self, name: String) -> Row {
        let Errors { determinant, product, transfer, riccati, .. } = *self;
        Row { name, values: vec![determinant, product, transfer, riccati] }
    }

    /// Compares the errors of generated code with their bound.
    fn checks(&self, name: &str) -> [Check; 2] {
        let bound = Bound::Fixed(bound(self.bodies, f64::EPSILON));
        [("transfer", self.transfer), ("riccati", self.riccati)].map(|(method, size)| Check {
            what: format!("{method}, {name}"),
            size,
            unit: "",
            bound,
        })
    }
}
